(* The tactics that apply the theorems of the library to terms as chapters write them. *)
From Symhaptic Require Export Loop Energy Stored Answers.
Open Scope R_scope.

Ltac gained :=
  first [reflexivity | unfold Motion.energy; rationals; numeric].

(* -- polynomials as chapters write them ----------------------------------------------------- *)

(* Exponents that are whole numbers d = INR n become natural numbers. *)
Lemma Craised_natural : forall w n, w = RtoC (INR n) -> forall z, Craised z w = (z ^ n)%C.
Proof. intros w n E z; rewrite E; apply Craised_number. Qed.
Ltac copies k n := lazymatch k with 1%nat => n | S ?k => let m := copies k n in constr:((n + m)%nat) end.
Ltac natural w :=
  lazymatch w with
  | (?a + ?b)%C => let m := natural a in let n := natural b in constr:((m + n)%nat)
  | (RtoC (IZR (Zpos ?p)) * ?b)%C => let n := natural b in let k := eval compute in (Pos.to_nat p) in copies k n
  | RtoC (INR ?n) => n
  | RtoC (IZR Z0) => constr:(0%nat)
  | RtoC (IZR (Zpos ?p)) => eval compute in (Pos.to_nat p)
  | RtoC ?x => match goal with E : x = INR ?n |- _ => n end
  end.
Ltac counted :=
  rewrite ?plus_INR; simpl INR; repeat match goal with E : _ = INR ?n |- context [INR ?n] => rewrite <- E end;
  Cpushed; ring.
Ltac natural_powers :=
  repeat match goal with |- context [Craised ?z ?w] =>
    let n := natural w in rewrite (Craised_natural w n ltac:(counted))
  end.
Ltac exponentials := repeat match goal with X : exp ?x = _ |- context [exp ?x] => rewrite X end.
Ltac summed := exponentials; Cpushed; cbn [Cpower]; first [reflexivity | ring | undivided; field; Cnz].
Ltac as_powers :=
  let z := fresh "z" in
  intro z; cbv beta; natural_powers; cbn [powers]; repeat rewrite Cpower_plus; cbn [Cpower]; summed.
(* With each p of which it is known that its zeros lie inside. *)
Ltac with_inside tac := opened; match goal with S : stable ?p |- _ => tac p S end.
Ltac degrees := repeat (constructor; [simpl; lia |]); constructor.
(* At 0 and at 1. *)
Ltac at_zero := cbn [powers]; simpl; summed.
Ltac at_one := cbn [powers]; rewrite ?Cpower_one; summed.
(* exp(j k t) as a power. *)
Lemma Cconj_turned : forall t : R, Cconj (Cexp (Ci * t)%C) = Cexp (Ci * RtoC (- t))%C.
Proof. intro t; rewrite !turned, cos_neg, sin_neg; reflexivity. Qed.
Ltac a_turn := first [reflexivity | rewrite ?Cconj_turned, ?Cexp_power]; f_equal; rewrite ?plus_INR; simpl INR;
  repeat match goal with E : _ = INR ?n |- context [INR ?n] => rewrite <- E end; Cpushed; first [ring | field; Cnz].
(* exp at quarter, half and whole turns. *)
Lemma Cexp_half_turn : forall (x : R) z, z = (RtoC x + Ci * RtoC PI)%C -> Cexp z = RtoC (- exp x).
Proof.
  intros x z E; rewrite (Cexp_at z x PI), cos_PI, sin_PI by (rewrite E; apply injective_projections; simpl; ring).
  apply injective_projections; simpl; ring.
Qed.
Lemma Cexp_half_turn_back : forall (x : R) z, z = (RtoC x - Ci * RtoC PI)%C -> Cexp z = RtoC (- exp x).
Proof.
  intros x z E; rewrite (Cexp_at z x (- PI)), cos_neg, sin_neg, cos_PI, sin_PI by (rewrite E;
    apply injective_projections; simpl; ring).
  apply injective_projections; simpl; ring.
Qed.
Lemma Cexp_turn : forall (x : R) z, z = (RtoC x + 2 * Ci * RtoC PI)%C -> Cexp z = RtoC (exp x).
Proof.
  intros x z E; rewrite (Cexp_at z x (2 * PI)), cos_2PI, sin_2PI by (rewrite E; apply injective_projections; simpl;
    ring).
  apply injective_projections; simpl; ring.
