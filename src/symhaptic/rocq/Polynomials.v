(* Polynomials with complex coefficients: where they vanish, and how their zeros move.
   A polynomial is the list of its coefficients, the lowest first. *)
From Symhaptic Require Export Prelude.
From Coq Require Export List.
From Coq Require Import Classical.
Open Scope list_scope.
Open Scope R_scope.

Fixpoint poly (a : list C) (z : C) : C :=
  match a with nil => RtoC 0 | x :: more => (x + z * poly more z)%C end.

(* -- powers ---------------------------------------------------------------------------- *)

Lemma Cpower_plus : forall z n m, (z ^ (n + m) = z ^ n * z ^ m)%C.
Proof. intros z n m; induction n as [| n IH]; simpl; [| rewrite IH]; ring. Qed.
Lemma Cpower_mult : forall z n m, (z ^ (n * m) = (z ^ m) ^ n)%C.
Proof. intros z n m; induction n as [| n IH]; simpl; [| rewrite Cpower_plus, IH]; ring. Qed.
Lemma Cpower_product : forall z w n, ((z * w) ^ n = z ^ n * w ^ n)%C.
Proof. intros z w n; induction n as [| n IH]; simpl; [| rewrite IH]; ring. Qed.
Lemma Cpower_one : forall n, (RtoC 1 ^ n = RtoC 1)%C.
Proof. induction n as [| n IH]; simpl; [| rewrite IH]; ring. Qed.
Lemma Cmod_power : forall z n, Cmod (z ^ n)%C = Cmod z ^ n.
Proof. intros z n; induction n as [| n IH]; simpl; [apply Cmod_1 | rewrite Cmod_mult, IH; reflexivity]. Qed.
Lemma Cexp_power : forall z n, (Cexp z ^ n)%C = Cexp (RtoC (INR n) * z)%C.
Proof.
  intros z n; induction n as [| n IH]; [symmetry; apply Cexp_nought; simpl; ring |].
  rewrite S_INR, RtoC_plus; simpl; rewrite IH, <- Cexp_plus; f_equal; ring.
Qed.
Lemma Cdiv_zero : forall z w, w <> RtoC 0 -> (z / w)%C = RtoC 0 -> z = RtoC 0.
Proof. intros z w N E; replace z with (z / w * w)%C by (field; exact N); rewrite E; ring. Qed.
(* Every complex number has a root of every order. *)
Lemma Croot : forall z n, (0 < n)%nat -> exists w, (w ^ n)%C = z.
Proof.
  intros z n L; destruct (Ceq_dec z 0) as [E | N].
  - exists (RtoC 0); rewrite E; destruct n; [lia | simpl; ring].
  - assert (RtoC (INR n) <> RtoC 0) by (apply Cnot_zero, not_0_INR; lia).
    exists (Cexp (Clog z / RtoC (INR n))%C); rewrite Cexp_power.
    transitivity (Cexp (Clog z)); [f_equal; field; assumption | exact (Cexp_log z N)].
Qed.

(* -- sums and products ----------------------------------------------------------------- *)

Fixpoint add (a b : list C) : list C :=
  match a, b with x :: a, y :: b => (x + y)%C :: add a b | _, nil => a | nil, _ => b end.
