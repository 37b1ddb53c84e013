// Points, vectors and poses: lengths, products, turns, and the frames that they are in.
#include "compiler/sema/frames.h"
#include "compiler/sema/property_checker.h"

namespace rtac::sema {

bool PropertyChecker::frames_agree(const SourceRange& range, const std::string& user,
                                   const std::optional<FrameId>& left,
                                   const std::optional<FrameId>& right) {
  if (!left || !right || *left == *right) return true;
  report_frames(context_, range,
                user + " mixes the frames `" + context_.spec[*left].name + "` and `" +
                    context_.spec[*right].name + "`",
                *right, *left);
  return false;
}

bool PropertyChecker::agree(const SourceRange& range, const std::string& user, const Pair& left,
                            const Pair& right) {
  if ((left.z != nullptr) == (right.z != nullptr)) {
    return frames_agree(range, user, left.frame, right.frame);
  }
  context_.report(Finding(Code::spaces_differ, range, user + " mixes the plane and space")
                      .label("two coordinates on one side, three on the other")
                      .help("`p.xy` is the part of `p` in the plane; `(p.x, p.y, 0 m)` puts `p` "
                            "into space"));
  return false;
}

bool PropertyChecker::in_plane(const syntax::Expr& expr, const std::string& user,
                               const Pair& pair) {
  if (!pair.z) return true;
  context_.report(Finding(Code::spaces_differ, expr.range, "`" + user + "` turns in the plane only")
                      .label("this has three coordinates")
                      .help("write `.xy` for its part in the plane, or compute the turn outside "
                            "and pass the result as `input ... error e`"));
  return false;
}

ExprPtr PropertyChecker::sum(const syntax::Expr& expr, ArithmeticOp op, ExprPtr left,
                             ExprPtr right) {
  const Dimension dimension = left->dimension;
  const auto one = constant_of(*left);
  const auto other = constant_of(*right);
  if (one && other) {
    const Rational value(*one + (op == ArithmeticOp::add ? *other : Rational(-*other)));
    return make_quantity(expr.range, dimension, Constant{value});
  }
  return make_quantity(expr.range, dimension,
                       Arithmetic{op, operands_of(std::move(left), std::move(right))});
}

ExprPtr PropertyChecker::product(const syntax::Expr& expr, ExprPtr left, ExprPtr right) {
  const auto one = constant_of(*left);
  const auto other = constant_of(*right);
  const auto dimension =
      combine(context_, syntax::BinaryOp::multiply, {&expr, left->dimension, one},
              {&expr, right->dimension, other}, expr.range);
  if (!dimension) return nullptr;
  if (one && other) return make_quantity(expr.range, *dimension, Constant{Rational(*one * *other)});
  return make_quantity(
      expr.range, *dimension,
      Arithmetic{ArithmeticOp::multiply, operands_of(std::move(left), std::move(right))});
}

Value PropertyChecker::norm(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 1, "norm(v)")) return nullptr;
  auto pair = pair_of(*call.arguments.front(), Pair::Kind::vector, "norm");
  if (!pair) return nullptr;
  const Dimension dimension = pair->x->dimension;
  auto parts = operands_of(std::move(pair->x), std::move(pair->y));
  if (pair->z) parts.push_back(std::move(pair->z));
  return math(expr, MathOp::norm, dimension, std::move(parts));
}

Value PropertyChecker::distance_of_points(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 2, "distance(p, q)")) return nullptr;
  auto one = pair_of(*call.arguments[0], Pair::Kind::point, "distance");
  if (!one) return nullptr;
  auto other = pair_of(*call.arguments[1], Pair::Kind::point, "distance");
  if (!other) return nullptr;
  if (!agree(expr.range, "`distance`", *one, *other) ||
      !one_dimension("`distance`", {call.arguments[0].get(), call.arguments[1].get()},
                     {one->x.get(), other->x.get()})) {
    return nullptr;
  }
  const Dimension dimension = one->x->dimension;
  const auto difference = [&](ExprPtr& a, ExprPtr& b) {
    return sum(expr, ArithmeticOp::subtract, std::move(a), std::move(b));
  };
  ExprPtr x = difference(one->x, other->x);
  auto parts = operands_of(std::move(x), difference(one->y, other->y));
  if (one->z) parts.push_back(difference(one->z, other->z));
  return math(expr, MathOp::norm, dimension, std::move(parts));
}

