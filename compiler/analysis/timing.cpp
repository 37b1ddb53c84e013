#include "compiler/analysis/timing.h"

#include <algorithm>

namespace rtac::analysis {
namespace {

// The return condition looks further ahead than the check: a period, since what holds for less is
// lost at once. Where commands are judged, more of them, within a time: the check lets the advanced
// controller far beyond the places from which any control is safe, and a place a little deeper is
// cheap for what it brings.
constexpr std::int64_t return_periods_of_commands = 4, return_extra_of_commands_us = 200'000;
// The part of the period that a step may be late where nothing else is declared.
constexpr std::int64_t jitter_share = 10;

}  // namespace

std::int64_t periods_of(const sema::Spec& spec, const sema::Monitor& monitor) {
  const bool is_template = monitor.recover && !std::holds_alternative<sema::ExternController>(
                                                  spec[*monitor.recover].implementation);
  return is_template ? 1 : 2;
}

std::int64_t lookahead_us(const sema::Spec& spec, const sema::Monitor& monitor,
                          std::int64_t period_us) {
  return monitor.ahead.duration ? ceil_to_int(monitor.ahead.duration->value * 1'000'000)
                                : periods_of(spec, monitor) * period_us;
}

// No timer is exact. Where nothing is declared and a look-ahead leaves no room, a step may still
// be late by a part of the period, for which every horizon gets longer.
std::int64_t jitter_us(const sema::Spec& spec, const sema::Decision& decision,
                       std::int64_t period_us, std::int64_t lookahead_most_us) {
  if (decision.jitter) return ceil_to_int(decision.jitter->value * 1'000'000);
  std::int64_t jitter = 0;
  for (const sema::MonitorId id : decision.priority) {
    const std::int64_t ahead_us =
        std::min(lookahead_us(spec, spec[id], period_us), lookahead_most_us);
    const std::int64_t room_us = ahead_us - periods_of(spec, spec[id]) * period_us;
    if (room_us >= 0) jitter = std::max(jitter, period_us / jitter_share - room_us);
  }
  return jitter;
}

std::int64_t return_extra_us(const sema::Spec& spec, const sema::Decision& decision,
                             std::int64_t period_us) {
  const bool commands = std::any_of(decision.priority.begin(), decision.priority.end(),
                                    [&](sema::MonitorId id) { return spec[id].ahead.command; });
  if (!commands) return period_us;
  return std::max(period_us,
                  std::min(return_periods_of_commands * period_us, return_extra_of_commands_us));
}

}  // namespace rtac::analysis
