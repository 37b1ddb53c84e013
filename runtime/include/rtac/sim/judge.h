// Judges the true state, in doubles, at every simulator step. It shares nothing with the generated
// kernels: it is what their verdicts are measured against.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "rtac/sim/world.h"
#include "rtac/zone.h"

namespace rtac::sim {

// A value below its requirement is a violation.
struct Requirements {
  double clearance_m = 0;     // body to boundary, negative outside
  double gap_m = 0;           // body to body, negative on overlap
  double battery_margin = 0;  // whatever the battery callback returns
};

struct Finding {
  double smallest = std::numeric_limits<double>::infinity();
  TimeUs time_us = never_us;             // of the smallest value
  Vec2 place;                            // of the robot (gap: of the first one) at that time
  TimeUs first_violation_us = never_us;  // never_us: none
  int episodes = 0;                      // separate violations
  [[nodiscard]] bool violated() const { return first_violation_us != never_us; }
};

class SafetyJudge {
 public:
  SafetyJudge(const std::vector<double>& radius_m, const Requirements& requirements);

  // The tables behind the view must outlive the judge. Without a zone no clearance is judged.
  void watch_zone(const ZoneView& zone);
  // Battery above the requirement's need, e.g. battery - energy_to(dock); called at every step.
  void watch_battery(std::function<double(int robot, const TruthState& truth)> margin);

  void observe(TimeUs now_us, const std::vector<TruthState>& truths);

  [[nodiscard]] const Finding& clearance(int robot) const;
  [[nodiscard]] const Finding& gap(int robot, int other) const;  // symmetric, robot != other
  [[nodiscard]] const Finding& battery(int robot) const;
  // Over all robots and requirements.
  [[nodiscard]] bool violated() const;
  [[nodiscard]] TimeUs first_violation_us() const;

 private:
  struct Watch {
    Finding finding;
    bool below = false;
  };
  // The last full evaluation: a clearance changes by at most the distance moved since, so that
  // steps which cannot matter are skipped without changing any result.
  struct Anchor {
    bool valid = false;
    Vec2 place;
    double centre_clearance_m = 0;
  };
  static void record(Watch& watch, double value, double requirement, TimeUs now_us, Vec2 place);
  void judge_clearance(std::size_t robot, TimeUs now_us, Vec2 place);
  void judge_gaps(std::size_t robot, TimeUs now_us, const std::vector<TruthState>& truths);

  std::vector<double> radius_m_;
  Requirements requirements_;
  bool has_zone_ = false;
  ZoneView zone_;
  std::function<double(int, const TruthState&)> battery_margin_;
  std::vector<Watch> clearance_, battery_, gap_;  // gap: robots x robots, used where row < column
  std::vector<Anchor> anchors_;
};

}  // namespace rtac::sim