std::optional<std::pair<Pair, Pair>> PropertyChecker::vectors(const syntax::Call& call) {
  const std::string& name = call.callee.text;
  auto one = pair_of(*call.arguments[0], Pair::Kind::vector, name);
  auto other = one ? pair_of(*call.arguments[1], Pair::Kind::vector, name) : std::nullopt;
  if (!other || !agree(call.arguments[1]->range, "`" + name + "`", *one, *other)) {
    return std::nullopt;
  }
  return std::pair(std::move(*one), std::move(*other));
}

Value PropertyChecker::dot(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 2, "dot(v, w)")) return nullptr;
  auto pairs = vectors(call);
  if (!pairs) return nullptr;
  auto& [v, w] = *pairs;
  ExprPtr all;
  for (ExprPtr Pair::*part : {&Pair::x, &Pair::y, &Pair::z}) {
    if (!(v.*part)) continue;
    ExprPtr each = product(expr, std::move(v.*part), std::move(w.*part));
    if (!each) return nullptr;
    all = all ? sum(expr, ArithmeticOp::add, std::move(all), std::move(each)) : std::move(each);
  }
  return all;
}

// a b - c d
ExprPtr PropertyChecker::cross_term(const syntax::Expr& expr, const ExprPtr& a, const ExprPtr& b,
                                    const ExprPtr& c, const ExprPtr& d) {
  ExprPtr one = product(expr, clone(*a), clone(*b));
  ExprPtr other = one ? product(expr, clone(*c), clone(*d)) : nullptr;
  if (!other) return nullptr;
  return sum(expr, ArithmeticOp::subtract, std::move(one), std::move(other));
}

// In space a vector; in the plane its component out of the plane.
Value PropertyChecker::cross(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 2, "cross(v, w)")) return nullptr;
  auto pairs = vectors(call);
  if (!pairs) return nullptr;
  const auto& [v, w] = *pairs;
  if (!affordable(expr, size_of(Value(clone(v))) + size_of(Value(clone(w))))) return nullptr;
  ExprPtr z = cross_term(expr, v.x, w.y, v.y, w.x);
  if (!z || !v.z) return z;
  ExprPtr x = cross_term(expr, v.y, w.z, v.z, w.y);
  ExprPtr y = cross_term(expr, v.z, w.x, v.x, w.z);
  return Pair{Pair::Kind::vector, std::move(x), std::move(y), std::move(z),
              v.frame ? v.frame : w.frame};
}

// Counter-clockwise: (c x - s y, s x + c y).
Value PropertyChecker::rotated(const syntax::Expr& expr, const Pair& pair, const Expr& angle) {
  const std::size_t copies = 4 * size_of(Value(clone(angle))) + 2 * size_of(Value(clone(pair)));
  if (!affordable(expr, copies)) return nullptr;
  const auto turn = [&](MathOp op, const ExprPtr& part) -> ExprPtr {
    Value value = math(expr, op, dims::number, operands_of(clone(angle)));
    auto* share = std::get_if<ExprPtr>(&value.node);
    return share != nullptr ? product(expr, std::move(*share), clone(*part)) : nullptr;
  };
  ExprPtr ahead = turn(MathOp::cosine, pair.x);
  if (!ahead) return nullptr;  // reported
  ExprPtr x = sum(expr, ArithmeticOp::subtract, std::move(ahead), turn(MathOp::sine, pair.y));
  ExprPtr aside = turn(MathOp::sine, pair.x);
  ExprPtr y = sum(expr, ArithmeticOp::add, std::move(aside), turn(MathOp::cosine, pair.y));
  return Pair{pair.kind, std::move(x), std::move(y), nullptr, pair.frame};
}

