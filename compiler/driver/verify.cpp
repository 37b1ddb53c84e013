#include "compiler/driver/verify.h"

#include <ostream>
#include <sstream>
#include <string>
#include <utility>

#include "compiler/driver/certificates.h"
#include "compiler/driver/driver.h"
#include "compiler/driver/files.h"
#include "compiler/driver/process.h"
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

// `yard` of `specs/yard.rta`.
std::string stem_of(const std::string& path) {
  const std::string name = path.substr(path.find_last_of('/') + 1);
  const std::size_t dot = name.find_last_of('.');
  return path == "-" ? "specification" : name.substr(0, dot == 0 ? std::string::npos : dot);
}

// Robots under attack, for as many runs as a person waits for.
constexpr const char* runs_to_show = "60";

// A run in which a monitor that has a refuted obligation is violated, if attacks find one: its
// trace, for `rtac sim --replay`.
void show(const Options& options, Compilation& c, verify::Report& report) {
  Options attack = options;
  attack.command = Command::sim;
  attack.runs = runs_to_show;
  const TemporaryFolder folder;
  if (!folder.problem().empty()) return;
  attack.trace_out = folder.path() + "/violation.trace";
  Compilation aside;  // what cannot be simulated is nothing that the user has done wrong
  aside.spec = std::move(c.spec);
  aside.module = std::move(c.module);
  aside.tables = c.tables;
  std::ostringstream said;
  const int status = simulate(attack, aside, said);
  c.spec = std::move(aside.spec);
  if (status != exit_violation) return;
  const std::string table = said.str(), mark = "violated: ";
  const std::size_t at = table.find(mark);
  if (at == std::string::npos) return;
  const std::size_t begin = at + mark.size();
  const std::string name = table.substr(begin, table.find(' ', begin) - begin);
  const std::string place = options.output.empty() ? stem_of(options.spec) + ".trace"
                                                   : options.output + "/violation.trace";
  if (!write_all({{place, read_file(attack.trace_out).value_or("")}}).empty()) return;
  for (verify::Decision& d : report.decisions) {
    for (verify::Obligation& o : d.obligations) {
      if (o.status == verify::Status::refuted && o.monitor == name) o.trace = place;
    }
  }
}

}  // namespace

int verify(const Options& options, Compilation& c, std::ostream& out) {
  verify::Report report =
      verify::verify(*c.spec, c.module ? &*c.module : nullptr, c.tables, c.diagnostics.all());
  const verify::Status worst = verify::worst(report);
  if (c.diagnostics.has_errors() && worst != verify::Status::refuted) return exit_spec_errors;
  if (c.module && worst == verify::Status::refuted) show(options, c, report);
  if (!options.output.empty()) {
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
  out << (options.format == Format::json ? verify::to_json(report, true) : verify::to_text(report));
  return exit_code(worst);
}

}  // namespace rtac::driver
