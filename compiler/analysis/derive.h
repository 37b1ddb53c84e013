// From the checked specification to the decision IR: zones, ways to sites, limits, horizons,
// blocks, clearances; and the checks that these numbers work out.
#pragma once

#include <functional>
#include <optional>
#include <set>

#include "compiler/analysis/share.h"
#include "compiler/analysis/trials.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"
#include "compiler/ir/table_map.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

struct Derived {
  ir::Module module;
  ir::TableMap tables;
};

// What becomes of a module that could be built and is not well formed. One that is played, as who
// has recorded a run of it asks, is told of as if it were refused.
enum class Finding { refuses, is_told, is_played };
// Of what could be built, with its reports: what is not shown of it; where asked, which takes
// seconds, that recoveries take turns for ever as well.
using Judge = std::function<std::set<Fault>(const sema::Spec& spec, Derived derived,
                                            const diag::Engine& diagnostics, bool turns)>;
// `spec` is left as it is; in between, numbers and orders that reports offer are tried in it.
// nullopt when an error was reported, unless it is about arbitration (6005); otherwise not of one
// that says that it is not well formed either. With a `judge` no order is offered with which less
// is shown, and with `is_told` no number either. Without `offers` reports say what is wrong, and
// not with which numbers it would work, which takes longer to find out than all the rest; and, as
// of what is only tried, 5020 also of places from where nobody has looked for a way.
std::optional<Derived> derive(sema::Spec& spec, const SourceManager& sources,
                              diag::Engine& diagnostics, Finding finding = Finding::refuses,
                              const Judge& judge = {}, bool offers = true);

// What `rtac check` tells about one monitor, in mm and us.
struct MonitorSummary {
  std::string monitor;
  std::int64_t lookahead_us = 0, horizon_us = 0;  // D, and D + sample age + latency
  std::int64_t stopping_mm = 0;                   // from full speed, horizon included
  std::int64_t return_clearance_mm = 0;
  std::int64_t lookahead_max_us = 0;  // longest D with a place to return to, 0: not a fence
  std::int64_t leave_us = 0;          // to lead out of zones that come and go, 0: there are none
  // Of the first zone of the plane that it holds the robot in; "": there is none.
  std::string zone{};
  Share share{};
};
std::vector<MonitorSummary> summarise(const ir::Module& module, const ir::Decision& decision);

}  // namespace rtac::analysis
