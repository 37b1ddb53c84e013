; lemma: space_tube
; Robots in space: a ball of radius R around a place of the segment lies in the upright cylinder over
; the shadow of its tube, R higher and R lower; and a height that keeps R to both ends of the segment
; keeps it to every place between them. Zones with height are stacks of slabs, each over a zone of the
; plane: a tube whose shadow, widened by R, is in every slab that its heights touch is in the zone, as
; long as the slabs that it touches follow each other without a gap.
; code: compiler/codegen/kernel/space.c | const int64_t bottom = min_of(p_z, e_z) - need_mm;
; code: compiler/codegen/kernel/space.c | spare = min_of(spare, held - k->floor_mm);
; code: compiler/codegen/kernel/space.c | const int64_t spare = max_of(now - r->centre_mm, min_of(now, end) - r->capsule_mm + b->radius_mm);

; step: the ball and its shadow
; mistake: s/(\* dz dz)) (\* R R)/(* dz dz)) (* 2 R R)/
(set-logic QF_NRA)
(declare-const dx Real) (declare-const dy Real) (declare-const dz Real) (declare-const R Real)
(assert (>= R 0)) (assert (<= (+ (* dx dx) (* dy dy) (* dz dz)) (* R R)))
; claim
(assert (not (and (<= (+ (* dx dx) (* dy dy)) (* R R)) (<= dz R) (<= (- R) dz))))
(check-sat)
(reset)

; step: heights of the segment lie between those of its ends, and those of the tube R around them
; mistake: s/(assert (<= k 1))//
; mistake: s/(- low R)/low/
(set-logic QF_NRA)
(declare-const z Real) (declare-const e Real) (declare-const k Real) (declare-const R Real)
(declare-const at Real) (declare-const dz Real) (declare-const low Real) (declare-const high Real)
(assert (>= k 0)) (assert (<= k 1))
(assert (= at (+ z (* k (- e z)))))
(assert (<= dz R)) (assert (<= (- R) dz))
(assert (= low (ite (<= z e) z e))) (assert (= high (ite (<= z e) e z)))
; claim
(assert (not (and (<= (- low R) (+ at dz)) (<= (+ at dz) (+ high R)))))
(check-sat)
(reset)

; step: a height within the tube is within a slab that it touches: those from the first one, whose
; step+ floor is below it, to the last one, whose ceiling is above, each beginning where one ends
; mistake: s/(assert (<= f2 c1))//
(set-logic QF_NRA)
(declare-const h Real) (declare-const bottom Real) (declare-const top Real)
(declare-const f1 Real) (declare-const c1 Real) (declare-const f2 Real) (declare-const c2 Real)
(assert (<= bottom h)) (assert (<= h top))
(assert (<= f1 bottom)) (assert (<= f2 c1)) (assert (<= top c2))
; claim
(assert (not (or (and (<= f1 h) (<= h c1)) (and (<= f2 h) (<= h c2)))))
(check-sat)
(reset)

; step: a limit of the height
; mistake: s/(- (ite (<= now end) now end) R)/(- now R)/
(set-logic QF_NRA)
(declare-const now Real) (declare-const end Real) (declare-const k Real) (declare-const R Real)
(declare-const off Real)
(assert (>= k 0)) (assert (<= k 1)) (assert (<= off R)) (assert (>= R 0))
(assert (>= (- (ite (<= now end) now end) R) 0))
; claim
(assert (not (>= (- (+ (* (- 1 k) now) (* k end)) off) 0)))
(check-sat)
(reset)