Qed.
Lemma Cexp_turn_back : forall (x : R) z, z = (RtoC x - 2 * Ci * RtoC PI)%C -> Cexp z = RtoC (exp x).
Proof.
  intros x z E; rewrite (Cexp_at z x (- (2 * PI))), cos_neg, sin_neg, cos_2PI, sin_2PI by (rewrite E;
    apply injective_projections; simpl; ring).
  apply injective_projections; simpl; ring.
Qed.
Lemma Cexp_quarter_turn : forall (x : R) z, z = (RtoC x + Ci * RtoC (PI / 2))%C -> Cexp z = (RtoC (exp x) * Ci)%C.
Proof.
  intros x z E; rewrite (Cexp_at z x (PI / 2)), cos_PI2, sin_PI2 by exact E.
  apply injective_projections; simpl; ring.
Qed.
Lemma Cexp_quarter_turn_back : forall (x : R) z, z = (RtoC x - Ci * RtoC (PI / 2))%C ->
  Cexp z = (- (RtoC (exp x) * Ci))%C.
Proof.
  intros x z E; rewrite (Cexp_at z x (- (PI / 2))), cos_neg, sin_neg, cos_PI2, sin_PI2
    by (rewrite E; apply injective_projections; simpl; ring).
  apply injective_projections; simpl; ring.
Qed.
Ltac turned_to x :=
  first
    [ rewrite (Cexp_half_turn x) by (Cpushed; first [ring | field;
      Cnz]) | rewrite (Cexp_half_turn_back x) by (Cpushed; first [ring | field; Cnz])
    | rewrite (Cexp_turn x) by (Cpushed; first [ring | field; Cnz]) | rewrite (Cexp_turn_back x) by (Cpushed;
      first [ring | field; Cnz])
    | rewrite (Cexp_quarter_turn x) by (Cpushed; first [ring | field; Cnz])
    | rewrite (Cexp_quarter_turn_back x) by (Cpushed; first [ring | field; Cnz]) ];
  rewrite ?exp_0; Cpushed; first [reflexivity | ring].
Ltac turned_value := rewrite turned; known_values; Ccompared.
Ltac summed_powers :=
  rewrite ?Cpower_one; repeat rewrite Cpower_plus; cbn [Cpower];
  first [summed | solve [Cpushed; ring [Ci_square]]].
Ltac taken := opened; first [assumption | apply f_equal; assumption].
Ltac apart_by :=
  first [assumption |
    match goal with A : ?x <> ?y |- _ <> RtoC 0 =>
      let Q := fresh in intro Q; apply A, RtoC_inj; rewrite <- Q; summed
    end].
(* (-1)^n is its own inverse. *)
Lemma sign_square : forall n, ((- RtoC 1) ^ n * (- RtoC 1) ^ n = RtoC 1)%C.
Proof. intro n; rewrite <- Cpower_product; replace (- RtoC 1 * - RtoC 1)%C with (RtoC 1) by ring;
  apply Cpower_one. Qed.
Lemma sign_apart : forall n, ((- RtoC 1) ^ n)%C <> RtoC 0.
Proof. intros n E; assert (S := sign_square n); rewrite E in S; apply (f_equal fst) in S; simpl in S; lra. Qed.
Lemma Cpower_opposite : forall z n, ((- z) ^ n = (- RtoC 1) ^ n * z ^ n)%C.
Proof. intros z n; rewrite <- Cpower_product; f_equal; ring. Qed.
Ltac opposed :=
  let z := fresh "z" in
  intro z; cbv beta; natural_powers; repeat rewrite Cpower_plus; repeat rewrite (Cpower_opposite z); cbn [Cpower];
    Cpushed;
  repeat match goal with S : ((- RtoC 1) ^ ?n * (- RtoC 1) ^ ?n)%C = RtoC 1 |- _ =>
    let e := fresh "s" in generalize dependent ((- RtoC 1) ^ n)%C; intros e S
  end;
  match goal with
  | S : (?s * ?s)%C = RtoC 1, T : (?t * ?t)%C = RtoC 1 |- _ => ring [S T]
  | S : (?s * ?s)%C = RtoC 1 |- _ => ring [S]
  | _ => ring
  end.
Ltac swung := cbn [powers swing]; rewrite ?plus_INR; simpl INR;
  repeat match goal with E : _ = INR ?n |- context [INR ?n] => rewrite <- E end.