Definition scale (c : C) (a : list C) : list C := map (Cmult c) a.
Lemma poly_add : forall a b z, poly (add a b) z = (poly a z + poly b z)%C.
Proof. induction a as [| x a IH]; intros [| y b] z; simpl; try ring; rewrite IH; ring. Qed.
Lemma poly_scale : forall c a z, poly (scale c a) z = (c * poly a z)%C.
Proof. intros c a z; induction a as [| x a IH]; simpl; [| rewrite IH]; ring. Qed.
Lemma poly_app : forall a b z, poly (a ++ b) z = (poly a z + z ^ length a * poly b z)%C.
Proof. induction a as [| x a IH]; intros b z; simpl; [| rewrite IH]; ring. Qed.
Lemma length_add : forall a b, length (add a b) = max (length a) (length b).
Proof. induction a as [| x a IH]; intros [| y b]; simpl; try reflexivity; rewrite IH; reflexivity. Qed.
Lemma length_scale : forall c a, length (scale c a) = length a.
Proof. intros; apply map_length. Qed.
Lemma last_add : forall a b, (length b < length a)%nat -> last (add a b) (RtoC 0) = last a (RtoC 0).
Proof.
  induction a as [| x a IH]; intros [| y b] L; simpl in L; try lia; try reflexivity.
  destruct a as [| x' a]; [simpl in L; lia |].
  specialize (IH b ltac:(simpl in *; lia)); destruct b; exact IH.
Qed.

(* -- conjugates ------------------------------------------------------------------------ *)

Lemma Cmod_conj : forall z, Cmod (Cconj z) = Cmod z.
Proof. intros [x y]; unfold Cmod, Cconj; simpl; f_equal; ring. Qed.
Lemma conj_conj : forall z, Cconj (Cconj z) = z.
Proof. intros [x y]; unfold Cconj; simpl; f_equal; ring. Qed.
Lemma conj_plus : forall x y, Cconj (x + y)%C = (Cconj x + Cconj y)%C.
Proof. intros; apply injective_projections; simpl; ring. Qed.
Lemma conj_minus : forall x y, Cconj (x - y)%C = (Cconj x - Cconj y)%C.
Proof. intros; apply injective_projections; simpl; ring. Qed.
Lemma conj_mult : forall x y, Cconj (x * y)%C = (Cconj x * Cconj y)%C.
Proof. intros; apply injective_projections; simpl; ring. Qed.
Lemma conj_power : forall z n, Cconj (z ^ n)%C = (Cconj z ^ n)%C.
Proof.
  intros z n; induction n as [| n IH]; simpl; [apply injective_projections; simpl; ring |].
  rewrite conj_mult, IH; reflexivity.
Qed.
Lemma conj_apart : forall z, z <> RtoC 0 -> Cconj z <> RtoC 0.
Proof. intros z N E; apply N; rewrite <- (conj_conj z), E; apply injective_projections; simpl; ring. Qed.
Lemma conj_inverse : forall z, z <> RtoC 0 -> Cconj (/ Cconj z)%C = (/ z)%C.
Proof.
  intros z N; assert (M := conj_apart z N).
  replace (/ z)%C with (Cconj (Cconj z * / Cconj z) * / z)%C by (rewrite Cinv_r by exact M; apply injective_projections; simpl; ring).
  rewrite conj_mult, conj_conj; field; exact N.
Qed.

(* -- size ------------------------------------------------------------------------------ *)

(* A polynomial is bounded on a disc, and changes there no faster than a multiple of the way. *)
Lemma bounded : forall a r, 0 <= r -> exists k, 0 < k /\ forall z, Cmod z <= r -> Cmod (poly a z) <= k.
Proof.
  intros a r P; induction a as [| x a (k & K & B)]; simpl.
  - exists 1; split; [lra |]; intros z _; rewrite Cmod_0; lra.
  - exists (Cmod x + r * k + 1); split; [generalize (Cmod_ge_0 x); nra |]; intros z Z.
    eapply Rle_trans; [apply Cmod_triangle |]; rewrite Cmod_mult.
    generalize (B z Z) (Cmod_ge_0 z) (Cmod_ge_0 (poly a z)); nra.
Qed.
Lemma steady : forall a r, 0 <= r -> exists k, 0 < k /\
  forall z w, Cmod z <= r -> Cmod w <= r -> Cmod (poly a z - poly a w)%C <= k * Cmod (z - w)%C.
Proof.
  intros a r P; induction a as [| x a (k & K & B)]; simpl.
  - exists 1; split; [lra |]; intros z w _ _; replace (0 - 0)%C with (RtoC 0) by ring; rewrite Cmod_0.
    generalize (Cmod_ge_0 (z - w)%C); lra.
  - destruct (bounded a r P) as (m & M & D); exists (r * k + m); split; [nra |]; intros z w Z W.
    replace (x + z * poly a z - (x + w * poly a w))%C with
      (z * (poly a z - poly a w) + (z - w) * poly a w)%C by ring.
    eapply Rle_trans; [apply Cmod_triangle |]; rewrite !Cmod_mult.
    generalize (B z w Z W) (D w W) (Cmod_ge_0 z) (Cmod_ge_0 (z - w)%C) (Cmod_ge_0 (poly a w))
      (Cmod_ge_0 (poly a z - poly a w)%C); nra.
Qed.
(* Of degree n it is no larger than a multiple of (1 + |z|)^n, ... *)
Lemma no_larger : forall a n, (length a <= S n)%nat ->
  exists k, 0 < k /\ forall z, Cmod (poly a z) <= k * (1 + Cmod z) ^ n.
Proof.
  induction a as [| x a IH]; intros n L.
  - exists 1; split; [lra |]; intro z; simpl; rewrite Cmod_0, Rmult_1_l.
    apply pow_le; generalize (Cmod_ge_0 z); lra.
  - destruct n as [| n].
    + destruct a; [| simpl in L; lia]; exists (Cmod x + 1); split; [generalize (Cmod_ge_0 x); lra |].
      intro z; simpl; replace (x + z * 0)%C with x by ring; lra.
    + destruct (IH n ltac:(simpl in L; lia)) as (k & K & B); exists (Cmod x + k).
      split; [generalize (Cmod_ge_0 x); lra |]; intro z; simpl.
      eapply Rle_trans; [apply Cmod_triangle |]; rewrite Cmod_mult.
      assert (Z := Cmod_ge_0 z); assert (P : 1 <= (1 + Cmod z) ^ n) by (apply pow_R1_Rle; lra).
      generalize (B z) (Cmod_ge_0 x); revert P; generalize ((1 + Cmod z) ^ n) as p; intros p P D X.
      assert (Cmod z * Cmod (poly a z) <= Cmod z * (k * p)) by (apply Rmult_le_compat_l; assumption).
      assert (0 <= Cmod x * (p - 1)) by (apply Rmult_le_pos; lra).
      assert (0 <= Cmod x * (Cmod z * p)) by (apply Rmult_le_pos; nra).
      assert (0 <= k * p) by nra; lra.
Qed.
(* ... and far away no smaller than a multiple of |z|^n. *)
Lemma no_smaller : forall a c, c <> RtoC 0 -> exists k r, 0 < k /\ 1 <= r /\
  forall z, r <= Cmod z -> k * Cmod z ^ length a <= Cmod (poly (a ++ c :: nil) z).
Proof.
  intros a c N; assert (P := proj1 (Cmod_gt_0 c) N); induction a as [| x a (k & r & K & Q & B)].
  - exists (Cmod c), 1; repeat split; [exact P | lra |]; intros z _; simpl.
    replace (c + z * 0)%C with c by ring; lra.
  - assert (X := Cmod_ge_0 x); exists (k / 2), (r + 2 * Cmod x / k).
    assert (0 <= 2 * Cmod x / k) by (apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, K]).
    repeat split; [lra | lra |]; intros z Z; simpl.
    assert (T : Cmod (z * poly (a ++ c :: nil) z)%C <= Cmod (x + z * poly (a ++ c :: nil) z)%C + Cmod x).
    { replace (z * poly (a ++ c :: nil) z)%C with ((x + z * poly (a ++ c :: nil) z) + - x)%C at 1 by ring.
      eapply Rle_trans; [apply Cmod_triangle | rewrite Cmod_opp; lra]. }
    rewrite Cmod_mult in T; specialize (B z ltac:(lra)).
    assert (1 <= Cmod z ^ length a) by (apply pow_R1_Rle; lra).
    assert (2 * Cmod x <= k * Cmod z).
    { replace (2 * Cmod x) with (k * (2 * Cmod x / k)) by (field; lra); apply Rmult_le_compat_l; lra. }
    assert (k * Cmod z <= k * Cmod z * Cmod z ^ length a) by nra.
    assert (Cmod z * (k * Cmod z ^ length a) <= Cmod z * Cmod (poly (a ++ c :: nil) z)).
    { apply Rmult_le_compat_l; lra. }
    nra.
Qed.

(* -- the fundamental theorem of algebra ------------------------------------------------- *)

(* Near z the polynomial is p(z) + c w^k + ..., unless it is constant. *)
Fixpoint shifted (z : C) (a : list C) : list C :=
  match a with nil => nil | x :: a => add (x :: nil) (add (scale z (shifted z a)) (RtoC 0 :: shifted z a)) end.
Lemma poly_shifted : forall z a w, poly (shifted z a) w = poly a (z + w)%C.
Proof. intros z a w; induction a as [| x a IH]; [reflexivity |]; cbn [shifted]; rewrite !poly_add, poly_scale; simpl; rewrite IH; ring. Qed.
Lemma first_power : forall a, (forall w, poly a w = poly a 0) \/
  exists k c b, c <> RtoC 0 /\ forall w, poly a w = (poly a 0 + w ^ S k * (c + w * poly b w))%C.
