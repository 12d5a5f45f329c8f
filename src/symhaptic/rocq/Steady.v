(* The steady state of a device that is moved by the held forces z^k, |z| = 1: what these work is burnt. *)
From Symhaptic Require Export Loop.
Open Scope R_scope.

Lemma locally_constant : forall (f : R -> R) p q c s, (forall t, p < t < q -> f t = c) -> p < s < q ->
  forall l, is_derive f s l -> l = 0.
Proof.
  intros f p q c s K S l D; rewrite <- (is_derive_unique _ _ _ D); apply is_derive_unique.
  apply (is_derive_ext_loc (fun _ => c)); [| apply (is_derive_const (V := R_NormedModule))].
  assert (P : 0 < Rmin (s - p) (q - s)) by (apply Rmin_glb_lt; lra); exists (mkposreal _ P); intros t T; symmetry;
    apply K.
  assert (Q : Rabs (t - s) < Rmin (s - p) (q - s)) by exact T; apply Rabs_def2 in Q.
  generalize (Rmin_l (s - p) (q - s)) (Rmin_r (s - p) (q - s)); lra.
Qed.
Lemma rises_weakly : forall (f g : R -> R) p q, p <= q -> (forall t, is_derive f t (g t)) ->
  (forall t, 0 <= g t) -> f p <= f q.
Proof.
  intros f g p q [L | L] D P; [| subst; lra]; destruct (MVT_cor2 f g p q L) as (c & E & C).
  - intros t _; apply is_derive_Reals, D.
  - specialize (P c); nra.
Qed.
(* A motion that does not speed up at one time, nor a moment later, never does. *)
Lemma steady_speed : forall gamma delta F x v s, moves gamma delta F x v -> gamma * v s = 0 ->
  F - delta * v s - gamma * x s = 0 ->
  forall t, v t = v s /\ x t = x s + v s * (t - s).
Proof.
  intros g d F x v s M Z E t; assert (L := moves_later _ _ _ _ _ s M).
  assert (N : moves g d F (fun t => x s + v s * t) (fun _ => v s)).
  { intro u; split; [auto_derive; [exact I | ring] |].
    replace (F - d * v s - g * (x s + v s * u)) with 0.
    - apply (is_derive_const (V := R_NormedModule)).
    - replace (F - d * v s - g * (x s + v s * u)) with (F - d * v s - g * x s - g * v s * u) by ring; rewrite E, Z;
        ring. }
  destruct (one_motion_always _ _ _ _ _ _ _ L N) with (t := t - s) as [A B]; try (rewrite Rplus_0_r; ring).
  replace (s + (t - s)) with t in * by ring; split; assumption.
Qed.

Section Steady.
Variables (g d : R) (x1 v1 x2 v2 x3 v3 : R -> R) (z : C).
Hypotheses (M : motions g d x1 v1 x2 v2 x3 v3) (D : 0 < d) (One : z <> RtoC 1) (Circle : Cmod z = 1).
Let N : C := (x3 1 * z + (x2 1 * v3 1 - v2 1 * x3 1))%C.
Let S : C := (v1 1 * x3 1 + (z - x1 1) * v3 1)%C.
Let A : C := (z^2 - (x1 1 + v2 1) * z + (x1 1 * v2 1 - x2 1 * v1 1))%C.
Hypothesis Apart : A <> RtoC 0.
(* Under the force A z^k the state is N z^k, S z^k at the beginning of period k. *)
Definition steady_place (t : R) : C := (x1 t * N + x2 t * S + x3 t * A)%C.
Definition steady_rate (t : R) : C := (v1 t * N + v2 t * S + v3 t * A)%C.
Lemma steady_starts : steady_place 0 = N /\ steady_rate 0 = S.
Proof.
  destruct M as [_ P1 Q1 _ P2 Q2 _ P3 Q3]; unfold steady_place, steady_rate; rewrite P1, Q1, P2, Q2, P3, Q3; split;
    ring.
Qed.
Lemma steady_ends : steady_place 1 = (z * N)%C /\ steady_rate 1 = (z * S)%C.
Proof. unfold steady_place, steady_rate, N, S, A; simpl; split; ring. Qed.
Lemma combined : forall p q r, moves g d r (fun t => p * x1 t + q * x2 t + r * x3 t) (fun t => p * v1 t +
  q * v2 t + r * v3 t).
