#include "compiler/analysis/at_its_worst.h"

#include <algorithm>
#include <cmath>

#include "compiler/analysis/speed_limits.h"
#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

// Signed distance of a place to the boundary of a zone, rounded down; negative outside.
std::int64_t clearance_mm(const ir::ZoneTable& zone, std::int64_t x_mm, std::int64_t y_mm) {
  double least = 1e18;
  bool inside = false;
  for (const ir::Edge& e : zone.edges) {
    const double ax = double(e.ax) - double(x_mm), ay = double(e.ay) - double(y_mm);
    const double dx = double(e.bx) - e.ax, dy = double(e.by) - e.ay;
    const double t = std::clamp(-(ax * dx + ay * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    least = std::min(least, std::hypot(ax + t * dx, ay + t * dy));
    if ((e.ay > y_mm) == (e.by > y_mm)) continue;
    const double cross = dx * (double(y_mm) - e.ay) - dy * (double(x_mm) - e.ax);
    if ((cross > 0) == (dy > 0)) inside = !inside;
  }
  // 1 mm: what the doubles round
  const auto mm = static_cast<std::int64_t>(std::floor(least)) - 1;
  return inside ? mm : -mm - 2;
}

// A limit of speed that is none to who sets out from rest.
bool allows_rest(const ir::Block& block, const ir::AtLeast& compare, std::int64_t rest_mmps) {
  const auto most = ir::upper_bound(block, compare);
  return most && most->leaf.kind == ir::Leaf::Kind::speed && rest_mmps <= most->most;
}

class AtItsWorst {
 public:
  AtItsWorst(const ir::Module& module, const ir::Decision& decision, const ir::Monitor& monitor,
             std::int64_t clearance_mm)
      : module_(module),
        decision_(decision),
        property_(monitor.property),
        way_(monitor.recovery),
        clearance_mm_(clearance_mm),
        rest_mmps_(fastest_from_rest(decision, monitor.lookahead.duration_us)) {}

  [[nodiscard]] bool allows(std::int64_t x_mm, std::int64_t y_mm) const {
    return allows(property_.result, x_mm, y_mm, false);
  }

 private:
  // Beside a zone, in one side of an `or`, what is no zone need not be so then.
  [[nodiscard]] bool allows(ir::ValueId id, std::int64_t x_mm, std::int64_t y_mm,
                            bool of_choice) const {
    const ir::Op& op = property_[id].op;
    if (std::holds_alternative<ir::ZoneThere>(op)) return false;
    if (const auto* v = std::get_if<ir::Not>(&op)) {
      return !of_choice && !std::holds_alternative<ir::ZoneThere>(property_[v->a].op);
    }
    if (const auto* v = std::get_if<ir::And>(&op)) {
      return allows(v->a, x_mm, y_mm, of_choice) && allows(v->b, x_mm, y_mm, of_choice);
    }
    if (const auto* v = std::get_if<ir::Or>(&op)) {
      return allows(v->a, x_mm, y_mm, true) || allows(v->b, x_mm, y_mm, true);
    }
    if (const auto* v = std::get_if<ir::AtLeast>(&op)) {
      const auto bound = ir::lower_bound(property_, *v, decision_.facts.params);
      if (!bound || bound->leaf.kind != ir::Leaf::Kind::clearance) {
        return !of_choice || allows_rest(property_, *v, rest_mmps_);
      }
      const ir::ZoneIndex zone{bound->leaf.table};
      const std::int64_t own_mm = std::max<std::int64_t>(bound->need.strictest, 0);
      const std::int64_t beside_mm =
          ir::leave_beside_mm(way_, zone, decision_.body.radius_mm + own_mm);
      return clearance_mm(module_[zone], x_mm, y_mm) >= clearance_mm_ + own_mm + beside_mm;
    }
    return !of_choice;
  }

  const ir::Module& module_;
  const ir::Decision& decision_;
  const ir::Block& property_;
  const ir::Recovery& way_;
  std::int64_t clearance_mm_, rest_mmps_;
};

class AllowedAtWorst {
 public:
  AllowedAtWorst(const ir::Decision& decision, const ir::Block& property, const ExactZone& exact)
      : decision_(decision), property_(property), exact_(exact) {}

  [[nodiscard]] geometry::Region region() const { return region(property_.result, false); }

 private:
  [[nodiscard]] geometry::Region region(ir::ValueId id, bool of_choice) const {
    const auto otherwise = [&](bool holds) {
      return holds ? geometry::Region::everywhere() : geometry::Region();
    };
    const ir::Op& op = property_[id].op;
    if (std::holds_alternative<ir::ZoneThere>(op)) return {};
    if (const auto* v = std::get_if<ir::Not>(&op)) {
      const bool there = std::holds_alternative<ir::ZoneThere>(property_[v->a].op);
      return otherwise(!there && !of_choice);
    }
    if (const auto* v = std::get_if<ir::And>(&op)) {
      return region(v->a, of_choice).intersect(region(v->b, of_choice));
    }
    if (const auto* v = std::get_if<ir::Or>(&op)) {
      return region(v->a, true).unite(region(v->b, true));
    }
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    const auto bound =
        compare ? ir::lower_bound(property_, *compare, decision_.facts.params) : std::nullopt;
    if (!bound || bound->leaf.kind != ir::Leaf::Kind::clearance) {
      return otherwise(!of_choice);
    }
    return exact_(ir::ZoneIndex(bound->leaf.table));
  }

  const ir::Decision& decision_;
  const ir::Block& property_;
  const ExactZone& exact_;
};

bool is_on(const geometry::Ring& ring, const geometry::Point& a, const geometry::Point& b) {
  const auto off = [](const geometry::Point& from, const geometry::Point& to,
                      const geometry::Point& p) {
    return (to.x - from.x) * (p.y - from.y) != (to.y - from.y) * (p.x - from.x);
  };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const geometry::Point &from = ring[i], &to = ring[(i + 1) % ring.size()];
    if (!off(from, to, a) && !off(from, to, b)) return true;
  }
  return false;
}

}  // namespace

