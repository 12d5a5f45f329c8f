(* Whether all zeros of a polynomial whose coefficients are numbers lie inside the unit circle: Rocq
   reduces it step by step as Schur did, with complex intervals of floats of any length. *)
From Symhaptic Require Export Boxes.
From Interval Require Import Xreal Interval Specific_bigint Specific_ops Float_full Tree Prog Eval Reify.
Import List Tree.
Open Scope list_scope.
Open Scope R_scope.

(* -- complex intervals ---------------------------------------------------------------- *)

Module Longs := Values Big.
Module Long := Longs.Ball.
Module L := Longs.J.
Notation long := Long.type.
Definition pair := (long * long)%type.
Definition within (X : pair) (c : C) : Prop := Longs.has (fst X) (Re c) /\ Longs.has (snd X) (Im c).

Section Precise.
Variable prec : Big.precision.
Definition plus_ (X Y : pair) : pair := (Long.add prec (fst X) (fst Y), Long.add prec (snd X) (snd Y)).
Definition minus_ (X Y : pair) : pair := (Long.sub prec (fst X) (fst Y), Long.sub prec (snd X) (snd Y)).
Definition opposite (X : pair) : pair := (Long.neg (fst X), Long.neg (snd X)).
Definition mirror (X : pair) : pair := (fst X, Long.neg (snd X)).
Definition product (X Y : pair) : pair :=
  (Long.sub prec (Long.mul prec (fst X) (fst Y)) (Long.mul prec (snd X) (snd Y)),
   Long.add prec (Long.mul prec (fst X) (snd Y)) (Long.mul prec (snd X) (fst Y))).
Definition norm_ (X : pair) : long :=
  Long.add prec (Long.mul prec (fst X) (fst X)) (Long.mul prec (snd X) (snd X)).
Definition inverse (X : pair) : pair :=
  (Long.div prec (fst X) (norm_ X), Long.div prec (Long.neg (snd X)) (norm_ X)).
Definition exponential (X : pair) : pair :=
  let size := Long.exp prec (fst X) in
  (Long.mul prec size (Long.cos prec (snd X)), Long.mul prec size (Long.sin prec (snd X))).
Definition nothing : pair := (Long.zero, Long.zero).
Definition anything : pair := (Long.nai, Long.nai).

Lemma within_plus : forall X c Y d, within X c -> within Y d -> within (plus_ X Y) (c + d)%C.
Proof. intros X c Y d [P Q] [U V]; split; apply L.add_correct; assumption. Qed.
Lemma within_minus : forall X c Y d, within X c -> within Y d -> within (minus_ X Y) (c - d)%C.
Proof. intros X c Y d [P Q] [U V]; split; apply L.sub_correct; assumption. Qed.
Lemma within_opposite : forall X c, within X c -> within (opposite X) (- c)%C.
Proof. intros X c [P Q]; split; apply L.neg_correct; assumption. Qed.
Lemma within_mirror : forall X c, within X c -> within (mirror X) (Cconj c).
Proof. intros X c [P Q]; split; [exact P | apply L.neg_correct; exact Q]. Qed.
Lemma within_product : forall X c Y d, within X c -> within Y d -> within (product X Y) (c * d)%C.
Proof.
  intros X c Y d [P Q] [U V]; split; [apply L.sub_correct | apply L.add_correct]; apply L.mul_correct; assumption.
Qed.
Definition square (c : C) : R := Re c * Re c + Im c * Im c.
Lemma has_norm : forall X c, within X c -> Longs.has (norm_ X) (square c).
Proof. intros X c [P Q]; apply L.add_correct; apply L.mul_correct; assumption. Qed.
Lemma within_inverse : forall X c, within X c -> within (inverse X) (/ c)%C.
Proof.
  intros X c P; assert (N := has_norm X c P); destruct P as [P Q].
  assert (E : fst c ^ 2 + snd c ^ 2 = square c) by (unfold square, Re, Im; ring).
  split.
  - change (Re (/ c)%C) with (fst c / (fst c ^ 2 + snd c ^ 2)); rewrite E; apply L.div_correct; assumption.
  - change (Im (/ c)%C) with (- snd c / (fst c ^ 2 + snd c ^ 2)); rewrite E.
    apply L.div_correct; [apply L.neg_correct |]; assumption.
