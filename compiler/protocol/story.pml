/* ---- What a run is told as, by `spin -t` -------------------------------------------------------- */
hidden int ticks;
hidden byte was_engaged[MONITORS];
hidden byte was_quiet;
hidden byte told;

inline remember() {
  told = 0;
  do
  :: told < MONITORS -> was_engaged[told] = engaged[told]; told++
  :: else -> break
  od
}

inline say_reason(m) {
  if
  :: why[m] == look_ahead && step == missed -> printf("a tick was missed")
  :: why[m] == look_ahead && step != missed -> printf("its look-ahead fails")
  :: why[m] == violation -> printf("it is violated")
  :: why[m] == starting -> printf("control may not be given at the start")
  :: why[m] == returning -> printf("control may not be given back")
  :: else -> printf("no reason")
  fi
}

inline tell() {
  if
  :: quiet && !was_quiet -> printf("nothing more comes from outside\n")
  :: else
  fi;
  was_quiet = quiet;
  told = 0;
  do
  :: told < MONITORS ->
     if
     :: engaged[told] && !was_engaged[told] ->
        printf("tick %d: ", ticks);
        say_monitor(told);
        printf(" engages: ");
        say_reason(told);
        printf("\n")
     :: !engaged[told] && was_engaged[told] ->
        printf("tick %d: ", ticks);
        say_monitor(told);
        printf(" disengages\n")
     :: else
     fi;
     told++
  :: else -> break
  od;
  printf("tick %d: ", ticks);
  if
  :: commands == 0 -> printf("NOBODY drives")
  :: commands > 1 -> printf("%d controllers drive", commands)
  :: commands == 1 ->
     told = 0;
     do
     :: told <= MONITORS && !drives[told] -> told++
     :: else -> break
     od;
     say_driver(told);
     printf(" drives");
     if
     :: mode != 0 && !engaged[mode - 1] && surrender -> printf(": control was given up")
     :: mode != 0 && !engaged[mode - 1] && !surrender -> printf(": it has promised to stay")
     :: else
     fi
  fi;
  printf("\n");
  ticks++
}

inline tell_end() {
  if
  :: overdue ->
     say_monitor(highest);
     printf(" is engaged, and ");
     say_driver(highest + 1);
     printf(" has not driven for %d ticks: its look-ahead has passed\n", waiting)
  :: not_ready -> printf("the advanced controller drives before control may be given back\n")
  :: else
  fi
}
