// External recoveries: nobody has verified them, but their author claims that a robot which they
// drive stays inside a zone, at most at a certain speed. The claim is checked in every tick under
// that motion; where it fails, the robot brakes and holds.
#pragma once

#include "rtac/controller.h"
#include "rtac/safe/pilot.h"

namespace rtac::safe {

struct Claim {
  const ZoneView* zone = nullptr;
  double speed_mps = 0;
  TimeUs reaction_us = 0;  // until the next decision acts: look-ahead, jitter and latency
  double accel_mps2 = 0;   // of the reference point, turning included
  // How far the braked path may be from the straight stop (theory, the brake: rho_sc): a time at
  // the speed it begins with, a part of the straight stop, and the hold.
  double brake_lag_s = 0, brake_bend = 0, hold_m = 0;
  const SolidView* solid = nullptr;  // in space, in the place of `zone`: one with height
};

// All that the robot can touch until the next decision, and then braking, lies in the zone, and it
// is not surely faster than claimed. False without measurements: what is unknown is not claimed.
bool claim_holds(const Claim& claim, const RobotLimits& limits, TimeUs period_us,
                 const Observation& observation);

template <class Output>
class Claimed final : public SafeController<Output> {
 public:
  Claimed(const Setting& setting, const Claim& claim)
      : claim_(claim), limits_(setting.limits), period_us_(setting.period_us), pilot_(setting) {}
  // Before the first use.
  void attach(SafeController<Output>& external) { external_ = &external; }

  void engage(const Observation& observation) override {
    pilot_.engage(observation);
    braking_ = false;
    external_->engage(observation);
  }
  void go_on(const Halt& halt) override {
    pilot_.go_on(halt);
    braking_ = true;  // unless the claim holds, it goes on with that
    external_->go_on(halt);
  }
  [[nodiscard]] std::optional<Halt> halt() const override {
    // nobody has verified that what drives otherwise is at rest
    return braking_ ? pilot_.halting() : std::nullopt;
  }
  // The gate binds it whatever the external controller makes of it.
  Output command(const Observation& observation, Gate gate) override {
    const bool drives = gate == Gate::free && keeps_claim(observation);
    if (!drives && !braking_) pilot_.engage(observation);
    braking_ = !drives;
    if (drives) return external_->command(observation, gate);
    return pilot_.can_steer(observation) ? pilot_.halt(observation)
                                         : pilot_.brake_blind(observation);
  }
  [[nodiscard]] bool keeps_claim(const Observation& observation) const override {
    return claim_holds(claim_, limits_, period_us_, observation);
  }
  [[nodiscard]] bool holding() const override {
    return braking_ ? pilot_.latched() : external_->holding();
  }
  [[nodiscard]] bool blocked() const override { return external_->blocked(); }
  [[nodiscard]] bool parked() const override { return external_->parked(); }
  [[nodiscard]] bool errand() const override { return external_->errand(); }
  [[nodiscard]] const Path* path() const override { return external_->path(); }

 private:
  Claim claim_;
  RobotLimits limits_;
  TimeUs period_us_;
  Pilot<Output> pilot_;
  SafeController<Output>* external_ = nullptr;
  bool braking_ = false;
};

}  // namespace rtac::safe
