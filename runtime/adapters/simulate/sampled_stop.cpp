#include "sampled_stop.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "rtac/safe/pilot.h"
#include "rtac/sim/math.h"
#include "track.h"

namespace rtac::simulate {
namespace {

constexpr TimeUs step_us = 1'000;
constexpr double step_s = 1e-6 * step_us;
constexpr TimeUs stamps_from_us = 1'000'000'000;  // stamps are not negative
constexpr double beyond_stop_s = 4;               // the hold has come to rest by then

double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// How samples mislead.
struct Deceit {
  double aside_rad;   // of the error of the velocity, from against the normal
  double seen_first;  // of the error of the place, along the normal: -1 or 1
  double seen_held;   // the same once its place is held
  bool oldest;        // samples are as old as they may be, or of now
};

struct Motion {
  std::vector<Vec3> places, velocities;  // from when the brake acts on, each step
  std::size_t farthest = 0;
  double reach_m = 0;  // there, along the normal
};

class Stop {
 public:
  Stop(const RobotLimits& limits, TimeUs period_us, const FreeMotion& free, Vec3 normal)
      : limits_(limits), period_us_(std::max(period_us, step_us)), free_(free), normal_(normal) {
    const Vec3 v = free_.velocity(free_.brake_s);
    aside_ = frame_of({}, normal_, v).aside;
    const double brake = limits_.brake_mps2 - limits_.disturbance_mps2;
    steps_ = static_cast<std::size_t>((beyond_stop_s + 2 * norm(v) / brake) / step_s);
  }

  // The command that acts first was made a latency before.
  [[nodiscard]] Motion by(const Deceit& deceit) const {
    safe::Setting setting;
    setting.limits = limits_;
    setting.period_us = period_us_;
    safe::Pilot<Acceleration> pilot(setting);
    Motion to;
    to.places.push_back(free_.place(free_.brake_s));
    to.velocities.push_back(free_.velocity(free_.brake_s));
    to.reach_m = dot(to.places.back(), normal_);
    TimeUs next_us = -limits_.latency_us;
    pilot.engage(seen(to, next_us, deceit, false));
    std::vector<std::pair<TimeUs, Vec3>> commands;  // with when they act
    std::size_t acting = 0;
    for (std::size_t k = 0; k < steps_; ++k) {
      const TimeUs now_us = static_cast<TimeUs>(k) * step_us;
      for (; next_us <= now_us; next_us += period_us_) {
        commands.emplace_back(next_us + limits_.latency_us,
                              command(pilot, seen(to, next_us, deceit, pilot.latched())));
      }
      while (acting + 1 < commands.size() && commands[acting + 1].first <= now_us) ++acting;
      move(to, commands[acting].second);
    }
    return to;
  }

  // Steps until it is as slow as when its brake gives way to the hold (lemma still_lag).
  [[nodiscard]] std::size_t stands_after(const Motion& motion) const {
    const double error = limits_.velocity_error_mps, push = limits_.disturbance_mps2;
    const double late_s =
        1e-6 * static_cast<double>(limits_.velocity_age_us + period_us_ + limits_.latency_us);
    const double brake = limits_.brake_mps2;
    const double eta = error + (brake + push) * late_s;
    const double stands_mps = eta * brake / (brake - push) + error;
    const auto found = std::find_if(motion.velocities.begin(), motion.velocities.end(),
                                    [&](Vec3 v) { return norm(v) <= stands_mps; });
    return static_cast<std::size_t>(found - motion.velocities.begin());
  }

 private:
  static Vec3 command(safe::Pilot<Acceleration>& pilot, const Observation& seen) {
    const Acceleration a = pilot.halt(seen);
    return {a.value_mps2.x, a.value_mps2.y, a.up_mps2};
  }
  // `time_us`: since the brake acts.
  [[nodiscard]] Vec3 at(const std::vector<Vec3>& course, const std::function<Vec3(double)>& before,
                        TimeUs time_us) const {
    if (time_us < 0) return before(free_.brake_s + 1e-6 * static_cast<double>(time_us));
    const auto k = static_cast<std::size_t>(time_us / step_us);
    return course[std::min(k, course.size() - 1)];
  }
  [[nodiscard]] Observation seen(const Motion& so_far, TimeUs now_us, const Deceit& deceit,
                                 bool holds) const {
    const TimeUs place_us = now_us - (deceit.oldest ? limits_.position_age_us : 0);
    const TimeUs velocity_us = now_us - (deceit.oldest ? limits_.velocity_age_us : 0);
    const sim::SinCos turn = sim::sin_cos(deceit.aside_rad);
    const Vec3 slower = turn.sin * aside_ - turn.cos * normal_;
    const double end = holds ? deceit.seen_held : deceit.seen_first;
    const Vec3 p =
        at(so_far.places, free_.place, place_us) + end * limits_.position_error_m * normal_;
    const Vec3 v =
        at(so_far.velocities, free_.velocity, velocity_us) + limits_.velocity_error_mps * slower;
    Observation o;
    o.now_us = stamps_from_us + now_us;
    o.position = {{p.x, p.y}, stamps_from_us + place_us};
    o.velocity = {{v.x, v.y}, stamps_from_us + velocity_us};
    o.height_m = p.z;
    o.climb_mps = v.z;
    return o;
  }
  void move(Motion& to, Vec3 command) const {
    const Vec3 a = command + limits_.disturbance_mps2 * normal_;
    const Vec3 v = to.velocities.back();
    Vec3 next = v + step_s * a;
    const double speed = norm(next);
    if (speed > limits_.speed_mps) next = (limits_.speed_mps / speed) * next;
    to.places.push_back(to.places.back() + (step_s / 2) * (v + next));
    to.velocities.push_back(next);
    const double reach_m = dot(to.places.back(), normal_);
    if (reach_m <= to.reach_m) return;
    to.reach_m = reach_m;
    to.farthest = to.places.size() - 1;
  }

  const RobotLimits& limits_;
  TimeUs period_us_;
  const FreeMotion& free_;
  Vec3 normal_, aside_;
  std::size_t steps_ = 0;
};

}  // namespace

WorstPath sampled_stop(const RobotLimits& limits, TimeUs period_us, const FreeMotion& free,
                       Vec3 normal, const char* by) {
  const Stop stop(limits, period_us, free, normal);
  Motion worst;
  bool any = false;
  for (const bool oldest : {false, true}) {
    for (const double aside_rad : {0.0, -sim::pi / 4, sim::pi / 4}) {
      for (const double held : {-1.0, 1.0}) {
        Motion found = stop.by({aside_rad, -held, held, oldest});
        if (any && found.reach_m <= worst.reach_m) continue;
        worst = std::move(found);
        any = true;
      }
    }
  }
  const auto time_after = [&](std::size_t steps) {
    return free.brake_s + step_s * static_cast<double>(steps);
  };
  const double end_s = time_after(worst.farthest), still_s = time_after(stop.stands_after(worst));
  auto at = [free, places = std::move(worst.places)](double time_s) {
    const double steps = (time_s - free.brake_s) / step_s;
    if (steps < 0) return free.place(time_s);
    const auto k = std::min(static_cast<std::size_t>(steps), places.size() - 1);
    return places[k];
  };
  return {std::move(at), end_s, still_s, by};
}

}  // namespace rtac::simulate
