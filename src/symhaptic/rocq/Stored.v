(* A device with a store of energy: what is stored at rest is nothing, so that it does not matter to passivity;
   Colgate and Schenkel, J. Robot. Syst. 14(1), 1997, Sec. 3. *)
From Symhaptic Require Export Energy.
Open Scope R_scope.

(* -- a device that stores energy ------------------------------------------------------------------ *)

(* The speed of a mass is continuous; the hand does no negative work against the store E of the speed at the end. *)
Definition passive_device (E : C -> C) (K B b T d : R) : Prop :=
  forall v, (forall t, continuous v t) -> v 0 = 0 -> forall e n, 0 <= e <= (INR n + d) * T ->
    0 <= Re (E (RtoC (v e))) + work K B b T d v e n.

(* A continuous speed that leads by p from a to q, begins and ends at 0, and burns little more than a constant one. *)
Definition smooth (N : nat) (a q p t : R) : R :=
  p / (q - a) * ((2 * INR N + 1) / (2 * INR N)) * Rmax 0 (1 - ((2 * t - a - q) / (q - a)) ^ (2 * N)).
Lemma slope_minus : forall (f g : R -> R) x (l m : R), is_derive f x l -> is_derive g x m ->
  is_derive (fun t => f t - g t) x (l - m).
Proof. intros f g x l m F G; exact (is_derive_minus f g x l m F G). Qed.
Lemma slope_plus : forall (f g : R -> R) x (l m : R), is_derive f x l -> is_derive g x m ->
  is_derive (fun t => f t + g t) x (l + m).
Proof. intros f g x l m F G; exact (is_derive_plus f g x l m F G). Qed.
Lemma slope_itself : forall x : R, is_derive (fun t : R => t) x 1.
Proof. intro x; auto_derive; [exact I | reflexivity]. Qed.
Lemma power_slope : forall a q M M1 x, a < q -> M1 = S M ->
  is_derive (fun t => (q - a) / 2 * (((2 * t - a - q) / (q - a)) ^ M1 / INR M1)) x (((2 * x - a - q) / (q - a)) ^ M).
Proof.
  intros a q M M1 x L E; assert (0 < INR M1) by (subst; apply lt_0_INR; lia).
  auto_derive; [exact I |]; replace (Nat.pred M1) with M by lia.
  unfold Rdiv; unfold Rminus; generalize (((2 * x + - a + - q) * / (q + - a)) ^ M); intro y; field; lra.
Qed.
Section Smooth.
Variables (N : nat) (a q p : R).
Hypotheses (N0 : (0 < N)%nat) (L : a < q).
Lemma even_power : forall x : R, x ^ (2 * N) = (x ^ 2) ^ N.
Proof. intro x; rewrite pow_mult; reflexivity. Qed.
Lemma smooth_outside : forall t, t <= a \/ q <= t -> smooth N a q p t = 0.
Proof.
  intros t T; unfold smooth; rewrite Rmax_left, Rmult_0_r; [reflexivity |].
  rewrite even_power; set (y := (2 * t - a - q) / (q - a)); assert (Y : 1 <= y ^ 2).
  { assert (D : y * (q - a) = 2 * t - a - q) by (unfold y; field; lra).
    destruct T as [T | T]; [assert (y <= -1) | assert (1 <= y)]; try nra;
      (apply Rnot_lt_le; intro; nra). }
  assert (1 <= (y ^ 2) ^ N) by (apply pow_R1_Rle; exact Y); lra.
Qed.
Lemma smooth_inside : forall t, a <= t <= q ->
  smooth N a q p t = p / (q - a) * ((2 * INR N + 1) / (2 * INR N)) * (1 - ((2 * t - a - q) / (q - a)) ^ (2 * N)).
