// What a property says of many robots in the same words: a quantifier over a fleet has one
// condition a robot in the IR, where each has ranges of its own; in C they become one function and
// a loop.
//
//   forall p : Rover : forall q : Rover, q != p : distance(p, q) >= 50 cm
//
// is one `and` of a condition for each pair. All have one form; what differs are the values that it
// starts from, its arguments: the position of p, and that of q, negated, which is computed once a
// robot. Rows say, for each pair, which of these values are meant.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "compiler/ir/module.h"

namespace rtac::codegen {

// Below, nothing is gained: the text is as short written out, and faster.
inline constexpr std::size_t fewest_repeats = 5;

// A condition, or a quantity, that is repeated.
struct Repeated {
  ir::Block block;            // the first values stand for the arguments
  std::size_t arguments = 0;  // how many those are
  ir::ValueId join{};         // a value of the property that joins repetitions
  // Values of the property that arguments are taken from: a condition, or a quantity, each.
  std::vector<ir::ValueId> quantities, conditions;
  // By argument: it is found at row[column] + offset of these.
  struct Place {
    std::size_t column, offset;
  };
  std::vector<Place> places;
  std::vector<std::vector<std::size_t>> rows;  // by repetition
};

// A part of what one value joins: a value as it is, or rows of what is repeated.
struct Part {
  ir::ValueId value{};    // without rows
  std::size_t of = 0;     // index in Repeats::all
  std::size_t first = 0;  // row
  std::size_t rows = 0;   // 0: none
};

struct Repeats {
  std::vector<Repeated> all;
  std::map<ir::ValueId, std::vector<Part>>
      joins;  // by the `and`, `or`, `minimum`, ... of the parts
  // The values that are written one by one, operands first; of what is repeated, its arguments.
  std::vector<ir::ValueId> order;
  [[nodiscard]] const std::vector<Part>* parts_of(ir::ValueId id) const {
    const auto found = joins.find(id);
    return found == joins.end() ? nullptr : &found->second;
  }
};

// Of a property of a monitor without a robot. What remembers is never repeated: each has its own
// place in the state.
Repeats find_repeats(const ir::Module& module, const ir::Block& property);

}  // namespace rtac::codegen
