; lemma: energy
; The charge that is left when a recovery takes over suffices for the way from wherever the robot may
; be then, when the measured charge does for the dearest place within its reach, with what the time
; since the sample and the horizon take at most.
; code: compiler/codegen/kernel/checks.c | return span_of(battery->lo - error_ppm - div_up(drain_ppm_per_s * div_up(age_us, 1000), 1000),
; code: compiler/codegen/kernel/checks.c | const int64_t spare = charge.lo - way.hi - reserve_ppm - div_up(drain_ppm_per_s * div_up(horizon_us, 1000), 1000);
; code: compiler/codegen/kernel/checks.c | charge.lo - least_ppm - div_up(drain_ppm_per_s * div_up(horizon_us, 1000), 1000);

; step: a charge that was `seen` with an error, has run down since, and goes on doing so until t
; mistake: s/(\* P age)) (\* P ahead)/(* P 0)) (* P ahead)/
; mistake: s/(assert (<= t ahead))//
; mistake: s/(assert (<= home dearest))//
; mistake: s/(assert (>= was (- seen err)))/(assert (>= was (- seen err err)))/
(set-logic QF_NRA)
(declare-const seen Real) (declare-const err Real) (declare-const was Real) (declare-const P Real)
(declare-const age Real) (declare-const ahead Real) (declare-const t Real) (declare-const left Real)
(declare-const dearest Real) (declare-const home Real) (declare-const reserve Real)
(assert (>= P 0)) (assert (>= err 0)) (assert (>= age 0)) (assert (<= 0 t)) (assert (<= t ahead))
(assert (>= was (- seen err)))
(assert (>= left (- was (* P (+ age t)))))
(assert (<= home dearest))
(assert (>= (- (- seen err (* P age)) (* P ahead) dearest reserve) 0))
; claim
(assert (not (>= left (+ home reserve))))
(check-sat)
(reset)

; step: the cells that the reach touches hold the one where the robot is: on either axis, with whole
; step+ numbers of cells of the width w
; mistake: s/(assert (<= (- x p) r))//
; mistake: s/(assert (<= (- p x) r))//
(set-logic QF_NRA)
(declare-const x Real) (declare-const p Real) (declare-const r Real) (declare-const w Real)
(declare-const cell Real) (declare-const first Real) (declare-const last Real)
(define-fun whole ((a Real) (b Real)) Bool (or (<= a b) (>= a (+ b 1))))
(assert (> w 0)) (assert (<= (- p x) r)) (assert (<= (- x p) r))
(assert (whole first cell)) (assert (whole cell last))
(assert (<= (* w cell) x)) (assert (< x (* w (+ cell 1))))
(assert (<= (* w first) (- p r))) (assert (< (- p r) (* w (+ first 1))))
(assert (<= (* w last) (+ p r))) (assert (< (+ p r) (* w (+ last 1))))
; claim
(assert (not (and (<= first cell) (<= cell last))))
(check-sat)
(reset)