Proof.
  intros t T; unfold smooth; rewrite Rmax_right; [reflexivity |].
  rewrite even_power; set (y := (2 * t - a - q) / (q - a)); assert (Y : y ^ 2 <= 1).
  { assert (D : y * (q - a) = 2 * t - a - q) by (unfold y; field; lra).
    assert (-1 <= y <= 1) by (split; apply Rnot_lt_le; intro; nra); nra. }
  assert ((y ^ 2) ^ N <= 1 ^ N) by (apply pow_incr; split; [apply pow2_ge_0 | exact Y]); rewrite pow1 in *; lra.
Qed.
Lemma smooth_continuous : forall t, continuous (smooth N a q p) t.
Proof.
  intro t; unfold smooth; apply (continuous_mult (K := R_AbsRing) (fun _ => _)); [apply continuous_const |].
  apply (continuous_ext (fun t => (1 - ((2 * t - a - q) / (q - a)) ^ (2 * N) +
    Rabs (1 - ((2 * t - a - q) / (q - a)) ^ (2 * N))) / 2)).
  - intro x; unfold Rmax, Rabs; destruct (Rle_dec 0 _), (Rcase_abs _); lra.
  - apply (continuous_mult (K := R_AbsRing) _ (fun _ => / 2)); [| apply continuous_const].
    assert (P : continuous (fun t => 1 - ((2 * t - a - q) / (q - a)) ^ (2 * N)) t).
    { apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; exact I. }
    apply (continuous_plus (V := R_NormedModule)); [exact P | apply continuous_comp;
      [exact P | apply continuous_Rabs]].
Qed.
Lemma smooth_way : is_RInt (smooth N a q p) a q p.
Proof.
  assert (Np := lt_0_INR N N0).
  apply (is_RInt_ext (fun t => p / (q - a) * ((2 * INR N +
    1) / (2 * INR N)) * (1 - ((2 * t - a - q) / (q - a)) ^ (2 * N)))).
  { intros x X; rewrite Rmin_left, Rmax_right in X by lra; symmetry; apply smooth_inside; lra. }
  remember (S (2 * N)) as M1 eqn:E1; assert (I1 : INR M1 = 2 * INR N + 1) by (subst M1; rewrite S_INR, mult_INR;
    simpl; ring).
  set (c := p / (q - a) * ((2 * INR N + 1) / (2 * INR N))).
  set (F := fun t => c * (t - (q - a) / 2 * (((2 * t - a - q) / (q - a)) ^ M1 / INR M1))).
  evar_last; [apply (is_RInt_derive F (fun t => c * (1 - ((2 * t - a - q) / (q - a)) ^ (2 * N)))) |].
  - intros x _; unfold F; apply is_derive_scal; apply (slope_minus (fun t => t));
      [apply slope_itself | apply power_slope; assumption].
  - intros x _; apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; exact I.
  - unfold F, minus, plus, opp; simpl Rplus; replace ((2 * q - a - q) / (q - a)) with 1 by (field; lra).
    replace ((2 * a - a - q) / (q - a)) with (-1) by (field; lra).
    rewrite pow1, E1, <- tech_pow_Rmult, even_power; replace ((-1) ^ 2) with 1 by ring; rewrite pow1, <- E1, I1;
      unfold c; simpl; field; repeat split; shown_here; lra.
