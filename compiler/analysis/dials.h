// Numbers of the specification as they are written, each with the nearest one in its place with
// which all of it works (trials.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "compiler/analysis/trials.h"
#include "compiler/sema/spec.h"
#include "compiler/support/rational.h"
#include "compiler/support/source.h"

namespace rtac::analysis {

// All numbers in steps: `per_unit` of them are an SI unit.
struct Sought {
  Fault fault;
  int per_unit = 1000;
  std::int64_t written = 0, guess = 0, far = 0;  // as of a Dial; where to begin
  std::optional<SourceRange> all_of{};           // Trials::nearest
};

// Less than so small a share of what may work is not what the author asks for.
inline constexpr std::int64_t asked_share = 10;

// A quantity of a name that no other number has; `written` is its own.
std::optional<std::int64_t> quantity_that_works(Trials& trials, Sought sought,
                                                const std::string& name, sema::Quantity& number);
// What a comparison asks for of a signal, as it is written, or in its place a number alone. none:
// the comparison is of several numbers, or of a multiple of the signal. `written` counts where that
// is no constant.
std::optional<std::int64_t> asked_that_works(Trials& trials, const Sought& sought,
                                             const SourceRange& comparison);
// How fast a recovery moves, in each of its steps that is faster than that: "a recovery of at most
// 0.3 m/s works"; and where it lands.
std::optional<std::string> recovery_speed_that_works(Trials& trials, const Sought& sought,
                                                     const std::string& recovery);
std::optional<std::int64_t> landing_that_works(Trials& trials, const Sought& sought,
                                               const std::string& recovery);
// How far ahead a monitor looks, whether that is written or not.
std::optional<std::int64_t> lookahead_that_works(Trials& trials, const Sought& sought,
                                                 const std::string& monitor);
// Whether it works when a recovery moves in another zone than in `from`; `name`: of no other one.
bool works_in_zone(Trials& trials, const Fault& fault, const SourceRange& all_of,
                   const std::string& recovery, const std::string& name, sema::ZoneId from,
                   sema::Zone zone);
// Whether it works when that monitor alone has another recovery, of a name that no other one has.
bool works_recovered_by(Trials& trials, const Fault& fault, const std::string& monitor,
                        sema::Controller recovery);
// "`drive` of at most 2.5 %/m", or what it may take at rest ("`idle` of at most 0.01 %/s") where
// the time alone takes too much: for a way that takes `share` of the battery that there is. none:
// neither works.
std::optional<std::string> consumption_that_works(Trials& trials, const Fault& fault,
                                                  sema::KindId kind, const Rational& share);

}  // namespace rtac::analysis
