(* Loops of a wall and a device: what their stability means, and how a delay makes a polynomial. *)
From Symhaptic Require Export Device.
Open Scope R_scope.

(* -- loops ------------------------------------------------------------------------------------ *)

(* The characteristic polynomial z^(d+1) (z^2 - a z + e) + (n_1 z + n_0) ((alpha + beta) z - beta) of a wall
   and a device, where zd stands for z^d. *)
Definition characteristic (alpha beta n_1 n_0 a e : R) (zd z : C) : C :=
  (zd * z * (z^2 - a * z + e) + (n_1 * z + n_0) * ((alpha + beta) * z - beta))%C.
(* The loop behind a delay of d = l + u periods. *)
Definition stable_loop (alpha beta gamma delta d : R) : Prop :=
  exists l u m_2 m_1 m_0 a e, late_device gamma delta u m_2 m_1 m_0 a e /\ u < 1 /\ d = INR l + u /\
    stable (fun z => z^(2 + l) * (z^2 - a * z + e) + (m_2 * z^2 + m_1 * z + m_0) * ((alpha + beta) * z - beta))%C.
(* As the paper reads a delay of d = p/q periods: a polynomial in w, with z = w^q. *)
Definition stable_substituted (alpha beta gamma delta d : R) : Prop :=
  exists n_1 n_0 a e p q, device gamma delta n_1 n_0 a e /\ (0 < q)%nat /\ d * INR q = INR p /\
    stable (fun w => characteristic alpha beta n_1 n_0 a e (w^p) (w^q))%C.
Definition pole (alpha beta gamma delta d : R) (z : C) : Prop :=
  exists n_1 n_0 a e p q w, device gamma delta n_1 n_0 a e /\ (0 < q)%nat /\ d * INR q = INR p /\ z = (w^q)%C /\
    characteristic alpha beta n_1 n_0 a e (w^p)%C (w^q)%C = RtoC 0.
(* With the principal value of z^d, for -PI < arg z < PI. *)
Definition stable_principal (alpha beta gamma delta d : R) : Prop :=
  exists n_1 n_0 a e, device gamma delta n_1 n_0 a e /\ forall z, 1 <= Cmod z -> (Im z = 0 -> 0 < Re z) ->
    characteristic alpha beta n_1 n_0 a e (Craised z d) z <> RtoC 0.

Lemma stable_power : forall f k, (0 < k)%nat -> (stable (fun w => f (w^k)%C) <-> stable f).
Proof.
  intros f k K; split; intros S z E.
  - destruct (Croot z k K) as [w W]; rewrite <- W in E; assert (L := S w E).
    rewrite <- W, Cmod_power; exact (proj2 (pow_lt_1_compat _ _ (conj (Cmod_ge_0 w) L) K)).
  - assert (L := S _ E); rewrite Cmod_power in L; apply Rnot_le_lt; intro M.
    assert (1 <= Cmod z ^ k) by (apply pow_R1_Rle; exact M); lra.
Qed.
(* Of a fraction that is not in lowest terms the polynomial is one in a power of w. *)
Lemma same_fraction : forall alpha beta n_1 n_0 a e p q r s, (0 < q)%nat -> (0 < s)%nat -> (p * s = r * q)%nat ->
  (stable (fun w => characteristic alpha beta n_1 n_0 a e (w^p) (w^q))%C <->
    stable (fun w => characteristic alpha beta n_1 n_0 a e (w^r) (w^s))%C).
Proof.
  intros al be n1 n0 a e p q r s Q S E.
  rewrite <- (stable_power (fun w => characteristic al be n1 n0 a e (w^p) (w^q))%C s S).
  rewrite <- (stable_power (fun w => characteristic al be n1 n0 a e (w^r) (w^s))%C q Q).
  apply stable_alike; intro w; rewrite <- !Cpower_mult.
  replace (p * s)%nat with (r * q)%nat by lia; replace (s * q)%nat with (q * s)%nat by lia; reflexivity.
