#include "compiler/analysis/free_standing.h"

#include <algorithm>
#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/geometry/region.h"

namespace rtac::analysis {
namespace {

using geometry::Region;
using geometry::Slab;
using geometry::Solid;

// What the zone leaves out around a block of the fence, or where there is none.
struct Gap {
  Region base;       // convex: of the block, or else of what is left out
  Rational top;      // of the block, m
  Rational width;    // around it and over it; 0 where there is none
  bool in_fence;     // there is a block
  std::size_t over;  // the slab of the zone above it; as many as there are: it has none
};

// What the search asks for, and how far it looks for that.
struct Search {
  Rational radius, aim, cell;  // m
  // It looks at so many cells, which lie no farther beside the straight way.
  static constexpr int cells_beside = 8;
  // All heights are looked at in stacks of so many slabs, and so often piece by piece, each of them
  // as long at most (runtime/core/space.cpp). Some are left for places.
  static constexpr std::size_t slabs_max = 6;
  static constexpr std::int64_t looks_max = 7800, piece_mm = 4;

  // Beside the block no more is looked at.
  [[nodiscard]] Rational reach(const Rational& width) const {
    return width + 2 * aim + cells_beside * cell + radius;
  }
  // At a leg that is no longer, and cut in two again and again.
  static std::int64_t looks_at(const Rational& longest) {
    std::int64_t pieces = 1;
    while (longest * 1000 > pieces * piece_mm) pieces *= 2;
    return 2 * pieces;
  }
};

// Offsets reach farther by no more than that, and two of them and what is on the grid no more.
const Rational excess(1, 1000), excesses(2, 1000);

// From where in x and in y to where.
std::array<Rational, 4> extent(const Region& region) {
  std::vector<Rational> x{0}, y{0};
  const std::vector<geometry::Ring> rings = region.rings();
  if (!rings.empty()) x.front() = rings[0][0].x, y.front() = rings[0][0].y;
  for (const geometry::Ring& ring : rings) {
    for (const geometry::Point& p : ring) x.push_back(p.x), y.push_back(p.y);
  }
  const auto [left, right] = std::ranges::minmax_element(x);
  const auto [low, top] = std::ranges::minmax_element(y);
  return {*left, *right, *low, *top};
}

class FreeStanding {
 public:
  FreeStanding(const Solid& zone, const Solid& fence, const Search& search, const Rational& asked)
      : zone_(zone.slabs()), fence_(fence), search_(search), asked_(asked) {}

  // What of the starts is not near a block that stands free.
  [[nodiscard]] Solid starts_elsewhere(Solid starts) const {
    if (zone_.size() > Search::slabs_max || !widens_upwards()) return starts;
    for (const geometry::PolygonWithHoles& part : zone_.front().region.polygons()) {
      for (const geometry::Ring& hole : part.holes) {
        const auto outline = Region::polygon(hole, {});
        const Region* const left_out = std::get_if<Region>(&outline);
        const auto gap = left_out != nullptr ? gap_in(*left_out) : std::nullopt;
        if (!gap || !is_free(*gap)) continue;
        const Rational beside = gap->width + search_.radius + excesses;
        starts = starts.subtract(Solid::prism(gap->base.grow(beside), ground(), gap->top + beside));
      }
    }
    return starts;
  }

 private:
  [[nodiscard]] const Rational& ground() const { return zone_.front().floor; }
  // Nothing hangs over a place of the zone, but a ceiling over the last slab.
  [[nodiscard]] bool widens_upwards() const {
    for (std::size_t i = 1; i < zone_.size(); ++i) {
      const Slab &lower = zone_[i - 1], &upper = zone_[i];
      if (lower.ceiling != upper.floor || !upper.region.contains(lower.region)) return false;
    }
    return !zone_.empty();
  }
  // nullopt: what the fence leaves out there is no upright block with a convex base.
  [[nodiscard]] std::optional<Gap> gap_in(const Region& left_out) const {
    std::size_t over = 1;
    while (over < zone_.size() && !zone_[over].region.contains(left_out)) ++over;
    const bool has_roof = over < zone_.size();
    const Rational top = has_roof ? zone_[over].floor : zone_.back().ceiling;
    const Solid block =
        Solid::prism(left_out.grow(excesses), ground(), has_roof ? Rational(top + excesses) : top)
            .subtract(fence_);
    if (block.empty()) {
      return is_convex(left_out) ? std::optional(Gap{left_out, top, 0, false, over}) : std::nullopt;
    }
    const std::vector<Slab>& slabs = block.slabs();
    if (slabs.size() != 1 || slabs[0].floor != ground() || !is_convex(slabs[0].region)) {
      return std::nullopt;
    }
    const Region& base = slabs[0].region;
    if (has_roof) return Gap{base, slabs[0].ceiling, top - slabs[0].ceiling, true, over};
    if (slabs[0].ceiling != top) return std::nullopt;
    return Gap{base, top, extent(base)[0] - extent(left_out)[0], true, over};
  }

