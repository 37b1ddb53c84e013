// Recoveries of robots in space that move: after the brake they carry the place of their hold along
// straight legs, so that the robot follows it as closely as it holds. Each leg ends at rest.
#pragma once

#include "rtac/controller.h"
#include "rtac/safe/pilot.h"
#include "rtac/safe/setting.h"

namespace rtac::safe {

class Carried : public SafeController<Acceleration> {
 public:
  explicit Carried(const Setting& setting) : setting_(setting), pilot_(setting) {}
  void engage(const Observation& observation) override;
  void go_on(const Halt& halt) override { pilot_.go_on(halt); }
  [[nodiscard]] std::optional<Halt> halt() const override { return pilot_.halting(); }
  Acceleration command(const Observation& observation, Gate gate) override;
  [[nodiscard]] bool holding() const override { return pilot_.latched() && legs_.empty(); }

 protected:
  static constexpr std::size_t legs_max = 2;
  using Legs = FixedList<Vec3, legs_max>;  // their ends
  // Where to go from a place of rest; nowhere: it stays.
  virtual void look(Vec3 from, Legs& legs) = 0;
  // How far from where its legs end it may be measured, once it rests there.
  [[nodiscard]] double sway_m() const { return pilot_.sway_m(); }

  Setting setting_;

 private:
  // Past robots that are HELD the gate lets it go only on legs that bring it nearer to none of
  // them.
  [[nodiscard]] bool allowed(const Observation& observation, Gate gate) const;

  Pilot<Acceleration> pilot_;
  Legs legs_;
  std::size_t leg_ = 0;
  TimeUs next_look_us_ = never_us;
};

// Up or down, and then on that level, to the nearest place from which control can be given back
// that it sees, never closer to the boundary than now, or than it may be; from outside back in the
// same way. In a zone of the plane, `Setting::zone`, it keeps its height.
class RetreatInSpace final : public Carried {
 public:
  using Carried::Carried;

 private:
  void look(Vec3 from, Legs& legs) override;
};

// Straight down to `Setting::land_at_m`, and stays there. From below it stays where it is.
class Land final : public Carried {
 public:
  using Carried::Carried;

 private:
  void look(Vec3 from, Legs& legs) override;
};

}  // namespace rtac::safe
