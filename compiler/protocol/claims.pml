/* ---- What is claimed --------------------------------------------------------------------------- */

/* Always exactly one controller sends a command, and it is the one that the decision has chosen. */
ltl one_controller { [] (decided -> (commands == 1 && drives[mode])) }

/* The recovery of the highest engaged monitor drives before its look-ahead has passed. */
ltl scheduled { [] (decided -> !overdue) }

/* The advanced controller drives only while no monitor is engaged, and gets control back only when
 * every derived return condition holds. */
ltl given_back { [] ((decided && driver == 0) -> (highest == NOBODY && !not_ready)) }

/* When nothing more comes from outside, recoveries do not take over from each other for ever. Quiet
 * never ends, so that the formulas, which spin turns into few states, say what one with `<> quiet ->`
 * in front would. */
ltl no_livelock { [] (quiet -> (<> (driver == 0) || <> [] !changed)) }

/* Then control comes back again and again, if every recovery that keeps driving reaches its return
 * set at some time, and promises to stay run out when they are not renewed. */
ltl control_returns {
  ([] <> (arrived || driver == 0) && [] <> !promised) -> [] <> (driver == 0 || !quiet)
}
