// What one robot knows of itself and of the others of its kind (rules 6 and 7).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/interp/outline.h"
#include "compiler/interp/signals.h"
#include "compiler/interp/span.h"
#include "compiler/sema/spec.h"

namespace rtac::interp {

// A plan that is proposed: way-points, to the nearest mm, and the next of them.
struct Plan {
  std::vector<Place> points;
  std::int64_t index = 0;
};
// The newest samples of one robot: position and velocity x, y, in space z; battery; whether it is
// present. The plan that it proposed last; none: none that can be read.
struct RobotSamples {
  std::optional<Sample> position, velocity, battery, presence;
  std::optional<Plan> plan;
};
using FleetSamples = std::vector<RobotSamples>;  // by RobotId

class Robots {
 public:
  // The specification outlives the robots; `self` is the one that looks.
  Robots(const sema::Spec& spec, sema::RobotId self);
  void arrive(std::int64_t now_us, const FleetSamples& samples);
  // A tick that was missed sees nothing.
  void miss() { signals_.miss(); }

  // A plan over its capacity, or whose index is none of its way-points nor the end, is unknown.
  void propose(const std::optional<Plan>& plan);
  [[nodiscard]] const std::optional<Plan>& plan() const { return plan_; }

  [[nodiscard]] const sema::RobotKind& kind() const { return kind_; }
  [[nodiscard]] sema::RobotId self() const { return self_; }
  // The others of its kind that have not said that they are absent.
  [[nodiscard]] std::vector<sema::RobotId> others() const;

  // The centre as measured; none: unknown.
  [[nodiscard]] std::optional<Place> place(sema::RobotId robot) const;
  // How high that is; none: unknown, or in the plane.
  [[nodiscard]] std::optional<Rational> height(sema::RobotId robot) const;
  [[nodiscard]] Span altitude() const;  // of this robot
  // How far the true centre may be from that, m.
  [[nodiscard]] const Rational& place_error() const { return kind_.position->error.value; }
  // Between the bodies of this robot and another one, m; negative where they overlap.
  [[nodiscard]] Span distance(sema::RobotId other) const;
  // Of what this robot senses, s.
  [[nodiscard]] Span age(sema::Sensed signal) const;
  [[nodiscard]] Span battery(sema::RobotId robot) const;
  [[nodiscard]] Span speed(sema::RobotId robot) const;
  // At least the straight way takes, and how much more is not known.
  [[nodiscard]] Span energy_to(sema::SiteId site) const;

 private:
  enum class Field : std::uint32_t { position, velocity, battery, presence };
  static std::vector<sema::Input> declared(const sema::Spec& spec, sema::RobotId self);
  [[nodiscard]] static sema::InputId id(sema::RobotId robot, Field field);

  const sema::Spec& spec_;
  sema::RobotId self_;
  const sema::RobotKind& kind_;
  std::vector<sema::Input> inputs_;  // by robot and field
  Signals signals_;
  std::optional<Plan> plan_;
};

}  // namespace rtac::interp
