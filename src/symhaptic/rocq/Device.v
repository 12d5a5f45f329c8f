(* A device of mass 1 with a spring and a damper, sampled at the times 0, 1, 2, ...: its motions exist and
   are unique, and give the numbers of its discrete transfer function. *)
From Symhaptic Require Export HalfPlane.
Open Scope R_scope.

(* -- motions -------------------------------------------------------------------------------- *)

(* x'' + delta x' + gamma x = F at all times, with the speed v; units of mass and period. *)
Definition moves (gamma delta F : R) (x v : R -> R) : Prop :=
  forall t, is_derive x t (v t) /\ is_derive v t (F - delta * v t - gamma * x t).
(* Its motions from a displacement 1, from a speed 1, and from rest under the force 1. *)
Record motions (gamma delta : R) (x1 v1 x2 v2 x3 v3 : R -> R) : Prop := {
  first : moves gamma delta 0 x1 v1; first_place : x1 0 = 1; first_speed : v1 0 = 0;
  second : moves gamma delta 0 x2 v2; second_place : x2 0 = 0; second_speed : v2 0 = 1;
  third : moves gamma delta 1 x3 v3; third_place : x3 0 = 0; third_speed : v3 0 = 0 }.
(* The sampled device (n_1 z + n_0)/(z^2 - a z + e): from one sample to the next these motions take the
   state x, v and a held force F to x1 x + x2 v + x3 F and v1 x + v2 v + v3 F. *)
Definition device (gamma delta n_1 n_0 a e : R) : Prop :=
  exists x1 v1 x2 v2 x3 v3, motions gamma delta x1 v1 x2 v2 x3 v3 /\
    a = x1 1 + v2 1 /\ e = x1 1 * v2 1 - x2 1 * v1 1 /\ n_1 = x3 1 /\ n_0 = x2 1 * v3 1 - v2 1 * x3 1.

(* A motion without force that is at rest at 0 stays there: x^2 + v^2 grows no faster than exp. *)
Lemma constant : forall f : R -> R, (forall s, is_derive f s 0) -> forall t, f t = f 0.
Proof.
  intros f D t; destruct (MVT_gen f 0 t (fun _ => 0)) as (c & _ & E); [| | lra].
  - intros s _; apply D.
  - intros s _; apply continuity_pt_filterlim, (ex_derive_continuous f), (ex_intro _ 0), D.
Qed.
Lemma falls : forall f g : R -> R, (forall s, is_derive f s (g s)) -> (forall s, g s <= 0) -> forall t, 0 <= t -> f t <= f 0.
Proof.
  intros f g D N t T; destruct (MVT_gen f 0 t g) as (c & _ & E).
  - intros s _; apply D.
  - intros s _; apply continuity_pt_filterlim, (ex_derive_continuous f), (ex_intro _ (g s)), D.
  - specialize (N c); nra.
Qed.
Lemma stays_at_rest : forall gamma delta x v, moves gamma delta 0 x v -> x 0 = 0 -> v 0 = 0 ->
  forall t, 0 <= t -> x t = 0 /\ v t = 0.
Proof.
  intros g d x v M X V t T; set (k := 1 + Rabs g + 2 * Rabs d).
  assert (D : forall s, is_derive (fun s => (x s * x s + v s * v s) * exp (- k * s)) s
    ((2 * x s * v s * (1 - g) - 2 * d * v s * v s - k * (x s * x s + v s * v s)) * exp (- k * s))).
  { intro s; destruct (M s) as [A B].
    assert (A' : Derive (fun t => x t) s = v s) by (apply is_derive_unique; exact A).
    assert (B' : Derive (fun t => v t) s = 0 - d * v s - g * x s) by (apply is_derive_unique; exact B).
    auto_derive; [repeat split; eexists; eassumption | rewrite A', B'; ring]. }
  assert (N : forall s, (2 * x s * v s * (1 - g) - 2 * d * v s * v s - k * (x s * x s + v s * v s)) * exp (- k * s) <= 0).
  { intro s; assert (0 < exp (- k * s)) by apply exp_pos.
    assert (2 * x s * v s * (1 - g) - 2 * d * v s * v s <= k * (x s * x s + v s * v s)); [| nra].
    assert (A := Rle_abs g); assert (B := Rle_abs (- g)); rewrite Rabs_Ropp in B.
    assert (C := Rle_abs d); assert (E := Rle_abs (- d)); rewrite Rabs_Ropp in E; unfold k.
    assert (0 <= (x s - v s) * (x s - v s)) by apply Rle_0_sqr; assert (0 <= (x s + v s) * (x s + v s)) by apply Rle_0_sqr.
    assert (0 <= x s * x s) by apply Rle_0_sqr; assert (0 <= v s * v s) by apply Rle_0_sqr.
    assert (2 * x s * v s <= x s * x s + v s * v s) by nra; assert (- (2 * x s * v s) <= x s * x s + v s * v s) by nra.
    assert (P : 2 * x s * v s * - g <= Rabs g * (x s * x s + v s * v s)).
    { destruct (Rle_dec 0 g) as [G | G]; [rewrite (Rabs_pos_eq g) by exact G | rewrite (Rabs_left g) by lra]; nra. }
    assert (Q : - (2 * d * v s * v s) <= 2 * Rabs d * (v s * v s)) by nra.
    assert (0 <= Rabs d) by apply Rabs_pos; nra. }
  assert (F := falls _ _ D N t T); simpl in F; rewrite X, V in F.
  assert (0 < exp (- k * t)) by apply exp_pos.
  assert (0 <= x t * x t) by apply Rle_0_sqr; assert (0 <= v t * v t) by apply Rle_0_sqr.
  assert (x t * x t + v t * v t <= 0) by nra; split; nra.
Qed.
(* So there is one motion from each state. *)
Lemma moves_minus : forall gamma delta F G x v y w, moves gamma delta F x v -> moves gamma delta G y w ->
  moves gamma delta (F - G) (fun t => x t - y t) (fun t => v t - w t).
Proof.
  intros g d F G x v y w M N t; destruct (M t) as [A B], (N t) as [C D]; split.
  - apply (is_derive_minus x y t (v t) (w t)); assumption.
  - evar_last; [apply (is_derive_minus v w t); eassumption | unfold minus, plus, opp; simpl; ring].
Qed.
Lemma one_motion : forall gamma delta F x v y w, moves gamma delta F x v -> moves gamma delta F y w ->
  x 0 = y 0 -> v 0 = w 0 -> forall t, 0 <= t -> x t = y t /\ v t = w t.
Proof.
  intros g d F x v y w M N X V t T; assert (D := moves_minus _ _ _ _ _ _ _ _ M N).
  replace (F - F) with 0 in D by ring.
  destruct (stays_at_rest _ _ _ _ D ltac:(lra) ltac:(lra) t T); lra.
Qed.

(* C' = q S and S' = C from 1 and 0: cos, 1 or cosh, as q is negative, 0 or positive. *)
Record waves (q : R) (c s : R -> R) : Prop := {
  c_slope : forall t, is_derive c t (q * s t); s_slope : forall t, is_derive s t (c t);
  c_start : c 0 = 1; s_start : s 0 = 0;
  as_exponential : forall w : C, (w * w)%C = RtoC q -> forall t : R, Cexp (w * t)%C = (RtoC (c t) + w * RtoC (s t))%C;
  c_below : q <= 0 -> forall t, c t <= 1;
  c_above : forall t, -1 <= c t; c_turns : - PI^2 < q -> -1 < c 1;
  s_above : - PI^2 < q -> forall t, 0 < t <= 1 -> 0 < s t }.
Lemma waves_exist : forall q, exists c s, waves q c s.
Proof.
  intro q; destruct (Rlt_le_dec q 0) as [N | P]; [| destruct P as [P | Z]].
  - set (r := sqrt (- q)); assert (R0 : 0 < r) by (apply sqrt_lt_R0; lra).
    assert (R2 : r * r = - q) by (apply sqrt_sqrt; lra).
    exists (fun t => cos (r * t)), (fun t => sin (r * t) / r); split.
    + intro t; auto_derive; [exact I |]; replace q with (- (r * r)) by lra; field; lra.
    + intro t; auto_derive; [lra |]; field; lra.
    + rewrite Rmult_0_r; apply cos_0.
    + rewrite Rmult_0_r, sin_0; field; lra.
    + intros w W t; assert (Rw : Re w = 0 /\ Im w * Im w = r * r).
      { destruct w as [u v]; apply (f_equal fst) in W as A; apply (f_equal snd) in W as B; simpl in *.
        assert (u * v = 0) by lra; destruct (Rmult_integral u v H) as [E | E]; [subst u | subst v; exfalso; nra].
        simpl; split; lra. }
      destruct Rw as [Rw Iw]; assert (V : Im w = r \/ Im w = - r).
      { assert (E : (Im w - r) * (Im w + r) = 0) by nra; apply Rmult_integral in E; lra. }
      rewrite (Cexp_at _ 0 (Im w * t)) by (apply injective_projections; destruct w; simpl in *; rewrite Rw; ring).
      rewrite exp_0; destruct V as [V | V]; apply injective_projections; destruct w as [u v]; simpl in *; rewrite V; simpl;
        rewrite ?Ropp_mult_distr_l_reverse, ?cos_neg, ?sin_neg; rewrite ?Rw; field; lra.
    + intros _ t; apply COS_bound.
    + intro t; apply COS_bound.
    + intro Q; rewrite Rmult_1_r.
      assert (Lr : r < PI) by (apply Rnot_le_lt; intro L; assert (PI * PI <= r * r) by (apply Rmult_le_compat; generalize PI_RGT_0; lra); simpl in Q; lra).
      rewrite <- cos_PI; apply cos_decreasing_1; lra.
    + intros Q t T; apply Rdiv_lt_0_compat; [| exact R0].
      assert (Lr : r < PI) by (apply Rnot_le_lt; intro L; assert (PI * PI <= r * r) by (apply Rmult_le_compat; generalize PI_RGT_0; lra); simpl in Q; lra).
      apply sin_gt_0; nra.
  - set (r := sqrt q); assert (R0 : 0 < r) by (apply sqrt_lt_R0; lra).
    assert (R2 : r * r = q) by (apply sqrt_sqrt; lra).
    assert (One : forall t, 1 <= cosh t) by apply one_le_cosh.
    exists (fun t => cosh (r * t)), (fun t => sinh (r * t) / r); split; try (intros; generalize (One (r * t)); lra).
    + intro t; unfold cosh, sinh; auto_derive; [exact I |]; rewrite <- R2; field; lra.
    + intro t; unfold cosh, sinh; auto_derive; [lra |]; field; lra.
    + rewrite Rmult_0_r; unfold cosh; rewrite Ropp_0, exp_0; field.
    + rewrite Rmult_0_r; unfold sinh; rewrite Ropp_0, exp_0; field; lra.
    + intros w W t; assert (Rw : Im w = 0 /\ Re w * Re w = r * r).
      { destruct w as [u v]; apply (f_equal fst) in W as A; apply (f_equal snd) in W as B; simpl in *.
        assert (u * v = 0) by lra; destruct (Rmult_integral u v H) as [E | E]; [subst u; exfalso; nra | subst v].
        simpl; split; lra. }
      destruct Rw as [Iw Rw]; assert (V : Re w = r \/ Re w = - r).
      { assert (E : (Re w - r) * (Re w + r) = 0) by nra; apply Rmult_integral in E; lra. }
      rewrite (Cexp_at _ (Re w * t) 0) by (apply injective_projections; destruct w; simpl in *; rewrite Iw; ring).
      rewrite cos_0, sin_0; unfold cosh, sinh; destruct V as [V | V]; apply injective_projections; destruct w as [u v]; simpl in *;
        rewrite V; simpl; rewrite ?Ropp_mult_distr_l_reverse, ?Ropp_involutive, ?Iw; field; lra.
    + intros _; generalize (One (r * 1)); lra.
    + intros _ t T; apply Rdiv_lt_0_compat; [| exact R0]; unfold sinh.
      assert (exp (- (r * t)) < exp (r * t)) by (apply exp_increasing; nra); lra.
  - subst q; exists (fun _ => 1), (fun t => t); split; try (intros; lra).
    + intro t; auto_derive; [exact I | ring].
    + intro t; auto_derive; [exact I | reflexivity].
    + intros w W t; assert (E : w = RtoC 0).
      { apply Cmod_eq_0; assert (K := f_equal Cmod W); rewrite Cmod_mult, Cmod_0 in K; nra. }
      rewrite E; rewrite Cexp_nought by ring; ring.
Qed.

(* After a blow the device moves by h = exp(-delta t/2) S(t); the other motions follow from this one. *)
Definition blow (delta : R) (s : R -> R) (t : R) : R := exp (- delta / 2 * t) * s t.
Definition blow_speed (delta : R) (c s : R -> R) (t : R) : R := exp (- delta / 2 * t) * (c t - delta / 2 * s t).
Lemma motions_after : forall gamma delta c s, waves (delta^2 / 4 - gamma) c s ->
  let h := blow delta s in let v := blow_speed delta c s in
  exists x, motions gamma delta (fun t => v t + delta * h t) (fun t => - gamma * h t) h v x h.
Proof.
  intros g d c s W h v.
  assert (H : moves g d 0 h v).
  { intro t; assert (C' : Derive (fun t => c t) t = (d^2 / 4 - g) * s t) by (apply is_derive_unique, (c_slope _ _ _ W)).
    assert (S' : Derive (fun t => s t) t = c t) by (apply is_derive_unique, (s_slope _ _ _ W)).
    assert (ex_derive (fun t => c t) t) by (eexists; apply (c_slope _ _ _ W)).
    assert (ex_derive (fun t => s t) t) by (eexists; apply (s_slope _ _ _ W)).
    unfold h, v, blow, blow_speed; split; auto_derive; try (repeat split; assumption); rewrite ?C', ?S'; field. }
  assert (Dh : forall t, is_derive h t (v t)) by apply H.
  assert (Ch : forall t, continuous h t) by (intro t; apply (ex_derive_continuous h); eexists; apply Dh).
  set (x := fun t => RInt h 0 t).
  assert (Dx : forall t, is_derive x t (h t)).
  { intro t; apply (is_derive_RInt h x 0 t); [| apply Ch].
    exists (mkposreal 1 Rlt_0_1); intros y _; apply (RInt_correct (V := R_CompleteNormedModule)), ex_RInt_continuous; intros z _; apply Ch. }
  assert (h 0 = 0 /\ v 0 = 1) as [h0 v0].
  { unfold h, v, blow, blow_speed; rewrite Rmult_0_r, exp_0, (s_start _ _ _ W), (c_start _ _ _ W); split; ring. }
  assert (X0 : x 0 = 0) by (unfold x; rewrite RInt_point; reflexivity).
  assert (K : forall t, v t + d * h t + g * x t = 1).
  { intro t; replace 1 with (v 0 + d * h 0 + g * x 0) by (rewrite h0, v0, X0; ring).
    apply (constant (fun t => v t + d * h t + g * x t)); intro u.
    evar_last; [apply (is_derive_plus (fun t => v t + d * h t) (fun t => g * x t));
      [apply (is_derive_plus v (fun t => d * h t)); [apply H | apply (is_derive_scal h), Dh] | apply (is_derive_scal x), Dx] |].
    unfold plus; simpl; ring. }
  exists x; split; cbv beta; rewrite ?h0, ?v0, ?X0; try ring; try exact H.
  - intro t; split.
    + evar_last; [apply (is_derive_plus v (fun t => d * h t)); [apply H | apply (is_derive_scal h), Dh] |].
      unfold plus; simpl; ring.
    + evar_last; [apply (is_derive_scal h), Dh | ring].
  - intro t; split; [apply Dx |]; evar_last; [apply Dh |]; specialize (K t); lra.
Qed.
Lemma motions_exist : forall gamma delta, exists x1 v1 x2 v2 x3 v3, motions gamma delta x1 v1 x2 v2 x3 v3.
Proof.
  intros g d; destruct (waves_exist (d^2 / 4 - g)) as (c & s & W), (motions_after g d c s W) as (x & M).
  do 6 eexists; exact M.
Qed.
Theorem device_exists : forall gamma delta, exists n_1 n_0 a e, device gamma delta n_1 n_0 a e.
Proof.
  intros g d; destruct (motions_exist g d) as (x1 & v1 & x2 & v2 & x3 & v3 & M).
  eexists _, _, _, _; exists x1, v1, x2, v2, x3, v3; split; [exact M | repeat split].
Qed.
Lemma motions_unique : forall gamma delta x1 v1 x2 v2 x3 v3 y1 w1 y2 w2 y3 w3,
  motions gamma delta x1 v1 x2 v2 x3 v3 -> motions gamma delta y1 w1 y2 w2 y3 w3 -> forall t, 0 <= t ->
  (x1 t = y1 t /\ v1 t = w1 t) /\ (x2 t = y2 t /\ v2 t = w2 t) /\ (x3 t = y3 t /\ v3 t = w3 t).
Proof.
  intros g d x1 v1 x2 v2 x3 v3 y1 w1 y2 w2 y3 w3 [A A0 A1 B B0 B1 C C0 C1] [D D0 D1 E E0 E1 F F0 F1] t T.
  split; [| split]; [apply (one_motion g d 0 x1 v1 y1 w1) | apply (one_motion g d 0 x2 v2 y2 w2) | apply (one_motion g d 1 x3 v3 y3 w3)];
    congruence || assumption.
Qed.
Theorem device_unique : forall gamma delta n_1 n_0 a e m_1 m_0 b f,
  device gamma delta n_1 n_0 a e -> device gamma delta m_1 m_0 b f -> n_1 = m_1 /\ n_0 = m_0 /\ a = b /\ e = f.
Proof.
  intros g d n1 n0 a e m1 m0 b f (x1 & v1 & x2 & v2 & x3 & v3 & M & A & E & N1 & N0)
    (y1 & w1 & y2 & w2 & y3 & w3 & N & B & F & M1 & M0).
  destruct (motions_unique _ _ _ _ _ _ _ _ _ _ _ _ _ _ M N 1 ltac:(lra)) as ((X1 & V1) & (X2 & V2) & (X3 & V3)).
  rewrite X1, V1, X2, V2, X3, V3 in *; repeat split; congruence.
Qed.

(* The numbers of a device, by a blow: with h and v = h' after one period, and the way x under the force 1. *)
Lemma device_shape : forall gamma delta n_1 n_0 a e, device gamma delta n_1 n_0 a e -> exists c s,
  waves (delta^2 / 4 - gamma) c s /\ let r := exp (- delta / 2) in let h := r * s 1 in let v := r * (c 1 - delta / 2 * s 1) in
  v + delta * h + gamma * n_1 = 1 /\ a = 2 * r * c 1 /\ e = exp (- delta) /\ n_0 = h * h - v * n_1 /\ c 1 * c 1 - (delta^2 / 4 - gamma) * (s 1 * s 1) = 1 /\
  (gamma = 0 -> h + delta * n_1 = 1).
Proof.
  intros g d n1 n0 a e (x1 & v1 & x2 & v2 & x3 & v3 & M & A & E & N1 & N0).
  destruct (waves_exist (d^2 / 4 - g)) as (c & s & W), (motions_after g d c s W) as (x & N).
  destruct (motions_unique _ _ _ _ _ _ _ _ _ _ _ _ _ _ M N 1 ltac:(lra)) as ((X1 & V1) & (X2 & V2) & (X3 & V3)).
  exists c, s; split; [exact W |]; intros r h v.
  assert (Hh : blow d s 1 = h) by (unfold blow, h, r; rewrite Rmult_1_r; reflexivity).
  assert (Hv : blow_speed d c s 1 = v) by (unfold blow_speed, v, r; rewrite Rmult_1_r; reflexivity).
  rewrite Hh, Hv in *; rewrite X1, V1, X2, V2, V3 in *; subst n1.
  assert (One : forall t, c t * c t - (d^2 / 4 - g) * (s t * s t) = 1).
  { intro t; replace 1 with (c 0 * c 0 - (d^2 / 4 - g) * (s 0 * s 0)) by (rewrite (c_start _ _ _ W), (s_start _ _ _ W); ring).
    apply (constant (fun t => c t * c t - (d^2 / 4 - g) * (s t * s t))); intro u.
    assert (C' : Derive (fun t => c t) u = (d^2 / 4 - g) * s u) by (apply is_derive_unique, (c_slope _ _ _ W)).
    assert (S' : Derive (fun t => s t) u = c u) by (apply is_derive_unique, (s_slope _ _ _ W)).
    assert (ex_derive (fun t => c t) u) by (eexists; apply (c_slope _ _ _ W)).
    assert (ex_derive (fun t => s t) u) by (eexists; apply (s_slope _ _ _ W)).
    auto_derive; [repeat split; assumption | rewrite C', S'; field]. }
  specialize (One 1); assert (R2 : r * r = exp (- d)) by (unfold r; rewrite <- exp_plus; f_equal; field).
  split; [| split; [| split; [| split; [| split]]]]; [| | | | exact One |].
  - (* the force is held by the spring, the damper and the mass *)
    assert (K : forall t, blow_speed d c s t + d * blow d s t + g * x t = 1).
    { intro t; replace 1 with (blow_speed d c s 0 + d * blow d s 0 + g * x 0).
      2: { rewrite (second_place _ _ _ _ _ _ _ _ N), (second_speed _ _ _ _ _ _ _ _ N), (third_place _ _ _ _ _ _ _ _ N); ring. }
      apply (constant (fun t => blow_speed d c s t + d * blow d s t + g * x t)); intro u.
      destruct (second _ _ _ _ _ _ _ _ N u) as [P Q], (third _ _ _ _ _ _ _ _ N u) as [T _].
      evar_last; [apply (is_derive_plus (fun t => blow_speed d c s t + d * blow d s t) (fun t => g * x t));
        [apply (is_derive_plus (blow_speed d c s) (fun t => d * blow d s t)); [exact Q | apply (is_derive_scal (blow d s)), P] | apply (is_derive_scal x), T] |].
      unfold plus; simpl; ring. }
    specialize (K 1); rewrite Hh, Hv, <- X3 in K; exact K.
  - rewrite A; unfold h, v; field.
  - rewrite E, <- R2; unfold h, v; replace (r * r) with (r * r * (c 1 * c 1 - (d^2 / 4 - g) * (s 1 * s 1))) by (rewrite One; ring); field.
  - rewrite N0; ring.
  - intro G; assert (K : forall t, blow d s t + d * x t - t = 0).
    { intro t; replace 0 with (blow d s 0 + d * x 0 - 0) by (rewrite (second_place _ _ _ _ _ _ _ _ N), (third_place _ _ _ _ _ _ _ _ N); ring).
      apply (constant (fun t => blow d s t + d * x t - t)); intro u; destruct (third _ _ _ _ _ _ _ _ N u) as [P Q].
      evar_last; [apply (is_derive_minus (fun t => blow d s t + d * x t) (fun t => t));
        [apply (is_derive_plus (blow d s) (fun t => d * x t)); [exact Q | apply (is_derive_scal x), P] | apply is_derive_id] |].
      rewrite G; unfold minus, plus, opp, one; simpl; ring. }
    specialize (K 1); rewrite Hh, <- X3 in K; lra.
Qed.

(* Under the held force gamma x the device stays at x = 1. *)
Theorem device_at_rest : forall gamma delta n_1 n_0 a e, device gamma delta n_1 n_0 a e -> - a + e + 1 = gamma * (n_0 + n_1).
Proof.
  intros g d n1 n0 a e V; destruct (device_shape _ _ _ _ _ _ V) as (c & s & W & K & A & E & N & One & _).
  set (r := exp (- d / 2)) in *; set (h := r * s 1) in *; set (v := r * (c 1 - d / 2 * s 1)) in *.
  assert (R2 : e = r * r) by (rewrite E; unfold r; rewrite <- exp_plus; f_equal; field).
  assert (Ae : a = 2 * v + d * h) by (rewrite A; unfold v, h; field).
  assert (Ee : e = v * v + d * h * v + g * (h * h)).
  { rewrite R2; unfold v, h; transitivity (r * r * (c 1 * c 1 - (d^2 / 4 - g) * (s 1 * s 1))); [rewrite One; ring | field]. }
  rewrite Ae, Ee, N; replace (g * (h * h - v * n1 + n1)) with (g * (h * h) + g * n1 * (1 - v)) by ring.
  replace (g * n1) with (1 - v - d * h) by lra; ring.
Qed.
Theorem device_loss : forall gamma delta n_1 n_0 a e, device gamma delta n_1 n_0 a e -> e = exp (- delta).
Proof. intros g d n1 n0 a e V; destruct (device_shape _ _ _ _ _ _ V) as (c & s & _ & _ & _ & E & _); exact E. Qed.
(* Its poles are exp(-delta/2) times exp(w) and exp(-w) with w^2 = delta^2/4 - gamma. *)
Theorem device_poles : forall gamma delta n_1 n_0 a e (w : C), device gamma delta n_1 n_0 a e ->
  (w * w)%C = RtoC (delta^2 / 4 - gamma) -> RtoC a = (RtoC (exp (- delta / 2)) * (Cexp w + Cexp (- w)))%C.
Proof.
  intros g d n1 n0 a e w V Q; destruct (device_shape _ _ _ _ _ _ V) as (c & s & W & _ & A & _).
  assert (P := as_exponential _ _ _ W w Q 1); assert (M := as_exponential _ _ _ W (- w)%C ltac:(rewrite <- Q; ring) 1).
  replace (w * 1)%C with w in P by ring; replace (- w * 1)%C with (- w)%C in M by ring.
  rewrite P, M, A, !RtoC_mult; ring.
Qed.
Lemma a_above : forall gamma delta n_1 n_0 a e, device gamma delta n_1 n_0 a e ->
  -2 * exp (- delta / 2) <= a /\ (gamma - delta^2 / 4 < PI^2 -> -2 * exp (- delta / 2) < a).
Proof.
  intros g d n1 n0 a e V; destruct (device_shape _ _ _ _ _ _ V) as (c & s & W & _ & A & _).
  assert (P := exp_pos (- d / 2)); rewrite A; split; [generalize (c_above _ _ _ W 1) | intro T; generalize (c_turns _ _ _ W ltac:(lra))]; nra.
Qed.
Theorem device_turns : forall gamma delta n_1 n_0 a e,
  device gamma delta n_1 n_0 a e /\ gamma - delta^2 / 4 < PI^2 -> -2 * exp (- delta / 2) < a.
Proof. intros g d n1 n0 a e [V T]; exact (proj2 (a_above _ _ _ _ _ _ V) T). Qed.
Lemma a_below : forall gamma delta n_1 n_0 a e, device gamma delta n_1 n_0 a e -> 0 < gamma -> 0 < delta -> a < 1 + e.
Proof.
  intros g d n1 n0 a e V G D; destruct (device_shape _ _ _ _ _ _ V) as (c & s & W & _ & A & E & _).
  set (r := exp (- d / 2)) in *; assert (P : 0 < r) by apply exp_pos.
  assert (R2 : e = r * r) by (rewrite E; unfold r; rewrite <- exp_plus; f_equal; field).
  assert (R1 : r < 1) by (rewrite <- exp_0; apply exp_increasing; lra).
  destruct (Rlt_le_dec 0 (d^2 / 4 - g)) as [Q | Q].
  - set (w := sqrt (d^2 / 4 - g)); assert (Pw : 0 < w) by (apply sqrt_lt_R0, Q).
    assert (W2 : w * w = d^2 / 4 - g) by (apply sqrt_sqrt; lra); assert (Lw : w < d / 2) by nra.
    assert (Z := device_poles _ _ _ _ _ _ (RtoC w) V ltac:(rewrite <- RtoC_mult, W2; reflexivity)).
    rewrite (Cexp_at _ w 0), (Cexp_at _ (- w) 0) in Z by (apply injective_projections; simpl; ring).
    apply (f_equal fst) in Z; simpl in Z; rewrite cos_0, sin_0 in Z; fold r in Z.
    assert (U : r * exp w < 1).
    { unfold r; rewrite <- exp_plus, <- exp_0; apply exp_increasing; lra. }
    assert (U' : r * exp (- w) < 1).
    { unfold r; rewrite <- exp_plus, <- exp_0; apply exp_increasing; lra. }
    assert (Pr : (r * exp w) * (r * exp (- w)) = r * r).
    { replace ((r * exp w) * (r * exp (- w))) with (r * r * (exp w * exp (- w))) by ring.
      rewrite <- exp_plus, Rplus_opp_r, exp_0; ring. }
    assert (0 < (1 - r * exp w) * (1 - r * exp (- w))) by (apply Rmult_lt_0_compat; lra).
    rewrite R2; nra.
  - assert (L := c_below _ _ _ W Q 1); rewrite A, R2; nra.
Qed.
(* A damped device gives way to a held force. *)
Theorem device_pushed : forall gamma delta n_1 n_0 a e,
  device gamma delta n_1 n_0 a e /\ 0 <= gamma /\ 0 < delta -> 0 < n_0 + n_1.
Proof.
  intros g d n1 n0 a e (V & [G | G] & D).
  - assert (B := a_below _ _ _ _ _ _ V G D); assert (R := device_at_rest _ _ _ _ _ _ V); nra.
  - subst g; assert (E := device_loss _ _ _ _ _ _ V); assert (Rest := device_at_rest _ _ _ _ _ _ V).
    destruct (device_shape _ _ _ _ _ _ V) as (c & s & W & K & A & _ & N & _ & Free).
    set (r := exp (- d / 2)) in *; set (h := r * s 1) in *; set (v := r * (c 1 - d / 2 * s 1)) in *.
    assert (Ae : a = 2 * v + d * h) by (rewrite A; unfold v, h; field).
    assert (Ee : v = e) by lra.
    assert (e < 1) by (rewrite E, <- exp_0; apply exp_increasing; lra).
    assert (Ph : 0 < h) by nra; specialize (Free eq_refl).
    replace (n0 + n1) with (h * h + n1 * (1 - v)) by (rewrite N; ring).
    replace (1 - v) with (d * h) by lra; replace (h * h + n1 * (d * h)) with (h * (h + d * n1)) by ring.
    rewrite Free; lra.
Qed.
Lemma quadratic : forall a e, -1 < e < 1 -> a < 1 + e -> - a < 1 + e -> stable (fun z => - a * z + e + z^2)%C.
Proof.
  intros a e E A B [x y] Z; apply (f_equal fst) in Z as X; apply (f_equal snd) in Z as Y; simpl in X, Y.
  apply Rnot_le_lt; intro L.
  assert (Q : 1 <= x * x + y * y).
  { assert (S := Cmod_square (x, y)); unfold Re, Im in S; simpl in S; nra. }
  assert (F : y * (2 * x - a) = 0) by lra; apply Rmult_integral in F; destruct F as [F | F].
  - subst y; assert (P : x * x - a * x + e = 0) by lra; clear - E A B Q P; assert (1 <= x \/ x <= -1).
    { destruct (Rle_dec 0 x); [left | right]; nra. }
    destruct H; nra.
  - assert (a = 2 * x) by lra; subst a; nra.
Qed.
(* Without a force a device with a spring and a damper comes to rest. *)
Theorem device_forgets : forall gamma delta n_1 n_0 a e,
  device gamma delta n_1 n_0 a e /\ 0 < gamma /\ 0 < delta -> stable (fun z => - a * z + e + z^2)%C.
Proof.
  intros g d n1 n0 a e (V & G & D); assert (E := device_loss _ _ _ _ _ _ V).
  assert (R1 : exp (- d) < 1) by (rewrite <- exp_0; apply exp_increasing; lra); assert (P := exp_pos (- d)).
  assert (R2 : exp (- d) = exp (- d / 2) * exp (- d / 2)) by (rewrite <- exp_plus; f_equal; field).
  assert (P2 := exp_pos (- d / 2)); apply quadratic; [lra | exact (a_below _ _ _ _ _ _ V G D) |].
  generalize (proj1 (a_above _ _ _ _ _ _ V)); nra.
Qed.
Theorem free_mass : forall n_1 n_0 a e, device 0 0 n_1 n_0 a e -> n_1 = 1 / 2.
Proof.
  intros n1 n0 a e (x1 & v1 & x2 & v2 & x3 & v3 & M & _ & _ & N & _); rewrite N.
  destruct (one_motion 0 0 1 x3 v3 (fun t => t * t / 2) (fun t => t)) with (t := 1) as [E _]; try lra.
  - apply (third _ _ _ _ _ _ _ _ M).
  - intro t; split; auto_derive; [exact I | field | exact I | ring].
  - rewrite (third_place _ _ _ _ _ _ _ _ M); field.
  - rewrite (third_speed _ _ _ _ _ _ _ _ M); reflexivity.
Qed.
Theorem undamped_device : forall x n_1 n_0 a e, device (x^2) 0 n_1 n_0 a e -> a = 2 * cos x /\ n_1 = n_0.
Proof.
  intros x n1 n0 a e V; destruct (device_shape _ _ _ _ _ _ V) as (c & s & W & K & A & E & N & One & Free).
  replace (- 0 / 2) with 0 in * by field; rewrite exp_0 in *.
  assert (C1 : c 1 = cos x).
  { assert (P := as_exponential _ _ _ W (Ci * RtoC x)%C ltac:(apply injective_projections; simpl; field) 1).
    replace (Ci * x * 1)%C with (Ci * x)%C in P by ring; rewrite turned in P; apply (f_equal fst) in P; simpl in P; lra. }
  split; [rewrite A, C1; ring |].
  set (v := 1 * (c 1 - 0 / 2 * s 1)) in *; set (h := 1 * s 1) in *.
  assert (V2 : v * v + x^2 * (h * h) = 1) by (rewrite <- One; unfold v, h; field).
  destruct (Req_dec x 0) as [Z | Z].
  - subst x; specialize (Free ltac:(ring)); replace (0 ^ 2) with 0 in * by ring; rewrite (free_mass _ _ _ _ V) in *.
    assert (h = 1) by lra; assert (v = 1) by lra; rewrite N; replace h with 1; replace v with 1; lra.
  - assert (P : x^2 <> 0) by (apply pow_nonzero; exact Z).
    assert (F : x^2 * (h * h - n1 * (1 + v)) = 0) by (replace (x^2 * (h * h - n1 * (1 + v))) with (x^2 * (h * h) - x^2 * n1 * (1 + v)) by ring;
      replace (x^2 * n1) with (1 - v) by lra; lra).
    apply Rmult_integral in F; destruct F as [F | F]; [contradiction |]; rewrite N; lra.
Qed.

(* -- a late force ---------------------------------------------------------------------------- *)

(* The same device, where each held force begins and ends a share u of a period late: it moves as it is
   for 1 - u under the new force, after u under the last one. *)
Definition late_device (gamma delta u m_2 m_1 m_0 a e : R) : Prop :=
  0 <= u <= 1 /\ exists x1 v1 x2 v2 x3 v3, motions gamma delta x1 v1 x2 v2 x3 v3 /\
    let x := x3 (1 - u) in let v := v3 (1 - u) in
    let y := x1 (1 - u) * x3 u + x2 (1 - u) * v3 u in let w := v1 (1 - u) * x3 u + v2 (1 - u) * v3 u in
    a = x1 1 + v2 1 /\ e = x1 1 * v2 1 - x2 1 * v1 1 /\
    m_2 = x /\ m_1 = x2 1 * v - v2 1 * x + y /\ m_0 = x2 1 * w - v2 1 * y.
(* What a force does in two periods one after the other. *)
Lemma moves_later : forall gamma delta F x v s, moves gamma delta F x v -> moves gamma delta F (fun t => x (s + t)) (fun t => v (s + t)).
Proof.
  intros g d F x v s M t; destruct (M (s + t)) as [A B]; split.
  - evar_last; [apply (is_derive_comp x (fun t => s + t)); [exact A |] |].
    + apply (is_derive_plus (fun _ => s) (fun t => t)); [apply is_derive_const | apply is_derive_id].
    + unfold scal, plus, zero, one; simpl; unfold mult; simpl; ring.
  - evar_last; [apply (is_derive_comp v (fun t => s + t)); [exact B |] |].
    + apply (is_derive_plus (fun _ => s) (fun t => t)); [apply is_derive_const | apply is_derive_id].
    + unfold scal, plus, zero, one; simpl; unfold mult; simpl; ring.
Qed.
Lemma moves_sum : forall gamma delta x1 v1 x2 v2 x3 v3 (p q : R), motions gamma delta x1 v1 x2 v2 x3 v3 ->
  moves gamma delta 1 (fun t => x3 t + p * x1 t + q * x2 t) (fun t => v3 t + p * v1 t + q * v2 t).
Proof.
  intros g d x1 v1 x2 v2 x3 v3 p q M t.
  destruct (first _ _ _ _ _ _ _ _ M t) as [A1 B1], (second _ _ _ _ _ _ _ _ M t) as [A2 B2], (third _ _ _ _ _ _ _ _ M t) as [A3 B3].
  split.
  - evar_last; [apply (is_derive_plus (fun t => x3 t + p * x1 t) (fun t => q * x2 t));
      [apply (is_derive_plus x3 (fun t => p * x1 t)); [exact A3 | apply (is_derive_scal x1), A1] | apply (is_derive_scal x2), A2] |].
    unfold plus; simpl; ring.
  - evar_last; [apply (is_derive_plus (fun t => v3 t + p * v1 t) (fun t => q * v2 t));
      [apply (is_derive_plus v3 (fun t => p * v1 t)); [exact B3 | apply (is_derive_scal v1), B1] | apply (is_derive_scal v2), B2] |].
    unfold plus; simpl; ring.
Qed.
Lemma two_parts : forall gamma delta x1 v1 x2 v2 x3 v3 s t, motions gamma delta x1 v1 x2 v2 x3 v3 -> 0 <= t ->
  x3 (s + t) = x3 t + x3 s * x1 t + v3 s * x2 t /\ v3 (s + t) = v3 t + x3 s * v1 t + v3 s * v2 t.
Proof.
  intros g d x1 v1 x2 v2 x3 v3 s t M T.
  assert (L := moves_later _ _ _ _ _ s (third _ _ _ _ _ _ _ _ M)); assert (S := moves_sum _ _ _ _ _ _ _ _ (x3 s) (v3 s) M).
  destruct M as [A A0 A1 B B0 B1 C C0 C1].
  apply (one_motion g d 1 _ _ _ _ L S); cbv beta; [rewrite Rplus_0_r, A0, B0, C0; ring | rewrite Rplus_0_r, A1, B1, C1; ring | exact T].
Qed.
Theorem late_device_exists : forall gamma delta u, 0 <= u /\ u <= 1 -> exists m_2 m_1 m_0 n_1 n_0 a e,
  late_device gamma delta u m_2 m_1 m_0 a e /\ device gamma delta n_1 n_0 a e.
Proof.
  intros g d u [U V]; destruct (motions_exist g d) as (x1 & v1 & x2 & v2 & x3 & v3 & M).
  do 7 eexists; split; [split; [split; [exact U | exact V] |] |]; exists x1, v1, x2, v2, x3, v3; (split; [exact M | repeat split]).
Qed.
Theorem late_device_and_device : forall gamma delta u m_2 m_1 m_0 n_1 n_0 a e b f,
  late_device gamma delta u m_2 m_1 m_0 a e -> device gamma delta n_1 n_0 b f ->
  m_2 + m_1 + m_0 = n_1 + n_0 /\ a = b /\ e = f /\
  (u = 0 -> m_2 = n_1 /\ m_1 = n_0 /\ m_0 = 0) /\ (u = 1 -> m_2 = 0 /\ m_1 = n_1 /\ m_0 = n_0).
Proof.
  intros g d u m2 m1 m0 n1 n0 a e b f (U & x1 & v1 & x2 & v2 & x3 & v3 & M & A & E & M2 & M1 & M0)
    (y1 & w1 & y2 & w2 & y3 & w3 & N & B & F & N1 & N0).
  destruct (motions_unique _ _ _ _ _ _ _ _ _ _ _ _ _ _ N M 1 ltac:(lra)) as ((X1 & V1) & (X2 & V2) & (X3 & V3)).
  rewrite X1, V1, X2, V2, X3, V3 in *; clear N X1 V1 X2 V2 X3 V3 y1 w1 y2 w2 y3 w3.
  destruct (two_parts _ _ _ _ _ _ _ _ u (1 - u) M ltac:(lra)) as [X V]; replace (u + (1 - u)) with 1 in X, V by ring.
  destruct M as [_ P1 Q1 _ P2 Q2 _ P3 Q3]; repeat split; try congruence; try (subst u; replace (1 - 0) with 1 in * by ring; replace (1 - 1) with 0 in * by ring).
  - rewrite M2, M1, M0, N1, N0, X, V; ring.
  - rewrite M2, N1; reflexivity.
  - rewrite M1, N0, P3, Q3; ring.
  - rewrite M0, P3, Q3; ring.
  - rewrite M2; exact P3.
  - rewrite M1, N1, P1, P2, P3, Q3; ring.
  - rewrite M0, N0, P1, P2, Q1, Q2; ring.
Qed.

Theorem undamped_late_device : forall x u m_2 m_1 m_0 a e, late_device (x^2) 0 u m_2 m_1 m_0 a e ->
  x^2 * m_2 = 1 - cos (x * (1 - u)) /\ x^2 * (m_1 + (1 + a) * m_2) = 1 - cos (x * (2 - u)).
Proof.
  intros x u m2 m1 m0 a e (U & x1 & v1 & x2 & v2 & x3 & v3 & M & A & E & M2 & M1 & M0).
  assert (K : forall t, 0 <= t -> x^2 * x3 t = 1 - cos (x * t)).
  { intros t T; destruct (one_motion (x^2) 0 (x^2) (fun t => x^2 * x3 t) (fun t => x^2 * v3 t)
      (fun t => 1 - cos (x * t)) (fun t => x * sin (x * t))) with (t := t) as [H _]; try exact H; try exact T.
    - intro s; destruct (third _ _ _ _ _ _ _ _ M s) as [P Q]; split; (evar_last; [apply is_derive_scal; eassumption | simpl; ring]).
    - intro s; split; auto_derive; [exact I | ring | exact I | ring].
    - cbv beta; rewrite (third_place _ _ _ _ _ _ _ _ M), !Rmult_0_r, cos_0; ring.
    - cbv beta; rewrite (third_speed _ _ _ _ _ _ _ _ M), !Rmult_0_r, sin_0; ring. }
  cbv zeta in *; assert (Two : m1 + (1 + a) * m2 = x3 (2 - u)).
  { destruct (two_parts _ _ _ _ _ _ _ _ u (1 - u) M ltac:(lra)) as [X V], (two_parts _ _ _ _ _ _ _ _ (1 - u) 1 M ltac:(lra)) as [Y _].
    replace (1 - u + 1) with (2 - u) in Y by ring; replace (u + (1 - u)) with 1 in X by ring.
    rewrite M1, M2, A, Y, X; ring. }
  split; [rewrite M2; apply K; lra | rewrite Two; apply K; lra].
Qed.
Theorem free_late_mass : forall u m_2 m_1 m_0 a e, late_device 0 0 u m_2 m_1 m_0 a e ->
  m_2 = (1 - u) ^ 2 / 2 /\ m_1 + (1 + a) * m_2 = (2 - u) ^ 2 / 2.
Proof.
  intros u m2 m1 m0 a e (U & x1 & v1 & x2 & v2 & x3 & v3 & M & A & E & M2 & M1 & M0).
  assert (K : forall t, 0 <= t -> x3 t = t ^ 2 / 2).
  { intros t T; destruct (one_motion 0 0 1 x3 v3 (fun t => t ^ 2 / 2) (fun t => t)) with (t := t) as [H _]; try exact H; try exact T.
    - apply (third _ _ _ _ _ _ _ _ M).
    - intro s; split; auto_derive; [exact I | field | exact I | ring].
    - rewrite (third_place _ _ _ _ _ _ _ _ M); field.
    - rewrite (third_speed _ _ _ _ _ _ _ _ M); reflexivity. }
  cbv zeta in *; assert (Two : m1 + (1 + a) * m2 = x3 (2 - u)).
  { destruct (two_parts _ _ _ _ _ _ _ _ u (1 - u) M ltac:(lra)) as [X V], (two_parts _ _ _ _ _ _ _ _ (1 - u) 1 M ltac:(lra)) as [Y _].
    replace (1 - u + 1) with (2 - u) in Y by ring; replace (u + (1 - u)) with 1 in X by ring.
    rewrite M1, M2, A, Y, X; ring. }
  split; [rewrite M2; apply K; lra | rewrite Two; apply K; lra].
Qed.

(* -- after a blow ------------------------------------------------------------------------------ *)

(* With h and v after a blow, x under the force 1: what these obey at all times. *)
Lemma moves_back : forall gamma delta F x v, moves gamma delta F x v ->
  moves gamma (- delta) F (fun t => x (- t)) (fun t => - v (- t)).
Proof.
  intros g d F x v M t; destruct (M (- t)) as [A B].
  assert (N : is_derive (fun t : R => - t) t (-1)) by (auto_derive; [exact I | ring]).
  split.
  - evar_last; [apply (is_derive_comp x (fun t => - t)); [exact A | exact N] |].
    unfold scal; simpl; unfold mult; simpl; ring.
  - evar_last; [apply (is_derive_opp (fun t => v (- t))), (is_derive_comp v (fun t => - t)); [exact B | exact N] |].
    unfold scal, opp; simpl; unfold mult; simpl; ring.
Qed.
Lemma one_motion_always : forall gamma delta F x v y w, moves gamma delta F x v -> moves gamma delta F y w ->
  x 0 = y 0 -> v 0 = w 0 -> forall t, x t = y t /\ v t = w t.
Proof.
  intros g d F x v y w M N X V t; destruct (Rle_dec 0 t) as [T | T]; [exact (one_motion g d F x v y w M N X V t T) |].
  destruct (one_motion g (- d) F _ _ _ _ (moves_back _ _ _ _ _ M) (moves_back _ _ _ _ _ N)) with (t := - t) as [A B];
    rewrite ?Ropp_0, ?Ropp_involutive in *; try lra; split; lra.
Qed.
(* With h and v after a blow, x under the force 1: what these obey at all times. *)
Lemma held_force : forall gamma delta x1 v1 x2 v2 x3 v3, motions gamma delta x1 v1 x2 v2 x3 v3 ->
  forall t, v3 t = x2 t /\ v2 t + delta * x2 t + gamma * x3 t = 1 /\
    v2 t * v2 t + delta * x2 t * v2 t + gamma * (x2 t * x2 t) = exp (- delta * t).
Proof.
  intros g d x1 v1 x2 v2 x3 v3 [_ _ _ B B0 B1 C C0 C1] t.
  assert (S : moves g d 0 v3 (fun t => 1 - d * v3 t - g * x3 t)).
  { intro u; destruct (C u) as [P Q]; split; [exact Q |].
    evar_last; [apply (is_derive_minus (fun t => 1 - d * v3 t) (fun t => g * x3 t));
      [apply (is_derive_minus (fun _ => 1) (fun t => d * v3 t)); [apply is_derive_const | apply (is_derive_scal v3), Q] | apply (is_derive_scal x3), P] |].
    unfold minus, plus, opp, zero; simpl; ring. }
  destruct (one_motion_always g d 0 _ _ _ _ S B) with (t := t) as [E F]; [rewrite B0; exact C1 | rewrite B1, C0, C1; ring |].
  split; [exact E |]; split; [rewrite <- E, <- F; ring |].
  assert (W : forall u, is_derive (fun t => (v2 t * v2 t + d * x2 t * v2 t + g * (x2 t * x2 t)) * exp (d * t)) u 0).
  { intro u; destruct (B u) as [P Q].
    assert (P' : Derive (fun t => x2 t) u = v2 u) by (apply is_derive_unique; exact P).
    assert (Q' : Derive (fun t => v2 t) u = 0 - d * v2 u - g * x2 u) by (apply is_derive_unique; exact Q).
    auto_derive; [repeat split; eexists; eassumption | rewrite P', Q'; ring]. }
  assert (K := constant _ W t); simpl in K; rewrite B0, B1, Rmult_0_r, exp_0 in K.
  assert (P := exp_pos (d * t)); apply Rmult_eq_reg_r with (exp (d * t)); [| lra].
  rewrite K, <- exp_plus; replace (- d * t + d * t) with 0 by ring; rewrite exp_0; ring.
Qed.
(* The motion h^2 - v x, under the force exp(-delta t) from rest: at 1 it is at n_0. *)
Lemma fading_force : forall gamma delta x1 v1 x2 v2 x3 v3, motions gamma delta x1 v1 x2 v2 x3 v3 ->
  let w := fun t => x2 t * x2 t - v2 t * x3 t in let s := fun t => x2 t - delta * w t in
  forall t, is_derive w t (s t) /\ is_derive s t (exp (- delta * t) - delta * s t - gamma * w t).
Proof.
  intros g d x1 v1 x2 v2 x3 v3 M w s t; destruct (held_force _ _ _ _ _ _ _ _ M t) as (E & F & G).
  assert (V : v2 t = 1 - d * x2 t - g * x3 t) by lra.
  destruct (second _ _ _ _ _ _ _ _ M t) as [P Q], (third _ _ _ _ _ _ _ _ M t) as [T _].
  assert (P' : Derive (fun t => x2 t) t = v2 t) by (apply is_derive_unique; exact P).
  assert (Q' : Derive (fun t => v2 t) t = 0 - d * v2 t - g * x2 t) by (apply is_derive_unique; exact Q).
  assert (T' : Derive (fun t => x3 t) t = v3 t) by (apply is_derive_unique; exact T).
  assert (W : is_derive w t (s t)).
  { unfold w, s; auto_derive; [repeat split; eexists; eassumption | rewrite P', Q', T', E, V; unfold w; rewrite ?V; ring]. }
  split; [exact W |].
  evar_last; [apply (is_derive_minus x2 (fun t => d * w t)); [exact P | apply (is_derive_scal w), W] |].
  unfold minus, plus, opp; simpl; unfold s, w; rewrite <- G, V; ring.
Qed.
(* Where a term is positive while the force lasts, so is what it moves: by u -> x (v + delta h) + v h at
   u and 1 - u, which increases from 0 to x(1); h is positive up to half a turn. *)
Theorem after_a_blow : forall gamma delta n_1 n_0 a e, device gamma delta n_1 n_0 a e -> gamma - delta^2 / 4 < PI^2 ->
  forall (p q : R) (f f1 f2 : R -> R), (forall t, is_derive f t (f1 t)) -> (forall t, is_derive f1 t (f2 t)) -> f 0 = 0 -> f1 0 = 0 ->
  let k := fun t => p + q * exp (- delta * t) - (f2 t + delta * f1 t + gamma * f t) in
  ((forall t, 0 < t < 1 -> 0 < k t) -> 0 < p * n_1 + q * n_0 - f 1) /\
  ((forall t, 0 < t < 1 -> 0 <= k t) -> 0 <= p * n_1 + q * n_0 - f 1).
Proof.
  intros g d n1 n0 a e (x1 & v1 & x2 & v2 & x3 & v3 & M & _ & _ & N1 & N0) Turn p q f f1 f2 F F1 Z Z1 k.
  assert (H : forall t, 0 < t <= 1 -> 0 < x2 t).
  { intros t T; destruct (waves_exist (d^2 / 4 - g)) as (c & s & W), (motions_after g d c s W) as (x & N).
    destruct (motions_unique _ _ _ _ _ _ _ _ _ _ _ _ _ _ M N t ltac:(lra)) as (_ & (E & _) & _); rewrite E; unfold blow.
    apply Rmult_lt_0_compat; [apply exp_pos | apply (s_above _ _ _ W); lra]. }
  set (w := fun t => x2 t * x2 t - v2 t * x3 t); set (y := fun t => x2 t - d * w t).
  assert (Fd := fading_force _ _ _ _ _ _ _ _ M); cbv zeta in Fd; fold w y in Fd.
  assert (D0 := second_place _ _ _ _ _ _ _ _ M); assert (D1 := second_speed _ _ _ _ _ _ _ _ M).
  assert (D2 := third_place _ _ _ _ _ _ _ _ M); assert (D3 := third_speed _ _ _ _ _ _ _ _ M).
  set (D := fun t => p * x3 t + q * w t - f t); set (D' := fun t => p * v3 t + q * y t - f1 t).
  set (m := fun u => D u * (v2 (1 - u) + d * x2 (1 - u)) + D' u * x2 (1 - u)).
  assert (S : forall u, is_derive m u (k u * x2 (1 - u))).
  { intro u; destruct (Fd u) as [A B], (third _ _ _ _ _ _ _ _ M u) as [A3 B3].
    destruct (second _ _ _ _ _ _ _ _ M (1 - u)) as [P Q].
    assert (E1 : Derive (fun t => x3 t) u = v3 u) by (apply is_derive_unique; exact A3).
    assert (E2 : Derive (fun t => v3 t) u = 1 - d * v3 u - g * x3 u) by (apply is_derive_unique; exact B3).
    assert (E3 : Derive (fun t => w t) u = y u) by (apply is_derive_unique; exact A).
    assert (E4 : Derive (fun t => y t) u = exp (- d * u) - d * y u - g * w u) by (apply is_derive_unique; exact B).
    assert (E5 : Derive (fun t => f t) u = f1 u) by (apply is_derive_unique, F).
    assert (E6 : Derive (fun t => f1 t) u = f2 u) by (apply is_derive_unique, F1).
    assert (E7 : Derive (fun t => x2 t) (1 - u) = v2 (1 - u)) by (apply is_derive_unique; exact P).
    assert (E8 : Derive (fun t => v2 t) (1 - u) = 0 - d * v2 (1 - u) - g * x2 (1 - u)) by (apply is_derive_unique; exact Q).
    assert (ex_derive (fun t => f t) u) by (eexists; apply F); assert (ex_derive (fun t => f1 t) u) by (eexists; apply F1).
    clearbody w y; unfold m, D, D', k; auto_derive; [repeat split; try assumption; eexists; eassumption |].
    rewrite E1, E2, E3, E4, E5, E6; unfold Rminus in E7, E8 |- *; rewrite E7, E8; ring. }
  assert (M0 : m 0 = 0) by (unfold m, D, D', w, y, w; rewrite D0, D2, D3, Z, Z1; ring).
  assert (M1 : m 1 = p * n1 + q * n0 - f 1).
  { unfold m; replace (1 - 1) with 0 by ring; rewrite D0, D1; unfold D, w; rewrite N1, N0.
    destruct (held_force _ _ _ _ _ _ _ _ M 1) as (E & _); rewrite E; ring. }
  rewrite <- M1; split; intro K.
  - destruct (MVT_cor2 m (fun u => k u * x2 (1 - u)) 0 1 ltac:(lra)) as (c & E & C).
    { intros u _; apply is_derive_Reals, S. }
    assert (0 < k c * x2 (1 - c)) by (apply Rmult_lt_0_compat; [apply K | apply H]; lra); lra.
  - destruct (MVT_cor2 m (fun u => k u * x2 (1 - u)) 0 1 ltac:(lra)) as (c & E & C).
    { intros u _; apply is_derive_Reals, S. }
    assert (0 <= k c * x2 (1 - c)) by (apply Rmult_le_pos; [apply K | apply Rlt_le, H]; lra); lra.
Qed.
