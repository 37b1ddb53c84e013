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

// Every place that a recovery routes to lies where the monitors that outrank it let a robot be; any
// other lies where the robots may be, as the monitors of their decisions have it: all robots that
// charge there, else some.
void check_fenced_out_sites(const sema::Spec& spec, const RegionOf& region_of,
                            diag::Engine& diagnostics);

}  // namespace rtac::analysis
