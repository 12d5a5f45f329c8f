(* Passive filters and passive walls: no motion gains energy from a force that is computed at the samples.
   Toeplitz: Grenander and Szego, Toeplitz Forms and Their Applications, 5.2; walls: Colgate and Schenkel,
   J. Robot. Syst. 14(1), 1997. *)
From Symhaptic Require Export Loop.
From Coq Require QArith Qround Qreals Qreduction.
Open Scope R_scope.

(* -- sums ------------------------------------------------------------------------------------- *)

(* f 0 + ... + f (n - 1). *)
Fixpoint total (n : nat) (f : nat -> R) : R := match n with O => 0 | S m => total m f + f m end.
Lemma total_alike : forall n f g, (forall k, (k < n)%nat -> f k = g k) -> total n f = total n g.
Proof. intros n f g E; induction n as [| n IH]; simpl; [reflexivity |]; rewrite IH, E by (intros; try apply E; lia);
  reflexivity. Qed.
Lemma total_plus : forall n f g, total n (fun k => f k + g k) = total n f + total n g.
Proof. intros n f g; induction n as [| n IH]; simpl; [| rewrite IH]; ring. Qed.
Lemma total_times : forall n c f, total n (fun k => c * f k) = c * total n f.
Proof. intros n c f; induction n as [| n IH]; simpl; [| rewrite IH]; ring. Qed.
Lemma total_minus : forall n f g, total n (fun k => f k - g k) = total n f - total n g.
Proof. intros n f g; induction n as [| n IH]; simpl; [| rewrite IH]; ring. Qed.
Lemma total_zero : forall n f, (forall k, (k < n)%nat -> f k = 0) -> total n f = 0.
Proof. intros n f E; induction n as [| n IH]; simpl; [reflexivity |]; rewrite IH, E by (intros; try apply E; lia);
  ring. Qed.
Lemma total_least : forall n f g, (forall k, (k < n)%nat -> f k <= g k) -> total n f <= total n g.
Proof. intros n f g L; induction n as [| n IH]; simpl; [lra |]; apply Rplus_le_compat; [apply IH; intros; apply L;
  lia | apply L; lia]. Qed.
Lemma total_positive : forall n f, (forall k, (k < n)%nat -> 0 <= f k) -> 0 <= total n f.
Proof. intros n f L; induction n as [| n IH]; simpl; [lra |]; apply Rplus_le_le_0_compat; [apply IH; intros;
  apply L; lia | apply L; lia]. Qed.
Lemma total_app : forall m n f, total (m + n) f = total m f + total n (fun k => f (m + k)%nat).
Proof.
  intros m n f; induction n as [| n IH]; [rewrite Nat.add_0_r; simpl; ring |].
  rewrite <- plus_n_Sm; simpl; rewrite IH; ring.
Qed.
Lemma total_swap : forall m n (f : nat -> nat -> R),
  total m (fun j => total n (fun k => f j k)) = total n (fun k => total m (fun j => f j k)).
Proof.
  intros m n f; induction m as [| m IH]; simpl; [symmetry; apply total_zero; reflexivity |].
  rewrite IH, total_plus; reflexivity.
Qed.
Lemma total_start : forall n f, total (S n) f = f O + total n (fun k => f (S k)).
Proof. intros n f; induction n as [| n IH]; [simpl; ring |];
  change (total (S (S n)) f) with (total (S n) f + f (S n)); rewrite IH; simpl; ring. Qed.

(* -- filters ---------------------------------------------------------------------------------- *)

(* A device that is moved by p 0, p 1, ... from sample to sample is at place p k at sample k. *)
Definition place (p : nat -> R) (k : nat) : R := total k p.
(* The force h_0 x_k + h_1 x_(k-1) + ...; x_k is 0 up to the sample 0. *)
Definition force (h p : nat -> R) (k : nat) : R := total (S k) (fun i => h i * place p (k - i)).
(* What n displacements cost against it and a damper that burns c p_k^2. *)
Definition energy (c : R) (h p : nat -> R) (n : nat) : R :=
  total n (fun k => c * p k ^ 2 + p k * force h p k).
(* H(z) = h_0 + h_1/z + h_2/z^2 + ... for all large z. *)
Fixpoint Ctotal (n : nat) (f : nat -> C) : C := match n with O => RtoC 0 | S m => (Ctotal m f + f m)%C end.
Definition response (H : C -> C) (h : nat -> R) : Prop :=
  exists r, forall z, r < Cmod z -> forall eps, 0 < eps -> exists N, forall n, (N <= n)%nat ->
    Cmod (Ctotal n (fun k => h k / z ^ k)%C - H z)%C < eps.
Definition passive (H : C -> C) (c : R) : Prop :=
  exists h, response H h /\ forall p n, 0 <= energy c h p n.

Lemma Ctotal_alike : forall n f g, (forall k, f k = g k) -> Ctotal n f = Ctotal n g.
Proof. intros n f g E; induction n as [| n IH]; simpl; [| rewrite IH, E]; reflexivity. Qed.
Lemma Ctotal_real : forall n f, Ctotal n (fun k => RtoC (f k)) = RtoC (total n f).
Proof. intros n f; induction n as [| n IH]; simpl; [| rewrite IH, RtoC_plus]; reflexivity. Qed.
Lemma sum_total : forall n (f : nat -> R), sum_n f n = total (S n) f.
Proof. intros n f; induction n as [| n IH]; [rewrite sum_O; simpl; ring | rewrite sum_Sn, IH; reflexivity]. Qed.
(* The h_k are those of one sequence: a power series in 1/z is that of its sum. *)
Lemma response_real : forall H h, response H h -> exists r, 0 < r /\
  forall x, x <> 0 -> Rabs x < r -> is_pseries h x (Re (H (RtoC (/ x)))).
Proof.
  intros H h (r & L); exists (/ (Rabs r + 1)); assert (P := Rabs_pos r).
  split; [apply Rinv_0_lt_compat; lra |]; intros x N X.
  assert (Z : r < Cmod (RtoC (/ x))).
  { rewrite Cmod_R, Rabs_inv; apply Rle_lt_trans with (Rabs r); [apply Rle_abs |].
    apply Rlt_trans with (Rabs r + 1); [lra |]; rewrite <- (Rinv_inv (Rabs r + 1)).
    apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; [apply Rabs_pos_lt, N | apply Rinv_0_lt_compat;
      lra] | exact X]. }
  specialize (L _ Z); apply is_pseries_R.
  change (is_lim_seq (sum_n (fun k => h k * x ^ k)) (Finite (Re (H (RtoC (/ x)))))); apply is_lim_seq_spec; intro eps.
  destruct (L eps (cond_pos eps)) as (M & B); exists M; intros n Mn.
  assert (E : Re (Ctotal (S n) (fun k => h k / RtoC (/ x) ^ k)%C) = sum_n (fun k => h k * x ^ k) n).
  { assert (K : forall k, (h k / RtoC (/ x) ^ k)%C = RtoC (h k * x ^ k)).
    { intro k; assert (Q : (RtoC (/ x) ^ k)%C = RtoC ((/ x) ^ k)).
      { induction k as [| k IH]; simpl; [reflexivity | rewrite IH, RtoC_mult; reflexivity]. }
      rewrite Q, <- RtoC_div by (apply pow_nonzero, Rinv_neq_0_compat, N); f_equal; unfold Rdiv.
      rewrite pow_inv, Rinv_inv; reflexivity. }
    rewrite (Ctotal_alike _ _ _ K), Ctotal_real; symmetry; apply sum_total. }
  unfold minus in *; rewrite <- E; apply Rle_lt_trans with (2 := B (S n) ltac:(lia)).
  eapply Rle_trans; [| apply Rmax_Cmod]; eapply Rle_trans; [| apply Rmax_l]; apply Req_le; f_equal.
Qed.
Lemma response_once : forall H g h, response H g -> response H h -> forall n, g n = h n.
Proof.
  assert (Rad : forall a r, 0 < r -> (forall x, x <> 0 -> Rabs x < r -> ex_pseries a x) ->
    Rbar_lt 0 (CV_radius (PS_incr_1 a))).
  { intros a r R E; rewrite CV_radius_incr_1; apply Rbar_not_le_lt; intro L.
    assert (X : ex_pseries a (r / 2)) by (apply E; [lra | rewrite Rabs_pos_eq; lra]).
    apply (CV_disk_outside a (r / 2)).
    - apply Rbar_le_lt_trans with (1 := L); simpl; rewrite Rabs_pos_eq; lra.
    - destruct X as [l X]; apply is_pseries_R in X; apply ex_series_lim_0; exists l; exact X. }
  intros H g h G K n; destruct (response_real _ _ G) as (r & R & A), (response_real _ _ K) as (s & S & B).
  assert (E : PS_incr_1 g (Datatypes.S n) = PS_incr_1 h (Datatypes.S n)); [| exact E].
  apply PSeries_ext_recip.
  - apply (Rad g r R); intros x X Y; eexists; apply A; assumption.
  - apply (Rad h s S); intros x X Y; eexists; apply B; assumption.
  - assert (M : 0 < Rmin r s) by (apply Rmin_glb_lt; assumption); exists (mkposreal _ M); intros x X.
    rewrite !PSeries_incr_1; destruct (Req_dec x 0) as [Z | Z]; [rewrite Z; ring | f_equal].
    assert (Y : Rabs x < Rmin r s).
    { assert (Q : Rabs (minus x 0) < Rmin r s) by exact X; unfold minus, plus, opp in Q; simpl in Q;
        rewrite Ropp_0, Rplus_0_r in Q; exact Q. }
    rewrite (is_pseries_unique _ _ _ (A x Z (Rlt_le_trans _ _ _ Y (Rmin_l _ _)))).
    symmetry; apply is_pseries_unique, B; [exact Z | exact (Rlt_le_trans _ _ _ Y (Rmin_r _ _))].
Qed.

(* -- filters with finitely many coefficients ---------------------------------------------------- *)

(* c/z^e + ... of pairs (e, c); its value at 1; what is c_0 + Re H/(z - 1) at z = exp(j t). *)
Definition taps (l : list (nat * R)) (z : C) : C := fold_right (fun u s => RtoC (snd u) / z ^ fst u + s)%C (RtoC 0) l.
Definition static (l : list (nat * R)) : R := fold_right (fun u s => snd u + s) 0 l.
Definition margin (c : R) (l : list (nat * R)) (t : R) : R :=
  fold_right (fun u s => snd u * ((cos (INR (S (fst u)) * t) - cos (INR (fst u) * t)) / (2 - 2 * cos t)) + s) c l.
Definition impulse (l : list (nat * R)) (k : nat) : R :=
  fold_right (fun u s => (if Nat.eqb (fst u) k then snd u else 0) + s) 0 l.

Lemma Ctotal_plus : forall n f g, Ctotal n (fun k => f k + g k)%C = (Ctotal n f + Ctotal n g)%C.
Proof. intros n f g; induction n as [| n IH]; simpl; [| rewrite IH]; ring. Qed.
Lemma response_of_taps : forall H l, (forall z, z <> RtoC 0 -> H z = taps l z) -> response H (impulse l).
Proof.
  intros H l E; exists 0; intros z Z eps P.
  assert (N : z <> RtoC 0) by (intro Q; rewrite Q, Cmod_0 in Z; lra).
  assert (L : exists M, forall n, (M <= n)%nat -> Ctotal n (fun k => impulse l k / z ^ k)%C = taps l z).
  { clear E; induction l as [| [e c] l [M L]]; simpl.
    - exists O; intros n _; induction n as [| n IH]; simpl; [reflexivity |]; rewrite IH; unfold Cdiv; ring.
    - exists (max M (S e)); intros n Mn; rewrite <- (L n) by lia.
      rewrite (Ctotal_alike _ _ (fun k => (if Nat.eqb e k then c else 0) / z ^ k + impulse l k / z ^ k)%C).
      2: { intro k; fold (impulse l k); rewrite RtoC_plus; unfold Cdiv; destruct (Nat.eqb e k); ring. }
      rewrite Ctotal_plus; f_equal.
      assert (One : Ctotal n (fun k => (if Nat.eqb e k then c else 0) / z ^ k)%C =
        if Nat.ltb e n then (c / z ^ e)%C else RtoC 0).
      { clear; induction n as [| n IH]; [reflexivity |]; simpl Ctotal; rewrite IH.
        destruct (Nat.ltb_spec e n), (Nat.ltb_spec e (S n)), (Nat.eqb_spec e n); try lia; subst; unfold Cdiv; ring. }
      rewrite One; destruct (Nat.ltb_spec e n); [reflexivity | lia]. }
  destruct L as [M L]; exists M; intros n Mn; rewrite L, E by assumption.
  replace (taps l z - taps l z)%C with (RtoC 0) by ring; rewrite Cmod_0; exact P.
Qed.

(* The energy of one coefficient is that of a step: half the square of the whole way, and less what lies behind. *)
Definition squares (p : nat -> R) (n : nat) : R := total n (fun k => p k ^ 2).
Definition lagged (e : nat) (p : nat -> R) (n : nat) : R :=
  total n (fun k => p k * (if Nat.leb e k then p (k - e)%nat else 0)).
Fixpoint rest (e : nat) (p : nat -> R) (n : nat) : R :=
  match e with O => - squares p n / 2 | S d => rest d p n - lagged e p n end.