Qed.
Theorem loop_in_w : forall alpha beta gamma delta d n_1 n_0 a e p q, device gamma delta n_1 n_0 a e -> (0 < q)%nat ->
  d * INR q = INR p -> (stable_substituted alpha beta gamma delta d <->
    stable (fun w => characteristic alpha beta n_1 n_0 a e (w^p) (w^q))%C).
Proof.
  intros al be g de d n1 n0 a e p q V Q D; split.
  - intros (m1 & m0 & b & f & r & s & W & S & F & St).
    destruct (device_unique _ _ _ _ _ _ _ _ _ _ V W) as (E1 & E0 & Ea & Ee); subst m1 m0 b f.
    revert St; apply same_fraction; try assumption; apply INR_eq; rewrite !mult_INR, <- D, <- F; ring.
  - intro St; exists n1, n0, a, e, p, q; repeat split; assumption.
Qed.
Theorem loop_as_read : forall alpha beta gamma delta d n_1 n_0 a e, device gamma delta n_1 n_0 a e ->
  stable_substituted alpha beta gamma delta d -> exists p q, (0 < q)%nat /\ d * INR q = INR p /\
    stable (fun w => characteristic alpha beta n_1 n_0 a e (w^p) (w^q))%C.
Proof.
  intros al be g de d n1 n0 a e V (m1 & m0 & b & f & r & s & W & S & F & St).
  destruct (device_unique _ _ _ _ _ _ _ _ _ _ V W) as (E1 & E0 & Ea & Ee); subst m1 m0 b f.
  exists r, s; repeat split; assumption.
Qed.
Theorem held_by_a_pole : forall alpha beta gamma delta d (x : R), pole alpha beta gamma delta d x -> 1 <= x^2 ->
  ~ stable_substituted alpha beta gamma delta d.
Proof.
  intros al be g de d x (n1 & n0 & a & e & p & q & w & V & Q & D & E & Z) X S.
  apply (loop_in_w al be g de d n1 n0 a e p q V Q D) in S; assert (L := S w Z).
  assert (Cmod x < 1).
  { rewrite E, Cmod_power; exact (proj2 (pow_lt_1_compat _ _ (conj (Cmod_ge_0 w) L) Q)). }
  rewrite Cmod_R in H; apply Rabs_def2 in H; nra.
Qed.
Lemma late_device_unique : forall gamma delta u m_2 m_1 m_0 a e k_2 k_1 k_0 b f,
  late_device gamma delta u m_2 m_1 m_0 a e -> late_device gamma delta u k_2 k_1 k_0 b f ->
  m_2 = k_2 /\ m_1 = k_1 /\ m_0 = k_0 /\ a = b /\ e = f.
Proof.
  intros g d u m2 m1 m0 a e k2 k1 k0 b f (U & x1 & v1 & x2 & v2 & x3 & v3 & M & P) (_ & y1 & w1 & y2 & w2 & y3 & w3 & N & Q).
  destruct (motions_unique _ _ _ _ _ _ _ _ _ _ _ _ _ _ M N 1 ltac:(lra)) as ((A1 & A2) & (A3 & A4) & (A5 & A6)).
  destruct (motions_unique _ _ _ _ _ _ _ _ _ _ _ _ _ _ M N u ltac:(lra)) as ((B1 & B2) & (B3 & B4) & (B5 & B6)).
  destruct (motions_unique _ _ _ _ _ _ _ _ _ _ _ _ _ _ M N (1 - u) ltac:(lra)) as ((C1 & C2) & (C3 & C4) & (C5 & C6)).
  cbv zeta in *; destruct P as (Pa & Pe & P2 & P1 & P0), Q as (Qa & Qe & Q2 & Q1 & Q0).
  rewrite <- A1, <- A2, <- A3, <- A4, <- C1, <- C2, <- C3, <- C4, <- C5, <- C6, <- B5, <- B6 in *; repeat split; congruence.
