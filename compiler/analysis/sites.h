// Sites that no decision routes to: those in use are held against the tables of their zones, with
// the clearances that the decision needs.
#pragma once

#include <functional>
#include <optional>

#include "compiler/diagnostics/engine.h"
#include "compiler/geometry/region.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// The zone as a keep-in; nullopt: faulty, and reported.
using RegionOf = std::function<std::optional<geometry::Region>(sema::ZoneId)>;

// Every place that such a controller routes to lies in its zone, with the whole body.
void check_idle_sites(const sema::Spec& spec, const RegionOf& region_of, diag::Engine& diagnostics);

// The monitor that lets none be at a place, and by how much that is out of what it allows.
struct Barred {
  sema::MonitorId by;
  double short_m = 0;
};
// Of a place that the recovery of monitor `k` leads to, the first monitor that outranks it and
// takes over before it arrives.
std::optional<Barred> barred_on_the_way(const sema::Spec& spec, const RegionOf& region_of,
                                        const sema::Decision& decision, std::size_t k,
                                        const sema::Site::Place& place);
// 4008 of that, of the place of a site.
diag::Diagnostic barred_site(const sema::Spec& spec, const Barred& barred,
                             const std::string& recovery, const sema::Site& site,
                             const sema::Site::Place& place);

// Every place that no recovery routes to lies where the robots may be, as the monitors of their
// decisions have it: all robots that charge there, else some.
void check_fenced_out_sites(const sema::Spec& spec, const RegionOf& region_of,
                            diag::Engine& diagnostics);

}  // namespace rtac::analysis
