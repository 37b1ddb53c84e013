// Whether inputs make a property what it is said to be, from what is written.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/sema/spec.h"
#include "compiler/support/rational.h"

namespace rtac::recheck {

// And its component; behind the last one how old it is, in s.
using ToldInput = std::pair<sema::InputId, std::uint32_t>;
// Of a truth 0 or 1, of a choice its number; else SI.
using ToldInputs = std::map<ToldInput, Rational>;

// Of "load.0=41/2;door.0=1"; none: it cannot be read, or an input cannot be that.
std::optional<ToldInputs> told_inputs(const sema::Spec& spec, const std::string& text);
// Those that a property speaks of, and that no robot senses.
std::set<ToldInput> told_in(const sema::Spec& spec, const sema::Expr& e);
// The same inputs, and those whose age it speaks of.
std::set<sema::InputId> spoken_of(const sema::Spec& spec, const sema::Expr& e);
// Whether two of these speak of one input, so that they may exclude each other, or a `return when`
// of any, which may never be so; or one of how old is what its robot senses.
bool asks_at_once(const sema::Spec& spec, const sema::Decision& d, const std::string& only);
// Of a robot that rests: how fast it may be seen to be, or reckoned to be soon, in m/s, and the
// charge that a full battery is sure to be seen with, of 1.
struct SeenAtRest {
  Rational speed, charge;
};
// As its samples show it, of whichever robot of a decision; none: it has none.
std::optional<SeenAtRest> shown_at_rest(const sema::Spec& spec, const sema::Decision& d);
// Of inputs, parameters, or how old is what a robot senses.
bool is_told(const sema::Spec& spec, const sema::Expr& e);
// Whether the property is `value` while these are measured, which are all of its inputs, for as
// long as it takes, and what robots sense is as it suits, one age of it included. It is then true
// whatever the errors, and false where there are none. What nobody knows makes nothing so.
bool told_makes(const sema::Spec& spec, const sema::Expr& property, const ToldInputs& inputs,
                bool value, const std::optional<SeenAtRest>& at_rest = {});
// Whether it is true while these are measured, and what robots sense suits, but what is said that
// it may be otherwise, and how old it is.
using MayBe = std::function<bool(const sema::Expr&, bool value)>;
bool told_makes_true_but(const sema::Spec& spec, const sema::Expr& property,
                         const ToldInputs& inputs, const MayBe& may_be);
// The parts of what has to be true that inputs or what robots sense may make so, either of them:
// which side is so need not be the same whenever one asks. An `or` of which a side is `always` so
// tears nothing.
std::vector<const sema::Expr*> torn_parts(const sema::Spec& spec, const sema::Expr& wanted,
                                          const std::function<bool(const sema::Expr&)>& always);
// Whether it is true then whatever else is sensed, as long as they stay so.
bool told_alone_makes(const sema::Spec& spec, const sema::Expr& property, const ToldInputs& inputs);

}  // namespace rtac::recheck
