#include "compiler/driver/verify.h"

#include <chrono>
#include <ostream>
#include <string>
#include <utility>

#include "compiler/driver/certificates.h"
#include "compiler/driver/conservatism.h"
#include "compiler/driver/driver.h"
#include "compiler/driver/mends.h"
#include "compiler/driver/model_checker.h"
#include "compiler/driver/show.h"
#include "compiler/driver/sim.h"
#include "compiler/verify/obligations.h"
#include "compiler/verify/report.h"

namespace rtac::driver {
namespace {

int exit_code(verify::Status worst) {
  switch (worst) {
    case verify::Status::refuted:
      return exit_violation;
    case verify::Status::unknown:
      return exit_inconclusive;
    case verify::Status::proved:
    case verify::Status::acknowledged:
      break;
  }
  return exit_clean;
}

// Nothing is refuted yet, but a run may do so.
bool asks_for_runs(const verify::Report& report) {
  for (const verify::Decision& d : report.decisions) {
    for (const verify::Obligation& o : d.obligations) {
      if (o.in_turns || o.declared) return true;
    }
  }
  return false;
}

// The specification of one compilation is another one's for as long as this is there.
class Lent {
 public:
  Lent(Compilation& from, Compilation& to) : from_(from), to_(to) {
    to.spec = std::move(from.spec);
  }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;
  // what has failed shows nothing
  ~Lent() {
    from_.spec = std::move(to_.spec);
    if (from_.internal_error.empty()) from_.internal_error = std::move(to_.internal_error);
  }

 private:
  Compilation &from_, &to_;
};

// What takes robots in motion: how conservative monitors are, and runs that show what is refuted.
// What cannot be simulated is nothing that the user has done wrong, but for mutants that are none.
int simulate_findings(const Options& options, Compilation& c, verify::Report& report) {
  Compilation aside;
  aside.module = std::move(c.module);
  aside.tables = c.tables;
  int built = exit_clean;
  {
    const Lent lent(c, aside);
    Simulator simulator;
    built = simulator.build(options, aside);
    if (options.conservatism) {
      if (built == exit_clean) {
        measure_conservatism(simulator, aside, report);
      } else {
        leave_unmeasured(report, aside.diagnostics.all().front().message);
      }
    }
    if (built != exit_clean) {
      leave_unshown(report, aside.diagnostics.all().front().message);
    } else if (verify::worst(report) == verify::Status::refuted || asks_for_runs(report)) {
      show(options, simulator, aside, report);
    }
  }
  if (options.mutant.empty() || built != exit_usage) return exit_clean;
  return refuse_mutant(options, c);
}

// Of what was tried nothing is kept. It is attacked for twice as long as what is written, so that
// the same attack on it, once it is written, finds no more.
void play_anew(const Options& options, Compilation& c, BuiltAnew& built, verify::Report& report) {
  const TemporaryFolder folder;
  Options trial = options;
  trial.output = folder.path();
  trial.attack_s = std::to_string(2 * attack_core_s(options));
  Compilation aside;
  aside.module = std::move(built.module);
  aside.tables = built.tables;
  const Lent lent(c, aside);
  Simulator simulator;
  if (simulator.build(trial, aside) == exit_clean) show(trial, simulator, aside, report);
}

}  // namespace

int verify(const Options& options, Compilation& c, std::ostream& out) {
  verify::Report report = verify::verify(*c.spec, c.module ? &*c.module : nullptr, c.tables,
                                         c.diagnostics.all(), check_model);
  verify::Status worst = verify::worst(report);
  if (c.diagnostics.has_errors() && worst != verify::Status::refuted) return exit_spec_errors;
  if (c.module &&
      (options.conservatism || worst == verify::Status::refuted || asks_for_runs(report))) {
    if (const int refused = simulate_findings(options, c, report); refused != exit_clean) {
      return refused;
    }
  }
  leave_open(report);
  if (c.module) {
    offer_mends(
        c, [&](auto& built, auto& anew) { play_anew(options, c, built, anew); }, report);
  }
  worst = verify::worst(report);
  if (!options.output.empty() && report.complete) {
    std::string problem = write_certificates(c, report, options.output);
    if (!problem.empty()) {
      c.diagnostics.report({diag::Code::cannot_write,
                            std::nullopt,
                            std::move(problem),
                            "",
                            {},
                            "give a directory that can be written after `-o`",
                            {}});
      return exit_usage;
    }
  }
  report.micros = std::chrono::duration_cast<std::chrono::microseconds>(
                      std::chrono::steady_clock::now() - c.started)
                      .count();
  out << (options.format == Format::json ? verify::to_json(report, true) : verify::to_text(report));
  return exit_code(worst);
}

}  // namespace rtac::driver