Lemma work_of_one : forall e p n, total n (fun k => p k * place p (k - e)) = place p n ^ 2 / 2 + rest e p n.
Proof.
  intros e p n; induction e as [| e IH]; simpl rest.
  - unfold squares, place; induction n as [| n IH]; simpl; [field |]; rewrite IH, Nat.sub_0_r; simpl; field.
  - replace (place p n ^ 2 / 2 +
      (rest e p n - lagged (S e) p n)) with (total n (fun k => p k * place p (k - e)) - lagged (S e) p n)
      by (rewrite IH; ring).
    unfold lagged; rewrite <- total_minus; apply total_alike; intros k _.
    destruct (Nat.leb_spec (S e) k) as [L | L].
    + replace (k - e)%nat with (S (k - S e)) by lia; unfold place; simpl; ring.
    + replace (k - e)%nat with O by lia; replace (k - S e)%nat with O by lia; unfold place; simpl; ring.
Qed.
Definition behind (c : R) (l : list (nat * R)) (p : nat -> R) (n : nat) : R :=
  fold_right (fun u s => snd u * rest (fst u) p n + s) (c * squares p n) l.
Lemma force_of_taps : forall l p k, force (impulse l) p k =
  fold_right (fun u s => snd u * place p (k - fst u) + s) 0 l.
Proof.
  intros l p k; induction l as [| [e x] l IH]; simpl fold_right; [apply total_zero; intros; unfold impulse; simpl;
    ring |].
  rewrite <- IH; unfold force;
    rewrite <- (total_alike _ (fun i => (if Nat.eqb e i then x else 0) * place p (k - i) +
    impulse l i * place p (k - i))).
  2: { intros i _; unfold impulse; simpl; ring. }
  rewrite total_plus; f_equal.
  assert (One : forall m, total m (fun i => (if Nat.eqb e i then x else 0) * place p (k - i)) =
    if Nat.ltb e m then x * place p (k - e) else 0).
  { clear; induction m as [| m IH]; [reflexivity |]; simpl total; rewrite IH.
    destruct (Nat.ltb_spec e m), (Nat.ltb_spec e (S m)), (Nat.eqb_spec e m); try lia; subst; ring. }
  rewrite One; destruct (Nat.ltb_spec e (S k)); [reflexivity |].
  simpl fst; replace (k - e)%nat with O by lia; unfold place; simpl; ring.
Qed.
Lemma passive_taps : forall H c l, (forall z, z <> RtoC 0 -> H z = taps l z) ->
  (passive H c <-> forall p n, 0 <= energy c (impulse l) p n).
Proof.
  intros H c l E; assert (R := response_of_taps H l E); split; [intros (h & G & P) p n | intro P;
    exists (impulse l); split; assumption].
  replace (energy c (impulse l) p n) with (energy c h p n); [apply P |].
  unfold energy, force; apply total_alike; intros k _; f_equal; f_equal; apply total_alike; intros i _.
  rewrite (response_once _ _ _ G R); reflexivity.
Qed.
Lemma energy_of_taps : forall c l p n, energy c (impulse l) p n = static l * (place p n ^ 2 / 2) + behind c l p n.
Proof.
  intros c l p n.
  unfold energy; rewrite (total_alike _ _ (fun k => c * p k ^ 2 +
    p k * fold_right (fun u s => snd u * place p (k - fst u) + s) 0 l)).
  2: { intros k _; rewrite force_of_taps; reflexivity. }
  rewrite total_plus, total_times; fold (squares p n).
  assert (G : total n (fun k => p k * fold_right (fun u s => snd u * place p (k - fst u) + s) 0 l) =
    static l * (place p n ^ 2 / 2) + fold_right (fun u s => snd u * rest (fst u) p n + s) 0 l).
  { induction l as [| [e x] l IH]; simpl fold_right; [rewrite total_zero by (intros; ring); unfold static; simpl;
      ring |].
    rewrite <- (total_alike _ (fun k => x * (p k * place p (k - e)) +
      p k * fold_right (fun u s => snd u * place p (k - fst u) + s) 0 l)).
    2: { intros; simpl; ring. }
    rewrite total_plus, total_times, IH, work_of_one; simpl; fold (static l); ring. }
  rewrite G; unfold behind; clear G; induction l as [| u l IH]; simpl; [ring |]; fold (static l) in *; lra.
Qed.

(* -- the same at each angle ------------------------------------------------------------------- *)

Fixpoint turned_back (e : nat) (t : R) : R :=
  match e with O => - (1 / 2) | S d => turned_back d t - cos (INR e * t) end.
Lemma turned_back_is : forall e t, cos t <> 1 ->
  (cos (INR (S e) * t) - cos (INR e * t)) / (2 - 2 * cos t) = turned_back e t.
Proof.
  intros e t N; assert (M : 2 - 2 * cos t <> 0) by lra; induction e as [| e IH].
  - simpl; rewrite Rmult_0_l, cos_0, Rmult_1_l; field; exact M.
  - change (turned_back (S e) t) with (turned_back e t - cos (INR (S e) * t)); rewrite <- IH.
    assert (A : cos (INR (S (S e)) * t) = cos (INR (S e) * t) * cos t - sin (INR (S e) * t) * sin t).
    { rewrite <- cos_plus; f_equal; rewrite (S_INR (S e)); ring. }
    assert (B : cos (INR e * t) = cos (INR (S e) * t) * cos t + sin (INR (S e) * t) * sin t).
    { rewrite <- cos_minus; f_equal; rewrite S_INR; ring. }
    rewrite A, B; field; exact M.
Qed.
Definition at_angle (c : R) (l : list (nat * R)) (t : R) : R :=
  fold_right (fun u s => snd u * turned_back (fst u) t + s) c l.
Lemma at_angle_is : forall c l t, cos t <> 1 -> margin c l t = at_angle c l t.
Proof. intros c l t N; unfold margin, at_angle; induction l as [| u l IH]; cbn [fold_right]; [reflexivity |];
  rewrite IH, turned_back_is by exact N; reflexivity. Qed.
(* |p_0 + p_1 exp(j t) + ...|^2. *)
Definition spectrum (p : nat -> R) (n : nat) (t : R) : R :=
  total n (fun k => p k * cos (INR k * t)) ^ 2 + total n (fun k => p k * sin (INR k * t)) ^ 2.
Lemma spectrum_next : forall p n t,
  spectrum p (S n) t = spectrum p n t + (2 * p n * total n (fun j => p j * cos (INR (n - j) * t)) + p n ^ 2).
Proof.
  intros p n t; unfold spectrum; cbn [total].
  rewrite (total_alike n (fun j => p j * cos (INR (n - j) * t))
    (fun j => cos (INR n * t) * (p j * cos (INR j * t)) + sin (INR n * t) * (p j * sin (INR j * t)))).
  2: { intros j J; rewrite minus_INR, Rmult_minus_distr_r, cos_minus by lia; ring. }
  rewrite total_plus, !total_times.
  set (x := total n _); set (y := total n _); generalize (pythagoras (INR n * t)); intro Q.
  replace ((x + p n * cos (INR n * t)) ^ 2 + (y + p n * sin (INR n * t)) ^ 2) with
    (x ^ 2 + y ^ 2 + 2 * p n * (cos (INR n * t) * x + sin (INR n * t) * y) + p n ^ 2 * (sin (INR n * t) ^ 2 +
      cos (INR n * t) ^ 2)) by ring.
  replace (sin (INR n * t) ^ 2 + cos (INR n * t) ^ 2) with 1 by (simpl in *; lra); ring.
Qed.

(* M angles on the circle: sums over them are means. *)
Section Circle.
Variable M : nat.
Hypothesis M0 : (0 < M)%nat.
Definition angle (m : nat) : R := INR (2 * m + 1) * PI / INR M.
Lemma M_positive : 0 < INR M.
Proof. apply lt_0_INR, M0. Qed.
Lemma mean_nothing : forall q, (0 < q < M)%nat -> total M (fun m => cos (INR q * angle m)) = 0.
Proof.
  intros q [Q0 Q]; set (h := INR q * PI / INR M); assert (P := M_positive).
  assert (Qr : 0 < INR q < INR M) by (split; [apply lt_0_INR, Q0 | apply lt_INR, Q]).
  assert (Sh : 0 < sin h).
  { unfold h; apply sin_gt_0.
    - apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [lra | apply PI_RGT_0] | exact P].
    - apply Rmult_lt_reg_r with (INR M); [exact P |]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra;
        generalize PI_RGT_0; nra. }
  assert (E : forall n, 2 * sin h * total n (fun m => cos (INR q * angle m)) = sin (2 * INR n * h)).
  { induction n as [| n IH]; [simpl; rewrite !Rmult_0_r, Rmult_0_l, sin_0; reflexivity |].
    cbn [total]; rewrite Rmult_plus_distr_l, IH.
    replace (INR q * angle n) with (2 * INR n * h + h).
    2: { unfold angle, h; rewrite plus_INR, mult_INR; simpl INR; field; lra. }
    replace (2 * INR (S n) * h) with (2 * INR n * h + h + h) by (rewrite S_INR; ring).
    rewrite (sin_plus (2 * INR n * h + h) h);
      replace (sin (2 * INR n * h)) with (sin (2 * INR n * h + h - h)) by (f_equal; ring).
    rewrite sin_minus; ring. }
  specialize (E M); replace (2 * INR M * h) with (0 + 2 * INR q * PI) in E by (unfold h; field; lra).
  rewrite sin_period, sin_0 in E; nra.
Qed.
Lemma mean_product : forall q r, (0 < q)%nat -> (0 < r)%nat -> (q + r < M)%nat ->
  2 * total M (fun m => cos (INR q * angle m) * cos (INR r * angle m)) = if Nat.eqb q r then INR M else 0.
Proof.
  intros q r Q R L; rewrite <- total_times.
  rewrite (total_alike _ _ (fun m => cos (INR (q + r) * angle m) + cos (INR (max q r - min q r) * angle m))).
  - rewrite total_plus, mean_nothing by lia; destruct (Nat.eqb_spec q r) as [E | N].
    + subst r; replace (max q q - min q q)%nat with O by lia; rewrite (total_alike _ _ (fun _ => 1)).
      2: { intros; simpl; rewrite Rmult_0_l, cos_0; reflexivity. }
      clear; induction M as [| n IH]; [simpl; ring |]; cbn [total]; rewrite S_INR; lra.
    + rewrite mean_nothing by lia; ring.
  - intros m _; rewrite plus_INR, Rmult_plus_distr_r, cos_plus.
    replace (cos (INR (max q r - min q r) * angle m)) with (cos (INR q * angle m - INR r * angle m));
      [rewrite cos_minus; ring |].
    destruct (Nat.le_ge_cases q r).
    + rewrite Nat.max_r, Nat.min_l, minus_INR by lia; rewrite <- cos_neg; f_equal; ring.
    + rewrite Nat.max_l, Nat.min_r, minus_INR by lia; f_equal; ring.
Qed.
Lemma mean_square : forall p n, (n <= M)%nat -> total M (fun m => spectrum p n (angle m)) = INR M * squares p n.
Proof.
  intros p n L; induction n as [| n IH].
  - rewrite total_zero; [unfold squares; simpl; ring | intros; unfold spectrum; simpl; ring].
  - rewrite (total_alike _ _ _ (fun m _ => spectrum_next p n (angle m))), total_plus, IH, total_plus, (total_times M
      (2 * p n)) by lia.
    rewrite total_swap, (total_zero n).
    + rewrite Rmult_0_r; unfold squares; cbn [total]; ring_simplify.
      replace (total M (fun _ => p n ^ 2)) with (INR M * p n ^ 2); [ring |].
      clear; induction M as [| k IH]; [simpl; ring |]; cbn [total]; rewrite <- IH, S_INR; ring.
    + intros j J; rewrite total_times, mean_nothing by lia; ring.
Qed.
Lemma mean_lagged : forall p n e, (0 < e)%nat -> (e + n <= M)%nat ->
  total M (fun m => spectrum p n (angle m) * cos (INR e * angle m)) = INR M * lagged e p n.
Proof.
  intros p n e E L; induction n as [| n IH].
  - rewrite total_zero; [unfold lagged; simpl; ring | intros; unfold spectrum; simpl; ring].
  - rewrite (total_alike _ _ (fun m => spectrum p n (angle m) * cos (INR e * angle m) +
      (p n * total n (fun j => p j * (2 * (cos (INR (n - j) * angle m) * cos (INR e * angle m)))) +
        p n ^ 2 * cos (INR e * angle m)))).
    2: { intros m _; rewrite spectrum_next.
      replace (total n (fun j => p j * (2 * (cos (INR (n - j) * angle m) * cos (INR e * angle m))))) with
        (2 * cos (INR e * angle m) * total n (fun j => p j * cos (INR (n - j) * angle m))); [ring |].
      rewrite <- total_times; apply total_alike; intros; ring. }
    rewrite total_plus, IH, total_plus, (total_times M (p n)), total_swap, (total_times M (p n ^ 2)), mean_nothing by
      lia.
    unfold lagged; cbn [total]; fold (lagged e p n).
    rewrite (total_alike n _ (fun j => p j * if Nat.eqb (n - j) e then INR M else 0)).
    2: { intros j J; rewrite total_times, total_times, mean_product by lia; reflexivity. }
    destruct (Nat.leb_spec e n) as [K | K].
    + replace (total n (fun j => p j * (if Nat.eqb (n - j) e then INR M else 0))) with (p (n - e)%nat * INR M);
        [ring |].
      assert (One : forall k, (k <= n)%nat ->
        total k (fun j => p j * (if Nat.eqb (n - j) e then INR M else 0)) =
        if Nat.ltb (n - e) k then p (n - e)%nat * INR M else 0).
      { induction k as [| k IHk]; intro Kn; [reflexivity |]; cbn [total]; rewrite IHk by lia.
        destruct (Nat.ltb_spec (n - e) k), (Nat.ltb_spec (n - e) (S k)), (Nat.eqb_spec (n - k) e); try lia; try ring.
        replace (n - e)%nat with k by lia; ring. }
      rewrite One by lia; destruct (Nat.ltb_spec (n - e) n); [reflexivity | lia].
    + rewrite total_zero; [ring |]; intros j J; destruct (Nat.eqb_spec (n - j) e); [lia | ring].
