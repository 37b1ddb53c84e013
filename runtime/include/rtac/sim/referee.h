// Judges the properties of a fleet on the true state at every simulator step. It shares nothing
// with the generated kernels: it is what their verdicts are measured against.
#pragma once

#include <limits>
#include <vector>

#include "rtac/sim/property.h"

namespace rtac::sim {

// What rounding of doubles may take from a margin: positions are below 1e5 m.
inline constexpr double referee_rounding = 1e-9;

struct LeastMargin {
  double value = std::numeric_limits<double>::infinity();
  TimeUs time_us = never_us;
  int robot = -1;
};
struct Violation {
  TimeUs time_us = never_us;  // never_us: none
  int monitor = -1, robot = -1;
};

class Referee {
 public:
  // One property of each monitor, for each of the robots. All of it outlives the referee.
  // `about`: the only monitor whose violation counts; -1: all.
  Referee(const Surroundings& surroundings, const std::vector<Property>& properties, int robots,
          int about = -1);

  // In the order of time. A margin that cannot have become the least one since it was last judged,
  // as far as robots have moved, is not judged again; no result depends on that.
  void observe(TimeUs now_us, const std::vector<TruthState>& truths);

  // Something has changed that no robot has moved: zones with times.
  void look_anew() { anchors_.assign(anchors_.size(), Anchor{}); }

  [[nodiscard]] const LeastMargin& least(int monitor) const {
    return least_[static_cast<std::size_t>(monitor)];
  }
  [[nodiscard]] const Violation& first_violation() const { return violation_; }
  [[nodiscard]] bool violated() const { return violation_.time_us != never_us; }

 private:
  struct Anchor {
    double margin = -std::numeric_limits<double>::infinity();
    double way_m = 0;  // that the robot and the fastest of all had driven then
  };
  void judge(std::size_t monitor, std::size_t robot, TimeUs now_us,
             const std::vector<TruthState>& truths);
  void count_ways(const std::vector<TruthState>& truths);

  const Surroundings& surroundings_;
  const std::vector<Property>& properties_;
  std::vector<double> steepness_per_m_;
  std::vector<LeastMargin> least_;
  std::vector<Anchor> anchors_;  // by monitor, then robot
  std::vector<Vec3> before_;
  std::vector<double> way_m_;
  double fastest_way_m_ = 0;
  int about_ = -1;
  Violation violation_;
};

}  // namespace rtac::sim