Proof.
  intros [| x a]; [left; reflexivity |].
  assert (Q : (forall w, poly a w = RtoC 0) \/
    exists k c b, c <> RtoC 0 /\ forall w, poly a w = (w ^ k * (c + w * poly b w))%C).
  { induction a as [| y a IH]; [left; reflexivity |].
    destruct (Ceq_dec y 0) as [E | N].
    - destruct IH as [IH | (k & c & b & N & IH)]; [left | right; exists (S k), c, b; split; [exact N |]];
        intro w; simpl; rewrite IH, E; ring.
    - right; exists 0%nat, y, a; split; [exact N |]; intro w; simpl; ring. }
  destruct Q as [Q | (k & c & b & N & Q)]; [left | right; exists k, c, b; split; [exact N |]];
    intro w; simpl; rewrite Q; ring.
Qed.
(* Where it is not zero it is smaller next by, as p(z) (1 - t^k) + ... is for some w and small t. *)
Lemma smaller_near : forall a z, poly a z <> RtoC 0 ->
  (forall w, poly a w = poly a z) \/ exists w, Cmod (poly a w) < Cmod (poly a z).
Proof.
  intros a z N; destruct (first_power (shifted z a)) as [F | (k & c & b & M & F)].
  - left; intro w; replace w with (z + (w - z))%C by ring; rewrite <- poly_shifted, F, poly_shifted; f_equal; ring.
  - right; set (v := poly a z) in *.
    destruct (Croot (- v / c)%C (S k) ltac:(lia)) as [u U].
    destruct (bounded b (Cmod u) (Cmod_ge_0 u)) as (m & K & B).
    assert (P := proj1 (Cmod_gt_0 v) N); set (s := Cmod u ^ S k * Cmod u * m).
    assert (S0 : 0 <= s) by (apply Rmult_le_pos; [apply Rmult_le_pos; [apply pow_le |] |]; try apply Cmod_ge_0; lra).
    set (t := Cmod v / (Cmod v + s)).
    assert (T : 0 < t <= 1) by (unfold t; split; [apply Rdiv_lt_0_compat; lra | apply Rle_div_l; lra]).
    assert (Ts : t * s < Cmod v).
    { assert (E : t * (Cmod v + s) = Cmod v) by (unfold t; field; lra); nra. }
    exists (z + RtoC t * u)%C; rewrite <- poly_shifted, F.
    replace (poly (shifted z a) 0) with v by (rewrite poly_shifted; unfold v; f_equal; ring).
    replace (v + (RtoC t * u) ^ S k * (c + RtoC t * u * poly b (RtoC t * u)))%C with
      (RtoC (1 - t ^ S k) * v + RtoC (t ^ S k * t) * (u ^ S k * u * poly b (RtoC t * u)))%C.
    2: { rewrite Cpower_product, RtoC_minus, RtoC_mult, RtoC_power, U; field; exact M. }
    eapply Rle_lt_trans; [apply Cmod_triangle |]; rewrite !Cmod_mult, !Cmod_R, Cmod_power.
    assert (Tk : 0 < t ^ S k <= 1).
    { split; [apply pow_lt; lra | rewrite <- (pow1 (S k)); apply pow_incr; lra]. }
    rewrite !Rabs_pos_eq by nra.
    assert (Y : Cmod u ^ S k * Cmod u * Cmod (poly b (RtoC t * u)%C) <= s).
    { apply Rmult_le_compat_l; [apply Rmult_le_pos; [apply pow_le |]; apply Cmod_ge_0 |].
      apply B; rewrite Cmod_mult, Cmod_R, Rabs_pos_eq by lra; generalize (Cmod_ge_0 u); nra. }
    assert (t ^ S k * (t * s) < t ^ S k * Cmod v) by (apply Rmult_lt_compat_l; lra).
    assert (t ^ S k * t * (Cmod u ^ S k * Cmod u * Cmod (poly b (RtoC t * u)%C)) <= t ^ S k * t * s).
    { apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact Y]. }
    lra.
Qed.
Lemma Cmod_2max : forall x y : R, Cmod (x, y) <= 2 * Rmax (Rabs x) (Rabs y).
Proof.
  intros x y; eapply Rle_trans; [apply Cmod_2Rmax | apply Rmult_le_compat_r].
  - eapply Rle_trans; [apply Rabs_pos | apply Rmax_l].
  - rewrite <- (sqrt_square 2) at 2 by lra; apply sqrt_le_1_alt; lra.
Qed.
(* A polynomial of positive degree comes closest to zero somewhere: on a square that is large enough
   by compactness, and outside it is larger. *)
Lemma smallest : forall a c, c <> RtoC 0 -> a <> nil ->
  exists z, forall w, Cmod (poly (a ++ c :: nil) z) <= Cmod (poly (a ++ c :: nil) w).
