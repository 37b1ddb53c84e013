#include "blame.h"

#include <algorithm>

namespace rtac::simulate {

Blame::Blame(std::size_t robots, std::size_t monitors)
    : has_decided_(robots, false), undecided_(robots) {
  const Drove nobody{0, 0, 0, std::vector<bool>(monitors + 1, false), true};
  of_robot_.assign(robots, std::vector<Drove>(monitors, nobody));
}

void Blame::decided(const DecisionRecord& record) {
  const auto robot = static_cast<std::size_t>(record.robot);
  if (!has_decided_[robot]) --undecided_;
  has_decided_[robot] = true;
  std::vector<Drove>& monitors = of_robot_[robot];
  for (std::size_t m = 0; m < monitors.size(); ++m) {
    Drove& drove = monitors[m];
    drove.holds = record.monitors[m].ahead == Verdict::is_true;
    // what drives from a tick on at which it holds leads to where it fails
    if (drove.holds) drove.held = record.mode;
    if (!record.monitors[m].engaged) {
      drove.free = record.mode;
      drove.modes.assign(drove.modes.size(), false);
    }
    drove.last = record.mode;
    drove.modes[static_cast<std::size_t>(record.mode)] = true;
  }
}

std::vector<Drove> Blame::who(int monitor, int robot) const {
  std::vector<Drove> all;
  for (std::size_t r = 0; r < of_robot_.size(); ++r) {
    const Drove& drove = of_robot_[r][static_cast<std::size_t>(monitor)];
    if (r == static_cast<std::size_t>(robot) || !drove.holds) all.push_back(drove);
  }
  return all;
}

bool as_asked(const Asked& asked, const std::vector<Drove>& who) {
  const auto in = [](const std::vector<bool>& modes, int mode) {
    return modes[static_cast<std::size_t>(mode)];
  };
  return std::any_of(who.begin(), who.end(), [&](const Drove& drove) {
    for (std::size_t mode = 0; mode < asked.not_driven_by.size(); ++mode) {
      if (asked.not_driven_by[mode] && drove.modes[mode]) return false;
    }
    return asked.driven_by.empty() || in(asked.driven_by, drove.held) ||
           in(asked.driven_by, drove.free) || in(asked.driven_by, drove.last);
  });
}

}  // namespace rtac::simulate