Proof.
  intros p q r t; destruct (first _ _ _ _ _ _ _ _ M t) as [A1 B1], (second _ _ _ _ _ _ _ _ M t) as [A2 B2], (third _
    _ _ _ _ _ _ _ M t) as [A3 B3].
  assert (L : forall f h k (f' h' k' : R), is_derive f t f' -> is_derive h t h' -> is_derive k t k' ->
    is_derive (fun t => p * f t + q * h t + r * k t) t (p * f' + q * h' + r * k')).
  { intros f h k f' h' k' E F G.
    apply (is_derive_plus (fun t => p * f t + q * h t) (fun t => r * k t));
      [apply (is_derive_plus (fun t => p * f t) (fun t => q * h t)) |];
      apply is_derive_scal; assumption. }
  split; [apply L; assumption |].
  replace (r - d * (p * v1 t + q * v2 t + r * v3 t) - g * (p * x1 t + q * x2 t + r * x3 t)) with
    (p * (0 - d * v1 t - g * x1 t) + q * (0 - d * v2 t - g * x2 t) + r * (1 - d * v3 t - g * x3 t)) by ring.
  apply L; assumption.
Qed.
Lemma steady_moves : moves g d (Re A) (fun t => Re (steady_place t)) (fun t => Re (steady_rate t)) /\
  moves g d (Im A) (fun t => Im (steady_place t)) (fun t => Im (steady_rate t)).
Proof.
  assert (L : forall F x v y w, moves g d F x v -> (forall t, y t = x t) -> (forall t, w t = v t) -> moves g d F y w).
  { intros F x v y w Mv X V t; destruct (Mv t) as [P Q]; rewrite X, V; split.
    - apply (is_derive_ext x); [intro; rewrite X; reflexivity | exact P].
    - apply (is_derive_ext v); [intro; rewrite V; reflexivity | exact Q]. }
  split; [apply (L _ _ _ _ _ (combined (Re N) (Re S) (Re A))) | apply (L _ _ _ _ _ (combined (Im N) (Im S) (Im A)))];
    intro t; unfold steady_place, steady_rate; destruct N, S, A; simpl; ring.
Qed.
(* What the force worked and is not stored. *)
Definition spent (t : R) : R := Re A * Re (steady_place t) + Im A * Im (steady_place t)
  - (Re (steady_rate t) ^ 2 + Im (steady_rate t) ^ 2) / 2 - g * (Re (steady_place t) ^ 2 +
      Im (steady_place t) ^ 2) / 2.
Lemma spent_more : forall p q, p < q ->
  d * (Cmod (steady_place q - steady_place p)%C ^ 2 / (q - p)) < spent q - spent p.
Proof.
  intros p q L; destruct steady_moves as [Mr Mi].
  set (xr := fun t => Re (steady_place t)) in *; set (vr := fun t => Re (steady_rate t)) in *.
  set (xi := fun t => Im (steady_place t)) in *; set (vi := fun t => Im (steady_rate t)) in *.
  set (mr := (xr q - xr p) / (q - p)); set (mi := (xi q - xi p) / (q - p)).
  set (f := fun t => Re A * xr t + Im A * xi t - (vr t ^ 2 + vi t ^ 2) / 2 - g * (xr t ^ 2 + xi t ^ 2) / 2
    - d * (2 * (mr * xr t + mi * xi t) - (mr ^ 2 + mi ^ 2) * t)).
  assert (Df : forall t, is_derive f t (d * ((vr t - mr) ^ 2 + (vi t - mi) ^ 2))).
  { intro t; destruct (Mr t) as [P1 Q1], (Mi t) as [P2 Q2].
    assert (E1 : Derive (fun t => xr t) t = vr t) by (apply is_derive_unique; exact P1).
    assert (E2 : Derive (fun t => vr t) t = Re A - d * vr t - g * xr t) by (apply is_derive_unique; exact Q1).
    assert (E3 : Derive (fun t => xi t) t = vi t) by (apply is_derive_unique; exact P2).
    assert (E4 : Derive (fun t => vi t) t = Im A - d * vi t - g * xi t) by (apply is_derive_unique; exact Q2).
    unfold f; clear f; set (Ar := Re A) in *; set (Ai := Im A) in *; clearbody Ar Ai xr vr xi vi.
    auto_derive; [repeat split; eexists; eassumption | rewrite E1, E2, E3, E4; field]. }
  assert (Nf : forall t, 0 <= d * ((vr t - mr) ^ 2 + (vi t - mi) ^ 2)).
  { intro t; apply Rmult_le_pos; [lra | generalize (pow2_ge_0 (vr t - mr)) (pow2_ge_0 (vi t - mi)); lra]. }
  assert (Rise : f p < f q).
  { apply Rnot_le_lt; intro Le; assert (Flat : forall t, p < t < q -> f t = f p).
    { intros t T; generalize (rises_weakly _ _ p t ltac:(lra) Df Nf) (rises_weakly _ _ t q ltac:(lra) Df Nf); lra. }
    assert (Same : forall t, p < t < q -> vr t = mr /\ vi t = mi).
    { intros t T; assert (Z := locally_constant f p q (f p) t Flat T _ (Df t)).
      assert ((vr t - mr) ^ 2 + (vi t - mi) ^ 2 = 0) by (apply Rmult_eq_reg_l with d; lra).
      generalize (pow2_ge_0 (vr t - mr)) (pow2_ge_0 (vi t - mi)); intros; split; apply Rminus_diag_uniq;
        apply Rsqr_0_uniq; unfold Rsqr; simpl in *; lra. }
    set (s := (p + q) / 2); assert (Ps : p < s < q) by (unfold s; lra).
    assert (Rest : forall F x v m, moves g d F x v -> (forall t, p < t < q -> v t = m) ->
      forall t, v t = v s /\ x t = x s + v s * (t - s)).
    { intros F x v m Mv V; assert (Acc : forall t, p < t < q -> F - d * v t - g * x t = 0).
      { intros t T; apply (locally_constant v p q m t V T), (Mv t). }
      apply (steady_speed g d F); [exact Mv | | apply Acc, Ps].
      apply (locally_constant (fun t => g * x t) p q (F - d * m) s); [| exact Ps | apply is_derive_scal, (Mv s)].
      intros t T; generalize (Acc t T); rewrite (V t T); lra. }
    assert (Ur := Rest _ _ _ mr Mr (fun t T => proj1 (Same t T)));
      assert (Ui := Rest _ _ _ mi Mi (fun t T => proj2 (Same t T))).
    assert (Turn : forall w : C, (z * w)%C = w -> w = RtoC 0).
    { intros w E; destruct (Ceq_dec w 0) as [Z | Z]; [exact Z | exfalso; apply One].
      replace z with (z * w / w)%C by (field; exact Z); rewrite E; field; exact Z. }
    assert (V0 : steady_rate 1 = steady_rate 0).
    { apply injective_projections; [change (vr 1 = vr 0) | change (vi 1 = vi 0)].
      - rewrite (proj1 (Ur 1)), (proj1 (Ur 0)); reflexivity.
      - rewrite (proj1 (Ui 1)), (proj1 (Ui 0)); reflexivity. }
    rewrite (proj2 steady_ends), (proj2 steady_starts) in V0; apply Turn in V0.
    assert (Zr : vr 0 = 0 /\ vi 0 = 0) by (unfold vr, vi; rewrite (proj2 steady_starts), V0; split; reflexivity).
    assert (Zs : vr s = 0 /\ vi s = 0) by (rewrite <- (proj1 (Ur 0)), <- (proj1 (Ui 0)); exact Zr).
    assert (X0 : steady_place 1 = steady_place 0).
    { apply injective_projections; [change (xr 1 = xr 0) | change (xi 1 = xi 0)].
      - rewrite (proj2 (Ur 1)), (proj2 (Ur 0)), (proj1 Zs); ring.
      - rewrite (proj2 (Ui 1)), (proj2 (Ui 0)), (proj2 Zs); ring. }
    rewrite (proj1 steady_ends), (proj1 steady_starts) in X0; apply Turn in X0.
    assert (Wr : xr 0 = 0 /\ xi 0 = 0) by (unfold xr, xi; rewrite (proj1 steady_starts), X0; split; reflexivity).
    assert (Acc : forall F x v, moves g d F x v -> (forall t, v t = v s /\ x t = x s + v s * (t - s)) ->
      v s = 0 -> x 0 = 0 -> F = 0).
    { intros F x v Mv V Vs Xs; assert (E : F - d * v 0 - g * x 0 = 0).
      { apply (locally_constant v (-1) 1 0 0); [intros t _; rewrite (proj1 (V t)); exact Vs | lra | apply (Mv 0)]. }
      rewrite (proj1 (V 0)), Vs, Xs in E; lra. }
    apply Apart; apply injective_projections; simpl.
    - exact (Acc _ _ _ Mr Ur (proj1 Zs) (proj1 Wr)).
    - exact (Acc _ _ _ Mi Ui (proj2 Zs) (proj2 Wr)). }
  unfold f in Rise; unfold spent; fold (xr q) (xr p) (xi q) (xi p) (vr q) (vr p) (vi q) (vi p).
  rewrite Cmod_square; replace (Re (steady_place q - steady_place p)%C) with (mr * (q - p)).
  2: { unfold mr, xr; destruct (steady_place q), (steady_place p); simpl; field; lra. }
  replace (Im (steady_place q - steady_place p)%C) with (mi * (q - p)).
  2: { unfold mi, xi; destruct (steady_place q), (steady_place p); simpl; field; lra. }
  replace ((mr * (q - p) * (mr * (q - p)) + mi * (q - p) * (mi * (q - p))) / (q - p)) with ((mr ^ 2 +
    mi ^ 2) * (q - p)) by (field; lra).
  assert (Er : xr q = xr p + mr * (q - p)) by (unfold mr; field; lra).
  assert (Ei : xi q = xi p + mi * (q - p)) by (unfold mi; field; lra).
  assert (d * (2 * (mr * xr q + mi * xi q) - (mr ^ 2 + mi ^ 2) * q) - d * (2 * (mr * xr p + mi * xi p) - (mr ^ 2 +
    mi ^ 2) * p) =
    d * ((mr ^ 2 + mi ^ 2) * (q - p))) by (rewrite Er, Ei; ring).
  lra.
Qed.
(* In a whole period as much is stored as before. *)
Lemma spent_in_all : spent 1 - spent 0 = Re (Cconj A * ((z - 1) * N))%C.
Proof.
  unfold spent; rewrite (proj1 steady_starts), (proj2 steady_starts), (proj1 steady_ends), (proj2 steady_ends).
  assert (Sq : forall w : C, Re (z * w)%C ^ 2 + Im (z * w)%C ^ 2 = Re w ^ 2 + Im w ^ 2).
  { intro w; assert (E := Cmod_square (z * w)%C); rewrite Cmod_mult, Circle, Rmult_1_l, Cmod_square in E;
      simpl in *; lra. }
  rewrite !Sq; destruct A, z, N; simpl; ring.
Qed.
End Steady.
(* No pole of a damped device lies on the circle, but that of a free one at 1. *)
Lemma away_from_poles : forall gamma delta n_1 n_0 a e (z : C), device gamma delta n_1 n_0 a e -> 0 <= gamma ->
  0 < delta ->
  Cmod z = 1 -> z <> RtoC 1 -> (z^2 - a * z + e)%C <> RtoC 0.
Proof.
  intros g d n1 n0 a e z V [G | G] D Z One E.
  - assert (S := device_forgets _ _ _ _ _ _ (conj V (conj G D)) z); cbv beta in S; assert (Cmod z < 1); [| lra].
    apply S; rewrite <- E; simpl; ring.
  - subst g; assert (R := device_at_rest _ _ _ _ _ _ V); assert (L := device_loss _ _ _ _ _ _ V).
    assert (P := exp_pos (- d)); assert (Q : exp (- d) < 1) by (rewrite <- exp_0; apply exp_increasing; lra).
    replace (RtoC a) with (1 + RtoC e)%C in E by (rewrite <- RtoC_plus; f_equal; lra).
    assert (F : ((z - 1) * (z - e))%C = RtoC 0) by (rewrite <- E; simpl; ring).
    destruct (product_apart_C _ _ F) as [K | K].
    + apply One; replace z with (z - 1 + 1)%C by ring; rewrite K; ring.
    + assert (Ze : z = RtoC e) by (replace z with (z - e + e)%C by ring; rewrite K; ring).
      rewrite Ze, Cmod_R, L, Rabs_pos_eq in Z; lra.
Qed.
Theorem held_steady_state : forall gamma delta n_1 n_0 a e (z : C), device gamma delta n_1 n_0 a e ->
  0 <= gamma -> 0 < delta ->
  Cmod z = 1 -> z <> RtoC 1 ->
  delta * Cmod ((z - 1) * (n_1 * z + n_0))%C ^ 2 < Re (Cconj (z^2 - a * z + e) * ((z - 1) * (n_1 * z + n_0)))%C.
Proof.
  intros g d n1 n0 a e z V G D Z One; assert (Ap := away_from_poles _ _ _ _ _ _ z V G D Z One).
  destruct V as (x1 & v1 & x2 & v2 & x3 & v3 & M & A & E & N1 & N0); subst a e n1 n0.
  rewrite !RtoC_minus, !RtoC_plus, !RtoC_mult in *.
  assert (Sp := spent_more _ _ _ _ _ _ _ _ z M D One Ap 0 1 Rlt_0_1).
  rewrite (spent_in_all _ _ _ _ _ _ _ _ z M One Z Ap), (proj1 (steady_starts _ _ _ _ _ _ _ _ z M)), (proj1
    (steady_ends x1 v1 x2 v2 x3 v3 z)) in Sp.
  replace (1 - 0) with 1 in Sp by ring; unfold Rdiv in Sp; rewrite Rinv_1, Rmult_1_r in Sp.
  eapply Rle_lt_trans; [| exact Sp]; apply Req_le; do 3 f_equal; ring.
Qed.

(* The same of each force from its beginning to its end, in two parts: before a sample and after it. *)
Lemma steady_sample : forall gamma delta x1 v1 x2 v2 x3 v3 u (z : C), motions gamma delta x1 v1 x2 v2 x3 v3 ->
  0 <= u <= 1 ->
  let x := x3 (1 - u) in let v := v3 (1 - u) in
  let y := x1 (1 - u) * x3 u + x2 (1 - u) * v3 u in let w := v1 (1 - u) * x3 u + v2 (1 - u) * v3 u in
  steady_place x1 v1 x2 v2 x3 v3 z (1 - u) =
    (x * z^2 + RtoC (x2 1 * v - v2 1 * x + y) * z + RtoC (x2 1 * w - v2 1 * y))%C.
Proof.
  intros g d x1 v1 x2 v2 x3 v3 u z M U; cbv zeta; set (r := 1 - u); assert (R0 : 0 <= r) by (unfold r; lra).
  destruct (two_parts _ _ _ _ _ _ _ _ u r M R0) as [E1 F1], (two_parts _ _ _ _ _ _ _ _ 1 r M R0) as [E2 F2].
  destruct (two_parts _ _ _ _ _ _ _ _ r 1 M ltac:(lra)) as [E3 F3], (two_parts _ _ _ _ _ _ _ _ 1 1 M ltac:(lra)) as
    [E4 F4].
  destruct (two_parts _ _ _ _ _ _ _ _ 2 r M R0) as [E5 F5], (two_parts _ _ _ _ _ _ _ _ (1 +
    r) 1 M ltac:(lra)) as [E6 F6].
  replace (u + r) with 1 in * by (unfold r; ring); replace (r + 1) with (1 + r) in * by ring;
    replace (1 + r + 1) with (2 + r) in * by ring.
  replace (1 + 1) with 2 in * by ring.
  assert (Y : x1 r * x3 u + x2 r * v3 u = x3 1 - x3 r) by lra;
    assert (W : v1 r * x3 u + v2 r * v3 u = v3 1 - v3 r) by lra.
  assert (C1 : x1 r * x3 1 + x2 r * v3 1 = x3 1 + x1 1 * x3 r + x2 1 * v3 r - x3 r) by lra.
  assert (C2 : x1 r * (x1 1 * x3 1 + x2 1 * v3 1) + x2 r * (v1 1 * x3 1 + v2 1 * v3 1) =
    x1 1 * x3 (1 + r) + x2 1 * v3 (1 + r) - x3 (1 + r) + x3 1).
  { replace (x1 1 * x3 1 + x2 1 * v3 1) with (x3 2 - x3 1) by lra;
      replace (v1 1 * x3 1 + v2 1 * v3 1) with (v3 2 - v3 1) by lra; lra. }
  rewrite E3, F3 in C2; rewrite Y, W; unfold steady_place.
  assert (Q : (x1 r * (x3 1 * z + (x2 1 * v3 1 - v2 1 * x3 1)) + x2 r * (v1 1 * x3 1 + (z - x1 1) * v3 1))%C =
    (RtoC (x1 r * x3 1 + x2 r * v3 1) * (z - RtoC (x1 1 + v2 1)) +
     RtoC (x1 r * (x1 1 * x3 1 + x2 1 * v3 1) + x2 r * (v1 1 * x3 1 + v2 1 * v3 1)))%C).
  { rewrite !RtoC_plus, !RtoC_mult, !RtoC_plus, !RtoC_mult; ring. }
  rewrite Q, C1, C2; repeat first [rewrite RtoC_plus | rewrite RtoC_minus | rewrite RtoC_mult]; simpl; ring.
Qed.
Theorem late_held_steady_state : forall gamma delta u m_2 m_1 m_0 n_1 n_0 a e (z : C),
  late_device gamma delta u m_2 m_1 m_0 a e -> device gamma delta n_1 n_0 a e -> 0 <= gamma -> 0 < delta ->
    0 < u < 1 ->
  Cmod z = 1 -> z <> RtoC 1 ->
  delta * (u * (1 - u) * Cmod ((z - 1) * (n_1 * z + n_0))%C ^ 2 +
    Cmod (m_2 * z^2 + m_1 * z + m_0 - (u + (1 - u) * z) * (n_1 * z + n_0))%C ^ 2) <
  u * (1 - u) * Re (Cconj (z^2 - a * z + e) * ((z - 1) * (n_1 * z + n_0)))%C.
Proof.
  intros g d u m2 m1 m0 n1 n0 a e z (U' & y1 & w1 & y2 & w2 & y3 & w3 & L & _ & _ & M2 & M1 & M0) V G D U Z One.
  assert (Ap := away_from_poles _ _ _ _ _ _ z V G D Z One).
  destruct V as (x1 & v1 & x2 & v2 & x3 & v3 & M & A & E & N1 & N0); subst a e n1 n0.
  assert (Same := motions_unique _ _ _ _ _ _ _ _ _ _ _ _ _ _ L M).
  destruct (Same 1 ltac:(lra)) as ((X1 & V1) & (X2 & V2) & (X3 & V3)), (Same u ltac:(lra)) as ((P1 & Q1) & (P2 & Q2)
    & (P3 & Q3)),
    (Same (1 - u) ltac:(lra)) as ((R1 & S1) & (R2 & S2) & (R3 & S3)).
  cbv zeta in M2, M1, M0; rewrite R3 in M2; rewrite X2, V2, P3, Q3, R1, R2, R3, S3 in M1;
    rewrite X2, V2, P3, Q3, R1, S1, R2, S2 in M0; clear X1 V1 X3 V3 P1 Q1 P2 Q2.

  assert (Sample := steady_sample _ _ _ _ _ _ _ _ u z M ltac:(lra)); cbv zeta in Sample;
    rewrite <- M1, <- M0, <- M2 in Sample.
  repeat first [rewrite RtoC_minus | rewrite RtoC_plus | rewrite RtoC_mult].
  repeat first [rewrite RtoC_minus in Ap | rewrite RtoC_plus in Ap | rewrite RtoC_mult in Ap].
  assert (One' := spent_more _ _ _ _ _ _ _ _ z M D One Ap 0 (1 - u) ltac:(lra)).
  assert (Two := spent_more _ _ _ _ _ _ _ _ z M D One Ap (1 - u) 1 ltac:(lra)).
  assert (All := spent_in_all _ _ _ _ _ _ _ _ z M One Z Ap).
  rewrite Sample, (proj1 (steady_starts _ _ _ _ _ _ _ _ z M)) in One';
    rewrite Sample, (proj1 (steady_ends x1 v1 x2 v2 x3 v3 z)) in Two.
  match type of All with _ = ?r => set (W := r) in * end.
  set (N := (x3 1 * z + (x2 1 * v3 1 - v2 1 * x3 1))%C) in *; set (X := (m2 * z^2 + m1 * z + m0)%C) in *.
  assert (Sum : d * (Cmod (X - N)%C ^ 2 / (1 - u)) + d * (Cmod (z * N - X)%C ^ 2 / u) < W).
  { replace (1 - u - 0) with (1 - u) in One' by ring; replace (1 - (1 - u)) with u in Two by ring; lra. }
  assert (Sq : u * (1 - u) * (d * (Cmod (X - N)%C ^ 2 / (1 - u)) + d * (Cmod (z * N - X)%C ^ 2 / u)) =
    d * (u * (1 - u) * Cmod ((z - 1) * N)%C ^ 2 + Cmod (X - (u + (1 - u) * z) * N)%C ^ 2)).
  { rewrite !Cmod_square; clearbody X N; destruct X as [p q], z as [s t], N as [i j]; simpl; field; repeat split;
      shown_here; lra. }
  rewrite <- Sq; apply Rmult_lt_compat_l; [nra | exact Sum].
Qed.
