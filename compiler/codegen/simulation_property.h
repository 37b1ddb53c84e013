// A property of a robot as a tree of JSON, for whoever judges the true state.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/ir/table_map.h"
#include "compiler/sema/spec.h"

namespace rtac::codegen {

// What the properties of a decision speak of, besides robots.
struct Facts {
  std::set<std::string> inputs;     // those that are told of
  std::vector<sema::ZoneId> timed;  // zones that are there at certain times
};

// `{"op": "and", "of": [...]}`; lengths in m, charge 1 = full, zones and sites by their number in
// the module, plain inputs by name, zones with times by their number in `facts`, which are added
// to. The past is what it is of inputs that have always been as they are. nullopt: it says
// something that the true state of robots does not tell; `why` says what.
std::optional<nlohmann::ordered_json> property_tree(const sema::Spec& spec, sema::KindId kind,
                                                    const ir::TableMap& tables,
                                                    const sema::Expr& property, Facts& facts,
                                                    std::string& why);

// From when on what an expression says of the past of inputs is as it is for ever, if they stay as
// they are. Of the past of robots it says nothing.
std::int64_t memory_us(const sema::Expr& e, std::int64_t period_us);

// The double nearest to the number.
double nearest_double(const Rational& value);

}  // namespace rtac::codegen
