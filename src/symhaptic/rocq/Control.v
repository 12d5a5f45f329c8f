(* What is said of loops, walls and devices, and what is known of it; and the tactics that apply the
   theorems on zeros to polynomials as chapters write them. *)
From Symhaptic Require Export HalfPlane.
Open Scope R_scope.

(* What is not defined here yet; what is known of it stands in the axioms.  A function of z stands
   for a transfer function. *)
Parameter passive : (C -> C) -> C -> Prop.
Parameter answers : (C -> C) -> C -> C -> C -> Prop.
Parameter passive_wall stable_loop stable_substituted stable_principal :
  C -> C -> C -> C -> C -> Prop.
Parameter passive_device : (C -> C) -> C -> C -> C -> C -> C -> Prop.
Parameter pole device : C -> C -> C -> C -> C -> C -> Prop.
Parameter late_device : C -> C -> C -> C -> C -> C -> C -> C -> Prop.
Parameter swings : C -> C -> C -> C -> Prop.

(* A motion at constant speeds, piece by piece (time in periods, way), from rest at 0; the force that
   a wall holds from k + late on is K x_k + B (x_k - x_(k-1))/T.  All of it but K, B and b is rational. *)
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

(* What the predicate means: a motion that gains energy. *)
Axiom rule_gains : forall (K B b T d : R) (late : QArith_base.Q) (motion : list _),
  d = Q2R late -> 0 <= b -> 0 < T -> QArith_base.Qle_bool (QArith_base.inject_Z 0) late = true ->
  Motion.forwards motion = true -> Motion.energy K B b T late motion < 0 ->
  ~ passive_wall K B b T d.
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
Ltac turned_value := rewrite turned; known_values; Ccompared.
Ltac summed_powers := rewrite ?Cpower_one; repeat rewrite Cpower_plus; cbn [Cpower]; summed.
Ltac taken := opened; first [assumption | apply f_equal; assumption].
Ltac apart_by :=
  first [assumption |
    match goal with A : ?x <> ?y |- _ <> RtoC 0 =>
      let Q := fresh in intro Q; apply A, RtoC_inj; rewrite <- Q; summed
    end].
(* (-1)^n is its own inverse. *)
Lemma sign_square : forall n, ((- RtoC 1) ^ n * (- RtoC 1) ^ n = RtoC 1)%C.
Proof. intro n; rewrite <- Cpower_product; replace (- RtoC 1 * - RtoC 1)%C with (RtoC 1) by ring; apply Cpower_one. Qed.
Lemma sign_apart : forall n, ((- RtoC 1) ^ n)%C <> RtoC 0.
Proof. intros n E; assert (S := sign_square n); rewrite E in S; apply (f_equal fst) in S; simpl in S; lra. Qed.
Lemma Cpower_opposite : forall z n, ((- z) ^ n = (- RtoC 1) ^ n * z ^ n)%C.
Proof. intros z n; rewrite <- Cpower_product; f_equal; ring. Qed.
Ltac opposed :=
  let z := fresh "z" in
  intro z; cbv beta; natural_powers; repeat rewrite Cpower_plus; repeat rewrite (Cpower_opposite z); cbn [Cpower]; Cpushed;
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
