// What inputs have to be for a property to hold, or to fail: searched in boxes of what each of them
// may be, and of how old it may be, by interval arithmetic. What robots sense is as it suits; what
// nobody knows is open.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/sema/spec.h"
#include "compiler/support/rational.h"

namespace rtac::analysis {

// Behind its last component: how old it is, in s.
inline std::uint32_t age_component(const sema::Input& input) {
  return static_cast<std::uint32_t>(input.components.size());
}
// Of a truth 0 or 1, of a choice its number; else SI.
struct ToldInput {
  sema::InputId input;
  std::uint32_t component = 0;
  Rational value;
};
enum class CanBeTold { yes, no, open };
struct Told {
  CanBeTold can = CanBeTold::yes;
  // Where it can: what is measured of all that it speaks of.
  std::vector<ToldInput> inputs;
};
// `seen`: whatever the errors of what is measured; else of what is so.
enum class ToldHow { exactly, seen };
// Of a robot that rests: how fast it may be seen to be, or reckoned to be soon, in m/s, and the
// charge that a full battery is sure to be seen with, of 1.
struct SeenAtRest {
  Rational speed, charge;
};
// Whether inputs within their ranges make `property` be `value`, whatever the parameters are. no:
// none does, with any parameters; open: nobody knows.
Told told_to_be(const sema::Spec& spec, const sema::Expr& property, bool value, ToldHow how,
                const std::optional<SeenAtRest>& at_rest = {});
// What has to be true of a robot, which rests or does as suits.
struct ToHold {
  const sema::Expr* property;
  std::optional<SeenAtRest> at_rest{};
};
// Whether inputs are seen to make all of these true at once, and some as long as they stay,
// whatever robots sense.
Told told_at_once(const sema::Spec& spec, const std::vector<ToHold>& all,
                  const std::vector<const sema::Expr*>& whatever_is_sensed = {});
// The inputs that an expression speaks of and no robot senses, their ages included.
std::set<sema::InputId> inputs_in(const sema::Spec& spec, const sema::Expr& e);
// Whether anything besides robots has a say in it: inputs, parameters, or how old is what a robot
// senses.
bool is_told(const sema::Spec& spec, const sema::Expr& e);
// The parts of what has to be true that these or what robots sense may make so, either of them:
// which side that is need not be the same whenever one asks. An `or` of which a side is `always` so
// is none.
std::vector<const sema::Expr*> torn_parts(const sema::Spec& spec, const sema::Expr& e,
                                          const std::function<bool(const sema::Expr&)>& always);
// Whether two of these speak of one input, or one of them of how old is what a robot senses, which
// whatever else is sensed has to be as well; or of one nobody knows whether inputs make it true.
bool share_inputs(const sema::Spec& spec, const std::vector<const sema::Expr*>& all);

// "load = 20, not door", of the specification.
std::string told_text(const sema::Spec& spec, const std::vector<ToldInput>& inputs);

}  // namespace rtac::analysis
