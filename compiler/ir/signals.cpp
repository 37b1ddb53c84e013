#include "compiler/ir/signals.h"

#include <algorithm>

#include "compiler/ir/grid_help.h"
#include "compiler/ir/watch_blocks.h"
#include "compiler/sema/dimension.h"
#include "compiler/sema/limits.h"
#include "compiler/sema/received.h"
#include "compiler/sema/visit.h"

namespace rtac::ir {
namespace {

using diag::Code;

class SignalBuilder {
 public:
  SignalBuilder(const sema::Spec& spec, diag::Engine& diagnostics)
      : spec_(spec), diagnostics_(diagnostics) {}

  Signals run() {
    Signals all;
    for (const sema::Input& input : spec_.inputs) {
      all.inputs.push_back(channel(input));
      all.inputs.back().declared = static_cast<std::uint32_t>(all.inputs.size() - 1);
    }
    for (const sema::Param& param : spec_.params) {
      all.params.push_back(this->param(param));
      all.params.back().declared = static_cast<std::uint32_t>(all.params.size() - 1);
    }
    return all;
  }

 private:
  // Where this resolution is declared for all inputs of the dimension; nullptr: it is not.
  [[nodiscard]] const SourceRange* grid_of(const sema::Dimension& dimension,
                                           const Rational& resolution) const {
    for (const sema::GridStep& each : spec_.grids) {
      if (each.dimension == dimension && each.value.value == resolution) return &each.value.range;
    }
    return nullptr;
  }

  Unit grid(const sema::Dimension& dimension, const Rational& resolution,
            const SourceRange& source) {
    const Unit unit{dimension, resolution, scale_of(spec_, dimension)};
    if (unit.is_fine_enough()) return unit;
    const auto show = [&](const Rational& v) { return sema::show(v, dimension); };
    const SourceRange* grid = grid_of(dimension, resolution);
    const std::string word = grid != nullptr ? "grid" : "resolution";
    diagnostics_.report({Code::value_out_of_range,
                         grid != nullptr ? *grid : source,
                         "the " + word + " " + show(resolution) +
                             " is finer than a millionth of the scale " + show(unit.scale),
                         "margins count millionths of the scale",
                         {},
                         "`" + word + " " + show(unit.scale / 1'000'000) + "` works, or `scale " +
                             show(resolution * 1'000'000) + ";`",
                         {}});
    return {dimension, unit.scale / 1'000'000, unit.scale};
  }

  // `si` in steps, rounded in this direction; reported when no grid goes so far.
  std::int64_t steps(const Rational& si, const Unit& unit, bool up, const SourceRange& source) {
    const Rational count = si / unit.step;
    if (abs(count) <= Rational(static_cast<long>(sema::grid_steps_max))) {
      return up ? ceil_to_int(count) : floor_to_int(count);
    }
    const Rational most = unit.step * static_cast<long>(sema::grid_steps_max);
    const bool counts = unit.dimension == sema::dims::number && unit.step == 1;
    diagnostics_.report(
        {Code::value_out_of_range,
         source,
         "this is more than 10^15 steps of " + sema::show(unit.step, unit.dimension),
         "too far from 0",
         {},
         "at most `" + sema::show(most, unit.dimension) + "` works" +
             (counts ? "" : ", or a coarser `resolution`"),
         {}});
    return 0;
  }

  Channel channel(const sema::Input& from) {
    Channel to;
    to.name = from.name;
    to.components = from.components;
    to.held = from.held;
    if (from.max_age) to.max_age_us = floor_to_int(from.max_age->value * 1'000'000);
    switch (from.type) {
      case sema::InputType::boolean:
        to.kind = ChannelKind::truth;
        to.unit = {{}, 1, 1};
        to.range = {0, 1, true};
        break;
      case sema::InputType::enumeration:
        to.kind = ChannelKind::choice;
        to.unit = {{}, 1, 1};
        to.choice = spec_[*from.enumeration].name;
        to.values = spec_[*from.enumeration].values;
        to.range = {0, static_cast<std::int64_t>(to.values.size()) - 1, true};
        break;
      case sema::InputType::zone:
        to.kind = ChannelKind::zone;
        to.unit = {{}, 1, 1};
        to.range = {0, 0, true};
        to.edges_most = from.edges_most;
        break;
      case sema::InputType::path:
        to.kind = ChannelKind::path;
        to.unit = {{}, 1, 1};
        to.range = {0, 0, true};
        to.components = {""};
        to.places_most = from.places_most;
        break;
      case sema::InputType::integer:
      case sema::InputType::real:
        to.kind = ChannelKind::number;
        to.element_size = from.element_size;
        number(from, from, to);
        if (from.turning) number(from, *from.turning, to.turning.emplace());
        break;
    }
    return to;
  }
  // `of`: what is declared of some components of the input, or of all.
  void number(const sema::Input& from, const sema::Measurement& of, ChannelGrid& to) {
    to.unit = grid(of.dimension, of.resolution, from.name_range);
    const std::int64_t most = sema::reach_steps(from);
    to.range = {-most, most, of.least && of.most};
    if (of.least) to.range.lo = steps(of.least->value, to.unit, false, of.least->range);
    if (of.most) to.range.hi = steps(of.most->value, to.unit, true, of.most->range);
    if (of.error) to.error_steps = steps(of.error->value, to.unit, true, of.error->range);
    if (to.range.lo <= to.range.hi) return;
    diagnostics_.report({Code::value_out_of_range,
                         of.most ? of.most->range : from.name_range,
                         "no step of " + sema::show(to.unit.step, of.dimension) +
                             " lies in the range of `" + from.name + "`",
                         "",
                         {},
                         "a finer `resolution` or a wider range works",
                         {}});
    to.range = {0, 0, true};
  }

