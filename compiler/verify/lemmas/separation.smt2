; lemma: separation
; Two robots each with a set of centres, a segment or a point, and a radius within which all of its
; body stays, errors and tube included. Sets that are as far apart as both radii and `least` keep the
; bodies `least` apart: point or segment, in all four combinations. And a robot whose check fails has
; to brake, no more: whichever passed last counted with it.
; code: compiler/codegen/kernel/checks.c | int64_t spare = point_gap_lo(r->p, o->s.p) - r->disc_mm - axis;
; code: compiler/codegen/kernel/checks.c | segment_gap_lo(r->p, r->e, o->r.p, o->r.e) - r->capsule_mm - o->r.capsule_mm);
; code: compiler/codegen/kernel/mode.c | if (pair_spare(r, &others[j], b) < least_mm) {

; step: places within their radii of places of the sets, on a line; the triangle inequality (norms)
; step+ is what makes it one
; mistake: s/(+ mine theirs least)/(+ mine least)/
; mistake: s/(>= left (- centres a b))/(>= left (- centres a b b))/
(set-logic QF_NRA)
(declare-const centres Real) (declare-const mine Real) (declare-const theirs Real)
(declare-const least Real) (declare-const a Real) (declare-const b Real) (declare-const left Real)
(assert (<= 0 a)) (assert (<= a mine)) (assert (<= 0 b)) (assert (<= b theirs))
(assert (>= centres (+ mine theirs least)))
(assert (>= left (- centres a b)))
; claim
(assert (not (>= left least)))
(check-sat)
(reset)

; step: the same in the plane, with coordinates: x and y are the bodies, c and e the centres
; mistake: s/(\* (+ m n l) (+ m n l))/(* (+ m l) (+ m l))/
(set-logic QF_NRA)
(declare-const xc Real) (declare-const yc Real) (declare-const xe Real) (declare-const ye Real)
(declare-const m Real) (declare-const n Real) (declare-const l Real) (declare-const d Real)
(assert (> m 0)) (assert (> n 0)) (assert (>= l 0))
(assert (<= (+ (* xc xc) (* yc yc)) (* m m)))
(assert (<= (+ (* (- xe d) (- xe d)) (* ye ye)) (* n n)))
(assert (>= d 0)) (assert (>= (* d d) (* (+ m n l) (+ m n l))))
; claim
(assert (not (>= (+ (* (- xe xc) (- xe xc)) (* (- ye yc) (- ye yc))) (* l l))))
(check-sat)
(reset)

; step: let the other one's check pass last, at `mine` (and mine passed at `theirs` <= it). My brake
; step+ acts by my next tick and my latency, and that is within what the other one counted me with
; step+ from my sample on: its age there, my period, jitter and latency
; mistake: s/(assert (<= theirs last))//
; mistake: s/(+ (- last stamp) lookahead jitter latency)/(+ (- last stamp) latency)/
(set-logic QF_NRA)
(declare-const theirs Real) (declare-const last Real) (declare-const stamp Real)
(declare-const acts Real) (declare-const lookahead Real) (declare-const jitter Real)
(declare-const latency Real)
(assert (> lookahead 0)) (assert (>= jitter 0)) (assert (>= latency 0))
(assert (<= stamp last)) (assert (<= theirs last))
(assert (<= acts (+ theirs lookahead jitter latency)))
; claim
(assert (not (<= (- acts stamp) (+ (- last stamp) lookahead jitter latency))))
(check-sat)
(reset)

; step: a robot that holds its place stays within e_p and hold of where it is measured, for as long
; step+ as it promises; a promise beyond the horizon outlasts what the check looks at
; mistake: s/(assert (>= lease (+ now horizon)))/(assert (>= lease now))/
(set-logic QF_NRA)
(declare-const now Real) (declare-const horizon Real) (declare-const lease Real)
(declare-const t Real)
(assert (>= horizon 0)) (assert (>= lease (+ now horizon)))
(assert (>= t now)) (assert (<= t (+ now horizon)))
; claim
(assert (not (<= t lease)))
(check-sat)
(reset)