Qed.
Lemma mean_rest : forall p n e, (e + n <= M)%nat ->
  total M (fun m => spectrum p n (angle m) * turned_back e (angle m)) = INR M * rest e p n.
Proof.
  intros p n e L; induction e as [| e IH].
  - simpl; rewrite (total_alike _ _ (fun m => - (1 / 2) * spectrum p n (angle m))) by (intros; ring).
    rewrite total_times, mean_square by lia; field.
  - cbn [turned_back rest]; rewrite (total_alike _ _ (fun m => spectrum p n (angle m) * turned_back e (angle m) -
      spectrum p n (angle m) * cos (INR (S e) * angle m))) by (intros; ring).
    rewrite total_minus, IH, mean_lagged by lia; ring.
Qed.
Lemma mean_behind : forall c l p n, (forall u, In u l -> (fst u + n <= M)%nat) -> (n <= M)%nat ->
  total M (fun m => spectrum p n (angle m) * at_angle c l (angle m)) = INR M * behind c l p n.
Proof.
  intros c l p n L N; induction l as [| u l IH].
  - unfold at_angle, behind; simpl; rewrite (total_alike _ _ (fun m => c * spectrum p n (angle m))) by (intros; ring).
    rewrite total_times, mean_square by exact N; ring.
  - unfold at_angle, behind; cbn [fold_right]; fold (behind c l p n).
    rewrite (total_alike _ _ (fun m => snd u * (spectrum p n (angle m) * turned_back (fst u) (angle m)) +
      spectrum p n (angle m) * at_angle c l (angle m)))
      by (intros; unfold at_angle; ring).
    rewrite total_plus, total_times, mean_rest, IH by (intros; apply L; simpl; auto); ring.
Qed.
End Circle.
Lemma cos_whole_turn : forall k t, cos (INR k * (2 * PI - t)) = cos (INR k * t).
Proof.
  intros k t; replace (INR k * (2 * PI - t)) with (- (INR k * t) + 2 * INR k * PI) by ring.
  rewrite cos_period; apply cos_neg.
Qed.
Lemma at_angle_back : forall c l t, at_angle c l (2 * PI - t) = at_angle c l t.
Proof.
  intros c l t; assert (B : forall e, turned_back e (2 * PI - t) = turned_back e t).
  { induction e as [| e IH]; [reflexivity |]; cbn [turned_back]; rewrite IH, cos_whole_turn; reflexivity. }
  induction l as [| u l IH]; [reflexivity |]; unfold at_angle in *; cbn [fold_right]; rewrite IH, B; reflexivity.
Qed.
Lemma cos_below_one : forall t, 0 < t < 2 * PI -> cos t < 1.
Proof.
  intros t T; assert (S : 0 < sin (t / 2)) by (apply sin_gt_0; lra).
  replace t with (2 * (t / 2)) by field; rewrite cos_2a_sin; nra.
Qed.
Lemma angles_suffice : forall c l, (forall t, 0 < t < PI -> 0 <= at_angle c l t) -> forall p n, 0 <= behind c l p n.
Proof.
  intros c l A p n.
  assert (B : exists b, forall u, In u l -> (fst u <= b)%nat).
  { clear; induction l as [| u l [b B]]; [exists O; contradiction |]; exists (max (fst u) b); intros v [E | V];
      [subst; lia | specialize (B v V); lia]. }
  destruct B as [b B]; set (M := (2 * (b + n + 1))%nat); assert (M0 : (0 < M)%nat) by lia.
  assert (E := mean_behind M M0 c l p n ltac:(intros u U; specialize (B u U); lia) ltac:(lia)).
  assert (P := lt_0_INR M M0); assert (G : 0 <= INR M * behind c l p n); [| nra].
  rewrite <- E; apply total_positive; intros m Mm; apply Rmult_le_pos.
  - unfold spectrum; generalize (pow2_ge_0 (total n (fun k => p k * cos (INR k * angle M m)))) (pow2_ge_0 (total n
      (fun k => p k * sin (INR k * angle M m)))); lra.
  - set (t := angle M m); assert (T : 0 < t < 2 * PI).
    { unfold t, angle; assert (0 < INR (2 * m + 1)) by (apply lt_0_INR; lia); assert (INR (2 * m + 1) < 2 * INR M).
      { replace (2 * INR M) with (INR (2 * M)) by (rewrite mult_INR; reflexivity); apply lt_INR; lia. }
      assert (Pp := PI_RGT_0); split; [apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; assumption |].
      apply Rmult_lt_reg_r with (INR M); [exact P |]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; nra. }
    assert (N : t <> PI).
    { unfold t, angle; intro Q; assert (Pp := PI_RGT_0).
      assert (R : INR (2 * m + 1) = INR M).
      { apply Rmult_eq_reg_r with PI; [| lra];
          replace (INR (2 * m + 1) * PI) with (INR (2 * m + 1) * PI / INR M * INR M) by (field; lra).
        rewrite Q; ring. }
      apply INR_eq in R; unfold M in R; lia. }
    destruct (Rlt_le_dec t PI) as [L | L]; [apply A; lra |].
    rewrite <- at_angle_back; apply A; lra.
Qed.
(* -- and back: the displacements cos(k t) and sin(k t) together ------------------------------------ *)

Lemma squares_swing : forall n t, squares (fun k => cos (INR k * t)) n + squares (fun k => sin (INR k * t)) n = INR n.
Proof.
  intros n t; unfold squares; induction n as [| n IH]; [simpl; ring |]; cbn [total]; rewrite S_INR.
  generalize (pythagoras (INR n * t)); simpl in *; lra.
Qed.
Lemma lagged_swing : forall n e t,
  lagged e (fun k => cos (INR k * t)) n + lagged e (fun k => sin (INR k * t)) n = INR (n - e) * cos (INR e * t).
Proof.
  intros n e t; unfold lagged; rewrite <- total_plus.
  induction n as [| n IH]; [simpl; ring |]; cbn [total]; rewrite IH.
  destruct (Nat.leb_spec e n) as [L | L].
  - replace (S n - e)%nat with (S (n - e)) by lia; rewrite S_INR.
    replace (cos (INR e * t)) with (cos (INR n * t - INR (n - e) * t)) at 2 by (f_equal; rewrite minus_INR by lia;
      ring).
    rewrite cos_minus; replace (cos (INR e * t)) with (cos (INR n * t - INR (n - e) * t)) by (f_equal;
      rewrite minus_INR by lia; ring).
    rewrite cos_minus; ring.
  - replace (S n - e)%nat with O by lia; replace (n - e)%nat with O by lia; simpl; ring.
Qed.
Lemma rest_swing : forall e t, exists b, forall n,
  Rabs (rest e (fun k => cos (INR k * t)) n + rest e (fun k => sin (INR k * t)) n - INR n * turned_back e t) <= b.
Proof.
  intros e t; induction e as [| e [b B]].
  - exists 0; intro n; cbn [rest turned_back]; generalize (squares_swing n t); intro Q.
    replace (- squares (fun k => cos (INR k * t)) n / 2 +
      - squares (fun k => sin (INR k * t)) n / 2 - INR n * - (1 / 2)) with 0 by lra.
    rewrite Rabs_R0; lra.
  - exists (b + INR (S e)); intro n; cbn [rest turned_back]; specialize (B n); generalize (lagged_swing n (S e) t);
      intro Q.
    set (x := rest e (fun k => cos (INR k * t)) n) in *; set (y := rest e (fun k => sin (INR k * t)) n) in *.
    match goal with |- Rabs ?q <= _ => replace q with ((x + y - INR n * turned_back e t) +
      (INR n - INR (n - S e)) * cos (INR (S e) * t)) by lra end.
    eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat; [exact B |]; rewrite Rabs_mult.
    assert (D : 0 <= INR n - INR (n - S e) <= INR (S e)).
    { destruct (Nat.le_ge_cases (S e) n) as [L | L]; [rewrite minus_INR by lia; generalize (pos_INR (S e)); lra |].
      replace (n - S e)%nat with O by lia; simpl (INR 0); apply le_INR in L; generalize (pos_INR n); lra. }
    rewrite (Rabs_pos_eq (INR n - _)) by lra; generalize (COS_bound (INR (S e) * t)); intro C.
    assert (Rabs (cos (INR (S e) * t)) <= 1) by (apply Rabs_le; lra).
    generalize (Rabs_pos (cos (INR (S e) * t))); nra.
Qed.
Lemma behind_swing : forall c l t, exists b, forall n,
  behind c l (fun k => cos (INR k * t)) n + behind c l (fun k => sin (INR k * t)) n <= INR n * at_angle c l t + b.
Proof.
  intros c l t; assert (A : exists b, forall n,
    Rabs (behind c l (fun k => cos (INR k * t)) n +
      behind c l (fun k => sin (INR k * t)) n - INR n * at_angle c l t) <= b).
  { induction l as [| u l [b B]].
    - exists 0; intro n; unfold behind, at_angle; cbn [fold_right]; generalize (squares_swing n t); intro Q.
      match goal with |- Rabs ?q <= _ => replace q with (c * (squares (fun k => cos (INR k * t)) n +
        squares (fun k => sin (INR k * t)) n - INR n)) by ring end.
      rewrite Q; replace (INR n - INR n) with 0 by ring; rewrite Rmult_0_r, Rabs_R0; lra.
    - destruct (rest_swing (fst u) t) as [d D]; exists (Rabs (snd u) * d + b); intro n; specialize (B n);
        specialize (D n).
      unfold behind, at_angle; cbn [fold_right];
        fold (behind c l (fun k => cos (INR k * t)) n) (behind c l (fun k => sin (INR k * t)) n) (at_angle c l t).
      match goal with |- Rabs ?q <= _ => replace q with
        (snd u * (rest (fst u) (fun k => cos (INR k * t)) n +
          rest (fst u) (fun k => sin (INR k * t)) n - INR n * turned_back (fst u) t) +
         (behind c l (fun k => cos (INR k * t)) n +
           behind c l (fun k => sin (INR k * t)) n - INR n * at_angle c l t)) by ring end.
      eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat; [rewrite Rabs_mult | exact B].
      apply Rmult_le_compat_l; [apply Rabs_pos | exact D]. }
  destruct A as [b B]; exists b; intro n; specialize (B n); apply Rabs_le_between in B; lra.
Qed.
Lemma ways_bounded : forall n t, (2 - 2 * cos t) *
  (place (fun k => cos (INR k * t)) n ^ 2 + place (fun k => sin (INR k * t)) n ^ 2) = 2 - 2 * cos (INR n * t).
Proof.
  intros n t; set (x := place _ n); set (y := place (fun k => sin (INR k * t)) n).
  assert (A : x - (cos t * x - sin t * y) = 1 - cos (INR n * t) /\ y - (cos t * y + sin t * x) = - sin (INR n * t)).
  { unfold x, y, place; clear; induction n as [| n [A B]]; [simpl; rewrite Rmult_0_l, cos_0, sin_0; lra |];
      cbn [total].
    replace (INR (S n) * t) with (INR n * t + t) by (rewrite S_INR; ring); rewrite cos_plus, sin_plus; split; lra. }
  destruct A as [A B].
  replace ((2 - 2 * cos t) * (x ^ 2 + y ^ 2)) with ((x - (cos t * x - sin t * y)) ^ 2 + (y - (cos t * y +
    sin t * x)) ^ 2
    + (1 - (sin t ^ 2 + cos t ^ 2)) * (x ^ 2 + y ^ 2)) by ring.
  rewrite A, B; replace (sin t ^ 2 + cos t ^ 2) with 1 by (generalize (pythagoras t); simpl; lra).
  replace ((1 - cos (INR n * t)) ^ 2 + (- sin (INR n * t)) ^ 2) with (1 - 2 * cos (INR n * t) +
    (sin (INR n * t) ^ 2 + cos (INR n * t) ^ 2)) by ring.
  replace (sin (INR n * t) ^ 2 + cos (INR n * t) ^ 2) with 1 by (generalize (pythagoras (INR n * t)); simpl; lra);
    ring.
Qed.
(* What grows no faster than n x + b and is not negative. *)
Lemma not_falling : forall x b, (forall n, 0 <= INR n * x + b) -> 0 <= x.
Proof.
  intros x b H; apply Rnot_lt_le; intro L; destruct (nfloor_ex (Rabs b / - x + 1)) as [n N].
  - assert (0 <= Rabs b / - x) by (apply Rdiv_le_0_compat; [apply Rabs_pos | lra]); lra.
  - specialize (H n); assert (Q : Rabs b < INR n * - x).
    { apply Rmult_lt_reg_r with (/ - x); [apply Rinv_0_lt_compat; lra |]; rewrite Rmult_assoc, Rinv_r by lra.
      fold (Rabs b / - x); lra. }
    generalize (Rle_abs b); lra.
