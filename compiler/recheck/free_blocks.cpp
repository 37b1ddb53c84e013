#include "compiler/recheck/free_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/recheck/claims.h"
#include "compiler/recheck/on_grid.h"

namespace rtac::recheck {
namespace {

using geometry::Region;
using geometry::Ring;
using geometry::Slab;
using geometry::Solid;

const Rational millimetre(1, 1000);
// Bounds of the search: slabs of which it looks at all heights, and looks that it takes, but for a
// few at places; and cells that it tries lie no farther aside than so many are wide.
constexpr std::size_t slabs_most = 6;
constexpr int looks_most = 7800, cells_aside = 8;
// Piece by piece, down to 4 mm.
std::int64_t looks_at(const Rational& way) {
  std::int64_t pieces = 1;
  while (way > milli(4 * pieces)) pieces *= 2;
  return 2 * pieces;
}

// The lowest and the highest coordinates; the same where there are none.
std::pair<geometry::Point, geometry::Point> corners_of(const Region& region) {
  const auto rings = region.rings();
  if (rings.empty()) return {};
  geometry::Point low = rings.front().front(), high = low;
  for (const Ring& ring : rings) {
    for (const geometry::Point& p : ring) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  return {low, high};
}
// 10 cm, or as many centimetres more as there would be more than 40,000 in the box around it.
Rational cell_of(const Region& region) {
  const auto [low, high] = corners_of(region);
  Rational cell(1, 10);
  const double wide = Rational(high.x - low.x).get_d(), deep = Rational(high.y - low.y).get_d();
  const auto count = [&](double length) { return std::ceil(length / cell.get_d() + 0.01); };
  while (count(wide) * count(deep) > 40'000) cell += Rational(1, 100);
  // beyond whole cells there may be a part of one on both sides
  return cell + Rational(1, 100);
}

// A block, upright from the ground on: its base, how high it reaches, and by how much more the zone
// leaves out around it and above.
struct Block {
  Region base;
  Rational top, around;
  bool real = true;      // false: the fence has none there
  std::size_t over = 0;  // the slab above it, if there is one
};

class Blocks {
 public:
  Blocks(const std::vector<Slab>& slabs, const Solid& fence, const FreeRoom& room)
      : slabs_(slabs), fence_(fence), room_(room) {
    for (const Slab& slab : slabs) cell_ = std::max(cell_, cell_of(slab.region));
  }
  // Of these starts, all from where somebody may be led nearer to the fence than is asked, but for
  // those near the block in that hole of the zone, if it stands free.
  [[nodiscard]] Solid elsewhere(const Solid& starts, const Ring& ring) const {
    const auto found = Region::polygon(ring, {});
    const Region* const hole = std::get_if<Region>(&found);
    const auto block = hole != nullptr ? block_in(*hole) : std::nullopt;
    if (!block) return starts;
    const Rational reach = block->around + room_.radius + 2 * millimetre;
    // a body at the floor or the ceiling of the zone has less room than beside the block
    const Rational high =
        ends(*block) ? Rational(block->top + reach) : Rational(block->top - room_.radius);
    const Solid beside =
        Solid::prism(block->base.grow(reach), slabs_.front().floor + room_.radius, high);
    return stands_free(*block) ? starts.subtract(beside) : starts;
  }

 private:
  [[nodiscard]] bool ends(const Block& block) const { return block.over < slabs_.size(); }

  [[nodiscard]] std::optional<Block> block_in(const Region& hole) const {
    const Rational hair = 2 * millimetre, ground = slabs_.front().floor;
    Block block{hole, slabs_.back().ceiling, 0, false, 1};
    while (ends(block) && !slabs_[block.over].region.contains(hole)) ++block.over;
    if (ends(block)) block.top = slabs_[block.over].floor;
    const Rational roof = block.top;
    const Solid what =
        Solid::prism(hole.grow(hair), ground, ends(block) ? Rational(roof + hair) : roof)
            .subtract(fence_);
    if (!what.empty()) {
      const Slab& only = what.slabs().front();
      const bool through = !ends(block) && only.ceiling < roof;
      if (what.slabs().size() > 1 || only.floor > ground || through) return std::nullopt;
      const Rational aside = corners_of(only.region).first.x - corners_of(hole).first.x;
      block = {only.region, only.ceiling, ends(block) ? Rational(roof - only.ceiling) : aside, true,
               block.over};
    }
    if (!is_convex(block.base.rings())) return std::nullopt;
    return block;
  }

  // Whether all that the search looks at from around the block is free, and wide enough.
  [[nodiscard]] bool stands_free(const Block& block) const {
    const Region near =
        block.base.grow(block.around + 2 * room_.clearance + cells_aside * cell_ + room_.radius);
    const Region beside = near.subtract(block.base.grow(block.around + 2 * millimetre));
    const Region core = block.base.grow(block.around - millimetre);
    for (std::size_t i = 0; i < block.over; ++i) {
      if (!slabs_[i].region.contains(beside)) return false;
      if (!core.intersect(slabs_[i].region).empty()) return false;
    }
    if (ends(block) && !goes_over(block, near)) return false;
    return keeps_others(block, near);
  }
  // Whether straight up is looked at from near the roof, and what is over that is free.
  [[nodiscard]] bool goes_over(const Block& block, const Region& near) const {
    const Slab &over = slabs_[block.over], &under = slabs_[block.over - 1];
    // the edge of what is left out is as far from that of the block as from a corner of a square
    const Rational least = block.around - 2 * millimetre, asked = room_.radius + room_.asked;
    if (block.real && (least <= 0 || least * least * 2 < asked * asked)) return false;
    if (slabs_.back().ceiling - over.floor < 2 * room_.clearance + room_.radius) return false;
    if (!over.region.contains(near)) return false;  // those above it contain it
    // of level legs the one to a cell that is nearer than straight up, from as far beside the block
    // as over it, by what is asked, but for 2 cm
    const Rational each = block.real ? Rational(asked * Rational(70, 99) - 20 * millimetre) : 0;
    const Rational off = std::max(each, Rational(0));
    const Rational up = block.around + room_.clearance + 4 * millimetre - off;
    const Rational level = up + cell_ * Rational(3, 2);
    std::int64_t looks = looks_at(up);
    for (std::size_t i = 0; i < block.over; ++i) {
      // as the slab under the roof: who goes down first finds no other cells there
      if (!slabs_[i].region.contains(under.region.intersect(near))) return false;
      if (corners_of(slabs_[i].region) != corners_of(under.region)) return false;
      const Rational height = slabs_[i].ceiling - room_.clearance;
      if (block.top + off - height >= level) continue;
      const Rational down = over.floor + 2 * millimetre - height;
      looks += looks_at(std::min(level, down));
    }
    return looks <= looks_most;
  }
  // Whether all else of the fence is as far off, but for the ground, and a ceiling over what ends
  // there.
  [[nodiscard]] bool keeps_others(const Block& block, const Region& near) const {
    const Rational asked = room_.radius + room_.asked, ground = slabs_.front().floor;
    const Rational high =
        ends(block) ? Rational(slabs_[block.over].floor + room_.clearance) : slabs_.back().ceiling;
    const Region wider = near.grow(2 * asked);
    Solid others = fence_.unite(Solid::prism(wider, ground - 2 * asked, ground));
    if (!ends(block)) others = others.unite(Solid::prism(wider, high, high + 2 * asked));
    if (block.real) others = others.unite(Solid::prism(block.base, ground, block.top));
    return Solid::prism(near, ground, high).subtract(others.shrink(asked, asked)).empty();
  }

  const std::vector<Slab>& slabs_;
  const Solid& fence_;
  const FreeRoom& room_;
  Rational cell_ = 0;
};

}  // namespace

bool beside_free_blocks(const Solid& zone, const Solid& fence, const FreeRoom& room,
                        const Solid& starts) {
  const std::vector<Slab>& slabs = zone.slabs();
  if (slabs.empty() || slabs.size() > slabs_most) return false;
  for (std::size_t i = 1; i < slabs.size(); ++i) {
    // over no place of the zone hangs anything but a ceiling
    const bool joined = slabs[i].floor == slabs[i - 1].ceiling;
    if (!joined || !slabs[i].region.contains(slabs[i - 1].region)) return false;
  }
  // the robot has as many of them if they end on its grid
  const auto whole = [](const Rational& m) { return Rational(m * 1000).get_den() == 1; };
  if (!std::ranges::all_of(
          slabs, [&](const Slab& slab) { return whole(slab.floor) && whole(slab.ceiling); })) {
    return false;
  }
  const Blocks blocks(slabs, fence, room);
  Solid left = starts;
  for (const geometry::PolygonWithHoles& polygon : slabs.front().region.polygons()) {
    for (const Ring& ring : polygon.holes) left = blocks.elsewhere(left, ring);
  }
  return left.empty();
}

}  // namespace rtac::recheck