Qed.
Lemma within_exponential : forall X c, within X c -> within (exponential X) (Cexp c).
Proof.
  intros X c [P Q]; split; simpl; apply L.mul_correct;
    [apply L.exp_correct | apply L.cos_correct | apply L.exp_correct | apply L.sin_correct]; assumption.
Qed.
Lemma within_nothing : within nothing (RtoC 0).
Proof. split; apply L.zero_correct. Qed.
Lemma within_anything : forall c, within anything c.
Proof. intro c; split; apply L.nai_correct. Qed.

(* -- polynomials ---------------------------------------------------------------------- *)

Fixpoint products {T} (zero : T) (add mul : T -> T -> T) (a b : list T) : list T :=
  match a with
  | nil => nil
  | x :: more => termwise add (map (mul x) b) (zero :: products zero add mul more b)
  end.
Lemma poly_sum : forall a b z, poly (termwise Cplus a b) z = (poly a z + poly b z)%C.
Proof.
  induction a as [| x a IH]; intros [| y b] z; simpl; try ring; rewrite IH; ring.
Qed.
Lemma poly_times : forall x b z, poly (map (Cmult x) b) z = (x * poly b z)%C.
Proof. intros x b z; induction b as [| y b IH]; simpl; [| rewrite IH]; ring. Qed.
Lemma poly_products : forall a b z, poly (products (RtoC 0) Cplus Cmult a b) z = (poly a z * poly b z)%C.
Proof.
  induction a as [| x a IH]; intros b z; simpl; [ring |].
  rewrite poly_sum, poly_times; simpl; rewrite IH; ring.
Qed.
Lemma within_sum : forall A a B b, Forall2 within A a -> Forall2 within B b ->
  Forall2 within (termwise plus_ A B) (termwise Cplus a b).
Proof.
  intros A a B b F; revert B b; induction F; intros B b G; [exact G |].
  destruct G; simpl; constructor; auto using within_plus.
Qed.
Lemma within_map : forall (f : pair -> pair) (g : C -> C) A a, (forall X c, within X c -> within (f X) (g c)) ->
  Forall2 within A a -> Forall2 within (map f A) (map g a).
Proof. intros f g A a H F; induction F; simpl; constructor; auto. Qed.
Lemma within_products : forall A a B b, Forall2 within A a -> Forall2 within B b ->
  Forall2 within (products nothing plus_ product A B) (products (RtoC 0) Cplus Cmult a b).
Proof.
  intros A a B b F G; induction F; simpl; [constructor |].
  apply within_sum; [apply within_map; [| exact G] | constructor; [apply within_nothing | assumption]].
  intros X c P; apply within_product; assumption.
Qed.

(* -- polynomials as they are written -------------------------------------------------- *)

Inductive written :=
  | Variable_ | Number (e : expr) | Imaginary | Plus (a b : written) | Minus (a b : written) | Opposite (a : written)
  | Times (a b : written) | Inverse (a : written) | Power (a : written) (n : nat) | Exponential (a : written).
Fixpoint meant (t : written) (z : C) : C :=
  match t with
  | Variable_ => z
  | Number e => RtoC (eval e nil)
  | Imaginary => Ci
  | Plus a b => (meant a z + meant b z)%C
  | Minus a b => (meant a z - meant b z)%C
  | Opposite a => (- meant a z)%C
  | Times a b => (meant a z * meant b z)%C
  | Inverse a => (/ meant a z)%C
  | Power a n => (meant a z ^ n)%C
  | Exponential a => Cexp (meant a z)
  end.
Fixpoint constant (t : written) : bool :=
  match t with
  | Variable_ => false
  | Number _ | Imaginary => true
  | Plus a b | Minus a b | Times a b => constant a && constant b
  | Opposite a | Inverse a | Power a _ | Exponential a => constant a
  end.
Definition one : pair := (Long.fromZ prec 1, Long.zero).
Fixpoint repeated {T} (one : T) (mul : T -> T -> T) (x : T) (n : nat) : T :=
  match n with O => one | S m => mul x (repeated one mul x m) end.
Fixpoint number (t : written) : pair :=
  match t with
  | Variable_ => anything
  | Number e => (Longs.value_of prec e nil, Long.zero)
  | Imaginary => (Long.zero, Long.fromZ prec 1)
  | Plus a b => plus_ (number a) (number b)
  | Minus a b => minus_ (number a) (number b)
  | Opposite a => opposite (number a)
  | Times a b => product (number a) (number b)
  | Inverse a => inverse (number a)
  | Power a n => repeated one product (number a) n
  | Exponential a => exponential (number a)
  end.
