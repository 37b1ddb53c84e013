/* When zones are there. */

/*= opening_type */
/* From the first microsecond on, before the second. */
typedef struct opening {
  int64_t from_us, until_us;
} opening;
/*= schedule_type : opening_type */
/* First the openings since 1970-01-01T00:00Z, then those of every week, since Monday 00:00Z. Those
 * of one kind are in order and apart. */
typedef struct schedule {
  const opening *openings;
  int32_t once, weekly;
} schedule;
/*= opens_at : opening_type */
/* Whether the last opening that has begun lasts. */
static int32_t opens_at(const opening *all, int32_t count, int64_t at_us) {
  int32_t begun = 0, behind = count;
  while (begun < behind) {
    const int32_t middle = begun + (behind - begun) / 2;
    if (all[middle].from_us <= at_us) {
      begun = middle + 1;
    } else {
      behind = middle;
    }
  }
  return begun > 0 && at_us < all[begun - 1].until_us;
}
/*= is_open : schedule_type opens_at */
/* 1970 began on a Thursday. */
static int32_t is_open(const schedule *s, int64_t now_us) {
  const int64_t day_us = INT64_C(86400000000), week_us = 7 * day_us;
  const int64_t of_week_us = (now_us % week_us + week_us + 3 * day_us) % week_us;
  return opens_at(s->openings, s->once, now_us) ||
         opens_at(s->openings + s->once, s->weekly, of_week_us);
}
/*= of_week */
/* 1970 began on a Thursday. */
static int64_t of_week(int64_t at_us) {
  const int64_t day_us = INT64_C(86400000000), week_us = 7 * day_us;
  return (at_us % week_us + week_us + 3 * day_us) % week_us;
}
/*= first_after : opening_type */
/* The first opening that begins after `at_us`; `count`: none does. */
static int32_t first_after(const opening *all, int32_t count, int64_t at_us) {
  int32_t begun = 0, behind = count;
  while (begun < behind) {
    const int32_t middle = begun + (behind - begun) / 2;
    if (all[middle].from_us <= at_us) {
      begun = middle + 1;
    } else {
      behind = middle;
    }
  }
  return begun;
}
/*= lasts_us : first_after elapsed_us */
/* How long the opening still lasts that `at_us` is in; 0: none is. */
static int64_t lasts_us(const opening *all, int32_t count, int64_t at_us) {
  const int32_t next = first_after(all, count, at_us);
  return next > 0 && at_us < all[next - 1].until_us ? elapsed_us(at_us, all[next - 1].until_us) : 0;
}
/*= begins_within : first_after */
/* Whether an opening begins after `from_us`, and not after `to_us`. */
static int32_t begins_within(const opening *all, int32_t count, int64_t from_us, int64_t to_us) {
  const int32_t next = first_after(all, count, from_us);
  return next < count && all[next].from_us <= to_us;
}
/*= there_from : schedule_type lasts_us of_week later max_of elapsed_us */
/* Whether the zone is there from `from_us` to `to_us`, both included. Openings that join are one; of
 * more than eight nothing is relied upon. */
static int32_t there_from(const schedule *s, int64_t from_us, int64_t to_us) {
  int64_t at_us = from_us;
  int32_t k;
  for (k = 0; k < 8; ++k) {
    const int64_t us = max_of(lasts_us(s->openings, s->once, at_us),
                              lasts_us(s->openings + s->once, s->weekly, of_week(at_us)));
    if (us == 0) {
      return 0;
    }
    at_us = later(at_us, us);
    if (at_us > to_us) {
      return 1;
    }
  }
  return 0;
}
/*= gone_from : schedule_type is_open begins_within of_week elapsed_us */
/* Whether the zone is not there at any time from `from_us` to `to_us`. */
static int32_t gone_from(const schedule *s, int64_t from_us, int64_t to_us) {
  const int64_t week_us = INT64_C(604800000000);
  const int64_t us = elapsed_us(from_us, to_us), at_us = of_week(from_us);
  const opening *weekly = s->openings + s->once;
  if (is_open(s, from_us) || begins_within(s->openings, s->once, from_us, to_us)) {
    return 0;
  }
  if (us >= week_us) {
    return s->weekly == 0;
  }
  return !begins_within(weekly, s->weekly, at_us, at_us + us) &&
         !begins_within(weekly, s->weekly, at_us - week_us, at_us - week_us + us);
}
/*= there_until : there_from estimate_type margin_true margin_false later */
/* The zone is there from when the robot was seen until `ahead_us` from now. */
static margin there_until(const schedule *s, const estimate *seen, int64_t now_us,
                          int64_t ahead_us) {
  return there_from(s, now_us - seen->age_us, later(now_us, ahead_us)) ? margin_true()
                                                                       : margin_false();
}
/*= gone_until : gone_from estimate_type margin_true margin_false later */
/* The zone is not there at any time from when the robot was seen until `ahead_us` from now. */
static margin gone_until(const schedule *s, const estimate *seen, int64_t now_us,
                         int64_t ahead_us) {
  return gone_from(s, now_us - seen->age_us, later(now_us, ahead_us)) ? margin_true()
                                                                      : margin_false();
}
