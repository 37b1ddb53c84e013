// The operators of the language that stand in formulas of inputs, with the types of what they take
// and give: which may stand in which is a matter of this table alone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rtac::differential {

enum class Type {
  condition,
  gear,
  whole,
  number,
  length,
  area,
  angle,
  time,
  speed,
  share,
  heat,
  vector,
  point,
  turned,  // a point that was turned
  near,    // a point that was not: together with those of robots its squares fit the kernel
  spot,    // a point in another frame
  vector3,
  point3,
  pose,
  twist
};

// In the text stands $1 for the first operand, and so on, and $v for a name of its own.
struct Operator {
  std::string name;
  std::string text;
  Type result;
  std::vector<Type> operands;
};
// An operator of several types is several entries of one name.
const std::vector<Operator>& operators();

// Whether what an operator gives may stand where another type is due: a whole number is a number.
bool fits(Type given, Type due);
// The k-th of some simple formulas of a type.
const std::string& leaf(Type type, std::size_t k);
// The operator on formulas of its operands; `depth` tells apart the names of nested ones.
std::string applied(const Operator& op, const std::vector<std::string>& operands, int depth);

// Of quantities that can be compared with a constant.
struct Scale {
  std::string unit;
  std::size_t steps;  // in one unit: limits are multiples of these
};
const Scale* scale_of(Type type);

}  // namespace rtac::differential