Proof.
  intros a c N A; set (p := poly (a ++ c :: nil)).
  destruct (completeness (fun y => forall z, y <= Cmod (p z))) as (m & U & L).
  { exists (Cmod (p 0)); intros y Y; apply Y. }
  { exists 0; intro z; apply Cmod_ge_0. }
  assert (Lower : forall z, m <= Cmod (p z)) by (intro z; apply L; intros y Y; apply Y).
  apply NNPP; intro None.
  assert (Above : forall z, m < Cmod (p z)).
  { intro z; apply Rnot_le_lt; intro Z; apply None; exists z; intro w; generalize (Lower w); fold p; lra. }
  destruct (no_smaller a c N) as (k & r & K & R1 & Far); fold p in Far.
  set (q := r + (m + 1) / k).
  assert (M : 0 <= m) by (apply U; intro z; apply Cmod_ge_0).
  assert (Q : 0 <= (m + 1) / k) by (apply Rdiv_le_0_compat; lra).
  assert (Outside : forall z, q <= Cmod z -> m + 1 <= Cmod (p z)).
  { intros z Z; eapply Rle_trans; [| apply Far; unfold q in Z; lra].
    assert (Cmod z <= Cmod z ^ length a).
    { destruct a as [| x a]; [contradiction |]; simpl; rewrite <- (Rmult_1_r (Cmod z)) at 1.
      apply Rmult_le_compat_l; [apply Cmod_ge_0 | apply pow_R1_Rle; unfold q in Z; lra]. }
    replace (m + 1) with (k * ((m + 1) / k)) by (field; lra).
    apply Rmult_le_compat_l; unfold q in Z; lra. }
  destruct (steady (a ++ c :: nil) (2 * q) ltac:(unfold q; lra)) as (l & Lp & St); fold p in St.
  assert (W : forall u v, 0 < (Cmod (p (u, v)) - m) / (4 * l)).
  { intros u v; apply Rdiv_lt_0_compat; [generalize (Above (u, v)) |]; lra. }
  set (width := fun u v => mkposreal _ (W u v)).
  destruct (compactness_value_2d (- q) q (- q) q width) as [d D].
  assert (Inside : forall z, Cmod z <= q -> m + 2 * l * d <= Cmod (p z)).
  { intros [x y] Z; apply Rnot_lt_le; intro Less.
    assert (Rabs x <= q /\ Rabs y <= q) as [X Y].
    { generalize (Rmax_Cmod (x, y)) (Rmax_l (Rabs x) (Rabs y)) (Rmax_r (Rabs x) (Rabs y)); simpl; lra. }
    apply Rabs_le_between in X, Y; apply (D x y X Y); intros (u & v & Ur & Vr & Ux & Vy & Wd).
    assert (Near : Cmod ((u, v) - (x, y))%C <= 2 * width u v).
    { eapply Rle_trans; [apply (Cmod_2max (u - x) (v - y)) | apply Rmult_le_compat_l; [lra |]].
      apply Rmax_lub; rewrite Rabs_minus_sym; apply Rlt_le; assumption. }
    assert (Cmod (u, v) <= 2 * q).
    { eapply Rle_trans; [apply Cmod_2max | apply Rmult_le_compat_l; [lra |]].
      apply Rmax_lub; apply Rabs_le_between; assumption. }
    assert (Gap := St (u, v) (x, y) ltac:(assumption) ltac:(lra)).
    assert (Cmod (p (u, v)) <= Cmod (p (x, y)) + Cmod (p (u, v) - p (x, y))%C).
    { replace (p (u, v)) with (p (x, y) + (p (u, v) - p (x, y)))%C at 1 by ring; apply Cmod_triangle. }
    assert (l * (2 * width u v) = (Cmod (p (u, v)) - m) / 2) by (simpl; field; lra).
    assert (l * Cmod ((u, v) - (x, y))%C <= l * (2 * width u v)) by (apply Rmult_le_compat_l; lra).
    assert (l * d <= l * width u v) by (apply Rmult_le_compat_l; lra).
    lra. }
  assert (0 < 2 * l * d) by (apply Rmult_lt_0_compat; [lra | apply cond_pos]).
  assert (m + Rmin 1 (2 * l * d) <= m).
  { apply U; intro z; destruct (Rle_dec q (Cmod z)) as [Z | Z].
    - generalize (Outside z Z) (Rmin_l 1 (2 * l * d)); lra.
    - generalize (Inside z ltac:(lra)) (Rmin_r 1 (2 * l * d)); lra. }
  generalize (Rmin_glb_lt 1 (2 * l * d) 0 ltac:(lra) ltac:(assumption)); lra.
Qed.
Theorem has_zero : forall a c, c <> RtoC 0 -> a <> nil -> exists z, poly (a ++ c :: nil) z = RtoC 0.
Proof.
  intros a c N A; destruct (smallest a c N A) as [z Z]; exists z; apply NNPP; intro M.
  destruct (smaller_near _ z M) as [F | (w & W)]; [| generalize (Z w); lra].
  destruct (no_smaller a c N) as (k & r & K & R1 & Far).
  set (b := Cmod (poly (a ++ c :: nil) z)) in *; set (x := r + b / k + 1).
  assert (B : 0 <= b / k) by (apply Rdiv_le_0_compat; [apply Cmod_ge_0 | exact K]).
  assert (X : Cmod (RtoC x) = x) by (rewrite Cmod_R; apply Rabs_pos_eq; unfold x; lra).
  specialize (Far (RtoC x) ltac:(rewrite X; unfold x; lra)); rewrite F, X in Far; fold b in Far.
  assert (x <= x ^ length a).
  { destruct a as [| y a]; [contradiction |]; simpl; rewrite <- (Rmult_1_r x) at 1.
    apply Rmult_le_compat_l; [| apply pow_R1_Rle]; unfold x; lra. }
  assert (k * (b / k) = b) by (field; lra); unfold x in *; nra.
Qed.

(* -- factors ---------------------------------------------------------------------------- *)

Definition product (rs : list C) (z : C) : C := fold_right (fun r p => ((z - r) * p)%C) (RtoC 1) rs.
Fixpoint quotient (r : C) (a : list C) : list C :=
  match a with nil => nil | _ :: a => add a (scale r (quotient r a)) end.
Lemma divided : forall r a z, poly a z = ((z - r) * poly (quotient r a) z + poly a r)%C.
Proof.
  intros r a z; induction a as [| x a IH]; simpl; [ring |].
  rewrite poly_add, poly_scale, IH; ring.
Qed.
Lemma length_quotient : forall r a, length (quotient r a) = pred (length a).
Proof. intros r a; induction a as [| x a IH]; simpl; [reflexivity |]; rewrite length_add, length_scale, IH; lia. Qed.
Lemma last_quotient : forall r x y a, last (quotient r (x :: y :: a)) (RtoC 0) = last (y :: a) (RtoC 0).
Proof.
  intros r x y a; change (quotient r (x :: y :: a)) with (add (y :: a) (scale r (quotient r (y :: a)))).
  apply last_add; rewrite length_scale, length_quotient; simpl; lia.
Qed.
Theorem factors : forall n a, length a = S n -> last a (RtoC 0) <> RtoC 0 ->
  exists rs, length rs = n /\ forall z, poly a z = (last a (RtoC 0) * product rs z)%C.
Proof.
  induction n as [| n IH]; intros [| x [| y a]] L N; simpl in L; try lia.
  - exists nil; split; [reflexivity |]; intro z; simpl; ring.
  - destruct (has_zero (removelast (x :: y :: a)) _ N) as [r Z]; [discriminate |].
    rewrite <- app_removelast_last in Z by discriminate.
    destruct (IH (quotient r (x :: y :: a))) as (rs & M & F).
    { rewrite length_quotient; simpl; lia. }
    { rewrite last_quotient; exact N. }
    exists (r :: rs); split; [simpl; lia |]; intro z.
    rewrite (divided r), Z, F, last_quotient; simpl; ring.
Qed.
Lemma product_zero : forall rs r, In r rs -> product rs r = RtoC 0.
Proof.
  induction rs as [| s rs IH]; intros r I; [destruct I |]; destruct I as [E | I]; simpl.
  - rewrite E; ring.
  - rewrite (IH r I); ring.
Qed.
Lemma zero_product : forall rs z, product rs z = RtoC 0 -> In z rs.
Proof.
  induction rs as [| s rs IH]; simpl; intros z E.
  - apply (f_equal fst) in E; simpl in E; lra.
  - destruct (Ceq_dec (z - s)%C 0) as [F | N].
    + left; replace s with (z - (z - s))%C by ring; rewrite F; ring.
    + right; apply IH; replace (product rs z) with ((z - s) * product rs z / (z - s))%C by (field; exact N).
      rewrite E; field; exact N.
