(* What every chapter uses: real and complex functions, and the tactics that prove leaves.
   A relation whose terms divide stands beside what it divides by: c <> 0 /\ a / c < b. *)
From Coq Require Export Reals Lra Lia Nsatz FunctionalExtensionality.
From Coq Require QArith Qround Qreals Qreduction Ranalysis5.
From Coquelicot Require Export Coquelicot.
From Interval Require Export Tactic.
From Interval Require Tree.
Open Scope R_scope.

Definition whole (x : R) : Prop := exists n : nat, x = INR n.
Definition cot (x : R) : R := cos x / sin x.
Definition increasing (f : R -> R) (a b : R) : Prop :=
  forall x y, a < x -> x < y -> y < b -> f x < f y.
Definition tends (f : R -> R) (a l : R) : Prop := is_lim f a l.

(* Complex numbers: powers with any exponent are principal values. *)
Fixpoint Cpower (z : C) (n : nat) : C := match n with O => 1%C | S m => (z * Cpower z m)%C end.
Notation "z ^ n" := (Cpower z n) : C_scope.
Definition Cexp (z : C) : C := (exp (Re z) * cos (Im z), exp (Re z) * sin (Im z)).
Definition Cangle_of (z : C) : R :=
  if Rle_dec 0 (Im z) then acos (Re z / Cmod z) else - acos (Re z / Cmod z).
Definition Clog (z : C) : C := (ln (Cmod z), Cangle_of z).
Definition Craised (z w : C) : C :=
  if Ceq_dec z 0 then if Ceq_dec w 0 then RtoC 1 else RtoC 0 else Cexp (w * Clog z)%C.
Definition Cless (z w : C) : Prop := Im z = 0 /\ Im w = 0 /\ Re z < Re w.
Definition Cless_eq (z w : C) : Prop := Im z = 0 /\ Im w = 0 /\ Re z <= Re w.
Definition Ctends (f : R -> C) (a : R) (l : C) : Prop :=
  tends (fun x => Re (f x)) a (Re l) /\ tends (fun x => Im (f x)) a (Im l).

(* -- numbers --------------------------------------------------------------------------- *)

(* Quotients of whole numbers are constants of ring and field, so that no divisor is a variable. *)
Definition Qvalue (q : QArith_base.Q) : R :=
  match QArith_base.Qden q with
  | xH => IZR (QArith_base.Qnum q)
  | p => match QArith_base.Qnum q with Zpos xH => / IZR (Zpos p) | n => IZR n * / IZR (Zpos p) end
  end.
Lemma Qvalued : forall q, Qvalue q = Q2R q.
Proof.
  intros [[| [p | p |] | p] [d | d |]]; unfold Qvalue, Q2R; simpl;
    first [ring | field; apply IZR_neq; discriminate].
Qed.
(* Whole numbers are added and multiplied as such: there is nothing to reduce. *)
Definition Qwhole_or (op : Z -> Z -> Z) (other : QArith_base.Q -> QArith_base.Q -> QArith_base.Q)
  (p q : QArith_base.Q) : QArith_base.Q :=
  match QArith_base.Qden p, QArith_base.Qden q with
  | xH, xH => QArith_base.Qmake (op (QArith_base.Qnum p) (QArith_base.Qnum q)) 1
  | _, _ => other p q
  end.
Definition Qadd := Qwhole_or Z.add Qreduction.Qplus'.
Definition Qsubtract := Qwhole_or Z.sub Qreduction.Qminus'.
Definition Qtimes := Qwhole_or Z.mul Qreduction.Qmult'.
Lemma Qsteps : forall p q, QArith_base.Qeq (Qadd p q) (QArith_base.Qplus p q) /\
  QArith_base.Qeq (Qsubtract p q) (QArith_base.Qminus p q) /\
  QArith_base.Qeq (Qtimes p q) (QArith_base.Qmult p q).
Proof.
  intros [n [d | d |]] [m [e | e |]]; repeat split; unfold Qadd, Qsubtract, Qtimes, Qwhole_or; simpl;
    try apply Qreduction.Qplus'_correct; try apply Qreduction.Qmult'_correct; try apply Qreduction.Qminus'_correct;
    unfold QArith_base.Qeq; simpl; lia.
Qed.
Notation Q_morph zero one plus times minus opp eq value :=
  (ring_morph zero one plus times minus opp eq
    (QArith_base.Qmake 0%Z 1%positive) (QArith_base.Qmake 1%Z 1%positive)
    Qadd Qtimes Qsubtract QArith_base.Qopp QArith_base.Qeq_bool value).
Lemma Qnumbers : Q_morph 0 1 Rplus Rmult Rminus Ropp (@eq R) Qvalue.
Proof.
  split; intros; rewrite ?Qvalued, <- ?Qreals.Q2R_plus, <- ?Qreals.Q2R_mult, <- ?Qreals.Q2R_minus,
    <- ?Qreals.Q2R_opp.
  1, 2: unfold Q2R; simpl; field.
  1-3: apply Qreals.Qeq_eqR, (Qsteps x y).
  - reflexivity.
  - apply Qreals.Qeq_eqR, QArith_base.Qeq_bool_iff; assumption.
Qed.
Lemma Qcomplete : forall p q, Qvalue p = Qvalue q -> QArith_base.Qeq_bool p q = true.
Proof. intros p q; rewrite !Qvalued; intro E; apply QArith_base.Qeq_bool_iff, Qreals.eqR_Qeq, E. Qed.
Ltac whole_Q n :=
  match isZcst n with
  | true => constr:(QArith_base.Qmake n 1%positive)
  | _ => constr:(InitialRing.NotConstant)
  end.
Ltac part_Q p :=
  match isPcst p with
  | true => lazymatch p with xH => constr:(InitialRing.NotConstant) | _ => constr:(QArith_base.Qmake 1%Z p) end
  | _ => constr:(InitialRing.NotConstant)
  end.
Ltac Qnumber t :=
  match t with
  | Qvalue ?q => constr:(q)
  | IZR ?n => whole_Q n
  | / IZR (Zpos ?p) => part_Q p
  | _ => constr:(InitialRing.NotConstant)
  end.
Add Field Rquotients : RealField.Rfield
  (morphism Qnumbers, completeness Qcomplete, constants [Qnumber],
    power_tac RealField.R_power_theory [RealField.Rpow_tac]).
Ltac shown := try unfold Qvalue in *; cbn [QArith_base.Qnum QArith_base.Qden] in *.
Ltac shown_here := try (unfold Qvalue; cbn [QArith_base.Qnum QArith_base.Qden]).

(* -- terms as expressions ------------------------------------------------------------ *)

(* A term, or a function of reals, as one of expressions: its operations are put in their place. *)
Ltac expression t :=
  let t := eval pattern R, Rplus, Rminus, Rmult, Rdiv, Ropp, Rinv, Rpow_def.pow, IZR, PI, sqrt, Rabs, cos, sin,
    tan, atan, exp, ln in t in
  lazymatch t with ?f _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ =>
    constr:(f Tree.expr (Tree.Ebinary Tree.Add) (Tree.Ebinary Tree.Sub) (Tree.Ebinary Tree.Mul)
      (Tree.Ebinary Tree.Div) (Tree.Eunary Tree.Neg) (Tree.Eunary Tree.Inv)
      (fun a n => Tree.Eunary (Tree.PowerInt (Z.of_nat n)) a) (fun n => Tree.Econst (Tree.Int n))
      (Tree.Econst Tree.Pi) (Tree.Eunary Tree.Sqrt) (Tree.Eunary Tree.Abs) (Tree.Eunary Tree.Cos)
      (Tree.Eunary Tree.Sin) (Tree.Eunary Tree.Tan) (Tree.Eunary Tree.Atan) (Tree.Eunary Tree.Exp)
      (Tree.Eunary Tree.Ln))
  end.
(* The same of a term in which terms have numbers: those that stand first are found first. *)
Ltac numbered f n := lazymatch n with O => f | S ?n => numbered constr:(f (Tree.Evar n)) n end.
Ltac expressed t vs :=
  let rec of t ws :=
    lazymatch ws with
    | nil => let f := expression t in let n := eval cbv in (List.length vs) in numbered f n
    | ?w :: ?ws => let t := eval pattern w in t in lazymatch t with ?f _ => of f ws end
    end in
  let e := of t vs in eval cbv in e.

(* Rational functions of variables, put to Rocq's field as expressions: what are equal where squares
   are what rules say, beside what then must not be zero. *)
