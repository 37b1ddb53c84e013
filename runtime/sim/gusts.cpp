#include "gusts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace rtac::sim {

Eigen::Vector3d Gusts::direction(const Eigen::Vector3d& velocity) const {
  const double speed = velocity.norm();
  if (style_ == 0 || speed < 1e-6) return steady_;
  const Eigen::Vector3d along = velocity / speed;
  if (style_ == 1) return along;
  // across: any way that is not along, in space
  const Eigen::Vector3d across = along.cross(steady_.z() != 0 ? steady_ : Eigen::Vector3d::UnitZ());
  if (steady_.z() != 0 && across.norm() > 1e-6) return across.normalized();
  return {-along.y(), along.x(), 0};
}

void Gusts::turn(const RobotLimits& limits, TimeUs now_us) {
  constexpr TimeUs aimed_us = 20'000, shortest_us = 200'000, longest_us = 5'000'000;
  if (aim_) {
    until_us_ = now_us + aimed_us;
    const Vec3 to = aim_();
    steady_ = {to.x, to.y, limits.in_space ? to.z : 0};
    return;
  }
  until_us_ = lasting_ ? std::numeric_limits<TimeUs>::max()
                       : now_us + shortest_us + random_.below(longest_us - shortest_us);
  style_ = lasting_ ? 0 : random_.below(3);
  if (limits.in_space) {
    const Vec3 from = random_.on_sphere(1);
    steady_ = {from.x, from.y, from.z};
  } else {
    const Vec2 from = random_.on_circle(1);
    steady_ = {from.x, from.y, 0};
  }
}

void Gusts::blow(Body& body, const RobotLimits& limits, TimeUs now_us, double dt_s) {
  if (now_us >= until_us_) turn(limits, now_us);
  const Eigen::Vector3d push = limits.disturbance_mps2 * direction(body.velocity);
  Eigen::Vector3d next = body.velocity + dt_s * push;
  const double speed = next.norm();
  if (speed > limits.speed_mps) next *= limits.speed_mps / speed;
  body.position += 0.5 * dt_s * (next - body.velocity);
  body.velocity = next;
  body.speed_mps = next.norm();
}

}  // namespace rtac::sim
