#include "rtac/sim/recorder.h"

#include <algorithm>

namespace rtac::sim {

Recorder::Recorder(int robots, const RecorderOptions& options)
    : options_(options),
      states_(static_cast<std::size_t>(std::max(0, robots))),
      tracks_(states_.size()) {
  options_.sample_us = std::max<TimeUs>(1, options_.sample_us);
}

void Recorder::observe(TimeUs now_us, const std::vector<TruthState>& truths) {
  now_us_ = now_us;
  const bool is_due = now_us >= next_sample_us_;
  if (is_due) next_sample_us_ = now_us + options_.sample_us;
  for (std::size_t i = 0; i < states_.size() && i < truths.size(); ++i) {
    states_[i].place = truths[i].position;
    if (is_due) tracks_[i].push_back({now_us, truths[i].position, states_[i].mode});
  }
}

void Recorder::account(State& state, TimeUs now_us) const {
  const TimeUs elapsed_us = now_us - state.since_us;
  state.total_us += elapsed_us;
  if (state.mode == 0) state.advanced_us += elapsed_us;
  state.since_us = now_us;
}

void Recorder::mode(int robot, TimeUs now_us, int mode, std::string_view controller,
                    std::string_view reason) {
  const auto i = static_cast<std::size_t>(robot);
  State& state = states_[i];
  if (!state.started) {
    state.started = true;
    state.mode = mode;
    state.since_us = now_us;
    if (!tracks_[i].empty()) tracks_[i].back().mode = mode;
    return;
  }
  account(state, now_us);
  if (mode == state.mode) return;
  switches_.push_back(
      {now_us, state.place, robot, mode, state.mode, std::string(controller), std::string(reason)});
  state.mode = mode;
  tracks_[i].push_back({now_us, state.place, mode});
}

const std::vector<TrackPoint>& Recorder::track(int robot) const {
  return tracks_[static_cast<std::size_t>(robot)];
}

double Recorder::advanced_share(int robot) const {
  State state = states_[static_cast<std::size_t>(robot)];
  if (state.started && now_us_ > state.since_us) account(state, now_us_);
  if (state.total_us == 0) return 1;
  return static_cast<double>(state.advanced_us) / static_cast<double>(state.total_us);
}

}  // namespace rtac::sim