bool allowed_at_worst(const ir::Module& module, const ir::Decision& decision,
                      const ir::Monitor& monitor, std::int64_t clearance_mm, std::int64_t x_mm,
                      std::int64_t y_mm) {
  return AtItsWorst(module, decision, monitor, clearance_mm).allows(x_mm, y_mm);
}

geometry::Region region_at_worst(const ir::Decision& decision, const ir::Block& property,
                                 const ExactZone& exact) {
  return AllowedAtWorst(decision, property, exact).region();
}

bool is_rectangle(const geometry::Region& region) {
  const auto parts = region.polygons();
  if (parts.size() != 1 || !parts[0].holes.empty() || parts[0].outer.size() != 4) return false;
  const geometry::Ring& ring = parts[0].outer;
  for (std::size_t i = 0; i < 4; ++i) {
    const geometry::Point &a = ring[i], &b = ring[(i + 1) % 4];
    if (a.x != b.x && a.y != b.y) return false;
  }
  return true;
}

std::optional<geometry::Point> hidden_from(const geometry::Region& left,
                                           const geometry::Point& from, const geometry::Region& own,
                                           const Rational& room_m) {
  const geometry::Ring walls = own.polygons().front().outer;  // they hide nothing
  for (const geometry::Ring& ring : left.rings()) {           // the region on their left
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const geometry::Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if (is_on(walls, a, b)) continue;
      const Rational dx = b.x - a.x, dy = b.y - a.y;
      const Rational across = dx * (from.y - a.y) - dy * (from.x - a.x);  // distance by length
      if (across > 0 && across * across >= room_m * room_m * (dx * dx + dy * dy)) continue;
      return geometry::Point{(a.x + b.x) / 2, (a.y + b.y) / 2};
    }
  }
  return std::nullopt;
}

}  // namespace rtac::analysis