Ltac conjugates :=
  repeat first [rewrite conj_plus | rewrite conj_mult | rewrite conj_power | rewrite Cconj_real]; rewrite ?conj_conj.
Ltac minor_of H :=
  refine (eq_ind _ (Rlt 0) H _ _); cbn [minor weight]; rewrite ?plus_INR; simpl INR;
  repeat match goal with E : _ = INR ?n |- context [INR ?n] => rewrite <- E end; first [ring | field; nz].
Ltac counted_real :=
  rewrite ?plus_INR; simpl INR; repeat match goal with E : _ = INR ?n |- context [INR ?n] => rewrite <- E end; ring.

(* -- what is known of devices and loops, as chapters say it ----------------------------------- *)

Lemma right_of_axis : forall x y : R, 0 < x ->
  exists p q : R, 0 < p /\ -PI/2 < q /\ q < PI/2 /\ x = p * cos q /\ y = p * sin q.
Proof.
  intros x y X; assert (P : 0 < 1 + Rsqr (y/x)) by (generalize (Rle_0_sqr (y/x)); lra).
  assert (S := sqrt_lt_R0 _ P); destruct (atan_bound (y/x)).
  exists (x * sqrt (1 + Rsqr (y/x))), (atan (y/x)); rewrite cos_atan, sin_atan.
  repeat split; [apply Rmult_lt_0_compat; lra | lra | lra | field; lra | field; split; lra].
Qed.
Lemma linear_inside : forall x, -1 < x < 1 -> stable (fun z => - x + z)%C.
Proof.
  intros x X z E; replace z with (RtoC x) by (replace z with ((- x + z) + x)%C by ring; rewrite E; ring).
  rewrite Cmod_R; apply Rabs_def1; lra.
Qed.
Ltac of_device_by F :=
  intros; opened;
  match goal with V : device _ _ _ _ _ _ |- _ => let K := fresh in assert (K := F _ _ _ _ _ _ V); finish K end.
Ltac wholes_counted := opened; repeat match goal with W : whole ?x |- _ => destruct W as [? ?] end.
Ltac characteristic_powers :=
  let z := fresh "z" in intro z; unfold characteristic; natural_powers; repeat rewrite Cpower_plus; cbn [Cpower];
    summed.
Ltac counted_delay :=
  first
    [ rewrite !INR_IZR_INZ; simpl; lra
    | repeat match goal with E : _ = INR ?n |- context [INR ?n] => rewrite <- E end; simpl; first [ring | field;
      nz] ].
Ltac counted_back := match goal with E : _ = INR ?n |- context [INR ?n] => rewrite <- E; assumption end.
Ltac counted_turn x := match goal with E : _ = INR ?n |- context [INR ?n] => rewrite <- E end; turned_to x.
Ltac same_kernel := cbv beta; first [same_field | by_squares].
Lemma beside_known : forall P G Q : Prop, G -> (P <-> Q) -> (P <-> G /\ Q).
Proof. tauto. Qed.
Ltac peeled := repeat (apply beside_known; [opened; first [assumption | nz | Cnz | rooted] |]).
(* A loop behind a whole delay, and behind a fraction of whole numbers p and q + 1. *)
Ltac whole_loop :=
  intros; wholes_counted;
  match goal with V : device ?g ?h _ _ _ _, E : ?d = INR ?n |- ((stable_loop ?a ?b _ _ _) <-> _) /\ _ =>
    destruct (loop_of_device a b g h n _ _ _ _ V) as [L M]; rewrite <- E in L, M;
    split; [apply (iff_trans L) | apply (iff_trans M)]; apply stable_alike; characteristic_powers
  end.
Ltac loop_of_fraction :=
  intros; wholes_counted;
  match goal with V : device _ _ _ _ _ _, E : ?p = INR ?m, F : ?q = INR ?n, D : ?d * (?q + 1) = ?p |- _ =>
    apply (iff_trans (loop_in_w _ _ _ _ d _ _ _ _ m (S n) V ltac:(lia) ltac:(rewrite S_INR, <- E, <- F; exact D)));
    apply stable_alike; characteristic_powers
  end.