Qed.
(* z f and f have their zeros inside together. *)
Lemma times_z : forall f g, (forall z, g z = z * f z)%C -> (stable g <-> stable f).
Proof.
  intros f g G; split; intros S z E; [apply S; rewrite G, E; ring |].
  rewrite G in E; destruct (product_apart_C _ _ E) as [Z | Z]; [rewrite Z, Cmod_0; lra | exact (S z Z)].
Qed.
Lemma parts_of_delay : forall l m u v, 0 <= u < 1 -> 0 <= v < 1 -> INR l + u = INR m + v -> l = m /\ u = v.
Proof.
  intros l m u v U V E; assert (L : l = m).
  { destruct (Nat.lt_trichotomy l m) as [H | [H | H]]; [exfalso | exact H | exfalso];
      apply le_INR in H; rewrite S_INR in H; lra. }
  subst m; split; [reflexivity | lra].
Qed.
Lemma loop_below : forall alpha beta gamma delta l u m_2 m_1 m_0 a e, late_device gamma delta u m_2 m_1 m_0 a e -> u < 1 ->
  (stable_loop alpha beta gamma delta (INR l + u) <->
    stable (fun z => z^(2 + l) * (z^2 - a * z + e) + (m_2 * z^2 + m_1 * z + m_0) * ((alpha + beta) * z - beta))%C).
Proof.
  intros al be g de l u m2 m1 m0 a e V U; split.
  - intros (k & v & k2 & k1 & k0 & b & f & W & Vv & D & S).
    destruct (parts_of_delay l k u v (conj (proj1 (proj1 V)) U) (conj (proj1 (proj1 W)) Vv) D) as [L E]; subst k v.
    destruct (late_device_unique _ _ _ _ _ _ _ _ _ _ _ _ _ V W) as (E2 & E1 & E0 & Ea & Ee); subst; exact S.
  - intro S; exists l, u, m2, m1, m0, a, e; repeat split; try assumption; apply V.
Qed.
Theorem loop_of_late_device : forall alpha beta gamma delta l u m_2 m_1 m_0 a e, late_device gamma delta u m_2 m_1 m_0 a e ->
  (stable_loop alpha beta gamma delta (INR l + u) <->
    stable (fun z => z^(2 + l) * (z^2 - a * z + e) + (m_2 * z^2 + m_1 * z + m_0) * ((alpha + beta) * z - beta))%C).
Proof.
  intros al be g de l u m2 m1 m0 a e V; destruct (Rlt_le_dec u 1) as [U | U]; [exact (loop_below al be g de l u m2 m1 m0 a e V U) |].
  assert (E : u = 1) by (generalize (proj2 (proj1 V)); lra); subst u.
  destruct (late_device_exists g de 0 ltac:(lra)) as (k2 & k1 & k0 & n1 & n0 & b & f & W & D).
  destruct (late_device_and_device _ _ _ _ _ _ _ _ _ _ _ _ V D) as (_ & Ea & Ee & _ & H); destruct (H eq_refl) as (A2 & A1 & A0).
  destruct (late_device_and_device _ _ _ _ _ _ _ _ _ _ _ _ W D) as (_ & _ & _ & K & _); destruct (K eq_refl) as (B2 & B1 & B0).
  subst a e; replace (INR l + 1) with (INR (S l) + 0) by (rewrite S_INR; ring).
  rewrite (loop_below al be g de (S l) 0 k2 k1 k0 b f W ltac:(lra)); apply times_z; intro z.
  rewrite A2, A1, A0, B2, B1, B0; simpl; ring.
Qed.
Theorem loop_of_device : forall alpha beta gamma delta n n_1 n_0 a e, device gamma delta n_1 n_0 a e ->
  (stable_loop alpha beta gamma delta (INR n) <-> stable (fun z => characteristic alpha beta n_1 n_0 a e (z^n) z)%C) /\
  (stable_substituted alpha beta gamma delta (INR n) <-> stable (fun z => characteristic alpha beta n_1 n_0 a e (z^n) z)%C).
