// What the verdict of a monitor without a robot is when that can be told at a glance: every number
// that it asks for is there, none of them is at the end of its range, and the condition holds, or
// does not, wherever between its step and the next each number lies. That is what nearly every tick
// finds; all others are looked at closely, and what is told at a glance is what they would find.
//
//   distance(first, second) >= 0.3 m         of numbers x, y in steps of 1 mm, each of which says
//   dx * dx + dy * dy >= 91204 (302^2): true     that something lies within [x, x + 1]: a
//   difference dx * dx + dy * dy <= 88209 (297^2): false    is off by 1, its length by 2 at most
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/codegen/code.h"
#include "compiler/codegen/watch.h"
#include "compiler/ir/module.h"

namespace rtac::codegen {

struct Glance {
  // The components that are asked for, by channel.
  std::map<std::uint32_t, std::set<std::uint32_t>> components;
  // What has a name, then conditions of `in`, what leads to the inputs; empty: it cannot be told.
  std::vector<std::string> names;
  std::string surely, never;
  // What surely holds asks each number alone, and of none that is out of its range or on the last
  // step of it: then that needs no question of its own.
  bool surely_inside = false;
  // Nothing is known without any of the inputs; or without all of them, when each comparison is of
  // one.
  bool needs_each = false, needs_some = false;
};
// Nothing: it takes a closer look, since the condition remembers, knows of time, or asks for more
// than sums and lengths.
std::optional<Glance> glance_at(const WatchKernel& kernel, const WatchNames& names,
                                const ir::Block& property);

}  // namespace rtac::codegen
