// What the built-in safe controllers have in common.
#pragma once

#include <variant>

#include "compiler/sema/spec.h"

namespace rtac::sema {

// The manoeuvres of a controller, in order; none: it is external.
std::vector<Template> templates_of(const Controller& controller);

// What an external controller claims; none: nothing, or it is built in.
std::optional<ExternController::Claim> claim_of(const Controller& controller);

// How fast a manoeuvre is; none: it stands.
std::optional<Rational> speed_of(const Template& what);

// The zone that a manoeuvre moves in, and how fast; none: it stands, or goes straight down.
struct Moves {
  ZoneId zone;
  Rational speed;
};
std::optional<Moves> moves_of(const Template& what);

// The way that a controller ends with; only the last step of a sequence leads to a site.
std::optional<Route> route_of(const Controller& controller);

// Calls `change` for what a recovery does: for each of its steps, or for what is claimed of it.
template <class Change>
void change_each(Controller& recovery, const Change& change) {
  if (auto* sequence = std::get_if<Sequence>(&recovery.implementation)) {
    for (auto& step : sequence->steps) std::visit(change, step.what);
  } else if (auto* external = std::get_if<ExternController>(&recovery.implementation)) {
    if (external->claim) change(*external->claim);
  } else {
    std::visit(change, recovery.implementation);
  }
}

// The landing that a recovery ends with, if it does, ends at that height, in metres.
inline void land_at(Controller& recovery, const Rational& height) {
  const auto land_there = [&](auto& what) {
    if (auto* const land = std::get_if<Land>(&what)) land->height.value = height;
  };
  if (auto* const sequence = std::get_if<Sequence>(&recovery.implementation)) {
    land_there(sequence->steps.back().what);
  } else {
    land_there(recovery.implementation);
  }
}

}  // namespace rtac::sema
