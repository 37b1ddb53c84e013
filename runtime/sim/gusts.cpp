#include "gusts.h"

#include <algorithm>

namespace rtac::sim {

Eigen::Vector2d Gusts::direction(const Eigen::Vector2d& velocity) const {
  const double speed = velocity.norm();
  if (style_ == 0 || speed < 1e-6) return steady_;
  const Eigen::Vector2d along = velocity / speed;
  if (style_ == 1) return along;
  return {-along.y(), along.x()};
}

void Gusts::blow(Body& body, const RobotLimits& limits, TimeUs now_us, double dt_s) {
  if (now_us >= until_us_) {
    constexpr std::int64_t shortest_us = 200'000, longest_us = 5'000'000;
    until_us_ = now_us + shortest_us + random_.below(longest_us - shortest_us);
    style_ = random_.below(3);
    const Vec2 from = random_.on_circle(1);
    steady_ = {from.x, from.y};
  }
  const Eigen::Vector2d push = limits.disturbance_mps2 * direction(body.velocity);
  Eigen::Vector2d next = body.velocity + dt_s * push;
  const double speed = next.norm();
  if (speed > limits.speed_mps) next *= limits.speed_mps / speed;
  body.position += 0.5 * dt_s * (next - body.velocity);
  body.velocity = next;
  body.speed_mps = next.norm();
}

}  // namespace rtac::sim
