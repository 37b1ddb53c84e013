#include "field.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "rtac/sim/math.h"

namespace rtac::simulate {
namespace {

using sim::Property;
using sim::PropertyOp;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double m_per_mm = 1e-3, s_per_us = 1e-6;
// A complement ends 536 km away, where the numbers of a kernel end; a site never comes near that.
constexpr std::int32_t sky_mm = 400'000'000;
constexpr double open_field_m = 4;  // half of its width, without any zone
// From this width on, in rooms to get fast and stop, half of the places are near a boundary.
constexpr double rooms_wide = 25;
constexpr double room_m_min = 0.5;

bool in_the_sky(const std::int32_t* point_mm) {
  return std::max(std::abs(point_mm[0]), std::abs(point_mm[1])) >= sky_mm;
}

bool in_the_sky(double height_m) {
  return std::abs(height_m) >= m_per_mm * sky_mm;
}

// Everything, when the zone is a complement. Zones of the plane have any height.
Box box_of(const ZoneView& zone) {
  Box box;
  box.hold_height(-infinite);
  box.hold_height(infinite);
  for (std::size_t e = 0; e < 4 * zone.edge_count; e += 2) {
    if (in_the_sky(zone.edges_mm + e)) return Box::everything();
    box.hold({m_per_mm * zone.edges_mm[e], m_per_mm * zone.edges_mm[e + 1]});
  }
  return box;
}

Box box_of(const SolidView& solid) {
  Box box;
  for (std::size_t k = 0; k < solid.slab_count; ++k) {
    const SlabView& slab = solid.slabs[k];
    Box part = box_of(*slab.base);
    part.bottom = in_the_sky(slab.floor_m) ? -infinite : slab.floor_m;
    part.top = in_the_sky(slab.ceiling_m) ? infinite : slab.ceiling_m;
    box.join(part);
  }
  return box;
}

Box box_of(const sim::Surroundings& all, int zone) {
  const auto index = static_cast<std::size_t>(zone);
  const bool solid = index < all.solids.size() && all.solids[index].slab_count > 0;
  return solid ? box_of(all.solids[index]) : box_of(all.zones[index]);
}

bool is_height(const Property& p, const Property& limit) {
  return p.op == PropertyOp::altitude && limit.op == PropertyOp::constant;
}

Box where(const Property& p, const DecisionCase& d);

Box where_at_least(const Property& most, const Property& least, const DecisionCase& d) {
  Box box = where(most, d);
  if (is_height(most, least)) box.bottom = least.value;
  if (is_height(least, most)) box.top = most.value;
  const bool may_leave = least.op == PropertyOp::constant && least.value < 0;
  return may_leave && most.op == PropertyOp::clearance ? box.grown(-least.value) : box;
}

// Of a condition: where it may hold. Of a quantity: where it may be positive.
Box where(const Property& p, const DecisionCase& d) {
  switch (p.op) {
    case PropertyOp::inside:
    case PropertyOp::clearance:
      return box_of(d.surroundings, p.index);
    case PropertyOp::at_least:
      return where_at_least(p.of[0], p.of[1], d);
    case PropertyOp::logical_and: {
      Box box = Box::everything();
      for (const Property& each : p.of) box.cut(where(each, d));
      return box;
    }
    case PropertyOp::logical_or: {
      Box box;
      for (const Property& each : p.of) box.join(where(each, d));
      return box;
    }
    case PropertyOp::forall:
    case PropertyOp::exists:
      return where(p.of[0], d);
    default:
      return Box::everything();
  }
}

// The greatest distance that is asked for.
double distance_asked_m(const Property& p) {
  double most = 0;
  if (p.op == PropertyOp::at_least && p.of[1].op == PropertyOp::constant &&
      (p.of[0].op == PropertyOp::clearance || p.of[0].op == PropertyOp::distance)) {
    most = p.of[1].value;
  }
  for (const Property& each : p.of) most = std::max(most, distance_asked_m(each));
  return most;
}

// From rest to full speed and to rest again, late by everything that is declared; then as far away
// as robots have to be.
double room_m(const DecisionCase& d) {
  const RobotLimits& l = d.limits;
  const TimeUs late_us =
      d.period_us + l.latency_us + std::max(l.position_age_us, l.velocity_age_us);
  double m = l.speed_mps * s_per_us * static_cast<double>(late_us);
  for (const double rate_mps2 : {l.accel_mps2, l.brake_mps2}) {
    if (rate_mps2 > 0) m += l.speed_mps * l.speed_mps / (2 * rate_mps2);
  }
  double apart_m = 2 * l.radius_m;
  for (const Property& p : d.properties) apart_m = std::max(apart_m, distance_asked_m(p));
  return std::max(m, room_m_min) + apart_m * std::sqrt(static_cast<double>(d.robots.size()));
}

}  // namespace

Box Box::everything() {
  Box box;
  std::swap(box.lo, box.hi);
  std::swap(box.bottom, box.top);
  return box;
}

void Box::hold(Vec2 p) {
  lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
  hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
}

void Box::hold_height(double z) {
  bottom = std::min(bottom, z);
  top = std::max(top, z);
}

void Box::join(const Box& other) {
  if (other.empty()) return;
  hold(other.lo);
  hold(other.hi);
  hold_height(other.bottom);
  hold_height(other.top);
}

void Box::cut(const Box& other) {
  lo = {std::max(lo.x, other.lo.x), std::max(lo.y, other.lo.y)};
  hi = {std::min(hi.x, other.hi.x), std::min(hi.y, other.hi.y)};
  bottom = std::max(bottom, other.bottom);
  top = std::min(top, other.top);
}

Box Box::grown(double by_m) const {
  Box box = *this;
  box.lo = lo - Vec2{by_m, by_m};
  box.hi = hi + Vec2{by_m, by_m};
  box.bottom = bottom - by_m;
  box.top = top + by_m;
  return box;
}

void Field::hold_zone(const ZoneView& zone, Box& holes) {
  for (std::size_t e = 0; e < zone.edge_count; ++e) {
    const std::int32_t* const mm = zone.edges_mm + 4 * e;
    if (in_the_sky(mm) || in_the_sky(mm + 2)) continue;
    Edge edge{m_per_mm * Vec2{static_cast<double>(mm[0]), static_cast<double>(mm[1])},
              m_per_mm * Vec2{static_cast<double>(mm[2]), static_cast<double>(mm[3])}};
    edge.until_m = (edges_.empty() ? 0 : edges_.back().until_m) + norm(edge.to - edge.from);
    edges_.push_back(edge);
    holes.hold(edge.from);
    holes.hold(edge.to);
  }
}

void Field::hold_all(const Property& p, const DecisionCase& d, Box& holes) {
  if (p.op == PropertyOp::inside || p.op == PropertyOp::clearance) {
    const auto index = static_cast<std::size_t>(p.index);
    hold_zone(d.surroundings.zones[index], holes);
    if (index < d.surroundings.solids.size()) {
      const SolidView& solid = d.surroundings.solids[index];
      for (std::size_t k = 0; k < solid.slab_count; ++k) {
        hold_zone(*solid.slabs[k].base, holes);
        for (const double z : {solid.slabs[k].floor_m, solid.slabs[k].ceiling_m}) {
          if (!in_the_sky(z)) holes.hold_height(z);
        }
      }
    }
  }
  if (p.op == PropertyOp::at_least) {
    if (is_height(p.of[0], p.of[1])) holes.hold_height(p.of[1].value);
    if (is_height(p.of[1], p.of[0])) holes.hold_height(p.of[0].value);
  }
  for (const Property& each : p.of) hold_all(each, d, holes);
}

Field::Field(const DecisionCase& d) : box_(Box::everything()), room_m_(room_m(d)) {
  Box holes;
  for (const Property& p : d.properties) {
    box_.cut(where(p, d));
    hold_all(p, d, holes);
  }
  Box around = holes.grown(room_m_);
  if (edges_.empty()) {
    const double half_m = open_field_m * std::sqrt(static_cast<double>(d.robots.size()));
    around.hold({-half_m, -half_m});
    around.hold({half_m, half_m});
  }
  if (holes.bottom > holes.top) {
    around.hold_height(-open_field_m);
    around.hold_height(open_field_m);
  }
  const bool flat = sim::is_finite(box_.lo) && sim::is_finite(box_.hi);
  const bool high = std::isfinite(box_.bottom) && std::isfinite(box_.top);
  open_ = !flat || (d.limits.in_space && !high);
  box_.cut(around);
  if (box_.empty()) box_ = around;  // nothing can hold; whoever looks for a place will find none
  near_ = !edges_.empty() &&
          std::max(box_.hi.x - box_.lo.x, box_.hi.y - box_.lo.y) > rooms_wide * room_m_;
}

bool Field::widen() {
  if (!open_) return false;
  box_ = box_.grown(room_m_);
  room_m_ *= 2;
  return true;
}

Vec2 Field::near_an_edge(sim::Random& random) const {
  const double along_m = random.uniform(0, edges_.back().until_m);
  auto edge = std::lower_bound(edges_.begin(), edges_.end(), along_m,
                               [](const Edge& e, double m) { return e.until_m < m; });
  if (edge == edges_.end()) --edge;
  const Vec2 at = edge->from + random.uniform(0, 1) * (edge->to - edge->from);
  return at + random.in_disc(room_m_);
}

Vec2 Field::draw(sim::Random& random) const {
  if (near_ && random.uniform() < 0.5) return near_an_edge(random);
  const double x = random.uniform(box_.lo.x, box_.hi.x);
  return {x, random.uniform(box_.lo.y, box_.hi.y)};
}

double Field::draw_height(sim::Random& random) const {
  return random.uniform(box_.bottom, box_.top);
}

}  // namespace rtac::simulate