Qed.
Theorem toeplitz : forall H c l, (forall z, z <> RtoC 0 -> H z = taps l z) ->
  (passive H c <-> 0 <= static l /\ forall t, 0 < t < PI -> 0 <= margin c l t).
Proof.
  intros H c l E; apply (iff_trans (passive_taps H c l E)); split.
  - intro P; assert (Q : forall p n, 0 <= static l * (place p n ^ 2 / 2) + behind c l p n).
    { intros p n; rewrite <- energy_of_taps; apply P. }
    clear P; assert (W : forall t, exists b, forall n, 0 <= static l * ((place (fun k => cos (INR k * t)) n ^ 2 +
      place (fun k => sin (INR k * t)) n ^ 2) / 2)
      + (INR n * at_angle c l t + b)).
    { intro t; destruct (behind_swing c l t) as [b B]; exists b; intro n; specialize (B n).
      assert (Q1 := Q (fun k => cos (INR k * t)) n); assert (Q2 := Q (fun k => sin (INR k * t)) n); lra. }
    assert (S0 : 0 <= static l).
    { destruct (W 0) as [b B]; assert (D : 0 <= static l / 2); [| lra].
      apply Rnot_lt_le; intro L.
      assert (F : forall n, 0 <= INR n * (INR n * (static l / 2) + at_angle c l 0) + b).
      { intro n; specialize (B n); replace (place (fun k => cos (INR k * 0)) n) with (INR n) in B.
        2: { unfold place; clear; induction n as [| n IH]; [reflexivity |]; cbn [total];
          rewrite <- IH, S_INR, Rmult_0_r, cos_0; reflexivity. }
        replace (place (fun k => sin (INR k * 0)) n) with 0 in B; [lra |].
        symmetry; apply total_zero; intros; rewrite Rmult_0_r; apply sin_0. }
      destruct (nfloor_ex ((Rabs (at_angle c l 0) + 1) / - (static l / 2) + 1)) as [m N].
      { assert (0 <= (Rabs (at_angle c l 0) + 1) / - (static l / 2)) by (apply Rdiv_le_0_compat;
          [generalize (Rabs_pos (at_angle c l 0)) |]; lra); lra. }
      assert (Big : INR m * (static l / 2) + at_angle c l 0 < -1).
      { assert (Y : (Rabs (at_angle c l 0) + 1) < INR m * - (static l / 2)).
        { apply Rmult_lt_reg_r with (/ - (static l / 2)); [apply Rinv_0_lt_compat; lra |].
          rewrite Rmult_assoc, Rinv_r by lra; fold ((Rabs (at_angle c l 0) + 1) / - (static l / 2)); lra. }
        generalize (Rle_abs (at_angle c l 0)); lra. }
      assert (Neg : 0 <= -1); [| lra]; apply (not_falling (-1) (b + INR m)); intro n.
      destruct (Nat.le_ge_cases m n) as [Le | Le].
      - specialize (F n); apply le_INR in Le; assert (INR n * (static l / 2) <= INR m * (static l / 2)) by nra.
        assert (INR n * (INR n * (static l / 2) + at_angle c l 0) <= INR n * -1) by (apply Rmult_le_compat_l;
          [apply pos_INR | lra]).
        generalize (pos_INR m); lra.
      - specialize (F O); simpl in F; apply le_INR in Le; lra. }
    split; [exact S0 |]; intros t T; assert (C := cos_below_one t ltac:(lra)); rewrite at_angle_is by lra.
    destruct (W t) as [b B]; apply (not_falling _ (static l * (4 / (2 - 2 * cos t) / 2) + b)); intro n;
      specialize (B n).
    assert (V := ways_bounded n t);
      set (y := place (fun k => cos (INR k * t)) n ^ 2 + place (fun k => sin (INR k * t)) n ^ 2) in *.
    assert (Y : y <= 4 / (2 - 2 * cos t)).
    { apply Rmult_le_reg_l with (2 - 2 * cos t); [lra |]; rewrite V; unfold Rdiv;
        rewrite (Rmult_comm 4), <- Rmult_assoc, Rinv_r, Rmult_1_l by lra.
      generalize (COS_bound (INR n * t)); lra. }
    assert (static l * (y / 2) <= static l * (4 / (2 - 2 * cos t) / 2)) by (apply Rmult_le_compat_l; lra); lra.
  - intros [S0 A]; intros p n; rewrite energy_of_taps.
    apply Rplus_le_le_0_compat; [apply Rmult_le_pos; [exact S0 | generalize (pow2_ge_0 (place p n)); lra] |].
    apply angles_suffice; intros t T; rewrite <- at_angle_is;
      [exact (A t T) | generalize (cos_below_one t ltac:(lra)); lra].
Qed.

(* -- motions -------------------------------------------------------------------------------------- *)

(* A speed at all times t >= 0, and where it leads from the place 0. *)
Definition speed (v : R -> R) : Prop := forall t, 0 <= t -> ex_RInt v 0 t /\ ex_RInt (fun s => v s ^ 2) 0 t.
Definition position (v : R -> R) (t : R) : R := RInt v 0 t.
Definition burnt (v : R -> R) (t : R) : R := RInt (fun s => v s ^ 2) 0 t.

Lemma between : forall (f : R -> R) a b, (forall t, 0 <= t -> ex_RInt f 0 t) -> 0 <= a <= b ->
  ex_RInt f a b /\ RInt f a b = RInt f 0 b - RInt f 0 a.
Proof.
  intros f a b E [A B]; assert (X : ex_RInt f a b) by (apply (ex_RInt_Chasles_2 f 0); [lra | apply E; lra]).
  split; [exact X |]; assert (Q : RInt f 0 a + RInt f a b = RInt f 0 b) by exact (RInt_Chasles f 0 a b (E a A) X);
    lra.
Qed.
(* A given way costs least at constant speed: the inequality of Schwarz. *)
Lemma schwarz : forall v a b, a <= b -> ex_RInt v a b -> ex_RInt (fun s => v s ^ 2) a b ->
  RInt v a b ^ 2 <= (b - a) * RInt (fun s => v s ^ 2) a b.
Proof.
  intros v a b [L | E] V W; [| subst b; rewrite !RInt_point; unfold zero; simpl; lra].
  set (x := RInt v a b); set (y := RInt _ a b); set (m := x / (b - a)).
  assert (D : is_RInt (fun s => (v s - m) ^ 2) a b (y + (- (2 * m) * x + m ^ 2 * (b - a)))).
  { apply (is_RInt_ext (fun s => plus (v s ^ 2) (plus (scal (- (2 * m)) (v s)) (m ^ 2)))).
    - intros s _; unfold plus, scal; simpl; unfold mult; simpl; ring.
    - apply (is_RInt_plus (V := R_NormedModule)); [apply (RInt_correct (V := R_CompleteNormedModule)), W |].
      apply (is_RInt_plus (V := R_NormedModule)).
      + apply (is_RInt_scal (V := R_NormedModule)); apply (RInt_correct (V := R_CompleteNormedModule)), V.
      + replace (m ^ 2 * (b - a)) with (scal (b - a) (m ^ 2)) by (unfold scal; simpl; unfold mult; simpl; ring).
        apply (is_RInt_const (V := R_NormedModule)). }
  assert (P : 0 <= y + (- (2 * m) * x + m ^ 2 * (b - a))).
  { rewrite <- (is_RInt_unique _ _ _ _ D); apply RInt_ge_0; [lra | eexists; exact D | intros; apply pow2_ge_0]. }
  assert (Q : m * (b - a) = x) by (unfold m; field; lra); nra.
Qed.
Lemma burnt_step : forall v p q, speed v -> 0 <= p <= q ->
  (position v q - position v p) ^ 2 / (q - p) <= burnt v q - burnt v p.
Proof.
  intros v p q V L; unfold burnt, position.
  destruct (between v p q (fun t T => proj1 (V t T)) L) as [E R], (between _ p q (fun t T => proj2 (V t T)) L) as [F
    Q].
  assert (W := schwarz v p q (proj2 L) E F); rewrite R, Q in W; destruct L as [_ [L | Eq]].
  - apply Rle_div_l; [lra |]; rewrite Rmult_comm; exact W.
  - subst q; replace (RInt v 0 p - RInt v 0 p) with 0 by ring; unfold Rdiv; rewrite pow_i, Rmult_0_l by lia; lra.
Qed.
Lemma burnt_start : forall v, burnt v 0 = 0.
Proof. intro v; unfold burnt; rewrite RInt_point; reflexivity. Qed.
Lemma burnt_least : forall v, speed v -> forall (s : nat -> R), s O = 0 -> (forall k, s k <= s (S k)) -> forall n,
  total n (fun k => (position v (s (S k)) - position v (s k)) ^ 2 / (s (S k) - s k)) <= burnt v (s n).
Proof.
  intros v V s S0 Up n; assert (Pos : forall k, 0 <= s k) by (induction k as [| k IH]; [lra | generalize (Up k);
    lra]).
  induction n as [| n IH]; [rewrite S0, burnt_start; simpl; lra |]; cbn [total].
  generalize (burnt_step v (s n) (s (S n)) V (conj (Pos n) (Up n))); lra.
Qed.
(* By p_k at constant speed from s_k to s_(k+1), and then at rest. *)
Fixpoint stepped (s p : nat -> R) (n : nat) (t : R) : R :=
  match n with
  | O => 0
  | S m => if Rlt_dec t (s m) then stepped s p m t else if Rlt_dec t (s n) then p m / (s n - s m) else 0
  end.
Section Stepped.
Variables s p : nat -> R.
Hypotheses (S0 : s O = 0) (Up : forall k, s k < s (S k)).
Lemma s_up : forall j k, (j <= k)%nat -> s j <= s k.
Proof. intros j k L; induction L as [| k L IH]; [lra | generalize (Up k); lra]. Qed.
Lemma s_positive : forall k, 0 <= s k.
Proof. intro k; rewrite <- S0; apply s_up; lia. Qed.
Lemma stepped_at : forall n j t, (j < n)%nat -> s j <= t < s (S j) -> stepped s p n t = p j / (s (S j) - s j).
Proof.
  intros n j t J T; induction n as [| n IH]; [lia |]; simpl.
  destruct (Rlt_dec t (s n)) as [L | L].
  - apply IH; destruct (Nat.eq_dec j n) as [E | N]; [subst; lra | lia].
  - destruct (Nat.eq_dec j n) as [E | N]; [subst; destruct (Rlt_dec t (s (S n))); [reflexivity | lra] |].
    exfalso; generalize (s_up (S j) n ltac:(lia)); lra.
Qed.
Lemma stepped_after : forall n t, s n <= t -> stepped s p n t = 0.
Proof.
  intros [| n] t T; [reflexivity |]; simpl; generalize (Up n); intro U.
  destruct (Rlt_dec t (s n)); [lra |]; destruct (Rlt_dec t (s (S n))); [lra | reflexivity].
Qed.
(* A function of the speed, piece by piece. *)
Lemma stepped_sum : forall (f : R -> R) n j, (j <= n)%nat ->
  is_RInt (fun t => f (stepped s p n t)) 0 (s j) (total j (fun k => (s (S k) - s k) * f (p k / (s (S k) - s k)))).
Proof.
  intros f n j J; induction j as [| j IH].
  - rewrite S0; apply (is_RInt_point (V := R_NormedModule)).
  - cbn [total]; apply (is_RInt_Chasles (V := R_NormedModule)) with (s j); [apply IH; lia |].
    apply (is_RInt_ext (fun _ => f (p j / (s (S j) - s j)))).
    + intros t T; rewrite Rmin_left, Rmax_right in T by (generalize (Up j); lra);
        rewrite (stepped_at n j) by (try lia; lra); reflexivity.
    + apply (is_RInt_const (V := R_NormedModule)).
Qed.
Lemma stepped_integrable : forall (f : R -> R) n t, 0 <= t -> ex_RInt (fun t => f (stepped s p n t)) 0 t.
Proof.
  intros f n t T; apply (ex_RInt_Chasles_1 (V := R_CompleteNormedModule)) with (Rmax t (s n)); [split;
    [exact T | apply Rmax_l] |].
  apply (ex_RInt_Chasles (V := R_NormedModule)) with (s n); [eexists; apply stepped_sum; lia |].
  apply (ex_RInt_ext (fun _ => f 0)); [| apply (ex_RInt_const (V := R_NormedModule))].
  intros u U; rewrite Rmin_left in U by apply Rmax_r; rewrite stepped_after by lra; reflexivity.
Qed.
Lemma stepped_speed : forall n, speed (stepped s p n).
Proof. intros n t T; split; [apply (stepped_integrable (fun v => v)) | apply (stepped_integrable (fun v => v ^ 2))];
  exact T. Qed.
Lemma stepped_position : forall n j, (j <= n)%nat -> position (stepped s p n) (s j) = place p j.
Proof.
  intros n j J; unfold position; etransitivity; [exact (is_RInt_unique _ _ _ _ (stepped_sum (fun v => v) n j J)) |];
    cbv beta.
  unfold place; apply total_alike; intros k _; field; generalize (Up k); lra.
