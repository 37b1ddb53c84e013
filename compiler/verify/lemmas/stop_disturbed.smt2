; lemma: stop_disturbed
; An ideal brake b against a push of at most d < b, from the speed s: the robot covers at most
; s^2 / (2 (b - d)) and stays within d s^2 / (2 b (b - d)) of the straight stop, the segment from p
; to p + v|v| / (2 b). Axes: x along the velocity, whose length is n; (px, py) is the push.
;
; How the steps make the lemma: the point q = p + v|v| / (2 b) where an undisturbed brake would stop
; moves with the rate of the first two steps. For every direction e, max(e p, e q) grows no faster
; than q moves (fourth step); so all of the way is within what q moves of the segment, which is the
; intersection of the half-planes e x <= max(e p0, e q0). Integration along the way by W and Y, whose
; rates outweigh those of q and of the way (third and fifth step).
; code: compiler/ir/module.h | return b.disturbance_mmps2 == 0 ? 0 : (1000 * b.disturbance_mmps2 + left_mmps2 - 1) / left_mmps2;
; code: compiler/codegen/kernel/motion.c | div_up(stop * b->sway_permille, 1000)

; step: the rate of q, v + (a|v| + v (v a)/|v|) / (2 b) under the acceleration a = -b v/|v| + push
; mistake: s/(\* 2 b qx) (+ (\* 2 b n) (\* ax n)/(* 2 b qx) (+ (* 4 b n) (* ax n)/
(set-logic QF_NRA)
(declare-const b Real) (declare-const n Real) (declare-const px Real) (declare-const py Real)
(declare-const ax Real) (declare-const ay Real) (declare-const qx Real) (declare-const qy Real)
(assert (> b 0)) (assert (> n 0))
(assert (= ax (- px b))) (assert (= ay py))
(assert (= (* 2 b qx) (+ (* 2 b n) (* ax n) (* n ax))))
(assert (= (* 2 b qy) (* ay n)))
; claim
(assert (not (and (= (* b qx) (* n px)) (= (* 2 b qy) (* n py)))))
(check-sat)
(reset)

; step: is at most d n / b long
; mistake: s/(assert (<= (+ (\* px px) (\* py py)) (\* d d)))/(assert (<= (+ (* px px) (* py py)) (* 2 d d)))/
(set-logic QF_NRA)
(declare-const b Real) (declare-const d Real) (declare-const n Real)
(declare-const px Real) (declare-const py Real) (declare-const qx Real) (declare-const qy Real)
(assert (> b 0)) (assert (>= d 0)) (assert (>= n 0))
(assert (<= (+ (* px px) (* py py)) (* d d)))
(assert (= (* b qx) (* n px))) (assert (= (* 2 b qy) (* n py)))
; claim
(assert (not (<= (* b b (+ (* qx qx) (* qy qy))) (* d d n n))))
(check-sat)
(reset)

; step: W = d n^2 / (2 b (b - d)) falls at least as fast, since the speed falls by b - d
; mistake: s/(\* rate b (- b d)) (\* d n fall)/(* rate b b) (* d n fall)/
(set-logic QF_NRA)
(declare-const b Real) (declare-const d Real) (declare-const n Real)
(declare-const fall Real) (declare-const rate Real)
(assert (>= d 0)) (assert (< d b)) (assert (>= n 0))
(assert (<= fall (- d b)))
(assert (= (* rate b (- b d)) (* d n fall)))
; claim
(assert (not (<= (+ (* b rate) (* d n)) 0)))
(check-sat)
(reset)

; step: max(e p, e q) rises no faster than q moves: where it is e p, the velocity leads away
; mistake: s/(assert (= (\* 2 b (- eq ep)) (\* n ev)))/(assert (= (* 2 b (- eq ep)) (* (- n) ev)))/
(set-logic QF_NRA)
(declare-const b Real) (declare-const n Real) (declare-const ev Real)
(declare-const ep Real) (declare-const eq Real)
(assert (> b 0)) (assert (> n 0))
(assert (= (* 2 b (- eq ep)) (* n ev)))
(assert (> ep eq))
; claim
(assert (not (<= ev 0)))
(check-sat)
(reset)

; step: and Y = n^2 / (2 (b - d)) falls by the way at least
; mistake: s/(assert (= (\* rate (- b d)) (\* n fall)))/(assert (= (* rate b) (* n fall)))/
(set-logic QF_NRA)
(declare-const b Real) (declare-const d Real) (declare-const n Real)
(declare-const fall Real) (declare-const rate Real)
(assert (>= d 0)) (assert (< d b)) (assert (>= n 0))
(assert (<= fall (- d b)))
(assert (= (* rate (- b d)) (* n fall)))
; claim
(assert (not (<= (+ rate n) 0)))
(check-sat)
(reset)

; step: as the kernel computes them: the stop s^2 / (2 b) and the share d / (b - d) of it are both
; mistake: s/(\* sway (- b d)) d/(* sway b) d/
(set-logic QF_NRA)
(declare-const b Real) (declare-const d Real) (declare-const s Real)
(declare-const sway Real) (declare-const stop Real)
(assert (>= d 0)) (assert (< d b)) (assert (>= s 0))
(assert (= (* sway (- b d)) d))
(assert (= (* 2 b stop) (* s s)))
; claim
(assert (not (and (= (* 2 (- b d) (+ stop (* sway stop))) (* s s))
                  (= (* 2 b (- b d) sway stop) (* d s s)))))
(check-sat)
(reset)