Ltac loop_read :=
  intros; opened; let m := fresh "m" in let n := fresh "n" in let T := fresh in let P := fresh in let D := fresh in
  match goal with V : device _ _ _ _ _ _, S : stable_substituted _ _ _ _ _ |- _ =>
    destruct (loop_as_read _ _ _ _ _ _ _ _ _ V S) as (m & n & P & D & T)
  end;
  destruct n as [| n]; [lia |]; exists (INR m), (INR n);
  split; [exists m; reflexivity |]; split; [exists n; reflexivity |]; split; [rewrite <- S_INR; exact D |];
  revert T; apply stable_alike; characteristic_powers.
Ltac late_loop :=
  intros; opened; let n := fresh "n" in let E := fresh in
  match goal with V : late_device ?g ?h ?u _ _ _ _ _, W : whole ?l |- stable_loop ?a ?b _ _ _ <-> _ =>
    destruct W as [n E]; replace (u + l) with (INR n + u) by (rewrite <- E; ring);
    apply (iff_trans (loop_of_late_device a b g h n u _ _ _ _ _ V)); apply stable_alike; as_powers
  end.
Ltac principal_half :=
  intros; opened; let n := fresh "n" in let E := fresh in
  let H := fresh in let x := fresh "x" in let y := fresh "y" in let X := fresh in let Y := fresh in let Z := fresh in
  match goal with V : device ?g ?h ?n1 ?n0 ?a ?e, W : whole ?l |- stable_principal ?al ?be _ _ _ <-> _ =>
    destruct W as [n E]; replace (l + 1/2) with (INR n + 1/2) by (rewrite <- E; reflexivity);
    apply (iff_trans (half_a_period al be g h n n1 n0 a e V)); clear V; split; intros H x y;
      [intros [X Y] | intros X Y]
  end;
  [ split; [intro Z; apply (f_equal fst) in Z; simpl in Z; lra | intro Z; apply (H x y X Y); rewrite <- Z]
  | intro Z; apply (proj2 (H x y (conj X Y))); rewrite <- Z ];
  unfold characteristic; natural_powers; repeat rewrite Cpower_plus; cbn [Cpower]; summed.
Ltac pole_held :=
  intros; opened; match goal with P : pole _ _ _ _ _ _ |- _ => apply (held_by_a_pole _ _ _ _ _ _ P); assumption end.
Ltac swung_as := let t := fresh "t" in let A := fresh in let B := fresh in split; intros [t [A B]]; exists t; split;
  lra.

(* -- what is known of passive filters, walls and steady states, as chapters say it ------------------ *)

Lemma Craised_inverse : forall z w n, z <> RtoC 0 -> w = (- RtoC (INR n))%C -> Craised z w = (/ z ^ n)%C.
Proof.
  intros z w n Z E; assert (P := Cpower_apart z n Z); assert (Q := Craised_plus z (RtoC (INR n)) w Z).
  rewrite E, Craised_number in Q; replace (RtoC (INR n) + - RtoC (INR n))%C with (RtoC (INR 0)) in Q by (simpl; ring).
  rewrite Craised_number in Q; simpl in Q; rewrite E; replace (Craised z (- RtoC (INR n))%C) with
    (z ^ n * Craised z (- RtoC (INR n)) / z ^ n)%C by (field; exact P); rewrite <- Q; field; exact P.
Qed.
(* How often an exponent below 0 is -1. *)
Ltac negative w :=
  lazymatch w with
  | (- ?a - ?b)%C => let m := natural a in let n := natural b in constr:((m + n)%nat)
  | (- ?a)%C => natural a
  | RtoC (IZR (Zneg ?p)) => eval compute in (Pos.to_nat p)
  end.
Ltac inverse_powers Z :=
  repeat match goal with |- context [Craised ?z ?w] =>
    let n := negative w in rewrite (Craised_inverse z w n Z ltac:(counted))
  end.
Ltac as_taps :=
  let z := fresh "z" in let Z := fresh "Z" in
  intros z Z; cbv beta; natural_powers; inverse_powers Z; cbn [taps fold_right fst snd];
  repeat rewrite Cpower_plus; cbn [Cpower Init.Nat.add];
  repeat match goal with |- context [Cpower z ?n] =>
    let P := fresh in assert (P := Cpower_apart z n Z);
    let q := fresh "q" in generalize dependent (Cpower z n); intros q P
  end;
  Cpushed; cbn [Cpower]; first [ring | undivided; field; repeat split; Cnz].