Qed.
Lemma smooth_burnt : is_RInt (fun t => smooth N a q p t ^ 2) a q (p ^ 2 / (q - a) * (1 + / (4 * INR N + 1))).
Proof.
  assert (Np := lt_0_INR N N0).
  apply (is_RInt_ext (fun t => (p / (q - a) * ((2 * INR N +
    1) / (2 * INR N)) * (1 - ((2 * t - a - q) / (q - a)) ^ (2 * N))) ^ 2)).
  { intros x X; rewrite Rmin_left, Rmax_right in X by lra; rewrite smooth_inside by lra; reflexivity. }
  remember (S (2 * N)) as M1 eqn:E1; assert (I1 : INR M1 = 2 * INR N + 1) by (subst M1; rewrite S_INR, mult_INR;
    simpl; ring).
  remember (S (2 * (2 * N))) as M2 eqn:E2; assert (I2 : INR M2 = 4 * INR N + 1) by (subst M2;
    rewrite S_INR, !mult_INR; simpl; ring).
  set (c := (p / (q - a) * ((2 * INR N + 1) / (2 * INR N))) ^ 2).
  set (F := fun t => c * ((t - 2 * ((q - a) / 2 * (((2 * t - a - q) / (q - a)) ^ M1 / INR M1)))
     + (q - a) / 2 * (((2 * t - a - q) / (q - a)) ^ M2 / INR M2))).
  apply (is_RInt_ext (fun t => c * ((1 - 2 * ((2 * t - a - q) / (q - a)) ^ (2 * N)) +
    ((2 * t - a - q) / (q - a)) ^ (2 * (2 * N))))).
  { intros x _; rewrite (Nat.mul_comm 2 (2 * N)), (pow_mult _ (2 * N) 2); unfold c;
      match goal with |- ?x = ?y => change (x = y :> R) end; ring. }
  evar_last; [apply (is_RInt_derive F (fun t => c * ((1 - 2 * ((2 * t - a - q) / (q - a)) ^ (2 * N)) +
    ((2 * t - a - q) / (q - a)) ^ (2 * (2 * N))))) |].
  - intros x _; unfold F; apply is_derive_scal; apply slope_plus; [| apply power_slope; assumption].
    apply (slope_minus (fun t => t)); [apply slope_itself | apply is_derive_scal, power_slope; assumption].
  - intros x _; apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; exact I.
  - unfold F, minus, plus, opp; simpl Rplus; replace ((2 * q - a - q) / (q - a)) with 1 by (field; lra).
    replace ((2 * a - a - q) / (q - a)) with (-1) by (field; lra).
    rewrite !pow1, E1, E2, <- !tech_pow_Rmult, !(pow_mult (-1) 2); replace ((-1) ^ 2) with 1 by ring;
      rewrite !pow1, <- E1, <- E2, I1, I2; unfold c; simpl; field; repeat split; shown_here; lra.
Qed.
End Smooth.

(* Times in their order. *)
Fixpoint ascending (a : R) (l : list R) : Prop := match l with nil => True | b :: l => a <= b /\ ascending b l end.
Fixpoint final (a : R) (l : list R) : R := match l with nil => a | b :: l => final b l end.
Fixpoint insert (x : R) (l : list R) : list R :=
  match l with nil => x :: nil | y :: m => if Rle_dec x y then x :: l else y :: insert x m end.
Lemma insert_ascending : forall l a x, ascending a l -> a <= x -> ascending a (insert x l).
Proof.
  induction l as [| y l IH]; intros a x A X; simpl; [split; auto |]; destruct A as [Y A], (Rle_dec x y) as [L | L];
    simpl; auto.
  split; [exact Y | apply IH; [exact A | lra]].
Qed.
Lemma insert_in : forall l x y, In y (insert x l) <-> y = x \/ In y l.
Proof. induction l as [| z l IH]; intros x y; simpl; [intuition |]; destruct (Rle_dec x z); simpl; rewrite ?IH;
  intuition. Qed.
Lemma in_order : forall a L, (forall x, In x L -> a <= x) -> exists l, ascending a l /\ forall x, In x l <-> In x L.
Proof.
  intros a L; induction L as [| x L IH]; intro B; [exists nil; simpl; tauto |].
  destruct IH as (l & A & I); [intros; apply B; simpl; auto |]; exists (insert x l).
  split; [apply insert_ascending; [exact A | apply B; simpl; auto] |]; intro y; rewrite insert_in, I; simpl;
    intuition.
Qed.
Lemma final_above : forall l a x, ascending a l -> In x (a :: l) -> a <= x <= final a l.
Proof.
  induction l as [| b l IH]; intros a x A X; simpl in *; [destruct X as [X | []]; subst; lra |].
  destruct A as [L A]; assert (B := IH b b A (or_introl eq_refl)); destruct X as [X | X]; [subst; lra |].
  generalize (IH b x A X); lra.
