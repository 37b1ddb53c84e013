// Advanced controllers that try to break things. They see what a controller sees: measurements,
// never the truth.
#pragma once

#include <vector>

#include "rtac/controller.h"
#include "rtac/sim/random.h"
#include "rtac/zone.h"

namespace rtac::sim {

// Full effort towards the nearest boundary of the zone or the nearest heard robot (taken to be of
// its own kind), whichever gap is smaller; once outside, further out. A unicycle drives backwards
// when that is the shorter turn.
template <class Output>
class PushAtNearest final : public Controller<Output> {
 public:
  // `zone` may be null (robots only); its tables must outlive the controller.
  PushAtNearest(const RobotLimits& limits, const ZoneView* zone);
  Output command(const Observation& observation) override;

 private:
  [[nodiscard]] Vec2 push_direction(const Observation& observation) const;
  RobotLimits limits_;
  const ZoneView* zone_;
  Vec2 last_direction_{1, 0};
};

// Random full-scale commands: acceleration in a random direction, or a random corner of the twist
// limits (turn -max, 0, max), held for a random time in [hold_min, hold_max].
template <class Output>
class BangBang final : public Controller<Output> {
 public:
  BangBang(const RobotLimits& limits, std::uint64_t seed, TimeUs hold_us_min = 100'000,
           TimeUs hold_us_max = 2'000'000);
  Output command(const Observation& observation) override;

 private:
  RobotLimits limits_;
  Random random_;
  TimeUs hold_us_min_, hold_us_max_;
  TimeUs until_us_ = never_us;
  Output held_{};
};

// Plays commands back: the newest entry that is not later than now; before the first one, zero.
template <class Output>
class Replay final : public Controller<Output> {
 public:
  struct Entry {
    TimeUs from_us = 0;
    Output output{};
  };
  explicit Replay(std::vector<Entry> entries);  // in any order
  Output command(const Observation& observation) override;

 private:
  std::vector<Entry> entries_;  // by time
};

extern template class PushAtNearest<Acceleration>;
extern template class PushAtNearest<Twist>;
extern template class BangBang<Acceleration>;
extern template class BangBang<Twist>;
extern template class Replay<Acceleration>;
extern template class Replay<Twist>;

}  // namespace rtac::sim
