(* What is positive on a box, by the pieces of a certificate: Rocq evaluates each of them with the
   intervals of coq-interval, over primitive floats; that what it finds holds is proved once here. *)
From Symhaptic Require Export Control.
From Coq Require Export String.
From Coq Require Import Ascii.
From Interval Require Import Xreal Interval Primitive_ops Specific_bigint Specific_ops Float_full Tree Prog Eval Reify.
Import List Tree.
Open Scope list_scope.
Open Scope R_scope.

(* -- values ------------------------------------------------------------------------- *)

(* Terms over intervals whose ends are floats of any kind. *)
Module Values (F : Sig.FloatOps with Definition sensible_format := true).
Module Ball := FloatIntervalFull F.
Module Balls := IntervalAlgos Ball.
Module J := Balls.J.
Notation ball := Ball.type.
Definition has (X : ball) (x : R) : Prop := contains (Ball.convert X) (Xreal x).

Section Precise.
Variable prec : F.precision.
Definition ops := Balls.BndValuator.operations prec.
Definition nullary_of (o : nullary_op) : ball :=
  match o with Tree.Int n => Ball.fromZ prec n | Tree.Pi => Ball.pi prec | Tree.Bpow _ _ => Ball.nai end.
Fixpoint value_of (e : expr) (of : list ball) : ball :=
  match e with
  | Evar n => nth n of Ball.nai
  | Econst o => nullary_of o
  | Eunary o a => unary ops o (value_of a of)
  | Ebinary o a b => binary ops o (value_of a of) (value_of b of)
  end.

Lemma has_nai : forall x, has Ball.nai x.
Proof. intro x; apply J.nai_correct. Qed.
Lemma has_nullary : forall o, has (nullary_of o) (nullary_real o).
Proof.
  intros [n | r n |]; [apply Ball.fromZ_correct | apply has_nai | apply Ball.pi_correct].
Qed.
Lemma all_of : forall (L : list ball) (l : list R), Forall2 has L l -> Balls.contains_all L l.
Proof.
  intros L l F; induction F as [| X x L l P F IH].
  - split; [reflexivity | intros [|]; apply J.nai_correct].
  - apply Balls.contains_all_cons; assumption.