  // The zone goes as far around the block as ways do, and over it.
  [[nodiscard]] bool is_free(const Gap& gap) const {
    const Region wide = gap.base.grow(search_.reach(gap.width));
    const Region ring = wide.subtract(gap.base.grow(gap.width + excesses));
    const Region filled = gap.base.grow(gap.width - excess);
    const auto is_around = [&](const Slab& slab) {
      return slab.region.contains(ring) && slab.region.intersect(filled).empty();
    };
    return std::all_of(zone_.begin(), zone_.begin() + std::ptrdiff_t(gap.over), is_around) &&
           (gap.over == zone_.size() || leads_over(gap, wide)) && keeps_the_rest(gap, wide);
  }
  // From everywhere in the gap that is near the roof the search looks at the way straight up.
  [[nodiscard]] bool leads_over(const Gap& gap, const Region& wide) const {
    const Slab &above = zone_[gap.over], &beside = zone_[gap.over - 1];
    if (beside.floor > gap.top - search_.aim ||
        above.ceiling < above.floor + 2 * search_.aim + search_.radius ||
        looks_over(gap) > Search::looks_max || !above.region.contains(wide) || !keeps_edges(gap)) {
      return false;
    }
    // who goes down first finds no other cells there
    const Region alike = beside.region.intersect(wide);
    return std::all_of(
        zone_.begin(), zone_.begin() + std::ptrdiff_t(gap.over), [&](const Slab& slab) {
          return slab.region.contains(alike) && extent(slab.region) == extent(beside.region);
        });
  }
  // Along the level, and as far down as is shorter than that.
  [[nodiscard]] std::int64_t looks_over(const Gap& gap) const {
    const Rational level = gap.width + search_.aim + 3 * search_.cell;
    std::int64_t looks = Search::looks_at(level);
    for (std::size_t j = 0; j < gap.over; ++j) {
      const Rational to = zone_[j].ceiling - search_.aim;
      if (gap.top - to >= level) continue;
      const Rational down = zone_[gap.over].floor - to;
      looks += std::int64_t(j + 1) * Search::looks_at(std::min(level, down));
    }
    return looks;
  }
  // Of the fence, whatever way they take there; none leads down, or up through what has no end.
  [[nodiscard]] bool keeps_the_rest(const Gap& gap, const Region& wide) const {
    const Rational off = search_.radius + asked_;
    const Region around = wide.grow(2 * off);
    const bool has_roof = gap.over < zone_.size();
    const Rational top =
        has_roof ? Rational(zone_[gap.over].floor + search_.aim) : zone_.back().ceiling;
    Solid without = fence_.unite(Solid::prism(around, ground() - 2 * off, ground()));
    if (!has_roof) without = without.unite(Solid::prism(around, top, top + 2 * off));
    if (gap.in_fence) without = without.unite(Solid::prism(gap.base, ground(), gap.top));
    return Solid::prism(wide, ground(), top).subtract(without.shrink(off, off)).empty();
  }
  // Who is beside the edge of what is left out is as far from that of the block as is asked.
  [[nodiscard]] bool keeps_edges(const Gap& gap) const {
    if (!gap.in_fence) return true;
    const Rational has = gap.width - excesses, off = search_.radius + asked_;
    return has > 0 && 2 * has * has >= off * off;
  }

  const std::vector<Slab>& zone_;
  const Solid& fence_;
  Search search_;
  Rational asked_;
};

}  // namespace

bool leads_off_blocks(const TakeOver& at, const ir::Recovery& step, ir::ZoneIndex fence,
                      std::int64_t asked_mm, const Solid& starts) {
  const ir::ZoneTable& zone = at.module[step.zone];
  if (!ir::goes_back(step.kind) || !zone.has_height()) return false;
  std::int64_t cell_mm = 0;
  for (const ir::ZoneTable::Slab& slab : zone.slabs) {
    cell_mm = std::max<std::int64_t>(cell_mm, at.module[slab.base].cells.cell_mm);
  }
  const ir::Body& body = at.decision.body;
  const std::int64_t slack_mm = body.end_reach_mm + body.position_error_mm;
  const std::int64_t aim_mm =
      std::max(aims_at_mm(at.decision, step), step.return_clearance_mm + slack_mm);
  const Solid within = at.solid(step.zone), around = at.solid(fence);
  const FreeStanding blocks(within, around,
                            {metres_of(body.radius_mm), metres_of(aim_mm), metres_of(cell_mm)},
                            metres_of(asked_mm));
  return blocks.starts_elsewhere(starts).empty();
}

}  // namespace rtac::analysis