Qed.
Lemma stepped_burnt : forall n j, (j <= n)%nat ->
  burnt (stepped s p n) (s j) = total j (fun k => p k ^ 2 / (s (S k) - s k)).
Proof.
  intros n j J; unfold burnt; etransitivity;
    [exact (is_RInt_unique _ _ _ _ (stepped_sum (fun v => v ^ 2) n j J)) |]; cbv beta.
  apply total_alike; intros k _; field; generalize (Up k); lra.
Qed.
End Stepped.

(* -- walls ---------------------------------------------------------------------------------------- *)

(* The force K x + B (x - x')/T of the sample k, with the places x then and x' one sample before, is held
   from (k + d) T to (k + 1 + d) T. *)
Definition wall_force (K B T : R) (v : R -> R) (k : nat) : R :=
  K * position v (INR k * T) + B * (position v (INR k * T) - position v (INR (pred k) * T)) / T.
(* What a motion costs up to the time e against the forces of n samples and a damper b. *)
Definition work (K B b T d : R) (v : R -> R) (e : R) (n : nat) : R :=
  b * burnt v e + total n (fun k =>
    wall_force K B T v k * (position v (Rmin e ((INR k + 1 + d) * T)) - position v (Rmin e ((INR k + d) * T)))).
(* No motion gains energy, at no time e. *)
Definition passive_wall (K B b T d : R) : Prop :=
  forall v, speed v -> forall e n, 0 <= e <= (INR n + d) * T -> 0 <= work K B b T d v e n.

Lemma position_start : forall v, position v 0 = 0.
Proof. intro v; unfold position; rewrite RInt_point; reflexivity. Qed.
(* From one place to the next is one displacement. *)
Lemma place_of : forall x n, x O = 0 -> place (fun j => x (S j) - x j) n = x n.
Proof. intros x n X; unfold place; induction n as [| n IH]; [simpl; lra |]; cbn [total]; rewrite IH; ring. Qed.
Lemma shorter : forall x l m, 0 <= l <= m -> (l = 0 -> x = 0) -> x ^ 2 / m <= x ^ 2 / l.
Proof.
  intros x l m [[L | L] M] Z; [| rewrite (Z (eq_sym L)); unfold Rdiv; rewrite pow_i, !Rmult_0_l by lia; lra].
  apply Rmult_le_compat_l; [apply pow2_ge_0 | apply Rinv_le_contravar; assumption].
Qed.
Lemma cut_off : forall e a b, a <= b -> 0 <= Rmin e b - Rmin e a <= b - a /\ (e <= a -> Rmin e a = e /\ Rmin e b = e).
Proof. intros e a b L; unfold Rmin; destruct (Rle_dec e a), (Rle_dec e b); repeat split; lra. Qed.

(* -- behind a whole delay ------------------------------------------------------------------------- *)

Definition whole_taps (K B T : R) (m : nat) : list (nat * R) := (m, K + B / T) :: (S m, - (B / T)) :: nil.
Lemma whole_energy : forall K B T c m p n, energy c (impulse (whole_taps K B T m)) p n =
  total n (fun k => c * p k ^ 2 + p k * (K * place p (k - m) + B * (place p (k - m) - place p (k - S m)) / T)).
Proof. intros; apply total_alike; intros k _; rewrite force_of_taps; cbn [whole_taps fold_right fst snd];
  unfold Rdiv; ring. Qed.
Lemma whole_work : forall K B T c m p n, c * total (n + m) (fun k => p k ^ 2) +
    total n (fun k => (K * place p k + B * (place p k - place p (pred k)) / T) * p (k + m)%nat) =
  energy c (impulse (whole_taps K B T m)) p (n + m).
Proof.
  intros K B T c m p n; rewrite whole_energy, total_plus, total_times; f_equal;
    rewrite (Nat.add_comm n m), total_app, (total_zero m).
  - rewrite Rplus_0_l; apply total_alike; intros k _; replace (m + k - m)%nat with k by lia;
      replace (m + k - S m)%nat with (pred k) by lia.
    rewrite (Nat.add_comm k m); ring.
  - intros k L; replace (k - m)%nat with O by lia; replace (k - S m)%nat with O by lia; unfold place; simpl;
      unfold Rdiv; ring.
Qed.
Lemma Cpower_apart : forall z n, z <> RtoC 0 -> (z ^ n)%C <> RtoC 0.
Proof. intros z n Z; induction n as [| n IH]; simpl; [apply Cnot_zero; lra | apply Cmult_neq_0; assumption]. Qed.
Theorem whole_wall : forall (K B b T : R) m H, 0 < T ->
  (forall z, z <> RtoC 0 -> H z = ((B * (z - 1) / (T * z) + K) / z ^ m)%C) ->
  (passive_wall K B b T (INR m) <-> passive H (b / T)).
Proof.
  intros K B b T m H Tp E; assert (Taps : forall z, z <> RtoC 0 -> H z = taps (whole_taps K B T m) z).
  { assert (Tc := Cnot_zero T ltac:(lra)); intros z Z; rewrite E by exact Z; assert (P := Cpower_apart z m Z).
    cbn [taps whole_taps fold_right fst snd Cpower]; rewrite RtoC_opp, RtoC_plus, RtoC_div by lra; field;
      repeat split; assumption. }
  apply iff_sym, (iff_trans (passive_taps H (b / T) _ Taps)); clear Taps; split; intros P.
  - assert (Pb : 0 <= b).
    { specialize (P (fun _ => 1) 1%nat); rewrite whole_energy in P; simpl in P; unfold place in P; simpl in P.
      assert (Q : 0 <= b / T) by (unfold Rdiv in *; nra); apply Rmult_le_reg_r with (/ T);
        [apply Rinv_0_lt_compat, Tp | rewrite Rmult_0_l; exact Q]. }
    intros v V e n [E0 En]; set (s := fun j => Rmin e (INR j * T));
      set (p := fun j => position v (s (S j)) - position v (s j)).
    assert (S0 : s O = 0) by (unfold s; simpl; rewrite Rmult_0_l; apply Rmin_right, E0).
    assert (Up : forall j, 0 <= s (S j) - s j <= T).
    { intro j; unfold s; rewrite S_INR; generalize (proj1 (cut_off e (INR j * T) ((INR j + 1) * T) ltac:(lra)));
        lra. }
    assert (Pl : forall k, place p k = position v (s k)) by (intro k; apply (place_of (fun j => position v (s j)));
      rewrite S0; apply position_start).
    assert (Se : s (n + m)%nat = e) by (unfold s; rewrite plus_INR; apply Rmin_left, En).
    assert (B1 := burnt_least v V s S0 (fun k => ltac:(generalize (Up k); lra)) (n + m)); rewrite Se in B1.
    specialize (P p (n + m)%nat); rewrite <- whole_work in P; unfold work.
    assert (Q : b / T * total (n + m) (fun k => p k ^ 2) <= b * burnt v e).
    { unfold Rdiv; rewrite Rmult_assoc, <- total_times; apply Rmult_le_compat_l; [exact Pb |]; eapply Rle_trans;
        [| exact B1].
      apply total_least; intros k _; rewrite Rmult_comm; fold (p k ^ 2 / T); apply shorter; [apply Up |].
      intro Z; unfold p; replace (s (S k)) with (s k) by lra; ring. }
    eapply Rle_trans; [exact P |]; apply Rplus_le_compat; [exact Q |]; apply Req_le, total_alike; intros k _.
    replace ((INR k + INR m) * T) with (INR (k + m) * T) by (rewrite plus_INR; ring).
    replace ((INR k + 1 + INR m) * T) with (INR (S (k + m)) * T) by (rewrite S_INR, plus_INR; ring).
    fold (s (k + m)%nat) (s (S (k + m))) (p (k + m)%nat); unfold wall_force; rewrite !Pl.
    destruct (Rle_dec e (INR (k + m) * T)) as [L | L].
    + assert (Z : p (k + m)%nat = 0).
      { unfold p, s; rewrite !Rmin_left by (rewrite ?S_INR; lra); ring. }
      rewrite Z; ring.
    + assert (I : forall i, (i <= k)%nat -> s i = INR i * T).
      { intros i I; unfold s; apply Rmin_right; apply Rle_trans with (INR (k + m) * T); [apply Rmult_le_compat_r;
          [lra | apply le_INR; lia] | lra]. }
      rewrite !I by lia; reflexivity.
  - intros p n; set (q := fun j => if Nat.ltb j n then p j else 0).
    assert (Q : energy (b / T) (impulse (whole_taps K B T m)) p n =
      energy (b / T) (impulse (whole_taps K B T m)) q (n + m)).
    { rewrite !whole_energy, total_app, (total_zero m).
      - rewrite Rplus_0_r; apply total_alike; intros k Kn.
        assert (Pl : forall j, (j <= n)%nat -> place q j = place p j).
        { intros j J; apply total_alike; intros i I; unfold q; destruct (Nat.ltb_spec i n); [reflexivity | lia]. }
        rewrite !Pl by lia; unfold q; destruct (Nat.ltb_spec k n); [reflexivity | lia].
      - intros k _; unfold q at 1 2; destruct (Nat.ltb_spec (n + k) n); [lia | simpl; ring]. }
    rewrite Q, <- whole_work; set (s := fun j => INR j * T); assert (S0 : s O = 0) by (unfold s; simpl; ring).
    assert (Up : forall k, s k < s (S k)) by (intro k; unfold s; rewrite S_INR; lra).
    specialize (P (stepped s q (n + m)) (stepped_speed s q S0 Up (n + m)) (s (n + m)%nat) n).
    assert (R0 : 0 <= s (n + m)%nat <= (INR n + INR m) * T) by (split; [apply (s_positive s S0 Up) | unfold s;
      rewrite plus_INR; lra]).
    specialize (P R0); unfold work in P; rewrite (stepped_burnt s q S0 Up) in P by lia.
    match type of P with 0 <= b * ?x + ?y => match goal with |- 0 <= b / T * ?u +
      ?w => replace (b / T * u) with (b * x); [replace w with y; [exact P |] |] end end.
    + apply total_alike; intros k Kn.
      assert (Mn : forall j, (j <= n + m)%nat -> Rmin (s (n + m)%nat) (s j) = s j) by (intros j J;
        apply Rmin_right, (s_up s Up), J).
      replace ((INR k + INR m) * T) with (s (k + m)%nat) by (unfold s; rewrite plus_INR; ring).
      replace ((INR k + 1 + INR m) * T) with (s (S (k + m))) by (unfold s; rewrite S_INR, plus_INR; ring).
      rewrite !Mn by lia; unfold wall_force; fold (s k) (s (pred k)); rewrite !(stepped_position s q S0 Up) by lia.
      unfold place at 4; cbn [total]; fold (place q (k + m)); ring.
    + rewrite (total_alike _ _ (fun k => / T * q k ^ 2)), total_times; [unfold Rdiv; ring |].
      intros k _; unfold s; rewrite S_INR; field; lra.
Qed.

(* -- behind l + u periods --------------------------------------------------------------------------- *)

(* Each force is held from one time (j + u) T to the next.  Over period j, between two such times, the device
   moves by P_j, by A_j up to the sample and by B_j after it; it is off a straight motion by Q_j = A_j - (1 - u) P_j
   when its sample is taken. *)
Section Late.
Variables (K B b T u : R) (l : nat).
Hypotheses (Tp : 0 < T) (bp : 0 < b) (U : 0 < u < 1).
Let g := K + B / T.
Let f := B / T.
Let o := u * (1 - u).
Let r := T * o / (4 * b).
Let w := 2 * r * g * f.
Definition late_taps : list (nat * R) :=
  (l, g * (1 - u)) :: (S l, g * u - f * (1 - u)) :: (S (S l), - (f * u)) :: (O, w) :: (1%nat, - w) :: nil.
Definition late_loss : R := b / T - r * (g ^ 2 + f ^ 2).
Definition one_before (p : nat -> R) (k : nat) : R := match k with O => 0 | S i => p i end.
Lemma late_energy : forall p n, energy late_loss (impulse late_taps) p n = total n (fun k => b / T * p k ^ 2) +
  (total n (fun k => p k * (g * ((1 - u) * place p (k - l) +
    u * place p (k - S l)) - f * ((1 - u) * place p (k - S l) + u * place p (k - S (S l)))))
   - r * total n (fun k => (g ^ 2 + f ^ 2) * p k ^ 2 - 2 * g * f * (p k * one_before p k))).
Proof.
  intros p n; rewrite <- total_times, <- total_minus, <- total_plus; apply total_alike; intros k _.
  rewrite force_of_taps; unfold late_taps, late_loss; cbn [fold_right fst snd].
  replace (place p (k - 0)) with (place p (k - 1) + one_before p k); [unfold w; ring |].
  destruct k as [| k]; [unfold place, one_before; simpl; ring |]; replace (S k - 0)%nat with (S k) by lia;
    replace (S k - 1)%nat with k by lia; reflexivity.
Qed.
Lemma late_squares : forall p n, p n = 0 ->
  total n (fun k => (g ^ 2 + f ^ 2) * p k ^ 2 - 2 * g * f * (p k * one_before p k)) =
  total (S n) (fun k => (g * one_before p k - f * p k) ^ 2).
Proof.
  intros p n Z.
  rewrite <- (total_alike (S n) (fun k => g ^ 2 * one_before p k ^ 2 +
    (f ^ 2 * p k ^ 2 - 2 * g * f * (p k * one_before p k)))) by (intros; ring).
  rewrite total_plus, (total_start n); cbn [total]; rewrite Z; cbn [one_before].
  rewrite <- (total_alike n (fun k => g ^ 2 * p k ^ 2 +
    (f ^ 2 * p k ^ 2 - 2 * g * f * (p k * one_before p k)))) by (intros; ring).
  rewrite total_plus; ring.
Qed.
Variables (P A : nat -> R) (n : nat).
Let N := S (l + n).
Let Q := fun j => A j - (1 - u) * P j.
Let R_ := fun k => g * P (S l + k)%nat - f * P (S (S l) + k)%nat.
Hypotheses (Start : A O = 0) (End : forall j, (N <= j)%nat -> P j = 0).
(* The wall takes more than the filter by squares. *)
Definition late_work : R := b * total N (fun j => A j ^ 2 / ((1 - u) * T) + (P j - A j) ^ 2 / (u * T)) +
  total n (fun k => (K * (place P k + A k) + B * ((place P k + A k) - (place P (pred k) +
    A (pred k))) / T) * P (S l + k)%nat).
Lemma late_work_is : late_work = energy late_loss (impulse late_taps) P N +
  (b / (T * o) * total (S l) (fun k => Q (n + k)%nat ^ 2) +
    r * total (S (S l)) (fun k => (g * one_before P k - f * P k) ^ 2) +
   b / (T * o) * total n (fun k => (Q k + T * o / (2 * b) * R_ k) ^ 2)).
Proof.
  assert (O : 0 < o) by (unfold o; nra).
  assert (Burn : b * total N (fun j => A j ^ 2 / ((1 - u) * T) + (P j - A j) ^ 2 / (u * T)) =
    total N (fun k => b / T * P k ^ 2) + b / (T * o) * total N (fun k => Q k ^ 2)).
  { rewrite <- !total_times, <- total_plus; apply total_alike; intros k _; unfold Q, o; field; repeat split;
      shown_here; lra. }
  assert (Force : total n (fun k => (K * (place P k + A k) + B * ((place P k + A k) - (place P (pred k) +
    A (pred k))) / T) * P (S l + k)%nat) =
    total N (fun k => P k * (g * ((1 - u) * place P (k - l) +
      u * place P (k - S l)) - f * ((1 - u) * place P (k - S l) + u * place P (k - S (S l))))) +
    total n (fun k => Q k * R_ k)).
  { unfold N; change (S (l + n)) with (S l + n)%nat; rewrite (total_app (S l)), (total_zero (S l)), Rplus_0_l.
    2: { intros k Kl; replace (k - l)%nat with 0%nat by lia; replace (k - S l)%nat with 0%nat by lia;
      replace (k - S (S l))%nat with 0%nat by lia.
      unfold place; simpl; ring. }
    assert (Shift : total n (fun k => P (S l + k)%nat * one_before Q k) =
      total n (fun k => P (S (S l) + k)%nat * Q k)).
    { assert (X := total_start n (fun k => P (S l + k)%nat * one_before Q k)); cbn [total one_before] in X.
      rewrite (End (S l + n)%nat) in X by (unfold N; lia).
      rewrite (total_alike n (fun k => P (S (S l) + k)%nat * Q k) (fun k => P (S l + S k)%nat * Q k)); [lra |].
      intros k _; f_equal; f_equal; lia. }
    unfold R_; rewrite (total_alike n (fun k => Q k * _) (fun k => g * (P (S l + k)%nat * Q k) - f * (P (S (S l) +
      k)%nat * Q k))) by (intros; ring).
    rewrite total_minus, (total_times n f), <- Shift, <- total_times, <- total_minus, <- total_plus;
      apply total_alike; intros k _.
    replace (S l + k - l)%nat with (S k) by lia; replace (S l + k - S l)%nat with k by lia;
      replace (S l + k - S (S l))%nat with (pred k) by lia.
    unfold Q; destruct k as [| k].
    - unfold place; cbn [total one_before Init.Nat.pred]; rewrite Start; unfold g, f; field; shown_here; lra.
    - cbn [one_before Init.Nat.pred]; unfold place; cbn [total]; unfold g, f; field; shown_here; lra. }
  unfold late_work; rewrite Burn, Force, late_energy, late_squares by (apply End; lia).
  replace (S N) with (S (S l) + n)%nat by (unfold N; lia); rewrite (total_app (S (S l))).
  rewrite (total_alike n (fun k => (g * one_before P (S (S l) + k) - f * P (S (S l) +
    k)%nat) ^ 2) (fun k => R_ k ^ 2)) by (intros; reflexivity).
  replace (total N (fun k => Q k ^ 2)) with (total n (fun k => Q k ^ 2) + total (S l) (fun k => Q (n + k)%nat ^ 2)).
  2: { rewrite <- (total_app n (S l) (fun k => Q k ^ 2)); f_equal; unfold N; lia. }
  replace (b / (T * o) * total n (fun k => (Q k + T * o / (2 * b) * R_ k) ^ 2)) with
    (b / (T * o) * total n (fun k => Q k ^ 2) + total n (fun k => Q k * R_ k) + r * total n (fun k => R_ k ^ 2));
      [ring |].
  rewrite <- !total_times, <- !total_plus; apply total_alike; intros k _; unfold r; field; repeat split; shown_here;
    lra.
Qed.
End Late.

(* Displacements that begin at a. *)
Definition begun (a n : nat) (p : nat -> R) (j : nat) : R :=
  if Nat.ltb j a then 0 else if Nat.ltb (j - a) n then p (j - a)%nat else 0.
Lemma begun_place : forall a n p i, (i <= n)%nat -> place (begun a n p) (a + i) = place p i.
Proof.
  intros a n p i I; unfold place; rewrite total_app, (total_zero a), Rplus_0_l.
  - apply total_alike; intros k K; unfold begun; replace (a + k - a)%nat with k by lia.
    destruct (Nat.ltb_spec (a + k) a), (Nat.ltb_spec k n); try lia; reflexivity.
  - intros k K; unfold begun; destruct (Nat.ltb_spec k a); [reflexivity | lia].
Qed.
Lemma begun_before : forall a n p i, (i <= a)%nat -> place (begun a n p) i = 0.
Proof. intros a n p i I; apply total_zero; intros k K; unfold begun; destruct (Nat.ltb_spec k a);
  [reflexivity | lia]. Qed.
Lemma begun_energy : forall c l a n p, energy c (impulse l) (begun a n p) (a + n) = energy c (impulse l) p n.
Proof.
  intros c l a n p; unfold energy; rewrite total_app, (total_zero a), Rplus_0_l.
  - apply total_alike; intros k K; rewrite !force_of_taps.
    replace (begun a n p (a + k)) with (p k).
    2: { unfold begun; replace (a + k - a)%nat with k by lia; destruct (Nat.ltb_spec (a + k) a), (Nat.ltb_spec k n);
      try lia; reflexivity. }
    f_equal; f_equal; induction l as [| u l IH]; [reflexivity |]; cbn [fold_right]; rewrite IH; f_equal; f_equal.
    destruct (Nat.le_ge_cases (fst u) k) as [L | L].
    + replace (a + k - fst u)%nat with (a + (k - fst u))%nat by lia; apply begun_place; lia.
    + rewrite begun_before by lia; replace (k - fst u)%nat with O by lia; reflexivity.
  - intros k K; unfold begun; destruct (Nat.ltb_spec k a); [simpl; ring | lia].
Qed.

Section Wall.
Variables (K B b T u : R) (l : nat).
Hypotheses (Tp : 0 < T) (bp : 0 < b) (U : 0 < u < 1).
Lemma late_down : (forall p n, 0 <= energy (late_loss K B b T u) (impulse (late_taps K B b T u l)) p n) ->
  passive_wall K B b T (INR l + u).
Proof.
  intros Pos v V e n [E0 En]; set (a := fun j => Rmin e (INR j * T)); set (h := fun j => Rmin e ((INR j + u) * T)).
  set (x := position v); set (P := fun j => match j with O => x (h O) | S i => x (h (S i)) - x (h i) end).
  set (A := fun j => match j with O => 0 | S i => x (a (S i)) - x (h i) end).
  assert (a0 : a O = 0) by (unfold a; simpl; rewrite Rmult_0_l; apply Rmin_right, E0).
  assert (X0 : x 0 = 0) by apply position_start.
  assert (Pl : forall j, place P (S j) = x (h j)).
  { intro j; induction j as [| j IH]; [unfold place; simpl; ring |];
      change (place P (S (S j))) with (place P (S j) + P (S j)); rewrite IH; unfold P; ring. }
  assert (Xa : forall k, place P k + A k = x (a k)).
  { intros [| k]; [rewrite a0, X0; unfold place; simpl; ring | rewrite Pl; unfold A; ring]. }
  assert (U1 : forall j, 0 <= h j - a j <= u * T /\ 0 <= a (S j) - h j <= (1 - u) * T /\ 0 <= a j).
  { intro j; unfold a, h; rewrite S_INR; assert (0 <= INR j * T) by (apply Rmult_le_pos; [apply pos_INR | lra]).
    assert (0 < u * T) by nra; assert (0 < (1 - u) * T) by nra.
    generalize (proj1 (cut_off e (INR j * T) ((INR j + u) * T) ltac:(lra))) (proj1 (cut_off e ((INR j +
      u) * T) ((INR j + 1) * T) ltac:(lra))).
    assert (0 <= Rmin e (INR j * T)) by (apply Rmin_glb; assumption); lra. }
  assert (Burn : forall m, total (S m) (fun j => A j ^ 2 / ((1 - u) * T) +
    (P j - A j) ^ 2 / (u * T)) <= burnt v (h m)).
  { assert (Z : forall p q, 0 <= p <= q -> q - p = 0 -> x q - x p = 0) by (intros p q L Z; replace q with p by lra;
      ring).
    assert (F : forall j, (x (h j) - x (a j)) ^ 2 / (u * T) <= burnt v (h j) - burnt v (a j)).
    { intro j; destruct (U1 j) as (L & _ & G); eapply Rle_trans; [apply (shorter _ _ _ L); intro; apply Z;
        lra | apply burnt_step; [exact V | lra]]. }
    induction m as [| m IH]; cbn [total].
    - specialize (F O); rewrite a0, burnt_start, X0 in F; unfold P, A; unfold Rdiv at 1;
        rewrite pow_i, Rmult_0_l by lia.
      replace (x (h O) - 0) with (x (h O)) in * by ring; lra.
    - cbn [total] in IH; assert (G : (x (a (S m)) - x (h m)) ^ 2 / ((1 - u) * T) <= burnt v (a (S m)) - burnt v (h
        m)).
      { destruct (U1 m) as (L' & L & G); eapply Rle_trans; [apply (shorter _ _ _ L); intro; apply Z;
          lra | apply burnt_step; [exact V | lra]]. }
      specialize (F (S m)); cbn [P A];
        replace (x (h (S m)) - x (h m) - (x (a (S m)) - x (h m))) with (x (h (S m)) - x (a (S m))) by ring; lra. }
  assert (He : h (l + n)%nat = e) by (unfold h; rewrite plus_INR; apply Rmin_left; lra).
  assert (End : forall j, (S (l + n) <= j)%nat -> P j = 0).
  { intros [| j] J; [lia |]; unfold P; assert (Hj : forall i, (l + n <= i)%nat -> h i = e).
    { intros i I; unfold h; apply Rmin_left; apply le_INR in I; rewrite plus_INR in I; eapply Rle_trans;
        [exact En | apply Rmult_le_compat_r; lra]. }
    rewrite !Hj by lia; ring. }
  assert (W := late_work_is K B b T u l Tp bp U P A n eq_refl End).
  assert (N : 0 <= late_work K B b T u l P A n).
  { rewrite W; apply Rplus_le_le_0_compat; [apply Pos |];
      assert (0 < b / (T * (u * (1 - u)))) by (apply Rdiv_lt_0_compat; [exact bp | apply Rmult_lt_0_compat; nra]).
    assert (0 < T * (u * (1 - u)) / (4 * b)) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; nra | lra]).
    repeat apply Rplus_le_le_0_compat; (apply Rmult_le_pos; [lra | apply total_positive; intros; apply pow2_ge_0]). }
  eapply Rle_trans; [exact N |]; unfold late_work, work; apply Rplus_le_compat.
  - apply Rmult_le_compat_l; [lra |]; rewrite <- He; apply Burn.
  - apply Req_le, total_alike; intros k _; rewrite !Xa.
    replace ((INR k + (INR l + u)) * T) with ((INR (l + k) + u) * T) by (rewrite plus_INR; ring).
    replace ((INR k + 1 + (INR l + u)) * T) with ((INR (S (l + k)) + u) * T) by (rewrite S_INR, plus_INR; ring).
    fold (h (l + k)%nat) (h (S (l + k))); change (P (S l + k)%nat) with (x (h (S (l + k))) - x (h (l + k)%nat)).
    unfold wall_force; fold x; destruct (Rle_dec e ((INR (l + k) + u) * T)) as [L | L].
    + assert (Hj : h (l + k)%nat = e /\ h (S (l + k)) = e) by (unfold h; rewrite !Rmin_left by (rewrite ?S_INR;
        lra); split; reflexivity).
      rewrite (proj1 Hj), (proj2 Hj); ring.
    + assert (I : forall i, (i <= k)%nat -> a i = INR i * T).
      { intros i I; unfold a; apply Rmin_right; apply Rle_trans with ((INR (l + k) + u) * T);
          [apply Rmult_le_compat_r; [lra |] | lra].
        apply Rle_trans with (INR (l + k)); [apply le_INR; lia | lra]. }
      rewrite !I by lia; reflexivity.
