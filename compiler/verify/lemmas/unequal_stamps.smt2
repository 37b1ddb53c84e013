; lemma: unequal_stamps
; A velocity that was measured a time `apart` before or after the place, as a velocity at the time of
; the place: wrong by e_v + A apart at most, for it has changed by A apart at most since (drift).
; Lengths of differences: `seen` of the measured velocity from the true one at its own stamp, `since`
; of that from the true one at the stamp of the place, `off` of the sum.
; code: compiler/codegen/kernel/motion.c | min_of(div_up(b->accel_mmps2 * apart_ms, 1000), 2 * SPEED_MAX_MMPS);

; step: the error
; mistake: s/(+ ev (\* A apart))/ev/
; mistake: s/(assert (>= apart (- tv tp)))//
(set-logic QF_NRA)
(declare-const tp Real) (declare-const tv Real) (declare-const apart Real)
(declare-const A Real) (declare-const ev Real)
(declare-const seen Real) (declare-const since Real) (declare-const off Real)
(assert (>= A 0))
(assert (>= apart (- tp tv))) (assert (>= apart (- tv tp)))
(assert (<= seen ev))
(assert (<= since (* A (ite (<= tp tv) (- tv tp) (- tp tv)))))
(assert (<= off (+ seen since)))
; claim
(assert (not (<= off (+ ev (* A apart)))))
(check-sat)
(reset)

; step: two velocities of at most Vm are 2 Vm apart, whatever lies between: the limit that the kernel
; step+ sets to keep its numbers small
; mistake: s/(\* 2 most)/most/
(set-logic QF_NRA)
(declare-const u Real) (declare-const w Real) (declare-const most Real) (declare-const since Real)
(assert (<= 0 u)) (assert (<= u most)) (assert (<= 0 w)) (assert (<= w most))
(assert (<= since (+ u w)))
; claim
(assert (not (<= since (* 2 most))))
(check-sat)
(reset)
