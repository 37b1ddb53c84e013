#include "compiler/driver/driver.h"

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <ostream>
#include <utility>

#include "compiler/codegen/generate.h"
#include "compiler/codegen/library_names.h"
#include "compiler/codegen/names.h"
#include "compiler/codegen/watch.h"
#include "compiler/contract/contract.h"
#include "compiler/diagnostics/render.h"
#include "compiler/diagnostics/render_sarif.h"
#include "compiler/driver/certificates.h"
#include "compiler/driver/compile.h"
#include "compiler/driver/explain.h"
#include "compiler/driver/explain_line.h"
#include "compiler/driver/files.h"
#include "compiler/driver/fmt.h"
#include "compiler/driver/help.h"
#include "compiler/driver/options.h"
#include "compiler/driver/replay.h"
#include "compiler/driver/sim.h"
#include "compiler/driver/summary.h"
#include "compiler/driver/verify.h"
#include "compiler/driver/write_protocol.h"
#include "compiler/driver/zone_layers.h"
#include "compiler/driver/zone_svg.h"

namespace rtac::driver {
namespace {

// Only for a person at a terminal who did not ask for none (no-color.org).
bool wants_colour(const std::ostream& err) {
  const char* const no_colour = std::getenv("NO_COLOR");
  return &err == &std::cerr && isatty(STDERR_FILENO) != 0 &&
         (no_colour == nullptr || *no_colour == '\0');
}

void show(const Options& options, const Compilation& c, std::ostream& err) {
  if (options.format == Format::json) {
    err << diag::render_json(c.diagnostics, c.sources);
  } else if (options.format == Format::sarif) {
    err << diag::render_sarif(c.diagnostics, c.sources, {RTAC_VERSION, page_about});
  } else {
    err << diag::render_text(c.diagnostics, c.sources, options.colour);
  }
}

// Shows what was found, and that standard output has not taken what was written: a full disk, a
// closed pipe.
int finish(const Options& options, Compilation& c, int status, std::ostream& out,
           std::ostream& err) {
  out.flush();
  const auto& all = c.diagnostics.all();
  const bool told = std::ranges::any_of(
      all, [](const diag::Diagnostic& d) { return d.code == diag::Code::cannot_write; });
  if (!out && !told) {
    c.diagnostics.report({diag::Code::cannot_write,
                          std::nullopt,
                          "cannot write to standard output",
                          "",
                          {},
                          "make room, or give a place that can be written",
                          {}});
  }
  show(options, c, err);
  err.flush();
  return out && (err || status != exit_clean) ? status : exit_usage;
}

std::string base_name(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}
// Name of the generated files; that of the specification when it came from standard input.
std::string stem_of(const Options& options, const Compilation& c) {
  if (options.spec == "-") return c.module->name;
  const std::string name = base_name(options.spec);
  const std::size_t dot = name.find_last_of('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

// Blanks and what else make and ninja read specially.
std::string escaped(const std::string& path) {
  std::string out;
  for (const char c : path) {
    if (c == ' ' || c == '#' || c == '\\') out += '\\';
    if (c == '$') out += '$';
    out += c;
  }
  return out;
}

// The generated files include each other by name, and C has no escapes there.
bool can_be_included(const std::string& stem) {
  return std::none_of(stem.begin(), stem.end(), [](unsigned char c) {
    return c < ' ' || c == '"' || c == '\\' || c == '\x7f';
  });
}

// Why no files can be called like that, and what to do; false: they can.
bool refuse_stem(const Options& options, const std::string& stem, Compilation& c) {
  const std::string name = options.spec == "-" ? stem : base_name(options.spec);
  std::string message, help;
  if (!can_be_included(stem)) {
    message = "`#include` cannot name files that are called like `" + name + "`";
    help = "rename the specification: no quotes, backslashes or line breaks";
  } else {
    const std::string folder = last_folder(options.output);
    const std::string header = codegen::hidden_header(stem, folder);
    if (header.empty()) return false;
    message = "the files of `" + name + "` would hide the header `" + header + "`";
    help = "rename the specification, such as `" + stem + "_monitors" +
           (options.spec == "-" ? "`" : ".rta`");
  }
  c.diagnostics.report(
      {diag::Code::usage, std::nullopt, std::move(message), "", {}, std::move(help), {}});
  return true;
}

// Writing the dependencies over a file that they name would destroy it.
bool is_overwritten(const Options& options, const Compilation& c,
                    const std::vector<OutputFile>& files) {
  const auto is_depfile = [&](const std::string& path) { return same_file(path, options.depfile); };
  return std::any_of(c.dependencies.begin(), c.dependencies.end(), is_depfile) ||
         std::any_of(files.begin(), files.end(),
                     [&](const OutputFile& file) { return is_depfile(file.path); });
}

// The kernel again, with contracts; what they leave out stands in its first lines.
OutputFile with_contracts(const Options& options, const std::string& stem, const Compilation& c,
                          const std::string& kernel) {
  const sema::Spec& spec = *c.spec;
  const std::string prefix =
      options.name_space.empty() ? codegen::legal_namespace(spec.name) : options.name_space;
  const contract::Contracts contracts = contract::contracts_of(spec, c.sources, prefix);
  const contract::Annotated annotated = contract::annotate(kernel, prefix, contracts.text);
  std::string head;
  for (const std::string& gap : contracts.gaps) head += "/* gap: " + gap + " */\n";
  for (const std::string& missing : annotated.missing) head += "/* gap: " + missing + " */\n";
  return {options.output + "/" + stem + "_proof.c", head + annotated.text};
}

int build(const Options& options, Compilation& c) {
  codegen::Naming naming;
  naming.stem = stem_of(options, c);
  if (refuse_stem(options, naming.stem, c)) return exit_usage;
  naming.source = options.spec == "-" ? "standard input" : base_name(options.spec);
  naming.space = options.name_space;
  naming.mutant = options.mutant;
  std::vector<OutputFile> files;
  for (auto& file : codegen::generate(std::move(*c.module), *c.spec, naming)) {
    if (options.contracts && file.name == naming.stem + "_kernel.c") {
      files.push_back(with_contracts(options, naming.stem, c, file.text));
    }
    files.push_back({options.output + "/" + file.name, std::move(file.text)});
  }
  if (files.empty()) return refuse_mutant(options, c);
  if (!options.depfile.empty()) {
    if (is_overwritten(options, c, files)) {
      c.diagnostics.report({diag::Code::usage,
                            std::nullopt,
                            "`--depfile " + options.depfile + "` would overwrite a file of its own",
                            "",
                            {},
                            "give it a name that no specification and no output has",
                            {}});
      return exit_usage;
    }
    std::string text = escaped(files.front().path) + ":";
    for (const std::string& path : c.dependencies) text += " \\\n  " + escaped(path);
    files.push_back({options.depfile, text + "\n"});
  }
  const std::string problem = write_all(files);
  if (problem.empty()) return exit_clean;
  c.diagnostics.report({diag::Code::cannot_write,
                        std::nullopt,
                        problem,
                        "",
                        {},
                        "give a directory that can be written after `-o`",
                        {}});
  return exit_usage;
}

int refuse_picture(Compilation& c, diag::Code code, std::string problem, std::string help) {
  c.diagnostics.report({code, std::nullopt, std::move(problem), "", {}, std::move(help), {}});
  return exit_usage;
}

int draw_zones(const Options& options, Compilation& c, std::ostream& out) {
  const auto is_output = [&](const std::string& path) { return same_file(path, options.output); };
  const bool to_file = options.output != "-";
  if (to_file && std::any_of(c.dependencies.begin(), c.dependencies.end(), is_output)) {
    return refuse_picture(c, diag::Code::usage,
                          "`-o " + options.output + "` would overwrite the specification",
                          "give it a name that no specification has, such as `zones.svg`");
  }
  const std::vector<ZoneSheet> sheets = zone_sheets(c);
  if (sheets.empty()) {
    return refuse_picture(c, diag::Code::usage, "the specification has no zone to draw",
                          "declare one: `zone room = rectangle (0 m, 0 m) to (5 m, 5 m);`");
  }
  const std::string name =
      options.spec == "-" ? "the specification " + c.spec->name : base_name(options.spec);
  std::string picture = zone_svg("Zones of " + name, sheets);
  if (!to_file) {
    out << picture;
    return exit_clean;
  }
  std::string problem = write_all({{options.output, std::move(picture)}});
  if (problem.empty()) return exit_clean;
  return refuse_picture(c, diag::Code::cannot_write, std::move(problem),
                        "give a file that can be written after `-o`");
}

bool has_warnings(const Compilation& c) {
  const auto& all = c.diagnostics.all();
  return std::any_of(all.begin(), all.end(), [](const diag::Diagnostic& d) {
    return diag::info(d.code).severity == diag::Severity::warning;
  });
}

void refuse_bytes(const Options& options, Compilation& c, const SourceRange& range,
                  const std::string& who, std::int64_t bytes) {
  const std::uint64_t most = options.state_bytes_max.value_or(state_bytes_max_default);
  if (static_cast<std::uint64_t>(bytes) <= most) return;
  const std::string needed = std::to_string(bytes);
  c.diagnostics.report(
      {diag::Code::too_many_bytes,
       range,
       who + " remember " + needed + " bytes; at most " + std::to_string(most) + " are allowed",
       "",
       {},
       "shorten their windows, or allow it: `--max-bytes " + needed +
           "`; `rtac explain FILE:LINE` says what each monitor remembers",
       {}});
}

// Everything that is refused by its size is refused before a file is written. An explanation is
// what tells where the bytes are.
void check_bytes(const Options& options, Compilation& c) {
  if (!c.module || options.command == Command::explain) return;
  if (c.module->watch) {
    const std::int64_t tables = codegen::table_bytes(*c.module->watch);
    const char* const who = tables > 0
                                ? "the monitors without a robot and the tables of their zones"
                                : "the monitors without a robot";
    refuse_bytes(options, c, c.spec->name_range, who,
                 codegen::watch_state_bytes(*c.module->watch) + tables);
  }
  for (const ir::Decision& d : c.module->decisions) {
    const auto declared =
        std::find_if(c.spec->decisions.begin(), c.spec->decisions.end(),
                     [&](const sema::Decision& each) { return each.name == d.name; });
    refuse_bytes(options, c, declared->name_range, "the monitors of one robot in `" + d.name + "`",
                 codegen::facts_state_bytes(d.facts));
  }
}

bool is_ready(const Options& options, const Compilation& c) {
  const bool needs_module =
      options.command != Command::replay || options.engine == EngineKind::kernel;
  return c.spec && (c.module || !needs_module) && !c.diagnostics.has_errors() &&
         c.internal_error.empty() && !(options.werror && has_warnings(c));
}
// A recorded run may show why a specification is refused.
bool is_replayable(const Options& options, const Compilation& c) {
  return options.command == Command::sim && !options.recorded.empty() && c.module &&
         c.internal_error.empty();
}

int run_compiled(const Options& options, Compilation& c, std::ostream& out) {
  if (options.command == Command::replay) return replay(options, c, out);
  if (options.command == Command::sim) return simulate(options, c, out);
  if (options.command == Command::build) return build(options, c);
  if (options.command == Command::zones) return draw_zones(options, c, out);
  if (options.command == Command::protocol) return write_protocol(options, c);
  if (options.command == Command::explain) return explain_line(options, c, out);
  const bool dumped =
      options.dump_ast || options.dump_spec || options.dump_ir || !options.print_after.empty();
  if (!dumped) out << summary(*c.module);
  return exit_clean;
}

int run_recheck(const Options& options, std::ostream& out, std::ostream& err) {
  Compilation c;
  const int status = recheck_certificates(options, c, out);
  return finish(options, c, status, out, err);
}

int run(const Options& options, std::ostream& out, std::ostream& err) {
  if (!options.recheck.empty()) return run_recheck(options, out, err);
  Compilation c;
  compile(options, out, c);
  check_bytes(options, c);
  int status = c.unreadable ? exit_usage : exit_spec_errors;
  if (options.command == Command::verify) {
    if (c.spec && c.internal_error.empty()) status = verify(options, c, out);
    if (status == exit_clean && options.werror && has_warnings(c)) status = exit_spec_errors;
  } else if (is_ready(options, c) || is_replayable(options, c)) {
    status = run_compiled(options, c, out);
  }
  if (!c.internal_error.empty()) {
    err << "internal error: " << c.internal_error
        << "\nthis is a bug of rtac; the specification may be fine\n";
    return exit_internal;
  }
  // warnings about other lines are no part of an explanation
  if (options.command == Command::explain && status == exit_clean && out.flush()) return status;
  return finish(options, c, status, out, err);
}

int run_format(const Options& options, std::ostream& out, std::ostream& err) {
  Compilation c;
  const int status = format_files(options, c, out);
  return finish(options, c, status, out, err);
}

int run_explain(const Options& options, std::ostream& out, std::ostream& err) {
  Compilation none;
  const int status = explain(options, none.diagnostics, out);
  return finish(options, none, status, out, err);
}

int run_print(const Options& options, const std::string& text, std::ostream& out,
              std::ostream& err) {
  Compilation none;
  out << text;
  return out.flush() ? exit_clean : finish(options, none, exit_clean, out, err);
}

}  // namespace

int run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err) {
  auto parsed = parse_options(arguments);
  if (const auto* problem = std::get_if<UsageError>(&parsed)) {
    Compilation none;
    none.diagnostics.report(
        {diag::Code::usage, std::nullopt, problem->message, "", {}, problem->help, {}});
    err << diag::render_text(none.diagnostics, none.sources, wants_colour(err));
    return exit_usage;
  }
  Options options = std::get<Options>(std::move(parsed));
  options.colour = wants_colour(err);
  switch (options.command) {
    case Command::help:
      return run_print(options, help_text(options.topic, options.help_flags), out, err);
    case Command::version:
      return run_print(options, "rtac " RTAC_VERSION "\n", out, err);
    case Command::format:
      return run_format(options, out, err);
    case Command::explain:
      if (!options.topic.empty()) return run_explain(options, out, err);
      break;
    case Command::check:
    case Command::build:
    case Command::replay:
    case Command::sim:
    case Command::verify:
    case Command::zones:
    case Command::protocol:
      break;
  }
  return run(options, out, err);
}

}  // namespace rtac::driver