Proof.
  intros al be g de n n1 n0 a e V; split.
  - destruct (late_device_exists g de 0 ltac:(lra)) as (k2 & k1 & k0 & m1 & m0 & b & f & W & D).
    destruct (device_unique _ _ _ _ _ _ _ _ _ _ V D) as (E1 & E0 & Ea & Ee); subst m1 m0 b f.
    destruct (late_device_and_device _ _ _ _ _ _ _ _ _ _ _ _ W D) as (_ & _ & _ & K & _); destruct (K eq_refl) as (B2 & B1 & B0).
    replace (INR n) with (INR n + 0) by ring; rewrite (loop_below al be g de n 0 _ _ _ _ _ W ltac:(lra)); apply times_z; intro z.
    rewrite B2, B1, B0; unfold characteristic; simpl; ring.
  - rewrite (loop_in_w al be g de (INR n) n1 n0 a e n 1 V ltac:(lia) ltac:(simpl; ring)); apply stable_alike; intro z.
    unfold characteristic; simpl; ring.
Qed.
Theorem loop_behind : forall alpha beta gamma delta d n n_1 n_0 a e, device gamma delta n_1 n_0 a e -> d = INR n ->
  (stable_loop alpha beta gamma delta d <-> stable (fun z => characteristic alpha beta n_1 n_0 a e (z^n) (z^1))%C).
Proof.
  intros al be g de d n n1 n0 a e V D; rewrite D; apply (iff_trans (proj1 (loop_of_device al be g de n n1 n0 a e V))).
  apply stable_alike; intro z; unfold characteristic; simpl; ring.
Qed.
(* Half a period: v is the root of z to the right, and z^d = v^(2 d). *)
Lemma Cexp_parts : forall w, Cmod (Cexp w) = exp (Re w).
Proof.
  intro w; apply Rsqr_inj; [apply Cmod_ge_0 | apply Rlt_le, exp_pos |]; unfold Rsqr.
  replace (Cmod (Cexp w) * Cmod (Cexp w)) with (Cmod (Cexp w) ^ 2) by ring; rewrite Cmod_square; unfold Cexp, Re, Im; simpl.
  transitivity (exp (fst w) * exp (fst w) * (sin (snd w) ^ 2 + cos (snd w) ^ 2)); [simpl; ring |].
  replace (sin (snd w) ^ 2 + cos (snd w) ^ 2) with 1 by (generalize (pythagoras (snd w)); lra); unfold Re; ring.
Qed.
Lemma Clog_exp : forall w, - PI < Im w <= PI -> Clog (Cexp w) = w.
Proof.
  intros w [L U]; unfold Clog; rewrite Cexp_parts, ln_exp; apply injective_projections; simpl; [reflexivity |].
  assert (P := exp_pos (Re w)); unfold Cangle_of; rewrite Cexp_parts.
  assert (C : Re (Cexp w) / exp (Re w) = cos (Im w)) by (unfold Cexp; simpl; field; lra); rewrite C.
  destruct (Rle_dec 0 (Im (Cexp w))) as [S | S]; unfold Cexp in S; simpl in S.
  - destruct (Rle_dec 0 (Im w)) as [I | I]; [apply acos_cos; unfold Im in *; lra |].
    exfalso; assert (sin (Im w) < 0) by (apply sin_lt_0_var; lra); nra.
  - destruct (Rle_dec 0 (Im w)) as [I | I].
    + exfalso; assert (0 <= sin (Im w)) by (apply sin_ge_0; lra); nra.
    + rewrite <- cos_neg, acos_cos; unfold Im in *; lra.