Qed.
Lemma final_in : forall l a, In (final a l) (a :: l).
Proof. induction l as [| b l IH]; intro a; [left; reflexivity | right; exact (IH b)]. Qed.

(* A continuous speed with the same places at some times, at rest at all of them. *)
Lemma smooth_path : forall N v, (0 < N)%nat -> speed v -> forall l a, ascending a l -> 0 <= a -> exists w B,
  (forall t, continuous w t) /\ (forall t, t <= a -> w t = 0) /\ (forall t, final a l <= t -> w t = 0) /\
  (forall x, In x (a :: l) -> is_RInt w a x (position v x - position v a)) /\
  is_RInt (fun t => w t ^ 2) a (final a l) B /\ B <= (1 + / (4 * INR N + 1)) * (burnt v (final a l) - burnt v a).
Proof.
  intros N v N0 V l; induction l as [| b l IH]; intros a A P.
  - exists (fun _ => 0), 0; simpl; repeat split; auto.
    + intro t; apply continuous_const.
    + intros x [X | []]; subst x; replace (position v a - position v a) with (@zero R_NormedModule) by (unfold zero;
        simpl; ring).
      apply (is_RInt_point (V := R_NormedModule)).
    + apply (is_RInt_point (V := R_NormedModule)).
    + replace (burnt v a - burnt v a) with 0 by ring; lra.
  - destruct A as [[L | L] A]; [| subst b].
    2: { destruct (IH a A P) as (w & B & C & Bef & Aft & Pos & Q & U); exists w, B; repeat split; auto.
         intros x [X | X]; apply Pos; [left; exact X | exact X]. }
    destruct (IH b A ltac:(lra)) as (w & B & C & Bef & Aft & Pos & Q & U).
    set (p := position v b - position v a); set (s := smooth N a b p).
    assert (So : forall t, t <= a \/ b <= t -> s t = 0) by (apply smooth_outside; assumption).
    assert (Fb : b <= final b l) by apply (final_above l b b A (or_introl eq_refl)).
    exists (fun t => s t + w t), (p ^ 2 / (b - a) * (1 + / (4 * INR N + 1)) + B); cbn [final]; repeat split.
    + intro t; apply (continuous_plus (V := R_NormedModule)); [apply smooth_continuous; assumption | apply C].
    + intros t T; rewrite So, Bef by lra; apply Rplus_0_l.
    + intros t T; rewrite So, Aft by lra; apply Rplus_0_l.
    + intros x [X | X].
      * subst x; replace (position v a - position v a) with (@zero R_NormedModule) by (unfold zero; simpl; ring).
        apply (is_RInt_point (V := R_NormedModule)).
      * assert (Xb : b <= x) by apply (final_above l b x A X).
        replace (position v x - position v a) with (plus p (position v x - position v b)) by (unfold plus; simpl;
          unfold p; match goal with |- ?x = ?y => change (x = y :> R) end; ring).
        apply (is_RInt_Chasles (V := R_NormedModule)) with b.
        -- apply (is_RInt_ext s); [| apply smooth_way; assumption].
           intros t T; rewrite Rmin_left, Rmax_right in T by lra; rewrite Bef by lra; symmetry; apply Rplus_0_r.
        -- apply (is_RInt_ext w); [| apply Pos, X].
           intros t T; rewrite Rmin_left, Rmax_right in T by lra; rewrite So by lra; symmetry; apply Rplus_0_l.
    + apply (is_RInt_Chasles (V := R_NormedModule)) with b.
      * apply (is_RInt_ext (fun t => s t ^ 2)); [| apply smooth_burnt; assumption].
        intros t T; rewrite Rmin_left, Rmax_right in T by lra; rewrite Bef by lra; f_equal; symmetry; apply Rplus_0_r.
      * apply (is_RInt_ext (fun t => w t ^ 2)); [| exact Q].
        intros t T; rewrite Rmin_left, Rmax_right in T by lra; rewrite So by lra; f_equal; symmetry; apply Rplus_0_l.
    + assert (St := burnt_step v a b V ltac:(lra)); fold p in St; assert (Np := lt_0_INR N N0).
      assert (0 < / (4 * INR N + 1)) by (apply Rinv_0_lt_compat; lra).
      assert (p ^ 2 / (b - a) * (1 + / (4 * INR N + 1)) <= (burnt v b - burnt v a) * (1 + / (4 * INR N + 1)))
        by (apply Rmult_le_compat_r; lra).
      lra.
