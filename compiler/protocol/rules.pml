/* ---- What a tick does -------------------------------------------------------------------------
 * Controllers are numbered: 0 is the advanced one, k + 1 the recovery of monitor k. Monitor 0 ranks
 * first. */
#define NOBODY MONITORS         /* no monitor */
#define SOMEBODY (MONITORS + 1) /* some monitor, whichever */

/* How long return conditions hold. They may begin to hold later, so that it is counted only from the
 * tick on after which less may happen. */
#define DWELLS (quiet -> DWELL : 0)

mtype = { none, look_ahead, violation, starting, returning, surrendered }; /* reasons */
mtype = { on_time, again, missed }; /* a tick; a second step in one; a gap, or a clock turned back */

/* What the kernel remembers. `promised`: a promise to stay binds the robot. */
bool started, promised;
bool engaged[MONITORS];
byte dwell[MONITORS];
byte mode = 1; /* until the first step */
hidden mtype why[MONITORS];
hidden mtype reason; /* of the record */

/* What the plan executor remembers: who drives. `commands`: how many were sent in this tick. */
byte driver;
bool drives[MONITORS + 1];
byte commands;

/* What a tick is given. */
mtype step;
bool surrender; /* the advanced side gives control up */
bool holding;   /* the recovery that drives has latched its hold and means to stay */
bool late;      /* the watchdog of the plan executor has run out */

/* What a tick finds of one monitor after the other. */
bool violated;   /* its property is false */
bool clear;      /* its look-ahead holds, under the motion of who drives */
bool safer;      /* its derived return condition holds */
bool gives_back; /* its `return when` holds, or it has none */

/* Of this tick. */
bool first;
byte before, highest, k;
byte open; /* the first that is not ready to give control back, if nobody is engaged */

inline begin_tick() {
  first = !started;
  started = 1;
  before = mode;
  open = NOBODY
}

inline engage(m, reason) {
  engaged[m] = 1;
  dwell[m] = 0;
  why[m] = reason
}

/* `monitor_step` of the kernel. */
inline judge(m) {
  if
  :: !safer && open == NOBODY && before != 0 -> open = m
  :: else
  fi;
  if
  :: first && safer -> engaged[m] = 0
  :: first && !safer && violated -> engage(m, violation)
  :: first && !safer && !violated -> engage(m, starting)
  :: !first && !engaged[m] && violated -> engage(m, violation)
  :: !first && !engaged[m] && !violated && (step == missed || !clear) -> engage(m, look_ahead)
  :: !first && !engaged[m] && !violated && step != missed && clear
  :: !first && engaged[m] && violated -> engage(m, violation)
  :: !first && engaged[m] && !violated && (step == missed || !(safer && gives_back)) ->
     engage(m, returning)
  :: !first && engaged[m] && !violated && step == again && safer && gives_back
  :: !first && engaged[m] && !violated && step == on_time && safer && gives_back ->
     why[m] = returning;
     dwell[m]++;
     if
     :: dwell[m] > DWELLS -> engaged[m] = 0; dwell[m] = 0; why[m] = none
     :: else
     fi
  fi;
  if
  :: engaged[m] -> open = SOMEBODY
  :: else
  fi
}

inline find_highest() {
  highest = 0;
  do
  :: highest < MONITORS && !engaged[highest] -> highest++
  :: else -> break
  od
}

/* `mode_step` of the kernel: who drives, and whether the promise to stay is renewed. */
inline decide() {
  find_highest();
  if
  :: highest != NOBODY -> mode = highest + 1
  :: highest == NOBODY && surrender -> mode = SURRENDERS_TO
  :: highest == NOBODY && !surrender && before != 0 && open != NOBODY ->
     engage(open, returning);
     mode = open + 1
  :: else -> mode = (promised -> before : 0)
  fi;
  find_highest();
  if
  :: PROMISES && mode != 0 && mode == before && holding &&
     (surrender || highest != NOBODY || open != NOBODY) -> promised = 1
  :: else
  fi;
  if
  :: mode == 0 -> reason = none
  :: mode != 0 && engaged[mode - 1] -> reason = why[mode - 1]
  :: mode != 0 && !engaged[mode - 1] && surrender -> reason = surrendered
  :: else -> reason = returning
  fi
}

/* `PlanExecutor::switch_to` and `command` of the runtime: the one that drove stops, the one of the
 * mode begins; who drives sends a command, but after too long a silence the advanced controller is
 * replaced by the brake of the first recovery for a tick. */
inline hand_over() {
  if
  :: mode != driver ->
     drives[driver] = 0;
     drives[mode] = 1;
     driver = mode
  :: else
  fi;
  commands = 0;
  k = 0;
  do
  :: k <= MONITORS && drives[k] && !(late && k == 0) -> commands++; k++
  :: k <= MONITORS && !(drives[k] && !(late && k == 0)) -> k++
  :: else -> break
  od;
  if
  :: late && drives[0] -> commands++ /* the brake */
  :: else
  fi
}
