; lemma: capsule
; At every time t <= T at which the brake may take over, the place p(t) and the point where an ideal
; brake stops from there, p + v|v| / (2 b), are within R of the segment from the measured place p0
; along the measured velocity v0, R = e_p + e_v T + A T^2 / 2 + (|v0| + s1)(e_v + A T) / (2 b).
; Everything between them is, too (norms), and with the tube of the brake added, everything that the
; robot covers until it stands. A segment that keeps R and the tube to the boundary, from a place
; inside, is inside with all of that.
; code: compiler/codegen/kernel/motion.c | const int64_t along_us = t_us + stopping_us(s, b);
; code: compiler/codegen/kernel/motion.c | return div_up(s->speed_mmps * 1000000, 2 * b->brake_mmps2);
; code: compiler/codegen/kernel/motion.c | r.capsule_mm = s->p_error_mm + aside_mm(s, b, m, t_ms, s1) + 2 + tube;
; code: compiler/codegen/kernel/motion.c | return by_error + by_accel + braked_mm(s->speed_mmps + s1, drift, b);
; code: compiler/codegen/kernel/motion.c | return div_up(v * w, 2 * b->brake_mmps2);
; code: compiler/codegen/kernel/checks.c | segment_boundary_lo(z, r->p, r->e) - r->capsule_mm - least_mm

; step: the nominal place and the nominal stop at t lie on the segment, `along` in times of |v0|
; mistake: s/(+ T stop)/T/
; mistake: s/(assert (<= t T))/(assert (<= t (* 2 T)))/
(set-logic QF_NRA)
(declare-const t Real) (declare-const T Real) (declare-const b Real)
(declare-const n Real) (declare-const stop Real) (declare-const along Real)
(assert (> b 0)) (assert (>= n 0)) (assert (>= t 0)) (assert (<= t T))
(assert (= (* 2 b stop) n))
(assert (>= along (+ T stop)))
; claim
(assert (not (and (<= 0 t) (<= t along) (<= 0 (+ t stop)) (<= (+ t stop) along))))
(check-sat)
(reset)

; step: the place is within R of the nominal one
; mistake: s/(define-fun reach () Real (+ ep (\* ev T)/(define-fun reach () Real (+ ep (* ev 0)/
(set-logic QF_NRA)
(declare-const A Real) (declare-const t Real) (declare-const T Real) (declare-const b Real)
(declare-const ep Real) (declare-const ev Real) (declare-const n Real) (declare-const s1 Real)
(declare-const off Real) (declare-const stop Real)
(define-fun reach () Real (+ ep (* ev T) (* 0.5 A T T) stop))
(assert (> b 0)) (assert (>= A 0)) (assert (>= ep 0)) (assert (>= ev 0))
(assert (>= n 0)) (assert (>= s1 0)) (assert (>= t 0)) (assert (<= t T))
(assert (= (* 2 b stop) (* (+ n s1) (+ ev (* A T)))))
(assert (<= off (+ ep (* ev t) (* 0.5 A t t))))
; claim
(assert (not (<= off reach)))
(check-sat)
(reset)

; step: the stop is within R of the nominal one: by stop_difference, from a speed u that is no
; step+ larger than s1 and a velocity that is off by dv
; mistake: s/(assert (<= u s1))/(assert (<= u (* 2 s1)))/
; mistake: s/(\* (+ n s1) (+ ev (\* A T)))/(* n (+ ev (* A T)))/
; mistake: s/(assert (<= dv (+ ev (\* A t))))/(assert (<= dv (+ ev (* A t) 1)))/
(set-logic QF_NRA)
(declare-const A Real) (declare-const t Real) (declare-const T Real) (declare-const b Real)
(declare-const ep Real) (declare-const ev Real) (declare-const n Real) (declare-const s1 Real)
(declare-const u Real) (declare-const dv Real)
(declare-const off Real) (declare-const stop Real) (declare-const stop_off Real)
(define-fun reach () Real (+ ep (* ev T) (* 0.5 A T T) stop))
(assert (> b 0)) (assert (>= A 0)) (assert (>= ep 0)) (assert (>= ev 0))
(assert (>= n 0)) (assert (>= u 0)) (assert (<= u s1)) (assert (>= t 0)) (assert (<= t T))
(assert (= (* 2 b stop) (* (+ n s1) (+ ev (* A T)))))
(assert (<= off (+ ep (* ev t) (* 0.5 A t t))))
(assert (>= dv 0)) (assert (<= dv (+ ev (* A t))))
(assert (<= (* 2 b stop_off) (* (+ n u) dv)))
; claim
(assert (not (<= (+ off stop_off) reach)))
(check-sat)
(reset)

; step: no speed until T is above s1 = min(V, |v0| + e_v + A T)
; mistake: s/(assert (<= u V))//
; mistake: s/(<= u (+ n ev (\* A t)))/(<= u (+ n ev (* A t) 1))/
(set-logic QF_NRA)
(declare-const A Real) (declare-const t Real) (declare-const T Real) (declare-const V Real)
(declare-const ev Real) (declare-const n Real) (declare-const u Real) (declare-const s1 Real)
(assert (>= A 0)) (assert (>= t 0)) (assert (<= t T))
(assert (<= u (+ n ev (* A t))))
(assert (<= u V))
(assert (= s1 (ite (<= V (+ n ev (* A T))) V (+ n ev (* A T)))))
; claim
(assert (not (<= u s1)))
(check-sat)
(reset)

; step: a boundary that is R + the tube and more away from the segment is `least` away from all of it
; mistake: s/(>= gap (+ reach tube least))/(>= gap (+ reach least))/
(set-logic QF_NRA)
(declare-const gap Real) (declare-const reach Real) (declare-const tube Real)
(declare-const least Real) (declare-const near Real) (declare-const off Real)
(declare-const left Real)
(assert (>= gap (+ reach tube least)))
(assert (>= tube 0)) (assert (<= 0 near)) (assert (<= near reach))
(assert (<= 0 off)) (assert (<= off tube))
(assert (>= left (- gap near off)))
; claim
(assert (not (>= left least)))
(check-sat)
(reset)