Lemma toeplitz_as : forall H c l (s : R) (m : R -> R), (forall z, z <> RtoC 0 -> H z = taps l z) -> static l = s ->
  (forall t, cos t < 1 -> margin c l t = m t) -> (passive H c <-> 0 <= s /\ forall t, 0 < t < PI -> 0 <= m t).
Proof.
  intros H c l s m E S M; apply (iff_trans (toeplitz H c l E)); rewrite S; split; intros [A B]; (split;
    [exact A |]); intros t T;
    assert (N := cos_below_one t ltac:(lra)); [rewrite <- M by lra | rewrite M by lra]; exact (B t T).
Qed.
Ltac a_cosine := first
  [ rewrite ?Rmult_0_l, ?cos_0; reflexivity | f_equal; rewrite ?S_INR; counted_real | rewrite <- cos_neg; f_equal;
    rewrite ?S_INR; counted_real ].
Ltac circled T := assert (cos T < 1) by (apply cos_below_one; lra).
Ltac as_passive F :=
  let P := fresh "P" in let S := fresh "S" in let t := fresh "t" in let A := fresh "A" in let B := fresh "B" in
  let Q := fresh "Q" in let M := fresh "M" in
  split; intro P; [opened | destruct P as [S P]];
  [ match goal with G : passive _ _ |- _ => apply F in G; destruct G as [S M] end; split; [solve [finish S] |];
    intros t [A B]; circled t; specialize (M t (conj A B)); cbv beta in M; opened; repeat split;
      first [assumption | nz]
  | opened; repeat (split; [solve [nz] |]); apply F; split; [opened; solve [finish S] |];
    intros t [A B]; cbv beta; assert (Q := P t (conj A B)); opened; assumption ].
Ltac wall_of_filter := intros; opened; wholes_counted;
  match goal with E : ?d = INR ?m |- passive_wall ?K ?B ?b ?T ?d <-> _ =>
    rewrite E; peeled; apply whole_wall; [assumption |]; let Z := fresh in intros ? Z; rewrite Craised_number;
      reflexivity
  end.
Ltac late_wall_of_filter := intros; opened; wholes_counted;
  match goal with E : ?l = INR ?m |- passive_wall ?K ?B ?b ?T (?u + ?l) <-> _ =>
    rewrite E; replace (u + INR m) with (INR m + u) by ring; peeled; apply late_wall;
      [assumption | assumption | split; assumption | |];
    [ let z := fresh "z" in let Z := fresh in intros z Z; rewrite Craised_number, (Craised_inverse z _ (S m) Z)
        by (rewrite S_INR, RtoC_plus; ring); assert (P := Cpower_apart z m Z); cbn [Cpower]; undivided;
      field; repeat split; first [assumption | Cnz]
    | field; split; nz ]
  end.
Lemma Cless_real : forall p q (x y : R), p = RtoC x -> q = RtoC y -> x < y -> Cless p q.
Proof. intros p q x y P Q L; rewrite P, Q; repeat split; exact L. Qed.
Lemma one_turn : forall t : R, 0 < t <= PI -> Cmod (Cexp (Ci * t)%C) = 1 /\ Cexp (Ci * t)%C <> RtoC 1.
Proof.
  intros t T; split; [apply Cmod_turned |]; rewrite turned; intro E; apply (f_equal fst) in E; simpl in E.
  assert (cos t < 1) by (apply cos_below_one; generalize PI_RGT_0; lra); lra.
Qed.
Ltac components := rewrite ?Cmod_square; apply injective_projections; simpl; field.
(* For all points of the circle but 1: exponentials of j t are powers of exp(j t) or of its conjugate. *)
Ltac around_circle :=
  match goal with T : ?t <= PI |- Cless _ _ =>
    let Z := fresh in destruct (one_turn t ltac:(split; assumption)) as [Z ?];
    replace (Cexp (- Ci * t)%C) with (Cconj (Cexp (Ci * t)%C)) by (rewrite Cconj_turned; f_equal; Cpushed; ring);
    replace (Cexp (2 * Ci * t)%C) with (Cexp (Ci * t)%C * Cexp (Ci * t)%C)%C by (rewrite <- Cexp_plus; f_equal; ring);
    replace (Cexp (-2 * Ci * t)%C) with (Cconj (Cexp (Ci * t)%C) * Cconj (Cexp (Ci * t)%C))%C
      by (rewrite Cconj_turned, <- Cexp_plus; f_equal; Cpushed; ring);
    generalize dependent (Cexp (Ci * t)%C); clear T
  end.
