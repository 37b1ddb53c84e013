; lemma: stop_difference
; | u|u| - v|v| | <= (|u| + |v|) |u - v|, in the plane and in space. Two robots that brake with b
; stop v|v| / (2 b) from where they are: so far apart are the ways of two velocities.
; code: compiler/codegen/kernel/motion.c | return by_error + by_accel + braked_mm(s->speed_mmps + s1, drift, b);
; code: compiler/codegen/kernel/motion.c | return div_up(v * w, 2 * b->brake_mmps2);
; code: compiler/codegen/kernel/command.c | div_up((fastest + s1) * drift, 2 * b->brake_mmps2)

; step: squared, with m = |u|, n = |v| and their inner product c
; mistake: s/(\* (+ m n) (+ m n)/(* m m/
; mistake: s/(<= (\* c c) (\* m m n n))/(<= c (* 2 m n))/
(set-logic QF_NRA)
(declare-const m Real) (declare-const n Real) (declare-const c Real)
(assert (>= m 0)) (assert (>= n 0)) (assert (<= (* c c) (* m m n n)))
; claim
(assert (not (<= (+ (* m m m m) (* n n n n) (* (- 2) m n c))
                 (* (+ m n) (+ m n) (+ (* m m) (* n n) (* (- 2) c))))))
(check-sat)
(reset)