Module Fractions.
Import QArith_base Ring_polynom Field_theory Tree.
Notation with_numbers f := (f (0 # 1) (1 # 1) Qadd Qtimes Qsubtract Qopp Qeq_bool).
Notation in_reals f := (f R 0%R 1%R Rplus Rmult Rminus Ropp).
Notation at_numbers f := (f Q Qvalue nat N.to_nat Rpow_def.pow).
Definition divided := InitialRing.triv_div (0 # 1) (1 # 1) Qeq_bool.
Definition part (n : positive) : FExpr Q :=
  match n with xH => FEinv (FEc (1 # 1)) | _ => FEc (1 # n) end.
Fixpoint fraction (e : expr) : option (FExpr Q) :=
  match e with
  | Evar n => Some (FEX _ (Pos.of_succ_nat n))
  | Econst (Int n) => Some (FEc (n # 1))
  | Eunary Inv (Econst (Int (Zpos n))) => Some (part n)
  | Eunary Neg a => option_map (@FEopp _) (fraction a)
  | Eunary Inv a => option_map (@FEinv _) (fraction a)
  | Eunary (PowerInt n) a => option_map (fun p => FEpow p (Z.to_N n)) (fraction a)
  | Ebinary Div a (Econst (Int (Zpos n))) => option_map (fun p => FEmul p (part n)) (fraction a)
  | Ebinary o a b =>
      match fraction a, fraction b with
      | Some p, Some q =>
          Some match o with Add => FEadd p q | Sub => FEsub p q | Mul => FEmul p q | Div => FEdiv p q end
      | _, _ => None
      end
  | _ => None
  end.
Definition sides (e : expr) : option (FExpr Q * FExpr Q) :=
  match e with
  | Ebinary Sub f g =>
      match fraction f, fraction g with Some p, Some q => Some (p, q) | _, _ => None end
  | _ => None
  end.
(* What a product of names is, which divides by nothing. *)
Definition rule_of_names : Type := PExpr Q * PExpr Q.
Fixpoint whole (f : FExpr Q) : option (PExpr Q) :=
  let both of a b := match whole a, whole b with Some p, Some q => Some (of p q) | _, _ => None end in
  match f with
  | FEX n => Some (PEX _ n)
  | FEc q => Some (PEc q)
  | FEadd a b => both (@PEadd Q) a b
  | FEsub a b => both (@PEsub Q) a b
  | FEmul a b => both (@PEmul Q) a b
  | FEopp a => option_map (@PEopp Q) (whole a)
  | FEpow a n => option_map (fun p => PEpow p n) (whole a)
  | _ => None
  end.
Definition rule (e : expr) : option rule_of_names :=
  match sides e with
  | Some (p, q) => match whole p, whole q with Some p, Some q => Some (p, q) | _, _ => None end
  | None => None
  end.
Definition equal (rs : list rule_of_names) (f g : FExpr Q) : option (list (PExpr Q)) :=
  let normal := with_numbers (@norm_subst Q) divided Ring_tac.ring_subst_niter
    (with_numbers (@mk_monpol_list Q) divided rs) in
  let p := with_numbers (@Fnorm Q) f in
  let q := with_numbers (@Fnorm Q) g in
  if Peq Qeq_bool (normal (PEmul (num p) (denum q))) (normal (PEmul (num q) (denum p)))
  then Some (Fapp (with_numbers (@Fcons2 Q) divided) (condition p ++ condition q) nil) else None.
Notation evaluated := (at_numbers (in_reals (@PEeval))).
Fixpoint hold (xs : list R) (rs : list rule_of_names) : Prop :=
  match rs with nil => True | cons (p, q) rs => evaluated xs p = evaluated xs q /\ hold xs rs end.
Lemma held : forall xs rs, hold xs rs -> at_numbers (in_reals (@interp_PElist) (@eq R)) xs rs.
Proof.
  intros xs; induction rs as [| [p q] [| r rs] IH]; intro H; [exact I | exact (proj1 H) |].
  split; [exact (proj1 H) | exact (IH (proj2 H))].
Qed.
Notation apart := (at_numbers (in_reals (@PCond) (@eq R))).
Notation value := (at_numbers (in_reals (@FEeval) Rdiv Rinv)).
Lemma by_normal_forms : forall xs rs f g cs,
  hold xs rs -> equal rs f g = Some cs -> apart xs cs -> value xs f = value xs g.
Proof.
  intros xs rs f g cs H E C; unfold equal in E; destruct (Peq _ _ _) eqn:P in E; [| discriminate].
  apply (Rquotients_field_lemma1 Ring_tac.ring_subst_niter xs rs f g (held xs rs H)
    _ eq_refl _ eq_refl _ eq_refl P).
  apply Rquotients_lemma5; intros lock L; rewrite L; injection E; intro W; rewrite <- W in C; exact C.
Qed.
End Fractions.
(* A name for each value of a function in the goal, but not for the inverses of numbers. *)
Ltac named f :=
  repeat match goal with |- context [f ?a] =>
    lazymatch constr:(f a) with / IZR _ => fail | ?x => let v := fresh "v" in set (v := x) end
  end.
Ltac functions_named := named cos; named sin; named exp; named sqrt; named ln; named tan; named atan; named Rabs.
Ltac unnamed := repeat match goal with v := _ : R |- _ => unfold v; clear v end.
Ltac variables_and xs :=
  match goal with
  | x : R |- _ => lazymatch xs with context [x] => fail | _ => variables_and constr:(x :: xs) end
  | _ => xs
  end.
(* ring and field, in less time, where rules say what squares are. *)
Ltac fraction_by xs rs rules_hold :=
  lazymatch goal with |- ?l = ?r :> R =>
    let e := expressed (l - r) xs in
    lazymatch eval vm_compute in (Fractions.sides e) with Some (?e, ?f) =>
      lazymatch eval vm_compute in (Fractions.equal rs e f) with Some ?cs =>
        simple refine (Fractions.by_normal_forms xs rs e f cs rules_hold _ _);
          [vm_cast_no_check (@eq_refl _ (Some cs)) |];
          protect_fv "field_cond"; fold_field_cond (@eq R); try exact I; unnamed
      end
    end
  end.
Ltac fraction_named :=
  let xs := variables_and constr:(PI :: nil) in
  fraction_by xs (@nil Fractions.rule_of_names) I.
(* Inverses are names, too. *)
Ltac polynomial := try unfold Rdiv; functions_named; named Rinv; solve [fraction_named].
Ltac fraction :=
  first
    [ lazymatch goal with |- context [_ / _] => polynomial | |- context [/ _] => polynomial end
    | functions_named; fraction_named ].
Ltac expressible :=
  lazymatch goal with |- ?l = ?r =>
    let xs := variables_and constr:(PI :: nil) in let e := expressed (l - r) xs in idtac
  end.
Ltac undivided := try unfold Rdiv in *; try unfold Cdiv in *.

(* -- logic -------------------------------------------------------------------------- *)

Ltac opened := repeat match goal with H : _ /\ _ |- _ => destruct H end.

(* -- what is not zero --------------------------------------------------------------- *)

Lemma product_apart : forall x y, x * y <> 0 -> x <> 0 /\ y <> 0.
Proof. intros x y H; split; intro E; apply H; rewrite E; ring. Qed.

Lemma power_apart : forall x n, x ^ S n <> 0 -> x <> 0.
Proof. intros x n H E; apply H; rewrite E; simpl; ring. Qed.

Ltac factors :=
  repeat match goal with
  | H : _ * _ <> 0 |- _ => apply product_apart in H; destruct H
  | H : _ ^ S _ <> 0 |- _ => apply power_apart in H
  end.

Ltac nz_known :=
  match goal with
  | H : 0 < ?c |- ?e <> 0 =>
      solve [let E := fresh in intro E; rewrite E in H; clear - H; lra]
  | H : ?c <> 0 |- ?e <> 0 => exact H
  | H : ?c <> 0 |- ?e <> 0 => solve [let E := fresh in intro E; apply H; rewrite E; unfold Rdiv; ring]
  | H : ?c <> ?d |- ?e <> 0 => solve [let E := fresh in intro E; apply H; lra]
  | H : ?c <> 0 |- ?e <> 0 => solve [let E := fresh in intro E; apply H; replace c with e by polynomial; exact E]
  | H : ?c <> 0 |- ?e <> 0 => 
      solve [let E := fresh in intro E; apply H; replace c with (- e) by polynomial; rewrite E; ring]
  | H : ?f ?a <> 0 |- ?f ?b <> 0 => solve [replace b with a by polynomial; exact H]
  end.

Ltac nz_with last :=
  opened; factors; repeat split; shown_here;
  first
    [ assumption
    | lra
    | apply Rgt_not_eq; apply exp_pos
    | apply Rgt_not_eq; apply PI_RGT_0
    | apply Rgt_not_eq; lra
    | apply Rlt_not_eq; lra
    | nz_known
    | solve [apply Rmult_integral_contrapositive_currified; nz_with last]
    | solve [apply pow_nonzero; nz_with last]
    | solve [apply Ropp_neq_0_compat; nz_with last]
    | solve [apply Rinv_neq_0_compat; nz_with last]
    | match goal with H : ?c <> 0 |- ?e <> 0 =>
        solve [replace e with (c * c) by polynomial; apply Rmult_integral_contrapositive_currified; exact H]
      end
    | solve [apply Rgt_not_eq; interval]
    | solve [apply Rlt_not_eq; interval]
    | last tt ].

Ltac nz_none _ := fail.
Ltac nz_quick := nz_with nz_none.

(* The last resort: what is a multiple of it would vanish. *)
Ltac nz_hard _ :=
  match goal with H : ?c <> 0 |- ?e <> 0 =>
    solve
      [let E := fresh in intro E; apply H; field_simplify_eq;
       [ first
           [ transitivity e; [ring | exact E]
           | transitivity (- e); [ring | rewrite E; ring]
           | field_simplify_eq in E; [shown; lra | nz_quick ..] ]
       | nz_quick .. ]]
  end.

Ltac nz := nz_with nz_hard.

Ltac defined := repeat (split; [solve [opened; first [assumption | lra | nz]] |]).

(* -- identities --------------------------------------------------------------------- *)

Ltac known_values :=
  rewrite ?Ropp_mult_distr_l_reverse, ?sin_neg, ?cos_neg, ?sin_0, ?cos_0, ?sin_PI, ?cos_PI,
    ?sin_PI2, ?cos_PI2, ?exp_0, ?sqrt_0, ?sqrt_1, ?tan_0, ?tan_PI4.
Ltac other_field nz :=
  tryif (try unfold Rdiv; functions_named; expressible) then fail else
  solve [undivided; first [solve [ring] | field; nz]].
Lemma cancelled_left : forall x y : R, x <> 0 -> x * y / x = y.
Proof. intros; field; assumption. Qed.
Lemma cancelled_right : forall x y : R, x <> 0 -> y * x / x = y.
Proof. intros; field; assumption. Qed.
Ltac cancelled := first [apply cancelled_left | apply cancelled_right]; assumption.
Ltac same_field := first [reflexivity | cancelled | solve [fraction; nz] | other_field nz].
Ltac quick_field := first [reflexivity | cancelled | solve [fraction; nz_quick] | other_field nz_quick].
Lemma pythagoras : forall x, sin x ^ 2 + cos x ^ 2 - 1 = 0.
Proof. intro x; generalize (sin2_cos2 x); unfold Rsqr; intro H; nra. Qed.

Lemma sine_square : forall x, sin x * sin x = 1 - cos x * cos x.
Proof. intro x; generalize (pythagoras x); lra. Qed.

Lemma root_square : forall x, 0 <= x -> sqrt x * sqrt x = x.
Proof. intros x H; apply sqrt_sqrt; exact H. Qed.

Ltac rooted := opened; first [assumption | lra | nra | interval].

Lemma sin_45 : sin (PI / 4) = sqrt 2 / 2.
Proof. rewrite sin_PI4; field [(root_square 2 ltac:(lra))]; apply Rgt_not_eq, sqrt_lt_R0; lra. Qed.
Lemma cos_45 : cos (PI / 4) = sqrt 2 / 2.
Proof. rewrite cos_PI4, <- sin_PI4; exact sin_45. Qed.
(* With the squares of sines, in those of cosines, and of roots. *)
Definition because (P : Prop) (proof : P) : P := proof.
Ltac squares xs rs p :=
  let another v b proof :=
    lazymatch p with context [v * v] => fail | _ =>
      let e := expressed (v * v - b) xs in
      lazymatch eval vm_compute in (Fractions.rule e) with Some ?r =>
        squares xs constr:(r :: rs) constr:(conj (because (v * v = b) proof) p)
      end
    end in
  match goal with
  | v := sin ?a, w := cos ?a |- _ => another v (1 - w * w) (sine_square a)
  | v := sqrt ?a |- _ => another v a (root_square a ltac:(rooted))
  | _ => constr:((rs, p))
  end.
Ltac squared :=
  functions_named;
  let xs := variables_and constr:(PI :: nil) in
  let rules := squares xs (@nil Fractions.rule_of_names) I in
  lazymatch rules with (?rs, ?p) => fraction_by xs rs p end.
Ltac rooted_field := solve [squared; nz_quick].
Ltac by_squares :=
  first [solve [squared; nz] | undivided; field_simplify_eq; [shown; first [lra | nra] | nz ..]].
Ltac special_values :=
  rewrite ?sin_PI, ?cos_PI, ?sin_PI2, ?cos_PI2, ?sin_0, ?cos_0,
    ?sin_PI6, ?cos_PI6, ?sin_PI3, ?cos_PI3, ?sin_45, ?cos_45.
Ltac turned :=
  repeat first [rewrite sin_plus | rewrite cos_plus | rewrite sin_neg | rewrite cos_neg];
  first [polynomial | special_values; first [polynomial | rooted_field]].

Ltac raised := repeat rewrite exp_plus; rewrite ?exp_Ropp; field; nz.
(* The value of a function of a sum, which is written out. *)
Ltac root_squares :=
  repeat match goal with |- context [sqrt ?a] =>
    lazymatch goal with _ : sqrt a * sqrt a = _ |- _ => fail | _ => pose proof (root_square a ltac:(rooted)) end
  end.
Ltac same_root := apply Rsqr_inj; [rooted | rooted | unfold Rsqr; root_squares; lra].
Ltac by_parts way :=
  transitivity way; [f_equal; first [solve [fraction; nz] | solve [same_root]] | first [turned | raised]].

(* -- signs -------------------------------------------------------------------------- *)

Lemma by_sum_lt : forall l r t z : R, r - l = t + z -> z = 0 -> 0 < t -> l < r.
Proof. intros; lra. Qed.
Lemma by_sum_le : forall l r t z : R, r - l = t + z -> z = 0 -> 0 <= t -> l <= r.
Proof. intros; lra. Qed.
Lemma by_sum_eq : forall l r z : R, r - l = z -> z = 0 -> l = r.
Proof. intros; lra. Qed.
Lemma by_sum_ne : forall l r t z : R, r - l = t + z -> z = 0 -> t <> 0 -> l <> r.
Proof. intros l r t z H Z N E; apply N; lra. Qed.
Lemma by_sum_ne' : forall l r t z : R, l - r = t + z -> z = 0 -> t <> 0 -> l <> r.
Proof. intros l r t z H Z N E; apply N; lra. Qed.

Lemma difference_positive : forall l r : R, l < r -> 0 < r - l.
Proof. intros; lra. Qed.
Lemma difference_not_negative : forall l r : R, l <= r -> 0 <= r - l.
Proof. intros; lra. Qed.

(* A sum of products: what is known is taken as it stands, so that no tactic multiplies it out. *)
Ltac signed :=
  first
    [ lazymatch goal with
      | H : ?l < ?r |- 0 < ?r - ?l => exact (difference_positive l r H)
      | H : ?l <= ?r |- 0 <= ?r - ?l => exact (difference_not_negative l r H)
      | |- 0 < _ * _ => solve [apply Rmult_lt_0_compat; signed]
      | |- 0 <= _ * _ => solve [apply Rmult_le_pos; signed]
      | |- 0 < _ + _ =>
          first
            [ solve [apply Rplus_lt_le_0_compat; signed]
            | solve [apply Rplus_le_lt_0_compat; signed] ]
      | |- 0 <= _ + _ => solve [apply Rplus_le_le_0_compat; signed]
      end
    | lra ].

Ltac apart :=
  opened;
  first
    [ nz
    | solve [apply Rgt_not_eq; signed]
    | solve [repeat apply Rmult_integral_contrapositive_currified; first [nz | lra]] ].

Ltac refuted :=
  first [lra | match goal with H : _ <> _ |- False => solve [apply H; lra] end].

(* -- complex numbers ---------------------------------------------------------------- *)

Definition Cvalue (q : QArith_base.Q) : C :=
  match QArith_base.Qden q with
  | xH => RtoC (IZR (QArith_base.Qnum q))
  | p =>
      match QArith_base.Qnum q with
      | Zpos xH => (/ RtoC (IZR (Zpos p)))%C
      | n => (RtoC (IZR n) * / RtoC (IZR (Zpos p)))%C
      end
  end.
Lemma Cvalued : forall q, Cvalue q = RtoC (Qvalue q).
Proof.
  intros [[| [p | p |] | p] [d | d |]]; unfold Cvalue, Qvalue; simpl; try reflexivity;
    rewrite ?RtoC_mult, RtoC_inv by (apply IZR_neq; discriminate); reflexivity.
Qed.
Lemma Cnumbers : Q_morph (RtoC 0) (RtoC 1) Cplus Cmult Cminus Copp (@eq C) Cvalue.
Proof.
  destruct Qnumbers; split; intros; rewrite ?Cvalued; try reflexivity.
  - rewrite morph_add; apply RtoC_plus.
  - rewrite morph_sub; apply RtoC_minus.
  - rewrite morph_mul; apply RtoC_mult.
  - rewrite morph_opp; apply RtoC_opp.
  - apply f_equal, morph_eq; assumption.
Qed.
Lemma Ccomplete : forall p q, Cvalue p = Cvalue q -> QArith_base.Qeq_bool p q = true.
Proof. intros p q; rewrite !Cvalued; intro E; apply Qcomplete, RtoC_inj, E. Qed.
Ltac Cnumber t :=
  match t with
  | Cvalue ?q => constr:(q)
  | RtoC (IZR ?n) => whole_Q n
  | Cinv (RtoC (IZR (Zpos ?p))) => part_Q p
  | _ => constr:(InitialRing.NotConstant)
  end.
Add Field Cnumbered : C_field_theory (morphism Cnumbers, completeness Ccomplete, constants [Cnumber]).

Lemma RtoC_div : forall x y : R, y <> 0 -> RtoC (x / y)%R = (RtoC x / RtoC y)%C.
Proof. intros x y H; unfold Rdiv, Cdiv; rewrite RtoC_mult, RtoC_inv; [reflexivity | exact H]. Qed.
Lemma RtoC_power : forall x n, RtoC (x ^ n)%R = (RtoC x ^ n)%C.
Proof. intros x n; induction n as [| n IH]; simpl; [| rewrite RtoC_mult, IH]; reflexivity. Qed.

(* The complex number that a real term is, made of those of its parts. *)
Section Images.
Variables (x y : R) (z w : C).
Hypotheses (X : RtoC x = z) (Y : RtoC y = w).
Lemma image_plus : RtoC (x + y)%R = (z + w)%C.
Proof. rewrite <- X, <- Y; apply RtoC_plus. Qed.
Lemma image_minus : RtoC (x - y)%R = (z - w)%C.
Proof. rewrite <- X, <- Y; apply RtoC_minus. Qed.
Lemma image_mult : RtoC (x * y)%R = (z * w)%C.
Proof. rewrite <- X, <- Y; apply RtoC_mult. Qed.
Lemma image_opp : RtoC (- x)%R = (- z)%C.
Proof. rewrite <- X; apply RtoC_opp. Qed.
Lemma image_power : forall n, RtoC (x ^ n)%R = (z ^ n)%C.
Proof. intro n; rewrite <- X; apply RtoC_power. Qed.
Lemma image_div : y <> 0 -> RtoC (x / y)%R = (z / w)%C.
Proof. intro N; rewrite <- X, <- Y; apply RtoC_div, N. Qed.
End Images.
Ltac Cimage x :=
  match x with
  | ?a + ?b => let p := Cimage a in let q := Cimage b in constr:(image_plus _ _ _ _ p q)
  | ?a - ?b => let p := Cimage a in let q := Cimage b in constr:(image_minus _ _ _ _ p q)
  | ?a * ?b => let p := Cimage a in let q := Cimage b in constr:(image_mult _ _ _ _ p q)
  | - ?a => let p := Cimage a in constr:(image_opp _ _ p)
  | ?a ^ ?n => let p := Cimage a in constr:(image_power _ _ p n)
  | ?a / ?b =>
      let n := constr:(ltac:(nz) : b <> 0) in
      let p := Cimage a in let q := Cimage b in constr:(image_div _ _ _ _ p q n)
  | _ => constr:(eq_refl (RtoC x))
  end.
Ltac Cpushed :=
  repeat match goal with |- context [RtoC ?x] =>
    let p := Cimage x in
    lazymatch type of p with ?l = ?l => fail | _ => rewrite p end
  end.
Lemma Cexp_nought : forall z : C, z = RtoC 0 -> Cexp z = RtoC 1.
Proof.
  intros z E; rewrite E; unfold Cexp; simpl; rewrite exp_0, cos_0, sin_0.
  apply injective_projections; simpl; ring.
Qed.
Lemma Cexp_plus : forall z w : C, Cexp (z + w)%C = (Cexp z * Cexp w)%C.
Proof.
  intros [a b] [c d]; unfold Cexp; simpl; rewrite exp_plus, cos_plus, sin_plus.
  apply injective_projections; simpl; ring.
Qed.
Lemma Cexp_log : forall z : C, z <> RtoC 0 -> Cexp (Clog z) = z.
Proof.
  intros z N; assert (P := proj1 (Cmod_gt_0 z) N); unfold Cexp, Clog, Cangle_of; simpl.
  assert (S : Re z * Re z + Im z * Im z = Cmod z * Cmod z).
  { unfold Cmod; rewrite sqrt_sqrt; [unfold Re, Im; ring |].
    apply Rplus_le_le_0_compat; apply pow2_ge_0. }
  assert (B : -1 <= Re z / Cmod z <= 1).
  { assert (Q : (Re z / Cmod z) * (Re z / Cmod z) <= 1).
    { apply Rmult_le_reg_r with (Cmod z * Cmod z); [apply Rmult_lt_0_compat; lra |].
      replace (Re z / Cmod z * (Re z / Cmod z) * (Cmod z * Cmod z)) with (Re z * Re z) by (field; lra).
      generalize (pow2_ge_0 (Im z)); lra. }
    split; nra. }
  assert (W : Cmod z * sqrt (1 - Rsqr (Re z / Cmod z)) = Rabs (Im z)).
  { rewrite <- (sqrt_square (Cmod z)) at 1 by lra; rewrite <- sqrt_mult_alt by (apply Rmult_le_pos; lra).
    rewrite <- (sqrt_Rsqr_abs (Im z)); f_equal; unfold Rsqr.
    replace (Im z * Im z) with (Cmod z * Cmod z - Re z * Re z) by lra; field; lra. }
  destruct (Rle_dec 0 (Im z)) as [L | L]; rewrite exp_ln by exact P.
  - rewrite cos_acos, sin_acos by exact B; rewrite W, Rabs_pos_eq by exact L.
    apply injective_projections; unfold Re, Im; simpl; [field; lra | reflexivity].
  - rewrite cos_neg, sin_neg, cos_acos, sin_acos by exact B.
    rewrite Ropp_mult_distr_r_reverse, W, Rabs_left by lra.
    apply injective_projections; unfold Re, Im; simpl; [field; lra | ring].
Qed.
Lemma Craised_plus : forall z v w : C, z <> RtoC 0 -> Craised z (v + w)%C = (Craised z v * Craised z w)%C.
Proof.
  intros z v w N; unfold Craised; destruct (Ceq_dec z 0) as [E | _]; [contradiction |].
  rewrite <- Cexp_plus; f_equal; ring.
Qed.
Lemma Cexp_apart : forall z : C, Cexp z <> RtoC 0.
Proof.
  intros z E; assert (W : (Cexp z * Cexp (- z))%C = RtoC 1).
  { rewrite <- Cexp_plus; apply Cexp_nought; ring. }
  rewrite E in W; apply (f_equal fst) in W; simpl in W; lra.
Qed.
Lemma Craised_apart : forall z w : C, z <> RtoC 0 -> Craised z w <> RtoC 0.
Proof.
  intros z w N; unfold Craised; destruct (Ceq_dec z 0) as [F | _]; [contradiction |].
  apply Cexp_apart.
Qed.
Lemma Craised_number : forall (z : C) n, Craised z (RtoC (INR n)) = (z ^ n)%C.
Proof.
  intros z n; destruct (Ceq_dec z 0) as [E | N].
  - unfold Craised; destruct (Ceq_dec z 0) as [_ | F]; [| contradiction]; destruct n as [| n].
    + destruct (Ceq_dec (INR 0) 0) as [_ | F]; [reflexivity | exfalso; apply F; reflexivity].
    + destruct (Ceq_dec (INR (S n)) 0) as [F | _].
      * apply RtoC_inj in F; generalize (lt_0_INR (S n) (Nat.lt_0_succ n)); lra.
      * rewrite E; simpl; ring.
  - induction n as [| n IH]; [| rewrite S_INR, RtoC_plus, Craised_plus, IH by exact N].
    + unfold Craised; destruct (Ceq_dec z 0) as [F | _]; [contradiction |].
      apply Cexp_nought; simpl; ring.
    + simpl; unfold Craised; destruct (Ceq_dec z 0) as [F | _]; [contradiction |].
      replace (RtoC 1 * Clog z)%C with (Clog z) by ring; rewrite Cexp_log by exact N; ring.
Qed.
Lemma Cnot_zero : forall x : R, x <> 0 -> RtoC x <> RtoC 0.
Proof. intros x H E; apply H, RtoC_inj, E. Qed.
Lemma Cproduct_apart : forall x y : C, x <> RtoC 0 -> y <> RtoC 0 -> (x * y)%C <> RtoC 0.
Proof. intros x y; apply Cmult_neq_0. Qed.
Lemma Ci_apart : Ci <> RtoC 0.
Proof. intro E; apply (f_equal snd) in E; simpl in E; lra. Qed.
(* What is known not to be zero, in complex numbers, too. *)
Ltac Clifted :=
  repeat match goal with H : ?x <> 0 |- _ =>
    lazymatch goal with |- context [RtoC x <> RtoC 0 -> _] => fail | _ => generalize (Cnot_zero x H) end
  end;
  Cpushed; intros; cbn [Cpower] in *.
Ltac Cring := cbn [Cpower]; first [reflexivity | ring].
(* By its real or its imaginary part. *)
Ltac Cnz_part :=
  let E := fresh in
  let part f := apply (f_equal f) in E; simpl in E; ring_simplify in E; shown; revert E;
    first [apply Rgt_not_eq; interval | apply Rlt_not_eq; interval] in
  intro E; first [solve [part (@fst R R)] | solve [part (@snd R R)]].
Ltac Cnz_with last :=
  cbv beta; repeat split; try (unfold Cvalue; cbn [QArith_base.Qnum QArith_base.Qden]);
  first
    [ assumption
    | apply Ci_apart
    | apply Cexp_apart
    | apply Craised_apart; assumption
    | apply Cnot_zero; nz_with last
    | Cnz_part
    | solve [apply Cproduct_apart; Cnz_with last]
    | match goal with
      | H : ?c <> RtoC 0 |- ?e <> RtoC 0 =>
          solve [let E := fresh in intro E; apply H;
            first [replace c with e by Cring; exact E | replace c with (- e)%C by Cring; rewrite E; Cring]]
      end
    | last tt ].
Ltac Cnz_quick := opened; Cnz_with nz_none.
Ltac Cnz_hard _ :=
  match goal with
  | H : ?c <> RtoC 0 |- ?e <> RtoC 0 =>
      solve
        [let E := fresh in intro E; apply H; cbn [Cpower]; field_simplify_eq;
         [ first [transitivity e; [Cring | exact E] | transitivity (- e)%C; [Cring | rewrite E; Cring]]
         | Cnz_quick .. ]]
  | |- _ <> 0 => nz_hard tt
  end.
Ltac Cnz := Cnz_with Cnz_hard.
Ltac Cquick_field :=
  cbn [Cpower]; first [reflexivity | solve [undivided; first [solve [ring] | field; Cnz_quick]]].
Ltac Csame_field := first [Cquick_field | solve [cbn [Cpower]; undivided; field; Cnz]].

Ltac enclosed := first [lra | interval | interval with (i_prec 100) | interval with (i_prec 400)].
Ltac numeric :=
  first
    [ enclosed
    | solve [apply Rlt_not_eq; enclosed]
    | solve [apply Rgt_not_eq; enclosed]
    | nz
    | Cnz ].

(* Both components, as real numbers. *)
Ltac Ccompared := apply injective_projections; simpl; first [reflexivity | solve [ring] | solve [field; nz] | lra].

Lemma Cexp_at : forall (z : C) (a b : R),
  z = (a + Ci * b)%C -> Cexp z = (exp a * (cos b + Ci * sin b))%C.
Proof.
  intros z a b E; rewrite E; unfold Cexp.
  replace (Re (a + Ci * b)%C) with a by (simpl; ring).
  replace (Im (a + Ci * b)%C) with b by (simpl; ring).
  apply injective_projections; simpl; ring.
Qed.
Lemma Cexp_turned : forall (z : C) (a b : R) (size c s : C),
  z = (a + Ci * b)%C -> RtoC (exp a) = size -> RtoC (cos b) = c -> RtoC (sin b) = s ->
  Cexp z = (size * (c + Ci * s))%C.
Proof. intros z a b size c s E F G H; rewrite (Cexp_at z a b E), F, G, H; reflexivity. Qed.
Lemma Ci_square : (Ci * Ci)%C = (- RtoC 1)%C.
Proof. apply injective_projections; simpl; ring. Qed.
Ltac Csame_turned :=
  cbn [Cpower]; first [Csame_field | solve [ring [Ci_square]] | solve [field [Ci_square]; Cnz]].

Lemma Csine_square : forall x : R, (sin x * sin x = 1 - cos x * cos x :> C)%C.
Proof.
  intro x; apply injective_projections; simpl; [| ring].
  generalize (sine_square x); intro E; ring_simplify; ring_simplify in E; exact E.
Qed.
Lemma Croot_square : forall (x : R) (z : C), 0 <= x -> z = RtoC x -> (sqrt x * sqrt x)%C = z.
Proof. intros x z H E; rewrite E, <- RtoC_mult, root_square; [reflexivity | exact H]. Qed.
Lemma Cby_zero : forall l r q : C, (l - r)%C = q -> q = RtoC 0 -> l = r.
Proof. intros l r q H E; replace l with ((l - r) + r)%C by ring; rewrite H, E; ring. Qed.
Lemma Cby_sum_eq : forall l r z : C, (r - l)%C = z -> z = RtoC 0 -> l = r.
Proof. intros l r z H E; symmetry; apply (Cby_zero _ _ z); assumption. Qed.
Lemma Cby_sum_ne : forall l r t z : C, (r - l)%C = (t + z)%C -> z = RtoC 0 -> t <> RtoC 0 -> l <> r.
Proof.
  intros l r t z H E N F; apply N; rewrite F, E in H.
  replace t with (t + 0)%C by ring; rewrite <- H; ring.
Qed.
Lemma Cby_sum_ne' : forall l r t z : C,
  (l - r)%C = (t + z)%C -> z = RtoC 0 -> t <> RtoC 0 -> l <> r.
Proof. intros l r t z H E N F; apply (Cby_sum_ne r l t z H E N); symmetry; exact F. Qed.

Definition Cpos (z : C) : Prop := Im z = 0 /\ 0 < Re z.
Definition Cnonneg (z : C) : Prop := Im z = 0 /\ 0 <= Re z.
Lemma Cby_sum_lt : forall l r t z : C,
  (r - l)%C = (t + z)%C -> z = RtoC 0 -> Cpos t -> Im l = 0 -> Cless l r.
Proof.
  intros l r t z H E [I P] L; rewrite E in H; replace r with (l + t)%C.
  - unfold Cless; simpl; repeat split; unfold Im, Re in *; lra.
  - replace r with ((r - l) + l)%C by ring; rewrite H; ring.
Qed.
Lemma Cby_sum_le : forall l r t z : C,
  (r - l)%C = (t + z)%C -> z = RtoC 0 -> Cnonneg t -> Im l = 0 -> Cless_eq l r.
Proof.
  intros l r t z H E [I P] L; rewrite E in H; replace r with (l + t)%C.
  - unfold Cless_eq; simpl; repeat split; unfold Im, Re in *; lra.
  - replace r with ((r - l) + l)%C by ring; rewrite H; ring.
Qed.
Lemma Cpos_minus : forall l r, Cless l r -> Cpos (r - l)%C.
Proof. intros l r (I & J & L); split; simpl; unfold Im, Re in *; lra. Qed.
Lemma Cnonneg_minus : forall l r, Cless_eq l r -> Cnonneg (r - l)%C.
Proof. intros l r (I & J & L); split; simpl; unfold Im, Re in *; lra. Qed.
Lemma Cnonneg_minus' : forall l r, Cless l r -> Cnonneg (r - l)%C.
Proof. intros l r (I & J & L); split; simpl; unfold Im, Re in *; lra. Qed.
Lemma Cpos_mult : forall x y, Cpos x -> Cpos y -> Cpos (x * y)%C.
Proof.
  intros x y [I P] [J Q]; split; simpl; unfold Im, Re in *; rewrite ?I, ?J; [ring |].
  generalize (Rmult_lt_0_compat _ _ P Q); lra.
Qed.
Lemma Cnonneg_mult : forall x y, Cnonneg x -> Cnonneg y -> Cnonneg (x * y)%C.
Proof.
  intros x y [I P] [J Q]; split; simpl; unfold Im, Re in *; rewrite ?I, ?J; [ring |].
  generalize (Rmult_le_pos _ _ P Q); lra.
Qed.
Lemma Cpos_plus : forall x y, Cpos x -> Cnonneg y -> Cpos (x + y)%C.
Proof. intros x y [I P] [J Q]; split; simpl; unfold Im, Re in *; lra. Qed.
Lemma Cpos_plus' : forall x y, Cnonneg x -> Cpos y -> Cpos (x + y)%C.
Proof. intros x y [I P] [J Q]; split; simpl; unfold Im, Re in *; lra. Qed.
Lemma Cnonneg_plus : forall x y, Cnonneg x -> Cnonneg y -> Cnonneg (x + y)%C.
Proof. intros x y [I P] [J Q]; split; simpl; unfold Im, Re in *; lra. Qed.
Lemma Cpos_real : forall x : R, 0 < x -> Cpos x.
Proof. intros x H; split; [reflexivity | exact H]. Qed.
Lemma Cnonneg_real : forall x : R, 0 <= x -> Cnonneg x.
Proof. intros x H; split; [reflexivity | exact H]. Qed.
Ltac Csigned :=
  first
    [ solve [apply Cpos_minus; assumption]
    | solve [apply Cnonneg_minus; assumption]
    | solve [apply Cnonneg_minus'; assumption]
    | lazymatch goal with
      | |- Cpos (_ + _)%C =>
          first [solve [apply Cpos_plus; Csigned] | solve [apply Cpos_plus'; Csigned]]
      | |- Cnonneg (_ + _)%C => apply Cnonneg_plus; Csigned
      | |- Cpos (_ * _)%C => apply Cpos_mult; Csigned
      | |- Cnonneg (_ * _)%C => apply Cnonneg_mult; Csigned
      end
    | solve [apply Cpos_real; lra]
    | solve [apply Cnonneg_real; lra]
    | solve [split; simpl; first [ring | lra]] ].
Ltac Cimaginary := first [reflexivity | simpl; ring | simpl; lra].
Lemma Cminus_zero : forall l r : C, l = r -> (r - l)%C = RtoC 0.
Proof. intros l r E; rewrite E; ring. Qed.
Ltac Czero :=
  first
    [ symmetry; apply Cminus_zero; first [assumption | symmetry; assumption]
    | solve [apply (f_equal RtoC); lra]
    | Ccompared ].
Lemma Cconj_real : forall x : R, Cconj (RtoC x) = RtoC x.
Proof. intros; apply injective_projections; simpl; ring. Qed.
Lemma Cconj_i : Cconj Ci = (- Ci)%C.
Proof. apply injective_projections; simpl; ring. Qed.
(* The mirror of a term, made of those of its parts. *)
Section Mirrors.
Variables (x y z w : C) (n : nat).
Hypotheses (X : Cconj x = z) (Y : Cconj y = w).
Lemma mirror_plus : Cconj (x + y)%C = (z + w)%C.
Proof. rewrite <- X, <- Y; apply injective_projections; simpl; ring. Qed.
Lemma mirror_minus : Cconj (x - y)%C = (z - w)%C.
Proof. rewrite <- X, <- Y; apply injective_projections; simpl; ring. Qed.
Lemma mirror_mult : Cconj (x * y)%C = (z * w)%C.
Proof. rewrite <- X, <- Y; apply injective_projections; simpl; ring. Qed.
Lemma mirror_opp : Cconj (- x)%C = (- z)%C.
Proof. rewrite <- X; apply injective_projections; simpl; ring. Qed.
Lemma mirror_inv : Cconj (/ x)%C = (/ z)%C.
Proof.
  rewrite <- X; apply injective_projections; simpl; unfold Rdiv;
    replace (- snd x * (- snd x * 1)) with (snd x * (snd x * 1)) by ring; ring.
Qed.
Lemma mirror_exp : Cconj (Cexp x) = Cexp z.
Proof.
  rewrite <- X; unfold Cexp, Cconj, Re, Im; simpl; rewrite cos_neg, sin_neg.
  apply injective_projections; simpl; ring.
Qed.
End Mirrors.
Lemma mirror_power : forall (x z : C) n, Cconj x = z -> Cconj (x ^ n)%C = (z ^ n)%C.
Proof.
  intros x z n X; induction n as [| n IH]; simpl; [apply Cconj_real | apply mirror_mult; assumption].
Qed.
Ltac Cmirror z :=
  match z with
  | (?a + ?b)%C => let p := Cmirror a in let q := Cmirror b in constr:(mirror_plus _ _ _ _ p q)
  | (?a - ?b)%C => let p := Cmirror a in let q := Cmirror b in constr:(mirror_minus _ _ _ _ p q)
  | (?a * ?b)%C => let p := Cmirror a in let q := Cmirror b in constr:(mirror_mult _ _ _ _ p q)
  | (- ?a)%C => let p := Cmirror a in constr:(mirror_opp _ _ p)
  | (/ ?a)%C => let p := Cmirror a in constr:(mirror_inv _ _ p)
  | (?a ^ ?n)%C => let p := Cmirror a in constr:(mirror_power _ _ n p)
  | Cexp ?a => let p := Cmirror a in constr:(mirror_exp _ _ p)
  | RtoC ?x => constr:(Cconj_real x)
  | Ci => constr:(Cconj_i)
  | _ => constr:(eq_refl (Cconj z))
  end.
Ltac Cconjugated :=
  unfold Cdiv;
  repeat match goal with |- context [Cconj ?z] =>
    let p := Cmirror z in
    lazymatch type of p with ?l = ?l => fail | _ => rewrite p end
  end.
Ltac Cangles :=
  repeat match goal with
  | E : context [Cexp ?a] |- context [Cexp ?b] =>
      tryif constr_eq a b then fail
      else replace (Cexp a) with (Cexp b) in E by (f_equal; Cring)
  end.
Ltac Cmirrored :=
  match goal with
  | H : ?l = ?r |- _ =>
      let E := fresh in
      pose proof (f_equal Cconj H) as E; clear - E; revert E; Cconjugated; intro E; Cangles;
      first [exact E | etransitivity; [| etransitivity; [exact E |]]; Cring]
  | H : ~ @eq C ?l ?r |- ~ @eq C _ _ => let E := fresh in intro E; apply H; clear H; Cmirrored
  end.
Lemma Creal : forall z : C, Cconj z = z -> z = RtoC (Re z).
Proof.
  intros [x y] E; injection E; intro F; apply injective_projections; simpl; [reflexivity | lra].
Qed.
(* Each exponential once: 1, or one that was met before. *)
Ltac Cexps :=
  repeat match goal with |- context [Cexp ?a] =>
    first
      [ rewrite (Cexp_nought a) by Cring
      | match goal with e := Cexp ?b |- _ => replace (Cexp a) with e by (unfold e; f_equal; Cring) end
      | let e := fresh "e" in set (e := Cexp a) ]
  end;
  repeat match goal with e := Cexp _ |- _ => unfold e; clear e end.
Ltac Cunmoved :=
  Cconjugated;
  Cexps; Csame_turned.

(* A real relation between numbers that are written as complex ones, and back. *)
Lemma Cless_of : forall (a b : R) (l r : C), a < b -> l = RtoC a -> r = RtoC b -> Cless l r.
Proof. intros a b l r H L R; subst; repeat split; exact H. Qed.
Lemma Cless_eq_of : forall (a b : R) (l r : C), a <= b -> l = RtoC a -> r = RtoC b -> Cless_eq l r.
Proof. intros a b l r H L R; subst; repeat split; exact H. Qed.
Lemma Cequal_of : forall (a b : R) (l r : C), a = b -> l = RtoC a -> r = RtoC b -> l = r.
Proof. intros a b l r H L R; subst; reflexivity. Qed.
Lemma Capart_of : forall (a b : R) (l r : C), a <> b -> l = RtoC a -> r = RtoC b -> l <> r.
Proof. intros a b l r H L R E; apply H, RtoC_inj; congruence. Qed.
Lemma less_of : forall (l r : C) (a b : R), Cless l r -> l = RtoC a -> r = RtoC b -> a < b.
Proof. intros l r a b (_ & _ & H) L R; subst; exact H. Qed.
Lemma less_eq_of : forall (l r : C) (a b : R), Cless_eq l r -> l = RtoC a -> r = RtoC b -> a <= b.
Proof. intros l r a b (_ & _ & H) L R; subst; exact H. Qed.
Lemma equal_of : forall (l r : C) (a b : R), l = r -> l = RtoC a -> r = RtoC b -> a = b.
Proof. intros l r a b H L R; apply RtoC_inj; congruence. Qed.
Lemma apart_of : forall (l r : C) (a b : R), l <> r -> l = RtoC a -> r = RtoC b -> a <> b.
Proof. intros l r a b H L R E; apply H; congruence. Qed.
Lemma Cof_real : forall (x y : R) (z : C), x = y -> z = RtoC x -> z = RtoC y.
Proof. intros x y z E F; congruence. Qed.
Lemma Creal_zero : forall (z : C) (x : R), z = RtoC 0 -> z = RtoC x -> x = 0.
Proof. intros z x E F; apply RtoC_inj; congruence. Qed.

Ltac Ctold :=
  Cpushed;
  repeat match goal with E : ?v = RtoC (Re ?v) |- context [RtoC (Re ?v)] => rewrite <- E end;
  Csame_turned.
Ltac Cmixed :=
  match goal with
  | H : ?a < ?b |- Cless ?l ?r => solve [apply (Cless_of a b l r H); Ctold]
  | H : ?a <= ?b |- Cless_eq ?l ?r => solve [apply (Cless_eq_of a b l r H); Ctold]
  | H : @eq R ?a ?b |- @eq C ?l ?r => solve [apply (Cequal_of a b l r H); Ctold]
  | H : ~ @eq R ?a ?b |- ~ @eq C ?l ?r => solve [apply (Capart_of a b l r H); Ctold]
  | H : Cless ?l ?r |- ?a < ?b => solve [apply (less_of l r a b H); Ctold]
  | H : Cless_eq ?l ?r |- ?a <= ?b => solve [apply (less_eq_of l r a b H); Ctold]
  | H : @eq C ?l ?r |- @eq R ?a ?b => solve [apply (equal_of l r a b H); Ctold]
  | H : ~ @eq C ?l ?r |- ~ @eq R ?a ?b => solve [apply (apart_of l r a b H); Ctold]
  end.

Ltac Capart := first [Cnz | solve [repeat apply Cproduct_apart; first [Cnz | let E := fresh in intro E; congruence]]].
Ltac Crefuted :=
  match goal with
  | F : (?h - ?l)%C = RtoC 0, H : ?l <> ?h |- False =>
      apply H; symmetry; apply (Cby_zero _ _ _ F); reflexivity
  | F : (?h - ?l)%C = RtoC 0, H : Cless ?l ?h |- False =>
      destruct (Cpos_minus _ _ H) as [_ P]; rewrite F in P; simpl in P; lra
  end.
Ltac Cevaluated := known_values; Cpushed; Cring.
Ltac Cangle :=
  first
    [ reflexivity
    | match goal with
      | |- RtoC (?f ?x) = RtoC (?f ?y) => replace x with y by (field; nz); reflexivity
      | |- RtoC (cos ?x) = RtoC (cos ?y) =>
          replace x with (- y) by (field; nz); rewrite cos_neg; reflexivity
      | |- RtoC (sin ?x) = (- RtoC (sin ?y))%C =>
          replace x with (- y) by (field; nz); rewrite sin_neg; apply RtoC_opp
      end
    | Cevaluated ].

Ltac rationals :=
  repeat match goal with |- context [Q2R (?f ?a)] =>
    lazymatch f with QArith_base.Qmake _ => fail | _ =>
      let q := eval vm_compute in (f a) in replace (f a) with q by (vm_compute; reflexivity)
    end
  end;
  unfold Q2R; cbn [QArith_base.Qnum QArith_base.Qden].
Ltac Craises_to z w n :=
  replace (Craised z w) with (z ^ n)%C by (rewrite <- Craised_number; f_equal; simpl; Cpushed; ring).
Ltac Craises :=
  repeat match goal with |- context [Craised ?z ?w] =>
    first
      [ Craises_to z w 0%nat | Craises_to z w 1%nat | Craises_to z w 2%nat | Craises_to z w 3%nat
      | match goal with |- context [Craised z ?v] =>
          tryif constr_eq v w then fail
          else replace (Craised z w) with (Craised z v) by (f_equal; Cring)
        end ]
  end.
Ltac Csums := repeat rewrite Craised_plus by assumption; Craises.
Ltac Cpowers := Cpushed; Craises; Cexps; Csame_turned.

(* -- from one form of a proposition to another ---------------------------------------- *)

(* Functions of arguments that are equal, or known values. *)
Ltac argument := solve [fraction; nz_quick].
Ltac alike f :=
  repeat match goal with |- context [f ?a] =>
    first
      [ match goal with e := f ?b |- _ => replace (f a) with e by (unfold e; apply (f_equal f); argument) end
      | let e := fresh "e" in set (e := f a) ]
  end;
  repeat match goal with e := f _ |- _ => unfold e; clear e end.
Ltac valued :=
  repeat match goal with
  | |- context [cos ?a] =>
      first
        [ replace (cos a) with 0 by (replace a with (PI / 2) by argument; symmetry; apply cos_PI2)
        | replace (cos a) with 1 by (replace a with 0 by argument; symmetry; apply cos_0)
        | replace (cos a) with (-1) by (replace a with PI by argument; symmetry; apply cos_PI) ]
  | |- context [sin ?a] =>
      first
        [ replace (sin a) with 1 by (replace a with (PI / 2) by argument; symmetry; apply sin_PI2)
        | replace (sin a) with 0 by (replace a with 0 by argument; symmetry; apply sin_0)
        | replace (sin a) with 0 by (replace a with PI by argument; symmetry; apply sin_PI) ]
  | |- context [tan ?a] =>
      first
        [ replace (tan a) with 1 by (replace a with (PI / 4) by argument; symmetry; apply tan_PI4)
        | replace (tan a) with 0 by (replace a with 0 by argument; symmetry; apply tan_0) ]
  | |- context [exp ?a] => replace (exp a) with 1 by (replace a with 0 by argument; symmetry; apply exp_0)
  end.
Ltac turned_by f g :=
  repeat match goal with |- context [f ?a] =>
    match goal with |- context [f ?b] =>
      tryif constr_eq a b then fail
      else first
        [ replace (f a) with (- f b) by
            (replace a with (b - PI) by argument; rewrite ?sin_minus, ?cos_minus, sin_PI, cos_PI; ring)
        | replace (f a) with (- f b) by
            (replace a with (b + PI) by argument; rewrite ?sin_plus, ?cos_plus, sin_PI, cos_PI; ring)
        | g a b ]
    end
  end.
Ltac back_sin a b :=
  first
    [ replace (sin a) with (sin b) by
        (replace a with (PI - b) by argument; rewrite sin_minus, sin_PI, cos_PI; ring)
    | replace (sin a) with (- sin b) by (replace a with (- b) by argument; rewrite sin_neg; ring) ].
Ltac back_cos a b :=
  first
    [ replace (cos a) with (- cos b) by
        (replace a with (PI - b) by argument; rewrite cos_minus, sin_PI, cos_PI; ring)
    | replace (cos a) with (cos b) by (replace a with (- b) by argument; rewrite cos_neg; ring) ].
Ltac reflected := turned_by sin back_sin; turned_by cos back_cos.
Ltac unified :=
  alike cos; alike sin; alike exp; alike tan; alike ln; alike sqrt; alike Rabs; alike atan.
(* An exponential of the opposite argument. *)
Ltac inverted :=
  repeat match goal with |- context [exp ?a] => match goal with |- context [exp ?b] =>
    tryif constr_eq a b then fail else
    replace (exp b) with (/ exp a) by (rewrite <- exp_Ropp; f_equal; argument) end end.

Lemma Cover_one : forall x y z : C, x = z -> y = RtoC 1 -> (x / y)%C = z.
Proof. intros x y z E F; rewrite E, F; field; apply Cnot_zero; lra. Qed.
(* Part by part: what is divided by need not be known not to vanish. *)
Ltac Ccongruent :=
  first
    [ Cquick_field
    | solve [Cpushed; Cquick_field]
    | match goal with
      | |- (_ / _ = _ / _)%C => apply (f_equal2 Cdiv); Ccongruent
      | |- (_ * _ = _ * _)%C => apply (f_equal2 Cmult); Ccongruent
      | |- Cexp _ = Cexp _ => apply f_equal; Ccongruent
      | |- (_ / _ = _)%C => apply Cover_one; [Ccongruent | solve [Cpowers]]
      | |- (_ = _ / _)%C => symmetry; apply Cover_one; [Ccongruent | solve [Cpowers]]
      end
    | solve [Cpowers] ].

Ltac same :=
  lazymatch goal with
  | |- @eq R _ _ =>
      first
        [ quick_field
        | solve [rooted_field]
        | solve [known_values; quick_field]
        | solve [unified; quick_field]
        | solve [inverted; quick_field]
        | solve [unified; reflected; valued; known_values; quick_field]
        | solve [unfold tan, cot, sinh, cosh, tanh, Rminus; unified; known_values; quick_field] ]
  | |- @eq C _ _ => first [Cquick_field | solve [Cpushed; Cquick_field] | solve [Ccongruent]
      | solve [Cpushed; Csame_field] | solve [Ccompared] | solve [Cpowers]]
  | |- @eq (_ -> _) _ _ =>
      let x := fresh in apply functional_extensionality; intro x; cbv beta; same
  end.

(* A function where SymPy has written a term in place of a symbol: known values, other signs. *)
Ltac special :=
  match goal with |- ?f ?a = _ =>
    first
      [ replace a with (PI / 4) by argument
      | replace a with (PI / 3) by argument
      | replace a with (PI / 6) by argument
      | replace a with (PI - PI / 4) by argument
      | replace a with (PI - PI / 3) by argument
      | replace a with (PI - PI / 6) by argument ]
  end;
  unfold tan; rewrite ?sin_minus, ?cos_minus; special_values; first [quick_field | rooted_field].
(* At twice the angle of a slope, or at the angle itself. *)
Lemma positive_root : forall x r : R, 0 < x -> 0 <= r -> r * r * x = 1 -> 1 / sqrt x = r.
Proof.
  intros x r P Q E; assert (S := sqrt_lt_R0 x P); assert (T := sqrt_sqrt x (Rlt_le _ _ P)).
  apply Rmult_eq_reg_r with (sqrt x); [| lra]; transitivity 1; [field; lra |].
  symmetry; apply Rsqr_inj; unfold Rsqr; [apply Rmult_le_pos; lra | lra |].
  transitivity (r * r * (sqrt x * sqrt x)); [ring | rewrite T, E; ring].
Qed.
Ltac by_slope :=
  match goal with |- cos ?a = _ =>
    match a with context [atan ?t] =>
      replace a with (atan t) by field; rewrite cos_atan; unfold Rsqr;
      apply positive_root; [lra | interval | rooted_field]
    end
  end.
Ltac shifted a b :=
  first
    [ replace a with (PI / 2 - b) by argument
    | replace a with (PI / 2 + b) by argument
    | replace a with (b - PI / 2) by argument ];
  rewrite ?sin_minus, ?cos_minus, ?sin_plus, ?cos_plus, sin_PI2, cos_PI2; ring.
(* A cosine by that of twice its angle. *)
Lemma half_angle : forall a r, 0 <= cos a -> 0 <= r -> cos (2 * a) = 2 * (r * r) - 1 -> cos a = r.
Proof. intros a r A B E; rewrite cos_2a_cos in E; nra. Qed.
Lemma sqrt_6 : sqrt 6 = sqrt 2 * sqrt 3.
Proof. rewrite <- sqrt_mult by lra; f_equal; ring. Qed.
Ltac by_half := apply half_angle; [interval | interval | rewrite ?sqrt_6; special].
Ltac evaluated :=
  first
    [ reflexivity
    | solve [f_equal; argument]
    | match goal with
      | |- sin ?a = ?r => match r with context [cos ?b] => solve [shifted a b] end
      | |- cos ?a = ?r => match r with context [sin ?b] => solve [shifted a b] end
      end
    | solve [special]
    | solve [by_slope]
    | solve [by_half]
    | solve [rewrite sqrt_pow2; [ring | first [lra | interval]]]
    | same ].
Ltac valued_by way :=
  opened; transitivity way;
  [ first [reflexivity | f_equal; argument]
  | first
      [ reflexivity
      | solve [unfold Rdiv; known_values; special_values; first [reflexivity | ring]]
      | evaluated ] ].
Tactic Notation "rewritten" constr(old) constr(way) constr(new) :=
  try (replace old with new by (symmetry; first [valued_by way | opened; evaluated])).
Tactic Notation "rewritten" constr(old) constr(way) constr(new) "in" hyp(P) :=
  try (let E := fresh in
    assert (E : old = new) by (clear P; first [valued_by way | opened; evaluated]); rewrite E in P; clear E).
Ltac tidied :=
  rewrite ?Rmult_0_r, ?Rmult_0_l, ?Rmult_1_r, ?Rmult_1_l, ?Ropp_0, ?Rminus_0_r, ?Rplus_0_r, ?Rplus_0_l.
Tactic Notation "tidied" "in" hyp(P) :=
  rewrite ?Rmult_0_r, ?Rmult_0_l, ?Rmult_1_r, ?Rmult_1_l, ?Ropp_0, ?Rminus_0_r, ?Rplus_0_r, ?Rplus_0_l in P.

(* What is said of other things by the same predicate, or by the same connective. *)
Ltac head_of t := lazymatch t with ?f _ => head_of f | _ => t end.
Ltac said_alike P Q := let p := head_of P in let q := head_of Q in constr_eq p q.

(* A relation from one that is known, by a tactic for the equality of their sides. *)
Lemma less_alike : forall a b l r : R, a < b -> l = a -> r = b -> l < r.
Proof. intros; subst; assumption. Qed.
Lemma less_eq_alike : forall a b l r : R, a <= b -> l = a -> r = b -> l <= r.
Proof. intros; subst; assumption. Qed.
Lemma apart_alike : forall a b l r : R, a <> b -> l = a -> r = b -> l <> r.
Proof. intros; subst; assumption. Qed.
Lemma equal_alike : forall a b l r : R, a = b -> l = a -> r = b -> l = r.
Proof. intros; subst; reflexivity. Qed.
Ltac from_known tac :=
  match goal with
  | H : ?a < ?b |- ?l < ?r => solve [apply (less_alike a b l r H); tac tt]
  | H : ?a <= ?b |- ?l <= ?r => solve [apply (less_eq_alike a b l r H); tac tt]
  | H : ?a = ?b :> R |- ?l = ?r => solve [apply (equal_alike a b l r H); tac tt]
  | H : ?a = ?b |- ?l = ?r => solve [replace l with a by tac tt; replace r with b by tac tt; exact H]
  | H : ?a <> ?b :> R |- ?l <> ?r => solve [apply (apart_alike a b l r H); tac tt]
  | H : ?a <> ?b |- ?l <> ?r => solve [replace l with a by tac tt; replace r with b by tac tt; exact H]
  | H : ?P |- ?Q =>
      said_alike P Q;
      solve
        [let E := fresh in
         assert (E : P = Q) by (f_equal; tac tt);
         exact (eq_ind P (fun X => X) H Q E)]
  end.

Ltac assumed := first [assumption | from_known ltac:(fun _ => same)].

Ltac by_ring _ := first [reflexivity | polynomial].
Ltac by_quick _ := lazymatch goal with |- @eq R _ _ => quick_field end.
Ltac by_same _ := same.

Ltac unrelated Q :=
  lazymatch Q with
  | _ < _ => fail | _ <= _ => fail | _ = _ => fail | _ <> _ => fail
  | _ => idtac
  end.

Ltac atom :=
  opened;
  first
    [ assumption
    | lazymatch goal with
      | |- _ <> 0 => nz
      | |- ?Q =>
          first
            [ unrelated Q; from_known by_same
            | lra | from_known by_ring | by_quick tt | from_known by_quick | from_known by_same ]
      end
    | from_known by_same
    | Cmixed
    | lazymatch goal with |- _ <= _ => interval | |- _ <> RtoC 0 => Cnz end ].

(* One relation from just one other. *)
Ltac direct H :=
  let sides := first
    [ reflexivity | polynomial | quick_field | solve [unified; quick_field]
    | solve [unified; reflected; valued; known_values; quick_field] ] in
  match type of H with
  | ?a < ?b => match goal with |- ?l < ?r => apply (less_alike a b l r H); sides end
  | ?a <= ?b => match goal with |- ?l <= ?r => apply (less_eq_alike a b l r H); sides end
  | @eq R ?a ?b => match goal with |- ?l = ?r => apply (equal_alike a b l r H); sides end
  | ?a <> ?b :> R => match goal with |- ?l <> ?r => apply (apart_alike a b l r H); sides end
  end.

(* A relation beside what it divides by, from one that is beside other things. *)
Ltac beside H :=
  lazymatch type of H with
  | _ /\ _ => let A := fresh in let B := fresh in destruct H as [A B]; beside B
  | _ =>
      repeat
        (lazymatch goal with |- _ /\ _ => split end;
         [first [assumption | lazymatch goal with |- _ <> _ => nz_quick end] |]);
      direct H
  end.

(* Relations joined by "and", each from the one in its place. *)
Ltac paired H :=
  lazymatch type of H with
  | _ /\ _ =>
      lazymatch goal with
      | |- _ /\ _ =>
          let A := fresh in
          let B := fresh in
          destruct H as [A B]; split; [paired A | paired B]
      end
  | ?P => first [exact H | unrelated P; from_known by_same | clear - H; first [from_known by_ring | lra]]
  end.

Ltac conv H :=
  cbv beta in H |- *;
  first
    [ exact H
    | lazymatch goal with
      | |- _ /\ _ => solve [let H' := fresh in pose proof H as H'; beside H']
      | _ => direct H
      end
    | lazymatch goal with
      | |- forall _ : R, _ =>
          let x := fresh in
          intro x; let H' := fresh in pose proof (H x) as H'; conv H'
      | |- exists _ : R, _ =>
          let x := fresh in
          let H' := fresh in destruct H as [x H']; exists x; conv H'
      | |- ~ _ =>
          let A := fresh in intro A; apply H; conv A
      | |- _ <-> _ =>
          let A := fresh in
          split; intro A;
          [ let B := fresh in
            match type of H with ?P <-> _ => assert (B : P) by (conv A) end;
            apply (proj1 H) in B; conv B
          | let B := fresh in
            match type of H with _ <-> ?P => assert (B : P) by (conv A) end;
            apply (proj2 H) in B; conv B ]
      | |- _ -> _ =>
          let A := fresh in
          intro A;
          let B := fresh in
          match type of H with ?P -> _ => assert (B : P) by (conv A) end;
          let H' := fresh in pose proof (H B) as H'; conv H'
      | |- _ \/ _ =>
          let A := fresh in
          destruct H as [A | A]; [left; conv A | right; conv A]
      | |- _ /\ _ =>
          first
            [ solve [let H' := fresh in pose proof H as H'; paired H']
            | solve [let H' := fresh in pose proof H as H'; opened; repeat split;
                first [assumption | from_known by_ring]]
            | conv_parts H
            | solve [let H' := fresh in pose proof H as H'; opened; repeat split; atom] ]
      | |- _ => let H' := fresh in pose proof H as H'; opened; atom
      end ]
with conv_parts H :=
  let A := fresh in
  let B := fresh in
  destruct H as [A B];
  split; [first [conv A | clear B; atom] | conv B].

(* An exponential of twice the argument, which SymPy writes for a square. *)
Ltac doubled :=
  repeat match goal with |- context [exp ?a] => match goal with |- context [exp ?b] =>
    tryif constr_eq a b then fail else
    replace (exp b) with (exp a ^ 2)
      by (transitivity (exp (a + a)); [rewrite exp_plus; ring | f_equal; argument]) end end.
Ltac finish t :=
  first [exact t | let H := fresh in pose proof t as H; first [conv H | progress doubled; conv H]].
Ltac feed P t :=
  first
    [ specialize (P t)
    | let A := fresh in
      match type of P with ?T -> _ => assert (A : T) by (let H := fresh in pose proof t as H; conv H) end;
      specialize (P A); clear A ].

(* -- relations that cannot both hold ------------------------------------------------- *)

Ltac Ccontradiction :=
  match goal with
  | P : Cless ?l ?r, D : ?l = ?r |- _ => rewrite D in P; destruct P as (_ & _ & P); lra
  | P : Cless ?l ?r, D : ?r = ?l |- _ => rewrite D in P; destruct P as (_ & _ & P); lra
  | P : Cless ?l ?r, D : Cless_eq ?r ?l |- _ => unfold Cless, Cless_eq in *; lra
  | P : Cless ?l ?r, D : Cless ?r ?l |- _ => unfold Cless, Cless_eq in *; lra
  end.

Ltac contradict_by P D :=
  first [exact (D P) | exact (P D) | exfalso; generalize P D; intros; opened; first [contradiction | lra | congruence | Ccontradiction]].

(* -- whole numbers ------------------------------------------------------------------ *)

Lemma whole_plus : forall x y, whole x -> whole y -> whole (x + y).
Proof. intros x y [n E] [m F]; exists (n + m)%nat; rewrite plus_INR; congruence. Qed.
Lemma whole_mult : forall x y, whole x -> whole y -> whole (x * y).
Proof. intros x y [n E] [m F]; exists (n * m)%nat; rewrite mult_INR; congruence. Qed.
Lemma whole_pow : forall x n, whole x -> whole (x ^ n).
Proof.
  intros x n H; induction n as [| n IH]; simpl.
  - exists 1%nat; reflexivity.
  - apply whole_mult; assumption.
Qed.
Lemma whole_number : forall p : Z, (0 <= p)%Z -> whole (IZR p).
Proof. intros p H; exists (Z.to_nat p); rewrite INR_IZR_INZ, Z2Nat.id; [reflexivity | exact H]. Qed.
Ltac wholes :=
  opened;
  first
    [ assumption
    | solve [apply whole_number; lia]
    | solve [apply whole_plus; wholes]
    | solve [apply whole_mult; wholes]
    | solve [apply whole_pow; wholes]
    | match goal with H : whole ?x |- whole ?y => solve [replace y with x by same; exact H] end ].

Lemma not_between : forall (x : R) (p : Z), IZR p < x -> x < IZR (p + 1) -> ~ whole x.
Proof.
  intros x p L U [n E]; rewrite E, INR_IZR_INZ in L, U.
  apply lt_IZR in L; apply lt_IZR in U; lia.
Qed.
Lemma whole_start : forall x, whole x -> 0 <= x.
Proof. intros x [n E]; rewrite E; apply pos_INR. Qed.
Lemma not_negative : forall x, x < 0 -> ~ whole x.
Proof. intros x H W; apply whole_start in W; lra. Qed.
Ltac broken p := first [apply not_negative; lra | apply (not_between _ p); simpl; lra].

(* -- analysis ------------------------------------------------------------------------ *)

(* By the mean value theorem, which the standard library proves. *)
Lemma rises : forall (f g : R -> R) (a b : R),
  (forall x, a < x < b -> is_derive f x (g x)) -> (forall x, a < x < b -> 0 < g x) ->
  increasing f a b.
Proof.
  intros f g a b D P x y X Y B.
  destruct (MVT_cor2 f g x y Y) as [c [E C]].
  - intros c C; apply is_derive_Reals, D; lra.
  - assert (0 < g c) by (apply P; lra); nra.
Qed.

Ltac near Y :=
  unfold ball in Y; simpl in Y; unfold AbsRing_ball, abs, minus, plus, opp in Y; simpl in Y;
  apply Rabs_def2 in Y.

Lemma above_its_start : forall (f : R -> R) (a b l : R),
  increasing f a b -> tends f a l -> forall x, a < x -> x < b -> l < f x.
Proof.
  intros f a b l I T x X B.
  assert (M : l <= f ((a + x) / 2)).
  { apply (filterlim_le (F := at_right a) f (fun _ => f ((a + x) / 2)) l (f ((a + x) / 2))).
    - exists (mkposreal ((x - a) / 2) ltac:(lra)); intros y Y Z; near Y.
      apply Rlt_le, I; lra.
    - intros P Q; destruct (T P Q) as [e E]; exists e; intros y Y Z; apply E; [exact Y | lra].
    - apply filterlim_const. }
  apply Rle_lt_trans with (1 := M), I; lra.
Qed.

(* What is said of all points of an interval, at one. *)
Ltac inside x :=
  try match goal with H : forall y : R, ?a < y -> y < ?b -> _ |- _ =>
    specialize (H x ltac:(assumption) ltac:(assumption))
  end;
  opened.

Lemma below_its_end : forall (f : R -> R) (a b l : R),
  increasing f a b -> tends f b l -> forall x, a < x -> x < b -> f x < l.
Proof.
  intros f a b l I T x X B.
  assert (M : f ((x + b) / 2) <= l).
  { apply (filterlim_le (F := at_left b) (fun _ => f ((x + b) / 2)) f (f ((x + b) / 2)) l).
    - exists (mkposreal ((b - x) / 2) ltac:(lra)); intros y Y Z; near Y.
      apply Rlt_le, I; lra.
    - apply filterlim_const.
    - intros P Q; destruct (T P Q) as [e E]; exists e; intros y Y Z; apply E; [exact Y | lra]. }
  apply Rlt_le_trans with (2 := M), I; lra.
Qed.

Lemma grows : forall (f g : R -> R) (a b : R), a < b ->
  (forall x, a <= x <= b -> ex_derive f x) -> (forall x, a < x < b -> is_derive f x (g x)) ->
  (forall x, a < x < b -> 0 < g x) -> f a < f b.
Proof.
  intros f g a b L X D P.
  assert (I : increasing f a b) by (apply (rises f g); assumption).
  assert (T : forall x, a <= x <= b -> tends f x (f x)).
  { intros x H; apply (is_lim_continuity f x), continuity_pt_filterlim.
    apply (ex_derive_continuous f x), X, H. }
  apply Rlt_trans with (f ((a + b) / 2)).
  - apply (above_its_start f a b); [exact I | apply T; lra | lra | lra].
  - apply (below_its_end f a b); [exact I | apply T; lra | lra | lra].
Qed.

(* The intermediate value theorem, from limits at the ends of an open interval. *)
Lemma crosses_zero : forall (f : R -> R) (a b l m : R), a < b -> l < 0 -> 0 < m ->
  (forall x, a < x -> x < b -> ex_derive f x) -> tends f a l -> tends f b m ->
  exists x, a < x /\ x < b /\ f x = 0.
Proof.
  intros f a b l m I L M D A B; apply is_lim_spec in A; apply is_lim_spec in B.
  assert (N : 0 < - l) by lra.
  destruct (A (mkposreal _ N)) as [r H]; destruct (B (mkposreal _ M)) as [s G]; simpl in H, G.
  assert (P : exists p, 0 < p < r /\ p <= (b - a) / 3).
  { exists (Rmin (r / 2) ((b - a) / 3)); generalize (cond_pos r) (Rmin_l (r / 2) ((b - a) / 3))
      (Rmin_r (r / 2) ((b - a) / 3)) (Rmin_pos (r / 2) ((b - a) / 3)); lra. }
  assert (Q : exists q, 0 < q < s /\ q <= (b - a) / 3).
  { exists (Rmin (s / 2) ((b - a) / 3)); generalize (cond_pos s) (Rmin_l (s / 2) ((b - a) / 3))
      (Rmin_r (s / 2) ((b - a) / 3)) (Rmin_pos (s / 2) ((b - a) / 3)); lra. }
  destruct P as [p P]; destruct Q as [q Q].
  assert (U : Rabs (f (a + p) - l) < - l).
  { apply H; [change (Rabs (a + p - a) < r); rewrite Rabs_pos_eq; lra | lra]. }
  assert (V : Rabs (f (b - q) - m) < m).
  { apply G; [change (Rabs (b - q - b) < s); rewrite Rabs_left; lra | lra]. }
  apply Rabs_def2 in U; apply Rabs_def2 in V.
  destruct (Ranalysis5.IVT_interv f (a + p) (b - q)) as [x [X E]]; [ | lra | lra | lra | ].
  - intros x X; apply continuity_pt_filterlim; apply (ex_derive_continuous f x), D; lra.
  - exists x; split; [| split]; [lra | lra | exact E].
Qed.

(* That what was derived is the slope that is wanted. *)
Ltac derived :=
  first
    [ solve [unfold Rminus, Rdiv; polynomial]
    | quick_field
    | solve [unfold tan, cot, cosh, sinh, tanh, Rminus in *; quick_field]
    | same_field ].
Ltac slope :=
  unfold tan, cot, cosh, sinh, tanh; auto_derive; repeat split; auto;
  first [nz | solve [valued; known_values; nz]].

(* -- limits --------------------------------------------------------------------------- *)

Lemma tends_at : forall (f : R -> R) (a l : R), ex_derive f a -> f a = l -> tends f a l.
Proof.
  intros f a l D E; rewrite <- E; apply (is_lim_continuity f a), continuity_pt_filterlim.
  apply (ex_derive_continuous f a), D.
Qed.

(* The order of a zero: f/(x - a)^k tends to c, by the mean value theorem for f - c (x - a)^k. *)
Lemma order_none : forall (f : R -> R) (a l : R), ex_derive f a -> f a = l ->
  tends (fun x => f x / (x - a) ^ 0) a l.
Proof.
  intros f a l D E; apply (is_lim_ext f); [intro x; simpl; field | apply tends_at; assumption].
Qed.

Lemma order_up : forall (f g : R -> R) (a l c : R) (k : nat),
  (forall x, is_derive f x (g x)) -> f a = 0 -> INR (S k) * c = l ->
  tends (fun x => g x / (x - a) ^ k) a l -> tends (fun x => f x / (x - a) ^ S k) a c.
Proof.
  intros f g a l c k D Z L T; apply is_lim_spec in T; apply is_lim_spec; intros e.
  assert (P : 0 < e / 2) by (generalize (cond_pos e); lra).
  destruct (T (mkposreal _ P)) as [r H]; exists r; intros x B N; simpl in H.
  assert (B' : Rabs (x - a) < r) by exact B.
  pose (h := fun t => f t - c * (t - a) ^ S k).
  assert (Dh : forall t, is_derive h t (g t - l * (t - a) ^ k)).
  { intro t; replace (g t - l * (t - a) ^ k) with (g t - c * (INR (S k) * (t - a) ^ k))
      by (rewrite <- L; ring).
    apply (is_derive_minus f); [apply D |].
    replace (c * (INR (S k) * (t - a) ^ k)) with (c * (INR (S k) * 1 * (t - a) ^ k)) by ring.
    apply (is_derive_scal (fun t => (t - a) ^ S k)), (is_derive_pow (fun t => t - a) (S k) t 1).
    auto_derive; [exact I | ring]. }
  assert (Ha : h a = 0) by (unfold h; rewrite Z; simpl; ring).
  assert (M : exists t, Rabs (t - a) <= Rabs (x - a) /\ t <> a /\
    h x = (g t - l * (t - a) ^ k) * (x - a)).
  { destruct (Rtotal_order x a) as [W | [W | W]]; [| contradiction |].
    - destruct (MVT_cor2 h (fun t => g t - l * (t - a) ^ k) x a W) as [t [E C]]; [intros; apply is_derive_Reals, Dh |].
      exists t; rewrite !Rabs_left by lra; repeat split; [lra | lra |].
      rewrite Ha in E; replace (h x) with (- (0 - h x)) by ring; rewrite E; ring.
    - destruct (MVT_cor2 h (fun t => g t - l * (t - a) ^ k) a x W) as [t [E C]]; [intros; apply is_derive_Reals, Dh |].
      exists t; rewrite !Rabs_pos_eq by lra; repeat split; [lra | lra |].
      rewrite Ha in E; rewrite <- E; ring. }
  destruct M as [t [C [Nt E]]].
  assert (Q : Rabs (g t - l * (t - a) ^ k) <= e / 2 * Rabs (x - a) ^ k).
  { assert (G : Rabs (g t / (t - a) ^ k - l) < e / 2).
    { apply H; [| exact Nt]; apply Rle_lt_trans with (Rabs (x - a)); assumption. }
    replace (g t - l * (t - a) ^ k) with ((g t / (t - a) ^ k - l) * (t - a) ^ k)
      by (field; apply pow_nonzero; lra).
    rewrite Rabs_mult, <- RPow_abs.
    apply Rmult_le_compat; [apply Rabs_pos | apply pow_le, Rabs_pos | lra |].
    apply pow_incr; split; [apply Rabs_pos | exact C]. }
  replace (f x / (x - a) ^ S k - c) with (h x / (x - a) ^ S k)
    by (unfold h; field; apply pow_nonzero; lra).
  assert (A : 0 < Rabs (x - a)) by (apply Rabs_pos_lt; lra).
  rewrite E; unfold Rdiv; rewrite !Rabs_mult, Rabs_inv, <- RPow_abs.
  apply Rle_lt_trans with (e / 2); [| generalize (cond_pos e); lra].
  apply Rmult_le_reg_r with (Rabs (x - a) ^ S k); [apply pow_lt, A |].
  rewrite Rmult_assoc, Rinv_l by (apply pow_nonzero; lra); simpl.
  rewrite Rmult_1_r, <- Rmult_assoc, (Rmult_comm (e / 2)), Rmult_assoc.
  rewrite (Rmult_comm (Rabs (x - a))); apply Rmult_le_compat_r; [lra | exact Q].
Qed.

(* The quotient of what vanishes there to the same order. *)
Lemma tends_quotient : forall (f n d : R -> R) (a p q l : R) (k : nat),
  tends (fun x => n x / (x - a) ^ k) a p -> tends (fun x => d x / (x - a) ^ k) a q ->
  q <> 0 -> p / q = l -> (forall x, d x <> 0 -> f x = n x / d x) -> tends f a l.
Proof.
  intros f n d a p q l k Tn Td Q E F; rewrite <- E.
  apply (is_lim_ext_loc (fun x => n x / (x - a) ^ k / (d x / (x - a) ^ k))).
  - apply is_lim_spec in Td.
    assert (P : 0 < Rabs q) by (apply Rabs_pos_lt; exact Q).
    destruct (Td (mkposreal _ P)) as [r H]; exists r; intros x B X.
    assert (G := H x B X); simpl in G.
    assert (N : (x - a) ^ k <> 0) by (apply pow_nonzero; lra).
    assert (d x <> 0).
    { intro Y; rewrite Y in G; replace (0 / (x - a) ^ k - q) with (- q) in G.
      - rewrite Rabs_Ropp in G; lra.
      - unfold Rdiv; ring. }
    rewrite F by assumption; field; split; assumption.
  - apply (is_lim_div _ _ a p q); try assumption.
    + intro Y; apply Q; injection Y; intro W; exact W.
    + simpl; unfold is_Rbar_div, is_Rbar_mult; simpl; destruct (Req_EM_T q 0); [contradiction | reflexivity].
Qed.

(* What a term is at a point: 0 or a multiple of pi. *)
Ltac at_point :=
  cbv beta; unfold tan, cot, cosh, sinh, tanh;
  rewrite ?Rmult_0_r, ?Rmult_0_l, ?Ropp_0, ?Rplus_0_r, ?Rplus_0_l; known_values;
  first [same_field | lra | solve [unified; reflected; valued; known_values; same_field]].

Lemma by_induction : forall P : R -> Prop,
  P 0 -> (forall n, whole n /\ P n -> P (n + 1)) -> forall n, whole n -> P n.
Proof.
  intros P Z S n [k E]; subst n; induction k as [| k IH]; [exact Z |].
  rewrite S_INR; apply S; split; [exists k; reflexivity | exact IH].
Qed.

Lemma unique_limit : forall (f : R -> R) (a p q : R), tends f a p -> p <> q -> ~ tends f a q.
Proof.
  intros f a p q P N Q; apply N.
  apply is_lim_unique in P; apply is_lim_unique in Q; rewrite P in Q; injection Q; intro E; exact E.
Qed.

Ltac no_other_limit :=
  match goal with P : tends ?f ?a ?p, N : ?p <> ?q, Q : tends ?f ?a ?q |- False =>
    exact (unique_limit f a p q P N Q)
  end.

Lemma weak_at_the_lower_end : forall (f : R -> R) (a b l : R), a < b ->
  (forall x, a < x -> x < b -> 0 <= f x) -> tends f a l -> 0 <= l.
Proof.
  intros f a b l L P T.
  apply (filterlim_le (F := at_right a) (fun _ => 0) f 0 l).
  - exists (mkposreal (b - a) ltac:(lra)); intros y Y Z.
    unfold ball in Y; simpl in Y; unfold AbsRing_ball, abs, minus, plus, opp in Y; simpl in Y.
    apply Rabs_def2 in Y; apply P; lra.
  - apply filterlim_const.
  - intros S Q; destruct (T S Q) as [e E]; exists e; intros y Y Z; apply E; [exact Y | lra].
Qed.

Lemma weak_at_the_upper_end : forall (f : R -> R) (a b l : R), a < b ->
  (forall x, a < x -> x < b -> 0 <= f x) -> tends f b l -> 0 <= l.
Proof.
  intros f a b l L P T.
  apply (filterlim_le (F := at_left b) (fun _ => 0) f 0 l).
  - exists (mkposreal (b - a) ltac:(lra)); intros y Y Z.
    unfold ball in Y; simpl in Y; unfold AbsRing_ball, abs, minus, plus, opp in Y; simpl in Y.
    apply Rabs_def2 in Y; apply P; lra.
  - apply filterlim_const.
  - intros S Q; destruct (T S Q) as [e E]; exists e; intros y Y Z; apply E; [exact Y | lra].
Qed.

Ltac weakly := match goal with H : ?a < ?b |- 0 <= _ => lra | H : ?a <= ?b |- 0 <= _ => lra end.

(* -- school mathematics ------------------------------------------------------------- *)

Lemma one_le_cosh : forall x, 1 <= cosh x.
Proof.
  intro x; unfold cosh; rewrite exp_Ropp.
  assert (E := exp_pos x); set (e := exp x) in *; clearbody e.
  assert (0 <= (e - 1) ^ 2 / e) by (apply Rdiv_le_0_compat; [apply pow2_ge_0 | exact E]).
  replace ((e + / e) / 2) with (1 + (e - 1) ^ 2 / e / 2) by (field; lra); lra.
Qed.

Lemma with_rest : forall x y, 0 <= x -> 0 < y ->
  exists p, whole p /\ p * y <= x /\ x < (p + 1) * y.
Proof.
  intros x y X Y; assert (Q : 0 <= x / y) by (apply Rdiv_le_0_compat; assumption).
  destruct (archimed (x / y)) as [U L]; set (k := (up (x / y) - 1)%Z) in *.
  assert (K : IZR k = IZR (up (x / y)) - 1) by (unfold k; rewrite minus_IZR; reflexivity).
  assert (E : x / y * y = x) by (field; lra).
  exists (IZR k); split; [| split].
  - apply whole_number.
    assert (- 1 < IZR k) by lra; assert (Z : (-1 < k)%Z) by (apply lt_IZR; exact H); lia.
  - rewrite <- E; apply Rmult_le_compat_r; lra.
  - rewrite <- E; apply Rmult_lt_compat_r; lra.
Qed.
