// What a tick sees of the plain inputs (rules 6 and 13).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "compiler/interp/received.h"
#include "compiler/interp/span.h"
#include "compiler/interp/trail.h"
#include "compiler/sema/spec.h"

namespace rtac::interp {

// One sample of an input: its components in the order of sema::Input, in SI; a condition is 0 or 1,
// a value of an enumeration its index. No value: not finite.
struct Sample {
  std::vector<std::optional<Rational>> values;
  std::int64_t stamp_us = 0;
  std::shared_ptr<const ReceivedZone> zone = nullptr;           // of a zone, beside a value of 1
  std::shared_ptr<const std::vector<Waypoint>> path = nullptr;  // of a path, beside 1 and its index
};
// The way-points of a path, and which of them is the next: their number where none is left.
struct PathSeen {
  const std::vector<Waypoint>& points;
  std::size_t next;
};
// By InputId: what has arrived since the last step.
using Inputs = std::vector<std::optional<Sample>>;

class Signals {
 public:
  // The declarations outlive the signals.
  explicit Signals(const std::vector<sema::Input>& declared);
  // `since_us`: the time of the tick before, whether or not it was missed.
  void arrive(std::int64_t now_us, std::int64_t since_us, const Inputs& inputs);
  // A tick that was missed sees nothing.
  void miss();

  // As measured; nullopt: unknown.
  [[nodiscard]] const std::optional<Rational>& measured(sema::InputId input,
                                                        std::uint32_t component) const;
  // With the declared error.
  [[nodiscard]] Span quantity(sema::InputId input, std::uint32_t component) const;
  // nullptr: unknown.
  [[nodiscard]] std::shared_ptr<const ReceivedZone> zone(sema::InputId input) const;
  // none: unknown.
  [[nodiscard]] std::optional<PathSeen> path(sema::InputId input) const;
  [[nodiscard]] Span age(sema::InputId input) const;  // s

 private:
  struct State {
    std::optional<Sample> arrived;  // the last one
    bool good = false;              // its stamp is to be believed
    std::optional<std::int64_t> last_stamp_us;
    std::vector<std::optional<Rational>> seen;  // at this tick
    std::optional<std::int64_t> age_us;
  };
  static void judge(State& state, std::int64_t now_us);
  static void see(const sema::Input& input, State& state, std::int64_t now_us,
                  std::int64_t since_us);
  const std::vector<sema::Input>& declared_;
  std::vector<State> states_;
};

// Every value that the input may have: the declared range, widened by the declared error; unknown
// without one.
Span declared_range(const sema::Spec& spec, sema::InputId input, std::uint32_t component);

}  // namespace rtac::interp