Qed.
Lemma angle_right : forall v, 0 < Re v -> - (PI / 2) < Cangle_of v < PI / 2.
Proof.
  intros v V; assert (N : v <> RtoC 0) by (intro E; rewrite E in V; simpl in V; lra).
  assert (P := proj1 (Cmod_gt_0 v) N); assert (Q : 0 < Re v / Cmod v) by (apply Rdiv_lt_0_compat; assumption).
  assert (B : Re v / Cmod v <= 1).
  { apply Rle_div_l; [exact P |]; rewrite Rmult_1_l; eapply Rle_trans; [apply Rle_abs |].
    eapply Rle_trans; [apply (Rmax_l (Rabs (fst v)) (Rabs (snd v))) | apply Rmax_Cmod]. }
  assert (A : acos (Re v / Cmod v) < PI / 2) by (rewrite acos_atan by exact Q; apply atan_bound).
  generalize (acos_bound (Re v / Cmod v)) PI_RGT_0; unfold Cangle_of; destruct (Rle_dec 0 (Im v)); lra.
Qed.
Lemma square_log : forall v, 0 < Re v -> Clog (v^2)%C = (RtoC 2 * Clog v)%C.
Proof.
  intros v V; assert (A := angle_right v V); assert (N : v <> RtoC 0) by (intro E; rewrite E in V; simpl in V; lra).
  rewrite <- (Clog_exp (RtoC 2 * Clog v)%C).
  - f_equal; replace (RtoC 2 * Clog v)%C with (Clog v + Clog v)%C by ring; rewrite Cexp_plus, Cexp_log by exact N; simpl; ring.
  - unfold Clog; simpl; lra.
Qed.
Lemma half_power : forall v n, 0 < Re v -> Craised (v^2)%C (RtoC (INR n + 1 / 2)) = (v^(1 + (n + n)))%C.
Proof.
  intros v n V; assert (N : v <> RtoC 0) by (intro E; rewrite E in V; simpl in V; lra).
  assert (N2 : (v^2)%C <> RtoC 0) by (simpl; repeat apply Cmult_neq_0; try exact N; apply Cnot_zero; lra).
  unfold Craised; destruct (Ceq_dec (v^2)%C 0) as [E | _]; [contradiction |].
  rewrite square_log by exact V; rewrite <- (Cexp_log v N) at 2; rewrite Cexp_power; f_equal.
  rewrite plus_INR, plus_INR, !RtoC_plus, RtoC_div by lra; simpl; field.
Qed.
Lemma Craised_root : forall x y : R, 0 < y -> y * y = x -> Craised (RtoC x) (RtoC (1 / 2)) = RtoC y.
Proof.
  intros x y Y E; assert (H := half_power (RtoC y) 0 Y); simpl in H.
  replace (RtoC x) with (RtoC y * (RtoC y * RtoC 1))%C by (rewrite <- E; Cpushed; ring).
  replace (1 / 2) with (0 + 1 / 2) by ring; rewrite H; ring.
Qed.
Theorem half_a_period : forall alpha beta gamma delta l n_1 n_0 a e, device gamma delta n_1 n_0 a e ->
  (stable_principal alpha beta gamma delta (INR l + 1 / 2) <->
    forall x y : R, 0 < x -> 1 <= x^2 + y^2 ->
      characteristic alpha beta n_1 n_0 a e ((x + Ci * y)^(1 + (l + l)))%C ((x + Ci * y)^2)%C <> RtoC 0).
