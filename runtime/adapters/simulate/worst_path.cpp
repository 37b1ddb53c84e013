#include "worst_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "rtac/optimize/worst_case.h"
#include "rtac/optimize/worst_unicycle.h"
#include "track.h"

namespace rtac::simulate {
namespace {

constexpr int restarts = 60, starts = 3;

WorstPath path_of(Track track, const char* by) {
  const double end_s = track.end_s();
  return {[track = std::move(track)](double time_s) { return track.at(time_s); }, end_s, by};
}

// Every stretch is straight between two places: no farther than the motion itself.
WorstPath path_of(UnicycleMotion motion, double begin_s, const char* by) {
  const double steps = static_cast<double>(motion.places_m.size() - 1);
  const double end_s = begin_s + steps * motion.step_s;
  const auto at = [motion = std::move(motion), begin_s, steps](double time_s) {
    const double s = std::clamp((time_s - begin_s) / motion.step_s, 0.0, steps);
    const auto k = std::min(static_cast<std::size_t>(s), motion.places_m.size() - 2);
    const Vec2 a = motion.places_m[k], b = motion.places_m[k + 1];
    const Vec2 p = a + (s - static_cast<double>(k)) * (b - a);
    return Vec3{p.x, p.y, 0};
  };
  return {at, end_s, by};
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
    found.paths.push_back(path_of({frame, q, searched, push.begin_s}, "Ipopt"));
  } else {
    found.failures = starts;
  }
  const WorstCase drawn = worst_case_by_restarts(q, restarts);
  if (!drawn.positions_m.empty()) {
    found.paths.push_back(path_of({frame, q, drawn, push.begin_s}, "restarts"));
  }
  return found;
}

}  // namespace

std::string not_searched(const RobotLimits& limits) {
  return limits.unicycle && limits.disturbance_mps2 > 0
             ? "motions of a unicycle that is pushed are not searched"
             : "";
}

WorstPaths worst_paths(const RobotLimits& limits, const Push& push) {
  return limits.unicycle ? of_unicycle(limits, push) : of_point(limits, push);
}

// A speed that saturates is projected onto what is allowed. Each piece is straight, at the mean of
// its velocities, so that no more than the acceleration changes them.
WorstPaths worst_paths_told(const RobotLimits& l, const Push& push, Vec3 command_mps2) {
  constexpr int pieces = 1000;
  const auto capped = [&](Vec3 v) {
    const double size = norm(v);
    return size > l.speed_mps ? (l.speed_mps / size) * v : v;
  };
  const Vec3 error = l.disturbance_mps2 * push.normal;
  const double step_s = push.free_s / pieces, brake_mps2 = l.brake_mps2 - l.disturbance_mps2;
  std::vector<Vec3> places{push.robot.position + l.position_error_m * push.normal};
  Vec3 v = capped(push.robot.velocity + l.velocity_error_mps * push.normal + push.apart_s * error);
  for (int k = 0; k < pieces; ++k) {
    const bool told = push.begin_s + k * step_s >= 0;
    const Vec3 next = capped(v + step_s * (told ? command_mps2 + error : error));
    places.push_back(places.back() + (step_s / 2) * (v + next));
    v = next;
  }
  const double begin_s = push.begin_s, brake_s = begin_s + push.free_s;
  const double speed = norm(v), stop_s = speed / brake_mps2;
  WorstPath path;
  path.end_s = brake_s + stop_s;
  path.by = "errors along the normal";
  path.at = [places = std::move(places), v, begin_s, brake_s, step_s, stop_s](double time_s) {
    if (time_s >= brake_s) {
      const double s = std::min(time_s - brake_s, stop_s);
      return stop_s > 0 ? places.back() + s * (1 - s / (2 * stop_s)) * v : places.back();
    }
    const double at = std::max(0.0, time_s - begin_s) / step_s;
    const auto k = std::min(static_cast<std::size_t>(at), places.size() - 2);
    return places[k] + (at - static_cast<double>(k)) * (places[k + 1] - places[k]);
  };
  WorstPaths found;
  found.paths.push_back(std::move(path));
  return found;
}

}  // namespace rtac::simulate
