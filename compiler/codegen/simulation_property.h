// A property of a robot as a tree of JSON, for whoever judges the true state.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>

#include "compiler/ir/table_map.h"
#include "compiler/sema/spec.h"

namespace rtac::codegen {

// `{"op": "and", "of": [...]}`; lengths in m, charge 1 = full, zones and sites by their number in
// the module, plain inputs by name, those of `inputs`. nullopt: it says something that the true
// state of robots does not tell; `why` says what.
std::optional<nlohmann::ordered_json> property_tree(const sema::Spec& spec, sema::KindId kind,
                                                    const ir::TableMap& tables,
                                                    const sema::Expr& property,
                                                    const std::set<std::string>& inputs,
                                                    std::string& why);

// The double nearest to the number.
double nearest_double(const Rational& value);

}  // namespace rtac::codegen