Proof.
  intros al be g de l n1 n0 a e V; split.
  - intros (m1 & m0 & b & f & W & H) x y X XY.
    destruct (device_unique _ _ _ _ _ _ _ _ _ _ V W) as (E1 & E0 & Ea & Ee); subst m1 m0 b f.
    set (v := (x + Ci * y)%C); assert (Rv : Re v = x) by (unfold v; simpl; ring).
    assert (Iv : Im v = y) by (unfold v; simpl; ring).
    rewrite <- half_power by lra; apply H.
    + rewrite Cmod_power, Cmod_square, Rv, Iv; simpl in XY; lra.
    + intro I; assert (Y : x * y = 0).
      { clear - I Rv Iv; destruct v as [p q]; simpl in *; subst; nra. }
      apply Rmult_integral in Y; destruct Y as [Y | Y]; [lra |]; clear - Rv Iv X Y; destruct v as [p q]; simpl in *; subst; nra.
  - intro H; exists n1, n0, a, e; split; [exact V |]; intros z Z I E.
    assert (N : z <> RtoC 0) by (intro K; rewrite K, Cmod_0 in Z; lra).
    assert (P := proj1 (Cmod_gt_0 z) N); set (t := Cangle_of z); assert (T : - PI < t < PI).
    { assert (X : -1 <= Re z / Cmod z <= 1).
      { assert (Rabs (Re z) <= Cmod z) by (eapply Rle_trans; [apply (Rmax_l (Rabs (fst z)) (Rabs (snd z))) | apply Rmax_Cmod]).
        apply Rabs_le_between in H0; split; [apply Rle_div_r | apply Rle_div_l]; lra. }
      assert (B := acos_bound (Re z / Cmod z)); assert (Pp := PI_RGT_0).
      assert (F : acos (Re z / Cmod z) <> PI).
      { intro A; assert (C := cos_acos _ X); rewrite A, cos_PI in C.
        assert (R : Re z = - Cmod z) by (replace (Re z) with (Re z / Cmod z * Cmod z) by (field; lra); rewrite <- C; ring).
        assert (S := Cmod_square z); assert (Im z = 0) by (simpl in S; nra); specialize (I H0); lra. }
      unfold t, Cangle_of; destruct (Rle_dec 0 (Im z)) as [J | J]; [lra |].
      lra. }
    set (v := Cexp (RtoC (1 / 2) * Clog z)%C); assert (V2 : (v^2)%C = z).
    { transitivity (Cexp (Clog z)); [| exact (Cexp_log z N)]; unfold v; simpl.
      rewrite Cmult_1_r, <- Cexp_plus; f_equal; rewrite RtoC_div by lra; field. }
    assert (Rv : 0 < Re v).
    { change (0 < exp (Re (RtoC (1 / 2) * Clog z)%C) * cos (Im (RtoC (1 / 2) * Clog z)%C)).
      replace (Im (RtoC (1 / 2) * Clog z)%C) with (t / 2) by (unfold t, Clog; simpl; field).
      apply Rmult_lt_0_compat; [apply exp_pos | apply cos_gt_0; lra]. }
    assert (D : v = (RtoC (Re v) + Ci * RtoC (Im v))%C) by (destruct v; apply injective_projections; simpl; ring).
    apply (H (Re v) (Im v) Rv).
    + assert (S := Cmod_square v); assert (Q := f_equal Cmod V2); rewrite Cmod_power in Q; simpl in S, Q; simpl; lra.
    + rewrite <- D, <- (half_power v l Rv), V2; exact E.
Qed.

(* -- the numbers of a device, by its poles ------------------------------------------------------- *)

(* With s^2 + delta s + gamma = (s - p) (s - q). *)
Theorem device_by_poles : forall gamma delta n_1 n_0 a e (p q : C), device gamma delta n_1 n_0 a e ->
  (p + q = - delta)%C -> (p * q = gamma)%C -> p <> q ->
  let h := ((Cexp p - Cexp q) / (p - q))%C in let v := ((p * Cexp p - q * Cexp q) / (p - q))%C in
  RtoC a = (Cexp p + Cexp q)%C /\ RtoC e = RtoC (exp (- delta)) /\
  (gamma <> 0 -> RtoC n_1 = (((Cexp p - 1) / p - (Cexp q - 1) / q) / (p - q))%C) /\ RtoC n_0 = (h * h - v * n_1)%C.
