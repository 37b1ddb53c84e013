#include "compiler/sema/templates.h"

#include "compiler/support/overloaded.h"

namespace rtac::sema {

std::vector<Template> templates_of(const Controller& controller) {
  return std::visit(Overloaded{
                        [](const ExternController&) { return std::vector<Template>{}; },
                        [](const Sequence& sequence) {
                          std::vector<Template> all;
                          for (const auto& step : sequence.steps) all.push_back(step.what);
                          return all;
                        },
                        [](const auto& one) { return std::vector<Template>{one}; },
                    },
                    controller.implementation);
}

std::optional<ExternController::Claim> claim_of(const Controller& controller) {
  const auto* external = std::get_if<ExternController>(&controller.implementation);
  return external ? external->claim : std::nullopt;
}

std::optional<Moves> moves_of(const Template& what) {
  return std::visit(Overloaded{
                        [](const BrakeAndHold&) { return std::optional<Moves>{}; },
                        [](const Land&) { return std::optional<Moves>{}; },
                        [](const auto& moving) {
                          return std::optional<Moves>{{moving.zone, moving.speed.value}};
                        },
                    },
                    what);
}

std::optional<Rational> speed_of(const Template& what) {
  if (const auto* land = std::get_if<Land>(&what)) return land->speed.value;
  const auto moves = moves_of(what);
  return moves ? std::optional(moves->speed) : std::nullopt;
}

std::optional<Route> route_of(const Controller& controller) {
  const std::vector<Template> all = templates_of(controller);
  const Route* route = all.empty() ? nullptr : std::get_if<Route>(&all.back());
  return route ? std::optional<Route>{*route} : std::nullopt;
}

}  // namespace rtac::sema
