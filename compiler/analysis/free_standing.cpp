#include "compiler/analysis/free_standing.h"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/sides.h"
#include "compiler/geometry/region.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

using geometry::Region;
using geometry::Slab;
using geometry::Solid;

// What the zone leaves out around a block of the fence, or where there is none.
struct Gap {
  Region base;             // convex: of the block, or else of what is left out
  Rational top;            // of the block, m
  Rational width;          // around it and over it; 0 where there is none
  bool has_block = false;  // of the fence
  std::size_t over = 1;    // the slab of the zone above it; as many as there are: it has none
};

// What the search asks for, and how far it looks for that.
struct Search {
  Rational radius, aim, cell;  // m
  // It looks at so many cells, which lie no farther beside the straight way.
  static constexpr int cells_beside = 8;
  // All heights are looked at in stacks of so many slabs, and so often piece by piece, each of them
  // as long at most (runtime/core/space.cpp). Some are left for places, and for ways up.
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

// Offsets reach farther by no more than the one, and two of them and what is on the grid than both.
const Rational one_excess(1, 1000), both_excesses(2, 1000);

// The box around a region that is not empty.
struct Box {
  Rational left, right, low, top;
  bool operator==(const Box&) const = default;
};
Box box_of(const Region& region) {
  const std::vector<geometry::Ring> rings = region.rings();
  const geometry::Point& first = rings.front().front();
  Box box{first.x, first.x, first.y, first.y};
  for (const geometry::Ring& ring : rings) {
    for (const geometry::Point& p : ring) {
      box = {std::min(box.left, p.x), std::max(box.right, p.x), std::min(box.low, p.y),
             std::max(box.top, p.y)};
    }
  }
  return box;
}
std::string middle_of(const Region& region) {
  const Box box = box_of(region);
  return "(" + metres(Rational((box.left + box.right) / 2)) + ", " +
         metres(Rational((box.low + box.top) / 2)) + ")";
}
bool is_on_grid(const Rational& height) {
  return Rational(height * 1000).get_den() == 1;
}

class FreeStanding {
 public:
  FreeStanding(const Solid& zone, const Solid& fence, const Search& search, const Rational& asked)
      : zone_(zone.slabs()), fence_(fence), search_(search), asked_(asked) {}

  // What the zone lacks for all of the starts to be near blocks that stand free. "": they are.
  [[nodiscard]] std::string why_not(Solid starts) const {
    if (zone_.size() > Search::slabs_max) {
      return "has " + std::to_string(zone_.size()) + " levels, and of " +
             std::to_string(Search::slabs_max) + " all are looked at";
    }
    if (!widens_upwards()) {
      return "has places that something hangs over, or levels that end on no whole millimetre";
    }
    std::string why;
    for (const geometry::PolygonWithHoles& part : zone_.front().region.polygons()) {
      for (const geometry::Ring& hole : part.holes) {
        const auto outline = Region::polygon(hole, {});
        const Region* const left_out = std::get_if<Region>(&outline);
        if (left_out == nullptr) continue;
        const auto gap = gap_in(*left_out);
        const std::string missing =
            gap ? missing_around(*gap)
                : "leaves out what is no upright block with a convex base, from its floor on";
        if (missing.empty()) {
          starts = starts.subtract(around(*gap));
        } else if (why.empty()) {
          why = missing + ", near " + middle_of(*left_out);
        }
      }
    }
    if (starts.empty()) return "";
    return !why.empty() ? why : "may have robots outside of it elsewhere than around a block";
  }

