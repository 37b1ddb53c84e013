/* ---- What may happen ---------------------------------------------------------------------------
 * Anything, until at some time `quiet` begins: from then on ticks come in time, nobody gives control
 * up, and while a recovery drives, other monitors fail, or are not ready to give control back, only
 * where the tables `keeps` and `settles` do not promise otherwise. */
bool quiet;
bool arrived; /* the recovery has driven for as long as it takes: it may return, and that stays so */
bool home;    /* it may return in this tick */

/* For the claims, at the end of a tick. */
bool decided, changed, not_ready, overdue;
byte waiting; /* ticks in which the recovery of the highest engaged monitor did not drive */

#define calm (quiet && driver != 0)
#define own (driver - 1)
#define KEEPS(m) keeps[own * MONITORS + m]
#define SETTLES(m) settles[own * MONITORS + m]

inline either(b) {
  if
  :: b = 0
  :: b = 1
  fi
}

/* How long the return conditions of those that are engaged have held. */
inline choose_dwell() {
  k = 0;
  do
  :: k < MONITORS && engaged[k] && dwell[k] < DWELL -> dwell[k]++
  :: k < MONITORS -> k++
  :: else -> break
  od
}

/* Before the checks. */
inline choose_tick() {
  if
  :: !quiet
  :: !quiet -> quiet = 1; choose_dwell()
  :: else
  fi;
  if
  :: step = on_time
  :: started && !quiet -> step = again
  :: started && !quiet -> step = missed
  fi;
  if
  :: calm && !arrived -> either(arrived)
  :: else
  fi;
  if
  :: calm && arrived -> home = 1
  :: calm && !arrived -> either(home)
  :: else
  fi
}

/* After them. A promise may have run out. Who is replaced, or gives control up, drives while nobody is
 * engaged. */
inline choose_rest() {
  if
  :: !quiet && open != SOMEBODY -> either(surrender)
  :: else
  fi;
  if
  :: !first && !quiet && open != SOMEBODY -> either(late)
  :: else
  fi;
  if
  :: PROMISES && driver != 0 -> either(holding)
  :: else
  fi;
  if
  :: promised -> either(promised)
  :: else
  fi
}

/* What is found of monitor m. Where its return set holds, its look-ahead does, which is shorter. Of
 * findings that `judge` takes for the same there is one. */
inline choose_check(m) {
  if
  :: calm && home && (m == own || SETTLES(m)) -> clear = 1; safer = 1
  :: !calm && !first ->
     if
     :: violated = 1
     :: !engaged[m] /* its look-ahead fails */
     :: clear = 1
     :: clear = 1; safer = 1
     fi
  :: else ->
     if
     :: calm && m != own && !engaged[m] && KEEPS(m) -> clear = 1
     :: else -> either(violated); either(clear)
     fi;
     if
     :: calm && m == own && !asks[m] /* not home */
     :: else -> either(safer); clear = (clear || safer)
     fi
  fi;
  if
  :: calm && m == own -> gives_back = home
  :: else ->
     if
     :: asks[m] && engaged[m] && safer -> either(gives_back)
     :: else -> gives_back = 1
     fi
  fi
}

inline clear_check() {
  violated = 0;
  clear = 0;
  safer = 0;
  gives_back = 0
}

inline end_tick() {
  changed = (driver != before && !first);
  not_ready = (driver == 0 && before != 0 && open != NOBODY);
  if
  :: changed -> arrived = 0
  :: !changed && home && !engaged[own] -> arrived = 1 /* only its promise keeps it there */
  :: else
  fi;
  find_highest();
  if
  :: highest != NOBODY && !drives[highest + 1] -> waiting++
  :: else -> waiting = 0
  fi;
  overdue = (highest != NOBODY && waiting >= ahead[highest]);
  step = 0;
  surrender = 0;
  holding = 0;
  late = 0;
  home = 0;
  first = 0;
  before = 0;
  open = 0;
  k = 0
}

/* States are kept between the checks, though nobody looks at them before `decided`: so runs that have
 * found the same so far are followed once. */
active proctype robot() {
  drives[0] = 1;
  do
  :: atomic {
       decided = 0;
       choose_tick();
       k = 0;
       d_step { begin_tick(); remember(); k = 0 }
     };
     do
     :: atomic {
          k < MONITORS ->
          choose_check(k);
          d_step { judge(k); clear_check(); k++ }
        }
     :: else -> break
     od;
     atomic {
       choose_rest();
       k = 0;
       d_step { decide(); hand_over(); tell(); end_tick(); tell_end(); decided = 1 }
     }
  od
}
