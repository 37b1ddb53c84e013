// Whether there is a way to a site from everywhere around it, and how near to it one rests.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/analysis/trials.h"
#include "compiler/analysis/ways_in.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// A robot is charged so near to its dock (language rule 6.7).
inline constexpr std::int64_t dock_reach_mm = 150;
// And counts as parked within this of its site: the route's tests hold it.
inline constexpr std::int64_t parked_mm = 100;
// How far from the end of its way errors and pushes that last may let it rest.
inline std::int64_t rests_off_mm(const ir::Body& body) {
  return body.end_reach_mm + body.sway_mm;
}

// Where the place of a robot is written, which may be one for all of them. Null: nowhere.
const sema::Site::Place* written_place(const sema::Spec& spec, const sema::Site& site,
                                       const std::string& robot);
const sema::Site::Place* written_place(const sema::Spec& spec, const ir::SiteTable& site,
                                       const ir::SiteTable::Place& place);
// The middle of a cell, and how clear the cell is.
struct OtherPlace {
  PlaceMm at;
  std::int64_t clearance_mm = 0;
};
// Where a place is written, and what it might be instead.
struct Move {
  SourceRange written;
  std::vector<OtherPlace> to;
};
struct MovedTo {
  sema::Point from;
  PlaceMm to;
};
// One of these for each of the moves, all of them moved on together: the first with which the whole
// specification works, `fault` being gone (trials.h), as far as whatever works has less clear ones
// alone nearer by. Empty: none.
std::vector<MovedTo> places_that_work(Trials& trials, const Fault& fault,
                                      const std::vector<Move>& moves);

// How far apart two places are at which two robots may be at once, at least: by their bodies, and
// by what monitors keep between them.
std::int64_t at_once_mm(const ir::Decision& decision);
// The distance of two places in the plane, squared.
std::int64_t square_mm2(const ir::SiteTable::Place& one, const ir::SiteTable::Place& other);

// A place of a site that has cells without a way home around it.
struct Cramped {
  const ir::SiteTable::Place& at;
  std::vector<OtherPlace> roomy;  // of all cells those that have none
};
// Of the cells within `radius_mm` of a place of the site, in x and y, each has to have a way: the
// places of which one has none.
std::vector<Cramped> cramped_places(const ir::Module& module, ir::SiteIndex site,
                                    std::int64_t radius_mm);

}  // namespace rtac::analysis
