/* ---- Who drives of several engaged monitors, as `coordinate` of the kernel ----------------------
 * In the place of the highest one. `shown`: the table of the kernel. `fits`: it is seen ahead of the
 * recovery of the row that the monitor of the column holds. */
bool false_now[MONITORS];
bool sure[MONITORS]; /* it may return, and so holds ahead of whoever drives */
bool fits[MONITORS * MONITORS];
bool more_room; /* of two prefixes that are equal, the second one ends with more room */
bool asked[MONITORS];  /* what is seen ahead of its recovery is chosen */
bool speaks[MONITORS]; /* it may have to engage, so that its recovery may drive */
byte asker;
bool lost; /* for the claim: a monitor that no circle leads to is not kept */
hidden byte best, longest, length, speaker, unkept, row, column;
hidden byte kept;

#define SHOWN(i, j) shown[(i) * MONITORS + (j)]
#define FITS(i, j) fits[(i) * MONITORS + (j)]

/* What was found under the motion of who drives: as good where no recovery is faster. Only what is asked
 * for is kept, of monitors that are idle, so that fewer states differ. */
inline note(m) {
  false_now[m] = violated;
  sure[m] = 0;
  row = 0;
  do
  :: row < MONITORS && SHOWN(row, m) == 0 ->
     FITS(row, m) = (clear && !engaged[m]);
     sure[m] = (safer && !engaged[m] && driver != 0);
     row++
  :: row < MONITORS && SHOWN(row, m) != 0 -> FITS(row, m) = 0; row++
  :: else -> break
  od
}

inline ask(i, j) {
  if
  :: false_now[j] -> kept = (SHOWN(i, j) == 2)
  :: !false_now[j] && SHOWN(i, j) != 0 -> kept = 1
  :: else -> kept = (!engaged[j] && FITS(i, j))
  fi
}

inline find_prefix(i) {
  length = 0;
  do
  :: length < MONITORS ->
     ask(i, length);
     if
     :: kept -> length++
     :: else -> break
     fi
  :: else -> break
  od
}

inline find_best() {
  best = NOBODY;
  longest = 0;
  row = 0;
  do
  :: row < MONITORS && engaged[row] ->
     find_prefix(row);
     if
     :: best == NOBODY || length > longest ||
        (length == longest && before != best + 1 && (before == row + 1 || more_room)) ->
        best = row;
        longest = length
     :: else
     fi;
     row++
  :: row < MONITORS && !engaged[row] -> row++
  :: else -> break
  od
}

inline find_speaker() {
  speaker = NOBODY;
  unkept = 0;
  column = 0;
  do
  :: column < MONITORS && speaker == NOBODY ->
     ask(best, column);
     if
     :: !kept && !engaged[column] -> speaker = column
     :: !kept && engaged[column] -> unkept = column
     :: else
     fi;
     column++
  :: else -> break
  od;
  row = 0;
  do
  :: row < MONITORS && speaker == NOBODY ->
     if
     :: engaged[row] ->
        find_prefix(row);
        if
        :: length < unkept && !engaged[length] -> speaker = length
        :: else
        fi
     :: else
     fi;
     row++
  :: else -> break
  od
}

inline choose() {
  find_best();
  find_speaker();
  do
  :: speaker != NOBODY ->
     engage(speaker, look_ahead);
     find_best();
     find_speaker()
  :: else -> break
  od;
  mode = best + 1
}

/* At the end of a tick in which somebody is engaged. Who leads out of a violation need not keep
 * what ranks below. */
inline find_lost() {
  lost = 0;
  column = 0;
  do
  :: column < MONITORS && highest != NOBODY && !false_now[column] ->
     ask(mode - 1, column);
     lost = (lost || (covered[column] && !kept));
     column++
  :: else -> break
  od
}

inline forget() {
  more_room = 0;
  row = 0;
  do
  :: row < MONITORS ->
     false_now[row] = 0;
     sure[row] = 0;
     asked[row] = 0;
     speaks[row] = 0;
     column = 0;
     do
     :: column < MONITORS -> FITS(row, column) = 0; column++
     :: else -> break
     od;
     row++
  :: else -> break
  od
}
