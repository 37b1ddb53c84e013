#include "compiler/interp/robots.h"

#include <algorithm>
#include <utility>

#include "compiler/sema/dimension.h"

namespace rtac::interp {
namespace {

constexpr std::uint32_t fields = 4;

// Rule 6: a robot hears of the others what they sense, at most as old as its kind declares.
sema::Input measurement(const std::optional<sema::Sense>& sense,
                        std::vector<std::string> components,
                        const std::optional<sema::Quantity>& heard_max_age) {
  sema::Input input{};
  input.type = sema::InputType::real;
  input.components = std::move(components);
  if (!sense) return input;
  input.error = sense->error;
  input.max_age = heard_max_age ? *heard_max_age : sense->max_age;
  return input;
}

// Beyond an empty and a full battery by more than the error nothing is known; two steps of the grid
// of 1 ppm more, since generated code knows the charge on that grid.
void limit_charge(sema::Input& input) {
  if (!input.error) return;
  const Rational slack = input.error->value + Rational(2, 1000000);
  input.least = sema::Quantity{-slack, input.error->range};
  input.most = sema::Quantity{1 + slack, input.error->range};
}

Rational squared(const Rational& value) {
  return value * value;
}

// `up`: how much higher the one is than the other.
Root length(const Place& from, const Place& to, const Rational& up = 0) {
  return square_root(Rational(squared(to.x - from.x) + squared(to.y - from.y) + squared(up)));
}

}  // namespace

std::vector<sema::Input> Robots::declared(const sema::Spec& spec, sema::RobotId self) {
  std::vector<sema::Input> inputs;
  for (std::uint32_t r = 0; r < spec.robots.size(); ++r) {
    const sema::RobotKind& kind = spec[spec.robots[r].kind];
    const auto heard = sema::RobotId{r} == self ? std::nullopt : kind.hears_max_age;
    std::vector<std::string> axes{"x", "y"};
    if (kind.in_space) axes.emplace_back("z");
    inputs.push_back(measurement(kind.position, axes, heard));
    inputs.push_back(measurement(kind.velocity, axes, heard));
    inputs.push_back(measurement(kind.battery, {""}, heard));
    limit_charge(inputs.back());
    sema::Input presence{};
    presence.type = sema::InputType::boolean;
    presence.components = {""};
    presence.max_age = kind.hears_max_age;
    inputs.push_back(std::move(presence));
  }
  return inputs;
}

Robots::Robots(const sema::Spec& spec, sema::RobotId self)
    : spec_(spec),
      self_(self),
      kind_(spec[spec[self].kind]),
      inputs_(declared(spec, self)),
      signals_(inputs_) {}

sema::InputId Robots::id(sema::RobotId robot, Field field) {
  return sema::InputId{static_cast<std::uint32_t>(robot) * fields +
                       static_cast<std::uint32_t>(field)};
}

void Robots::arrive(std::int64_t now_us, const FleetSamples& samples) {
  Inputs inputs;
  inputs.reserve(inputs_.size());
  for (const RobotSamples& robot : samples) {
    for (const auto* sample : {&robot.position, &robot.velocity, &robot.battery, &robot.presence}) {
      inputs.push_back(*sample);
    }
  }
  signals_.arrive(now_us, now_us, inputs);
}

// Rule 8.
void Robots::propose(const std::optional<Plan>& plan) {
  plan_.reset();
  if (!plan || !kind_.plan) return;
  const auto count = static_cast<std::int64_t>(plan->points.size());
  if (count <= kind_.plan->capacity && plan->index >= 0 && plan->index <= count) plan_ = plan;
}

// Rule 6.5: absence is asserted, never inferred from silence.
std::vector<sema::RobotId> Robots::others() const {
  std::vector<sema::RobotId> others;
  for (std::uint32_t r = 0; r < spec_.robots.size(); ++r) {
    const sema::RobotId robot{r};
    if (robot == self_ || spec_.robots[r].kind != spec_[self_].kind) continue;
    const auto& present = signals_.measured(id(robot, Field::presence), 0);
    const bool absent = kind_.open_fleet && present && *present == 0;
    if (!absent) others.push_back(robot);
  }
  return others;
}

std::optional<Place> Robots::place(sema::RobotId robot) const {
  const auto& x = signals_.measured(id(robot, Field::position), 0);
  const auto& y = signals_.measured(id(robot, Field::position), 1);
  if (!x || !y || (kind_.in_space && !height(robot))) return std::nullopt;
  return Place{*x, *y};
}

std::optional<Rational> Robots::height(sema::RobotId robot) const {
  if (!kind_.in_space) return std::nullopt;
  return signals_.measured(id(robot, Field::position), 2);
}

// Its parts arrive together: without one of them nothing is known.
Span Robots::altitude() const {
  const auto z = height(self_);
  if (!place(self_) || !z) return unknown(std::nullopt);
  return between(Rational(*z - place_error()), Rational(*z + place_error()));
}

Span Robots::distance(sema::RobotId other) const {
  const auto from = place(self_), to = place(other);
  if (!from || !to) return unknown(std::nullopt);
  const auto from_z = height(self_), to_z = height(other);
  const Rational up = from_z && to_z ? Rational(*to_z - *from_z) : Rational(0);
  const Root centres = length(*from, *to, up);
  const Rational error = 2 * place_error(), bodies = 2 * kind_.radius.value;
  return between(Rational(centres.below - error - bodies),
                 Rational(centres.above + error - bodies));
}

Span Robots::age(sema::Sensed signal) const {
  switch (signal) {
    case sema::Sensed::position:
      return signals_.age(id(self_, Field::position));
    case sema::Sensed::velocity:
      return signals_.age(id(self_, Field::velocity));
    case sema::Sensed::battery:
      return signals_.age(id(self_, Field::battery));
  }
  return unknown(std::nullopt);
}

Span Robots::battery(sema::RobotId robot) const {
  const auto& charge = signals_.measured(id(robot, Field::battery), 0);
  if (!charge) return unknown(std::nullopt);
  const Rational& error = kind_.battery->error.value;
  return between(Rational(*charge - error), Rational(*charge + error));
}

Span Robots::speed(sema::RobotId robot) const {
  const auto& x = signals_.measured(id(robot, Field::velocity), 0);
  const auto& y = signals_.measured(id(robot, Field::velocity), 1);
  if (!x || !y) return unknown(std::nullopt);
  Rational square = squared(*x) + squared(*y);
  if (kind_.in_space) {
    const auto& z = signals_.measured(id(robot, Field::velocity), 2);
    if (!z) return unknown(std::nullopt);
    square += squared(*z);
  }
  const Root speed = square_root(square);
  const Rational& error = kind_.velocity->error.value;
  return between(Rational(std::max(Rational(0), Rational(speed.below - error))),
                 Rational(speed.above + error));
}

Span Robots::energy_to(sema::SiteId site) const {
  const auto from = place(self_);
  if (!from || !kind_.energy) return unknown(std::nullopt);
  for (const sema::Site::Place& to : spec_[site].places) {
    if (to.robot && *to.robot != self_) continue;
    const Rational straight = length(*from, {to.position.x, to.position.y}).below - place_error();
    const Rational least = straight * kind_.energy->drive.value;
    return between(std::max(Rational(0), least), Extended::infinity(1));
  }
  return unknown(std::nullopt);
}

}  // namespace rtac::interp