(* Of what is no polynomial nothing is known. *)
Fixpoint balls (t : written) : list pair :=
  if constant t then number t :: nil
  else
    match t with
    | Variable_ => nothing :: one :: nil
    | Plus a b => termwise plus_ (balls a) (balls b)
    | Minus a b => termwise plus_ (balls a) (map opposite (balls b))
    | Opposite a => map opposite (balls a)
    | Times a b => products nothing plus_ product (balls a) (balls b)
    | Power a n => repeated (one :: nil) (products nothing plus_ product) (balls a) n
    | _ => nil
    end.
Fixpoint polynomial (t : written) : bool :=
  constant t ||
  match t with
  | Variable_ => true
  | Plus a b | Minus a b | Times a b => polynomial a && polynomial b
  | Opposite a | Power a _ => polynomial a
  | _ => false
  end.

Lemma within_one : within one (RtoC 1).
Proof. split; [apply Long.fromZ_correct | apply L.zero_correct]. Qed.
Lemma within_number : forall t z, within (number t) (meant t z).
Proof.
  intros t z; induction t; simpl; auto using within_anything, within_plus, within_minus, within_opposite,
    within_product, within_inverse, within_exponential.
  - split; [apply Longs.has_value; intros [|]; apply L.nai_correct | apply L.zero_correct].
  - split; [apply L.zero_correct | apply Long.fromZ_correct].
  - induction n as [| n IH]; simpl; [apply within_one | apply within_product; assumption].
Qed.
Lemma constant_there : forall t y z, constant t = true -> meant t y = meant t z.
Proof.
  intros t y z; induction t; simpl; intro E; try discriminate; try reflexivity;
    try (apply andb_prop in E; destruct E as [E G]; rewrite IHt1, IHt2 by assumption; reflexivity);
    rewrite IHt by exact E; reflexivity.
Qed.
Lemma poly_opposite : forall a z, poly (map Copp a) z = (- poly a z)%C.
Proof. intros a z; induction a as [| x a IH]; simpl; [| rewrite IH]; ring. Qed.
Lemma constant_holds : forall t, constant t = true ->
  exists a, Forall2 within (balls t) a /\ forall z, meant t z = poly a z.
Proof.
  intros t K; exists (meant t (RtoC 0) :: nil); split.
  - replace (balls t) with (number t :: nil) by (destruct t; simpl in *; rewrite ?K; congruence).
    constructor; [apply within_number | constructor].
  - intro z; simpl; rewrite (constant_there t z (RtoC 0) K); ring.
Qed.
Lemma balls_hold : forall t, polynomial t = true ->
  exists a, Forall2 within (balls t) a /\ forall z, meant t z = poly a z.
Proof.
  induction t; intro P;
    match goal with |- context [balls ?t] =>
      destruct (constant t) eqn:K; [exact (constant_holds t K) |] end;
    simpl in P, K |- *; rewrite ?K in *; simpl in P; try discriminate;
    try (apply andb_prop in P; destruct P as [P Q];
      destruct (IHt1 P) as (a & A & M), (IHt2 Q) as (b & B & N));
    try destruct (IHt P) as (a & A & M).
  - exists (RtoC 0 :: RtoC 1 :: nil); split; [repeat constructor; apply within_nothing || apply within_one |].
    intro z; simpl; ring.
  - exists (termwise Cplus a b); split; [apply within_sum; assumption |].
    intro z; rewrite poly_sum, M, N; reflexivity.
  - exists (termwise Cplus a (map Copp b)); split.
    + apply within_sum; [exact A | apply within_map; [exact within_opposite | exact B]].
    + intro z; rewrite poly_sum, poly_opposite, M, N; ring.
  - exists (map Copp a); split; [apply within_map; [exact within_opposite | exact A] |].
    intro z; rewrite poly_opposite, M; reflexivity.
  - exists (products (RtoC 0) Cplus Cmult a b); split; [apply within_products; assumption |].
    intro z; rewrite poly_products, M, N; reflexivity.
  - clear P K; induction n as [| n (c & B & N)]; simpl.
    + exists (RtoC 1 :: nil); split; [repeat constructor; apply within_one | intro z; simpl; ring].
    + exists (products (RtoC 0) Cplus Cmult a c); split; [apply within_products; assumption |].
      intro z; rewrite poly_products, <- M, <- N; reflexivity.
Qed.

(* -- the reduction -------------------------------------------------------------------- *)