Qed.
(* A polynomial that vanishes everywhere has no coefficients but 0. *)
Theorem vanishing : forall a, (forall z, poly a z = RtoC 0) -> Forall (fun c => c = RtoC 0) a.
Proof.
  induction a as [| x a IH]; intro V; constructor.
  - rewrite <- (V (RtoC 0)); simpl; ring.
  - assert (X : x = RtoC 0) by (rewrite <- (V (RtoC 0)); simpl; ring).
    assert (Away : forall z, z <> RtoC 0 -> poly a z = RtoC 0).
    { intros z N; generalize (V z); simpl; rewrite X; intro E.
      replace (poly a z) with ((0 + z * poly a z) / z)%C by (field; exact N); rewrite E; field; exact N. }
    apply IH; intro z; destruct (Ceq_dec z 0) as [E | N]; [| exact (Away z N)].
    rewrite E; apply NNPP; intro M; assert (P := proj1 (Cmod_gt_0 _) M).
    destruct (steady a 1 ltac:(lra)) as (k & K & S); set (v := Cmod (poly a 0)) in *.
    set (t := Rmin 1 (v / (2 * k))).
    assert (T : 0 < t) by (apply Rmin_glb_lt; [lra | apply Rdiv_lt_0_compat; lra]).
    assert (Ct : Cmod (RtoC t) = t) by (rewrite Cmod_R; apply Rabs_pos_eq; lra).
    specialize (S (RtoC 0) (RtoC t)); rewrite (Away (RtoC t)), Ct, Cmod_0 in S by (apply Cnot_zero; lra).
    replace (poly a 0 - 0)%C with (poly a 0) in S by ring; fold v in S.
    replace (0 - t)%C with (- RtoC t)%C in S by ring; rewrite Cmod_opp, Ct in S.
    specialize (S ltac:(lra) (Rmin_l _ _)).
    assert (k * t <= k * (v / (2 * k))) by (apply Rmult_le_compat_l; [lra | apply Rmin_r]).
    replace (k * (v / (2 * k))) with (v / 2) in * by (field; lra); lra.
Qed.

(* -- zeros along a path ------------------------------------------------------------------ *)

(* A region without zeros: no zero of p lies in it. *)
Definition free (region : C -> Prop) (p : C -> C) : Prop := forall z, region z -> p z <> RtoC 0.
Definition closed (region : C -> Prop) : Prop :=
  forall z, ~ region z -> exists e, 0 < e /\ forall w, Cmod (w - z)%C < e -> ~ region w.
Definition interior (region : C -> Prop) (z : C) : Prop :=
  exists e, 0 < e /\ forall w, Cmod (w - z)%C < e -> region w.

Section Path.
Variable region : C -> Prop.
Hypothesis Closed : closed region.

(* In a closed region a product of linear factors without zeros there is no smaller than a multiple
   of (1 + |z|)^n. *)
Lemma away : forall r, ~ region r -> exists k, 0 < k /\ forall z, region z -> k * (1 + Cmod z) <= Cmod (z - r)%C.
Proof.
  intros r N; destruct (Closed r N) as (e & E & B); set (q := 2 + 2 * Cmod r + 1).
  assert (Q : 0 <= Cmod r) by apply Cmod_ge_0.
  assert (R1 : 0 < Rmin (1 / 4) (e / (1 + q))).
  { apply Rmin_glb_lt; [lra | apply Rdiv_lt_0_compat; unfold q; lra]. }
  exists (Rmin (1 / 4) (e / (1 + q))); split; [exact R1 |]; intros z Z.
  assert (Far : e <= Cmod (z - r)%C) by (apply Rnot_lt_le; intro L; exact (B z L Z)).
  assert (T : Cmod z <= Cmod (z - r)%C + Cmod r).
  { replace z with ((z - r) + r)%C at 1 by ring; apply Cmod_triangle. }
  assert (P := Cmod_ge_0 z); destruct (Rle_dec q (Cmod z)) as [L | L].
  - assert (Rmin (1 / 4) (e / (1 + q)) * (1 + Cmod z) <= 1 / 4 * (1 + Cmod z)).
    { apply Rmult_le_compat_r; [lra | apply Rmin_l]. }
    unfold q in L; lra.
  - assert (W : Rmin (1 / 4) (e / (1 + q)) * (1 + Cmod z) <= e / (1 + q) * (1 + q)).
    { apply Rmult_le_compat; [lra | lra | apply Rmin_r | lra]. }
    replace (e / (1 + q) * (1 + q)) with e in W by (field; unfold q; nz); lra.
Qed.
Lemma product_away : forall rs, free region (product rs) ->
  exists k, 0 < k /\ forall z, region z -> k * (1 + Cmod z) ^ length rs <= Cmod (product rs z).
Proof.
  induction rs as [| r rs IH]; intro F; simpl.
  - exists 1; split; [lra |]; intros z _; rewrite Cmod_1; lra.
  - destruct IH as (k & K & B).
    { intros z Z E; apply (F z Z); simpl; rewrite E; ring. }
    destruct (away r) as (m & M & D).
    { intro I; apply (F r I); simpl; ring. }
    exists (m * k); split; [apply Rmult_lt_0_compat; assumption |]; intros z Z; rewrite Cmod_mult.
    replace (m * k * ((1 + Cmod z) * (1 + Cmod z) ^ length rs)) with
      (m * (1 + Cmod z) * (k * (1 + Cmod z) ^ length rs)) by ring.
    assert (P := Cmod_ge_0 z); apply Rmult_le_compat; [nra | | apply D; exact Z | apply B; exact Z].
    apply Rmult_le_pos; [lra | apply pow_le; lra].
Qed.
Lemma free_away : forall a c, c <> RtoC 0 -> free region (poly (a ++ c :: nil)) ->
  exists k, 0 < k /\ forall z, region z -> k * (1 + Cmod z) ^ length a <= Cmod (poly (a ++ c :: nil) z).
Proof.
  intros a c N F; destruct (factors (length a) (a ++ c :: nil)) as (rs & L & E).
  { rewrite app_length; simpl; lia. }
  { rewrite last_last; exact N. }
  rewrite last_last in E; destruct (product_away rs) as (k & K & B).
  { intros z Z V; apply (F z Z); rewrite E, V; ring. }
  assert (P := proj1 (Cmod_gt_0 c) N); exists (Cmod c * k); split; [apply Rmult_lt_0_compat; assumption |].
  intros z Z; rewrite E, Cmod_mult, <- L, Rmult_assoc; apply Rmult_le_compat_l; [lra | apply B; exact Z].
