#include PROBE_KERNEL_TEXT

#include "swifts_probe.h"

static swifts_point point_of(const int64_t* mm, int64_t stamp_us) {
  swifts_point p;
  p.stamp_us = stamp_us;
  p.valid = 1;
  p.x_lo = p.x_hi = mm[0];
  p.y_lo = p.y_hi = mm[1];
  p.z_lo = p.z_hi = mm[2];
  return p;
}
probe_way probe_way_of(const int64_t* velocity, const int64_t* sent, const int64_t* proposed) {
  static const int64_t origin[3] = {0, 0, 0};
  const int64_t now_us = 10000000, period_us = 50000;
  const swifts_point p = point_of(origin, now_us), v = point_of(velocity, now_us);
  const swifts_point u = point_of(sent, now_us), next = point_of(proposed, now_us);
  const estimate s = estimate_of(&p, &v, now_us, &fly_body);
  swifts_command kept[SWIFTS_COMMANDS];
  probe_way way;
  course c;
  int32_t i;
  for (i = 0; i < SWIFTS_COMMANDS; ++i) {
    kept[i] = command_of(&u, now_us - (i + 1) * period_us, &fly_order);
  }
  c = course_of(&s, &fly_body, &fly_order, kept, &next, now_us, 70000);
  way.usable = c.usable;
  way.count = c.count;
  way.first = c.first;
  way.leg_mm = c.leg_mm;
  way.stop_mm = c.stop_mm;
  for (i = 0; i < c.count && i < 16; ++i) {
    way.at[i][0] = c.at[i].x;
    way.at[i][1] = c.at[i].y;
    way.at[i][2] = c.z[i];
    way.stop[i][0] = c.stop[i].x;
    way.stop[i][1] = c.stop[i].y;
    way.stop[i][2] = c.stop_z[i];
  }
  return way;
}
