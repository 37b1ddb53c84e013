#include "compiler/sema/check.h"

#include <algorithm>

#include "compiler/sema/agents.h"
#include "compiler/sema/context.h"
#include "compiler/sema/controllers.h"
#include "compiler/sema/decisions.h"
#include "compiler/sema/declare.h"
#include "compiler/sema/fleets.h"
#include "compiler/sema/inputs.h"
#include "compiler/sema/monitors.h"
#include "compiler/sema/origin.h"
#include "compiler/sema/property.h"
#include "compiler/sema/robots.h"
#include "compiler/sema/watches.h"
#include "compiler/sema/zones.h"

namespace rtac::sema {
namespace {

using diag::Code;

bool refutes(const diag::Diagnostic& d) {
  return diag::info(d.code).severity != diag::Severity::error || d.code == Code::recovery_missing ||
         d.code == Code::limit_contradictory || d.code == Code::outputs_differ;
}

std::optional<Spec> checked(const syntax::Program& program, diag::Engine& diagnostics,
                            bool although_refuted) {
  Context context(diagnostics, program);
  if (!program.files.empty() && program.files.back().spec) {
    context.spec.name = program.files.back().spec->text;
    context.spec.name_range = program.files.back().spec->range;
  }
  // Each step needs the ones before it: names before uses, the origin before the zones that are
  // placed about it, robots before the places that belong to them, places before the kinds that
  // charge there, limits of kinds before the controllers that must keep them, the period and the
  // signals before the properties that speak of them, properties before the decisions that say when
  // they are judged.
  declare_all(context, program);
  check_origin(context, program);
  check_zones(context);
  check_fleets(context, program);
  check_sites(context, program);
  check_kinds(context);
  check_controllers(context);
  check_settings(context, program);
  check_inputs(context);
  check_agents(context);
  check_params(context);
  check_carriers(context);
  check_functions(context);
  check_monitors(context);
  check_watches(context);
  check_assumptions(context, program);
  check_directions(context);
  check_decisions(context);
  if (!diagnostics.has_errors()) {
    warn_unused_signals(context);
    warn_without_robots(context);
  }
  const bool faulty = although_refuted ? !std::ranges::all_of(diagnostics.all(), refutes)
                                       : diagnostics.has_errors();
  if (faulty || context.silent()) return std::nullopt;
  return std::move(context.spec);
}

}  // namespace

std::optional<Spec> check(const syntax::Program& program, diag::Engine& diagnostics) {
  return checked(program, diagnostics, false);
}
std::optional<Spec> check_refuted(const syntax::Program& program, diag::Engine& diagnostics) {
  return checked(program, diagnostics, true);
}

}  // namespace rtac::sema
