/* ---- What is claimed --------------------------------------------------------------------------- */

/* At most one plan is delivered, and none that a monitor refuses. */
ltl one_controller { [] (decided -> (deliveries == (delivered != nobody) && deliveries <= 1)) }
ltl admissible_only { [] ((decided && delivered != nobody) -> admissible) }

/* Where the advanced planner has no admissible plan, the safe one is asked within the request. */
ltl scheduled { [] ((decided && delivered != advanced) -> asked_safe) }

/* Every request is answered. */
ltl answered { [] <> decided }