Definition above_ (X : long) : bool := match Long.sign_strict X with Xgt => true | _ => false end.
Definition smaller (X Y : pair) : bool := above_ (Long.sub prec (norm_ Y) (norm_ X)).
Definition reduced_ (A : list pair) : list pair :=
  let K := product (hd nothing A) (inverse (mirror (last A nothing))) in
  tl (map (fun X => minus_ (fst X) (product K (mirror (snd X)))) (combine A (rev A))).
Fixpoint inside (steps : nat) (A : list pair) : bool :=
  match steps, A with
  | Datatypes.S more, first :: next =>
      above_ (norm_ (last A nothing)) &&
      match next with
      | nil => true
      | _ => smaller first (last A nothing) && inside more (reduced_ A)
      end
  | _, _ => false
  end.
Fixpoint outside (steps : nat) (A : list pair) : bool :=
  match steps, A with
  | Datatypes.S more, first :: _ :: _ =>
      above_ (norm_ (last A nothing)) &&
      (smaller (last A nothing) first || outside more (reduced_ A))
  | _, _ => false
  end.

Lemma above_holds : forall X x, Longs.has X x -> above_ X = true -> 0 < x.
Proof.
  intros X x P A; unfold above_ in A; destruct (Long.sign_strict X) eqn:N; try discriminate.
  assert (M := Long.sign_strict_correct X); rewrite N in M; apply (M (Xreal x) P).
Qed.
Lemma smaller_holds : forall X c Y d, within X c -> within Y d -> smaller X Y = true -> Cmod c < Cmod d.
Proof.
  intros X c Y d P Q S; assert (L : 0 < square d - square c).
  { apply (above_holds (Long.sub prec (norm_ Y) (norm_ X))); [| exact S].
    apply L.sub_correct; apply has_norm; assumption. }
  unfold Cmod; apply sqrt_lt_1_alt; unfold square, Re, Im in L; split; [| lra].
  apply Rplus_le_le_0_compat; apply pow2_ge_0.
Qed.
Lemma apart_holds : forall X c, within X c -> above_ (norm_ X) = true -> c <> RtoC 0.
Proof.
  intros X c P A E; assert (L := above_holds _ _ (has_norm X c P) A).
  rewrite E in L; unfold square in L; simpl in L; lra.
Qed.
Lemma within_last : forall A a, Forall2 within A a -> within (last A nothing) (last a (RtoC 0)).
Proof.
  intros A a F; induction F as [| X x A a P F IH]; [apply within_nothing |].
  destruct F; [exact P | exact IH].
Qed.
Lemma within_hd : forall A a, Forall2 within A a -> within (hd nothing A) (hd (RtoC 0) a).
Proof. intros A a F; destruct F; [apply within_nothing | assumption]. Qed.
Lemma within_rev : forall A a, Forall2 within A a -> Forall2 within (rev A) (rev a).
Proof.
  intros A a F; induction F; simpl; [constructor | apply Forall2_app; [assumption |]].
  constructor; [assumption | constructor].
Qed.
Lemma within_reduced : forall A a, Forall2 within A a -> Forall2 within (reduced_ A) (reduced a).
Proof.
  intros A a F; unfold reduced_, reduced.
  assert (K : within (product (hd nothing A) (inverse (mirror (last A nothing))))
    (hd (RtoC 0) a / Cconj (last a (RtoC 0)))%C).
  { apply within_product; [apply within_hd, F | apply within_inverse, within_mirror, within_last, F]. }
  set (k := (hd (RtoC 0) a / Cconj (last a (RtoC 0)))%C) in *; clearbody k.
  set (Q := product _ _) in *; clearbody Q; assert (G := within_rev A a F).
  assert (H : Forall2 within (map (fun X => minus_ (fst X) (product Q (mirror (snd X)))) (combine A (rev A)))
    (map (fun x => fst x - k * Cconj (snd x))%C (combine a (rev a)))).
  { revert G; generalize (rev A) (rev a); induction F; intros B b G; simpl; [constructor |].
    destruct G; simpl; constructor; [| auto].
    apply within_minus; [assumption | apply within_product; [exact K | apply within_mirror; assumption]]. }
  destruct H; [constructor | assumption].
