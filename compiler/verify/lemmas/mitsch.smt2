; lemma: mitsch
; Without noise, cap and push the radius of the disc is that of the static safety of Mitsch, Ghorbal,
; Vogelbacher, Platzer: Formal verification of obstacle avoidance and navigation of ground robots
; (IJRR 2017), Theorem 1: v^2 / (2 b) + (A / b + 1)(A T^2 / 2 + T v). With an agent of the speed V_o,
; until the robot stands, it is that of passive safety, Theorem 2: v^2 / (2 b) + V_o v / b +
; (A / b + 1)(A T^2 / 2 + T (v + V_o)). So either is a case of the formulas of the kernel.
; code: compiler/codegen/kernel/motion.c | const int64_t stop = braked_mm(s1, s1, b);
; code: compiler/codegen/kernel/motion.c | return div_up(v * w, 2 * b->brake_mmps2);

; step: Theorem 1, times 2 b
; mistake: s/(+ A b) (+ (\* 0.5 A T T)/(+ A b) (+ (* A T T)/
; mistake: s/(= s1 (+ v (\* A T)))/(= s1 v)/
(set-logic QF_NRA)
(declare-const v Real) (declare-const A Real) (declare-const b Real) (declare-const T Real)
(declare-const s1 Real) (declare-const way Real)
(assert (> b 0)) (assert (>= A 0)) (assert (>= T 0)) (assert (>= v 0))
(assert (= s1 (+ v (* A T)))) (assert (= way (+ (* v T) (* 0.5 A T T))))
; claim
(assert (not (= (+ (* 2 b way) (* s1 s1))
                (+ (* v v) (* 2 (+ A b) (+ (* 0.5 A T T) (* T v)))))))
(check-sat)
(reset)

; step: Theorem 2, times 2 b: V_o for T and s1 / b
; mistake: s/(\* 2 Vo s1)/(* 2 Vo v)/
; mistake: s/(\* 2 Vo b T) (\* 2 Vo s1)/(* 2 Vo s1)/
(set-logic QF_NRA)
(declare-const v Real) (declare-const A Real) (declare-const b Real) (declare-const T Real)
(declare-const s1 Real) (declare-const way Real) (declare-const Vo Real)
(assert (> b 0)) (assert (>= A 0)) (assert (>= T 0)) (assert (>= v 0)) (assert (>= Vo 0))
(assert (= s1 (+ v (* A T)))) (assert (= way (+ (* v T) (* 0.5 A T T))))
; claim
(assert (not (= (+ (* 2 b way) (* s1 s1) (* 2 Vo b T) (* 2 Vo s1))
                (+ (* v v) (* 2 Vo v)
                   (* 2 (+ A b) (+ (* 0.5 A T T) (* T (+ v Vo))))))))
(check-sat)
(reset)
