#include "worst_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "rtac/optimize/worst_case.h"
#include "rtac/optimize/worst_unicycle.h"
#include "sampled_stop.h"
#include "track.h"

namespace rtac::simulate {
namespace {

constexpr int restarts = 60, starts = 3;
// In a step of a motion.
constexpr double stands_m = 1e-9;

// Stopped by an ideal brake, and by its pilot.
void add(WorstPaths& to, const RobotLimits& limits, const Push& push, Track track, const char* by) {
  const FreeMotion free{[track](double time_s) { return track.free_place(time_s); },
                        [track](double time_s) { return track.free_velocity(time_s); },
                        track.brake_s()};
  to.paths.push_back(sampled_stop(limits, push.period_us, free, push.normal, by));
  const double end_s = track.end_s();
  to.paths.push_back(
      {[track = std::move(track)](double time_s) { return track.at(time_s); }, end_s, end_s, by});
}

// Every stretch is straight between two places: no farther than the motion itself.
WorstPath path_of(UnicycleMotion motion, double begin_s, const char* by) {
  const double steps = static_cast<double>(motion.places_m.size() - 1);
  const double end_s = begin_s + steps * motion.step_s;
  // The turn may run down for longer than the speed: who only turns stands.
  std::size_t last = motion.places_m.size() - 1;
  while (last > 0 && norm(motion.places_m[last] - motion.places_m[last - 1]) < stands_m) --last;
  const double still_s = begin_s + static_cast<double>(last) * motion.step_s;
  const auto at = [motion = std::move(motion), begin_s, steps](double time_s) {
    const double s = std::clamp((time_s - begin_s) / motion.step_s, 0.0, steps);
    const auto k = std::min(static_cast<std::size_t>(s), motion.places_m.size() - 2);
    const Vec2 a = motion.places_m[k], b = motion.places_m[k + 1];
    const Vec2 p = a + (s - static_cast<double>(k)) * (b - a);
    return Vec3{p.x, p.y, 0};
  };
  return {at, end_s, still_s, by};
}

WorstPaths of_unicycle(const RobotLimits& l, const Push& push) {
  UnicycleProblem q;
  const Moving& robot = push.robot;
  q.position = {robot.position.x, robot.position.y};
  q.velocity = {robot.velocity.x, robot.velocity.y};
  q.heading_rad = robot.heading_rad;
  q.position_error_m = l.position_error_m;
  // it may have changed before the position was measured
  q.velocity_error_mps = l.velocity_error_mps + push.apart_s * l.accel_mps2;
  q.heading_error_rad = l.heading_error_rad;
  q.accel_mps2 = l.accel_mps2;
  q.brake_mps2 = l.brake_mps2;
  q.speed_mps = l.speed_mps;
  q.turn_radps = l.turn_radps;
  q.turn_accel_radps2 = l.turn_accel_radps2;
  q.horizon_s = push.free_s;
  q.normal = {push.normal.x, push.normal.y};
  q.starts = starts;
  WorstPaths found;
  found.searches = starts;
  UnicycleMotion searched = worst_motion(q);
  if (searched.status == SearchStatus::converged) {
    found.paths.push_back(path_of(std::move(searched), push.begin_s, "Ipopt"));
  } else {
    found.failures = starts;
  }
  UnicycleMotion drawn = worst_motion_by_restarts(q, restarts);
  if (!drawn.places_m.empty()) {
    found.paths.push_back(path_of(std::move(drawn), push.begin_s, "restarts"));
  }
  return found;
}

// In half a plane, see Frame.
WorstPaths of_point(const RobotLimits& l, const Push& push) {
  const Moving& robot = push.robot;
  const Frame frame = frame_of(robot.position, push.normal, robot.velocity);
  const auto along = [&](Vec3 axis) {
    return robot.velocity.x * axis.x + robot.velocity.y * axis.y + robot.velocity.z * axis.z;
  };
  ReachProblem q;
  q.position = {0, 0};
  q.velocity = {along(frame.across), along(frame.aside)};
  q.position_error_m = l.position_error_m;
  // what pushes it pushes it on, and takes from its brake
  q.accel_mps2 = l.accel_mps2 + l.disturbance_mps2;
  q.brake_mps2 = l.brake_mps2 - l.disturbance_mps2;
  // it may have changed before the position was measured
  q.velocity_error_mps = l.velocity_error_mps + push.apart_s * q.accel_mps2;
  q.speed_mps = l.speed_mps;
  q.horizon_s = push.free_s;
  q.normal = {1, 0};
  q.starts = starts;
  WorstPaths found;
  found.searches = starts;
  const WorstCase searched = worst_case(q);
  if (searched.status == SearchStatus::converged) {
    add(found, l, push, {frame, q, searched, push.begin_s}, "Ipopt");
  } else {
    found.failures = starts;
  }
  const WorstCase drawn = worst_case_by_restarts(q, restarts);
  if (!drawn.positions_m.empty()) {
    add(found, l, push, {frame, q, drawn, push.begin_s}, "restarts");
  }
  return found;
}

// What a point mass does that is told so, and pushed along the normal by all errors. A speed that
// saturates is projected onto what is allowed. Each piece is straight, at the mean of its
// velocities, so that no more than the acceleration changes them.
class ToldCourse {
 public:
  ToldCourse(const RobotLimits& l, const Push& push, Vec3 command_mps2)
      : begin_s_(push.begin_s), step_s_(push.free_s / pieces) {
    const auto capped = [&](Vec3 v) {
      const double size = norm(v);
      return size > l.speed_mps ? (l.speed_mps / size) * v : v;
    };
    const Vec3 error = l.disturbance_mps2 * push.normal;
    places_.push_back(push.robot.position + l.position_error_m * push.normal);
    velocities_.push_back(
        capped(push.robot.velocity + l.velocity_error_mps * push.normal + push.apart_s * error));
    for (int k = 0; k < pieces; ++k) {
      const bool told = begin_s_ + k * step_s_ >= 0;
      const Vec3 v = velocities_.back();
      const Vec3 next = capped(v + step_s_ * (told ? command_mps2 + error : error));
      places_.push_back(places_.back() + (step_s_ / 2) * (v + next));
      velocities_.push_back(next);
    }
  }
  [[nodiscard]] Vec3 place(double time_s) const { return between(places_, time_s); }
  [[nodiscard]] Vec3 velocity(double time_s) const { return between(velocities_, time_s); }

