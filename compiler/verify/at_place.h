// What monitors ask of a place beside being clear of boundaries: charge for a way that begins
// there, heights, and agents who are farther away than anybody knows of.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compiler/verify/proofs.h"

namespace rtac::verify {

struct Place {
  std::int64_t x_mm = 0, y_mm = 0;
  std::optional<std::int64_t> z_mm{};  // none: at a height that suits
};

// Whether all monitors find enough charge to give control back to a robot at rest at a place, with
// a full battery: their properties look ahead, their return conditions do not. `zones`: in which it
// is clear enough to be given back.
bool is_charged_at(const Subject& s, const Place& at, const std::vector<Need>& zones);
// Whether any of them asks for charge.
bool asks_for_charge(const Subject& s);
// The same of what one of them says, without a look ahead, and of heights as well.
bool is_seen_at(const Subject& s, const ir::Block& property, const Place& at,
                const std::vector<Need>& zones);
// Whether it asks for charge, or for heights.
bool asks_for_more(const Subject& s, const ir::Block& property);
// A place of the plane, as clear of all of them, that is good besides: `first` if it is, that of a
// site, or the middle of a cell.
std::optional<geometry::Point> good_place(const Subject& s, const std::vector<Need>& all,
                                          const std::optional<geometry::Point>& first,
                                          const std::function<bool(const Place&)>& is_good);
// Whether its zones settle what it asks of a place, and `mmps`, as fast as a robot at rest may be.
// `is_told`: inputs make what speaks of them true.
bool settles_places(const Subject& s, const ir::Monitor& m, std::int64_t mmps,
                    bool is_told = false);
// `shrink`, tables and the grid: a zone may be so much wider than it is found to be.
inline constexpr std::int64_t rounded_mm = 10;
// The places of sites that monitors ask for the charge of the way to.
std::vector<Place> charging_places(const Subject& s);

// Whether nothing is known of agents who are so far away (language rule 9.8), but that one is
// absent.
bool is_out_of_sight(const Subject& s, ir::AgentIndex agent, std::int64_t least_mm);
// The monitor that asks for an agent to be as far away; "": there is none. `only`: of this one.
std::string out_of_sight(const Subject& s, std::optional<std::size_t> only = {});

}  // namespace rtac::verify