Proof.
  intros g d n1 n0 a e p q V S P N h v; destruct (device_shape _ _ _ _ _ _ V) as (c & s & W & K & A & E & N0 & One & _).
  set (r := exp (- d / 2)) in *; set (w := ((p - q) / 2)%C).
  assert (Two : RtoC 2 <> RtoC 0) by (apply Cnot_zero; lra).
  assert (D : (p - q)%C <> RtoC 0) by (intro Z; apply N; replace p with (p - q + q)%C by ring; rewrite Z; ring).
  assert (Q : (w * w)%C = RtoC (d^2 / 4 - g)).
  { transitivity (((p + q) * (p + q)) / 4 - p * q)%C; [unfold w; field |].
    rewrite S, P, RtoC_minus, RtoC_div by lra; simpl; rewrite !RtoC_mult; field. }
  assert (X := as_exponential _ _ _ W w Q 1); assert (Y := as_exponential _ _ _ W (- w)%C ltac:(rewrite <- Q; ring) 1).
  replace (w * 1)%C with w in X by ring; replace (- w * 1)%C with (- w)%C in Y by ring.
  assert (R0 : Cexp (RtoC (- d / 2)) = RtoC r).
  { rewrite (Cexp_at _ (- d / 2) 0) by (apply injective_projections; simpl; ring).
    rewrite cos_0, sin_0; unfold r; apply injective_projections; simpl; ring. }
  assert (Ep : Cexp p = (RtoC r * (RtoC (c 1) + w * RtoC (s 1)))%C).
  { rewrite <- X, <- R0, <- Cexp_plus; f_equal; rewrite RtoC_div by lra; rewrite RtoC_opp, <- S; unfold w; field. }
  assert (Eq : Cexp q = (RtoC r * (RtoC (c 1) - w * RtoC (s 1)))%C).
  { replace (c 1 - w * s 1)%C with (c 1 + - w * s 1)%C by ring.
    rewrite <- Y, <- R0, <- Cexp_plus; f_equal; rewrite RtoC_div by lra; rewrite RtoC_opp, <- S; unfold w; field. }
  assert (Hh : RtoC (r * s 1) = h).
  { unfold h; rewrite Ep, Eq, RtoC_mult; unfold w; field; exact D. }
  assert (Hv : RtoC (r * (c 1 - d / 2 * s 1)) = v).
  { rewrite RtoC_mult, RtoC_minus, RtoC_mult, RtoC_div by lra; replace (RtoC d) with (- (p + q))%C by (rewrite S; ring).
    unfold v; rewrite Ep, Eq; unfold w; field; exact D. }
  split; [rewrite A, Ep, Eq, !RtoC_mult; ring |]; split; [rewrite E; reflexivity |]; split.
  - intro G; assert (Np : p <> RtoC 0) by (intro Z; apply G, RtoC_inj; rewrite <- P, Z; ring).
    assert (Nq : q <> RtoC 0) by (intro Z; apply G, RtoC_inj; rewrite <- P, Z; ring).
    assert (Kc : (v + (- (p + q)) * h + p * q * RtoC n1)%C = RtoC 1).
    { rewrite <- Hv, <- Hh, S, P, <- !RtoC_opp, Ropp_involutive, <- !RtoC_mult, <- !RtoC_plus; f_equal; exact K. }
    replace (RtoC n1) with ((1 - v + (p + q) * h) / (p * q))%C.
    + unfold v, h; field; repeat split; assumption.
    + rewrite <- Kc at 1; field; split; assumption.
  - rewrite N0, RtoC_minus, (RtoC_mult (r * s 1) (r * s 1)), (RtoC_mult (r * (c 1 - d / 2 * s 1)) n1), Hh, Hv; reflexivity.
Qed.
Theorem device_unsprung : forall delta n_1 n_0 a e, device 0 delta n_1 n_0 a e -> delta <> 0 ->
  let h := (1 - e) / delta in a = 1 + e /\ e = exp (- delta) /\ n_1 = (1 - h) / delta /\ n_0 = h * h - e * n_1.
