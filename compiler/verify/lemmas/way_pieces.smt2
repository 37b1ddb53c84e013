; lemma: way_pieces
; A way that is looked at piece by piece: the clearance of a place is at least that of another less
; their distance. So a piece of length l is clear by (c1 + c2 - l) / 2 with the clearances c1 and c2 of
; its ends, by c - l / 2 with that of its middle, and a cell by that of its worst place.
; code: runtime/core/space.cpp | const double middle_m = clearance_m(0.5 * (a + b));
; code: runtime/core/space.cpp | if (middle_m - length_m / 2 >= least_m || length_m <= 2 * loss_m) return true;

; step: between two ends: a place at s from the first one
; mistake: s/(\* 0.5 (- (+ c1 c2) l))/(* 0.5 (+ c1 c2))/
; mistake: s/(assert (>= c (- c2 (- l s))))//
(set-logic QF_LRA)
(declare-const c1 Real) (declare-const c2 Real) (declare-const l Real) (declare-const s Real)
(declare-const c Real)
(assert (<= 0 s)) (assert (<= s l))
(assert (>= c (- c1 s))) (assert (>= c (- c2 (- l s))))
; claim
(assert (not (>= c (* 0.5 (- (+ c1 c2) l)))))
(check-sat)
(reset)

; step: around the middle
; mistake: s/(\* 0.5 l)) need)/(* 0.2 l)) need)/
(set-logic QF_LRA)
(declare-const middle Real) (declare-const l Real) (declare-const s Real)
(declare-const c Real) (declare-const need Real)
(assert (<= (* 2 s) l)) (assert (<= (* (- 2) s) l))
(assert (>= c (- middle (ite (<= 0 s) s (- s)))))
(assert (>= (- middle (* 0.5 l)) need))
; claim
(assert (not (>= c need)))
(check-sat)
(reset)
