#include "compiler/driver/compile.h"

#include <algorithm>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

#include "compiler/analysis/derive.h"
#include "compiler/analysis/zones.h"
#include "compiler/codegen/mutate.h"
#include "compiler/driver/driver.h"
#include "compiler/driver/files.h"
#include "compiler/driver/model_checker.h"
#include "compiler/ir/printer.h"
#include "compiler/ir/verifier.h"
#include "compiler/passes/pipeline.h"
#include "compiler/sema/check.h"
#include "compiler/sema/spec_printer.h"
#include "compiler/syntax/parse.h"
#include "compiler/syntax/printer.h"
#include "compiler/verify/obligations.h"

namespace rtac::driver {
namespace {

void run_passes(const Options& options, std::ostream& out, Compilation& c) {
  if (const auto problem = ir::verify(*c.module)) {
    c.internal_error = "after building the IR: " + *problem;
    return;
  }
  const auto after = [&](const passes::Pass& pass) {
    if (options.print_after == pass.name) out << ir::print(*c.module);
  };
  if (auto problem = passes::run_pipeline(*c.module, c.diagnostics, after)) {
    c.internal_error = std::move(*problem);
  }
}

// As `rtac verify` will, of a specification that is tried.
std::set<analysis::Fault> judge(const sema::Spec& spec, const analysis::Derived& derived,
                                const diag::Engine& diagnostics, bool turns) {
  return verify::open_obligations(spec, derived.module, derived.tables, diagnostics.all(),
                                  turns ? check_small_model : protocol::CheckModel());
}

// What is imported has no `spec` line, and must not get one: it is read with what imports it.
void tell_of_parts(const Options& options, const syntax::File& root, Compilation& c) {
  const auto& all = c.diagnostics.all();
  const bool lacks_spec = std::any_of(all.begin(), all.end(), [&](const diag::Diagnostic& d) {
    return d.code == diag::Code::missing_spec_name && d.range == SourceRange{root.id, 0, 0};
  });
  if (!lacks_spec || root.items.empty()) return;
  const std::string command =
      options.line.empty() ? "rtac check MAIN.rta"
                           : "rtac explain " + options.spec + ":" + options.line + " --in MAIN.rta";
  c.diagnostics.add_note(diag::Code::missing_spec_name,
                         "a file that others import has none: `" + command +
                             "` works, where MAIN.rta is a specification that imports it");
}

// A recovery that spends charge is built as if that were acknowledged.
int errors_in_building(const diag::Engine& diagnostics) {
  const auto& all = diagnostics.all();
  return static_cast<int>(std::count_if(all.begin(), all.end(), [](const diag::Diagnostic& d) {
    return d.code != diag::Code::recovery_spends_charge &&
           diag::info(d.code).severity == diag::Severity::error;
  }));
}

}  // namespace

std::optional<FileId> open_source(const std::string& path, Compilation& c) {
  std::string why;
  const bool from_stdin = path == "-";
  std::optional<FileId> file;
  if (!from_stdin) {
    file = c.sources.load(path, why);
  } else if (auto text = read_stdin(why)) {
    file = c.sources.add("<stdin>", std::move(*text));
  }
  if (!file) {
    c.unreadable = true;
    c.diagnostics.report(
        {diag::Code::cannot_read,
         std::nullopt,
         "cannot read " + (from_stdin ? "standard input" : "`" + path + "`") + ": " + why,
         "",
         {},
         "give the path of a .rta file, or - for standard input",
         {}});
  }
  return file;
}

std::optional<BuiltAnew> build_anew(sema::Spec& spec, const SourceManager& sources) {
  BuiltAnew built;
  auto derived =
      analysis::derive(spec, sources, built.diagnostics, analysis::Finding::is_told, {}, false);
  if (!derived || built.diagnostics.has_errors()) return std::nullopt;
  built.module = std::move(derived->module);
  built.tables = std::move(derived->tables);
  const bool whole = !passes::run_pipeline(built.module, built.diagnostics, [](const auto&) {});
  if (!whole || built.diagnostics.has_errors()) return std::nullopt;
  return built;
}

int refuse_mutant(const Options& options, Compilation& c) {
  c.diagnostics.report(
      {diag::Code::usage,
       std::nullopt,
       "the mutant `" + options.mutant + "` changes nothing of `" + c.spec->name + "`",
       "",
       {},
       std::string("it believes that ") + codegen::find_mutant(options.mutant)->about +
           ", which makes no difference to any decision here",
       {}});
  return exit_usage;
}

void check_only(const Options& options, Compilation& c) {
  const auto file = open_source(options.spec, c);
  if (!file) return;
  const syntax::Program program =
      syntax::parse_program(*file, c.sources, c.diagnostics, c.dependencies);
  c.spec = sema::check(program, c.diagnostics);
}

void compile(const Options& options, std::ostream& out, Compilation& c) {
  const auto file = open_source(options.spec, c);
  if (!file) return;
  const syntax::Program program =
      syntax::parse_program(*file, c.sources, c.diagnostics, c.dependencies);
  tell_of_parts(options, program.files.back(), c);  // the root is visited to its end last
  if (options.dump_ast) out << syntax::dump(program, c.sources);
  c.spec = options.command == Command::verify ? sema::check_refuted(program, c.diagnostics)
                                              : sema::check(program, c.diagnostics);
  if (!c.spec && !c.diagnostics.has_errors()) {
    c.internal_error = "the checker has refused the specification and not said why";
  }
  // with errors, there is nothing but to say what they refute
  if (!c.spec || c.diagnostics.has_errors()) return;
  if (options.dump_spec) out << sema::dump(*c.spec);
  // The interpreter shares nothing with what follows. A zone that is none it would take for
  // unknown, and one beyond the grid for what no kernel knows.
  if (options.command == Command::replay && options.engine == EngineKind::interp) {
    analysis::check_zones(*c.spec, c.diagnostics);
    return;
  }
  // What is refused because it cannot work is told in full there, and played again.
  const bool played = options.command == Command::sim && !options.recorded.empty();
  const auto finding = options.command == Command::verify ? analysis::Finding::is_told
                       : played                           ? analysis::Finding::is_played
                                                          : analysis::Finding::refuses;
  diag::Engine said;  // whoever plays a run again mends nothing: what would work is not sought
  auto derived = analysis::derive(*c.spec, c.sources, played ? said : c.diagnostics, finding, judge,
                                  options.offers && !played);
  for (diag::Diagnostic each : said.all()) {
    each.help = "`rtac check` says what would work";
    c.diagnostics.report(std::move(each));
  }
  if (!derived) return;
  const int errors = finding == analysis::Finding::refuses ? 0 : errors_in_building(c.diagnostics);
  c.module = std::move(derived->module);
  c.tables = std::move(derived->tables);
  run_passes(options, out, c);
  const int now = finding == analysis::Finding::refuses ? c.diagnostics.error_count()
                                                        : errors_in_building(c.diagnostics);
  if (now > errors || !c.internal_error.empty()) {
    c.module.reset();
    return;
  }
  if (options.command == Command::check || options.command == Command::build) {
    for (diag::Diagnostic& d : verify::never_given_back(*c.spec, *c.module, c.tables)) {
      c.diagnostics.report(std::move(d));
    }
  }
  if (options.dump_ir) out << ir::print(*c.module);
}

}  // namespace rtac::driver
