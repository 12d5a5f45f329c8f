(* Polynomials with all zeros in the left half plane, and how the circle becomes one. *)
From Symhaptic Require Export Circle.
From Coq Require Import Classical.
Open Scope R_scope.

(* -- the half plane ------------------------------------------------------------------------- *)

(* The even powers of a polynomial, of which the others are those of the tail. *)
Fixpoint evens (l : list R) : list R := match l with x :: _ :: l => x :: 0 :: evens l | _ => l end.
Fixpoint lowered (k : R) (l m : list R) : list R :=
  match l, m with x :: l, y :: m => (x - k * y) :: lowered k l m | _, _ => l end.
(* Routh's reduction: (p - k q)/s with p(0) = k q(0), where s q are the odd powers of p. *)
Definition routh (l : list R) : list R :=
  match l with x :: m => tl (lowered (x / hd 0 m) l (evens m)) | nil => nil end.

Lemma pair_induction : forall P : list R -> Prop, P nil -> (forall x, P (x :: nil)) ->
  (forall x y l, P l -> P (x :: y :: l)) -> forall l, P l.
Proof.
  intros P N O T; assert (B : forall l, P l /\ forall x, P (x :: l)).
  { induction l as [| y l [A B]]; split; auto. }
  intro l; apply B.
Qed.
Lemma length_evens : forall l, length (evens l) = length l.
Proof. apply pair_induction; simpl; auto. Qed.
Lemma length_lowered : forall k l m, length (lowered k l m) = length l.
Proof. intros k l; induction l as [| x l IH]; intros [| y m]; simpl; auto. Qed.
Lemma lowered_end : forall k b c e, (length e <= length b)%nat ->
  lowered k (b ++ c :: nil) e = lowered k b e ++ c :: nil.
Proof. intros k b c; induction b as [| x b IH]; intros [| y e] L; simpl in *; try lia; [| | rewrite IH by lia]; reflexivity. Qed.
Lemma poly_lowered : forall k l m z, (length m <= length l)%nat ->
  poly (reals (lowered k l m)) z = (poly (reals l) z - RtoC k * poly (reals m) z)%C.
Proof.
  intros k l; induction l as [| x l IH]; intros [| y m] z L; simpl in *; try lia; try ring.
  fold (reals l) (reals m) (reals (lowered k l m)); rewrite IH by lia; rewrite RtoC_minus, RtoC_mult; ring.
Qed.
Lemma poly_evens : forall y l z, poly (reals (evens (y :: l))) z = (y + z ^ 2 * poly (reals (evens (tl l))) z)%C.
Proof. intros y [| w l] z; simpl; ring. Qed.
Lemma poly_parts : forall l z,
  poly (reals l) z = (poly (reals (evens l)) z + z * poly (reals (evens (tl l))) z)%C.
Proof.
  intros l z; revert l; apply pair_induction; [simpl; ring | intro x; simpl; ring |].
  intros x y l IH; change (tl (x :: y :: l)) with (y :: l); rewrite !poly_evens; change (tl (y :: l)) with l.
  change (poly (reals (x :: y :: l)) z) with (x + z * (y + z * poly (reals l) z))%C; rewrite IH; simpl; ring.
Qed.
Lemma evens_imaginary : forall l (w : R), exists u : R, poly (reals (evens l)) (Ci * w)%C = RtoC u.
Proof.
  intros l w; revert l; apply pair_induction; [exists 0; reflexivity | intro x; exists x; simpl; ring |].
  intros x y l [u U]; exists (x - w ^ 2 * u).
  change (poly (reals (evens (x :: y :: l))) (Ci * w)%C) with
    (x + (Ci * w) * (RtoC 0 + (Ci * w) * poly (reals (evens l)) (Ci * w)%C))%C.
  rewrite U; apply injective_projections; simpl; ring.
Qed.

Definition right_half (z : C) : Prop := 0 <= Re z.
Lemma hurwitz_free : forall p, hurwitz p <-> free right_half p.
Proof.
  intro p; split; intros S z Z.
  - intro E; generalize (S z E); unfold right_half in Z; lra.
  - apply Rnot_le_lt; intro L; exact (S z L Z).
Qed.
Lemma half_closed : closed right_half.
Proof.
  intros z Z; unfold right_half in *; exists (- Re z); split; [lra |]; intros w W V.
  generalize (Re_near w z) (Rle_abs (Re w - Re z)); lra.
Qed.
Lemma half_interior : forall z, 0 < Re z -> interior right_half z.
Proof.
  intros z Z; exists (Re z); split; [exact Z |]; intros w W; unfold right_half.
  generalize (Re_near w z) (Rle_abs (- (Re w - Re z))); rewrite Rabs_Ropp; lra.
Qed.

Lemma routh_end : forall x y l b c, x :: y :: l = b ++ c :: nil ->
  exists h, length h = length l /\ routh (x :: y :: l) = h ++ c :: nil.
Proof.
  intros x y l b c B; assert (Lb : length b = S (length l)).
  { apply (f_equal (@length R)) in B; rewrite app_length in B; simpl in B; lia. }
  assert (Rp : routh (x :: y :: l) = tl (lowered (x / y) (x :: y :: l) (evens (y :: l)))) by reflexivity.
  rewrite Rp, B, lowered_end by (rewrite length_evens; simpl; lia).
  assert (L := length_lowered (x / y) b (evens (y :: l))).
  destruct (lowered (x / y) b (evens (y :: l))) as [| u h]; [simpl in *; lia |].
  exists h; simpl in *; split; [lia | reflexivity].
Qed.

Section Routh.
Variables (x y c : R) (l : list R).
Let m := y :: l.
Let p := x :: m.
Hypotheses (X : 0 < x) (Y : y <> 0) (Lead : c <> 0) (Ends : exists b, p = b ++ c :: nil).
Let k := x / y.
(* From p to s times the reduced polynomial. *)
Let q (t : R) (z : C) : C := (poly (reals p) z - RtoC (t * k) * poly (reals (evens m)) z)%C.
Lemma at_one : forall z, q 1 z = (z * poly (reals (routh p)) z)%C.
Proof.
  intro z; unfold q; replace (1 * k) with k by ring.
  assert (L : (length (evens m) <= length p)%nat) by (rewrite length_evens; simpl; lia).
  rewrite <- poly_lowered by exact L; unfold routh, p, m; simpl hd; fold k.
  destruct l as [| v n]; simpl; replace (x - k * y) with 0 by (unfold k; field; exact Y); ring.
Qed.
(* On the imaginary axis all of these vanish together, but for 0. *)
Lemma on_axis : forall t (w : R), w <> 0 -> q t (Ci * w)%C = RtoC 0 -> forall s, q s (Ci * w)%C = RtoC 0.
Proof.
  intros t w W E s; unfold q in *; rewrite poly_parts in *; change (tl p) with m in *.
  destruct (evens_imaginary p w) as [u U], (evens_imaginary m w) as [v V]; rewrite U, V in *.
  assert (Z : u - t * k * v = 0 /\ w * v = 0) by (split; [apply (f_equal fst) in E | apply (f_equal snd) in E]; simpl in E; lra).
  destruct Z as [Z O]; assert (v = 0) by (apply Rmult_integral in O; lra); subst v.
  assert (u = 0) by lra; subst u; apply injective_projections; simpl; ring.
Qed.
Lemma at_zero : forall t, q t 0 = RtoC (x * (1 - t)).
Proof.
  intro t; unfold q, p, m; rewrite poly_evens; simpl; unfold k; apply injective_projections; simpl; [field; exact Y | ring].
Qed.
Let g (d : R) : list C := scale (RtoC (- (d * k))) (reals (evens m)).
Lemma from_q : forall t d, exists a, length a = length m /\
  forall s z, along a (g d) (RtoC c) s z = q (t + s * d) z.
Proof.
  intros t d; destruct Ends as [b B]; exists (add (reals b) (g t)).
  assert (L : length b = length m).
  { apply (f_equal (@length R)) in B; rewrite app_length in B; change (length p) with (S (length m)) in B; simpl (length (c :: nil)) in B; lia. }
  assert (Lg : forall u, length (g u) = length m).
  { intro u; unfold g, reals; rewrite length_scale, map_length, length_evens; reflexivity. }
  assert (Lb : length (reals b) = length m) by (unfold reals; rewrite map_length; exact L).
  split; [rewrite length_add, Lg, Lb; lia |]; intros s z; unfold along, q.
  assert (R : poly (reals p) z = poly (reals b ++ RtoC c :: nil) z).
  { rewrite B; unfold reals; rewrite map_app; reflexivity. }
  rewrite R, !poly_app, length_add, Lg, Lb, poly_add; replace (max (length m) (length m)) with (length m) by lia.
  unfold g; rewrite !poly_scale, !RtoC_opp, !RtoC_mult, !RtoC_plus, !RtoC_mult; ring.
Qed.
Lemma lead_apart : RtoC c <> RtoC 0.
Proof. apply Cnot_zero, Lead. Qed.
Lemma length_g : forall d, length (g d) = length m.
Proof. intro d; unfold g, reals; rewrite length_scale, map_length, length_evens; reflexivity. Qed.
(* No zero crosses the imaginary axis while t stays below 1. *)
Lemma no_crossing : forall t d, t < 1 -> t + d < 1 -> free right_half (q t) -> free right_half (q (t + d)).
Proof.
  intros t d T D F; destruct (from_q t d) as (a & L & A).
  assert (G := path right_half half_closed a (g d) (RtoC c) lead_apart ltac:(rewrite length_g, L; lia)).
  intros z Z E; apply G with (z := z); [| | exact Z | rewrite A; replace (t + 1 * d) with (t + d) by ring; exact E].
  - intros w W V; rewrite A in V; replace (t + 0 * d) with t in V by ring; exact (F w W V).
  - intros s w S W V; rewrite A in V; destruct W as [W | W]; [apply half_interior; exact W | exfalso].
    assert (I : w = (Ci * RtoC (Im w))%C) by (destruct w; simpl in *; apply injective_projections; simpl; lra).
    destruct (Req_dec (Im w) 0) as [Z0 | N].
    + rewrite I, Z0 in V; replace (Ci * 0)%C with (RtoC 0) in V by ring; rewrite at_zero in V.
      apply RtoC_inj in V; apply Rmult_integral in V; destruct V as [V | V]; [lra |].
      assert (0 <= (1 - s) * (1 - t)) by (apply Rmult_le_pos; lra).
      assert (0 < s * (1 - (t + d))) by (apply Rmult_lt_0_compat; lra); lra.
    + rewrite I in V; apply (F w); [unfold right_half; lra |]; rewrite I; exact (on_axis _ _ N V t).
Qed.
Lemma down : hurwitz (poly (reals p)) -> hurwitz (poly (reals (routh p))).
Proof.
  intros H; assert (F0 : free right_half (q 0)).
  { intros z Z E; apply (proj1 (hurwitz_free _) H z Z); rewrite <- E; unfold q; replace (0 * k) with 0 by ring; ring. }
  apply hurwitz_free; intros z Z E.
  assert (Q : q 1 z = RtoC 0) by (rewrite at_one, E; ring).
  destruct Z as [Z | Z].
  - destruct (half_interior z Z) as (e & Pe & I), (from_q 0 1) as (a & L & A).
    destruct (followed a (g 1) (RtoC c) lead_apart ltac:(rewrite length_g, L; lia) 1 z e) as (d & D & Fl);
      [rewrite A; replace (0 + 1 * 1) with 1 by ring; exact Q | exact Pe |].
    set (t := Rmax 0 (1 - d / 2)).
    assert (T : 0 <= t < 1 /\ 1 - d / 2 <= t) by (unfold t; split; [split; [apply Rmax_l | apply Rmax_lub_lt; lra] | apply Rmax_r]).
    destruct (Fl t) as (w & W & V); [apply Rabs_def1; lra |]; rewrite A in V.
    apply (no_crossing 0 t ltac:(lra) ltac:(lra) F0 w (I w W)); rewrite <- V; f_equal; ring.
  - assert (I : z = (Ci * RtoC (Im z))%C) by (destruct z; simpl in *; apply injective_projections; simpl; lra).
    destruct (Req_dec (Im z) 0) as [Z0 | N].
    + assert (V : poly (reals (routh p)) 0 = RtoC y).
      { unfold routh, p, m; destruct l; simpl; [ring | replace (y - x / y * 0) with y by ring; ring]. }
      rewrite I, Z0 in E; replace (Ci * 0)%C with (RtoC 0) in E by ring; rewrite V in E.
      exact (Y (RtoC_inj _ _ E)).
    + rewrite I in Q; apply (F0 z); [unfold right_half; lra |]; rewrite I; exact (on_axis _ _ N Q 0).
Qed.
Lemma up : 0 < y -> hurwitz (poly (reals (routh p))) -> hurwitz (poly (reals p)).
Proof.
  intros Yp H; assert (K : 0 < k) by (apply Rdiv_lt_0_compat; assumption).
  assert (Er : exists h, length h = length l /\ reals (routh p) = h ++ RtoC c :: nil).
  { destruct Ends as [b B], (routh_end x y l b c B) as (h & L & E); exists (reals h).
    unfold p, m; rewrite E; unfold reals; rewrite map_length, map_app; split; [exact L | reflexivity]. }
  destruct Er as (h & Lh & Eh).
  assert (Y0 : RtoC y <> RtoC 0) by (apply Cnot_zero; lra).
  destruct (departs right_half 0 h (scale (RtoC k) (reals (evens m))) (RtoC c) half_closed lead_apart) as (n & Pn & D).
  { rewrite length_scale; unfold reals; rewrite map_length, length_evens, Lh; simpl; lia. }
  { rewrite <- Eh; apply hurwitz_free; exact H. }
  rewrite <- Eh in D.
  assert (V : poly (reals (routh p)) 0 = RtoC y).
  { unfold routh, p, m; destruct l; simpl; [ring | replace (y - x / y * 0) with y by ring; ring]. }
  assert (U : poly (reals (evens m)) 0 = RtoC y) by (unfold m; rewrite poly_evens; simpl; ring).
  rewrite V, poly_scale, U in D.
  assert (Next : forall t, 0 < t <= 1 -> t * n < k * y -> free right_half (q (1 - t))).
  { intros t T Tn z Z E; specialize (D t z T Z).
    rewrite poly_scale in D; replace ((z - 0) * poly (reals (routh p)) z)%C with (q 1 z) in D by (rewrite at_one; ring).
    replace (q 1 z + t * (RtoC k * poly (reals (evens m)) z))%C with (q (1 - t) z) in D.
    2: { unfold q; rewrite !RtoC_mult, RtoC_minus; ring. }
    specialize (D E); replace ((z - 0) * y + t * (RtoC k * RtoC y))%C with ((z + RtoC (t * k)) * RtoC y)%C in D by (rewrite RtoC_mult; ring).
    rewrite Cmod_mult, Cmod_R, Rabs_pos_eq in D by lra.
    assert (W : Re z + t * k <= Cmod (z + RtoC (t * k))%C).
    { eapply Rle_trans; [apply Rle_abs |]; replace (Re z + t * k) with (fst (z + RtoC (t * k))%C) by (destruct z; simpl; ring).
      eapply Rle_trans; [apply Rmax_l | apply Rmax_Cmod]. }
    unfold right_half in Z; assert ((Re z + t * k) * y <= n * t ^ 2) by (eapply Rle_trans; [apply Rmult_le_compat_r; [lra | exact W] | exact D]).
    assert (t * (t * n) < t * (k * y)) by (apply Rmult_lt_compat_l; lra); simpl in *; nra. }
  set (t := Rmin 1 (k * y / (2 * n))).
  assert (Ky : 0 < k * y) by (apply Rmult_lt_0_compat; assumption).
  assert (T : 0 < t <= 1) by (unfold t; split; [apply Rmin_glb_lt; [lra | apply Rdiv_lt_0_compat; lra] | apply Rmin_l]).
  assert (Tn : t * n < k * y).
  { assert (t * n <= k * y / (2 * n) * n) by (apply Rmult_le_compat_r; [lra | apply Rmin_r]).
    replace (k * y / (2 * n) * n) with (k * y / 2) in * by (field; lra); lra. }
  assert (F := no_crossing (1 - t) (- (1 - t)) ltac:(lra) ltac:(lra) (Next t T Tn)).
  apply hurwitz_free; intros z Z E; apply (F z Z); rewrite <- E; unfold q.
  replace (1 - t + - (1 - t)) with 0 by ring; replace (0 * k) with 0 by ring; ring.
Qed.
End Routh.
(* To first order a polynomial is p(0) (1 - sum of z/a) with its zeros a, and 0 < Re -1/a. *)
Lemma second_positive : forall x y l c b, 0 < x -> c <> 0 -> x :: y :: l = b ++ c :: nil ->
  hurwitz (poly (reals (x :: y :: l))) -> 0 < y.
Proof.
  intros x y l c b X N B H.
  assert (E : reals (x :: y :: l) = reals b ++ RtoC c :: nil) by (rewrite B; unfold reals; apply map_app).
  assert (Nc := Cnot_zero c N); destruct (factors (length b) (reals (x :: y :: l))) as (rs & L & F).
  { rewrite E, app_length; unfold reals; rewrite map_length; simpl; lia. }
  { rewrite E, last_last; exact Nc. }
  rewrite E, last_last in F; rewrite E in H.
  assert (W : Forall (fun r => Re r < 0) rs).
  { apply Forall_forall; intros r I; apply H; rewrite F, product_zero by exact I; ring. }
  assert (Co := coefficients (reals (x :: y :: l)) (scale (RtoC c) (expanded rs))).
  specialize (Co ltac:(intro z; rewrite poly_scale, poly_expanded, E; apply F)).
  assert (C0 := Co 0%nat); assert (C1 := Co 1%nat); rewrite nth_scale in C0, C1; simpl in C0, C1.
  set (e := expanded rs) in *.
  assert (Q : nth 0 e (RtoC 0) <> RtoC 0 /\ (rs <> nil -> 0 < Re (nth 1 e (RtoC 0) / nth 0 e (RtoC 0))%C)).
  { subst e; clear - W; assert (G : nth 0 (expanded rs) (RtoC 0) <> RtoC 0 /\
      0 <= Re (nth 1 (expanded rs) (RtoC 0) / nth 0 (expanded rs) (RtoC 0))%C /\
      (rs <> nil -> 0 < Re (nth 1 (expanded rs) (RtoC 0) / nth 0 (expanded rs) (RtoC 0))%C)); [| tauto].
    induction W as [| r rs R W (N & P & _)]; simpl expanded.
    - simpl; repeat split; [intro K; apply (f_equal fst) in K; simpl in K; lra | | contradiction].
      simpl; lra.
    - rewrite !nth_add, !nth_scale; set (u := nth 0 (expanded rs) (RtoC 0)) in *; set (v := nth 1 (expanded rs) (RtoC 0)) in *.
      assert (Nr : r <> RtoC 0) by (intro K; rewrite K in R; simpl in R; lra).
      simpl nth; fold u; replace (- r * u + 0)%C with (- r * u)%C by ring.
      assert (Nu : (- r * u)%C <> RtoC 0).
      { apply Cmult_neq_0; [intro K; apply Nr; replace r with (- - r)%C by ring; rewrite K; ring | exact N]. }
      assert (G : 0 < Re ((- r * v + u) / (- r * u))%C).
      { replace ((- r * v + u) / (- r * u))%C with (v / u + - / r)%C by (field; split; assumption).
        assert (0 < Re (- / r)%C).
        { destruct r as [s t]; simpl in *; unfold Rdiv; rewrite Ropp_mult_distr_l; apply Rmult_lt_0_compat; [lra |].
          apply Rinv_0_lt_compat; nra. }
        change (Re (v / u + - / r)%C) with (Re (v / u)%C + Re (- / r)%C); lra. }
      repeat split; [exact Nu | lra | intros _; exact G]. }
  destruct Q as [Q P]; specialize (P ltac:(intro K; subst rs; destruct b as [| u [| v b]]; simpl in *; try discriminate)).
  assert (D : (nth 1 e (RtoC 0) / nth 0 e (RtoC 0))%C = RtoC (y / x)).
  { rewrite RtoC_div by lra; rewrite C0, C1; field; split; assumption. }
  rewrite D in P; simpl in P; replace y with (y / x * x) by (field; lra); apply Rmult_lt_0_compat; assumption.
Qed.
(* Routh: all zeros of a real polynomial with p(0) > 0 lie in the left half plane if and only if its
   next coefficient is positive and those of the reduced polynomial do; Gantmacher, XV, 3. *)
Theorem routh_reduces : forall x y l, 0 < x -> last (x :: y :: l) 0 <> 0 ->
  (hurwitz (poly (reals (x :: y :: l))) <-> 0 < y /\ hurwitz (poly (reals (routh (x :: y :: l))))).
Proof.
  intros x y l X N; set (c := last (x :: y :: l) 0) in *.
  assert (B : x :: y :: l = removelast (x :: y :: l) ++ c :: nil) by (apply app_removelast_last; discriminate).
  split; [intro H; assert (Y := second_positive x y l c _ X N B H); split; [exact Y |] | intros [Y H]].
  - apply (down x y c l X ltac:(lra) N (ex_intro _ _ B) H).
  - apply (up x y c l X ltac:(lra) N (ex_intro _ _ B) Y H).
Qed.

(* -- real polynomials ------------------------------------------------------------------------ *)

Fixpoint rpoly (l : list R) (t : R) : R := match l with nil => 0 | x :: l => x + t * rpoly l t end.
Lemma poly_real : forall l t, poly (reals l) (RtoC t) = RtoC (rpoly l t).
Proof.
  intros l t; induction l as [| x l IH]; [reflexivity |].
  change (poly (reals (x :: l)) (RtoC t)) with (x + t * poly (reals l) (RtoC t))%C; rewrite IH; simpl.
  rewrite RtoC_plus, RtoC_mult; reflexivity.
Qed.
Lemma rpoly_continuous : forall l, continuity (rpoly l).
Proof.
  induction l as [| x l IH]; [apply continuity_const; intros u v; reflexivity |].
  apply (continuity_plus (fun _ => x) (fun t => t * rpoly l t)).
  - apply continuity_const; intros u v; reflexivity.
  - apply (continuity_mult id (rpoly l)); [apply derivable_continuous, derivable_id | exact IH].
Qed.
Lemma rpoly_far : forall l c, 0 < c -> exists r e, 0 < e /\ forall t, r <= t -> e <= rpoly (l ++ c :: nil) t.
Proof.
  intros l c P; induction l as [| x l (r & e & E & B)]; simpl.
  - exists 0, c; split; [exact P | intros; lra].
  - exists (Rmax r (Rmax 0 ((e + Rabs x) / e))), e; split; [exact E |]; intros t T.
    assert (A := Rmax_l r (Rmax 0 ((e + Rabs x) / e))); assert (D := Rmax_r r (Rmax 0 ((e + Rabs x) / e))).
    assert (F := Rmax_l 0 ((e + Rabs x) / e)); assert (G := Rmax_r 0 ((e + Rabs x) / e)).
    assert (H : e + Rabs x <= t * e).
    { replace (e + Rabs x) with ((e + Rabs x) / e * e) by (field; lra); apply Rmult_le_compat_r; lra. }
    assert (t * e <= t * rpoly (l ++ c :: nil) t) by (apply Rmult_le_compat_l; [lra | apply B; lra]).
    generalize (Rle_abs (- x)); rewrite Rabs_Ropp; lra.
Qed.
(* A real polynomial that is positive far to the right is positive up to its last zero. *)
Lemma positive_from : forall l c t, 0 < c ->
  (forall s, t <= s -> poly (reals (l ++ c :: nil)) (RtoC s) <> RtoC 0) -> 0 < rpoly (l ++ c :: nil) t.
Proof.
  intros l c t P N; apply Rnot_le_lt; intro L; destruct (rpoly_far l c P) as (r & e & E & B).
  set (u := Rmax t r + 1).
  assert (U : t < u /\ r <= u) by (unfold u; generalize (Rmax_l t r) (Rmax_r t r); lra).
  destruct (IVT_cor (rpoly (l ++ c :: nil)) t u (rpoly_continuous _) ltac:(lra)) as (s & S & Z).
  { specialize (B u ltac:(lra)); assert (0 <= - rpoly (l ++ c :: nil) t * rpoly (l ++ c :: nil) u) by (apply Rmult_le_pos; lra); lra. }
  apply (N s ltac:(lra)); rewrite poly_real, Z; reflexivity.
Qed.

(* -- Hurwitz' criterion ----------------------------------------------------------------------- *)

Lemma hurwitz_alike : forall p q, (forall s, p s = q s) -> (hurwitz p <-> hurwitz q).
Proof. intros p q E; split; intros H s Z; apply H; [rewrite E | rewrite <- E]; exact Z. Qed.
Lemma hurwitz_0 : forall x, x <> 0 -> hurwitz (poly (reals (x :: nil))).
Proof.
  intros x N s E; exfalso; apply N; simpl in E; apply (f_equal fst) in E; simpl in E; lra.
Qed.
Lemma hurwitz_1 : forall x y, 0 < x -> y <> 0 -> (hurwitz (poly (reals (x :: y :: nil))) <-> 0 < y).
Proof.
  intros x y X Y; rewrite routh_reduces by assumption; split; [tauto | intro P; split; [exact P |]].
  exact (hurwitz_0 y Y).
Qed.
Lemma hurwitz_2 : forall x y z, 0 < x -> z <> 0 -> (hurwitz (poly (reals (x :: y :: z :: nil))) <-> 0 < y /\ 0 < z).
Proof.
  intros x y z X Z; rewrite routh_reduces by assumption.
  replace (routh (x :: y :: z :: nil)) with (y :: z :: nil) by (unfold routh; simpl; do 2 f_equal; ring).
  split; intros [Y H]; (split; [exact Y |]); apply (hurwitz_1 y z Y Z); exact H.
Qed.
Lemma hurwitz_3 : forall x y z w, 0 < x -> w <> 0 -> (hurwitz (poly (reals (x :: y :: z :: w :: nil))) <->
  0 < y /\ 0 < y * z - x * w /\ 0 < w).
Proof.
  intros x y z w X W; rewrite routh_reduces by assumption.
  replace (routh (x :: y :: z :: w :: nil)) with (y :: (z - x / y * w) :: w :: nil) by
    (unfold routh; simpl; repeat f_equal; ring).
  split; intros [Y H]; (split; [exact Y |]).
  - apply hurwitz_2 in H; [| assumption ..]; destruct H as [H G]; split; [| exact G].
    replace (y * z - x * w) with (y * (z - x / y * w)) by (field; lra); apply Rmult_lt_0_compat; assumption.
  - destruct H as [H G]; apply hurwitz_2; try assumption; split; [| exact G].
    replace (z - x / y * w) with ((y * z - x * w) / y) by (field; lra); apply Rdiv_lt_0_compat; assumption.
Qed.
Lemma hurwitz_4 : forall x y z w v, 0 < x -> v <> 0 -> (hurwitz (poly (reals (x :: y :: z :: w :: v :: nil))) <->
  0 < y /\ 0 < y * z - x * w /\ 0 < (y * z - x * w) * w - y * y * v /\ 0 < v).
Proof.
  intros x y z w v X V; rewrite routh_reduces by assumption.
  replace (routh (x :: y :: z :: w :: v :: nil)) with (y :: (z - x / y * w) :: w :: v :: nil) by
    (unfold routh; simpl; repeat f_equal; ring).
  split; intros [Y H]; (split; [exact Y |]); assert (E : z - x / y * w = (y * z - x * w) / y) by (field; lra).
  - apply hurwitz_3 in H; [| assumption ..]; destruct H as (H & G & K); rewrite E in *.
    assert (P : 0 < y * z - x * w).
    { replace (y * z - x * w) with ((y * z - x * w) / y * y) by (field; lra); apply Rmult_lt_0_compat; assumption. }
    repeat split; [exact P | | exact K].
    replace ((y * z - x * w) * w - y * y * v) with (y * ((y * z - x * w) / y * w - y * v)) by (field; lra).
    apply Rmult_lt_0_compat; assumption.
  - destruct H as (H & G & K); apply hurwitz_3; try assumption; rewrite E; repeat split; [| | exact K].
    + apply Rdiv_lt_0_compat; assumption.
    + replace ((y * z - x * w) / y * w - y * v) with (((y * z - x * w) * w - y * y * v) / y) by (field; lra).
      apply Rdiv_lt_0_compat; assumption.
Qed.
(* Hurwitz for the degree 3: the leading minors of his matrix; Gantmacher, XV, Theorem 4. *)
Theorem hurwitz_cubic : forall p (a b c d : R), 0 < a -> (forall s, p s = a * s^3 + b * s^2 + c * s + d)%C ->
  (hurwitz p <-> 0 < b /\ 0 < b * c - a * d /\ 0 < d * (b * c - a * d)).
Proof.
  intros p a b c d A P; rewrite (hurwitz_alike p (poly (reals (d :: c :: b :: a :: nil)))) by (intro s; rewrite P; simpl; ring).
  split.
  - intro H; assert (D : 0 < d).
    { replace d with (rpoly ((d :: c :: b :: nil) ++ a :: nil) 0) by (simpl; ring); apply positive_from; [exact A |].
      intros s S E; generalize (H _ E); simpl; lra. }
    apply hurwitz_3 in H; [| lra ..]; destruct H as (Y & M & W).
    assert (0 < b * c - a * d) by lra.
    assert (0 < b) by nra; repeat split; try assumption; apply Rmult_lt_0_compat; assumption.
  - intros (B & M & K); assert (0 < d) by nra; apply hurwitz_3; [lra .. |].
    assert (0 < c) by nra; repeat split; lra.
Qed.

(* -- from the circle to the half plane ---------------------------------------------------------- *)

(* z = (1 + s)/(1 - s) takes the left half plane to the inside of the circle. *)
Lemma one_minus : forall s, s <> RtoC 1 -> (1 - s)%C <> RtoC 0.
Proof. intros s N E; apply N; replace s with (1 - (1 - s))%C by ring; rewrite E; ring. Qed.
Lemma half_plane : forall s, s <> RtoC 1 -> (0 <= Re s <-> 1 <= Cmod ((1 + s) / (1 - s))%C).
Proof.
  intros s N; assert (M := one_minus s N); assert (P := proj1 (Cmod_gt_0 _) M); rewrite Cmod_div by exact M.
  assert (E : Cmod (1 + s)%C ^ 2 - Cmod (1 - s)%C ^ 2 = 4 * Re s) by (rewrite !Cmod_square; destruct s; simpl; ring).
  assert (A := Cmod_ge_0 (1 + s)%C); set (x := Cmod (1 + s)%C) in *; set (y := Cmod (1 - s)%C) in *; split; intro H.
  - apply Rmult_le_reg_r with y; [exact P |]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; simpl in E; nra.
  - assert (y <= x); [| simpl in E; nra].
    replace x with (x / y * y) by (field; lra); rewrite <- (Rmult_1_l y) at 1; apply Rmult_le_compat_r; lra.
Qed.
Lemma bilinear : forall p q n, (forall s, s <> RtoC 1 -> q s = ((1 - s) ^ n * p ((1 + s) / (1 - s)))%C) ->
  q 1 <> RtoC 0 -> p (- RtoC 1)%C <> RtoC 0 -> (stable p <-> hurwitz q).
Proof.
  intros p q n Q Q1 P1; split; [intro S; apply hurwitz_free | intro H; apply stable_free]; intros s Z E.
  - destruct (Ceq_dec s 1) as [F | N]; [rewrite F in E; exact (Q1 E) |].
    rewrite Q in E by exact N; apply (proj1 (half_plane s N)) in Z.
    destruct (product_apart_C _ _ E) as [F | F]; [| generalize (S _ F); lra].
    assert (K := f_equal Cmod F); rewrite Cmod_power, Cmod_0 in K.
    apply pow_nonzero in K; [exact K |]; apply Rgt_not_eq, Cmod_gt_0, one_minus, N.
  - assert (N : (s + 1)%C <> RtoC 0).
    { intro F; apply P1; rewrite <- E; f_equal; replace s with (s + 1 - 1)%C by ring; rewrite F; ring. }
    set (w := ((s - 1) / (s + 1))%C).
    assert (Two : RtoC 2 <> RtoC 0) by (apply Cnot_zero; lra).
    assert (W : (1 - w)%C = (2 / (s + 1))%C) by (unfold w; field; exact N).
    assert (V : ((1 + w) / (1 - w))%C = s).
    { rewrite W; unfold w; field; exact N. }
    assert (Nw : w <> RtoC 1).
    { intro F; rewrite F in W; replace (1 - 1)%C with (RtoC 0) in W by ring; symmetry in W; apply Cdiv_zero in W; [exact (Two W) | exact N]. }
    assert (K := H w); rewrite Q, V, E in K by exact Nw; specialize (K ltac:(ring)).
    unfold outside in Z; rewrite <- V in Z; apply (proj2 (half_plane w Nw)) in Z; lra.
Qed.
(* p and its sign at 1 and at -1, where all zeros lie inside. *)
Lemma stable_at_1 : forall l, stable (poly (reals (l ++ 1 :: nil))) -> 0 < rpoly (l ++ 1 :: nil) 1.
Proof.
  intros l S; apply positive_from; [lra |]; intros t T E; generalize (S _ E).
  rewrite Cmod_R, Rabs_pos_eq; lra.
Qed.
Lemma stable_not : forall p, stable p -> p (- RtoC 1)%C <> RtoC 0.
Proof. intros p S E; generalize (S _ E); rewrite Cmod_opp, Cmod_1; lra. Qed.

(* -- Jury's criterion --------------------------------------------------------------------------- *)

(* For the degrees 3 and 4: p(1), -p(-1) or p(-1), a coefficient of (1 - s)^n p((1 + s)/(1 - s)), and
   inner determinants; Anderson and Jury, IEEE Trans. Automatic Control 18(2), 1973. *)
Theorem jury_3 : forall p (a b c : R), (forall z, p z = z^3 + a * z^2 + b * z + c)%C ->
  (stable p <-> 0 < 1 + a + b + c /\ 0 < 3 + a - b - 3 * c /\ 0 < 1 - a + b - c /\ 0 < 1 - b + a * c - c^2).
Proof.
  intros p a b c P.
  set (l := (1 + a + b + c) :: (3 + a - b - 3 * c) :: (3 - a - b + 3 * c) :: (1 - a + b - c) :: nil).
  assert (Q : forall s, s <> RtoC 1 -> poly (reals l) s = ((1 - s) ^ 3 * p ((1 + s) / (1 - s)))%C).
  { intros s N; apply one_minus in N; rewrite P; unfold l; simpl.
    repeat rewrite ?RtoC_plus, ?RtoC_minus, ?RtoC_mult; field; exact N. }
  assert (Q1 : poly (reals l) 1 = RtoC 8).
  { unfold l; simpl; repeat rewrite ?RtoC_plus, ?RtoC_minus, ?RtoC_mult; ring. }
  assert (M : p (- RtoC 1)%C = RtoC (- (1 - a + b - c))).
  { rewrite P; simpl; repeat rewrite ?RtoC_opp, ?RtoC_plus, ?RtoC_minus, ?RtoC_mult; ring. }
  assert (B : p (- RtoC 1)%C <> RtoC 0 -> (stable p <-> hurwitz (poly (reals l)))).
  { apply bilinear with (n := 3%nat); [exact Q |]; rewrite Q1; apply Cnot_zero; lra. }
  assert (D : (3 + a - b - 3 * c) * (3 - a - b + 3 * c) - (1 + a + b + c) * (1 - a + b - c) = 8 * (1 - b + a * c - c ^ 2)) by ring.
  split.
  - intro S; assert (N := stable_not p S); assert (P1 : 0 < 1 + a + b + c).
    { replace (1 + a + b + c) with (rpoly ((c :: b :: a :: nil) ++ 1 :: nil) 1) by (simpl; ring); apply stable_at_1.
      apply (stable_alike _ _ P) in S; revert S; apply stable_alike; intro z; simpl; ring. }
    apply B in S; [| exact N]; apply hurwitz_3 in S; [lra | exact P1 |].
    intro E; apply N; rewrite M, E; f_equal; ring.
  - intros (P1 & C1 & P2 & I); apply B; [rewrite M; apply Cnot_zero; lra |]; apply hurwitz_3; [exact P1 | lra |].
    repeat split; lra.
Qed.
Theorem jury_4 : forall p (a b c d : R), (forall z, p z = z^4 + a * z^3 + b * z^2 + c * z + d)%C ->
  (stable p <-> 0 < 1 + a + b + c + d /\ 0 < 6 - 2 * b + 6 * d /\ 0 < 1 - a + b - c + d /\ 0 < 1 - d /\
    0 < (1 - d) * (1 - d^2) - b * (1 - d)^2 + (a - c) * (c - a * d)).
Proof.
  intros p a b c d P.
  set (l := (1 + a + b + c + d) :: (4 + 2 * a - 2 * c - 4 * d) :: (6 - 2 * b + 6 * d) :: (4 - 2 * a + 2 * c - 4 * d)
    :: (1 - a + b - c + d) :: nil).
  assert (Q : forall s, s <> RtoC 1 -> poly (reals l) s = ((1 - s) ^ 4 * p ((1 + s) / (1 - s)))%C).
  { intros s N; apply one_minus in N; rewrite P; unfold l; simpl.
    repeat rewrite ?RtoC_plus, ?RtoC_minus, ?RtoC_mult; field; exact N. }
  assert (Q1 : poly (reals l) 1 = RtoC 16).
  { unfold l; simpl; repeat rewrite ?RtoC_plus, ?RtoC_minus, ?RtoC_mult; ring. }
  assert (M : p (- RtoC 1)%C = RtoC (1 - a + b - c + d)).
  { rewrite P; simpl; repeat rewrite ?RtoC_opp, ?RtoC_plus, ?RtoC_minus, ?RtoC_mult; ring. }
  assert (B : p (- RtoC 1)%C <> RtoC 0 -> (stable p <-> hurwitz (poly (reals l)))).
  { apply bilinear with (n := 4%nat); [exact Q |]; rewrite Q1; apply Cnot_zero; lra. }
  set (u := 4 + 2 * a - 2 * c - 4 * d) in *; set (v := 6 - 2 * b + 6 * d) in *; set (w := 4 - 2 * a + 2 * c - 4 * d) in *.
  set (x := 1 + a + b + c + d) in *; set (y := 1 - a + b - c + d) in *.
  assert (E1 : u + w = 8 * (1 - d)) by (unfold u, w; ring).
  assert (E3 : (u * v - x * w) * w - u * u * y =
    64 * ((1 - d) * (1 - d^2) - b * (1 - d)^2 + (a - c) * (c - a * d))) by (unfold u, v, w, x, y; ring).
  split.
  - intro S; assert (N := stable_not p S); assert (P1 : 0 < x).
    { unfold x; replace (1 + a + b + c + d) with (rpoly ((d :: c :: b :: a :: nil) ++ 1 :: nil) 1) by (simpl; ring).
      apply stable_at_1; apply (stable_alike _ _ P) in S; revert S; apply stable_alike; intro z; simpl; ring. }
    apply B in S; [| exact N]; apply hurwitz_4 in S; [| exact P1 | intro F; apply N; rewrite M; fold y; rewrite F; reflexivity].
    destruct S as (U & D & T & Y); assert (W : 0 < w) by nra.
    assert (V : 0 < v) by nra; repeat split; lra.
  - intros (P1 & V & P2 & I & T); apply B; [rewrite M; apply Cnot_zero; lra |].
    assert (T3 : 0 < (u * v - x * w) * w - u * u * y) by lra.
    assert (UW : 0 < u * w) by nra.
    assert (U : 0 < u) by nra; assert (W : 0 < w) by nra.
    apply hurwitz_4; [exact P1 | lra |]; repeat split; try assumption; nra.
Qed.

(* -- first minors of Hurwitz' matrix -------------------------------------------------------------- *)

(* The product with a + b s, and the powers (1 + s)^e (1 - s)^f. *)
Definition times (b : R) (l : list R) : list R := rsum l (0 :: map (Rmult b) l).
Fixpoint falling (f : nat) : list R := match f with O => 1 :: nil | S f => times (- (1)) (falling f) end.
Fixpoint both (e f : nat) : list R := match e with O => falling f | S e => times 1 (both e f) end.
Lemma poly_multiple : forall c l z, poly (reals (map (Rmult c) l)) z = (c * poly (reals l) z)%C.
Proof.
  intros c l z; induction l as [| x l IH]; simpl; [ring |].
  fold (reals l) (reals (map (Rmult c) l)); rewrite IH, RtoC_mult; ring.
Qed.
Lemma poly_times : forall b l z, poly (reals (times b l)) z = ((1 + b * z) * poly (reals l) z)%C.
Proof. intros b l z; unfold times; rewrite poly_rsum; simpl; rewrite poly_multiple; ring. Qed.
Lemma poly_both : forall e f z, poly (reals (both e f)) z = ((1 + z) ^ e * (1 - z) ^ f)%C.
Proof.
  intros e f z; induction e as [| e IH]; simpl both.
  - simpl Cpower; induction f as [| f IH]; simpl; [ring |]; rewrite poly_times, IH, RtoC_opp; ring.
  - rewrite poly_times, IH; simpl; ring.
Qed.
Lemma length_times : forall b l, length (times b l) = S (length l).
Proof. intros b l; unfold times; rewrite length_sum; simpl; rewrite map_length; lia. Qed.
Lemma length_both : forall e f, length (both e f) = S (e + f).
Proof.
  intros e f; induction e as [| e IH]; simpl; [| rewrite length_times, IH; reflexivity].
  induction f as [| f IH]; simpl; [reflexivity | rewrite length_times, IH; reflexivity].
Qed.
Lemma nth_sum : forall a b n, nth n (rsum a b) 0 = nth n a 0 + nth n b 0.
Proof. induction a as [| x a IH]; intros [| y b] [| n]; simpl; try lra; apply IH. Qed.
Lemma nth_times_0 : forall b l, nth 0 (times b l) 0 = nth 0 l 0.
Proof. intros; unfold times; rewrite nth_sum; simpl; ring. Qed.
Lemma nth_times : forall b l n, nth (S n) (times b l) 0 = nth (S n) l 0 + b * nth n l 0.
Proof.
  intros b l n; unfold times; rewrite nth_sum; simpl; f_equal; revert n.
  induction l as [| x l IH]; intros [| n]; simpl; try lra; apply IH.
Qed.
(* Coefficients of (1 + s)^e (1 - s)^f. *)
Definition weight (k : nat) (e f : R) : R :=
  match k with
  | 0%nat => 1
  | 1%nat => e - f
  | 2%nat => e * (e - 1) / 2 - e * f + f * (f - 1) / 2
  | _ => e * (e - 1) * (e - 2) / 6 - e * (e - 1) / 2 * f + e * (f * (f - 1) / 2) - f * (f - 1) * (f - 2) / 6
  end.
Lemma nth_both : forall e f k, (k <= 3)%nat -> nth k (both e f) 0 = weight k (INR e) (INR f).
Proof.
  intros e f; induction e as [| e IH].
  - induction f as [| f IH]; intros [| [| [| [| k]]]] K; try lia; simpl both in *; simpl falling in *;
      rewrite ?nth_times, ?nth_times_0, ?IH by lia; rewrite ?S_INR; simpl; field.
  - intros [| [| [| [| k]]]] K; try lia; simpl both; rewrite ?nth_times, ?nth_times_0, ?IH by lia; rewrite ?S_INR; simpl; field.
Qed.
(* The coefficient k of (1 - s)^n p((1 + s)/(1 - s)). *)
Fixpoint minor (k n : nat) (s : list (R * nat)) : R :=
  match s with nil => 0 | (c, e) :: s => c * weight k (INR e) (INR n - INR e) + minor k n s end.
Fixpoint turned_list (n : nat) (s : list (R * nat)) : list R :=
  match s with nil => nil | (c, e) :: s => rsum (map (Rmult c) (both e (n - e))) (turned_list n s) end.
Lemma nth_turned : forall n s k, (k <= 3)%nat -> Forall (fun t => (snd t <= n)%nat) s ->
  nth k (turned_list n s) 0 = minor k n s.
Proof.
  intros n s k K D; induction D as [| [c e] s E D IH]; simpl in *; [destruct k; reflexivity |].
  rewrite nth_sum, IH; f_equal.
  rewrite <- minus_INR, <- nth_both by (assumption || lia).
  generalize (both e (n - e)) as l; clear; revert k; intros k l; revert k.
  induction l as [| x l IH]; intros [| k]; simpl; try ring; apply IH.
Qed.
Lemma poly_turned : forall n s z, z <> RtoC 1 -> Forall (fun t => (snd t <= n)%nat) s ->
  poly (reals (turned_list n s)) z = ((1 - z) ^ n * powers s ((1 + z) / (1 - z)))%C.
Proof.
  intros n s z N D; apply one_minus in N; induction D as [| [c e] s E D IH]; simpl in *; [ring |].
  rewrite poly_rsum, IH, poly_multiple, poly_both.
  replace ((1 - z) ^ n)%C with ((1 - z) ^ e * (1 - z) ^ (n - e))%C.
  2: { rewrite <- Cpower_plus; f_equal; lia. }
  replace ((1 + z) ^ e)%C with ((1 - z) ^ e * ((1 + z) / (1 - z)) ^ e)%C; [ring |].
  rewrite <- Cpower_product; f_equal; field; exact N.
Qed.
Lemma length_turned : forall n s, s <> nil -> Forall (fun t => (snd t <= n)%nat) s -> length (turned_list n s) = S n.
Proof.
  intros n s N D; induction D as [| [c e] s E D IH]; [contradiction |]; simpl in *.
  rewrite length_sum, map_length, length_both; destruct s; [simpl; lia | rewrite IH by discriminate; lia].
Qed.
Lemma turned_at_1 : forall n s, degrees_below s n -> poly (reals (turned_list n ((1, n) :: s))) 1 = RtoC (2 ^ n).
Proof.
  intros n s D; simpl; rewrite poly_rsum, poly_multiple, poly_both, Nat.sub_diag.
  replace (poly (reals (turned_list n s)) 1) with (RtoC 0).
  - simpl; rewrite RtoC_power; replace (1 + 1)%C with (RtoC 2); [ring |].
    apply injective_projections; simpl; ring.
  - induction D as [| [c e] s E D IH]; simpl in *; [reflexivity |].
    rewrite poly_rsum, poly_multiple, poly_both, <- IH; destruct (n - e)%nat eqn:F; [lia |]; simpl; ring.
Qed.
Lemma last_both : forall e f, nth (e + f) (both e f) 0 = (-1) ^ f.
Proof.
  intros e f; induction e as [| e IH]; simpl both.
  - induction f as [| f IH]; [reflexivity |]; change (falling (S f)) with (times (- (1)) (both 0 f)).
    change (0 + S f)%nat with (S (0 + f)); rewrite nth_times, nth_overflow by (rewrite length_both; lia).
    change (both 0 f) with (falling f); rewrite IH; simpl; ring.
  - change (S e + f)%nat with (S (e + f)); rewrite nth_times, IH, nth_overflow by (rewrite length_both; lia); ring.
Qed.
Lemma last_turned : forall n s, Forall (fun t => (snd t <= n)%nat) s ->
  RtoC (nth n (turned_list n s) 0) = (RtoC ((-1) ^ n) * powers s (- RtoC 1))%C.
Proof.
  intros n s D; induction D as [| [c e] s E D IH]; simpl in *; [destruct n; simpl; ring |].
  rewrite nth_sum, RtoC_plus, IH; replace (nth n (map (Rmult c) (both e (n - e))) 0) with (c * (-1) ^ (n - e)).
  - replace (- RtoC 1)%C with (RtoC (-1)) by (apply injective_projections; simpl; ring).
    rewrite <- RtoC_power; replace ((-1) ^ (n - e)) with ((-1) ^ n * (-1) ^ e); [rewrite !RtoC_mult; ring |].
    replace n with (n - e + e)%nat at 1 by lia; rewrite pow_add, Rmult_assoc, <- Rpow_mult_distr.
    replace (-1 * -1) with 1 by ring; rewrite pow1; ring.
  - rewrite <- (last_both e (n - e)); replace (e + (n - e))%nat with n by lia.
    generalize (both e (n - e)) as l; clear; revert n; intros n l; revert n.
    induction l as [| x l IH]; intros [| n]; simpl; try ring; apply IH.
Qed.
(* Where all zeros of a monic real polynomial lie inside, p(1) and the first minors of Hurwitz' matrix
   of (1 - s)^n p((1 + s)/(1 - s)) are positive; Gantmacher, XV, Theorem 4. *)
Theorem first_minors : forall n s, degrees_below s n -> stable (powers ((1, n) :: s)) ->
  let c k := minor k n ((1, n) :: s) in
  0 < c 0%nat /\ ((1 <= n)%nat -> 0 < c 1%nat) /\ ((2 <= n)%nat -> 0 < c 1%nat * c 2%nat - c 0%nat * c 3%nat).
Proof.
  intros n s D S c; set (t := (1, n) :: s) in *; set (l := turned_list n t).
  assert (Dt : Forall (fun t => (snd t <= n)%nat) t).
  { constructor; [simpl; lia |]; eapply Forall_impl; [| exact D]; simpl; intros; lia. }
  assert (Ln : length l = Datatypes.S n) by (apply length_turned; [discriminate | exact Dt]).
  assert (Nth : forall k, (k <= 3)%nat -> nth k l 0 = c k) by (intros k K; apply nth_turned; assumption).
  destruct (led 1 n s D) as (a & La & E).
  assert (C0 : 0 < c 0%nat).
  { replace (c 0%nat) with (rpoly (a ++ 1 :: nil) 1).
    - apply stable_at_1; apply (stable_alike _ _ E), S.
    - apply RtoC_inj; rewrite <- poly_real, <- E; fold t; unfold c; clear.
      induction t as [| [x e] t IH]; simpl; [reflexivity |]; rewrite IH, Cpower_one, RtoC_plus, RtoC_mult; ring. }
  assert (Far : nth n l 0 <> 0).
  { intro F; assert (L := last_turned n t Dt); fold l in L; rewrite F in L; symmetry in L.
    destruct (product_apart_C _ _ L) as [K | K]; [| exact (stable_not _ S K)].
    apply RtoC_inj in K; revert K; apply pow_nonzero; lra. }
  assert (H : hurwitz (poly (reals l))).
  { apply (bilinear (powers t) _ n); [intros w W; apply poly_turned; assumption | | exact (stable_not _ S) | exact S].
    unfold l, t; rewrite turned_at_1 by exact D; apply Cnot_zero, pow_nonzero; lra. }
  rewrite <- !Nth by lia; rewrite <- Nth in C0 by lia; split; [exact C0 |]; clearbody l; clear c Nth.
  destruct l as [| x [| y m]]; simpl in Ln; [lia | split; intro; lia |].
  assert (E1 : x :: y :: m = removelast (x :: y :: m) ++ nth n (x :: y :: m) 0 :: nil).
  { replace (nth n (x :: y :: m) 0) with (last (x :: y :: m) 0); [apply app_removelast_last; discriminate |].
    assert (Nl : forall l : list R, l <> nil -> last l 0 = nth (pred (length l)) l 0).
    { clear; induction l as [| u [| v l] IH]; intro N; [contradiction | reflexivity |]; simpl in *; apply IH; discriminate. }
    rewrite Nl by discriminate; f_equal; simpl in *; lia. }
  assert (Y := second_positive x y m _ _ C0 Far E1 H); split; [intros _; exact Y |]; intro N2.
  destruct m as [| z m]; [simpl in *; lia |].
  assert (Dn : hurwitz (poly (reals (routh (x :: y :: z :: m))))) by exact (down x y _ (z :: m) C0 ltac:(simpl in Y; lra) Far (ex_intro _ _ E1) H).
  destruct (routh_end x y (z :: m) _ _ E1) as (h & _ & E2).
  replace (routh (x :: y :: z :: m)) with (y :: (z - x / y * nth 0 m 0) :: tl (tl (routh (x :: y :: z :: m)))) in Dn, E2.
  2: { unfold routh; destruct m as [| w [| v m]]; simpl; repeat (apply f_equal2; [ring |]); reflexivity. }
  assert (Z := second_positive y _ _ _ h Y Far E2 Dn); simpl nth in *.
  replace (nth 3 (x :: y :: z :: m) 0) with (nth 0 m 0) by reflexivity; simpl.
  replace (y * z - x * nth 0 m 0) with (y * (z - x / y * nth 0 m 0)) by (field; lra).
  apply Rmult_lt_0_compat; assumption.
Qed.