 private:
  static constexpr int pieces = 1000;

  [[nodiscard]] Vec3 between(const std::vector<Vec3>& all, double time_s) const {
    const double at = std::clamp((time_s - begin_s_) / step_s_, 0.0, double{pieces});
    const auto k = std::min(static_cast<std::size_t>(at), all.size() - 2);
    return all[k] + (at - static_cast<double>(k)) * (all[k + 1] - all[k]);
  }

  double begin_s_, step_s_;
  std::vector<Vec3> places_, velocities_;
};

}  // namespace

std::string not_searched(const RobotLimits& limits) {
  return limits.unicycle && limits.disturbance_mps2 > 0
             ? "motions of a unicycle that is pushed are not searched"
             : "";
}

WorstPaths worst_paths(const RobotLimits& limits, const Push& push) {
  return limits.unicycle ? of_unicycle(limits, push) : of_point(limits, push);
}

WorstPaths worst_paths_told(const RobotLimits& l, const Push& push, Vec3 command_mps2) {
  const auto course = std::make_shared<const ToldCourse>(l, push, command_mps2);
  const double brake_s = push.begin_s + push.free_s;
  const FreeMotion free{[course](double time_s) { return course->place(time_s); },
                        [course](double time_s) { return course->velocity(time_s); }, brake_s};
  constexpr const char* by = "errors along the normal";
  const Vec3 from = free.place(brake_s), v = free.velocity(brake_s);
  const double stop_s = norm(v) / (l.brake_mps2 - l.disturbance_mps2);
  const auto ideal = [free, from, v, brake_s, stop_s](double time_s) {
    if (time_s < brake_s) return free.place(time_s);
    const double s = std::min(time_s - brake_s, stop_s);
    return stop_s > 0 ? from + s * (1 - s / (2 * stop_s)) * v : from;
  };
  WorstPaths found;
  found.paths.push_back({ideal, brake_s + stop_s, brake_s + stop_s, by});
  found.paths.push_back(sampled_stop(l, push.period_us, free, push.normal, by));
  return found;
}

}  // namespace rtac::simulate
