; lemma: return_implies_ahead
; The return condition is the check with a longer horizon T2 >= T under any control: it implies the
; check (P3), as do larger errors, speeds and limits, each bound being monotone in all of them. What
; the capsule covers in less time is part of what it covers in more.
; code: compiler/analysis/derive.cpp | d.return_extra_us = return_extra_us(spec_, from, d.period_us);
; code: compiler/codegen/kernel/motion.c | const int64_t along_us = t_us + stopping_us(s, b);
; code: compiler/codegen/kernel/motion.c | return div_up(s->speed_mmps * 1000000, 2 * b->brake_mmps2);

; step: the radius of the capsule
; mistake: s/(assert (<= T T2))/(assert (<= T (* 2 T2)))/
; mistake: s/(assert (<= ev ev2))/(assert (<= ev (* 2 ev2)))/
(set-logic QF_NRA)
(declare-const A Real) (declare-const T Real) (declare-const T2 Real) (declare-const n Real)
(declare-const ep Real) (declare-const ev Real) (declare-const ep2 Real) (declare-const ev2 Real)
(declare-const s1 Real) (declare-const s2 Real) (declare-const A2 Real)
(declare-const b Real) (declare-const stop Real) (declare-const stop2 Real)
(assert (> b 0)) (assert (>= n 0)) (assert (>= ep 0)) (assert (>= ev 0)) (assert (>= A 0))
(assert (>= T 0)) (assert (>= s1 0))
(assert (<= T T2)) (assert (<= ep ep2)) (assert (<= ev ev2)) (assert (<= A A2)) (assert (<= s1 s2))
(assert (= (* 2 b stop) (* (+ n s1) (+ ev (* A T)))))
(assert (= (* 2 b stop2) (* (+ n s2) (+ ev2 (* A2 T2)))))
; claim
(assert (not (<= (+ ep (* ev T) (* 0.5 A T T) stop)
                 (+ ep2 (* ev2 T2) (* 0.5 A2 T2 T2) stop2))))
(check-sat)
(reset)

; step: the greatest speed by then, and with it the tube of the brake
; mistake: s/(assert (<= A A2))//
(set-logic QF_NRA)
(declare-const V Real) (declare-const n Real) (declare-const n2 Real)
(declare-const ev Real) (declare-const ev2 Real) (declare-const V2 Real)
(declare-const A Real) (declare-const A2 Real) (declare-const T Real) (declare-const T2 Real)
(define-fun fastest ((cap Real) (sum Real)) Real (ite (<= cap sum) cap sum))
(assert (>= A 0)) (assert (>= T 0))
(assert (<= n n2)) (assert (<= ev ev2)) (assert (<= A A2)) (assert (<= T T2)) (assert (<= V V2))
; claim
(assert (not (<= (fastest V (+ n ev (* A T))) (fastest V2 (+ n2 ev2 (* A2 T2))))))
(check-sat)
(reset)

; step: the segment of the capsule is part of the longer one
; mistake: s/(assert (<= T T2))/(assert (<= T (+ T2 1)))/
(set-logic QF_NRA)
(declare-const T Real) (declare-const T2 Real) (declare-const stop Real) (declare-const k Real)
(assert (>= stop 0)) (assert (<= T T2))
(assert (<= 0 k)) (assert (<= k (+ T stop)))
; claim
(assert (not (and (<= 0 k) (<= k (+ T2 stop)))))
(check-sat)
(reset)

; step: a margin of the return condition that is at least 0 leaves one of the check that is
; mistake: s/(assert (<= reach reach2))/(assert (<= reach (+ reach2 1)))/
; mistake: s/(assert (<= gap2 gap))/(assert (<= gap2 (+ gap 1)))/
(set-logic QF_NRA)
(declare-const gap Real) (declare-const gap2 Real) (declare-const reach Real)
(declare-const reach2 Real) (declare-const least Real)
(assert (<= gap2 gap)) (assert (<= reach reach2))
(assert (>= (- gap2 reach2 least) 0))
; claim
(assert (not (>= (- gap reach least) 0)))
(check-sat)
(reset)
