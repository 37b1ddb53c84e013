// Tables of when zones are there.
#pragma once

#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::ir {

inline constexpr std::int64_t us_per_day = 86'400'000'000, us_per_week = 7 * us_per_day;

Schedule schedule_of(const sema::Zone& zone);

// The schedule of the zone in the list, which gets one if it has none.
ScheduleIndex schedule_in(std::vector<Schedule>& all, const sema::Zone& zone);

}  // namespace rtac::ir