Qed.
Lemma late_up : passive_wall K B b T (INR l + u) ->
  forall p n, 0 <= energy (late_loss K B b T u) (impulse (late_taps K B b T u l)) p n.
Proof.
  intros Pass p n0; set (a := S (S (S l))); set (P := begun a n0 p); set (n := S (S n0)).
  set (g := K + B / T); set (f := B / T); set (o := u * (1 - u)).
  set (A := fun j => (1 - u) * P j - T * o / (2 * b) * (g * P (S l + j)%nat - f * P (S (S l) + j)%nat)).
  assert (Before : forall j, (j < a)%nat -> P j = 0) by (intros j J; unfold P, begun; destruct (Nat.ltb_spec j a);
    [reflexivity | lia]).
  assert (End : forall j, (S (l + n) <= j)%nat -> P j = 0).
  { intros j J; unfold P, begun; destruct (Nat.ltb_spec j a); [reflexivity |]; destruct (Nat.ltb_spec (j - a) n0);
      [unfold a, n in *; lia | reflexivity]. }
  assert (A0 : A O = 0) by (unfold A; rewrite !Before by (unfold a; lia); ring).
  assert (W := late_work_is K B b T u l Tp bp U P A n A0 End).
  assert (Q : energy (late_loss K B b T u) (impulse (late_taps K B b T u l)) p n0 = late_work K B b T u l P A n).
  { rewrite W; replace (S (l + n)) with (a + n0)%nat by (unfold a, n; lia); unfold P at 1; rewrite begun_energy.
    rewrite (total_zero (S l)), (total_zero (S (S l))), (total_zero n); [ring | | |]; intros k Kn.
    - unfold A; fold g f o; field; lra.
    - replace (one_before P k) with 0; [rewrite (Before k) by (unfold a; lia); ring |].
      destruct k as [| k]; [reflexivity | symmetry; apply Before; unfold a; lia].
    - unfold A; rewrite (End (S l + (n + k))%nat), (End (S (S l) + (n + k))%nat) by lia; ring. }
  rewrite Q; clear W Q.
  set (s := fun i => INR (Nat.div2 i) * T + if Nat.odd i then u * T else 0).
  set (y := fun i => if Nat.odd i then place P (S (Nat.div2 i)) else place P (Nat.div2 i) + A (Nat.div2 i)).
  assert (Even : forall j, Nat.odd (2 * j) = false /\ Nat.odd (S (2 * j)) = true /\ Nat.div2 (2 * j) =
    j /\ Nat.div2 (S (2 * j)) = j).
  { intro j; rewrite Nat.div2_double, Nat.div2_succ_double, Nat.odd_succ, <- Nat.negb_even, Nat.even_mul;
      repeat split; reflexivity. }
  assert (Se : forall j, s (2 * j)%nat = INR j * T) by (intro j; destruct (Even j) as (C & _ & D & _); unfold s;
    rewrite C, D; ring).
  assert (So : forall j, s (S (2 * j)) = (INR j + u) * T) by (intro j; destruct (Even j) as (_ & C & _ & D);
    unfold s; rewrite C, D; ring).
  assert (Ye : forall j, y (2 * j)%nat = place P j + A j) by (intro j; destruct (Even j) as (C & _ & D & _);
    unfold y; rewrite C, D; reflexivity).
  assert (Yo : forall j, y (S (2 * j)) = place P (S j)) by (intro j; destruct (Even j) as (_ & C & _ & D); unfold y;
    rewrite C, D; reflexivity).
  assert (Sss : forall j, S (S (2 * j)) = (2 * S j)%nat) by (intro; lia).
  assert (S0 : s O = 0) by (transitivity (INR 0 * T); [exact (Se O) | simpl; ring]).
  assert (Up : forall i, s i < s (S i)).
  { intro i; assert (0 < u * T) by nra; assert (0 < (1 - u) * T) by nra;
      destruct (Nat.Even_or_Odd i) as [[j J] | [j J]]; subst i.
    - rewrite Se, So; lra.
    - rewrite Nat.add_1_r, So, Sss, Se, S_INR; lra. }
  set (D := fun i => y (S i) - y i); assert (Y0 : y O = 0) by (transitivity (place P O + A O);
    [exact (Ye O) | rewrite A0; unfold place; simpl; ring]).
  set (M := S (2 * (l + n))); set (v := stepped s D M).
  assert (Pv : forall i, (i <= M)%nat -> position v (s i) = y i).
  { intros i I; unfold v; rewrite (stepped_position s D S0 Up) by exact I; apply place_of, Y0. }
  assert (Sum : forall m, total (S (2 * m)) (fun k => D k ^ 2 / (s (S k) - s k)) =
    total (S m) (fun j => A j ^ 2 / ((1 - u) * T) + (P j - A j) ^ 2 / (u * T))).
  { induction m as [| m IH].
    - change (2 * 0)%nat with O; cbn [total]; rewrite (So O : s 1%nat = _), S0, A0; unfold D;
        rewrite (Yo O : y 1%nat = _), Y0.
      unfold place; simpl; field; repeat split; shown_here; lra.
    - rewrite <- Sss; change (total (S (S (S (2 * m)))) ?F) with (total (S (2 * m)) F + F (S (2 * m)) +
        F (S (S (2 * m)))); rewrite IH.
      change (total (S (S m)) ?F) with (total (S m) F + F (S m)); unfold D; rewrite Sss, !So, !Se, !Yo, !Ye, S_INR.
      replace ((INR m + 1) * T - (INR m + u) * T) with ((1 - u) * T) by ring.
      replace ((INR m + 1 + u) * T - (INR m + 1) * T) with (u * T) by ring; unfold place; cbn [total]; field.
      repeat split; shown_here; lra. }
  assert (Bv : burnt v (s M) = total (S (l + n)) (fun j => A j ^ 2 / ((1 - u) * T) + (P j - A j) ^ 2 / (u * T))).
  { unfold v; rewrite (stepped_burnt s D S0 Up) by lia; apply Sum. }
  specialize (Pass v (stepped_speed s D S0 Up M) (s M) n).
  assert (Sm : s M = (INR n + (INR l + u)) * T) by (unfold M; rewrite So, plus_INR; ring).
  specialize (Pass ltac:(split; [apply (s_positive s S0 Up) | rewrite Sm; lra])); unfold work in Pass;
    rewrite Bv in Pass.
  unfold late_work; match type of Pass with 0 <= _ + ?q => match goal with |- 0 <= _ + ?r => replace r with q;
    [exact Pass |] end end.
  apply total_alike; intros k Kn.
  assert (Mn : forall j, (j <= M)%nat -> Rmin (s M) (s j) = s j) by (intros j J; apply Rmin_right, (s_up s Up), J).
  replace ((INR k + (INR l + u)) * T) with (s (S (2 * (l + k)))) by (rewrite So, plus_INR; ring).
  replace ((INR k + 1 + (INR l + u)) * T) with (s (S (2 * S (l + k)))) by (rewrite So, S_INR, plus_INR; ring).
  rewrite !Mn, !Pv by (unfold M; lia); unfold wall_force; rewrite <- !Se, !Pv, !Ye, !Yo by (unfold M; lia).
  change (place P (S (S (l + k)))) with (place P (S (l + k)) + P (S (l + k)));
    change (S l + k)%nat with (S (l + k)); ring.