Qed.

(* On the path from f to f + g, where f is of higher degree, zeros stay outside the region as long as
   they do not cross its border: the set of y with all zeros of f + y g outside is open and closed. *)
Variables (a g : list C) (c : C).
Hypotheses (Lead : c <> RtoC 0) (Lower : (length g <= length a)%nat).
Let f := a ++ c :: nil.
Definition along (y : R) (z : C) : C := (poly f z + y * poly g z)%C.
Lemma along_poly : forall y, exists b, length b = length a /\ forall z, along y z = poly (b ++ c :: nil) z.
Proof.
  intro y; exists (add a (scale y g)); split; [rewrite length_add, length_scale; lia |].
  intro z; unfold along, f; rewrite !poly_app, length_add, length_scale, poly_add, poly_scale.
  replace (max (length a) (length g)) with (length a) by lia; ring.
Qed.
Lemma opens : forall y, free region (along y) -> exists e, 0 < e /\ forall x, Rabs (x - y) < e -> free region (along x).
Proof.
  intros y F; destruct (along_poly y) as (b & L & B), (no_larger g (length a) ltac:(lia)) as (m & M & U).
  destruct (free_away b c Lead) as (k & K & D); [intros z Z E; apply (F z Z); rewrite B; exact E |].
  rewrite L in D; exists (k / m); split; [apply Rdiv_lt_0_compat; assumption |]; intros x X z Z E.
  specialize (D z Z); rewrite <- B in D; specialize (U z).
  assert (P : 0 < (1 + Cmod z) ^ length a) by (apply pow_lt; generalize (Cmod_ge_0 z); lra).
  replace (along y z) with (along x z - RtoC (x - y) * poly g z)%C in D by (unfold along; rewrite RtoC_minus; ring).
  rewrite E in D; replace (0 - RtoC (x - y) * poly g z)%C with (- (RtoC (x - y) * poly g z))%C in D by ring.
  rewrite Cmod_opp, Cmod_mult, Cmod_R in D; set (q := (1 + Cmod z) ^ length a) in *.
  assert (Rabs (x - y) * Cmod (poly g z) <= Rabs (x - y) * (m * q)).
  { apply Rmult_le_compat_l; [apply Rabs_pos | exact U]. }
  assert (Rabs (x - y) * (m * q) < k / m * (m * q)) by (apply Rmult_lt_compat_r; [nra | exact X]).
  replace (k / m * (m * q)) with (k * q) in * by (field; lra); lra.
Qed.
Lemma product_far : forall rs e z, 0 < e -> (forall r, In r rs -> e <= Cmod (z - r)%C) ->
  e ^ length rs <= Cmod (product rs z).
Proof.
  induction rs as [| r rs IH]; intros e z E F; simpl; [rewrite Cmod_1; lra |].
  rewrite Cmod_mult; apply Rmult_le_compat; [lra | apply pow_le; lra | apply F; left; reflexivity |].
  apply IH; [exact E | intros s S; apply F; right; exact S].
Qed.
(* Next to a polynomial of the path with a zero z are others with zeros next to z. *)
Lemma followed : forall y z e, along y z = RtoC 0 -> 0 < e -> exists d, 0 < d /\
  forall x, Rabs (x - y) < d -> exists w, Cmod (w - z)%C < e /\ along x w = RtoC 0.
Proof.
  intros y z e V E; assert (P := proj1 (Cmod_gt_0 c) Lead); assert (G := Cmod_ge_0 (poly g z)).
  assert (Q : 0 < Cmod c * e ^ length a) by (apply Rmult_lt_0_compat; [exact P | apply pow_lt, E]).
  exists (Cmod c * e ^ length a / (1 + Cmod (poly g z))); split; [apply Rdiv_lt_0_compat; lra |]; intros x X.
  apply NNPP; intro None; destruct (along_poly x) as (b & L & B).
  destruct (factors (length b) (b ++ c :: nil)) as (rs & Lr & F).
  { rewrite app_length; simpl; lia. }
  { rewrite last_last; exact Lead. }
  rewrite last_last in F; assert (Far := product_far rs e z E); rewrite Lr, L in Far.
  assert (D : e ^ length a <= Cmod (product rs z)).
  { apply Far; intros r R; apply Rnot_lt_le; intro C; apply None; exists r; split.
    - replace (r - z)%C with (- (z - r))%C by ring; rewrite Cmod_opp; exact C.
    - rewrite B, F, product_zero by exact R; ring. }
  assert (T : along x z = (RtoC (x - y) * poly g z)%C).
  { replace (along x z) with (along x z - along y z)%C by (rewrite V; ring).
    unfold along; rewrite RtoC_minus; ring. }
  assert (Cmod (along x z) = Cmod c * Cmod (product rs z)) by (rewrite B, F; apply Cmod_mult).
  rewrite T, Cmod_mult, Cmod_R in *.
  assert (Cmod c * e ^ length a <= Cmod c * Cmod (product rs z)) by (apply Rmult_le_compat_l; lra).
  assert (Rabs (x - y) * (1 + Cmod (poly g z)) < Cmod c * e ^ length a).
  { apply Rmult_lt_reg_r with (/ (1 + Cmod (poly g z))); [apply Rinv_0_lt_compat; lra |].
    replace (Rabs (x - y) * (1 + Cmod (poly g z)) * / (1 + Cmod (poly g z))) with (Rabs (x - y)) by (field; nz).
    exact X. }
  generalize (Rabs_pos (x - y)); nra.
Qed.
Theorem path : free region (along 0) ->
  (forall y z, 0 < y <= 1 -> region z -> along y z = RtoC 0 -> interior region z) ->
  free region (along 1).
