// Where a robot is in the course of a motion that was searched for.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "rtac/optimize/worst_case.h"
#include "rtac/types.h"

namespace rtac::simulate {

// Half a plane through the measured place of a robot: `across` is what it is pushed along, and
// `aside` what is left of its velocity. By symmetry no motion reaches farther across than one that
// stays in it.
struct Frame {
  Vec3 origin, across, aside;
  [[nodiscard]] Vec3 at(Vec2 p) const { return origin + p.x * across + p.y * aside; }
};
Frame frame_of(Vec3 origin, Vec3 across, Vec3 velocity);

// A free motion up to when the brake acts, and the stop; before and after, it stands.
class Track {
 public:
  // `begin_s`: on the clock of who asks.
  Track(const Frame& frame, const ReachProblem& problem, const WorstCase& motion, double begin_s);
  [[nodiscard]] Vec3 at(double time_s) const;
  // Up to when the brake acts; before it begins it has come straight.
  [[nodiscard]] Vec3 free_place(double time_s) const;
  [[nodiscard]] Vec3 free_velocity(double time_s) const;
  [[nodiscard]] double end_s() const { return end_s_; }
  [[nodiscard]] double brake_s() const { return begin_s_ + brake_s_; }

 private:
  // The knot before, and the time since it, in s.
  [[nodiscard]] std::pair<std::size_t, double> since_knot(double time_s) const;

  Frame frame_;
  std::vector<Vec2> places_, velocities_, pushes_;
  double step_s_, begin_s_, brake_mps2_, brake_s_, end_s_;
};

}  // namespace rtac::simulate