// Reports the angle before the vector.
bool PropertyChecker::rotate_swapped(const syntax::Expr& expr, const Value& first,
                                     const Value& second) {
  const auto* angle = std::get_if<ExprPtr>(&first.node);
  const bool swapped =
      angle != nullptr && !(*angle)->boolean && std::holds_alternative<Pair>(second.node);
  if (!swapped) return false;
  context_.report(Finding(Code::wrong_argument, expr.range, "`rotate` takes the vector first")
                      .label("the angle stands first")
                      .help("swap them: `rotate(v, angle)`"));
  return true;
}

Value PropertyChecker::rotate(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 2, "rotate(v, angle)")) return nullptr;
  Value first = infer(*call.arguments[0]);
  Value second = infer(*call.arguments[1], dims::angle);
  if (!first || !second || rotate_swapped(expr, first, second)) return nullptr;
  auto vector = as_pair(*call.arguments[0], std::move(first), Pair::Kind::vector, "rotate");
  ExprPtr angle = as_quantity(*call.arguments[1], std::move(second));
  if (!vector || !angle || !in_plane(*call.arguments[0], "rotate", *vector)) return nullptr;
  if (angle->dimension != dims::angle) {
    const syntax::Expr* bare = bare_number(*call.arguments[1]);
    if (bare != nullptr) {
      report_unit_missing(context_, *bare, dims::angle, "`rotate` takes an angle");
    } else {
      context_.report(Finding(Code::wrong_dimension, call.arguments[1]->range,
                              "`rotate` takes an angle, this is " + describe(angle->dimension))
                          .label("not an angle")
                          .help("write an angle, such as `at.heading` or `90 deg`"));
    }
    return nullptr;
  }
  vector->kind = Pair::Kind::vector;
  return rotated(expr, *vector, *angle);
}

// A point or a vector of the frame that the pose places, in the frame of the pose.
Value PropertyChecker::transform(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 2, "transform(at, p)")) return nullptr;
  Value placed = infer(*call.arguments[0]);
  Value moved = infer(*call.arguments[1]);
  if (!placed || !moved) return nullptr;
  auto* pose = std::get_if<Pose>(&placed.node);
  auto* pair = std::get_if<Pair>(&moved.node);
  if (pose == nullptr || pair == nullptr) {
    const bool first = pose == nullptr;
    context_.report(Finding(Code::wrong_argument, call.arguments[first ? 0 : 1]->range,
                            std::string("`transform` takes ") +
                                (first ? "a pose" : "a point or a vector") + ", this is " +
                                describe(context_.spec, first ? placed : moved))
                        .label(first ? "not a pose" : "not a point")
                        .help(first ? "write an input of type `pose of base`"
                                    : "write an input of type `point @ base` or `vector @ base`"));
    return nullptr;
  }
  if (!in_plane(*call.arguments[1], "transform", *pair)) return nullptr;
  if (pair->frame && *pair->frame != pose->of) {
    report_frames(context_, call.arguments[1]->range,
                  "this pose places `" + context_.spec[pose->of].name + "`, and this is in `" +
                      context_.spec[*pair->frame].name + "`",
                  *pair->frame, pose->of);
    return nullptr;
  }
  Value turned = rotated(expr, *pair, *pose->heading);
  auto* result = std::get_if<Pair>(&turned.node);
  if (result == nullptr) return nullptr;
  result->frame = pose->position.frame;
  if (pair->kind == Pair::Kind::vector) return turned;
  if (!one_dimension("`transform`", {call.arguments[0].get(), call.arguments[1].get()},
                     {pose->position.x.get(), result->x.get()})) {
    return nullptr;
  }
  result->kind = Pair::Kind::point;
  result->x = sum(expr, ArithmeticOp::add, std::move(pose->position.x), std::move(result->x));
  result->y = sum(expr, ArithmeticOp::add, std::move(pose->position.y), std::move(result->y));
  return turned;
}

}  // namespace rtac::sema