Qed.
Lemma has_unary : forall o X x, has X x -> has (unary ops o X) (unary_real o x).
Proof.
  intros o X x P.
  apply (Balls.BndValuator.eval_correct' prec (Unary o 0 :: nil) (X :: nil) (x :: nil) (all_of (X :: nil) (x :: nil) ltac:(repeat constructor; exact P)) 0).
Qed.
Lemma has_binary : forall o X x Y y, has X x -> has Y y -> has (binary ops o X Y) (binary_real o x y).
Proof.
  intros o X x Y y P Q.
  apply (Balls.BndValuator.eval_correct' prec (Binary o 0 1 :: nil) (X :: Y :: nil) (x :: y :: nil)
    (all_of (X :: Y :: nil) (x :: y :: nil) ltac:(repeat constructor; assumption)) 0).
Qed.
Lemma has_nth : forall L l n, Forall2 has L l -> has (nth n L Ball.nai) (nth n l 0).
Proof.
  intros L l n F; revert n; induction F; intros [| n]; simpl; auto; apply has_nai.
Qed.
Lemma has_value : forall e L l, (forall n, has (nth n L Ball.nai) (nth n l 0)) ->
  has (value_of e L) (eval e l).
Proof.
  intros e L l F; induction e; simpl.
  - apply F.
  - apply has_nullary.
  - apply has_unary; assumption.
  - apply has_binary; assumption.
Qed.
End Precise.
End Values.

(* -- boxes of plants ------------------------------------------------------------------ *)

(* The way under a unit force that is held, from rest: y'' + d y' + g y = 1.  Its power series in
   time; the pair has the coefficients of t^(k+1) and t^(k+2). *)
Fixpoint ways (g d : R) (k : nat) : R * R :=
  match k with
  | O => (0, 1 / 2)
  | S m =>
      let (p, q) := ways g d m in
      (q, - (d * q / INR (m + 3) + g * p / (INR (m + 3) * INR (m + 2))))
  end.
Definition held (g d x : R) : Prop := is_series (fun k => snd (ways g d k)) x.

Lemma ways_next : forall g d k,
  snd (ways g d (S (S k))) =
  - (d * snd (ways g d (S k)) / INR (k + 4) + g * snd (ways g d k) / (INR (k + 4) * INR (k + 3))).
Proof.
  intros g d k; cbn [ways]; destruct (ways g d k) as [p q]; cbn [snd].
  replace (S k + 3)%nat with (k + 4)%nat by lia; replace (S k + 2)%nat with (k + 3)%nat by lia.
  reflexivity.
Qed.

(* The coefficients of the powers of the time, and that they fall as those of an exponential. *)
Definition taylor (g d : R) (n : nat) : R := match n with S (S k) => snd (ways g d k) | _ => 0 end.
Lemma taylor_next : forall g d n, INR (n + 2) * INR (n + 1) * taylor g d (S (S n)) + d * (INR (n + 1) * taylor g d (S n)) + g * taylor g d n =
  match n with O => 1 | _ => 0 end.
Proof.
  intros g d [| [| n]]; [simpl; field | simpl; field |].
  change (taylor g d (S (S (S (S n))))) with (snd (ways g d (S (S n)))); change (taylor g d (S (S (S n)))) with (snd (ways g d (S n))).
  change (taylor g d (S (S n))) with (snd (ways g d n)); rewrite ways_next.
  replace (S (S n) + 2)%nat with (n + 4)%nat by lia; replace (S (S n) + 1)%nat with (n + 3)%nat by lia.
  assert (INR (n + 4) <> 0) by (apply not_0_INR; lia); assert (INR (n + 3) <> 0) by (apply not_0_INR; lia); field; split; assumption.
Qed.
Lemma taylor_falls : forall g d n, Rabs (taylor g d n) <= (1 + Rabs d + Rabs g) ^ n / INR (fact n).
Proof.
  intros g d; set (k := 1 + Rabs d + Rabs g); assert (K : 1 <= k) by (unfold k; generalize (Rabs_pos d) (Rabs_pos g); lra).
  assert (B : forall n, Rabs (taylor g d n) * INR (fact n) <= k ^ n /\ Rabs (taylor g d (S n)) * INR (fact (S n)) <= k ^ S n).
  { induction n as [| n [A B]].
    - simpl; rewrite Rabs_R0; split; lra.
    - split; [exact B |]; assert (T := taylor_next g d n).
      assert (P1 : 0 < INR (n + 1)) by (apply lt_0_INR; lia); assert (P2 : 0 < INR (n + 2)) by (apply lt_0_INR; lia).
      assert (Pf : 0 < INR (fact n)) by apply INR_fact_lt_0.
      replace (INR (fact (S (S n)))) with (INR (n + 2) * INR (n + 1) * INR (fact n)).
      2: { rewrite !fact_simpl, !mult_INR; replace (S (S n)) with (n + 2)%nat by lia; replace (S n) with (n + 1)%nat by lia; ring. }
      replace (Rabs (taylor g d (S (S n))) * (INR (n + 2) * INR (n + 1) * INR (fact n))) with
        (Rabs (INR (n + 2) * INR (n + 1) * taylor g d (S (S n))) * INR (fact n)).
      2: { rewrite !Rabs_mult, (Rabs_pos_eq (INR (n + 2))), (Rabs_pos_eq (INR (n + 1))) by lra; ring. }
      rewrite fact_simpl, mult_INR in B; replace (S n) with (n + 1)%nat in B by lia.
      set (u := match n with O => 1 | _ => 0 end) in T.
      replace (INR (n + 2) * INR (n + 1) * taylor g d (S (S n))) with (u - d * (INR (n + 1) * taylor g d (S n)) - g * taylor g d n) by lra.
      assert (U : Rabs u * INR (fact n) <= k ^ S n).
      { unfold u; destruct n; [simpl; rewrite Rabs_R1; lra | rewrite Rabs_R0, Rmult_0_l; apply pow_le; lra]. }
      assert (Tr : Rabs (u - d * (INR (n + 1) * taylor g d (S n)) - g * taylor g d n) <=
        Rabs u + Rabs d * (INR (n + 1) * Rabs (taylor g d (S n))) + Rabs g * Rabs (taylor g d n)).
      { unfold Rminus; eapply Rle_trans; [apply Rabs_triang | apply Rplus_le_compat].
        - eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat_l; rewrite Rabs_Ropp, !Rabs_mult, (Rabs_pos_eq (INR (n + 1))) by lra; lra.
        - rewrite Rabs_Ropp, Rabs_mult; lra. }
      apply Rle_trans with ((Rabs u + Rabs d * (INR (n + 1) * Rabs (taylor g d (S n))) + Rabs g * Rabs (taylor g d n)) * INR (fact n)).
      { apply Rmult_le_compat_r; [lra | exact Tr]. }
      assert (Kn : k ^ n <= k ^ S n) by (simpl; assert (0 < k ^ n) by (apply pow_lt; lra); nra).
      replace (n + 1)%nat with (S n) in * by lia.
      assert (Q1 : Rabs d * (INR (S n) * Rabs (taylor g d (S n)) * INR (fact n)) <= Rabs d * k ^ S n).
      { apply Rmult_le_compat_l; [apply Rabs_pos |]; eapply Rle_trans; [apply Req_le | exact B]; ring. }
      assert (Q2 : Rabs g * (Rabs (taylor g d n) * INR (fact n)) <= Rabs g * k ^ S n).
      { apply Rmult_le_compat_l; [apply Rabs_pos | lra]. }
      assert (Sum : (Rabs u + Rabs d * (INR (S n) * Rabs (taylor g d (S n))) + Rabs g * Rabs (taylor g d n)) * INR (fact n) =
        Rabs u * INR (fact n) + Rabs d * (INR (S n) * Rabs (taylor g d (S n)) * INR (fact n)) + Rabs g * (Rabs (taylor g d n) * INR (fact n))) by ring.
      rewrite Sum; apply Rle_trans with (k ^ S n + Rabs d * k ^ S n + Rabs g * k ^ S n); [lra |].
      change (k ^ S (S n)) with (k * k ^ S n); replace (k * k ^ S n) with ((1 + Rabs d + Rabs g) * k ^ S n) by reflexivity; lra. }
  intro n; assert (P : 0 < INR (fact n)) by apply INR_fact_lt_0; apply Rle_div_r; [exact P | apply B].
Qed.
Lemma below_exp : forall z n, 0 <= z -> z ^ n / INR (fact n) <= exp z.
Proof.
  intros z n Z; assert (P : forall k, 0 <= z ^ k * / INR (fact k)).
  { intro k; apply Rmult_le_pos; [apply pow_le, Z | apply Rlt_le, Rinv_0_lt_compat, INR_fact_lt_0]. }
  assert (E := is_exp_Reals z); apply is_pseries_R in E.
  assert (I : forall m, sum_n (fun k => / INR (fact k) * z ^ k) m <= sum_n (fun k => / INR (fact k) * z ^ k) (S m)).
  { intro m; rewrite sum_Sn; change plus with Rplus; generalize (P (S m)); rewrite Rmult_comm; lra. }
  assert (L := is_lim_seq_incr_compare _ (exp z) E I n); eapply Rle_trans; [| exact L].
  destruct n as [| n]; [rewrite sum_O; simpl; lra |].
  rewrite sum_Sn; assert (0 <= sum_n (fun k => / INR (fact k) * z ^ k) n).
  { clear - P; induction n as [| n IH]; [rewrite sum_O; rewrite Rmult_comm; apply P |].
    rewrite sum_Sn; change plus with Rplus; apply Rplus_le_le_0_compat; [exact IH | rewrite Rmult_comm; apply P]. }
  eapply Rle_trans; [| apply Rplus_le_compat_r; exact H]; unfold Rdiv; apply Req_le; ring.
Qed.
Lemma taylor_converges : forall g d, CV_radius (taylor g d) = p_infty.
Proof.
  intros g d; set (k := 1 + Rabs d + Rabs g); assert (K : 1 <= k) by (unfold k; generalize (Rabs_pos d) (Rabs_pos g); lra).
  assert (L : forall r : R, 0 <= r -> Rbar_le r (CV_radius (taylor g d))).
  { intros r R0; destruct (CV_radius_bounded (taylor g d)) as [U _]; apply U.
    exists (exp (k * r)); intro n; rewrite Rabs_mult, (Rabs_pos_eq (r ^ n)) by (apply pow_le, R0).
    apply Rle_trans with ((k * r) ^ n / INR (fact n)); [| apply below_exp, Rmult_le_pos; lra].
    rewrite Rpow_mult_distr; unfold Rdiv; rewrite (Rmult_comm (k ^ n)), Rmult_assoc, (Rmult_comm (r ^ n)).
    apply Rmult_le_compat_r; [apply pow_le, R0 | apply taylor_falls]. }
  destruct (CV_radius (taylor g d)) as [r | |]; [exfalso | reflexivity | exfalso; exact (L 0 (Rle_refl 0))].
  assert (A := L (Rabs r + 1) ltac:(generalize (Rabs_pos r); lra)); simpl in A; generalize (Rle_abs r); lra.
Qed.
Lemma no_series : is_series (fun _ : nat => 0) 0.
Proof. apply (filterlim_ext (fun _ => 0)); [intro n; rewrite sum_n_const; ring | apply filterlim_const]. Qed.
(* The sum of the series in time is the motion under a unit force. *)
Lemma series_moves : forall g d, moves g d 1 (PSeries (taylor g d)) (PSeries (PS_derive (taylor g d))).
Proof.
  intros g d t; set (a := taylor g d); assert (R0 : CV_radius a = p_infty) by apply taylor_converges.
  assert (R1 : CV_radius (PS_derive a) = p_infty) by (rewrite CV_radius_derive; exact R0).
  split; [apply is_derive_PSeries; rewrite R0; exact I |].
  evar_last; [apply is_derive_PSeries; rewrite R1; exact I |].
  assert (C : forall b, CV_radius b = p_infty -> ex_pseries b t) by (intros b B; apply CV_radius_inside; rewrite B; exact I).
  assert (E : PSeries (PS_derive (PS_derive a)) t + d * PSeries (PS_derive a) t + g * PSeries a t = 1).
  { assert (C2 : CV_radius (PS_derive (PS_derive a)) = p_infty) by (rewrite CV_radius_derive; exact R1).
    assert (S0 := PSeries_correct _ _ (C _ R0)); assert (S1 := PSeries_correct _ _ (C _ R1)); assert (S2 := PSeries_correct _ _ (C _ C2)).
    assert (T1 := is_pseries_scal d _ t _ (Rmult_comm _ _) S1); assert (T0 := is_pseries_scal g _ t _ (Rmult_comm _ _) S0).
    assert (T := is_pseries_plus _ _ t _ _ (is_pseries_plus _ _ t _ _ S2 T1) T0).
    apply (is_pseries_ext _ (fun n => match n with O => 1 | _ => 0 end)) in T.
    - assert (One : is_pseries (fun n => match n with O => 1 | _ => 0 end) t 1).
      { apply is_pseries_R, is_series_decr_1.
        evar_last; [apply (is_series_ext (fun _ => 0)); [intro n; change (0 = 0 * t ^ S n); ring | apply no_series] |].
        unfold plus, opp; simpl; ring. }
      apply is_pseries_unique in T; apply is_pseries_unique in One; rewrite One in T; symmetry; exact T.
    - intro n; transitivity (INR (n + 2) * INR (n + 1) * taylor g d (S (S n)) + d * (INR (n + 1) * taylor g d (S n)) + g * taylor g d n); [| apply taylor_next]; unfold PS_plus, PS_scal, PS_derive.
      change plus with Rplus; change scal with Rmult; fold a; replace (n + 2)%nat with (S (S n)) by lia; replace (n + 1)%nat with (S n) by lia.
      rewrite !S_INR; match goal with |- ?x = ?y => change (@eq R x y) end; ring. }
  lra.
Qed.

Theorem on_plants : forall g d n1 n0 a e : R, device g d n1 n0 a e ->
  held g d n1 /\ held g (- d) (n0 / exp (- d)) /\ e = exp (- d) /\ 1 - a + e = g * (n1 + n0).
Proof.
  intros g d n1 n0 a e V; assert (Start : forall k, PSeries (taylor g k) 0 = 0 /\ PSeries (PS_derive (taylor g k)) 0 = 0).
  { intro k; rewrite !PSeries_0; unfold PS_derive; simpl; split; ring. }
  assert (Sum : forall k, held g k (PSeries (taylor g k) 1)).
  { intro k; unfold held; assert (R0 : CV_radius (taylor g k) = p_infty) by apply taylor_converges.
    assert (P := PSeries_correct (taylor g k) 1 ltac:(apply CV_radius_inside; rewrite R0; exact I)); apply is_pseries_R in P.
    apply (is_series_ext _ (taylor g k)) in P; [| intro n; rewrite pow1; apply Rmult_1_r].
    apply (is_series_incr_n (taylor g k) 2); [lia |].
    evar_last; [exact P |]; simpl pred; rewrite sum_Sn, sum_O; unfold plus; simpl; ring. }
  assert (W := V); destruct W as (x1 & v1 & x2 & v2 & x3 & v3 & M & A & E & N1 & N0).
  repeat split.
  - rewrite N1; destruct (one_motion g d 1 _ _ _ _ (third _ _ _ _ _ _ _ _ M) (series_moves g d)) with (t := 1) as [X _];
      [rewrite (third_place _ _ _ _ _ _ _ _ M); symmetry; apply Start | rewrite (third_speed _ _ _ _ _ _ _ _ M); symmetry; apply Start | lra |].
    rewrite X; apply Sum.
  - (* exp(d t) times the motion under the force exp(-d t) is that of the damping - d *)
    set (w := fun t => x2 t * x2 t - v2 t * x3 t); set (s := fun t => x2 t - d * w t).
    assert (B : moves g (- d) 1 (fun t => exp (d * t) * w t) (fun t => exp (d * t) * (s t + d * w t))).
    { intro t; assert (P : is_derive w t (s t)) by apply (fading_force _ _ _ _ _ _ _ _ M t).
      assert (Q : is_derive s t (exp (- d * t) - d * s t - g * w t)) by apply (fading_force _ _ _ _ _ _ _ _ M t).
      assert (P' : Derive (fun t => w t) t = s t) by (apply is_derive_unique; exact P).
      assert (Q' : Derive (fun t => s t) t = exp (- d * t) - d * s t - g * w t) by (apply is_derive_unique; exact Q).
      assert (F : exp (d * t) * exp (- d * t) = 1) by (rewrite <- exp_plus, <- exp_0; f_equal; ring).
      clearbody w s; split.
      - auto_derive; [repeat split; eexists; eassumption | rewrite P'; ring].
      - auto_derive; [repeat split; eexists; eassumption | rewrite P', Q'].
        transitivity (exp (d * t) * exp (- d * t) + d * exp (d * t) * (s t + d * w t) - g * (exp (d * t) * w t)); [ring | rewrite F; ring]. }
    destruct (one_motion g (- d) 1 _ _ _ _ B (series_moves g (- d))) with (t := 1) as [X _]; [| | lra |].
    + rewrite (proj1 (Start (- d))); unfold w; rewrite (second_place _ _ _ _ _ _ _ _ M), (third_place _ _ _ _ _ _ _ _ M); ring.
    + rewrite (proj2 (Start (- d))); unfold s, w; rewrite (second_place _ _ _ _ _ _ _ _ M), (third_place _ _ _ _ _ _ _ _ M); ring.
    + replace (n0 / exp (- d)) with (PSeries (taylor g (- d)) 1); [apply Sum |].
      rewrite <- X, N0, Rmult_1_r; destruct (held_force _ _ _ _ _ _ _ _ M 1) as (H & _); rewrite H.
      unfold w; rewrite exp_Ropp; field; apply Rgt_not_eq, exp_pos.
  - exact (device_loss _ _ _ _ _ _ V).
  - generalize (device_at_rest _ _ _ _ _ _ V); lra.
Qed.

(* What follows the coefficient of t^(m + 2) is less than twice the next one may be. *)
Definition left_out (m : nat) (g d : R) : R := 2 * ((1 + Rabs d + Rabs g) ^ (m + 3) / INR (fact (m + 3))).
Lemma taylor_tail : forall g d m, 1 + Rabs d + Rabs g <= INR (m + 4) / 2 -> forall k,
  Rabs (taylor g d (m + 3 + k)) <= (1 + Rabs d + Rabs g) ^ (m + 3) / INR (fact (m + 3)) * (1/2) ^ k.
Proof.
  intros g d m B k; eapply Rle_trans; [apply taylor_falls |].
  set (c := 1 + Rabs d + Rabs g) in *; assert (C : 0 <= c) by (unfold c; generalize (Rabs_pos d) (Rabs_pos g); lra).
  induction k as [| k IH]; [rewrite Nat.add_0_r, pow_O; lra |].
  replace (m + 3 + S k)%nat with (S (m + 3 + k)) by lia; rewrite fact_simpl, mult_INR.
  assert (P : 0 < INR (fact (m + 3 + k))) by apply INR_fact_lt_0.
  assert (Q : INR (m + 4) <= INR (S (m + 3 + k))) by (apply le_INR; lia).
  assert (M : 4 <= INR (m + 4)) by (rewrite plus_INR; simpl; generalize (pos_INR m); lra).
  replace (c ^ S (m + 3 + k) / (INR (S (m + 3 + k)) * INR (fact (m + 3 + k)))) with
    (c ^ (m + 3 + k) / INR (fact (m + 3 + k)) * (c / INR (S (m + 3 + k)))) by
    (change (c ^ S (m + 3 + k)) with (c * c ^ (m + 3 + k)); field; split; lra).
  replace ((1/2) ^ S k) with ((1/2) ^ k * (1/2)) by (simpl; ring); rewrite <- Rmult_assoc.
  apply Rmult_le_compat; [| | exact IH |].
  - apply Rmult_le_pos; [apply pow_le, C | apply Rlt_le, Rinv_0_lt_compat, P].
  - apply Rmult_le_pos; [exact C | apply Rlt_le, Rinv_0_lt_compat; lra].
  - apply Rle_div_l; lra.
Qed.
Lemma held_near : forall g d x m, 1 + Rabs d + Rabs g <= INR (m + 4) / 2 -> held g d x ->
  Rabs (x - sum_n (fun k => snd (ways g d k)) m) <= left_out m g d.
Proof.
  intros g d x m S H; unfold left_out; set (A := (1 + Rabs d + Rabs g) ^ (m + 3) / INR (fact (m + 3))).
  set (b := fun k => snd (ways g d (Datatypes.S m + k))).
  assert (B : is_series b (x - sum_n (fun k => snd (ways g d k)) m)).
  { apply (is_series_incr_n (fun k => snd (ways g d k)) (Datatypes.S m)); [lia |].
    set (w := sum_n (fun k => snd (ways g d k)) m).
    evar_last; [exact H | change (x = x - w + w); ring]. }
  assert (F : forall k, Rabs (b k) <= A * (1/2) ^ k).
  { intro k; replace (b k) with (taylor g d (m + 3 + k)); [apply (taylor_tail g d m S k) |].
    replace (m + 3 + k)%nat with (Datatypes.S (Datatypes.S (Datatypes.S m + k))) by lia; reflexivity. }
  assert (T : is_series (fun k => A * (1/2) ^ k) (2 * A)).
  { assert (W : Rabs (1/2) < 1) by (rewrite Rabs_pos_eq; lra).
    assert (V : is_series (fun k => A * (1/2) ^ k) (A * (/ (1 - 1/2))))
      by exact (is_series_scal A (fun k => (1/2) ^ k) (/ (1 - 1/2)) (is_series_geom (1/2) W)).
    replace (A * / (1 - 1/2)) with (2 * A) in V by field; exact V. }
  assert (X : ex_series (fun k => Rabs (b k))).
  { apply (ex_series_le (fun k => Rabs (b k)) (fun k => A * (1/2) ^ k)); [| exists (2 * A); exact T].
    intro k; unfold norm; simpl; unfold abs; simpl; rewrite Rabs_Rabsolu; apply F. }
  rewrite <- (is_series_unique _ _ B), <- (is_series_unique _ _ T).
  apply Rle_trans with (1 := Series_Rabs b X).
  apply Series_le; [| exists (2 * A); exact T]; intro k; split; [apply Rabs_pos | apply F].
Qed.
Lemma sampled : forall (m : nat) (g d n1 n0 a e : R), device g d n1 n0 a e -> 1 + Rabs d + Rabs g <= INR (m + 4) / 2 ->
  exists r s, Rabs r <= left_out m g d /\ Rabs s <= left_out m g d /\ n1 = sum_n (fun k => snd (ways g d k)) m + r /\
    n0 = exp (- d) * (sum_n (fun k => snd (ways g (- d) k)) m + s) /\ e = exp (- d) /\ a = 1 + e - g * (n1 + n0).
Proof.
  intros m g d n1 n0 a e V B; destruct (on_plants g d n1 n0 a e V) as (P & Q & E & A).
  assert (Y := held_near g (- d) _ m ltac:(rewrite Rabs_Ropp; exact B) Q).
  unfold left_out in Y; rewrite Rabs_Ropp in Y; fold (left_out m g d) in Y.
  exists (n1 - sum_n (fun k => snd (ways g d k)) m), (n0 / exp (- d) - sum_n (fun k => snd (ways g (- d) k)) m).
  repeat split; [exact (held_near g d n1 m B P) | exact Y | ring | field; apply Rgt_not_eq, exp_pos | exact E | lra].
Qed.

(* -- sums of lists -------------------------------------------------------------------- *)

Fixpoint termwise {T} (add : T -> T -> T) (a b : list T) : list T :=
  match a, b with
  | nil, _ => b
  | _, nil => a
  | x :: a', y :: b' => add x y :: termwise add a' b'
  end.
Fixpoint along {T} (zero : T) (add mul : T -> T -> T) (s h : list T) : T :=
  match s, h with
  | x :: s', y :: h' => add (mul x y) (along zero add mul s' h')
  | _, _ => zero
  end.
Notation dot := (along 0 Rplus Rmult).

Lemma dot_termwise : forall a b h, dot (termwise Rplus a b) h = dot a h + dot b h.
Proof.
  induction a as [| x a IH]; intros [| y b] [| z h]; simpl; try ring.
  rewrite IH; ring.
Qed.
Lemma dot_times : forall k a h, dot (map (Rmult k) a) h = k * dot a h.
Proof. intros k; induction a as [| x a IH]; intros [| z h]; simpl; try ring; rewrite IH; ring. Qed.

(* -- names ---------------------------------------------------------------------------- *)

(* Each of what is named before it; and the last names of a chain. *)
Definition with_names (es : list expr) : list R -> list R := fold_left (fun x e => eval e x :: x) es.
Definition last_of {T} (none : T) (kept : nat) (chain : list T) : list T := map (fun i => nth i chain none) (seq 0 kept).
Lemma nth_last_of : forall T (none : T) kept chain more n, nth n (last_of none kept chain ++ more) none =
  if (n <? kept)%nat then nth n chain none else nth (n - kept) more none.
Proof.
  intros T none kept chain more n; assert (L : List.length (last_of none kept chain) = kept)
    by (unfold last_of; rewrite map_length; apply seq_length).
  destruct (Nat.ltb_spec n kept) as [B | B].
  - rewrite app_nth1 by lia; unfold last_of; rewrite (nth_indep _ none (nth O chain none)) by (rewrite map_length, seq_length; lia).
    rewrite (map_nth (fun i => nth i chain none) (seq 0 kept) O n), seq_nth by lia; reflexivity.
  - rewrite app_nth2, L by lia; reflexivity.
Qed.

(* The coefficients of t to t^(m + 1), each named after those before it, where the n-th name finds gamma and delta by G n and D n; and their sum. *)
Definition quotient (a : expr) (n : Z) : expr := Ebinary Div a (Econst (Int n)).
Definition next (G D : nat -> expr) (m : nat) : expr :=
  let n := Z.of_nat (m + 3) in
  Eunary Neg (Ebinary Tree.Add (quotient (Ebinary Mul (D (m + 2)%nat) (Evar 0)) n)
    (quotient (Ebinary Mul (G (m + 2)%nat) (Evar 1)) (n * (n - 1)))).
Fixpoint coefficients (G D : nat -> expr) (m : nat) : list expr :=
  match m with
  | O => Econst (Int 0) :: nil
  | S O => Econst (Int 0) :: quotient (Econst (Int 1)) 2 :: nil
  | S (S k as l) => coefficients G D l ++ next G D k :: nil
  end.
Fixpoint said (g d : R) (m : nat) : list R :=
  match m with O => taylor g d 1 :: nil | S k => taylor g d (S (S k)) :: said g d k end.
Fixpoint total (i k : nat) : expr :=
  match k with O => Econst (Int 0) | S k => Ebinary Tree.Add (Evar i) (total (S i) k) end.
Lemma said_length : forall g d m, List.length (said g d m) = S m.
Proof. intros g d m; induction m; simpl; congruence. Qed.
Lemma named_coefficients : forall g d G D x, (forall l, eval (G (List.length l)) (l ++ x) = g) ->
  (forall l, eval (D (List.length l)) (l ++ x) = d) ->
  forall m, with_names (coefficients G D m) x = said g d m ++ x.
Proof.
  intros g d G D x HG HD m; assert (B : with_names (coefficients G D m) x = said g d m ++ x /\
    with_names (coefficients G D (S m)) x = said g d (S m) ++ x); [| apply B].
  induction m as [| m [_ IH]]; [split; reflexivity |]; split; [exact IH |].
  change (coefficients G D (S (S m))) with (coefficients G D (S m) ++ next G D m :: nil).
  unfold with_names in *; rewrite fold_left_app, IH; cbn [fold_left]; change (said g d (S (S m))) with
    (taylor g d (S (S (S m))) :: said g d (S m)); cbn [app]; f_equal.
  assert (P : INR (m + 3) <> 0) by (apply not_0_INR; lia); assert (Q : INR (m + 3) - 1 <> 0).
  { rewrite plus_INR; simpl; generalize (pos_INR m); lra. }
  assert (HG' := HG (said g d (S m))); assert (HD' := HD (said g d (S m))); rewrite said_length in HG', HD'.
  replace (S (S m)) with (m + 2)%nat in HG', HD' by lia.
  cbn -[INR Z.of_nat taylor said app Nat.add Z.mul Z.sub]; rewrite HG', HD'; rewrite mult_IZR, minus_IZR, <- !INR_IZR_INZ.
  assert (T := taylor_next g d (S m)); cbn [said app nth] in *.
  replace (S m + 2)%nat with (m + 3)%nat in T by lia; replace (INR (S m + 1)) with (INR (m + 3) - 1) in T
    by (replace (m + 3)%nat with (S (S m + 1)) by lia; rewrite S_INR; ring).
  assert (U : taylor g d (S (S (S m))) = - (d * taylor g d (S (S m)) / INR (m + 3) +
    g * taylor g d (S m) / (INR (m + 3) * (INR (m + 3) - 1)))) by
    (apply (Rmult_eq_reg_l (INR (m + 3) * (INR (m + 3) - 1))); [| apply Rmult_integral_contrapositive; tauto];
     transitivity (- (d * ((INR (m + 3) - 1) * taylor g d (S (S m))) + g * taylor g d (S m))); [lra | field; tauto]).
  rewrite U; destruct m; reflexivity.
Qed.
Lemma total_of : forall l pre x, eval (total (List.length pre) (List.length l)) (pre ++ l ++ x) = fold_right Rplus 0 l.
Proof.
  induction l as [| y l IH]; intros pre x; simpl; [reflexivity |]; f_equal.
  - rewrite app_nth2, Nat.sub_diag by lia; reflexivity.
  - replace (S (List.length pre)) with (List.length (pre ++ y :: nil)) by (rewrite app_length; simpl; lia).
    rewrite <- (IH (pre ++ y :: nil) x), <- app_assoc; reflexivity.
Qed.
Lemma sum_said : forall g d m, fold_right Rplus 0 (said g d (S m)) = sum_n (fun k => snd (ways g d k)) m.
Proof.
  intros g d m; induction m as [| m IH]; [rewrite sum_O; simpl; ring |].
  rewrite sum_Sn, <- IH; change plus with Rplus; change (said g d (S (S m))) with (taylor g d (S (S (S m))) :: said g d (S m)).
  cbn [fold_right]; change (taylor g d (S (S (S m)))) with (snd (ways g d (S m))); ring.
Qed.

(* Boxes with floats of one kind and length. *)
Module Type Length (F : Sig.FloatOps).
Parameter prec : F.precision.
End Length.
Module Boxes (F : Sig.FloatOps with Definition sensible_format := true) (Floats_have : Length F).
Module Import Floats := Values F.
Definition prec := Floats_have.prec.
Notation ops := (Floats.ops prec).
Notation nullary_of := (Floats.nullary_of prec).
Notation value_of := (Floats.value_of prec).
Notation has_nullary := (Floats.has_nullary prec).
Notation has_unary := (Floats.has_unary prec).
Notation has_binary := (Floats.has_binary prec).
Notation has_value := (Floats.has_value prec).
Notation ball := Ball.type.

(* -- slopes: f(x) - f(c) = s . (x - c) ------------------------------------------------ *)

(* A function on a box: its values; its value in the middle and its slopes, where they are known. *)
Record node := Node { values : ball; slopes : option (ball * list ball) }.

Section Slopes.
Variable ways : list ball.
Variable way : list R.
Hypothesis Ways : Forall2 has ways way.

Definition good (f : node) (x c : R) : Prop :=
  has (values f) x /\
  match slopes f with
  | None => True
  | Some (C, Sl) => has C c /\ exists s, Forall2 has Sl s /\ x - c = dot s way
  end.

Definition add := Ball.add prec.
Definition mul := Ball.mul prec.
Arguments add : simpl never.
Arguments mul : simpl never.
Arguments Floats.ops : simpl never.
Definition moved (V C : ball) (Sl : list ball) : node :=
  Node (Ball.meet V (add C (along Ball.zero add mul Sl ways))) (Some (C, Sl)).
Definition times (K : ball) (Sl : list ball) := map (mul K) Sl.

Definition of_unary (o : unary_op) (f : node) : node :=
  let V := unary ops o (values f) in
  match slopes f with
  | None => Node V None
  | Some (C, Sl) =>
      let D := unary ops o C in
      let between := Ball.join (values f) C in
      match o with
      | Neg => moved V D (map Ball.neg Sl)
      | Sqr => moved V D (times (add (values f) C) Sl)
      | Exp => moved V D (times (Ball.exp prec between) Sl)
      | PowerInt (Z.pos n) =>
          moved V D (times (mul (Ball.fromZ prec (Z.pos n)) (Ball.power_int prec between (Z.pos n - 1))) Sl)
      | Inv =>
          match Ball.sign_strict (mul (values f) C) with
          | Xgt => moved V D (times (Ball.neg (Ball.inv prec (mul (values f) C))) Sl)
          | _ => Node V None
          end
      | _ => Node V None
      end
  end.
Definition of_product (V : ball) (f g : node) : node :=
  match slopes f, slopes g with
  | Some (C, Sl), Some (D, T) =>
      moved V (mul C D) (termwise add (times (values g) Sl) (times C T))
  | _, _ => Node V None
  end.
Definition of_binary (o : binary_op) (f g : node) : node :=
  let V := binary ops o (values f) (values g) in
  match o with
  | Mul => of_product V f g
  | Div => of_product V f (of_unary Inv g)
  | Add | Sub =>
      match slopes f, slopes g with
      | Some (C, Sl), Some (D, T) =>
          moved V (binary ops o C D) (termwise add Sl (match o with Sub => map Ball.neg T | _ => T end))
      | _, _ => Node V None
      end
  end.
Definition nowhere := Node Ball.nai None.
Fixpoint node_of (e : expr) (of : list node) : node :=
  match e with
  | Evar n => nth n of nowhere
  | Econst o => Node (nullary_of o) (Some (nullary_of o, nil))
  | Eunary o a => of_unary o (node_of a of)
  | Ebinary o a b => of_binary o (node_of a of) (node_of b of)
  end.

Lemma has_add : forall X x Y y, has X x -> has Y y -> has (add X Y) (x + y).
Proof. intros X x Y y; apply J.add_correct. Qed.
Lemma has_mul : forall X x Y y, has X x -> has Y y -> has (mul X Y) (x * y).
Proof. intros X x Y y; apply J.mul_correct. Qed.
Lemma has_number : forall n, has (Ball.fromZ prec n) (IZR n).
Proof. intro n; apply Ball.fromZ_correct. Qed.
Lemma has_power : forall X x n, has X x -> has (Ball.power_int prec X n) (powerRZ x n).
Proof. intros X x n; exact (J.power_int_correct prec n X x). Qed.
Lemma has_exp : forall X x, has X x -> has (Ball.exp prec X) (exp x).
Proof. exact (J.exp_correct prec). Qed.
Lemma has_neg : forall X x, has X x -> has (Ball.neg X) (- x).
Proof. intros X x; apply J.neg_correct. Qed.
Lemma has_termwise : forall A a B b, Forall2 has A a -> Forall2 has B b -> Forall2 has (termwise add A B) (termwise Rplus a b).
Proof.
  intros A a B b F; revert B b; induction F; intros B b G; [exact G |].
  destruct G; simpl; constructor; auto using has_add.
Qed.
Lemma has_times : forall K k A a, has K k -> Forall2 has A a -> Forall2 has (times K A) (map (Rmult k) a).
Proof. intros K k A a P F; induction F; simpl; constructor; auto using has_mul. Qed.
Lemma has_negs : forall A a, Forall2 has A a -> Forall2 has (map Ball.neg A) (map (Rmult (-1)) a).
Proof.
  intros A a F; induction F; simpl; constructor; auto.
  replace (-1 * y) with (- y) by ring; apply has_neg; assumption.
Qed.
Lemma has_dot : forall A a, Forall2 has A a -> has (along Ball.zero add mul A ways) (dot a way).
Proof.
  intros A a F; revert ways way Ways; induction F; intros W w G; simpl; [apply J.zero_correct |].
  destruct G; [apply J.zero_correct |]; apply has_add; auto using has_mul.
Qed.
Lemma has_between : forall X x Y y z, has X x -> has Y y -> Rmin x y <= z <= Rmax x y -> has (Ball.join X Y) z.
Proof.
  intros X x Y y z P Q B; destruct (Rle_dec x y) as [L | L].
  - rewrite Rmin_left, Rmax_right in B by lra; apply (J.join_correct X Y x y); assumption.
  - rewrite Rmin_right, Rmax_left in B by lra.
    apply (contains_connected (Ball.convert (Ball.join X Y)) y x); [| | exact B];
      apply Ball.join_correct; [right | left]; assumption.
Qed.
Lemma has_moved : forall V C Sl x c s, has V x -> has C c -> Forall2 has Sl s -> x - c = dot s way ->
  good (moved V C Sl) x c.
Proof.
  intros V C Sl x c s P Q F E; split; simpl.
  - apply Ball.meet_correct; [exact P |].
    replace x with (c + dot s way) by lra; apply has_add; [exact Q | apply has_dot, F].
  - split; [exact Q | exists s; split; assumption].
Qed.
Lemma has_times_way : forall V C Sl K x c s k y d, has V y -> has C d -> has K k -> Forall2 has Sl s ->
  x - c = dot s way -> y - d = k * (x - c) -> good (moved V C (times K Sl)) y d.
Proof.
  intros V C Sl K x c s k y d P Q N F E D; apply (has_moved V C _ y d (map (Rmult k) s)); auto using has_times.
  rewrite dot_times, D, E; reflexivity.
Qed.
(* By the mean value theorem. *)
Lemma between : forall (f g : R -> R) x c, (forall t, is_derive f t (g t)) ->
  exists t, Rmin x c <= t <= Rmax x c /\ f x - f c = g t * (x - c).
Proof.
  intros f g x c D; destruct (MVT_gen f c x g) as [t [B E]].
  - intros t _; apply D.
  - intros t _; apply continuity_pt_filterlim, (ex_derive_continuous f); exists (g t); apply D.
  - exists t; rewrite Rmin_comm, Rmax_comm; split; assumption.
Qed.
Lemma good_unary : forall o f x c, good f x c -> good (of_unary o f) (unary_real o x) (unary_real o c).
Proof.
  intros o [X [[C Sl] |]] x c [P Q]; unfold of_unary; simpl in P, Q |- *; [| split; [apply has_unary, P | exact I]].
  destruct Q as [Q [s [F E]]]; assert (V := has_unary o X x P); assert (D := has_unary o C c Q).
  destruct o; try (split; [exact V | exact I]).
  - apply (has_moved _ _ _ _ _ (map (Rmult (-1)) s)); auto using has_negs.
    rewrite dot_times; simpl; lra.
  - destruct (Ball.sign_strict (mul X C)) eqn:N; try (split; [exact V | exact I]).
    assert (M := Ball.sign_strict_correct (mul X C)); rewrite N in M.
    destruct (M (Xreal (x * c)) (has_mul X x C c P Q)) as [_ L]; simpl in L.
    apply (has_times_way _ _ _ _ x c s (- / (x * c))); auto.
    + apply has_neg, J.inv_correct, has_mul; assumption.
    + simpl; field; split; intro Z; rewrite Z in L; lra.
  - apply (has_times_way _ _ _ _ x c s (x + c)); auto using has_add.
    simpl; unfold Rsqr; ring.
  - destruct (between exp exp x c is_derive_exp) as [t [B W]].
    apply (has_times_way _ _ _ _ x c s (exp t)); auto.
    apply has_exp, (has_between X x C c); assumption.
  - destruct n as [| n |]; try (split; [exact V | exact I]).
    destruct (between (fun t => powerRZ t (Z.pos n)) (fun t => IZR (Z.pos n) * powerRZ t (Z.pos n - 1)) x c) as [t [B W]].
    + intro t; simpl powerRZ at 1; replace (Z.pos n - 1)%Z with (Z.of_nat (pred (Pos.to_nat n))) by lia.
      rewrite <- pow_powerRZ, <- positive_nat_Z, <- INR_IZR_INZ.
      replace (INR (Pos.to_nat n) * t ^ pred (Pos.to_nat n)) with (INR (Pos.to_nat n) * 1 * t ^ pred (Pos.to_nat n)) by ring.
      apply (is_derive_pow (fun t => t) (Pos.to_nat n) t 1); auto_derive; [exact Logic.I | ring].
    + apply (has_times_way _ _ _ _ x c s (IZR (Z.pos n) * powerRZ t (Z.pos n - 1))); auto.
      apply has_mul; [apply has_number | apply has_power, (has_between X x C c); assumption].
Qed.
Lemma good_product : forall V f g x c y d, has V (x * y) -> good f x c -> good g y d ->
  good (of_product V f g) (x * y) (c * d).
Proof.
  intros V [X [[C Sl] |]] [Y [[D T] |]] x c y d P [Q F] [U G]; unfold of_product; simpl in *;
    try (split; [exact P | exact I]).
  destruct F as [F [s [A E]]], G as [G [t [B L]]].
  apply (has_moved _ _ _ _ _ (termwise Rplus (map (Rmult y) s) (map (Rmult c) t))); auto using has_mul.
  - apply has_termwise; apply has_times; assumption.
  - rewrite dot_termwise, !dot_times, <- E, <- L; ring.
Qed.
Lemma good_binary : forall o f g x c y d, good f x c -> good g y d ->
  good (of_binary o f g) (binary_real o x y) (binary_real o c d).
Proof.
  intros o f g x c y d P Q; assert (V := has_binary o _ _ _ _ (proj1 P) (proj1 Q)).
  destruct o; [| | apply good_product; assumption |].
  - destruct f as [X [[C Sl] |]], g as [Y [[D T] |]], P as [P F], Q as [Q G]; simpl in *;
      try (split; [exact V | exact I]).
    destruct F as [F [s [A E]]], G as [G [t [B L]]].
    apply (has_moved _ _ _ _ _ (termwise Rplus s t)); auto using has_termwise.
    + apply (has_binary Add); assumption.
    + rewrite dot_termwise, <- E, <- L; ring.
  - destruct f as [X [[C Sl] |]], g as [Y [[D T] |]], P as [P F], Q as [Q G]; simpl in *;
      try (split; [exact V | exact I]).
    destruct F as [F [s [A E]]], G as [G [t [B L]]].
    apply (has_moved _ _ _ _ _ (termwise Rplus s (map (Rmult (-1)) t))); auto.
    + apply (has_binary Sub); assumption.
    + apply has_termwise; auto using has_negs.
    + rewrite dot_termwise, dot_times, <- E, <- L; ring.
  - exact (good_product _ f (of_unary Inv g) x c (/ y) (/ d) V P (good_unary Inv g y d Q)).
Qed.
Lemma good_node : forall e F x c, (forall n, good (nth n F nowhere) (nth n x 0) (nth n c 0)) ->
  good (node_of e F) (eval e x) (eval e c).
Proof.
  intros e F x c G; induction e; simpl.
  - apply G.
  - split; simpl; [apply has_nullary | split; [apply has_nullary | exists nil; split; [constructor | simpl; ring]]].
  - apply good_unary; assumption.
  - apply good_binary; assumption.
Qed.


End Slopes.

(* -- pieces -------------------------------------------------------------------------- *)

Section Pieces.
Variables (rests chain : list expr) (kept : nat) (inner : list expr) (outer : expr).
(* Of each variable a box's part; of what is left out of a series a bound; of what is named how it
   is made of the variables, of that, and of what is named before it.  Of a chain of names only the
   last are kept. *)

Definition around (X : ball) : ball := Ball.join (Ball.neg X) X.
Definition whole_box (box : list ball) : list ball := box ++ map (fun e => around (value_of e box)) rests.
Definition unit (n : nat) : list ball := repeat Ball.zero n ++ Ball.fromZ prec 1 :: nil.
Definition ways_of (box : list ball) : list ball := map (fun X => Ball.sub prec X (J.midpoint X)) box.
Fixpoint variables (n : nat) (box : list ball) : list node :=
  match box with
  | nil => nil
  | X :: more => Node X (Some (J.midpoint X, unit n)) :: variables (Datatypes.S n) more
  end.
Definition above (X : ball) : bool := match Ball.sign_strict X with Xgt => true | _ => false end.
Definition decided (box : list ball) : bool :=
  let all := whole_box box in
  let W := ways_of all in
  let named := fold_left (fun known e => node_of W e known :: known) in
  let env := named inner (last_of nowhere kept (named chain (variables 0 all)) ++ variables 0 all) in
  above (value_of outer (map values env)) || above (values (node_of W outer env)).

Definition parts (n : nat) (box : list ball) : list ball * list ball :=
  let (X, Y) := Ball.bisect (nth n box Ball.nai) in
  (firstn n box ++ X :: skipn (Datatypes.S n) box, firstn n box ++ Y :: skipn (Datatypes.S n) box).
Definition number_of (c : ascii) : nat := nat_of_ascii c - 48.
(* The certificate: a digit is the number of the variable across which a piece is halved, the lower
   half first.  What is left of the text, where all is decided. *)
Fixpoint pieces (fuel : nat) (cuts : string) (box : list ball) : option string :=
  match fuel, cuts with
  | Datatypes.S more, String c rest =>
      if orb (Ascii.eqb c " ") (Ascii.eqb c "010") then pieces more rest box
      else if orb (Ascii.eqb c ".") (Ascii.eqb c ":") then if decided box then Some rest else None
      else if Nat.ltb (number_of c) (List.length box) then
        let (low, high) := parts (number_of c) box in
        match pieces more rest low with
        | Some rest => pieces more rest high
        | None => None
        end
      else None
  | _, _ => None
  end.

Definition within_rests (x r : list R) : Prop := Forall2 (fun e y => Rabs y <= eval e x) rests r.
Definition all_names (x : list R) : list R := with_names inner (last_of 0 kept (with_names chain x) ++ x).
Definition holds (x : list R) : Prop := forall r, within_rests x r -> 0 < eval outer (all_names (x ++ r)).

Lemma has_around : forall X x r, has X x -> Rabs r <= x -> has (around X) r.
Proof.
  intros X x r P B; apply Rabs_le_between in B.
  apply (J.join_correct (Ball.neg X) X (- x) x); [apply has_neg | |]; assumption.
Qed.
Lemma has_whole : forall B x r, Forall2 has B x -> within_rests x r -> Forall2 has (whole_box B) (x ++ r).
Proof.
  intros B x r F G; apply Forall2_app; [exact F |]; clear inner outer.
  unfold within_rests in G; induction G; simpl; constructor; [| assumption].
  apply has_around with (eval x0 x); [apply has_value; intro n; apply has_nth |]; assumption.
Qed.
Definition middle (X : ball) : R := proj_val (Ball.F.convert (Ball.midpoint X)).
Lemma has_middle : forall X x, has X x -> has (J.midpoint X) (middle X).
Proof. intros X x P; apply J.contains_midpoint; exists x; exact P. Qed.
Lemma has_ways : forall B x, Forall2 has B x -> Forall2 has (ways_of B) (map (fun p => fst p - middle (snd p)) (combine x B)).
Proof.
  intros B x F; induction F as [| X y B x P F IH]; simpl; constructor; [| exact IH].
  apply J.sub_correct; [exact P | apply (has_middle X y P)].
Qed.
Lemma has_unit : forall n, Forall2 has (unit n) (repeat 0 n ++ 1 :: nil).
Proof.
  intro n; apply Forall2_app; [| constructor; [apply Ball.fromZ_correct | constructor]].
  induction n; simpl; constructor; [apply J.zero_correct | assumption].
Qed.
Lemma dot_unit : forall n w, dot (repeat 0 n ++ 1 :: nil) w = nth n w 0.
Proof. induction n; intros [| y w]; simpl; try ring; rewrite IHn; ring. Qed.
Lemma good_variables : forall B x n w m, Forall2 has B x ->
  (forall k, nth (n + k) w 0 = nth k (map (fun p => fst p - middle (snd p)) (combine x B)) 0) ->
  good w (nth m (variables n B) nowhere) (nth m x 0) (nth m (map middle B) 0).
Proof.
  intros B x n w m F; revert n m; induction F as [| X y B x P F IH]; intros n m E.
  - destruct m; (split; [apply has_nai | exact Logic.I]).
  - destruct m as [| m]; simpl.
    + split; [exact P | split; [apply (has_middle X y P) |]].
      exists (repeat 0 n ++ 1 :: nil); split; [apply has_unit |].
      rewrite dot_unit; rewrite <- (Nat.add_0_r n), E; reflexivity.
    + apply IH; intro k; replace (Datatypes.S n + k)%nat with (n + Datatypes.S k)%nat by lia; apply E.
Qed.
Lemma above_zero : forall X x, has X x -> above X = true -> 0 < x.
Proof.
  intros X x P A; unfold above in A; destruct (Ball.sign_strict X) eqn:N; try discriminate.
  assert (M := Ball.sign_strict_correct X); rewrite N in M; apply (M (Xreal x) P).
Qed.
Lemma decided_holds : forall B x, Forall2 has B x -> decided B = true -> holds x.
Proof.
  intros B x F D r W; assert (G := has_whole B x r F W); unfold decided in D.
  set (all := whole_box B) in *; set (y := x ++ r) in *; clearbody all y.
  set (w := map (fun p => fst p - middle (snd p)) (combine y all)).
  assert (V : forall n, good w (nth n (variables 0 all) nowhere) (nth n y 0) (nth n (map middle all) 0)).
  { intro n; apply good_variables; [exact G | reflexivity]. }
  set (named := fold_left (fun known e => node_of (ways_of all) e known :: known)) in D.
  assert (I : forall es N z c, (forall n, good w (nth n N nowhere) (nth n z 0) (nth n c 0)) ->
    forall n, good w (nth n (named es N) nowhere) (nth n (with_names es z) 0) (nth n (with_names es c) 0)).
  { clear - G; subst named; unfold with_names; induction es as [| e more IH]; intros N z c V; simpl; [exact V |].
    apply IH; intros [| n]; [| apply V]; apply good_node; [apply has_ways, G | exact V]. }
  set (N := named inner _) in D; set (c := all_names (map middle all)).
  assert (U : forall n, good w (nth n N nowhere) (nth n (all_names y) 0) (nth n c 0)).
  { apply I; intro n; rewrite !nth_last_of; destruct (n <? kept)%nat; [apply I |]; apply V. }
  apply orb_prop in D; destruct D as [D | D].
  - refine (above_zero _ _ (has_value outer _ _ _) D); intro n.
    rewrite (map_nth values N nowhere n : nth n (map values N) Ball.nai = _); apply (U n).
  - exact (above_zero _ _ (proj1 (good_node (ways_of all) w (has_ways _ _ G) outer N _ c U)) D).
Qed.
Lemma parts_cover : forall n B x, (n < List.length B)%nat -> Forall2 has B x ->
  Forall2 has (fst (parts n B)) x \/ Forall2 has (snd (parts n B)) x.
Proof.
  intros n B x L F; unfold parts; assert (P := has_nth B x n F).
  assert (Q := Ball.bisect_correct _ _ P); destruct (Ball.bisect (nth n B Ball.nai)) as [X Y]; simpl in *.
  assert (E : x = firstn n x ++ nth n x 0 :: skipn (Datatypes.S n) x).
  { clear - F L; revert n L; induction F; intros [| n] L; simpl in *; try lia; [reflexivity |].
    f_equal; apply IHF; lia. }
  assert (G : Forall2 has (firstn n B) (firstn n x) /\ Forall2 has (skipn (Datatypes.S n) B) (skipn (Datatypes.S n) x)).
  { clear - F; revert n; induction F; intros [| n]; simpl; split; try constructor; try assumption; apply IHF. }
  destruct Q as [Q | Q]; [left | right]; rewrite E; apply Forall2_app; try constructor; tauto.
Qed.
Lemma pieces_hold : forall fuel cuts B rest, pieces fuel cuts B = Some rest ->
  forall x, Forall2 has B x -> holds x.
Proof.
  induction fuel as [| fuel IH]; intros [| c cuts] B rest E x F; simpl in E; try discriminate.
  destruct (Ascii.eqb c " " || Ascii.eqb c "010"); [exact (IH _ _ _ E x F) |].
  destruct (Ascii.eqb c "." || Ascii.eqb c ":"); [destruct (decided B) eqn:D; [| discriminate] |].
  - apply (decided_holds B x F D).
  - destruct (Nat.ltb_spec (number_of c) (List.length B)) as [L | L]; [| discriminate].
    assert (P := parts_cover (number_of c) B x L F); destruct (parts (number_of c) B) as [X Y].
    destruct (pieces fuel cuts X) eqn:G; [| discriminate].
    destruct P as [P | P]; [apply (IH _ _ _ G x P) | apply (IH _ _ _ E x P)].
Qed.

(* Between two numbers, each a quotient of whole numbers. *)
Definition side (ends : expr * expr) : ball := Ball.join (value_of (fst ends) nil) (value_of (snd ends) nil).
Definition lies (ends : expr * expr) (x : R) : Prop := eval (fst ends) nil <= x <= eval (snd ends) nil.
Definition checked (ends : list (expr * expr)) (cuts : string) : bool :=
  match pieces (Datatypes.S (String.length cuts)) cuts (map side ends) with Some EmptyString => true | _ => false end.
Theorem boxed : forall ends cuts x r, checked ends cuts = true ->
  Forall2 lies ends x -> Forall2 (fun e y => Rabs y <= eval e x) rests r ->
  0 < eval outer (all_names (x ++ r)).
Proof.
  intros ends cuts x r E F; unfold checked in E.
  destruct (pieces (Datatypes.S (String.length cuts)) cuts (map side ends)) eqn:P; [| discriminate].
  apply (pieces_hold _ _ _ _ P x); clear - F.
  induction F as [| [a b] y ends x L F IH]; simpl; constructor; [| exact IH].
  apply (J.join_correct _ _ (eval a nil) (eval b nil));
    [apply has_value; intros [|]; apply has_nai .. | exact L].
Qed.
End Pieces.

(* -- a device's numbers on a box ------------------------------------------------------ *)

(* The numbers of a device, of gamma, delta, others and what is left out of two series with m + 1 terms: their last four
   are a, n_0, e and n_1. *)
Definition sum_of (m : nat) (rest : nat) : expr := Ebinary Tree.Add (total 0 (m + 2)) (Evar (m + 2 + rest)).
Definition numbers_of (m others : nat) : list expr :=
  coefficients Evar (fun n => Evar (n + 1)) (Datatypes.S m) ++ sum_of m (2 + others) ::
  coefficients (fun n => Evar (n + (m + 3))) (fun n => Eunary Neg (Evar (n + (m + 4)))) (Datatypes.S m) ++
  sum_of m (m + 3 + (3 + others)) ::
  Evar (m + 3) :: Eunary Exp (Eunary Neg (Evar (2 * (m + 3) + 2))) :: Ebinary Mul (Evar 0) (Evar 2) ::
  Ebinary Sub (Ebinary Tree.Add (Econst (Int 1)) (Evar 1))
    (Ebinary Mul (Evar (2 * (m + 3) + 3)) (Ebinary Tree.Add (Evar 2) (Evar 0))) :: nil.
Fixpoint factorial (n : nat) : Z := match n with O => 1 | Datatypes.S k => Z.of_nat n * factorial k end.
Lemma factorial_is : forall n, IZR (factorial n) = INR (fact n).
Proof.
  induction n as [| n IH]; [reflexivity |].
  rewrite fact_simpl, mult_INR, <- IH; cbn [factorial]; rewrite mult_IZR, <- INR_IZR_INZ; reflexivity.
Qed.
Definition left_out_of (m : nat) : expr :=
  Ebinary Mul (Econst (Int 2)) (quotient (Eunary (PowerInt (Z.of_nat (m + 3)))
    (Ebinary Tree.Add (Ebinary Tree.Add (Econst (Int 1)) (Eunary Abs (Evar 1))) (Eunary Abs (Evar 0)))) (factorial (m + 3))).
Definition rests_of (m : nat) : list expr := left_out_of m :: left_out_of m :: nil.
(* Between -(m + 2)/4 and (m + 2)/4. *)
Definition small_side (m : nat) (ends : expr * expr) : bool :=
  let most := value_of (quotient (Econst (Int (Z.of_nat (m + 2)))) 4) nil in
  above (Ball.sub prec most (side ends)) && above (add most (side ends)).
Lemma has_side : forall ends x, lies ends x -> has (side ends) x.
Proof.
  intros [a b] x L; apply (J.join_correct _ _ (eval a nil) (eval b nil));
    [apply has_value; intros [|]; apply has_nai .. | exact L].
Qed.
Lemma small_side_holds : forall m ends x, small_side m ends = true -> lies ends x -> Rabs x <= INR (m + 2) / 4.
Proof.
  intros m ends x S L; apply andb_prop in S; destruct S as [S T]; apply has_side in L.
  assert (M : has (value_of (quotient (Econst (Int (Z.of_nat (m + 2)))) 4) nil) (INR (m + 2) / 4)).
  { rewrite INR_IZR_INZ; apply (has_value (quotient (Econst (Int (Z.of_nat (m + 2)))) 4) nil nil);
      intros [|]; apply has_nai. }
  apply (above_zero _ (INR (m + 2) / 4 - x)) in S; [| apply J.sub_correct; [exact M | exact L]].
  apply (above_zero _ (INR (m + 2) / 4 + x)) in T; [| apply has_add; [exact M | exact L]].
  apply Rabs_le; lra.
Qed.
Definition checked_numbers (m others : nat) (inner : list expr) (outer : expr) (ends : list (expr * expr)) (cuts : string) : bool :=
  forallb (small_side m) (firstn 2 ends) &&
  checked (rests_of m) (numbers_of m others) 4 inner outer ends cuts.
Lemma names_of : forall m g d others r s n1 n0 a e, n1 = sum_n (fun k => snd (ways g d k)) m + r ->
  n0 = exp (- d) * (sum_n (fun k => snd (ways g (- d) k)) m + s) -> e = exp (- d) -> a = 1 + e - g * (n1 + n0) ->
  last_of 0 4 (with_names (numbers_of m (List.length others)) (g :: d :: others ++ r :: s :: nil)) = a :: n0 :: e :: n1 :: nil.
Proof.
  intros m g d others r s n1 n0 a e N1 N0 E A; set (x := g :: d :: others ++ r :: s :: nil).
  unfold with_names, numbers_of; rewrite fold_left_app.
  fold (with_names (coefficients Evar (fun n => Evar (n + 1)) (Datatypes.S m)) x).
  rewrite (named_coefficients g d) by (intro l; cbn [eval];
    first [rewrite app_nth2, Nat.sub_diag by lia | rewrite app_nth2 by lia; replace (_ + 1 - _)%nat with 1%nat by lia]; reflexivity).
  cbn [fold_left]; set (y := said g d (Datatypes.S m) ++ x); assert (S1 : eval (sum_of m (2 + List.length others)) y = n1).
  { unfold sum_of; cbn [eval binary_real]; rewrite N1, <- sum_said; f_equal.
    - replace (m + 2)%nat with (List.length (said g d (Datatypes.S m))) by (rewrite said_length; lia).
      apply (total_of _ nil x).
    - unfold y; rewrite app_nth2, said_length by (rewrite said_length; lia).
      replace (m + 2 + (2 + List.length others) - Datatypes.S (Datatypes.S m))%nat with (2 + List.length others)%nat by lia.
      unfold x; cbn [nth Nat.add]; rewrite app_nth2, Nat.sub_diag by lia; reflexivity. }
  rewrite S1, fold_left_app; set (z := n1 :: y).
  assert (Z : List.length (n1 :: said g d (Datatypes.S m)) = (m + 3)%nat) by (cbn [List.length]; rewrite said_length; lia).
  match goal with |- context [fold_left _ (coefficients ?G ?D ?k) z] => change (fold_left (fun x e => eval e x :: x) (coefficients G D k) z)
    with (with_names (coefficients G D k) z) end.
  assert (Far : forall l n, nth (List.length l + (m + 3 + n)) (l ++ z) 0 = nth n x 0).
  { intros l n; rewrite app_nth2 by lia; replace (List.length l + (m + 3 + n) - List.length l)%nat with (m + 3 + n)%nat by lia.
    change z with ((n1 :: said g d (Datatypes.S m)) ++ x); rewrite app_nth2 by lia; f_equal; lia. }
  rewrite (named_coefficients g (- d)).
  2: { intro l; cbn [eval]; generalize (Far l 0%nat); rewrite Nat.add_0_r; intro H; rewrite H; reflexivity. }
  2: { intro l; cbn [eval unary_real]; generalize (Far l 1%nat); replace (m + 3 + 1)%nat with (m + 4)%nat by lia; intro H; rewrite H; reflexivity. }
  cbn [fold_left]; set (q := said g (- d) (Datatypes.S m)) in *; assert (Q : List.length q = (m + 2)%nat) by (unfold q; rewrite said_length; lia).
  set (s2 := eval (sum_of m (m + 3 + (3 + List.length others))) (q ++ z)).
  assert (S2 : s2 = sum_n (fun k => snd (ways g (- d) k)) m + s).
  { unfold s2, sum_of; cbn [eval binary_real]; rewrite <- sum_said; f_equal.
    - rewrite <- Q; apply (total_of q nil z).
    - rewrite <- Q at 1; rewrite Far; unfold x; cbn [nth Nat.add].
      rewrite app_nth2 by lia; replace (Datatypes.S (List.length others) - List.length others)%nat with 1%nat by lia; reflexivity. }
  clearbody s2.
  assert (V1 : eval (Evar (m + 3)) (s2 :: q ++ z) = n1).
  { cbn [eval]; replace (m + 3)%nat with (Datatypes.S (m + 2)) by lia; cbn [nth]; rewrite app_nth2, Q, Nat.sub_diag by lia; reflexivity. }
  rewrite V1; set (v := n1 :: s2 :: q ++ z).
  assert (V2 : eval (Eunary Exp (Eunary Neg (Evar (2 * (m + 3) + 2)))) v = e).
  { cbn [eval unary_real]; rewrite E; do 2 f_equal; unfold v.
    replace (2 * (m + 3) + 2)%nat with (Datatypes.S (Datatypes.S (List.length q + (m + 3 + 1)))) by lia; cbn [nth]; rewrite Far; reflexivity. }
  rewrite V2; assert (V3 : eval (Ebinary Mul (Evar 0) (Evar 2)) (e :: v) = n0).
  { cbn [eval binary_real]; unfold v; cbn [nth]; rewrite N0, S2, E; reflexivity. }
  rewrite V3; unfold last_of; cbn [seq map nth]; unfold v; repeat f_equal.
  cbn [eval binary_real nullary_real]; replace (2 * (m + 3) + 3)%nat with (3 + Datatypes.S (List.length q + (m + 3 + 0)))%nat by lia.
  cbn [nth Nat.add]; rewrite Far; cbn [nth]; rewrite A; unfold x; cbn [nth]; reflexivity.
Qed.
Theorem boxed_numbers : forall m inner outer ends cuts g d others n1 n0 a e,
  device g d n1 n0 a e ->
  checked_numbers m (List.length others) inner outer ends cuts = true -> Forall2 lies ends (g :: d :: others) ->
  forall t, (forall r s, eval outer (with_names inner (a :: n0 :: e :: n1 :: (g :: d :: others) ++ r :: s :: nil)) = t) ->
  0 < t.
Proof.
  intros m inner outer ends cuts g d others n1 n0 a e V C F t T; unfold checked_numbers in C.
  apply andb_prop in C; destruct C as [B C].
  assert (G := F); inversion G as [| G1 ? ends' ? Lg F']; subst; inversion F' as [| G2 ? ends'' ? Ld F'']; subst.
  simpl in B; apply andb_prop in B; destruct B as [Bg B]; apply andb_prop in B; destruct B as [Bd _].
  assert (K := small_side_holds m _ _ Bg Lg); assert (L := small_side_holds m _ _ Bd Ld).
  destruct (sampled m g d n1 n0 a e V) as (r & s & Pr & Ps & N1 & N0 & E & A).
  { replace (m + 4)%nat with (m + 2 + 2)%nat by lia; rewrite (plus_INR (m + 2)); simpl (INR 2); lra. }
  rewrite <- (T r s); clear t T.
  assert (O : eval (left_out_of m) (g :: d :: others) = left_out m g d).
  { unfold left_out, left_out_of, quotient; cbn [eval binary_real unary_real nullary_real nth]; rewrite factorial_is, <- pow_powerRZ; reflexivity. }
  rewrite <- O in Pr, Ps.
  assert (P := boxed _ _ _ _ _ _ _ _ (r :: s :: nil) C F ltac:(repeat (apply Forall2_cons; [assumption |]); apply Forall2_nil)).
  unfold all_names in P; cbn [app] in P; rewrite (names_of m g d others r s n1 n0 a e N1 N0 E A) in P; exact P.
Qed.
End Boxes.

(* Primitive floats, which are fast, and floats of 120 bits, for a difference of nearly equal terms. *)
Module Short <: Length PrimitiveFloat. Definition prec := PrimitiveFloat.PtoP 53. End Short.
Module Big := SpecificFloat BigIntRadix2.
Module Long <: Length Big. Definition prec := Big.PtoP 120. End Long.
Module Fast := Boxes PrimitiveFloat Short.
Module Exact := Boxes Big Long.

(* -- tactics ------------------------------------------------------------------------- *)

Ltac ends_expressed ends :=
  lazymatch ends with
  | nil => constr:(@nil (expr * expr))
  | (?a, ?b) :: ?more =>
      let x := expressed a (@nil R) in let y := expressed b (@nil R) in
      let es := ends_expressed more in constr:((x, y) :: es)
  end.

Lemma positive_as : forall t s : R, t = s -> 0 < s -> 0 < t.
Proof. intros t s E P; rewrite E; exact P. Qed.
(* Expressions for terms, each of those in a list and of the terms before it, and the list with them. *)
Ltac with_terms ts l :=
  lazymatch ts with
  | nil => constr:((@nil expr, l))
  | ?t :: ?ts =>
      let e := expressed t l in
      let more := with_terms ts constr:(t :: l) in
      lazymatch more with (?es, ?l) => constr:((e :: es, l)) end
  end.
(* On a box of xs between their ends, by a certificate. *)
Ltac sided :=
  repeat (apply Forall2_cons; [split; first [assumption | cbn; lra] |]); apply Forall2_nil.
Ltac in_pieces xs ends cuts :=
  let ends := ends_expressed ends in
  lazymatch goal with |- 0 < ?t =>
    let outer := expressed t xs in
    first
      [ exact (Fast.boxed nil nil 0 nil outer ends cuts xs nil ltac:(vm_compute; reflexivity) ltac:(sided) (Forall2_nil _))
      | exact (Exact.boxed nil nil 0 nil outer ends cuts xs nil ltac:(vm_compute; reflexivity) ltac:(sided) (Forall2_nil _)) ]
  end.
(* Of a device's numbers and of gamma, delta and others; vs are further terms that it names. *)
Ltac of_device vs xs ends cuts :=
  let ends := ends_expressed ends in
  lazymatch goal with V : device ?g ?d ?n1 ?n0 ?a ?e |- 0 < ?t =>
    lazymatch xs with _ :: _ :: ?others =>
      let terms := with_terms vs constr:(a :: n0 :: e :: n1 :: xs) in
      lazymatch terms with (?inner, ?l) =>
        let outer := expressed t l in
        first
          [ exact (Fast.boxed_numbers 14 inner outer ends cuts g d others n1 n0 a e V
              ltac:(vm_compute; reflexivity) ltac:(sided) t (fun r s => eq_refl t))
          | exact (Fast.boxed_numbers 40 inner outer ends cuts g d others n1 n0 a e V
              ltac:(vm_compute; reflexivity) ltac:(sided) t (fun r s => eq_refl t))
          | exact (Exact.boxed_numbers 40 inner outer ends cuts g d others n1 n0 a e V
              ltac:(vm_compute; reflexivity) ltac:(sided) t (fun r s => eq_refl t)) ]
      end
    end
  end.
Open Scope string_scope.
Open Scope R_scope.
