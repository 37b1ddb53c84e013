// What a comparison says about signals, however it is written: the one place that knows.
#pragma once

#include <compare>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "compiler/ir/module.h"
#include "compiler/support/rational.h"

namespace rtac::ir {

// A leaf of a linear form: which signal, of which table (zone, site, agent or zone that is
// received; of a count its value in the block; 0 for the others).
struct Leaf {
  enum class Kind {
    battery,
    clearance,
    distance,
    energy_to,
    count,
    speed,
    altitude,
    agent,
    received
  } kind;
  std::uint32_t table = 0;
  friend auto operator<=>(const Leaf&, const Leaf&) = default;
};

// A number of grid steps that parameters change: sum of coefficient * parameter + constant. Grid
// steps of lengths and charge, as robots use them.
struct Affine {
  Rational constant;
  std::map<std::uint32_t, Rational> params;  // by index in Decision::facts; no coefficient is 0
};
// sum of coefficient * leaf + rest, in grid steps; no coefficient is 0.
struct Linear {
  std::map<Leaf, Rational> terms;
  Affine rest;
};

// Whether a comparison is one of these: of signals of now, constants and parameters, and of no
// other arithmetic. Only then it has a form.
bool has_form(const Block& block, const AtLeast& compare);

// The comparison as `form >= 0` (`form > 0` when it is strict). 2 * gap >= 30 is 2 gap - 30.
Linear linear_form(const Block& block, const AtLeast& compare);

// What a comparison of one signal from below asks for, in whole grid steps: the least that
// satisfies it. With parameters it is fixed + sum of coefficient * parameter, each term rounded up.
struct Need {
  std::int64_t strictest = 0;  // whatever the parameters become; what is derived relies on it
  std::int64_t laxest = 0;     // and what holds at least wherever the comparison does
  std::int64_t fixed = 0;
  std::map<std::uint32_t, Rational> params;
};
// leaf >= need
struct LowerBound {
  Leaf leaf;
  Need need;
};
// `params`: those of the decision.
std::optional<LowerBound> lower_bound(const Block& block, const AtLeast& compare,
                                      const std::vector<Param>& params);

// most >= leaf, in whole grid steps: the most that satisfies it. None with parameters.
struct UpperBound {
  Leaf leaf;
  std::int64_t most = 0;
};
std::optional<UpperBound> upper_bound(const Block& block, const AtLeast& compare);

// battery >= energy_to(site) + reserve, in ppm.
struct ChargeForWay {
  SiteIndex site;
  Need reserve;
};
std::optional<ChargeForWay> charge_for_way(const Block& block, const AtLeast& compare,
                                           const std::vector<Param>& params);

// The largest gap to each agent that some monitor asks for: whoever moves keeps it.
std::map<AgentIndex, std::int64_t> agent_gaps(const Decision& decision);

// Whether some comparison is with the clearance of a zone that is received.
bool asks_for_received(const Block& block);

// Visits every comparison of a block, those about other robots included, with the block it is in.
void for_each_comparison(const Block& block,
                         const std::function<void(const Block&, const AtLeast&)>& visit);

}  // namespace rtac::ir