Proof.
  intros Start Inner; set (S := fun y => free region (along y)).
  destruct (completeness (fun y => 0 <= y <= 1 /\ forall x, 0 <= x <= y -> S x)) as (s & U & L).
  { exists 1; intros y [Y _]; lra. }
  { exists 0; split; [lra |]; intros x X; replace x with 0 by lra; exact Start. }
  assert (S0 : 0 <= s) by (apply U; split; [lra |]; intros x X; replace x with 0 by lra; exact Start).
  assert (S1 : s <= 1) by (apply L; intros y [Y _]; lra).
  assert (Below : forall x, 0 <= x < s -> S x).
  { intros x X; apply NNPP; intro N; assert (s <= x); [| lra].
    apply L; intros y [Y D]; apply Rnot_lt_le; intro Z; apply N, D; lra. }
  assert (There : S s).
  { destruct (Req_dec s 0) as [E | E]; [rewrite E; exact Start |].
    intros z Z V; destruct (Inner s z ltac:(lra) Z V) as (e & E1 & I), (followed s z e V E1) as (d & D & F).
    set (x := Rmax 0 (s - d / 2)).
    assert (X : 0 <= x < s /\ s - d / 2 <= x).
    { unfold x; split; [split; [apply Rmax_l | apply Rmax_lub_lt; lra] | apply Rmax_r]. }
    destruct (F x) as (w & W & Zero); [apply Rabs_def1; lra |].
    exact (Below x ltac:(lra) w (I w W) Zero). }
  destruct (Req_dec s 1) as [E | E]; [rewrite <- E; exact There |]; exfalso.
  destruct (opens s There) as (e & E1 & O); set (t := Rmin 1 (s + e / 2)).
  assert (T : s < t <= 1 /\ t <= s + e / 2).
  { unfold t; split; [split; [apply Rmin_glb_lt; lra | apply Rmin_l] | apply Rmin_r]. }
  assert (t <= s); [| lra]; apply U; split; [lra |]; intros x X.
  destruct (Rlt_le_dec x s); [apply Below; lra | apply O; apply Rabs_def1; lra].
Qed.
End Path.

(* A zero b of f = (z - b) h on the border moves, to first order, by - y g(b)/h(b). *)
Lemma departs : forall region b h g c, closed region -> c <> RtoC 0 -> (length g <= S (length h))%nat ->
  free region (poly (h ++ c :: nil)) -> exists k, 0 < k /\ forall y z, 0 < y <= 1 -> region z ->
  ((z - b) * poly (h ++ c :: nil) z + y * poly g z = RtoC 0)%C ->
  Cmod ((z - b) * poly (h ++ c :: nil) b + y * poly g b)%C <= k * y ^ 2.
Proof.
  intros region b h g c Closed N L F; set (f := h ++ c :: nil) in *.
  destruct (free_away region Closed h c N F) as (m & M & Low), (no_larger g (length h) L) as (n & Q & Up).
  set (q := n / m); assert (P : 0 < q) by (apply Rdiv_lt_0_compat; assumption).
  assert (R0 : 0 <= Cmod b + q) by (generalize (Cmod_ge_0 b); lra).
  destruct (steady f _ R0) as (k & K & Sf), (steady g _ R0) as (l & Lp & Sg).
  exists (q * (q * k) + q * l); split; [nra |]; intros y z Y Z E.
  set (w := (1 + Cmod z) ^ length h).
  assert (W : 0 < w) by (apply pow_lt; generalize (Cmod_ge_0 z); lra).
  assert (Near : Cmod (z - b)%C <= y * q).
  { assert (G : Cmod (z - b)%C * Cmod (poly f z) = y * Cmod (poly g z)).
    { rewrite <- Cmod_mult; replace ((z - b) * poly f z)%C with (- (RtoC y * poly g z))%C.
      - rewrite Cmod_opp, Cmod_mult, Cmod_R, Rabs_pos_eq by lra; reflexivity.
      - replace ((z - b) * poly f z)%C with ((z - b) * poly f z + y * poly g z - y * poly g z)%C by ring.
        rewrite E; ring. }
    apply Rmult_le_reg_r with (m * w); [nra |]; unfold q.
    replace (y * (n / m) * (m * w)) with (y * (n * w)) by (field; lra).
    assert (Cmod (z - b)%C * (m * w) <= Cmod (z - b)%C * Cmod (poly f z)).
    { apply Rmult_le_compat_l; [apply Cmod_ge_0 | apply Low; exact Z]. }
    assert (y * Cmod (poly g z) <= y * (n * w)) by (apply Rmult_le_compat_l; [lra | apply Up]).
    lra. }
  assert (Small : Cmod z <= Cmod b + q).
  { replace z with (b + (z - b))%C by ring; eapply Rle_trans; [apply Cmod_triangle |]; nra. }
  replace ((z - b) * poly f b + y * poly g b)%C with
    ((z - b) * (poly f b - poly f z) + y * (poly g b - poly g z) + ((z - b) * poly f z + y * poly g z))%C by ring.
  rewrite E; replace ((z - b) * (poly f b - poly f z) + y * (poly g b - poly g z) + 0)%C with
    ((z - b) * (poly f b - poly f z) + y * (poly g b - poly g z))%C by ring.
  eapply Rle_trans; [apply Cmod_triangle |]; rewrite !Cmod_mult, Cmod_R, Rabs_pos_eq by lra.
  specialize (Sf b z ltac:(lra) Small); specialize (Sg b z ltac:(lra) Small).
  replace (b - z)%C with (- (z - b))%C in Sf, Sg by ring; rewrite Cmod_opp in Sf, Sg.
  assert (D := Cmod_ge_0 (z - b)%C); set (x := Cmod (z - b)%C) in *.
  assert (x * Cmod (poly f b - poly f z)%C <= x * (k * x)) by (apply Rmult_le_compat_l; assumption).
  assert (x * (k * x) <= (y * q) * (k * (y * q))) by (apply Rmult_le_compat; nra).
  assert (y * Cmod (poly g b - poly g z)%C <= y * (l * (y * q))).
  { apply Rmult_le_compat_l; [lra |]; eapply Rle_trans; [exact Sg |]; apply Rmult_le_compat_l; lra. }
  simpl; lra.
Qed.

Lemma nth_add : forall a b n, nth n (add a b) (RtoC 0) = (nth n a (RtoC 0) + nth n b (RtoC 0))%C.
Proof. induction a as [| x a IH]; intros [| y b] [| n]; simpl; try ring; apply IH. Qed.
Lemma nth_scale : forall c a n, nth n (scale c a) (RtoC 0) = (c * nth n a (RtoC 0))%C.
Proof. intros c a; induction a as [| x a IH]; intros [| n]; simpl; try ring; apply IH. Qed.
Lemma coefficients : forall a b, (forall z, poly a z = poly b z) -> forall n, nth n a (RtoC 0) = nth n b (RtoC 0).
Proof.
  intros a b E n; assert (V := vanishing (add a (scale (- RtoC 1)%C b))).
  specialize (V ltac:(intro z; rewrite poly_add, poly_scale, E; ring)).
  assert (Z : nth n (add a (scale (- RtoC 1)%C b)) (RtoC 0) = RtoC 0).
  { destruct (Nat.lt_ge_cases n (length (add a (scale (- RtoC 1)%C b)))) as [L | L].
    - exact (proj1 (Forall_forall _ _) V _ (nth_In _ _ L)).
    - apply nth_overflow, L. }
  rewrite nth_add, nth_scale in Z; replace (nth n a (RtoC 0)) with (nth n a (RtoC 0) + - RtoC 1 * nth n b (RtoC 0) + nth n b (RtoC 0))%C by ring.
  rewrite Z; ring.
