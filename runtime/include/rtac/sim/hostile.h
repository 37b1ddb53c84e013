// A fleet in a world that is against it: within what is declared, measurements are as misleading,
// as old and as lossy as an attack wants them.
#pragma once

#include <functional>
#include <memory>

#include "rtac/controller.h"
#include "rtac/sim/arena.h"
#include "rtac/sim/tape.h"
#include "rtac/sim/world.h"

namespace rtac::sim {

enum class Noise {
  none,
  uniform,  // anywhere within the errors
  extreme,  // always on the bound, in a random direction
  aimed,    // on the bound, away from where the margin falls fastest
  lasting   // on the bound, the same for the whole run: what no average takes away
};
enum class Ages {
  fresh,     // measured when asked for
  oldest,    // as old as the declared age allows
  unequal,   // one sense fresh, the other as old as possible
  wandering  // any admissible age, anew at every tick; stamps never go backwards
};

struct Hostility {
  std::uint64_t seed = 1;
  Aim aim = Aim::anything;  // of aimed noise
  Noise noise = Noise::aimed;
  Ages ages = Ages::oldest;
  TimeUs fault_every_us = 0;        // mean time between lost or broken samples of a robot; 0: none
  TimeUs jitter_us = 0;             // a tick is up to so late
  TimeUs fault_us_max = 1'000'000;  // how long samples of one sense are lost or broken
  TimeUs deaf_from_us = never_us;   // from then on no robot hears another one; never_us: they do
  TimeUs period_us = 0;             // of decisions: how long a measurement waits to be told of
};

// Between the runtime and a world that measures without noise, whose senses are not asked.
template <class Output>
class HostileFleet final : public FleetSdk<Output> {
 public:
  // All of it outlives the fleet. `on_step`: at time 0 and after every step of the world, whose own
  // callback is the fleet's.
  HostileFleet(World<Output>& world, const Arena& arena, const Hostility& hostility, Tape& tape,
               std::function<void(TimeUs)> on_step);
  ~HostileFleet() override;
  HostileFleet(const HostileFleet&) = delete;
  HostileFleet& operator=(const HostileFleet&) = delete;

  RobotSdk<Output>& robot(int index) override;
  [[nodiscard]] TimeUs now_us() const override;
  bool wait_until(TimeUs time_us) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

extern template class HostileFleet<Acceleration>;
extern template class HostileFleet<Twist>;

}  // namespace rtac::sim
