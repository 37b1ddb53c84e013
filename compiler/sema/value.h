// Values of expressions while they are checked. Points, vectors, arrays and values of enumerations
// exist here only: what leaves the checker is made of conditions and scalar quantities.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/sema/context.h"

namespace rtac::sema {

// A component that has an enumeration for its type.
struct EnumSignal {
  EnumId type;
  InputRef signal;
};
// Quantities of one dimension: two, or three. A literal may stand for a point and for a vector.
struct Pair {
  enum class Kind { point, vector, literal };
  Kind kind;
  ExprPtr x, y;
  ExprPtr z = nullptr;                       // null: of the plane
  std::optional<FrameId> frame = map_frame;  // none: that of what it meets, as for literals
};
// Where a frame lies in another one, which is that of the position.
struct Pose {
  Pair position;
  ExprPtr heading;  // from the x axis, counter-clockwise
  FrameId of;
};
struct Twist {
  ExprPtr linear, angular;
};
// Places one after the other, and the straight legs between them: those of its own, then those of
// a path. In the plane.
struct Way {
  std::vector<Pair> places;
  std::optional<InputId> path;  // behind places of its own what is left of it, else all of it
  bool next_only = false;       // the next way-point of it, none behind
  std::optional<FrameId> frame = map_frame;
  [[nodiscard]] bool is_leg() const { return next_only || (!path && places.size() == 2); }
};
struct Value;
struct Array {
  std::vector<Value> elements;
};
// One of two values of one enumeration.
struct EnumChoice {
  ExprPtr condition;
  std::vector<Value> options;  // then, else
};

// Nothing inside: a mistake, which was reported.
struct Value {
  Value() = default;
  Value(std::nullptr_t) {}  // NOLINT(google-explicit-constructor): reads like a null expression
  Value(ExprPtr expr) {     // NOLINT(google-explicit-constructor)
    if (expr) node = std::move(expr);
  }
  Value(EnumValue value) : node(value) {}                // NOLINT(google-explicit-constructor)
  Value(EnumSignal signal) : node(signal) {}             // NOLINT(google-explicit-constructor)
  Value(Pair pair) : node(std::move(pair)) {}            // NOLINT(google-explicit-constructor)
  Value(Array array) : node(std::move(array)) {}         // NOLINT(google-explicit-constructor)
  Value(Pose pose) : node(std::move(pose)) {}            // NOLINT(google-explicit-constructor)
  Value(Twist twist) : node(std::move(twist)) {}         // NOLINT(google-explicit-constructor)
  Value(EnumChoice choice) : node(std::move(choice)) {}  // NOLINT(google-explicit-constructor)
  Value(Way way) : node(std::move(way)) {}               // NOLINT(google-explicit-constructor)
  explicit operator bool() const { return !std::holds_alternative<std::monostate>(node); }

  std::variant<std::monostate, ExprPtr, EnumValue, EnumSignal, Pair, Array, Pose, Twist, EnumChoice,
               Way>
      node;
};

ExprPtr clone(const Expr& expr);
Value clone(const Value& value);

Pair clone(const Pair& pair);
Trail clone(const Trail& trail);

// The enumeration of which it is a value; none: of no one.
std::optional<EnumId> enumeration_of(const Value& value);

// Number of expressions inside, and how deeply they are nested.
std::size_t size_of(const Value& value);
std::size_t depth_of(const Value& value);

// Is it a whole number whatever the inputs are?
bool is_integer(const Spec& spec, const Expr& expr);

// "a condition", "a speed (m/s)", "a point", "a value of `Gear`", "an array of 4 elements".
std::string describe(const Spec& spec, const Value& value);
std::string describe(const Spec& spec, const ValueType& type);

// Can a value of this type stand where one of `type` is due?
bool fits(const Spec& spec, const Value& value, const ValueType& type);

}  // namespace rtac::sema
