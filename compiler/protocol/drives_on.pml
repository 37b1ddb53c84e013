/* ---- Who drives on though a monitor that ranks higher is engaged, as `drives_on` of the kernel ----
 * `shown`: the table of the kernel. */
bool false_now[MONITORS];
bool goes_on; /* who has driven drives, in this tick */
bool excused; /* for the claim: who drives is shown to keep what ranks higher */
hidden byte column;

inline note(m) {
  false_now[m] = violated
}

inline find_going_on() {
  goes_on = 0;
  if
  :: !first && step != missed && before != 0 -> goes_on = engaged[before - 1]
  :: else
  fi;
  column = 0;
  do
  :: goes_on && column + 1 < before ->
     goes_on = (!engaged[column] || (shown[(before - 1) * MONITORS + column] == 1 && !false_now[column]));
     column++
  :: else -> break
  od
}

/* At the end of a tick. */
inline find_excuse() {
  excused = (step != missed && mode != 0);
  if
  :: mode != 0 -> excused = (excused && engaged[mode - 1])
  :: else
  fi;
  column = 0;
  do
  :: column < MONITORS ->
     if
     :: column + 1 < mode && engaged[column] ->
        excused = (excused && shown[(mode - 1) * MONITORS + column] == 1 && !false_now[column])
     :: else
     fi;
     false_now[column] = 0;
     column++
  :: else -> break
  od
}
