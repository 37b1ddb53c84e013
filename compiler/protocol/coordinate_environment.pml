
/* Ahead of a recovery that is faster than who drives less may hold. */
#define may_differ(i) (fits[i] && shown[i] == 0 && !engaged[(i) % MONITORS] && !sure[(i) % MONITORS] && \
                       driver != 0 && (i) / MONITORS != own)

inline choose_ahead() {
  k = 0;
  do
  :: k < MONITORS * MONITORS && may_differ(k) -> either(fits[k]); k++
  :: k < MONITORS * MONITORS && !may_differ(k) -> k++
  :: else -> break
  od;
  either(more_room)
}
