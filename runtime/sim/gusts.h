// Private: what pushes a robot that declares a disturbance, always at its bound.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>

#include "motion.h"
#include "rtac/sim/random.h"

namespace rtac::sim {

// A steady wind from anywhere, along the motion or across it: each for a while, by seed. Or one
// that is aimed.
class Gusts {
 public:
  // `lasting`: a steady wind that never turns. `aim`: where it blows to, a unit vector, or none of
  // length; empty: by seed.
  Gusts(Random random, bool lasting, std::function<Vec3()> aim)
      : random_(random), lasting_(lasting), aim_(std::move(aim)) {}
  // Moves and speeds up `body` by what a gust does in `dt_s`, within its declared speed.
  void blow(Body& body, const RobotLimits& limits, TimeUs now_us, double dt_s);

 private:
  void turn(const RobotLimits& limits, TimeUs now_us);
  [[nodiscard]] Eigen::Vector3d direction(const Eigen::Vector3d& velocity) const;

  Random random_;
  bool lasting_;
  std::function<Vec3()> aim_;
  TimeUs until_us_ = 0;
  std::int64_t style_ = 0;
  Eigen::Vector3d steady_ = Eigen::Vector3d::Zero();
};

}  // namespace rtac::sim
