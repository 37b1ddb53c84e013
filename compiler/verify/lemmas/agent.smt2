; lemma: agent
; What moves by itself with at most V_o keeps `least` from a robot until that stands, when it is as far
; from the centres of the robot's disc or capsule as the radius of that, its own, its error and V_o
; times the age of its sample and the time until the robot stands (still_lag).
; code: compiler/codegen/kernel/agents.c | const int64_t around = a->radius_mm + a->error_mm + div_up(a->speed_mmps * until_ms, 1000);
; code: compiler/codegen/kernel/agents.c | const int64_t until_ms = a->age_ms + r->still_ms;

; step: until the robot stands
; mistake: s/(\* Vo (+ age still))/(* Vo still)/
; mistake: s/(\* Vo (+ age still))/(* Vo age)/
; mistake: s/(assert (<= t still))//
(set-logic QF_NRA)
(declare-const gap Real) (declare-const reach Real) (declare-const ro Real) (declare-const eo Real)
(declare-const Vo Real) (declare-const age Real) (declare-const still Real) (declare-const t Real)
(declare-const least Real) (declare-const moved Real) (declare-const seen Real)
(declare-const mine Real) (declare-const left Real)
(assert (>= ro 0)) (assert (>= eo 0)) (assert (>= Vo 0)) (assert (>= age 0)) (assert (>= still 0))
(assert (>= gap (+ reach ro eo (* Vo (+ age still)) least)))
(assert (<= 0 t)) (assert (<= t still))
(assert (<= 0 mine)) (assert (<= mine reach)) (assert (<= 0 seen)) (assert (<= seen eo))
(assert (<= 0 moved)) (assert (<= moved (* Vo (+ age t))))
(assert (>= left (- gap mine ro seen moved)))
; claim
(assert (not (>= left least)))
(check-sat)
(reset)

; step: it stands after the horizon, s1 / (b - d) and the lag, whenever before the horizon it began
; step+ to brake from at most s1
; mistake: s/(assert (<= u s1))/(assert (<= u (* 2 s1)))/
; mistake: s/(assert (<= t0 horizon))//
(set-logic QF_NRA)
(declare-const t0 Real) (declare-const horizon Real) (declare-const u Real) (declare-const s1 Real)
(declare-const net Real) (declare-const lag Real) (declare-const stands Real)
(declare-const brakes Real) (declare-const still Real)
(assert (> net 0)) (assert (>= lag 0))
(assert (<= 0 u)) (assert (<= u s1)) (assert (<= 0 t0)) (assert (<= t0 horizon))
(assert (= (* net brakes) u)) (assert (<= stands (+ t0 brakes lag)))
(assert (= (* net (- still horizon lag)) s1))
; claim
(assert (not (<= stands still)))
(check-sat)
(reset)
