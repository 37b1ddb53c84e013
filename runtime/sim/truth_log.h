// Private: the true states of the last few seconds, to be measured later than they were true.
#pragma once

#include <algorithm>
#include <deque>
#include <vector>

#include "rtac/sim/world.h"

namespace rtac::sim {

class TruthLog {
 public:
  explicit TruthLog(TimeUs longest_us) : longest_us_(longest_us) {}

  void push(TimeUs now_us, const std::vector<TruthState>& truths) {
    // One moment before the horizon stays, so that there is always one as old as may be.
    while (moments_.size() > 1 && moments_[1].time_us <= now_us - longest_us_) {
      spare_.swap(moments_.front().truths);
      moments_.pop_front();
    }
    spare_.assign(truths.begin(), truths.end());
    moments_.push_back({now_us, {}});
    moments_.back().truths.swap(spare_);
  }
  struct Moment {
    TimeUs time_us = 0;
    std::vector<TruthState> truths;
  };
  // The first one that is not before `time_us`.
  [[nodiscard]] const Moment& at(TimeUs time_us) const {
    const auto found = std::lower_bound(moments_.begin(), moments_.end(), time_us,
                                        [](const Moment& m, TimeUs us) { return m.time_us < us; });
    return found == moments_.end() ? moments_.back() : *found;
  }

 private:
  TimeUs longest_us_;
  std::deque<Moment> moments_;
  std::vector<TruthState> spare_;
};

}  // namespace rtac::sim