Qed.
End Wall.

Theorem late_wall : forall (K B b T u : R) l H c, 0 < T -> 0 < b -> 0 <= u <= 1 ->
  (forall z, z <> RtoC 0 -> H z = (B * u * (1 - u) * (1 - 1 / z) * (B + K * T) / (2 * T * b) +
    (u / z ^ S l + (1 - u) / z ^ l) * (B * (z - 1) / (T * z) + K))%C) ->
  c = b / T - u * (1 - u) * (B ^ 2 + (B + K * T) ^ 2) / (4 * T * b) ->
  (passive_wall K B b T (INR l + u) <-> passive H c).
Proof.
  intros K B b T u l H c Tp bp [U0 U1] E C; assert (Tc := Cnot_zero T ltac:(lra));
    assert (bc := Cnot_zero b ltac:(lra)).
  destruct U0 as [U0 | U0]; [destruct U1 as [U1 | U1] |].
  - assert (Taps : forall z, z <> RtoC 0 -> H z = taps (late_taps K B b T u l) z).
    { intros z Z; rewrite E by exact Z; assert (P := Cpower_apart z l Z).
      cbn [taps late_taps fold_right fst snd Cpower]; unfold Rdiv; rewrite !RtoC_opp.
      repeat first [rewrite RtoC_plus | rewrite RtoC_minus | rewrite RtoC_mult | rewrite RtoC_opp | rewrite RtoC_inv
        by nra].
      field; repeat split; try assumption; apply Cnot_zero; lra. }
    replace c with (late_loss K B b T u) by (rewrite C; unfold late_loss; field; lra).
    apply iff_sym, (iff_trans (passive_taps H _ _ Taps)); split; [apply late_down | apply late_up]; auto.
  - subst u; replace (INR l + 1) with (INR (S l)) by (rewrite S_INR; ring).
    replace c with (b / T) by (rewrite C; field; lra); apply whole_wall; [exact Tp |]; intros z Z;
      rewrite E by exact Z.
    assert (P := Cpower_apart z l Z); simpl; field; repeat split; try assumption; apply Cnot_zero; lra.
  - subst u; replace (INR l + 0) with (INR l) by ring.
    replace c with (b / T) by (rewrite C; field; lra); apply whole_wall; [exact Tp |]; intros z Z;
      rewrite E by exact Z.
    assert (P := Cpower_apart z l Z); simpl; field; repeat split; try assumption; apply Cnot_zero; lra.
Qed.

(* -- a motion that gains energy ----------------------------------------------------------------- *)

(* Piece by piece, (time, way), each at constant speed: the speed, and what it adds up to. *)
Fixpoint going (l : list (R * R)) (t : R) : R :=
  match l with nil => 0 | (time, way) :: rest => if Rlt_dec t time then way / time else going rest (t - time) end.
Fixpoint amount (f : R -> R) (l : list (R * R)) (t : R) : R :=
  match l with
  | nil => 0
  | (time, way) :: rest => if Rle_dec time t then time * f (way / time) +
    amount f rest (t - time) else t * f (way / time)
  end.
Lemma going_integral : forall f l, f 0 = 0 -> Forall (fun u => 0 < fst u) l -> forall t, 0 <= t ->
  is_RInt (fun s => f (going l s)) 0 t (amount f l t).
Proof.
  intros f l Z P; induction P as [| [time way] l Pu P IH]; intros t T.
  - apply (is_RInt_ext (fun _ => 0)); [intros; simpl; symmetry; exact Z |].
    replace (amount f nil t) with (scal (t - 0) 0) by (unfold scal; simpl; unfold mult; simpl; ring).
    apply (is_RInt_const (V := R_NormedModule)).
  - simpl in Pu; assert (First : forall s, 0 <= s <= time ->
      is_RInt (fun s => f (going ((time, way) :: l) s)) 0 s (s * f (way / time))).
    { intros s S; apply (is_RInt_ext (fun _ => f (way / time))).
      - intros x X; rewrite Rmin_left, Rmax_right in X by lra; simpl; destruct (Rlt_dec x time); [reflexivity | lra].
      - replace (s * f (way / time)) with (scal (s - 0) (f (way / time))) by (unfold scal; simpl; unfold mult;
          simpl; ring).
        apply (is_RInt_const (V := R_NormedModule)). }
    cbn [amount]; destruct (Rle_dec time t) as [L | L]; [| apply First; lra].
    apply (is_RInt_Chasles (V := R_NormedModule)) with time; [apply First; lra |].
    apply (is_RInt_ext (fun s => scal 1 (f (going l (1 * s + - time))))).
    + intros x X; rewrite Rmin_left, Rmax_right in X by lra; unfold scal; simpl; unfold mult; simpl;
        destruct (Rlt_dec x time); [lra |].
      rewrite Rmult_1_l; do 2 f_equal; ring.
    + apply (is_RInt_comp_lin (V := R_NormedModule) (fun s => f (going l s))).
      replace (1 * time + - time) with 0 by ring; replace (1 * t + - time) with (t - time) by ring; apply IH; lra.
Qed.
(* A motion from rest at 0, piece by piece (time in periods, way); the force that a wall holds from k + late on
   is K x_k + B (x_k - x_(k-1))/T.  All of it but K, B and b is rational. *)
Module Motion.
Import QArith Qround.
Open Scope Q_scope.
Fixpoint after (motion : list (Q * Q)) (t : Q) : Q :=
  match motion with
  | nil => 0
  | cons (time, way) rest =>
      if Qle_bool time t then Qred (way + after rest (t - time)) else Qred (way * t / time)
  end.
Definition place motion t := if Qle_bool t 0 then 0 else after motion t.
Fixpoint lasts (motion : list (Q * Q)) : Q :=
  match motion with nil => 0 | cons (time, _) rest => Qred (time + lasts rest) end.