Qed.

(* A polynomial of degree n that z^n leads; one of lower degree than n; one with real coefficients. *)
Definition monic (p : C -> C) (n : nat) : Prop :=
  exists a, length a = n /\ forall z, p z = poly (a ++ RtoC 1 :: nil) z.
Definition below (p : C -> C) (n : nat) : Prop := exists a, (length a <= n)%nat /\ forall z, p z = poly a z.
Definition real_poly (p : C -> C) : Prop := forall z, p (Cconj z) = Cconj (p z).
Lemma real_along : forall f g y, real_poly f -> real_poly g -> real_poly (fun z => (f z + RtoC y * g z)%C).
Proof.
  intros f g y F G z; rewrite F, G; destruct (f z), (g z); apply injective_projections; simpl; ring.
Qed.

(* Real coefficients. *)
Definition reals (l : list R) : list C := map RtoC l.

(* -- sums of powers ------------------------------------------------------------------------------ *)

(* A polynomial as a chapter writes it: coefficients with their exponents, in any order. *)
Fixpoint powers (s : list (R * nat)) (z : C) : C :=
  match s with nil => RtoC 0 | (c, e) :: s => (RtoC c * z ^ e + powers s z)%C end.
Definition degrees_below (s : list (R * nat)) (n : nat) : Prop := Forall (fun t => (snd t < n)%nat) s.
Fixpoint monomial (c : R) (e : nat) : list R := match e with O => c :: nil | S e => 0 :: monomial c e end.
Lemma poly_monomial : forall c e z, poly (reals (monomial c e)) z = (RtoC c * z ^ e)%C.
Proof.
  intros c e z; induction e as [| e IH]; simpl; [ring |].
  fold (reals (monomial c e)); rewrite IH; ring.
Qed.
Lemma length_monomial : forall c e, length (monomial c e) = S e.
Proof. intros c e; induction e; simpl; auto. Qed.
Fixpoint rsum (a b : list R) : list R :=
  match a, b with x :: a, y :: b => x + y :: rsum a b | _, nil => a | nil, _ => b end.
Lemma poly_rsum : forall a b z, poly (reals (rsum a b)) z = (poly (reals a) z + poly (reals b) z)%C.
Proof.
  induction a as [| x a IH]; intros [| y b] z; simpl; try ring.
  fold (reals a) (reals b) (reals (rsum a b)); rewrite IH, RtoC_plus; ring.
Qed.
Lemma length_sum : forall a b, length (rsum a b) = max (length a) (length b).
Proof. induction a as [| x a IH]; intros [| y b]; simpl; try reflexivity; rewrite IH; reflexivity. Qed.
Fixpoint dense (s : list (R * nat)) : list R :=
  match s with nil => nil | (c, e) :: s => rsum (monomial c e) (dense s) end.
Lemma poly_dense : forall s z, poly (reals (dense s)) z = powers s z.
Proof.
  induction s as [| [c e] s IH]; intro z; simpl; [reflexivity |]; rewrite poly_rsum, poly_monomial, IH; reflexivity.
Qed.
Lemma length_dense : forall s n, degrees_below s n -> (length (dense s) <= n)%nat.
Proof.
  intros s n D; induction D as [| [c e] s E D IH]; simpl in *; [lia |].
  rewrite length_sum, length_monomial; lia.
Qed.
(* With trailing zeros, so that a power stands at its place. *)
Lemma led : forall c n s, degrees_below s n -> exists a, length a = n /\
  forall z, powers ((c, n) :: s) z = poly (reals (a ++ c :: nil)) z.
Proof.
  intros c n s D; exists (rsum (repeat 0 n) (dense s)); assert (L := length_dense s n D).
  rewrite length_sum, repeat_length; split; [lia |]; intro z.
  unfold reals; rewrite map_app, poly_app, map_length, length_sum, repeat_length; fold (reals (rsum (repeat 0 n) (dense s))).
  rewrite poly_rsum, poly_dense; replace (max n (length (dense s))) with n by lia.
  replace (poly (reals (repeat 0 n)) z) with (RtoC 0); [simpl; ring |].
  clear; induction n as [| n IH]; simpl; [reflexivity |]; fold (reals (repeat 0 n)); rewrite <- IH; ring.
Qed.
Lemma powers_monic : forall n s, degrees_below s n -> monic (powers ((1, n) :: s)) n.
Proof.
  intros n s D; destruct (led 1 n s D) as (a & L & E); exists (reals a); split; [unfold reals; rewrite map_length; exact L |].
  intro z; rewrite E; unfold reals; rewrite map_app; reflexivity.
Qed.
Lemma powers_below : forall n s, degrees_below s n -> below (powers s) n.
Proof.
  intros n s D; exists (reals (dense s)); split; [unfold reals; rewrite map_length; exact (length_dense s n D) |].
  intro z; symmetry; apply poly_dense.
Qed.
Lemma powers_real : forall s, real_poly (powers s).
Proof.
  intros s z; induction s as [| [c e] s IH]; simpl; [apply injective_projections; simpl; ring |].
  rewrite IH, conj_plus, conj_mult, conj_power, Cconj_real; reflexivity.
Qed.

(* The degree is the highest power whose coefficient is not zero. *)
Definition degree (p : C -> C) (n : R) : Prop :=
  exists a c, c <> RtoC 0 /\ n = INR (length a) /\ forall z, p z = poly (a ++ c :: nil) z.
Theorem degree_of : forall p c n s m, c <> 0 -> degrees_below s n -> (forall z, p z = powers ((c, n) :: s) z) ->
  m = INR n -> degree p m.
Proof.
  intros p c n s m N D P M; destruct (led c n s D) as (a & L & E); exists (reals a), (RtoC c).
  split; [apply Cnot_zero, N |]; split; [unfold reals; rewrite map_length, L; exact M |].
  intro z; rewrite P, E; unfold reals; rewrite map_app; reflexivity.
Qed.
Theorem no_degree : forall p n, (forall z, p z = RtoC 0) -> ~ degree p n.
Proof.
  intros p n Z (a & c & N & _ & P); apply N.
  assert (V := vanishing (a ++ c :: nil) ltac:(intro z; rewrite <- P; apply Z)).
  apply Forall_app in V; destruct V as [_ V]; inversion V; assumption.
Qed.
