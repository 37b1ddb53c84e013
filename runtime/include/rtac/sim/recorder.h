// Keeps what a picture of a run needs: the true paths with the mode that drove, and every switch
// between controllers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rtac/sim/world.h"

namespace rtac::sim {

struct TrackPoint {
  TimeUs time_us = 0;
  Vec2 place;
  int mode = 0;  // 0: advanced controller; holds from this point to the next
};

struct SwitchEvent {
  TimeUs time_us = 0;
  Vec2 place;  // true position
  int robot = 0;
  int mode = 0, previous_mode = 0;
  std::string controller;  // that takes over
  std::string reason;      // a few words
};

struct RecorderOptions {
  TimeUs sample_us = 50'000;
};

class Recorder {
 public:
  explicit Recorder(int robots, const RecorderOptions& options = {});

  // At every physics step; keeps a sample every `sample_us` of the true path.
  void observe(TimeUs now_us, const std::vector<TruthState>& truths);
  // At every tick, after observe() of that time. Text is copied only when the mode changes; the
  // first call of a robot sets the mode it starts in.
  void mode(int robot, TimeUs now_us, int mode, std::string_view controller,
            std::string_view reason);

  [[nodiscard]] int robots() const { return static_cast<int>(tracks_.size()); }
  [[nodiscard]] const std::vector<TrackPoint>& track(int robot) const;
  [[nodiscard]] const std::vector<SwitchEvent>& switches() const { return switches_; }
  // Share of the time since the first mode() of this robot that the advanced controller drove;
  // 1 before any time has passed.
  [[nodiscard]] double advanced_share(int robot) const;

 private:
  struct State {
    bool started = false;
    int mode = 0;
    Vec2 place;
    TimeUs since_us = 0, total_us = 0, advanced_us = 0;
  };
  void account(State& state, TimeUs now_us) const;

  RecorderOptions options_;
  TimeUs next_sample_us_ = INT64_MIN;
  TimeUs now_us_ = 0;
  std::vector<State> states_;
  std::vector<std::vector<TrackPoint>> tracks_;
  std::vector<SwitchEvent> switches_;
};

}  // namespace rtac::sim
