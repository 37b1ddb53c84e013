/* ---- What a request for a plan does -------------------------------------------------------------
 * Nothing is remembered from one request to the next. */
#define NOBODY MONITORS /* no monitor */

mtype = { nobody, advanced, safe }; /* planners */

mtype delivered; /* whose plan the executor gets */
byte deliveries;
bool asked_safe, found, passes, admissible, decided;
byte deciding, k; /* the highest monitor that is not true of the plan */
hidden int requests;

inline either(b) {
  if
  :: b = 0
  :: b = 1
  fi
}

/* `M_judge` of the kernel: every monitor, the highest last. Any of them may be true or not. */
inline judge() {
  deciding = NOBODY;
  k = MONITORS;
  do
  :: k > 0 ->
     k--;
     either(passes);
     if
     :: !passes -> deciding = k
     :: else
     fi;
     passes = 0
  :: else -> break
  od;
  admissible = (deciding == NOBODY)
}

inline tell(planner) {
  printf("request %d: ", requests);
  say_planner(planner);
  if
  :: !found -> printf(" finds no plan\n")
  :: found && admissible -> printf(" plans\n")
  :: else ->
     printf(" has a plan that ");
     say_monitor(deciding);
     printf(" refuses\n")
  fi
}

/* `MotionPlanner::attempt` of the runtime: a plan is judged before it is delivered. */
inline attempt(planner) {
  admissible = 0;
  either(found);
  if
  :: found -> judge()
  :: else
  fi;
  if
  :: found && admissible -> delivered = planner; deliveries++
  :: else
  fi;
  tell(planner);
  found = 0
}

/* `MotionPlanner::find`: the advanced planner is asked, unless the executor prefers the safe one;
 * that is asked where there is no admissible plan yet. */
active proctype planner() {
  bool prefer_safe;
  do
  :: atomic {
       decided = 0;
       delivered = nobody;
       deliveries = 0;
       asked_safe = 0;
       deciding = 0;
       either(prefer_safe);
       if
       :: !prefer_safe -> attempt(advanced)
       :: else
       fi;
       if
       :: delivered == nobody -> asked_safe = 1; attempt(safe)
       :: else
       fi;
       prefer_safe = 0;
       requests++;
       decided = 1
     }
  od
}
