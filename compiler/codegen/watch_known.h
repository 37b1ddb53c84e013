// Monitors that know nothing as soon as a number of their inputs is missing: comparisons of
// quantities that are made of all of them. One question before the first of these answers for all.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "compiler/ir/module.h"

namespace rtac::codegen {

// Whether the property is such a comparison.
bool needs_all_inputs(const ir::Block& property);
// The components that a property asks for, by channel.
std::map<std::uint32_t, std::set<std::uint32_t>> components_of(const ir::Block& property);
// Whether it asks for all of a channel that has a few numbers, which usually are all there or all
// missing: a point, a pose.
bool asks_for_whole(const ir::Channel& channel, const std::set<std::uint32_t>& components);
// By channel: whether such a monitor asks for all of it.
std::vector<bool> needed_whole(const ir::Watch& watch);

}  // namespace rtac::codegen
