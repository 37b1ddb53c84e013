// An `or` of which a recovery keeps one side or another, whichever of them held when it took over.
#pragma once

#include <optional>
#include <vector>

#include "compiler/analysis/recovery_places.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// Whether a value holds of each robot that is as slow as that, whatever inputs say.
bool asks_for_slow(const ir::Module& module, const ir::Decision& decision, const ir::Block& block,
                   ir::ValueId id, std::int64_t mmps);

// Whether some `or` of zones and of its own speed holds, outside of those zones, of a robot that is
// too slow for the recovery of monitor `k`: there it would set out faster than that allows.
bool sets_out_faster(const ir::Module& module, const ir::Decision& decision, std::size_t k,
                     const ir::Block& block, ir::ValueId id);

// Whether one side of an `or` does, as slow as the recovery of monitor `k` drives. Its brake makes
// the robot no faster: what held until it stands goes on to hold then, but where inputs change what
// is asked, to which the brake is the answer.
bool has_slow_side(const ir::Module& module, const ir::Decision& decision, std::size_t k,
                   const ir::Block& block, const ir::Or& either);

// The zones of an `or` whose sides are nothing but `r inside Z` in the plane, else none.
std::vector<ir::ZoneIndex> sides_in_zones(const ir::Module& module, const ir::Decision& decision,
                                          const ir::Block& block, ir::ValueId id);

Rational metres_of(std::int64_t mm);

// More than offsets of regions round (geometry/region.h), in mm.
inline constexpr std::int64_t offsets_round_mm = 3;
// More than a leg loses of the clearance that its robot has (connector_loss_m of the routes), in
// mm.
inline constexpr std::int64_t ways_lose_mm = 10;
// The places that are `own_mm` from the boundary of `own`, and for each of `zones` no farther than
// `side_mm` from what it leaves out of that. With less of the former than a disc has, and more of
// the latter: empty where every such disc that lies in `own` lies in one of the zones. The other
// way round: places of discs that lie in none of them. nullopt: too many vertices to tell.
std::optional<geometry::Region> between(const geometry::Region& own,
                                        const std::vector<ir::ZoneIndex>& zones,
                                        const ExactZone& exact, std::int64_t own_mm,
                                        std::int64_t side_mm);

// The places of discs that lie in one of the zones, but for what offsets round. nullopt: too many
// vertices to tell.
std::optional<geometry::Region> places_of_discs(const std::vector<ir::ZoneIndex>& zones,
                                                const ExactZone& exact, std::int64_t radius_mm);
// Whether the places of discs that lie in one of the zones are convex, so that straight ways from
// one of them to another one lead over no other place.
bool straight_between(const std::vector<ir::ZoneIndex>& zones, const ExactZone& exact,
                      std::int64_t radius_mm);

// Whether one side of an `or` holds wherever the recovery of monitor `k` drives, and where it
// stopped another one did.
bool keeps_a_side(const ir::Module& module, const ir::Decision& decision, const ExactZone& exact,
                  std::size_t k, const ir::Block& block, ir::ValueId id);

}  // namespace rtac::analysis
