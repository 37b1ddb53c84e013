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