Proof.
  intros d n1 n0 a e V D h; assert (R0 := device_at_rest _ _ _ _ _ _ V); assert (E := device_loss _ _ _ _ _ _ V).
  destruct (device_shape _ _ _ _ _ _ V) as (c & s & W & K & A & _ & N & _ & Free).
  set (r := exp (- d / 2)) in *; set (x := r * s 1) in *; set (v := r * (c 1 - d / 2 * s 1)) in *.
  assert (Ae : a = 2 * v + d * x) by (rewrite A; unfold v, x; field).
  assert (Ve : v = e) by lra; specialize (Free eq_refl).
  assert (X : x = h) by (unfold h; apply Rmult_eq_reg_l with d; [| exact D]; replace (d * ((1 - e) / d)) with (1 - e) by (field; exact D); lra).
  split; [lra |]; split; [exact E |]; split; [| rewrite N, X, Ve; reflexivity].
  rewrite X in Free; replace (1 - h) with (d * n1) by lra; field; exact D.
Qed.
Theorem device_free : forall n_1 n_0 a e, device 0 0 n_1 n_0 a e -> a = 2 /\ e = 1 /\ n_1 = 1 / 2 /\ n_0 = 1 / 2.
Proof.
  intros n1 n0 a e V; assert (E := device_loss _ _ _ _ _ _ V); rewrite Ropp_0, exp_0 in E.
  assert (N := free_mass _ _ _ _ V); assert (R0 := device_at_rest _ _ _ _ _ _ V).
  assert (W := V); replace 0 with (0 ^ 2) in W at 1 by ring; destruct (undamped_device _ _ _ _ _ W) as [A B].
  repeat split; lra.
Qed.

(* -- swinging --------------------------------------------------------------------------------- *)

(* m x'' + b x' + k x = 0 has a motion exp(s t) sin(w t). *)
Definition swings (m b k w : R) : Prop :=
  exists (s : R) (v a : R -> R), let x := fun t => exp (s * t) * sin (w * t) in
    forall t, is_derive x t (v t) /\ is_derive v t (a t) /\ m * a t + b * v t + k * x t = 0.
Theorem swinging : forall m b k w, w <> 0 ->
  (swings m b k w <-> exists s, m * (s^2 - w^2) + b * s + k = 0 /\ 2 * m * s * w + b * w = 0).
Proof.
  intros m b k w W; split.
  - intros (s & v & a & H); exists s.
    assert (V : forall t, v t = exp (s * t) * (s * sin (w * t) + w * cos (w * t))).
    { intro t; destruct (H t) as (X & _ & _); rewrite <- (is_derive_unique _ _ _ X); apply is_derive_unique; auto_derive; [exact I | ring]. }
    assert (A : forall t, a t = exp (s * t) * ((s^2 - w^2) * sin (w * t) + 2 * s * w * cos (w * t))).
    { intro t; destruct (H t) as (_ & X & _); rewrite <- (is_derive_unique _ _ _ X), (Derive_ext _ _ t V).
      apply is_derive_unique; auto_derive; [exact I | ring]. }
    assert (E : forall t, (m * (s^2 - w^2) + b * s + k) * sin (w * t) + (2 * m * s * w + b * w) * cos (w * t) = 0).
    { intro t; destruct (H t) as (_ & _ & X); rewrite V, A in X; assert (P := exp_pos (s * t)).
      apply Rmult_eq_reg_l with (exp (s * t)); [rewrite Rmult_0_r, <- X; ring | lra]. }
    assert (E0 := E 0); rewrite Rmult_0_r, sin_0, cos_0 in E0.
    assert (E1 := E (PI / 2 / w)); replace (w * (PI / 2 / w)) with (PI / 2) in E1 by (field; exact W).
    rewrite sin_PI2, cos_PI2 in E1; split; lra.
  - intros (s & A & B); exists s, (fun t => exp (s * t) * (s * sin (w * t) + w * cos (w * t))),
      (fun t => exp (s * t) * ((s^2 - w^2) * sin (w * t) + 2 * s * w * cos (w * t))); intros x t; unfold x.
    split; [auto_derive; [exact I | ring] |]; split; [auto_derive; [exact I | ring] |].
    transitivity (exp (s * t) * ((m * (s^2 - w^2) + b * s + k) * sin (w * t) + (2 * m * s * w + b * w) * cos (w * t))); [ring |].
    rewrite A, B; ring.
Qed.