 private:
  [[nodiscard]] const Rational& ground() const { return zone_.front().floor; }
  [[nodiscard]] bool has_roof(const Gap& gap) const { return gap.over < zone_.size(); }
  // Nothing hangs over a place of the zone, but a ceiling over the last slab. Where slabs end on
  // the grid, a robot has as many.
  [[nodiscard]] bool widens_upwards() const {
    for (std::size_t i = 1; i < zone_.size(); ++i) {
      const Slab &lower = zone_[i - 1], &upper = zone_[i];
      if (lower.ceiling != upper.floor || !upper.region.contains(lower.region)) return false;
    }
    return std::ranges::all_of(
        zone_, [](const Slab& slab) { return is_on_grid(slab.floor) && is_on_grid(slab.ceiling); });
  }
  // Where bodies are beside a block, or over it, that do not fit in the zone for what that leaves
  // out there, and neither for its floor nor for its ceiling.
  [[nodiscard]] Solid around(const Gap& gap) const {
    const Rational& radius = search_.radius;
    const Rational beside = gap.width + radius + both_excesses;
    return Solid::prism(gap.base.grow(beside), ground() + radius,
                        has_roof(gap) ? Rational(gap.top + beside) : Rational(gap.top - radius));
  }
  // nullopt: what the fence leaves out there is no upright block with a convex base.
  [[nodiscard]] std::optional<Gap> gap_in(const Region& left_out) const {
    Gap gap{left_out, zone_.back().ceiling, 0};
    while (has_roof(gap) && !zone_[gap.over].region.contains(left_out)) ++gap.over;
    if (has_roof(gap)) gap.top = zone_[gap.over].floor;
    const Rational up_to = has_roof(gap) ? Rational(gap.top + both_excesses) : gap.top;
    const Solid block =
        Solid::prism(left_out.grow(both_excesses), ground(), up_to).subtract(fence_);
    if (!block.empty()) {
      const Slab& only = block.slabs().front();
      if (block.slabs().size() != 1 || only.floor != ground()) return std::nullopt;
      if (!has_roof(gap) && only.ceiling != gap.top) return std::nullopt;
      gap.base = only.region;
      gap.width = has_roof(gap) ? Rational(gap.top - only.ceiling)
                                : Rational(box_of(only.region).left - box_of(left_out).left);
      gap.top = only.ceiling;
      gap.has_block = true;
    }
    return is_convex(gap.base) ? std::optional(gap) : std::nullopt;
  }

