#include "compiler/interp/trail.h"

#include <algorithm>

namespace rtac::interp {
namespace {

Rational square(const Place& a) {
  return dot(a, a);
}

// Square of the distance of a place from the way from a to b.
Rational square_between(const Place& p, const Place& a, const Place& b) {
  const Place way = minus(b, a), to = minus(p, a);
  const Rational along = dot(to, way), length = square(way);
  if (along <= 0 || length == 0) return square(to);
  if (along >= length) return square(minus(p, b));
  const Rational across = cross(way, to);
  return across * across / length;
}

int side(const Place& a, const Place& b, const Place& p) {
  return sgn(cross(minus(b, a), minus(p, a)));
}
// At a place that is an end of none; what only touches, ends find.
bool cross_each_other(const Place& a, const Place& b, const Place& c, const Place& d) {
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}
Rational square_between(const Place& a, const Place& b, const Place& c, const Place& d) {
  if (cross_each_other(a, b, c, d)) return 0;
  return std::min({square_between(a, c, d), square_between(b, c, d), square_between(c, a, b),
                   square_between(d, a, b)});
}

struct Gap {  // of a distance, signed
  Rational lo, hi;
};

// Negative outside; `turned`: inside.
Gap signed_gap(const Outline& outline, const Place& place, bool turned) {
  const Root gap = outline.distance(place);
  if (outline.contains(place) != turned) return {gap.below, gap.above};
  return {-gap.above, -gap.below};
}

bool is_on_right_side(const Outline& outline, const Place& a, const Place& b, const Root& gap,
                      bool turned) {
  return turned ? sgn(gap.below) > 0 && !outline.contains(a) : outline.contains(a, b);
}

// Of the way from one share of a leg to another one.
struct Stretch {
  Rational from, to;
  Rational lo_from, lo_to;  // of the ends
  Rational least;           // of all of it
};

// The least signed distance of the places of a leg: exact where all of it is on the right side.
// Else that of places along it, and less by what it may fall between two: a distance changes by no
// more than the way does. What may be least is divided, time and again.
Gap leg_gap(const Outline& outline, const Place& a, const Place& b, bool turned) {
  const Root gap = outline.distance(a, b);
  if (is_on_right_side(outline, a, b, gap, turned)) return {gap.below, gap.above};
  const Place way = minus(b, a);
  const Rational length = square_root(square(way)).above;
  const auto at = [&](const Rational& share) {
    return signed_gap(outline, {a.x + way.x * share, a.y + way.y * share}, turned);
  };
  const auto stretch = [&](const Rational& from, const Rational& lo_from, const Rational& to,
                           const Rational& lo_to) {
    return Stretch{from, to, lo_from, lo_to, (lo_from + lo_to - length * Rational(to - from)) / 2};
  };
  const Gap start = at(0), end = at(1);
  Rational hi = std::min({start.hi, end.hi, Rational(-gap.below)});
  std::vector<Stretch> all{stretch(0, start.lo, 1, end.lo)};
  const auto is_later = [](const Stretch& one, const Stretch& other) {
    return one.least > other.least;
  };
  constexpr int divisions = 100;
  const Rational near(1, 10000);  // m
  for (int k = 0; k < divisions && hi - all.front().least > near; ++k) {
    std::pop_heap(all.begin(), all.end(), is_later);
    const Stretch low = std::move(all.back());
    all.pop_back();
    const Rational middle = (low.from + low.to) / 2;
    const Gap there = at(middle);
    hi = std::min(hi, there.hi);
    for (Stretch half : {stretch(low.from, low.lo_from, middle, there.lo),
                         stretch(middle, there.lo, low.to, low.lo_to)}) {
      all.push_back(std::move(half));
      std::push_heap(all.begin(), all.end(), is_later);
    }
  }
  return {all.front().least, hi};
}

Gap least_gap(const Outline& outline, const Trail& trail, bool turned) {
  std::optional<Gap> least;
  trail.for_each_leg([&](const Place& a, const Place& b) {
    Gap leg = leg_gap(outline, a, b, turned);
    if (!least) {
      least = std::move(leg);
      return;
    }
    least->lo = std::min(least->lo, leg.lo);
    least->hi = std::min(least->hi, leg.hi);
  });
  return {least->lo - trail.room, least->hi + trail.room};
}

}  // namespace

void lead_on(Trail& trail, const Span& x, const Span& y) {
  for (const Span* each : {&x, &y}) {
    if (each->missing.missing && !trail.missing.missing) trail.missing = each->missing;
  }
  if (trail.missing.missing) return;
  if (!x.lo.is_finite() || !x.hi.is_finite() || !y.lo.is_finite() || !y.hi.is_finite()) {
    trail.missing.missing = true;
    return;
  }
  const Place middle{(x.lo.value() + x.hi.value()) / 2, (y.lo.value() + y.hi.value()) / 2};
  const Place half{x.hi.value() - middle.x, y.hi.value() - middle.y};
  trail.room = std::max(trail.room, square_root(square(half)).above);
  trail.places.push_back(middle);
}

void lead_on(Trail& trail, const Waypoint& place) {
  const auto metres = [](std::int64_t mm) {
    Rational m(static_cast<long>(mm), 1000);
    m.canonicalize();
    return m;
  };
  trail.places.push_back({metres(place.x_mm), metres(place.y_mm)});
}

Span distance_of(const Trail& a, const Trail& b) {
  if (a.is_unknown()) return unknown(a.missing.input);
  if (b.is_unknown()) return unknown(b.missing.input);
  std::optional<Rational> least;
  a.for_each_leg([&](const Place& from, const Place& to) {
    b.for_each_leg([&](const Place& start, const Place& end) {
      const Rational gap = square_between(from, to, start, end);
      if (!least || gap < *least) least = gap;
    });
  });
  const Root gap = square_root(*least);
  const Rational room = a.room + b.room;
  return between(std::max(Rational(0), Rational(gap.below - room)), Rational(gap.above + room));
}

Span clearance_of(const Outline& within, const Outline& around, const Trail& trail, bool greatest) {
  const Rational deepest = around.deepest();
  if (!greatest) {
    return between(least_gap(within, trail, false).lo,
                   std::min(deepest, least_gap(around, trail, false).hi));
  }
  return between(Rational(-least_gap(within, trail, true).hi),
                 std::min(deepest, Rational(-least_gap(around, trail, true).lo)));
}

bool surely_leaves(const Outline& within, const Outline& around, const Trail& trail, bool outside) {
  if (trail.is_unknown() || trail.room != 0) return false;
  bool leaves = false;
  trail.for_each_leg([&](const Place& a, const Place& b) {
    const Outline& outline = outside ? within : around;
    leaves = leaves || !is_on_right_side(outline, a, b, outline.distance(a, b), outside);
  });
  return leaves;
}

}  // namespace rtac::interp
