(* What a device answers to a held force z^k: the one motion that turns by z from period to period; Coddington and
   Levinson, Theory of Ordinary Differential Equations, 1.8 and 3.1. *)
From Symhaptic Require Export Steady.
Open Scope R_scope.

(* m x'' + b x' + k x = 1 in complex numbers. *)
Definition pushed (m b k : R) (x v : R -> C) : Prop :=
  moves (k / m) (b / m) (/ m) (fun t => Re (x t)) (fun t => Re (v t)) /\
  moves (k / m) (b / m) 0 (fun t => Im (x t)) (fun t => Im (v t)).
(* After the time p, place and speed are z times what they were. *)
Definition turns (z : C) (p : R) (x v : R -> C) : Prop := x p = (z * x 0)%C /\ v p = (z * v 0)%C.
(* P(s) = exp(-t s)/(m s^2 + b s + k). *)
Definition transfers (P : C -> C) (m b k t : R) : Prop :=
  forall s, (m * s^2 + b * s + k)%C <> RtoC 0 -> P s = (Cexp (- s * t) / (m * s^2 + b * s + k))%C.
(* A force z^k is held from k p + t to (k + 1) p + t.  There is one motion that turns by z; while the force is 1,
   from t on, it is x.  The place at sample i - j is X z^(i - j), and this sample is taken meanwhile. *)
Definition answers (P : C -> C) (z X T : C) : Prop :=
  exists m b k t p : R, m <> 0 /\ 0 < p /\ T = RtoC p /\ transfers P m b k t /\ z <> RtoC 0 /\
  exists x v, pushed m b k x v /\ turns z p x v /\
    (forall y w, pushed m b k y w -> turns z p y w -> y 0 = x 0 /\ w 0 = v 0) /\
    exists i j : nat, 0 <= (INR i - INR j) * p - t <= p /\ (z^j * x ((INR i - INR j) * p - t)%R = z^i * X)%C.

Theorem answer_turns : forall P z X T, answers P z X T -> z <> RtoC 0.
Proof. intros P z X T (m & b & k & t & p & _ & _ & _ & _ & Z & _); exact Z. Qed.
Lemma power_there : forall z n, z <> RtoC 0 -> (z ^ n)%C <> RtoC 0.
Proof. intros z n Z; induction n as [| n IH]; simpl; [apply Cnot_zero; lra | apply Cmult_neq_0; assumption]. Qed.
(* A force that comes n periods later. *)
Theorem answer_later : forall P Q z X (T : R) n, (forall s, Q s = (Cexp (- s * (INR n * T)) * P s)%C) ->
  (answers P z X T <-> z <> RtoC 0 /\ answers Q z (X / z^n)%C T).
Proof.
  assert (Tr : forall t u s, Cexp (- s * RtoC (t + u))%C = (Cexp (- s * RtoC t) * Cexp (- s * RtoC u))%C).
  { intros t u s; rewrite <- Cexp_plus; f_equal; rewrite RtoC_plus; ring. }
  intros P Q z X T n E; split.
  - intros (m & b & k & t & p & M & Pp & Tp & Tf & Z & x & v & Mo & Tu & One & i & j & R0 & Eq).
    split; [exact Z |]; apply RtoC_inj in Tp; subst T.
    exists m, b, k, (t + INR n * p), p; repeat (split; [assumption || reflexivity |]); split.
    { intros s S; rewrite E, (Tf s S), Tr, <- RtoC_mult; unfold Cdiv; ring. }
    split; [exact Z |]; exists x, v; repeat (split; [assumption |]).
    exists (i + n)%nat, j; rewrite plus_INR;
      replace ((INR i + INR n - INR j) * p - (t + INR n * p)) with ((INR i - INR j) * p - t) by ring.
    split; [exact R0 |]; rewrite Eq, Cpower_plus; field; apply power_there, Z.
  - intros (Z & m & b & k & t & p & M & Pp & Tp & Tf & _ & x & v & Mo & Tu & One & i & j & R0 & Eq).
    apply RtoC_inj in Tp; subst T.
    exists m, b, k, (t - INR n * p), p; repeat (split; [assumption || reflexivity |]); split.
    { intros s S; assert (F := Tf s S); rewrite E in F.
      replace (P s) with (Cexp (- s * RtoC (- (INR n * p))) * (Cexp (- s * (INR n * p)) * P s))%C.
      - rewrite F; unfold Rminus; rewrite Tr; unfold Cdiv; ring.
      - rewrite Cmult_assoc, <- Cexp_plus, Cexp_nought by (rewrite RtoC_opp, RtoC_mult; ring); ring. }
    split; [exact Z |]; exists x, v; repeat (split; [assumption |]).
    exists i, (j + n)%nat; rewrite plus_INR;
      replace ((INR i - (INR j + INR n)) * p - (t - INR n * p)) with ((INR i - INR j) * p - t) by ring.
    split; [exact R0 |]; rewrite Cpower_plus; transitivity (z^n * (z^j * x ((INR i - INR j) * p - t)%R))%C; [ring |].
    rewrite Eq; field; apply power_there, Z.
Qed.
(* Other units: of time by u, of force per length by f. *)
Lemma moves_scaled : forall g d F x v u f, moves g d F x v ->
  moves (u^2 * g) (u * d) (u^2 * f * F) (fun t => f * x (u * t)) (fun t => u * f * v (u * t)).
Proof.
  intros g d F x v u f M t; destruct (M (u * t)) as [A B].
  assert (L : is_derive (fun t => u * t) t u) by (auto_derive; [exact I | ring]).
  split.
  - replace (u * f * v (u * t)) with (f * (u * v (u * t))) by ring; apply is_derive_scal.
    exact (is_derive_comp x (fun t => u * t) t _ _ A L).
  - replace (u ^ 2 * f * F - u * d * (u * f * v (u * t)) - u ^ 2 * g * (f * x (u * t))) with (u * f * (u * (F - d * v
      (u * t) - g * x (u * t)))) by ring.
    apply is_derive_scal; exact (is_derive_comp v (fun t => u * t) t _ _ B L).
Qed.
Lemma pushed_scaled : forall m b k x v u f, m <> 0 -> u <> 0 -> f <> 0 -> pushed m b k x v ->
  pushed (m / (u^2 * f)) (b / (u * f)) (k / f) (fun t => f * x (u * t)%R)%C (fun t => (u * f)%R * v (u * t)%R)%C.
Proof.
  intros m b k x v u f M U F [A B]; unfold pushed.
  replace (k / f / (m / (u ^ 2 * f))) with (u^2 * (k / m)) by (field; auto).
  replace (b / (u * f) / (m / (u ^ 2 * f))) with (u * (b / m)) by (field; auto).
  replace (/ (m / (u ^ 2 * f))) with (u^2 * f * / m) by (field; auto).
  assert (L : forall g d F x v y w, moves g d F x v -> (forall t, y t = x t) -> (forall t, w t = v t) ->
    moves g d F y w).
  { intros g d G x' v' y w Mv X V t; destruct (Mv t) as [P Q]; rewrite X, V; split.
    - apply (is_derive_ext x'); [intro; rewrite X; reflexivity | exact P].
    - apply (is_derive_ext v'); [intro; rewrite V; reflexivity | exact Q]. }
  split.
  - apply (L _ _ _ _ _ _ _ (moves_scaled _ _ _ _ _ u f A)); intro t; unfold Re; simpl; ring.
  - replace 0 with (u^2 * f * 0) by ring; apply (L _ _ _ _ _ _ _ (moves_scaled _ _ _ _ _ u f B)); intro t;
      unfold Im; simpl; ring.
Qed.
Theorem answer_scaled : forall P Q z X (T u f : R), 0 < u -> f <> 0 -> (forall s, Q s = (f * P (s / u))%C) ->
  answers P z X T -> answers Q z (f * X)%C (T / u)%R.
Proof.
  intros P Q z X T u f U F E (m & b & k & t & p & M & Pp & Tp & Tf & Z & x & v & Mo & Tu & One & i & j & R0 & Eq).
  apply RtoC_inj in Tp; subst T; assert (u0 : u <> 0) by lra.
  assert (Uc := Cnot_zero u u0); assert (Fc := Cnot_zero f F).
  exists (m / (u^2 * f)), (b / (u * f)), (k / f), (t / u), (p / u).
  assert (Mn : m / (u^2 * f) <> 0).
  { apply Rmult_integral_contrapositive; split; [exact M | apply Rinv_neq_0_compat, Rmult_integral_contrapositive;
      split; [apply pow_nonzero |]; assumption]. }
  split; [exact Mn |].
  split; [apply Rdiv_lt_0_compat; assumption |]; split; [reflexivity |]; split.
  { intros s S; rewrite E; set (s' := (s / u)%C).
    assert (Den : (RtoC (m / (u ^ 2 * f)) * s^2 + RtoC (b / (u * f)) * s + RtoC (k / f) =
      (m * s'^2 + b * s' + k) / f)%C).
    { replace (m / (u ^ 2 * f)) with (m * / u * / u * / f) by (field; split; assumption).
      replace (b / (u * f)) with (b * / u * / f) by (field; split; assumption); unfold Rdiv.
      rewrite !RtoC_mult, !RtoC_inv by assumption; unfold s'; simpl; field; split; assumption. }
    rewrite Den in S |- *; rewrite (Tf s').
    - replace (- s' * RtoC t)%C with (- s * RtoC (t / u))%C by (unfold s'; rewrite RtoC_div by exact u0; field;
        exact Uc).
      field; split; [exact Fc |]; intro Q0; apply S; unfold s' in *; rewrite Q0; field; exact Fc.
    - intro Q0; apply S; rewrite Q0; field; exact Fc. }
  split; [exact Z |]; exists (fun t => f * x (u * t)%R)%C, (fun t => (u * f)%R * v (u * t)%R)%C.
  split; [apply pushed_scaled; assumption |]; assert (Up : u * (p / u) = p) by (field; exact u0).
  split; [unfold turns; rewrite Up, !Rmult_0_r; destruct Tu as [A B]; rewrite A, B; split; ring |]; split.
  - intros y w My Ty; assert (Mb := pushed_scaled _ _ _ _ _ (/ u) (/ f) Mn (Rinv_neq_0_compat _ u0)
      (Rinv_neq_0_compat _ F) My).
    replace (m / (u ^ 2 * f) / ((/ u) ^ 2 * / f)) with m in Mb by (field; auto).
    replace (b / (u * f) / (/ u * / f)) with b in Mb by (field; auto).
    replace (k / f / / f) with k in Mb by (field; auto).
    destruct (One _ _ Mb) as [Y W].
    + unfold turns in *; rewrite !Rmult_0_r; replace (/ u * p) with (p / u) by (unfold Rdiv; ring);
        destruct Ty as [A B]; rewrite A, B; split; ring.
    + rewrite !Rmult_0_r in *; rewrite <- Y, <- W, !RtoC_mult, !RtoC_inv by assumption; split; field; repeat split;
        assumption.
  - exists i, j; replace ((INR i - INR j) * (p / u) - t / u) with (((INR i - INR j) * p - t) / u) by (field;
      exact u0).
    split.
    + split; [apply Rdiv_le_0_compat; lra |]; apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, U | lra].
    + replace (u * (((INR i - INR j) * p - t) / u)) with ((INR i - INR j) * p - t) by (field; exact u0).
      transitivity (f * (z^j * x ((INR i - INR j) * p - t)%R))%C; [ring | rewrite Eq; ring].
Qed.

(* A transfer function has one mass, damper, spring and delay. *)
Lemma large_square : forall m b k : R, m <> 0 -> exists S, 1 <= S /\ forall s, S <= s ->
  Rabs m / 2 * s^2 <= Rabs (m * s^2 + b * s + k) <= (Rabs m + Rabs b + Rabs k) * s^2.
Proof.
  intros m b k M; assert (Pm := Rabs_pos_lt m M); assert (Pb := Rabs_pos b); assert (Pk := Rabs_pos k).
  exists (1 + 2 * (Rabs b + Rabs k) / Rabs m);
    assert (Q : 0 <= 2 * (Rabs b + Rabs k) / Rabs m) by (apply Rdiv_le_0_compat; lra).
  split; [lra |]; intros s S; assert (s1 : 1 <= s) by lra.
  assert (Ms : 2 * (Rabs b + Rabs k) <= Rabs m * s).
  { replace (2 * (Rabs b + Rabs k)) with (Rabs m * (2 * (Rabs b + Rabs k) / Rabs m)) by (field; lra);
      apply Rmult_le_compat_l; lra. }
  assert (A : Rabs (m * s^2) = Rabs m * s^2) by (rewrite Rabs_mult, (Rabs_pos_eq (s^2));
    [reflexivity | apply pow2_ge_0]).
  assert (B : Rabs (b * s) = Rabs b * s) by (rewrite Rabs_mult, (Rabs_pos_eq s); [reflexivity | lra]).
  assert (Rest : Rabs (b * s + k) <= (Rabs b + Rabs k) * s).
  { eapply Rle_trans; [apply Rabs_triang |]; rewrite B; nra. }
  assert (S2 : s <= s^2) by nra; split.
  - assert (T : Rabs m * s^2 <= Rabs (m * s^2 + b * s + k) + Rabs (b * s + k)).
    { rewrite <- A; replace (m * s^2) with (m * s^2 + b * s + k + - (b * s + k)) at 1 by ring.
      eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp; lra. }
    assert ((Rabs b + Rabs k) * s <= Rabs m / 2 * s^2) by nra; nra.
  - replace (m * s^2 + b * s + k) with (m * s^2 + (b * s + k)) by ring.
    eapply Rle_trans; [apply Rabs_triang |]; rewrite A; nra.
Qed.
Lemma transfers_at : forall P m b k t s, transfers P m b k t -> m * s^2 + b * s + k <> 0 ->
  P (RtoC s) = RtoC (exp (- s * t) / (m * s^2 + b * s + k)).
Proof.
  intros P m b k t s T N; assert (E : (m * RtoC s ^ 2 + b * s + k)%C = RtoC (m * s^2 + b * s + k)).
  { rewrite !RtoC_plus, !RtoC_mult; simpl; rewrite !RtoC_mult; ring. }
  rewrite T, E by (rewrite E; apply Cnot_zero, N); rewrite RtoC_div by exact N; f_equal.
  rewrite (Cexp_at _ (- s * t) 0) by (apply injective_projections; simpl; ring); rewrite cos_0, sin_0.
  apply injective_projections; simpl; ring.
Qed.
Lemma transfers_related : forall P m b k t m' b' k' t', m <> 0 -> m' <> 0 -> transfers P m b k t ->
  transfers P m' b' k' t' ->
  exists S, 1 <= S /\ forall s, S <= s -> m' * s^2 + b' * s + k' = (m * s^2 + b * s + k) * exp ((t - t') * s).
Proof.
  intros P m b k t m' b' k' t' M M' T T'.
  destruct (large_square m b k M) as (S & S1 & L), (large_square m' b' k' M') as (S' & S1' & L').
  exists (Rmax S S'); split; [eapply Rle_trans; [exact S1 | apply Rmax_l] |]; intros s Ss.
  assert (Big : forall m b k, m <> 0 -> Rabs m / 2 * s^2 <= Rabs (m * s^2 + b * s + k) -> m * s^2 + b * s + k <> 0).
  { intros n c l N Le Z; rewrite Z, Rabs_R0 in Le; assert (Pn := Rabs_pos_lt n N).
    assert (1 <= s) by (generalize (Rmax_l S S'); lra); assert (0 < s^2) by nra; nra. }
  assert (N := Big m b k M (proj1 (L s (Rle_trans _ _ _ (Rmax_l S S') Ss)))).
  assert (N' := Big m' b' k' M' (proj1 (L' s (Rle_trans _ _ _ (Rmax_r S S') Ss)))).
  assert (E := transfers_at _ _ _ _ _ s T N); rewrite (transfers_at _ _ _ _ _ s T' N') in E; apply RtoC_inj in E.
  replace (exp (- s * t')) with (exp (- s * t) * exp ((t - t') * s)) in E by (rewrite <- exp_plus; f_equal; ring).
  assert (X := exp_pos (- s * t)); set (q := m * s^2 + b * s + k) in *; set (q' := m' * s^2 + b' * s + k') in *.
  apply Rmult_eq_reg_l with (exp (- s * t)); [| lra].
  replace (exp (- s * t) * (q * exp ((t - t') * s))) with (exp (- s * t) * exp ((t - t') * s) / q' * (q * q'))
    by (field; exact N').
  rewrite E; field; exact N.
Qed.
Lemma no_less_delay : forall P m b k t m' b' k' t', m <> 0 -> m' <> 0 -> transfers P m b k t ->
  transfers P m' b' k' t' -> t <= t'.
Proof.
  intros P m b k t m' b' k' t' M M' T T'; apply Rnot_lt_le; intro L.
  destruct (transfers_related P _ _ _ _ _ _ _ _ M M' T T') as (S & S1 & E).
  destruct (large_square m b k M) as (R & R1 & A), (large_square m' b' k' M') as (R' & R1' & A').
  set (c := Rabs m / 2); set (d := Rabs m' + Rabs b' + Rabs k'); assert (Pm := Rabs_pos_lt m M).
  assert (Pc : 0 < c) by (unfold c; lra); set (s := Rmax S (Rmax R (Rmax R' (d / c / (t - t'))))).
  assert (S2 : S <= s) by apply Rmax_l.
  assert (R2 : R <= s) by (eapply Rle_trans; [apply Rmax_l | apply Rmax_r]).
  assert (R3 : R' <= s) by (eapply Rle_trans; [apply Rmax_l | eapply Rle_trans; [apply Rmax_r | apply Rmax_r]]).
  assert (R4 : d / c / (t - t') <= s) by (eapply Rle_trans; [apply Rmax_r | eapply Rle_trans;
    [apply Rmax_r | apply Rmax_r]]).
  specialize (E s S2); specialize (A s R2); specialize (A' s R3); fold c in A; fold d in A'.
  assert (X := exp_pos ((t - t') * s)); assert (Sq : 0 < s^2) by (assert (1 <= s) by lra; nra).
  assert (Y : exp ((t - t') * s) * c <= d).
  { apply Rmult_le_reg_r with (s^2); [exact Sq |]; eapply Rle_trans; [| apply A'].
    rewrite E, Rabs_mult, (Rabs_pos_eq (exp _)) by lra.
    replace (exp ((t - t') * s) * c * s^2) with (c * s^2 * exp ((t - t') * s)) by ring; apply Rmult_le_compat_r;
      lra. }
  assert (Z : d <= (t - t') * s * c).
  { replace d with (d / c / (t - t') * ((t - t') * c)) at 1 by (field; lra).
    replace ((t - t') * s * c) with (s * ((t - t') * c)) by ring; apply Rmult_le_compat_r; [nra | exact R4]. }
  assert (W : 1 + (t - t') * s <= exp ((t - t') * s)) by apply exp_ineq1_le.
  nra.
Qed.
Lemma transfers_once : forall P m b k t m' b' k' t', m <> 0 -> m' <> 0 -> transfers P m b k t ->
  transfers P m' b' k' t' ->
  m' = m /\ b' = b /\ k' = k /\ t' = t.
Proof.
  intros P m b k t m' b' k' t' M M' T T'.
  assert (E : t' = t) by (apply Rle_antisym;
    [apply (no_less_delay P m' b' k' t' m b k t) | apply (no_less_delay P m b k t m' b' k' t')]; assumption).
  destruct (transfers_related P _ _ _ _ _ _ _ _ M M' T T') as (S & S1 & Eq); subst t'.
  assert (Same : forall s, S <= s -> m' * s^2 + b' * s + k' = m * s^2 + b * s + k).
  { intros s Ss; rewrite (Eq s Ss); replace ((t - t) * s) with 0 by ring; rewrite exp_0; ring. }
  assert (A := Same S (Rle_refl S)); assert (B := Same (S + 1) ltac:(lra)); assert (C := Same (S + 2) ltac:(lra)).
  assert (Dm : m' = m) by lra; subst m'; assert (Db : b' = b) by lra; subst b'; repeat split; lra.
Qed.

Lemma pushed_once : forall m b k x v y w, pushed m b k x v -> pushed m b k y w -> x 0 = y 0 -> v 0 = w 0 ->
  forall t, x t = y t /\ v t = w t.
Proof.
  intros m b k x v y w [A B] [C D] X V t.
  destruct (one_motion_always _ _ _ _ _ _ _ A C) with (t := t) as [P Q]; [rewrite X; reflexivity | rewrite V;
    reflexivity |].
  destruct (one_motion_always _ _ _ _ _ _ _ B D) with (t := t) as [R S]; [rewrite X; reflexivity | rewrite V;
    reflexivity |].
  split; apply injective_projections; assumption.
Qed.
(* A sample may be taken at the end of a period or at the beginning of the next one. *)
Lemma same_sample : forall z p t (x : R -> C) X Y (i j i' j' : nat), z <> RtoC 0 -> 0 < p -> x p = (z * x 0)%C ->
  0 <= (INR i - INR j) * p - t <= p -> (z^j * x ((INR i - INR j) * p - t)%R = z^i * X)%C ->
  0 <= (INR i' - INR j') * p - t <= p -> (z^j' * x ((INR i' - INR j') * p - t)%R = z^i' * Y)%C -> X = Y.
Proof.
  assert (One : forall z p t (x : R -> C) X Y (i j i' j' : nat), z <> RtoC 0 -> 0 < p -> x p = (z * x 0)%C ->
    (i + j' <= i' + j)%nat -> 0 <= (INR i - INR j) * p - t <= p ->
      (z^j * x ((INR i - INR j) * p - t)%R = z^i * X)%C ->
    0 <= (INR i' - INR j') * p - t <= p -> (z^j' * x ((INR i' - INR j') * p - t)%R = z^i' * Y)%C -> X = Y).
  { intros z p t x X Y i j i' j' Z P Tu Le R0 E R1 F; apply le_INR in Le as Lr; rewrite !plus_INR in Lr.
    assert (Cancel : forall n a b, (z^n * a = z^n * b)%C -> a = b).
    { intros n a b Q; assert (N := power_there z n Z); replace a with (z^n * a / z^n)%C by (field; exact N);
        rewrite Q; field; exact N. }
    destruct (Nat.eq_dec (i + j') (i' + j)) as [Q | Q].
    - assert (Qr : INR i + INR j' = INR i' + INR j) by (rewrite <- !plus_INR; f_equal; exact Q).
      replace (INR i' - INR j') with (INR i - INR j) in F by lra; set (y := x ((INR i - INR j) * p - t)) in *.
      apply (Cancel (i + j')%nat); rewrite Q at 2; rewrite !Cpower_plus.
      transitivity (z^j' * (z^i * X))%C; [ring |]; rewrite <- E; transitivity (z^j * (z^j' * y))%C; [ring |];
        rewrite F; ring.
    - assert (N : (i + j' + 1 <= i' + j)%nat) by lia; apply le_INR in N as Nr; rewrite !plus_INR in Nr;
        simpl (INR 1) in Nr.
      assert (Up : (INR i' - INR j') * p - t = p /\ (INR i - INR j) * p - t = 0).
      { assert ((INR i + 1 - INR j) * p <= (INR i' - INR j') * p) by (apply Rmult_le_compat_r; lra); lra. }
      destruct Up as [U1 U0]; rewrite U0 in E; rewrite U1, Tu in F.
      assert (Q' : (i' + j = i + j' + 1)%nat).
      { apply INR_eq; rewrite !plus_INR; simpl (INR 1); apply Rmult_eq_reg_r with p; lra. }
      apply (Cancel (i + j' + 1)%nat); rewrite <- Q' at 2; rewrite !Cpower_plus; replace (z^1)%C with z by (simpl;
        ring).
      transitivity (z^j' * z * (z^i * X))%C; [ring |]; rewrite <- E; transitivity (z^j * (z^j' * (z * x 0)))%C;
        [ring |]; rewrite F; ring. }
  intros z p t x X Y i j i' j' Z P Tu R0 E R1 F; destruct (Nat.le_ge_cases (i + j') (i' + j)) as [L | L].
  - exact (One z p t x X Y i j i' j' Z P Tu L R0 E R1 F).
  - symmetry; exact (One z p t x Y X i' j' i j Z P Tu L R1 F R0 E).
Qed.
Theorem one_answer : forall P z X Y T, answers P z X T -> answers P z Y T -> X = Y.
Proof.
  intros P z X Y T (m & b & k & t & p & M & Pp & Tp & Tf & Z & x & v & Mo & Tu & One & i & j & R0 & E)
    (m' & b' & k' & t' & p' & M' & Pp' & Tp' & Tf' & _ & y & w & Mo' & Tu' & _ & i' & j' & R1 & F).
  destruct (transfers_once P _ _ _ _ _ _ _ _ M M' Tf Tf') as (Em & Eb & Ek & Et); subst m' b' k' t'.
  rewrite Tp in Tp'; apply RtoC_inj in Tp'; subst p'.
  destruct (One y w Mo' Tu') as [Y0 W0];
    destruct (pushed_once _ _ _ _ _ _ _ Mo Mo' (eq_sym Y0) (eq_sym W0) ((INR i' - INR j') * p - t)) as [Q _].
  rewrite <- Q in F; exact (same_sample z p t x X Y i j i' j' Z Pp (proj1 Tu) R0 E R1 F).
Qed.

(* In numbers: Phi and Gamma move a state, and from rest under the force 1. *)
Section Held.
Variables (m b k : R) (x1 v1 x2 v2 x3 v3 : R -> R).
Hypotheses (M0 : m <> 0) (M : motions (k / m) (b / m) x1 v1 x2 v2 x3 v3).
Definition state (p q : C) (t : R) : C := (x1 t * p + x2 t * q + x3 t / m)%C.
Definition rate (p q : C) (t : R) : C := (v1 t * p + v2 t * q + v3 t / m)%C.
Lemma state_starts : forall p q, state p q 0 = p /\ rate p q 0 = q.
Proof.
  intros p q; destruct M as [_ P1 Q1 _ P2 Q2 _ P3 Q3]; unfold state, rate; rewrite P1, Q1, P2, Q2, P3, Q3; split;
    unfold Cdiv; ring.
Qed.
Lemma state_pushed : forall p q, pushed m b k (state p q) (rate p q).
Proof.
  intros p q; assert (L : forall F x v y w, moves (k / m) (b / m) F x v -> (forall t, y t = x t) ->
    (forall t, w t = v t) -> moves (k / m) (b / m) F y w).
  { intros G x' v' y w Mv X V t; destruct (Mv t) as [P Q]; rewrite X, V; split.
    - apply (is_derive_ext x'); [intro; rewrite X; reflexivity | exact P].
    - apply (is_derive_ext v'); [intro; rewrite V; reflexivity | exact Q]. }
  assert (Mc := Cnot_zero m M0); assert (D : forall y : R, (RtoC y / RtoC m)%C = RtoC (/ m * y)).
  { intro y; rewrite <- RtoC_div by exact M0; f_equal; unfold Rdiv; ring. }
  split; [apply (L _ _ _ _ _ (combined _ _ _ _ _ _ _ _ M (Re p) (Re q) (/ m))) |
    apply (L _ _ _ _ _ (combined _ _ _ _ _ _ _ _ M (Im p) (Im q) 0))];
    intro t; unfold state, rate; rewrite D; destruct p, q; simpl; ring.
Qed.
Lemma state_of : forall x v, pushed m b k x v -> forall t, x t = state (x 0) (v 0) t /\ v t = rate (x 0) (v 0) t.
Proof.
  intros x v P t; destruct (state_starts (x 0) (v 0)) as [S R].
  apply (pushed_once m b k); [exact P | apply state_pushed | rewrite S | rewrite R]; reflexivity.
Qed.
(* (1, 0) adj(z - Phi) of a vector. *)
Definition determinant (z : C) : C := ((z - x1 1) * (z - v2 1) - x2 1 * v1 1)%C.
Theorem held_answer : forall P z X l u, transfers P m b k (INR l + u) -> 0 <= u <= 1 ->
  let g := fun t => (RtoC (x3 t) / m)%C in let h := fun t => (RtoC (v3 t) / m)%C in
  let x := (g (1 - u)%R / z^l + (x1 (1 - u)%R * g u + x2 (1 - u)%R * h u) / z^(S l))%C in
  let v := (h (1 - u)%R / z^l + (v1 (1 - u)%R * g u + v2 (1 - u)%R * h u) / z^(S l))%C in
  (answers P z X 1 <-> z <> RtoC 0 /\ determinant z <> RtoC 0 /\ (X * determinant z =
    (z - v2 1%R) * x + x2 1%R * v)%C).
Proof.
  intros P z X l u Tf U g h x v; assert (Mc := Cnot_zero m M0).
  set (s := ((z - v2 1%R) * g 1%R + x2 1%R * h 1%R)%C); set (r := (v1 1%R * g 1%R + (z - x1 1%R) * h 1%R)%C).
  (* The state that turns, times the determinant, and where it is at the sample. *)
  assert (Sample : z <> RtoC 0 ->
    (x1 (1 - u)%R * s + x2 (1 - u)%R * r + g (1 - u)%R * determinant z =
    z^(S l) * ((z - v2 1%R) * x + x2 1%R * v))%C).
  { intro Z; assert (St := steady_sample _ _ _ _ _ _ _ _ u z M U); cbv zeta in St; unfold steady_place in St.
    repeat first [rewrite RtoC_plus in St | rewrite RtoC_minus in St | rewrite RtoC_mult in St].
    assert (N := power_there z l Z); unfold x, v, s, r, g, h, determinant; cbn [Cpower] in St |- *.
    match type of St with ?a = ?b => assert (Q : (a / m = b / m)%C) by (rewrite St; reflexivity) end.
    etransitivity; [| etransitivity; [exact Q |]]; field; repeat split; assumption. }
  assert (Turn : forall p q, turns z 1 (state p q) (rate p q) <-> ((z - x1 1%R) * p - x2 1%R * q =
    g 1%R)%C /\ ((z - v2 1%R) * q - v1 1%R * p = h 1%R)%C).
  { intros p q; destruct (state_starts p q) as [S0 R0]; unfold turns; rewrite S0, R0; unfold state, rate;
      fold (g 1%R) (h 1%R); split; intros [A B]; split.
    - transitivity (z * p - x1 1%R * p - x2 1%R * q)%C; [ring |]; rewrite <- A; ring.
    - transitivity (z * q - v2 1%R * q - v1 1%R * p)%C; [ring |]; rewrite <- B; ring.
    - rewrite <- A; ring.
    - rewrite <- B; ring. }
  split.
  - intros (m' & b' & k' & t & p & M' & Pp & Tp & Tf' & Z & y & w & Mo & Tu & One & i & j & R0 & E).
    destruct (transfers_once P _ _ _ _ _ _ _ _ M' M0 Tf' Tf) as (Em & Eb & Ek & Et); subst m' b' k' t.
    apply RtoC_inj in Tp; subst p; split; [exact Z |].
    assert (Ty : turns z 1 (state (y 0) (w 0)) (rate (y 0) (w 0))).
    { destruct (state_starts (y 0) (w 0)) as [S0 Q0]; unfold turns;
        rewrite S0, Q0, <- (proj1 (state_of y w Mo 1)), <- (proj2 (state_of y w Mo 1)); exact Tu. }
    assert (There := proj1 (state_of y w Mo (1 - u))); set (p := y 0) in *; set (q := w 0) in *.
    apply Turn in Ty; destruct Ty as [T1 T2].
    assert (D0 : determinant z <> RtoC 0).
    { intro D0; assert (Kernel : forall c d, ((z - x1 1%R) * c - x2 1%R * d = RtoC 0)%C ->
        ((z - v2 1%R) * d - v1 1%R * c = RtoC 0)%C -> c = RtoC 0 /\ d = RtoC 0).
      { intros c d C D; destruct (One (state (p + c)%C (q + d)%C) (rate (p + c)%C (q +
          d)%C) (state_pushed _ _)) as [A B].
        - apply Turn; split.
          + transitivity ((z - x1 1%R) * p - x2 1%R * q + ((z - x1 1%R) * c - x2 1%R * d))%C; [ring | rewrite T1, C;
              ring].
          + transitivity ((z - v2 1%R) * q - v1 1%R * p + ((z - v2 1%R) * d - v1 1%R * c))%C; [ring | rewrite T2, D;
              ring].
        - rewrite (proj1 (state_starts _ _)) in A; rewrite (proj2 (state_starts _ _)) in B; fold p q in A, B; split.
          + replace c with (p + c - p)%C by ring; rewrite A; ring.
          + replace d with (q + d - q)%C by ring; rewrite B; ring. }
      unfold determinant in D0.
      destruct (Kernel (x2 1%R) (z - x1 1%R)%C) as [A1 A2]; [ring | rewrite <- D0; ring |].
      destruct (Kernel (z - v2 1%R)%C (v1 1%R)) as [B1 B2]; [rewrite <- D0; ring | ring |].
      destruct (Kernel (RtoC 1) (RtoC 0)) as [One' _]; [rewrite A2; ring | rewrite B2; ring |].
      apply (f_equal fst) in One'; simpl in One'; lra. }
    split; [exact D0 |].
    assert (Ps : (determinant z * p = s)%C).
    { unfold s, determinant; rewrite <- T1, <- T2; ring. }
    assert (Qr : (determinant z * q = r)%C).
    { unfold r, determinant; rewrite <- T1, <- T2; ring. }
    assert (Xs : (z^0 * y ((INR (S l) - INR 0) * 1 - (INR l + u))%R =
      z^(S l) * ((z - v2 1%R) * x + x2 1%R * v) / determinant z)%C).
    { rewrite S_INR; replace ((INR l + 1 - INR 0) * 1 - (INR l + u)) with (1 - u) by (simpl; ring).
      rewrite There, <- Sample by exact Z; unfold state; fold (g (1 - u)%R); rewrite <- Ps, <- Qr; simpl; field;
        exact D0. }
    assert (Eq : X = (((z - v2 1%R) * x + x2 1%R * v) / determinant z)%C).
    { apply (same_sample z 1 (INR l + u) y X _ i j (S l) O Z Pp (proj1 Tu) R0 E).
      - rewrite S_INR; simpl (INR 0); lra.
      - rewrite Xs; unfold Cdiv; ring. }
    rewrite Eq; field; exact D0.
  - intros (Z & D0 & E); exists m, b, k, (INR l + u), 1; repeat (split; [assumption || reflexivity || lra |]).
    set (p := (s / determinant z)%C); set (q := (r / determinant z)%C).
    exists (state p q), (rate p q); split; [apply state_pushed |].
    assert (Ty : turns z 1 (state p q) (rate p q)).
    { apply Turn; unfold p, q, s, r; split; unfold determinant in *; field; exact D0. }
    split; [exact Ty |]; split.
    + intros y w Mo Tu; assert (Tw : turns z 1 (state (y 0) (w 0)) (rate (y 0) (w 0))).
      { destruct (state_starts (y 0) (w 0)) as [S0 Q0]; unfold turns;
          rewrite S0, Q0, <- (proj1 (state_of y w Mo 1)), <- (proj2 (state_of y w Mo 1)); exact Tu. }
      apply Turn in Tw; destruct Tw as [T1 T2]; rewrite (proj1 (state_starts p q)), (proj2 (state_starts p q));
        unfold p, q, s, r; rewrite <- T1, <- T2.
      split; unfold determinant in *; field; exact D0.
    + exists (S l), O; rewrite S_INR; simpl (INR 0);
        replace ((INR l + 1 - 0) * 1 - (INR l + u)) with (1 - u) by ring; split; [lra |].
      replace X with (X * determinant z / determinant z)%C by (field; exact D0); rewrite E.
      transitivity (z^(S l) * ((z - v2 1%R) * x + x2 1%R * v) / determinant z)%C; [| unfold Cdiv; ring].
      rewrite <- Sample by exact Z; unfold state, p, q; fold (g (1 - u)%R); simpl; field; exact D0.
Qed.
End Held.
(* The same in both directions. *)
Lemma Cinv_nothing : (/ RtoC 0 = RtoC 0)%C.
Proof. apply injective_projections; simpl; unfold Rdiv; ring. Qed.
Lemma Cdiv_share : forall (x d : C) (f : R), f <> 0 -> (x / (d / f) = f * (x / d))%C.
Proof.
  intros x d f F; assert (Fc := Cnot_zero f F); destruct (Ceq_dec d 0) as [Z | N]; [| field; split; assumption].
  rewrite Z; replace (RtoC 0 / f)%C with (RtoC 0) by (field; exact Fc); unfold Cdiv; rewrite Cinv_nothing; ring.
Qed.
Theorem answer_units : forall P Q z X Y (T u f : R) S, 0 < u -> f <> 0 -> (forall s, Q s = (f * P (s / u))%C) ->
  Y = (f * X)%C -> S = RtoC (T / u) -> (answers P z X T <-> answers Q z Y S).
Proof.
  intros P Q z X Y T u f S U F E EY ES; subst Y S; assert (Fc := Cnot_zero f F);
    assert (Uc := Cnot_zero u ltac:(lra)).
  split; intro A; [exact (answer_scaled P Q z X T u f U F E A) |].
  replace X with (RtoC (/ f) * (f * X))%C by (rewrite RtoC_inv by exact F; field; exact Fc).
  replace T with (T / u / / u) by (field; lra).
  apply (answer_scaled Q P); [apply Rinv_0_lt_compat, U | apply Rinv_neq_0_compat, F | | exact A].
  intro s; rewrite E, !RtoC_inv by (try exact F; lra); replace (s / (/ u) / u)%C with s by (field; exact Uc); field;
    exact Fc.
Qed.