  // What it takes for the block to stand free. "": it does.
  [[nodiscard]] std::string missing_around(const Gap& gap) const {
    // the zone goes as far around the block as ways do
    const Rational reach = search_.reach(gap.width);
    const Region wide = gap.base.grow(reach);
    const Region ring = wide.subtract(gap.base.grow(gap.width + both_excesses));
    const Region filled = gap.base.grow(gap.width - one_excess);
    const auto is_around = [&](const Slab& slab) {
      return slab.region.contains(ring) && slab.region.intersect(filled).empty();
    };
    if (!std::all_of(zone_.begin(), zone_.begin() + std::ptrdiff_t(gap.over), is_around)) {
      return "has to go on for " + metres(reach) + " around the block";
    }
    if (has_roof(gap)) {
      const std::string missing = missing_over(gap, wide);
      if (!missing.empty()) return missing;
    }
    return keeps_the_rest(gap, wide)
               ? ""
               : "has ways nearer than " + metres(Rational(search_.radius + asked_)) +
                     " to what else is to be kept off";
  }
  // From everywhere in the gap that is near the roof the search looks at the way straight up, or at
  // a leg to a cell that is nearer.
  [[nodiscard]] std::string missing_over(const Gap& gap, const Region& wide) const {
    const Slab &above = zone_[gap.over], &beside = zone_[gap.over - 1];
    const Rational over = 2 * search_.aim + search_.radius;
    if (!above.region.contains(wide) || zone_.back().ceiling < above.floor + over) {
      return "has to go on for " + metres(over) + " over what it leaves out, and for " +
             metres(search_.reach(gap.width)) + " around it there";
    }
    if (!keeps_edges(gap)) {
      return "leaves out less than is asked by the edge of a roof, where " + metres(least_gap()) +
             " around the block are enough";
    }
    // who goes down first finds no other cells there
    const Region alike = beside.region.intersect(wide);
    const auto is_alike = [&](const Slab& slab) {
      return slab.region.contains(alike) && box_of(slab.region) == box_of(beside.region);
    };
    if (!std::all_of(zone_.begin(), zone_.begin() + std::ptrdiff_t(gap.over), is_alike)) {
      return "has levels with other outlines beside the block";
    }
    if (looks_over(gap) > Search::looks_max) {
      return "leaves out so much that it is more than is looked along, with the clearance of " +
             metres(search_.aim) + " that is looked for";
    }
    return "";
  }
  // Until a way is found that is no longer than straight up: as far down as the nearest cell of its
  // own level is away, and if that is nearer, along the level. From farther over the roof than
  // beside it none is nearer, and what leads down is not clear at its middle; so the block is as
  // far below as it is beside.
  [[nodiscard]] std::int64_t looks_over(const Gap& gap) const {
    const Rational off = gap.has_block ? least_of_both() : Rational(0);
    const Rational up = gap.width + search_.aim + 2 * both_excesses - off;
    const Rational level = up + search_.cell * Rational(3, 2);  // more than a cell is across
    std::int64_t looks = Search::looks_at(up);
    for (std::size_t j = 0; j < gap.over; ++j) {
      const Rational to = zone_[j].ceiling - search_.aim;
      if (gap.top + off - to >= level) continue;
      const Rational down = zone_[gap.over].floor + both_excesses - to;
      looks += Search::looks_at(std::min(level, down));
    }
    return looks;
  }
  // Of the fence, whatever way they take there; none leads down, or up through what has no end.
  [[nodiscard]] bool keeps_the_rest(const Gap& gap, const Region& wide) const {
    const Rational off = search_.radius + asked_;
    const Region wider = wide.grow(2 * off);
    const Rational top =
        has_roof(gap) ? Rational(zone_[gap.over].floor + search_.aim) : zone_.back().ceiling;
    Solid without = fence_.unite(Solid::prism(wider, ground() - 2 * off, ground()));
    if (!has_roof(gap)) without = without.unite(Solid::prism(wider, top, top + 2 * off));
    if (gap.has_block) without = without.unite(Solid::prism(gap.base, ground(), gap.top));
    return Solid::prism(wide, ground(), top).subtract(without.shrink(off, off)).empty();
  }
  // Who is beside the edge of what is left out is as far from that of the block as is asked.
  [[nodiscard]] bool keeps_edges(const Gap& gap) const {
    if (!gap.has_block) return true;
    const Rational has = gap.width - both_excesses, off = search_.radius + asked_;
    return has > 0 && 2 * has * has >= off * off;
  }
  [[nodiscard]] Rational least_gap() const {
    const Rational off = search_.radius + asked_;
    return off * Rational(7072, 10'000) + both_excesses;
  }

  // Who has what is asked, but for what a hold strays, and is as far beside a block as over it.
  [[nodiscard]] Rational least_of_both() const {
    const Rational strays(2, 100);
    return std::max(Rational((search_.radius + asked_) * Rational(7071, 10'000) - strays),
                    Rational(0));
  }

  const std::vector<Slab>& zone_;
  const Solid& fence_;
  Search search_;
  Rational asked_;
};

// How clear a place is, in mm, that recoveries look for first in a zone, with what lengths are
// rounded by here and where certificates are checked. nullopt: it is not known, as something asks
// for more before it gives back, or moves there in another way.
std::optional<std::int64_t> looked_for_mm(const ir::Decision& decision, ir::ZoneIndex zone) {
  constexpr std::int64_t rounding_mm = 20;
  const ir::Body& body = decision.body;
  std::int64_t most_mm = 0;
  for (const ir::Monitor& m : decision.monitors) {
    if (m.return_when) return std::nullopt;
    for (const ir::Recovery* step : ir::steps_of(m.recovery)) {
      if (!(ir::moves(step->kind) || step->claims) || step->zone != zone) continue;
      if (step->claims || !ir::goes_back(step->kind)) return std::nullopt;
      most_mm = std::max(most_mm, step->return_clearance_mm);
    }
  }
  return most_mm + body.end_reach_mm + body.position_error_mm + rounding_mm;
}

}  // namespace

std::string missing_off_blocks(const TakeOver& at, ir::ZoneIndex within, ir::ZoneIndex fence,
                               std::int64_t asked_mm, const Solid& starts) {
  const ir::ZoneTable& zone = at.module[within];
  const auto aim_mm = looked_for_mm(at.decision, within);
  const std::string name = quoted(zone.name) + " ";
  if (!zone.has_height()) return name + "has no height";
  if (!aim_mm)
    return name + "is where a `return when`, or a way to a site, has something else looked for";
  std::int64_t cell_mm = 0;
  for (const ir::ZoneTable::Slab& slab : zone.slabs) {
    cell_mm = std::max<std::int64_t>(cell_mm, at.module[slab.base].cells.cell_mm);
  }
  const std::int64_t radius_mm = at.decision.body.radius_mm;
  const Solid inner = at.solid(within), outer = at.solid(fence);
  const FreeStanding blocks(inner, outer,
                            {metres_of(radius_mm), metres_of(*aim_mm), metres_of(cell_mm)},
                            metres_of(asked_mm));
  const std::string why = blocks.why_not(starts);
  return why.empty() ? "" : name + why;
}

}  // namespace rtac::analysis