Fixpoint forwards (motion : list (Q * Q)) : bool :=
  match motion with nil => true | cons (time, _) rest => andb (negb (Qle_bool time 0)) (forwards rest) end.
Fixpoint burnt (motion : list (Q * Q)) : Q :=
  match motion with nil => 0 | cons (time, way) rest => Qred (way * way / time + burnt rest) end.
(* The sum of f(k) times the way while the force of sample k is held, for k = 1 to n. *)
Fixpoint taken motion (late : Q) (f : Q -> Q) (n : nat) : Q :=
  match n with
  | O => 0
  | S m =>
      let k := inject_Z (Z.of_nat n) in
      Qred (f k * (place motion (k + 1 + late) - place motion (k + late)) + taken motion late f m)
  end.
Definition samples motion := Z.to_nat (Qceiling (lasts motion)).
Definition by_spring motion late := taken motion late (place motion) (samples motion).
Definition by_damper motion late :=
  taken motion late (fun k => place motion k - place motion (k - 1)) (samples motion).
Definition energy (K B b T : R) (late : Q) motion : R :=
  (b / T * Q2R (burnt motion) + K * Q2R (by_spring motion late) + B / T * Q2R (by_damper motion late))%R.
End Motion.
Lemma Q2R_reduced : forall q, Q2R (Qreduction.Qred q) = Q2R q.
Proof. intro q; apply Qreals.Qeq_eqR, Qreduction.Qred_correct. Qed.
Lemma Q2R_whole : forall z, Q2R (QArith_base.inject_Z z) = IZR z.
Proof. intro z; unfold Q2R, QArith_base.inject_Z; cbn [QArith_base.Qnum QArith_base.Qden]; field. Qed.
Section Gains.
Variables (T : R) (motion : list (QArith_base.Q * QArith_base.Q)).
Hypotheses (Tp : 0 < T) (Forwards : Motion.forwards motion = true).
Definition real_pieces (m : list (QArith_base.Q * QArith_base.Q)) := map (fun u => (T * Q2R (fst u), Q2R (snd u))) m.
Lemma times_positive : forall m, Motion.forwards m = true -> Forall (fun u => 0 < Q2R (fst u)) m.
Proof.
  induction m as [| [time way] m IH]; simpl; intro F; constructor; apply andb_prop in F; destruct F as [F G];
    [| exact (IH G)].
  simpl; apply Rnot_le_lt; intro L; apply Bool.negb_true_iff in F; rewrite <- RMicromega.Q2R_0 in L;
    apply Qreals.Rle_Qle in L.
  apply QArith_base.Qle_bool_iff in L; congruence.
Qed.
Lemma pieces_forwards : Forall (fun u => 0 < fst u) (real_pieces motion).
Proof.
  assert (P := times_positive motion Forwards); clear Forwards; unfold real_pieces; induction P as [| u l U P IH];
    constructor; [| exact IH].
  simpl; apply Rmult_lt_0_compat; assumption.
Qed.
Let v := going (real_pieces motion).
Lemma pieces_speed : speed v.
Proof.
  intros t Ht; split; eexists.
  - apply (going_integral (fun v => v)); [reflexivity | apply pieces_forwards | exact Ht].
  - apply (going_integral (fun v => v ^ 2)); [ring | apply pieces_forwards | exact Ht].
Qed.
Lemma pieces_after : forall m, Forall (fun u => 0 < Q2R (fst u)) m ->
  forall q, Q2R (Motion.after m q) = amount (fun v => v) (real_pieces m) (T * Q2R q).
Proof.
  intros m P; induction P as [| [time way] m U P IH]; intro q; [apply RMicromega.Q2R_0 |];
    cbn [Motion.after real_pieces map amount fst snd] in *.
  assert (Nz : ~ QArith_base.Qeq time (QArith_base.inject_Z 0)).
  { intro E; apply Qreals.Qeq_eqR in E; rewrite E in U; unfold Q2R in U; simpl in U; lra. }
  destruct (QArith_base.Qle_bool time q) eqn:L, (Rle_dec (T * Q2R time) (T * Q2R q)) as [M | M]; rewrite Q2R_reduced.
  - rewrite Qreals.Q2R_plus, IH, Qreals.Q2R_minus; f_equal; [field; lra | f_equal; ring].
  - exfalso; apply M; apply Rmult_le_compat_l; [lra |]; apply Qreals.Qle_Rle, QArith_base.Qle_bool_iff, L.
  - exfalso; apply Rmult_le_reg_l in M; [| exact Tp]; apply Qreals.Rle_Qle, QArith_base.Qle_bool_iff in M; congruence.
  - rewrite Qreals.Q2R_div, Qreals.Q2R_mult by exact Nz; field; lra.
Qed.
Lemma pieces_place : forall q, 0 <= Q2R q -> position v (T * Q2R q) = Q2R (Motion.place motion q).
Proof.
  intros q P; unfold position, Motion.place; destruct (QArith_base.Qle_bool q (QArith_base.Qmake 0 1)) eqn:L.
  - apply QArith_base.Qle_bool_iff, Qreals.Qle_Rle in L; assert (Z : Q2R q = 0) by (unfold Q2R in L at 2;
      simpl in L; lra).
    rewrite Z, Rmult_0_r, RInt_point, RMicromega.Q2R_0; reflexivity.
  - rewrite (pieces_after motion (times_positive motion Forwards)).
    apply is_RInt_unique, (going_integral (fun v => v)); [reflexivity | apply pieces_forwards | apply Rmult_le_pos;
      lra].
Qed.
Lemma pieces_burnt : forall t, Q2R (Motion.lasts motion) <= t -> burnt v (T * t) = Q2R (Motion.burnt motion) / T.
Proof.
  intros t L; assert (A : forall m, Forall (fun u => 0 < Q2R (fst u)) m -> 0 <= Q2R (Motion.lasts m) /\
    forall t, Q2R (Motion.lasts m) <= t ->
      amount (fun v => v ^ 2) (real_pieces m) (T * t) = Q2R (Motion.burnt m) / T).
  { intros m P; induction P as [| [time way] m U P [N IH]]; [split; [simpl; rewrite RMicromega.Q2R_0;
      lra | intros s _; simpl; rewrite RMicromega.Q2R_0; field; lra] |].
    cbn [Motion.lasts Motion.burnt real_pieces map amount fst snd] in *; rewrite !Q2R_reduced, Qreals.Q2R_plus;
      split; [lra |]; intros s S.
    assert (Nz : ~ QArith_base.Qeq time (QArith_base.inject_Z 0)).
    { intro E; apply Qreals.Qeq_eqR in E; rewrite E in U; unfold Q2R in U; simpl in U; lra. }
    destruct (Rle_dec (T * Q2R time) (T * s)) as [M | M]; [| exfalso; apply M, Rmult_le_compat_l; lra].
    replace (T * s - T * Q2R time) with (T * (s - Q2R time)) by ring; rewrite IH by lra.
    rewrite Qreals.Q2R_plus, Qreals.Q2R_div, Qreals.Q2R_mult by exact Nz; field; lra. }
  destruct (A motion (times_positive motion Forwards)) as [N B]; rewrite <- (B t L); unfold burnt.
  apply is_RInt_unique, (going_integral (fun v => v ^ 2)); [ring | apply pieces_forwards | apply Rmult_le_pos; lra].
Qed.
Lemma pieces_taken : forall (late : QArith_base.Q) (f : QArith_base.Q -> QArith_base.Q) (g : nat ->
  R) n, 0 <= Q2R late ->
  (forall k, Q2R (f (QArith_base.inject_Z (Z.of_nat (S k)))) = g k) ->
  Q2R (Motion.taken motion late f n) =
    total n (fun k => g k * (position v ((INR (S k) + 1 + Q2R late) * T) - position v ((INR (S k) + Q2R late) * T))).
Proof.
  intros late f g n P F; induction n as [| n IH]; [apply RMicromega.Q2R_0 |].
  assert (I : Q2R (QArith_base.inject_Z (Z.of_nat (S n))) = INR (S n)) by (rewrite Q2R_whole; symmetry;
    apply INR_IZR_INZ).
  assert (Pn := pos_INR (S n)).
  change (Motion.taken motion late f (S n)) with (let k := QArith_base.inject_Z (Z.of_nat (S n)) in
    Qreduction.Qred (QArith_base.Qplus (QArith_base.Qmult (f k) (QArith_base.Qminus (Motion.place motion
      (QArith_base.Qplus (QArith_base.Qplus k (QArith_base.inject_Z 1)) late)) (Motion.place motion
      (QArith_base.Qplus k late)))) (Motion.taken motion late f n))).
  cbv zeta; rewrite Q2R_reduced, Qreals.Q2R_plus, Qreals.Q2R_mult, Qreals.Q2R_minus, IH, F; cbn [total].
  assert (One : Q2R (QArith_base.inject_Z 1) = 1) by apply Q2R_whole.
  rewrite <- !pieces_place by (rewrite !Qreals.Q2R_plus, ?One, I; lra);
    rewrite !Qreals.Q2R_plus, One, I, !(Rmult_comm T); ring.
Qed.
End Gains.
Theorem gains_energy : forall (K B b T d : R) (late : QArith_base.Q) (motion : list _),
  d = Q2R late -> 0 <= b -> 0 < T -> QArith_base.Qle_bool (QArith_base.inject_Z 0) late = true ->
  Motion.forwards motion = true -> Motion.energy K B b T late motion < 0 -> ~ passive_wall K B b T d.
Proof.
  intros K B b T d late motion D Bp Tp L F E P; subst d.
  apply QArith_base.Qle_bool_iff, Qreals.Qle_Rle in L; assert (L0 : 0 <= Q2R late) by (rewrite Q2R_whole in L;
    exact L).
  set (v := going (real_pieces T motion)); set (n := Motion.samples motion).
  specialize (P v (pieces_speed T motion Tp F) ((INR (S n) + Q2R late) * T) (S n)).
  assert (Pn := pos_INR (S n)); specialize (P ltac:(split; [apply Rmult_le_pos; lra | lra])); unfold work in P.
  assert (End : Q2R (Motion.lasts motion) <= INR (S n) + Q2R late).
  { assert (C := Qround.Qle_ceiling (Motion.lasts motion)); apply Qreals.Qle_Rle in C; eapply Rle_trans; [exact C |].
    rewrite S_INR; unfold n, Motion.samples; rewrite Q2R_whole.
    destruct (Z_le_dec 0 (Qround.Qceiling (Motion.lasts motion))) as [Z | Z].
    - rewrite INR_IZR_INZ, Z2Nat.id by exact Z; lra.
    - assert (IZR (Qround.Qceiling (Motion.lasts motion)) <= 0) by (apply IZR_le; lia);
        generalize (pos_INR (Z.to_nat (Qround.Qceiling (Motion.lasts motion)))); lra. }
  rewrite (Rmult_comm _ T) in P at 1; fold v in P; unfold v in P at 1;
    rewrite (pieces_burnt T motion Tp F _ End) in P.
  apply (Rlt_not_le _ _ E); eapply Rle_trans; [exact P |]; apply Req_le; unfold Motion.energy.
  rewrite total_start; unfold wall_force at 1; cbn [Init.Nat.pred]; simpl (INR 0); rewrite Rmult_0_l, position_start.
  assert (Whole : forall k, Q2R (QArith_base.inject_Z (Z.of_nat k)) = INR k) by (intro k; rewrite Q2R_whole;
    symmetry; apply INR_IZR_INZ).
  assert (At : forall q k, Q2R q = INR k -> Q2R (Motion.place motion q) = position v (INR k * T)).
  { intros q k Q; rewrite Rmult_comm, <- Q; symmetry; apply (pieces_place T motion Tp F); rewrite Q; apply pos_INR. }
  unfold Motion.by_spring, Motion.by_damper.
  rewrite (pieces_taken T motion Tp F late (Motion.place motion) (fun k => position v (INR (S k) * T)) _ L0)
    by (intro; apply At, Whole).
  rewrite (pieces_taken T motion Tp F late _ (fun k => position v (INR (S k) * T) - position v (INR k * T)) _ L0).
  2: { intro k; rewrite Qreals.Q2R_minus; f_equal; apply At; [apply Whole |].
       rewrite Qreals.Q2R_minus, Whole, S_INR; change (Q2R {| QArith_base.Qnum := 1;
         QArith_base.Qden := 1 |}) with (Q2R (QArith_base.inject_Z 1)); rewrite Q2R_whole; ring. }
  fold v n; replace (b * (Q2R (Motion.burnt motion) / T)) with (b / T * Q2R (Motion.burnt motion)) by (unfold Rdiv;
    ring).
  rewrite (Rplus_assoc (b / T * _)); apply Rplus_eq_compat_l;
    rewrite <- (total_times n K), <- (total_times n (B / T)), <- total_plus.
  replace (K * 0 + B * (0 - 0) / T) with 0 by (unfold Rdiv; ring); rewrite Rmult_0_l.
  rewrite Rplus_0_l; apply total_alike; intros k Kn; rewrite !Rmin_right.
  - unfold wall_force; cbn [Init.Nat.pred]; field; lra.
  - apply Rmult_le_compat_r; [lra |]; apply Rplus_le_compat_r; apply le_INR; lia.
  - apply Rmult_le_compat_r; [lra |]; apply Rplus_le_compat_r; rewrite <- S_INR; apply le_INR; lia.
Qed.
