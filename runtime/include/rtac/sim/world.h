// The simulated fleet: point masses (output Acceleration) or unicycles (output Twist) in virtual
// time. Two worlds with equal setups, options, faults and calls produce the same bits.
//
// Integration. Time advances to the next multiple of `step_us`, sampling instant or command
// arrival, whichever comes first, so that stamps and latencies are exact to the microsecond.
//  * Point mass: the exact solution for an acceleration that is constant over the step. A command
//    that brakes through zero is split at the turning point, because `brake` bounds it before and
//    `accel` after. At the speed limit the new velocity is projected radially; the projection is
//    non-expansive, so the acceleration stays within its bound.
//  * Unicycle: the speed profile over the step is integrated exactly (it falls through zero at
//    `brake`, then grows at `accel`); heading by the trapezoidal rule; the displacement is taken
//    along the mid-step heading, which is off by less than V dt (W dt)^2 / 24 per step
//    (7e-11 m for 0.22 m/s, 2.84 rad/s, 1 ms).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "rtac/controller.h"
#include "rtac/types.h"

namespace rtac::sim {

enum class NoiseModel {
  none,
  uniform,  // position and velocity uniform in their discs, heading and battery in their intervals
  extreme   // always on the bound, in a random direction
};

struct RobotSetup {
  RobotLimits limits;
  Vec2 start;
  double heading_rad = 0;
  double battery = 1;  // 1 = full
  bool has_dock = false;
  Vec2 dock;
  double dock_speed_mps = 0.02;  // of whom its dock charges, at most: who rests there
  double height_m = 0;           // of the start, in space
};

struct WorldOptions {
  std::uint64_t seed = 1;
  NoiseModel noise = NoiseModel::uniform;
  bool lasting_gusts = false;  // who is pushed is pushed from one side for the whole run
  // Where the wind drives a robot that is pushed, a unit vector; empty: gusts by seed.
  std::function<Vec3(int robot)> wind;
  TimeUs step_us = 1000;           // clamped to 1 .. 1000
  TimeUs end_us = INT64_MAX;       // wait_until() goes no further and then returns false
  std::size_t commands_max = 256;  // of a robot under way at once; more are lost
};

enum class Sense { position, velocity, heading, battery, announcements };
enum class FaultKind {
  drop,    // samples of the interval are lost
  nan,     // they arrive, but the value is not a number
  freeze,  // they arrive with fresh stamps and the last value from before the fault
  jump     // they arrive displaced by `jump`, for vectors in one random direction per fault
};
// Applies to samples taken in [from_us, until_us); for announcements: to those that `robot` would
// hear and that were sent in that time.
struct Fault {
  int robot = 0;
  Sense sense = Sense::position;
  FaultKind kind = FaultKind::drop;
  TimeUs from_us = 0, until_us = 0;
  double jump = 0;  // m, m/s, rad or share of a full battery; announcements: m
};

struct TruthState {
  Vec2 position;  // m, map frame
  Vec2 velocity;  // m/s, map frame
  double heading_rad = 0;
  double speed_mps = 0;  // unicycle: along the heading, signed; point mass: norm of the velocity
  double turn_radps = 0;
  double battery = 1;
  bool charging = false;               // connected to its dock and not yet full
  double height_m = 0, climb_mps = 0;  // in space: z of position and velocity
};
inline Vec3 position_of(const TruthState& truth) {
  return {truth.position.x, truth.position.y, truth.height_m};
}
inline Vec3 velocity_of(const TruthState& truth) {
  return {truth.velocity.x, truth.velocity.y, truth.climb_mps};
}

inline constexpr double dock_reach_m = 0.15;

// Sensing. Every sense of every robot has its own clock: sampled every max_age/2 with a seeded
// offset, delivered max_age/2 - 1 ms later, so that the age at use comes up to max_age - 1 ms and
// never exceeds it. max_age 0: measured at every call. A first fix of everything is there at
// time 0. Announcements arrive hears_age/2 - 1 ms after they were sent (hears_age 0: at once), so
// a robot that announces every hears_age/2 or faster is heard in time.
template <class Output>
class World final : public FleetSdk<Output> {
 public:
  // Robots beyond max_robots are ignored; the clock starts at 0.
  World(const std::vector<RobotSetup>& robots, const WorldOptions& options);
  ~World() override;
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  RobotSdk<Output>& robot(int index) override;
  [[nodiscard]] TimeUs now_us() const override;
  // Exact: afterwards the clock reads `time_us`, or `end_us` if that comes first.
  bool wait_until(TimeUs time_us) override;

  // The running wait_until() returns false after the present step, and so do all later ones.
  void stop();
  void inject(const Fault& fault);
  // Called after each physics step with the new time; the truth is that of the new time.
  void on_step(std::function<void(TimeUs)> callback);
  [[nodiscard]] const TruthState& truth(int robot) const;
  [[nodiscard]] const std::vector<TruthState>& truths() const;
  // Commands and announcements refused because too many were under way (queues are bounded).
  [[nodiscard]] std::int64_t lost() const;

 private:
  class Robot;
  class Impl;
  std::unique_ptr<Impl> impl_;
};

extern template class World<Acceleration>;
extern template class World<Twist>;

}  // namespace rtac::sim
