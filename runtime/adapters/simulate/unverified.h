// Stands where the safe controller of an application would: nobody has verified that one, so this
// one attacks.
#pragma once

#include <memory>
#include <utility>

#include "rtac/controller.h"
#include "rtac/sim/arena.h"
#include "rtac/sim/random.h"

namespace rtac::simulate {

// Towards where the margin falls fastest, away from there, or across, in phases by seed, at no more
// than the speed that is claimed: what is assumed of it between two ticks. Whether the robot stays
// where its author claims is not its concern.
template <class Output>
class Unverified final : public Controller<Output> {
 public:
  // `acts_us`: from a measurement until the last effect of the command that follows from it. The
  // arena outlives the controller.
  Unverified(const sim::Arena& arena, int robot, sim::Aim aim, double speed_mps, TimeUs acts_us,
             std::uint64_t seed);
  Output command(const Observation& observation) override;

 private:
  void choose(TimeUs now_us);

  const sim::Arena& arena_;
  int robot_;
  sim::Aim aim_;
  double speed_mps_, settles_s_;
  sim::Random random_;
  TimeUs until_us_ = never_us;
  double towards_ = 1, across_ = 0;  // of the way that it wants
};

extern template class Unverified<Acceleration>;
extern template class Unverified<Twist>;

// A controller in the place of a recovery: it never holds, and asks for nothing.
template <class Output>
class AsRecovery final : public SafeController<Output> {
 public:
  explicit AsRecovery(std::unique_ptr<Controller<Output>> driver) : driver_(std::move(driver)) {}
  void engage(const Observation& /*observation*/) override {}
  Output command(const Observation& observation, Gate /*gate*/) override {
    return driver_->command(observation);
  }
  [[nodiscard]] bool holding() const override { return false; }

 private:
  std::unique_ptr<Controller<Output>> driver_;
};

}  // namespace rtac::simulate
