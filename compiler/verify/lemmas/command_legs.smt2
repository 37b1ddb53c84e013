; lemma: command_legs
; The legs of the look-ahead under commands (docs/command.md), each under one command u of the size m
; for h, gained = m h. What z3 is asked are the bounds; that the end of a leg under a saturation that
; goes on all the time differs from the one of one step by the integral of the difference of the
; fields, and that the field is monotone, is argued there.
; code: compiler/codegen/kernel/command.c | w->v_error_umps += div_up(gained * over, cap) + 4;
; code: compiler/codegen/kernel/command.c | w->leg_bend_um = max_of(w->leg_bend_um, div_up(gained * h_us, 8000000));
; code: compiler/codegen/kernel/command.c | w->v_error_umps += div_up(root_up(dx * dx + dy * dy) * div_up(o->latency_us + 1, 2), 1000);
; code: compiler/codegen/kernel/command.c | off = min_of(over, below + bend) + div_up(bend, 4) + 2;

; step: without saturation the way is a parabola, off its chord by m t (h - t) / 2, m h^2 / 8 at most
; mistake: s/(\* 8 off) (\* m h h)/(* 10 off) (* m h h)/
(set-logic QF_NRA)
(declare-const m Real) (declare-const h Real) (declare-const t Real) (declare-const off Real)
(assert (>= m 0)) (assert (<= 0 t)) (assert (<= t h))
(assert (= (* 2 off) (* m t (- h t))))
; claim
(assert (not (<= (* 8 off) (* m h h))))
(check-sat)
(reset)

; step: from the chord: p + w t + u t^2 / 2 less p + (t / h)(w h + u h^2 / 2) is u t (t - h) / 2
; mistake: s/(\* t h 0.5 u)/(* t h u)/
(set-logic QF_NRA)
(declare-const w Real) (declare-const u Real) (declare-const h Real) (declare-const t Real)
(declare-const off Real)
(assert (> h 0)) (assert (<= 0 t)) (assert (<= t h))
(assert (= off (- (+ (* w t) (* 0.5 u t t)) (+ (* t w) (* t h 0.5 u)))))
; claim
(assert (not (= (* 2 off) (* u t (- t h)))))
(check-sat)
(reset)

; step: a command that begins up to half a latency from when it is taken to: the velocity goes wrong
; step+ by the difference of the commands for as long
; mistake: s/(+ issued (\* 0.5 latency))/issued/
(set-logic QF_NRA)
(declare-const begun Real) (declare-const taken Real) (declare-const issued Real)
(declare-const latency Real) (declare-const between Real) (declare-const wrong Real)
(assert (>= between 0)) (assert (>= latency 0))
(assert (>= begun issued)) (assert (<= begun (+ issued latency)))
(assert (= taken (+ issued (* 0.5 latency))))
(assert (<= wrong (* between (ite (<= taken begun) (- begun taken) (- taken begun)))))
; claim
(assert (not (<= wrong (* between 0.5 latency))))
(check-sat)
(reset)

; step: where the speed saturates: y = |w + u t| is at most V + over between the ends of a leg, being
; step+ convex, and V / y falls short of 1 by over / V at most
; mistake: s/(assert (<= y (+ V over)))/(assert (<= y (+ V over over)))/
(set-logic QF_NRA)
(declare-const V Real) (declare-const over Real) (declare-const y Real) (declare-const k Real)
(assert (> V 0)) (assert (>= over 0)) (assert (<= V y)) (assert (<= y (+ V over)))
(assert (= (* k y) V))
; claim
(assert (not (<= (* V (- 1 k)) over)))
(check-sat)
(reset)

; step: the bend along the cap: the velocity V (w + u t) / |w + u t| has a second derivative of
; step+ V m^2 / y^2 times the root of 4 c^2 s^2 + s^4, s and c of the angle between command and velocity:
; step+ 1.62 m^2 / V at most. Over h that is 1.62 / 8 of gained^2 / V off its chord, less than a quarter
; mistake: s/(assert (>= y V))/(assert (>= y (* 0.8 V)))/
; mistake: s/(\* 1.62 1.62 m m/(* 1.1 1.1 m m/
(set-logic QF_NRA)
(declare-const V Real) (declare-const y Real) (declare-const m Real)
(declare-const c2 Real) (declare-const s2 Real) (declare-const square Real) (declare-const f Real)
(assert (> V 0)) (assert (>= y V)) (assert (>= m 0))
(assert (>= s2 0)) (assert (>= c2 0)) (assert (= (+ s2 c2) 1))
(assert (= (* y y f) (* V V)))
(assert (= square (* f f m m m m (+ (* 4 c2 s2) (* s2 s2)))))
; claim
(assert (not (<= square (* 1.62 1.62 m m m m))))
(check-sat)
(reset)

; step: how far the velocity is off its straight line: as far as from V - |w| below the cap it takes
; step+ to it and the bend beyond, or what is over, whichever is less, and the bend
; mistake: s/(assert (<= off (+ below bend quarter)))//
(set-logic QF_NRA)
(declare-const over Real) (declare-const below Real) (declare-const bend Real)
(declare-const quarter Real) (declare-const off Real)
(assert (>= over 0)) (assert (>= below 0)) (assert (>= bend 0)) (assert (= (* 4 quarter) bend))
(assert (<= off (+ over quarter)))
(assert (<= off (+ below bend quarter)))
; claim
(assert (not (<= off (+ (ite (<= over (+ below bend)) over (+ below bend)) quarter))))
(check-sat)
(reset)