  Param param(const sema::Param& from) {
    Param to;
    to.name = from.name;
    to.unit = grid(from.dimension, from.resolution, from.name_range);
    to.tightens = from.tightens;
    to.range = {steps(from.least.value, to.unit, true, from.least.range),
                steps(from.most.value, to.unit, false, from.most.range), true};
    to.value = steps(from.value.value, to.unit, from.tightens > 0, from.value.range);
    if (Rational(static_cast<long>(to.value)) * to.unit.step != from.value.value) {
      off_grid(from.value, to.unit);
    }
    return to;
  }
  void off_grid(const sema::Quantity& value, const Unit& unit) {
    const auto finer = fitting_resolution(value.value, unit.step, unit);
    const auto beside = neighbours(value.value, unit);
    diagnostics_.report(
        {Code::constant_off_grid,
         value.range,
         "this value does not lie on the grid of " + sema::show(unit.step, unit.dimension),
         "",
         {},
         finer ? "`resolution " + *finer + "` works"
         : beside
             ? *beside + " do"
             : "a value with a few decimals in SI units works, with a `resolution` that it is a "
               "multiple of",
         {}});
  }

  const sema::Spec& spec_;
  diag::Engine& diagnostics_;
};

template <class Item>
std::uint32_t place_of(const std::vector<Item>& items, const std::string& name) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.name == name; });
  return static_cast<std::uint32_t>(found - items.begin());
}

}  // namespace

Signals build_signals(const sema::Spec& spec, diag::Engine& diagnostics) {
  return SignalBuilder(spec, diagnostics).run();
}

void UsedSignals::add(const sema::Spec& spec, const sema::Expr& expr) {
  const auto zone = [&](sema::ZoneId id) {
    if (const auto by = sema::received_by(spec, id)) inputs.insert(by->input);
  };
  const auto path = [&](const sema::Trail& trail) {
    if (trail.path) inputs.insert(*trail.path);
  };
  sema::for_each_expr(expr, [&](const sema::Expr& each) {
    if (const auto* v = std::get_if<sema::Clearance>(&each.node)) zone(v->zone);
    if (const auto* v = std::get_if<sema::InsideZone>(&each.node)) zone(v->zone);
    if (const auto* v = std::get_if<sema::PointInside>(&each.node)) zone(v->zone);
    if (const auto* v = std::get_if<sema::PointClearance>(&each.node)) zone(v->zone);
    if (const auto* v = std::get_if<sema::TrailInside>(&each.node)) zone(v->zone), path(v->trail);
    if (const auto* v = std::get_if<sema::TrailClearance>(&each.node)) {
      zone(v->zone), path(v->trail);
    }
    if (const auto* v = std::get_if<sema::TrailDistance>(&each.node)) {
      path(v->trail), path(v->other);
    }
    if (const auto* v = std::get_if<sema::PathGiven>(&each.node)) inputs.insert(v->input);
    if (const auto* v = std::get_if<sema::InputRef>(&each.node)) inputs.insert(v->input);
    if (const auto* v = std::get_if<sema::AgeOf>(&each.node)) inputs.insert(v->input);
    if (const auto* v = std::get_if<sema::IsValue>(&each.node)) inputs.insert(v->input);
    if (const auto* v = std::get_if<sema::SameValue>(&each.node)) {
      inputs.insert({v->left.input, v->right.input});
    }
    if (const auto* v = std::get_if<sema::AgentDistance>(&each.node)) {
      inputs.insert(v->seen);
      if (v->present) inputs.insert(*v->present);
    }
    if (const auto* v = std::get_if<sema::ParamRef>(&each.node)) params.insert(v->param);
  });
}

void UsedSignals::add(const sema::Spec& spec, const sema::Monitor& monitor) {
  if (monitor.always) add(spec, *monitor.always);
  if (monitor.return_when) add(spec, *monitor.return_when);
}

std::uint32_t channel_of(const Watch& watch, const std::string& name) {
  return place_of(watch.inputs, name);
}
std::uint32_t param_of(const Watch& watch, const std::string& name) {
  return place_of(watch.params, name);
}

}  // namespace rtac::ir
