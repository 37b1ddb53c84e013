#include "track.h"

#include <algorithm>
#include <cmath>

namespace rtac::simulate {
namespace {

double dot3(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Some unit vector at right angles to another one.
Vec3 any_aside(Vec3 across) {
  const double level = std::sqrt(across.x * across.x + across.y * across.y);
  if (level > 0.5) return (1 / level) * Vec3{-across.y, across.x, 0};
  const Vec3 aside = Vec3{1, 0, 0} - across.x * across;
  return (1 / norm(aside)) * aside;
}

}  // namespace

Frame frame_of(Vec3 origin, Vec3 across, Vec3 velocity) {
  constexpr double least_mps = 1e-9;
  const Vec3 rest = velocity - dot3(velocity, across) * across;
  const double size = norm(rest);
  return {origin, across, size > least_mps ? (1 / size) * rest : any_aside(across)};
}

Track::Track(const Frame& frame, const ReachProblem& problem, const WorstCase& motion,
             double begin_s)
    : frame_(frame),
      places_(motion.positions_m),
      velocities_(motion.velocities_mps),
      pushes_(motion.controls_mps2),
      step_s_(problem.horizon_s / problem.intervals),
      begin_s_(begin_s),
      brake_mps2_(problem.brake_mps2),
      brake_s_(step_s_ * static_cast<double>(motion.brake_at)),
      end_s_(0) {
  places_.resize(motion.brake_at + 1);
  velocities_.resize(motion.brake_at + 1);
  end_s_ = begin_s_ + brake_s_ + norm(velocities_.back()) / brake_mps2_;
}

std::pair<std::size_t, double> Track::since_knot(double time_s) const {
  const double t = std::min(time_s - begin_s_, brake_s_);
  if (t <= 0 || places_.size() < 2) return {0, std::min(t, 0.0)};
  const auto k = std::min(places_.size() - 2, static_cast<std::size_t>(t / step_s_));
  return {k, t - step_s_ * static_cast<double>(k)};
}

Vec3 Track::free_place(double time_s) const {
  const auto [k, s] = since_knot(time_s);
  const double pushed_s = std::max(s, 0.0);
  return frame_.at(places_[k] + s * velocities_[k] + (pushed_s * pushed_s / 2) * pushes_[k]);
}

Vec3 Track::free_velocity(double time_s) const {
  const auto [k, s] = since_knot(time_s);
  const Vec2 v = velocities_[k] + std::max(s, 0.0) * pushes_[k];
  return v.x * frame_.across + v.y * frame_.aside;
}

Vec3 Track::at(double time_s) const {
  const double t = std::max(0.0, time_s - begin_s_);
  if (t < brake_s_) return free_place(std::max(time_s, begin_s_));
  const Vec2 v = velocities_.back();
  const double speed = norm(v);
  if (speed <= 0) return frame_.at(places_.back());
  const double s = std::min(t - brake_s_, speed / brake_mps2_);
  return frame_.at(places_.back() + s * (1 - s * brake_mps2_ / (2 * speed)) * v);
}

}  // namespace rtac::simulate
