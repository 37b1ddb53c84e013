#include "compiler/interp/signals.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <limits>

#include "compiler/sema/limits.h"

namespace rtac::interp {
namespace {

constexpr long us_per_s = 1000000;

std::size_t index(sema::InputId id) {
  return static_cast<std::size_t>(id);
}

// Rule 13: a value outside the declared range is unknown, without one that beyond its reach.
bool in_range(const sema::Input& input, const sema::Measurement& declared, const Rational& value) {
  const Rational reach =
      Rational(static_cast<long>(sema::reach_steps(input))) * declared.resolution;
  const Rational least = declared.least ? declared.least->value : Rational(-reach);
  const Rational most = declared.most ? declared.most->value : reach;
  return least <= value && value <= most;
}

Rational error_of(const sema::Measurement& input) {
  return input.error ? input.error->value : Rational(0);
}

// Stamps may be anything; what lies further apart than the clock can say counts as that far.
std::int64_t elapsed_us(std::int64_t from_us, std::int64_t to_us) {
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  return from_us < 0 && to_us > most + from_us ? most : to_us - from_us;
}

Rational in_s(std::int64_t us) {
  Rational result(static_cast<long>(us), us_per_s);
  result.canonicalize();
  return result;
}

}  // namespace

Span declared_range(const sema::Spec& spec, sema::InputId id, std::uint32_t component) {
  const sema::Measurement& input = spec[id].measurement(component);
  if (!input.least || !input.most) return unknown(id);
  const Rational error = error_of(input);
  return between(Rational(input.least->value - error), Rational(input.most->value + error));
}

Signals::Signals(const std::vector<sema::Input>& declared)
    : declared_(declared), states_(declared.size()) {
  miss();
}

void Signals::miss() {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    states_[i].seen.assign(declared_[i].components.size(), std::nullopt);
    states_[i].age_us.reset();
  }
}

void Signals::arrive(std::int64_t now_us, std::int64_t since_us, const Inputs& inputs) {
  miss();
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const sema::Input& input = declared_[i];
    if (i < inputs.size() && inputs[i] && inputs[i]->values.size() == input.components.size()) {
      states_[i].arrived = inputs[i];
    }
    judge(states_[i], now_us);
    see(input, states_[i], now_us, since_us);
  }
}

// Rule 6: a stamp from the future is unknown until its time has come, and does not shut out later
// samples before that; one that goes backwards stays unknown.
void Signals::judge(State& state, std::int64_t now_us) {
  state.good = state.arrived && state.arrived->stamp_us <= now_us &&
               !(state.last_stamp_us && state.arrived->stamp_us < *state.last_stamp_us);
  if (state.good) state.last_stamp_us = state.arrived->stamp_us;
}

// Rule 6: the newest sample; without `max_age` it must have arrived since the last tick.
void Signals::see(const sema::Input& input, State& state, std::int64_t now_us,
                  std::int64_t since_us) {
  if (!state.good) return;
  const Sample& newest = *state.arrived;
  const std::int64_t age_us = elapsed_us(newest.stamp_us, now_us);
  const auto& values = newest.values;
  if (std::all_of(values.begin(), values.end(), [](const auto& v) { return v.has_value(); })) {
    state.age_us = age_us;
  }
  const bool fresh = newest.stamp_us > since_us;
  const bool usable =
      input.held || (input.max_age ? Rational(in_s(age_us)) <= input.max_age->value : fresh);
  if (!usable) return;
  for (std::size_t c = 0; c < state.seen.size(); ++c) {
    const auto& value = values[c];
    const sema::Measurement& declared = input.measurement(static_cast<std::uint32_t>(c));
    if (value && in_range(input, declared, *value)) state.seen[c] = value;
  }
}

const std::optional<Rational>& Signals::measured(sema::InputId input,
                                                 std::uint32_t component) const {
  return states_[index(input)].seen[component];
}

std::shared_ptr<const ReceivedZone> Signals::zone(sema::InputId input) const {
  const State& state = states_[index(input)];
  return state.seen[0] ? state.arrived->zone : nullptr;
}

// Rule 8.1: one way-point off the map, or an index that it does not have, and nothing is known.
std::optional<PathSeen> Signals::path(sema::InputId input) const {
  const State& state = states_[index(input)];
  if (!state.seen[0] || !state.seen[1] || state.arrived->path == nullptr) return std::nullopt;
  const std::vector<Waypoint>& points = *state.arrived->path;
  const Rational& next = *state.seen[1];
  const Rational count(static_cast<long>(points.size()));
  if (next < 0 || next > count || next.get_den() != 1) return std::nullopt;
  constexpr std::int64_t map_mm = std::int64_t{1} << 29;
  const bool on_map = std::all_of(points.begin(), points.end(), [](const Waypoint& p) {
    return std::abs(p.x_mm) <= map_mm && std::abs(p.y_mm) <= map_mm;
  });
  if (!on_map) return std::nullopt;
  return PathSeen{points, static_cast<std::size_t>(next.get_num().get_ui())};
}

Span Signals::quantity(sema::InputId input, std::uint32_t component) const {
  const auto& value = measured(input, component);
  if (!value) return unknown(input);
  const sema::Measurement& declared = declared_[index(input)].measurement(component);
  if (!declared.error) return exactly(*value);
  return between(Rational(*value - declared.error->value),
                 Rational(*value + declared.error->value));
}

Span Signals::age(sema::InputId input) const {
  const auto& age_us = states_[index(input)].age_us;
  return age_us ? exactly(in_s(*age_us)) : unknown(input);
}

}  // namespace rtac::interp
