
/* Ahead of a recovery that is faster than who drives less may hold; but when nothing more comes from
 * outside, all of a monitor that stays idle while that recovery drives: inputs and agents, which have
 * let go then, whoever drives, and what is accepted. */
#define stays_idle(i) (quiet && keeps[i])
#define may_differ(i) (fits[i] && shown[i] == 0 && !engaged[(i) % MONITORS] && !sure[(i) % MONITORS] && \
                       driver != 0 && !stays_idle(i) && (i) / MONITORS != own)

/* A recovery that cannot drive next nobody asks for. */
#define may_drive(i) (engaged[i] || speaks[i] || open == i)

inline choose_ahead_of(i) {
  asked[i] = 1;
  k = i * MONITORS;
  do
  :: k < (i + 1) * MONITORS && may_differ(k) ->
     if
     :: fits[k] = 0; speaks[k % MONITORS] = 1
     :: fits[k] = 1
     fi;
     k++
  :: k < (i + 1) * MONITORS && !may_differ(k) -> k++
  :: else -> break
  od
}

inline choose_ahead() {
  asker = 0;
  do
  :: asker < MONITORS && may_drive(asker) && !asked[asker] -> choose_ahead_of(asker); asker = 0
  :: asker < MONITORS && !(may_drive(asker) && !asked[asker]) -> asker++
  :: else -> break
  od;
  asker = 0;
  if
  :: open != NOBODY -> either(more_room)
  :: else
  fi
}
