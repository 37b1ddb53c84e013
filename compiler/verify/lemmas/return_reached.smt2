; lemma: return_reached
; Where a robot that stands passes the return condition in spite of noise: its centre has the true
; clearance e_p + R(e_v + A apart), R(n) = e_p + S + s1^2 / (2 (b - d)) + tube being the radius of the
; disc with the measured speed n, `apart` the most that two stamps may be apart.
; code: compiler/analysis/limits.cpp | return disc_mm(b, decision.motions[0], b.velocity_error_mmps + apart_mmps(b), t_us) + std::max(b.position_error_mm, seen_mm);

; step: a boundary is no more than e_p nearer to the measured place than to the true one
; mistake: s/(assert (<= off ep))/(assert (<= off (* 2 ep)))/
(set-logic QF_NRA)
(declare-const true_gap Real) (declare-const seen_gap Real) (declare-const off Real)
(declare-const ep Real) (declare-const disc Real) (declare-const least Real)
(assert (>= ep 0)) (assert (>= off 0)) (assert (<= off ep))
(assert (>= seen_gap (- true_gap off)))
(assert (>= true_gap (+ ep disc least)))
; claim
(assert (not (>= (- seen_gap disc least) 0)))
(check-sat)
(reset)

; step: at rest no more than e_v is measured, and the disc counts no more than the lemma does
; mistake: s/(assert (<= seen ev))/(assert (<= seen (* 3 ev)))/
; mistake: s/(assert (<= late apart))/(assert (<= late (* 2 apart)))/
(set-logic QF_NRA)
(declare-const A Real) (declare-const ev Real) (declare-const seen Real)
(declare-const late Real) (declare-const apart Real)
(assert (>= A 0)) (assert (>= ev 0)) (assert (<= 0 seen)) (assert (<= seen ev))
(assert (<= 0 late)) (assert (<= late apart))
; claim
(assert (not (<= (+ seen (+ ev (* A late))) (+ (+ ev (* A apart)) ev))))
(check-sat)
(reset)
