
/* Ahead of a recovery that is faster than who drives less may hold; but when nothing more comes from
 * outside, all of a monitor that stays idle while that recovery drives: inputs and agents, which have
 * let go then, whoever drives, and what is accepted. */
#define stays_idle(i) (quiet && keeps[i])
#define may_differ(i) (fits[i] && shown[i] == 0 && !engaged[(i) % MONITORS] && !sure[(i) % MONITORS] && \
                       driver != 0 && !stays_idle(i) && (i) / MONITORS != own)

inline choose_ahead() {
  k = 0;
  do
  :: k < MONITORS * MONITORS && may_differ(k) -> either(fits[k]); k++
  :: k < MONITORS * MONITORS && !may_differ(k) -> k++
  :: else -> break
  od;
  either(more_room)
}
