#include "compiler/recheck/receding.h"

#include <algorithm>
#include <optional>

namespace rtac::recheck {
namespace {

constexpr double slack_square = 1e-6;  // m^2, of the doubles of the runtime

}  // namespace

double farthest(const Box& a, const Box& b) {
  return length(std::max(a.right - b.x, b.right - a.x), std::max(a.top - b.y, b.top - a.y));
}
double nearest(const Box& a, const Box& b) {
  return length(std::max({a.x - b.right, b.x - a.right, 0.0}),
                std::max({a.y - b.top, b.y - a.top, 0.0}));
}
// (c - p) (p - q) is concave in p and linear in q, so that corners are the worst. Signs are exact
// in doubles, and so is what is negative on neither axis.
bool recedes(Place c, const Box& from, const Box& other) {
  const auto least = [](double to, double low, double high, double other_low, double other_high) {
    return std::min({(to - low) * (low - other_low), (to - low) * (low - other_high),
                     (to - high) * (high - other_low), (to - high) * (high - other_high)});
  };
  const double on_x = least(c.x, from.x, from.right, other.x, other.right);
  const double on_y = least(c.y, from.y, from.top, other.y, other.top);
  return on_x + on_y >= slack_square || (on_x >= 0 && on_y >= 0);
}

namespace {

struct Off {
  double least, most;  // of the difference of two coordinates
};
std::optional<Off> off_on(int sign, double low, double high, double other_low, double other_high) {
  Off off{low - other_high, high - other_low};
  if (sign > 0) off.least = std::max(off.least, 0.0);
  if (sign < 0) off.most = std::min(off.most, 0.0);
  return off.least <= off.most ? std::optional(off) : std::nullopt;
}

}  // namespace

bool recedes(Place c, const Box& from, const Box& other, Side side) {
  const auto off_x = off_on(side.x, from.x, from.right, other.x, other.right);
  const auto off_y = off_on(side.y, from.y, from.top, other.y, other.top);
  if (!off_x || !off_y) return true;
  const auto least = [](double to, double low, double high, const Off& off) {
    return std::min({(to - low) * off.least, (to - low) * off.most, (to - high) * off.least,
                     (to - high) * off.most});
  };
  const double on_x = least(c.x, from.x, from.right, *off_x);
  const double on_y = least(c.y, from.y, from.top, *off_y);
  return on_x + on_y >= slack_square || (on_x >= 0 && on_y >= 0);
}
// What recedes in both directions does in all between.
bool recedes(Place c, const Box& from, Side side, Axis axis) {
  constexpr double slack = 1e-6;  // m, of the doubles of the runtime
  const double on_x = std::min(side.x * (c.x - from.x), side.x * (c.x - from.right));
  const double on_y = std::min(side.y * (c.y - from.y), side.y * (c.y - from.top));
  if (on_x >= 0 && on_y >= 0) return true;
  return (axis == Axis::x ? on_x : on_y) >= slack && on_x + on_y >= slack;
}
// Of one axis the product is the largest halfway between c and q.
bool comes_nearer(Place c, const Box& from, const Box& other) {
  const auto most = [](double to, double low, double high, double q) {
    const double p = std::clamp((to + q) / 2, low, high);
    return (to - p) * (p - q);
  };
  const double on_x =
      std::max(most(c.x, from.x, from.right, other.x), most(c.x, from.x, from.right, other.right));
  const double on_y =
      std::max(most(c.y, from.y, from.top, other.y), most(c.y, from.y, from.top, other.top));
  return on_x + on_y < -slack_square;
}

}  // namespace rtac::recheck