Qed.
Theorem stored : forall (E : C -> C) (K B b T d : R), 0 < T -> 0 <= d -> (forall x : R, 0 <= Re (E (RtoC x))) ->
  Re (E (RtoC 0)) = 0 ->
  (passive_device E K B b T d <-> passive_wall K B b T d).
Proof.
  intros E K B b T d Tp Dp Some None; split.
  - intro P; assert (b0 : 0 <= b).
    { apply Rnot_lt_le; intro Neg; set (w := fun t => t * (T - t)).
      assert (Cw : forall t, continuous w t) by (intro t; apply (ex_derive_continuous (V := R_NormedModule));
        unfold w; auto_derive; exact I).
      specialize (P w Cw (Rmult_0_l (T - 0)) T 1%nat ltac:(simpl; split; [lra | nra])); unfold w in P at 1.
      replace (T * (T - T)) with 0 in P by ring; rewrite None in P; unfold work in P; cbn [total] in P.
      unfold wall_force in P; cbn [Init.Nat.pred] in P; simpl (INR 0) in P; rewrite Rmult_0_l, position_start in P.
      assert (Bw : burnt w T = T ^ 5 / 30).
      { unfold burnt; apply is_RInt_unique; unfold w.
        apply (is_RInt_ext (fun t => t ^ 2 * T ^ 2 - 2 * T * t ^ 3 + t ^ 4)); [intros;
          match goal with |- ?x = ?y => change (x = y :> R) end; ring |].
        evar_last; [apply (is_RInt_derive (fun t => t ^ 3 / 3 * T ^ 2 - 2 * T * (t ^ 4 / 4) + t ^ 5 / 5)) |].
        - intros x _; auto_derive; [exact I | field].
        - intros x _; apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; exact I.
        - unfold minus, plus, opp; simpl; field. }
      rewrite Bw in P; assert (0 < T ^ 5) by (apply pow_lt, Tp).
      replace (K * 0 + B * (0 - 0) / T) with 0 in P by (unfold Rdiv; ring); nra. }
    intros v V e n [E0 En].
    set (times := e :: flat_map (fun k => Rmin e (INR k * T) :: Rmin e ((INR k + d) * T) :: nil) (seq 0 (S (S n)))).
    assert (Pos : forall k, 0 <= Rmin e (INR k * T) /\ 0 <= Rmin e ((INR k + d) * T)).
    { intro k; assert (Pk := pos_INR k); split; apply Rmin_glb; try exact E0; apply Rmult_le_pos; lra. }
    assert (Has : forall k, (k <= S n)%nat -> In (Rmin e (INR k * T)) times /\ In (Rmin e ((INR k + d) * T)) times).
    { intros k Kn; unfold times; split; right; apply in_flat_map; exists k; (split; [apply in_seq; lia | simpl;
        auto]). }
    assert (Low : forall x, In x times -> 0 <= x <= e).
    { intros x [X | X]; [lra |]; apply in_flat_map in X; destruct X as (k & _ & [X | [X | []]]); subst x;
        (split; [apply Pos | apply Rmin_l]). }
    destruct (in_order 0 times (fun x X => proj1 (Low x X))) as (l & A & I).
    assert (Fe : final 0 l = e).
    { apply Rle_antisym.
      - destruct (final_in l 0) as [F | F]; [rewrite <- F; exact E0 | apply Low, I, F].
      - apply (final_above l 0 e A); right; apply I; left; reflexivity. }
    apply Rnot_lt_le; intro Neg.
    assert (Small : exists N, (0 < N)%nat /\ b * burnt v e * / (4 * INR N + 1) < - work K B b T d v e n).
    { destruct (nfloor_ex (Rabs (b * burnt v e) / - work K B b T d v e n + 1)) as [N Nf].
      { assert (0 <= Rabs (b * burnt v e) / - work K B b T d v e n) by (apply Rdiv_le_0_compat;
          [apply Rabs_pos | lra]); lra. }
      assert (Q : 0 <= Rabs (b * burnt v e) / - work K B b T d v e n) by (apply Rdiv_le_0_compat;
        [apply Rabs_pos | lra]).
      exists (S N); split; [lia |]; rewrite S_INR; apply Rmult_lt_reg_r with (4 * (INR N + 1) + 1);
        [generalize (pos_INR N); lra |].
      rewrite Rmult_assoc, Rinv_l, Rmult_1_r by (generalize (pos_INR N); lra).
      apply Rle_lt_trans with (1 := Rle_abs _); apply Rmult_lt_reg_r with (/ - work K B b T d v e n);
        [apply Rinv_0_lt_compat; lra |].
      replace (- work K B b T d v e n * (4 * (INR N + 1) + 1) * / - work K B b T d v e n) with (4 * (INR N + 1) +
        1) by (field; lra).
      fold (Rabs (b * burnt v e) / - work K B b T d v e n); generalize (pos_INR N); lra. }
    destruct Small as (N & N0 & Small).
    destruct (smooth_path N v N0 V l 0 A (Rle_refl 0)) as (w & Bw & C & Bef & Aft & Way & Q & U); rewrite Fe in *.
    rewrite position_start, burnt_start in *; rewrite !Rminus_0_r in *.
    assert (At : forall x, In x times -> position w x = position v x).
    { intros x X; unfold position at 1; apply is_RInt_unique; assert (Y := Way x (or_intror (proj2 (I x) X)));
        rewrite Rminus_0_r in Y; exact Y. }
    specialize (P w C (Bef 0 (Rle_refl 0)) e n (conj E0 En)); rewrite (Aft e (Rle_refl e)), None, Rplus_0_l in P.
    assert (W : work K B b T d w e n = b * Bw + (work K B b T d v e n - b * burnt v e)).
    { unfold work; replace (burnt w e) with Bw by (symmetry; apply is_RInt_unique, Q).
      match goal with |- _ + ?x = _ + (_ + ?y - _) => replace x with y; [ring |] end.
      apply total_alike; intros k Kn; replace ((INR k + 1 + d) * T) with ((INR (S k) + d) * T) by (rewrite S_INR;
        ring).
      rewrite !At by (apply Has; lia); destruct (Rle_dec e (INR k * T)) as [L | L].
      - assert (Pk := pos_INR k); rewrite !Rmin_left by (rewrite ?S_INR; nra); ring.
      - assert (Z : forall i, (i <= k)%nat -> position w (INR i * T) = position v (INR i * T)).
        { intros i Ik; assert (Ri : Rmin e (INR i * T) = INR i * T) by (apply Rmin_right; apply le_INR in Ik; nra).
          rewrite <- Ri; apply At, Has; lia. }
        unfold wall_force; rewrite !Z by lia; reflexivity. }
    rewrite W in P; assert (b * Bw <= b * ((1 + / (4 * INR N + 1)) * burnt v e)) by (apply Rmult_le_compat_l;
      assumption); lra.
  - intros P v Cv V0 e n En; apply Rplus_le_le_0_compat; [apply Some | apply P; [| exact En]].
    intros t T0; split; apply (ex_RInt_continuous (V := R_CompleteNormedModule)); intros x _; [apply Cv |].
    apply (continuous_ext (fun s => v s * v s)); [intro; simpl; ring | apply (continuous_mult (K := R_AbsRing));
      apply Cv].
Qed.
