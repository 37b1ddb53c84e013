// The zones of a specification by the names that claims give them, and what is asked of them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/interp/zones.h"
#include "compiler/sema/spec.h"
#include "compiler/support/source.h"

namespace rtac::recheck {

class NamedZones {
 public:
  NamedZones(const sema::Spec& spec, const SourceManager& sources);
  // none: no zone is called like that.
  [[nodiscard]] std::optional<sema::ZoneId> find(const std::string& name) const;
  [[nodiscard]] std::string name(sema::ZoneId zone) const;
  // nullptr: a zone with height, or one that is received.
  const geometry::Region* region(sema::ZoneId zone) { return zones_.within(zone); }
  // Of a zone of the plane, as far up and down as coordinates go; nullopt: it is not known.
  std::optional<geometry::Solid> solid(sema::ZoneId zone);
  // Whether the place (m) lies in the zone, as far from its boundary; false: it is not known.
  bool clear(sema::ZoneId zone, const geometry::Point& place, const Rational& clearance);
  // The same of a place in space.
  bool clear_in_space(sema::ZoneId zone, const geometry::Point& place, const Rational& z,
                      const Rational& clearance);
  // Whether each of its slabs is convex, and it has no other one if it counts in space as a whole.
  bool convex(sema::ZoneId zone, bool slab_by_slab);
  // How many slabs it has, one in the plane; 0: it is not known.
  std::size_t slabs(sema::ZoneId zone);
  // The outline of one of them; nullptr: it is not known.
  const geometry::Region* slab(sema::ZoneId zone, std::size_t slab);
  bool convex_slab(sema::ZoneId zone, std::size_t slab);
  // Whether the places of discs that lie in one of these zones of the plane are convex.
  bool convex_for(const std::vector<sema::ZoneId>& zones, const Rational& radius);
  // Whether slab `to` is 2 `clearance` high, and it gets no narrower on the way there, straight up
  // or down, from any place of slab `from`.
  bool leads_straight(sema::ZoneId zone, std::size_t from, std::size_t to,
                      const Rational& clearance);
  // Whether the height is that of a place of the slab, `clearance` from its ends.
  bool within_slab(sema::ZoneId zone, std::size_t slab, const Rational& z,
                   const Rational& clearance);

 private:
  const sema::Spec& spec_;
  std::vector<std::string> names_;  // by ZoneId
  std::map<sema::ZoneId, geometry::Solid> slabs_;
  interp::Zones zones_;
};

// The cells that recoveries find their ways over.
struct Cells {
  std::int64_t cell_mm = 0, x_mm = 0, y_mm = 0;  // width; where the first one begins
};
struct BadCells {
  bool too_many = false;  // or there is too much to look at: nothing is known
};
// Whether from every cell of the zone whose places have `body_m` of clearance a way leads, over
// cells as clear as `route_m` or as the one that it starts from, to one as clear as `goal_m`, or to
// one of `sites`; and whether ways begin from everywhere in it; where `sites` are none, from there
// a leg in sight may lead straight to such a place instead. The outline is the one that a robot
// has, on its grid and inside of the exact one, and so are its cells. Otherwise the place of a cell
// from which none leads.
std::variant<std::monostate, geometry::Point, BadCells> without_way(
    const geometry::Region& zone, const Cells& cells, const Rational& body_m,
    const Rational& route_m, const Rational& goal_m, const std::vector<geometry::Point>& sites);
// Whether from every place with `seen_m` of clearance and less than `fits_m` a leg leads straight
// to one with `fits_m`, over the cells of the same outline: whoever is seen with less than its body
// takes, `body_m`, which it has where it is, no farther off than `error_m`, is led in that way
// alone. Otherwise the place of a cell.
std::variant<std::monostate, geometry::Point, BadCells> without_leg(
    const geometry::Region& zone, const Cells& cells, const Rational& seen_m,
    const Rational& body_m, const Rational& error_m, const Rational& fits_m);
// The length of the longest of these ways, each the shortest one on which no cell is less clear
// than what the one before it asks for: the search finds none that is longer. From cells without
// such a way counts the leg in sight that may be taken, without `sites`. The leg to where its cells
// begin is left out, up to the reach within which the search takes the best one. A goal that is
// `deeper` than where control is given back need not be reached. nullopt: of some of them nothing
// bounds the way.
struct LongestWays {
  Rational longest;
  std::vector<double> from;  // by cell: from any place of it, what joins it included
};
std::optional<LongestWays> longest_ways(const geometry::Region& zone, const Cells& cells,
                                        const Rational& body_m, const Rational& route_m,
                                        const Rational& goal_m,
                                        const std::vector<geometry::Point>& sites,
                                        bool deeper = false);
std::optional<Rational> longest_way(const geometry::Region& zone, const Cells& cells,
                                    const Rational& body_m, const Rational& route_m,
                                    const Rational& goal_m,
                                    const std::vector<geometry::Point>& sites, bool deeper = false);

// Whether from anywhere in the zone with less than `back_m` a leg no longer than `most_m` leads to
// a place as clear as `aim_m`, and keeps the clearance that it begins with.
bool legs_lead(const geometry::Region& zone, const Cells& cells, const Rational& body_m,
               const Rational& back_m, const Rational& aim_m, const Rational& most_m);

// Of zones, which lie within 100 km of the origin; what reaches farther is a complement.
bool has_end(const geometry::Region& region);

}  // namespace rtac::recheck
