#include "compiler/ir/schedule.h"

#include <algorithm>

namespace rtac::ir {
namespace {

// In order, and what overlaps or touches is one.
std::vector<Opening> joined(std::vector<Opening> all) {
  std::sort(all.begin(), all.end(),
            [](const Opening& a, const Opening& b) { return a.from_us < b.from_us; });
  std::vector<Opening> out;
  for (const Opening& each : all) {
    if (out.empty() || out.back().until_us < each.from_us) {
      out.push_back(each);
    } else {
      out.back().until_us = std::max(out.back().until_us, each.until_us);
    }
  }
  return out;
}

}  // namespace

Schedule schedule_of(const sema::Zone& zone) {
  constexpr std::int64_t us_per_s = 1'000'000;
  std::vector<Opening> once, weekly;
  for (const sema::Opening& each : zone.openings) {
    const Opening opening{each.from_s * us_per_s, each.until_s * us_per_s};
    if (each.days == 0) once.push_back(opening);
    for (unsigned day = 0; day < 7; ++day) {
      if ((each.days >> day & 1U) == 0) continue;
      const std::int64_t midnight_us = day * us_per_day;
      weekly.push_back({midnight_us + opening.from_us, midnight_us + opening.until_us});
    }
  }
  return {zone.name, joined(std::move(once)), joined(std::move(weekly))};
}

ScheduleIndex schedule_in(std::vector<Schedule>& all, const sema::Zone& zone) {
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Schedule& each) { return each.name == zone.name; });
  const auto index = static_cast<std::uint32_t>(found - all.begin());
  if (found == all.end()) all.push_back(schedule_of(zone));
  return ScheduleIndex{index};
}

}  // namespace rtac::ir
