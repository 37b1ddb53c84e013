; lemma: speed
; A robot is never faster than min(V, |v0| + e_v + A T) until its recovery acts at T, and its brake
; does not make it faster, sampled and against a push d < b included, as long as the velocity that it
; goes by is faster than eta b / (b - d) (sampled_brake has the angle, c its cosine).
; code: compiler/codegen/kernel/speed.c | return min_of(speed_cap(s, m), s->speed_mmps + s->v_error_mmps + div_up(m->accel_mmps2 * div_up(us, 1000), 1000));
; code: compiler/codegen/kernel/speed.c | const int64_t spare = most_mmps - fastest_mmps(s, m, s->age_us + horizon_us);

; step: until it acts
; mistake: s/(+ n ev (\* A T))/(+ n (* A T))/g
; mistake: s/(assert (<= u V))//
; mistake: s/(assert (>= (- limit fastest) 0))//
(set-logic QF_NRA)
(declare-const A Real) (declare-const t Real) (declare-const T Real) (declare-const V Real)
(declare-const ev Real) (declare-const n Real) (declare-const u Real) (declare-const fastest Real)
(declare-const limit Real)
(assert (>= A 0)) (assert (>= ev 0)) (assert (>= t 0)) (assert (<= t T))
(assert (<= u (+ n ev (* A t)))) (assert (<= u V))
(assert (= fastest (ite (<= V (+ n ev (* A T))) V (+ n ev (* A T)))))
(assert (>= (- limit fastest) 0))
; claim
(assert (not (<= u limit)))
(check-sat)
(reset)

; step: from then on: half of the rate of |v|^2 under -b u' + push, u' of unit length
; mistake: s/(assert (>= (\* b c) d))/(assert (>= (* 2 b c) d))/
; mistake: s/(\* (- b) v c)/(* b v c)/
(set-logic QF_NRA)
(declare-const b Real) (declare-const d Real) (declare-const v Real) (declare-const c Real)
(declare-const push Real) (declare-const rate Real)
(assert (> b 0)) (assert (>= d 0)) (assert (> v 0))
(assert (>= (* b c) d)) (assert (<= push d))
(assert (= rate (+ (* (- b) v c) (* v push))))
; claim
(assert (not (<= rate 0)))
(check-sat)
(reset)