Ltac whole_steady := intros; opened; around_circle; let z := fresh "z" in intros z;
  match goal with V : device _ _ _ _ _ _ |- _ => intros Z One;
    refine (Cless_real _ _ _ _ _ _ (held_steady_state _ _ _ _ _ _ z V _ _ Z One)); try assumption; clear Z One
  end; destruct z; components.
Ltac late_steady := intros; opened; around_circle; let z := fresh "z" in intros z;
  match goal with L : late_device _ _ _ _ _ _ _ _, V : device _ _ _ _ _ _ |- _ => intros Z One;
    refine (Cless_real _ _ _ _ _ _ (late_held_steady_state _ _ _ _ _ _ _ _ _ _ z L V _ _ _ Z One));
      try assumption; try (split; assumption); clear Z One
  end; destruct z; components.
Ltac later_answers := intros; opened; wholes_counted;
  match goal with E : ?p = INR ?n |- answers _ ?z ?X (RtoC ?T) <-> _ =>
    rewrite E, Craised_number; apply (answer_later _ _ z X T n); let s := fresh "s" in intro s; cbv beta; unfold Cdiv;
    rewrite Cmult_assoc, <- Cexp_plus; do 2 f_equal; Cpushed; ring
  end.
Ltac other_units := intros; opened; peeled;
  match goal with U : 0 < ?u, F : ?f <> 0 |- _ =>
    assert (RtoC f <> RtoC 0) by (apply Cnot_zero; exact F); assert (RtoC u <> RtoC 0) by (apply Cnot_zero; lra);
    apply (answer_units _ _ _ _ _ _ u f); [exact U | exact F | | ring | rewrite RtoC_div by lra; reflexivity];
    let s := fresh "s" in intro s; cbv beta; rewrite <- Cdiv_share by exact F; f_equal;
    [f_equal; field; assumption | cbn [Cpower]; field; split; assumption]
  end.
Ltac amplified_answers := intros;
  match goal with F : ?f <> 0 |- _ =>
    apply (answer_units _ _ _ _ _ _ 1 f); [lra | exact F | | ring | f_equal; field];
    let s := fresh "s" in intro s; cbv beta; replace (s / 1)%C with s by (field; Cnz); unfold Cdiv; ring
  end.
Ltac answer_unique := opened; match goal with A : answers ?P ?z ?X ?T, B : answers ?P ?z ?Y ?T |- _ =>
    let E := fresh in assert (E := one_answer P z X Y T A B); repeat split; assumption
  end.
Ltac shown_transfer :=
  let s := fresh "s" in intros s _; cbv beta; f_equal;
  [ first [ symmetry; apply Cexp_nought; simpl INR; Cpushed; ring | f_equal; simpl INR; Cpushed;
    first [ring | field; Cnz] ]
  | Cpushed; cbn [Cpower]; first [ring | field; Cnz] ].
Lemma conditions_alike : forall (z d x n : C) (z' d' x' n' : R), z = RtoC z' -> d = RtoC d' ->
  (x * d = RtoC x')%C -> n = RtoC n' ->
  ((z <> RtoC 0 /\ d <> RtoC 0 /\ (x * d = n)%C) <-> (z' <> 0 /\ d' <> 0 /\ x' = n')).
Proof.
  intros z d x n z' d' x' n' Z D X N; rewrite X, Z, D, N.
  assert (A : forall r, RtoC r <> RtoC 0 <-> r <> 0).
  { intro r; split; intros H E; apply H; [rewrite E; reflexivity | exact (RtoC_inj _ _ E)]. }
  rewrite !A; split; intros (P & Q & E); (split; [exact P |]); (split; [exact Q |]);
    [exact (RtoC_inj _ _ E) | rewrite E; reflexivity].
Qed.
Ltac Cpulled := cbn [Cpower];
  repeat first [ rewrite <- RtoC_plus | rewrite <- RtoC_minus | rewrite <- RtoC_mult | rewrite <- RtoC_opp
    | rewrite <- RtoC_div by nz | rewrite <- RtoC_inv by nz ];
  f_equal; exponentials; same_field.