Qed.
Lemma inside_holds : forall steps A a, Forall2 within A a -> inside steps A = true -> stable (poly a).
Proof.
  induction steps as [| steps IH]; intros A a F E; destruct F as [| X x A a P F]; try discriminate.
  simpl in E; apply andb_prop in E; destruct E as [E G].
  assert (F' := Forall2_cons X x P F); apply schur.
  - apply (apart_holds (last (X :: A) nothing)); [apply within_last, F' | exact E].
  - destruct F as [| Y y A a Q F]; [left; reflexivity | right].
    apply andb_prop in G; destruct G as [G N]; split.
    + apply (smaller_holds X _ (last (X :: Y :: A) nothing)); [exact P | apply within_last, F' | exact G].
    + apply (IH (reduced_ (X :: Y :: A))); [apply within_reduced, F' | exact N].
Qed.
Lemma outside_holds : forall steps A a, Forall2 within A a -> outside steps A = true -> ~ stable (poly a).
Proof.
  induction steps as [| steps IH]; intros A a F E S; destruct F as [| X x A a P F]; try discriminate.
  destruct F as [| Y y A a Q F]; try discriminate.
  assert (F' := Forall2_cons X x P (Forall2_cons Y y Q F)).
  simpl in E; apply andb_prop in E; destruct E as [E G].
  apply schur in S; [destruct S as [S | [S T]]; [discriminate |] |].
  - apply orb_prop in G; destruct G as [G | G].
    + apply (Rlt_irrefl (Cmod x)); apply Rlt_trans with (1 := S).
      apply (smaller_holds (last (X :: Y :: A) nothing) _ X); [apply within_last, F' | exact P | exact G].
    + apply (IH _ _ (within_reduced _ _ F') G T).
  - apply (apart_holds (last (X :: Y :: A) nothing)); [apply within_last, F' | exact E].
Qed.
Definition all_inside (t : written) : bool :=
  polynomial t && let A := balls t in inside (List.length A) A.
Definition not_all_inside (t : written) : bool :=
  polynomial t && let A := balls t in outside (List.length A) A.
Lemma as_written : forall t, polynomial t = true -> exists a, Forall2 within (balls t) a /\ meant t = poly a.
Proof.
  intros t P; destruct (balls_hold t P) as (a & A & M); exists a; split; [exact A |].
  apply functional_extensionality; exact M.
Qed.
Theorem zeros_inside : forall t, all_inside t = true -> stable (meant t).
Proof.
  intros t E; apply andb_prop in E; destruct E as [P E]; destruct (as_written t P) as (a & A & M).
  rewrite M; exact (inside_holds _ _ _ A E).
Qed.
Theorem zero_outside : forall t, not_all_inside t = true -> ~ stable (meant t).
Proof.
  intros t E; apply andb_prop in E; destruct E as [P E]; destruct (as_written t P) as (a & A & M).
  rewrite M; exact (outside_holds _ _ _ A E).
Qed.
End Precise.

(* -- tactics -------------------------------------------------------------------------- *)

Ltac polynomial_in z t :=
  lazymatch t with
  | z => constr:(Variable_)
  | RtoC ?x => let e := reify x (@nil R) in constr:(Number e)
  | Ci => constr:(Imaginary)
  | Cplus ?a ?b => let p := polynomial_in z a in let q := polynomial_in z b in constr:(Plus p q)
  | Cminus ?a ?b => let p := polynomial_in z a in let q := polynomial_in z b in constr:(Minus p q)
  | Copp ?a => let p := polynomial_in z a in constr:(Opposite p)
  | Cmult ?a ?b => let p := polynomial_in z a in let q := polynomial_in z b in constr:(Times p q)
  | Cdiv ?a ?b => let p := polynomial_in z a in let q := polynomial_in z b in constr:(Times p (Inverse q))
  | Cpower ?a ?n => let p := polynomial_in z a in constr:(Power p n)
  | Cexp ?a => let p := polynomial_in z a in constr:(Exponential p)
  end.
(* With floats of so many bits. *)
Ltac zeros_with holds bits t :=
  apply (holds (Big.PtoP bits) t); vm_cast_no_check (eq_refl true).
Ltac zeros bits :=
  let body f := constr:(ltac:(let z := fresh "z" in intro z; let b := eval cbv beta in (f z) in
    let t := polynomial_in z b in exact t) : C -> written) in
  lazymatch goal with
  | |- stable ?f => let t := body f in let t := eval cbv beta in (t (RtoC 0)) in zeros_with zeros_inside bits t
  | |- ~ stable ?f => let t := body f in let t := eval cbv beta in (t (RtoC 0)) in zeros_with zero_outside bits t
  end.
