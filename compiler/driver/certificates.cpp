#include "compiler/driver/certificates.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/driver/driver.h"
#include "compiler/driver/files.h"
#include "compiler/driver/model_checker.h"
#include "compiler/driver/process.h"
#include "compiler/driver/seals.h"
#include "compiler/recheck/recheck.h"
#include "compiler/verify/report.h"

namespace rtac::driver {
namespace {

namespace fs = std::filesystem;

constexpr const char* solver = "z3";
// For one lemma, as the solver is told, and until it is ended: it is told, since nobody ends it
// when this program has been killed.
constexpr int solver_seconds_max = 20, spare_s = 2;

constexpr const char* standard_input = "<stdin>";

// The folder above all files that were read, so that imports keep their places.
fs::path common_folder(const std::vector<std::string>& files) {
  fs::path common = fs::weakly_canonical(files.front()).parent_path();
  for (const std::string& file : files) {
    const fs::path path = fs::weakly_canonical(file);
    while (!common.empty() && common != common.root_path()) {
      const fs::path below = path.lexically_relative(common);
      if (!below.empty() && *below.begin() != "..") break;
      common = common.parent_path();
    }
  }
  return common;
}

int refuse(Compilation& c, diag::Code code, std::string message, std::string help) {
  c.diagnostics.report({code, std::nullopt, std::move(message), "", {}, std::move(help), {}});
  return exit_usage;
}

// How often a script asks.
std::size_t questions_of(const std::string& script) {
  const std::string question = "(check-sat)";
  std::size_t count = 0;
  for (std::size_t at = script.find(question); at != std::string::npos;
       at = script.find(question, at + question.size())) {
    ++count;
  }
  return count;
}

// What z3 says of a script: `unsat` to every question, or else something is not proved. One that
// has not ended once is not asked again.
std::optional<recheck::Doubt> ask(const std::string& script, const std::string& folder,
                                  bool& hangs) {
  const std::string file = folder + "/lemma.smt2", said = folder + "/said";
  if (hangs) return recheck::Doubt{false, "z3 is not asked, since it has not ended before"};
  std::ofstream(file, std::ios::binary) << script;
  const ProgramResult result =
      run_within(solver_seconds_max + spare_s,
                 {solver, "-T:" + std::to_string(solver_seconds_max), file}, said);
  hangs = result.timed_out;
  if (hangs) {
    return recheck::Doubt{false,
                          "z3 has not ended within " + std::to_string(solver_seconds_max) + " s"};
  }
  if (!result.started) return recheck::Doubt{false, "z3 cannot be started: " + result.problem};
  const std::string answer = read_file(said).value_or("");
  std::size_t from = 0, answers = 0;
  while (from < answer.size()) {
    const std::size_t end = std::min(answer.find('\n', from), answer.size());
    const std::string line = answer.substr(from, end - from);
    from = end + 1;
    ++answers;
    if (line == "unsat") continue;
    if (line == "sat") return recheck::Doubt{true, "z3 has found a case in which it is false"};
    return recheck::Doubt{false, "z3 says: " + told(line)};
  }
  if (answers == 0) return recheck::Doubt{false, "z3 has said nothing"};
  if (answers != questions_of(script)) {
    return recheck::Doubt{false, "z3 has answered " + std::to_string(answers) + " of " +
                                     std::to_string(questions_of(script)) + " questions"};
  }
  if (result.status != 0) {
    return recheck::Doubt{false, "z3 has ended with status " + std::to_string(result.status)};
  }
  return std::nullopt;
}

// A lemma is the one that this program knows, and z3 proves it.
std::optional<recheck::Doubt> prove(const std::string& name, const std::string& folder,
                                    const std::string& scratch, bool& hangs) {
  const auto known = lemma_texts().find(name);
  if (known == lemma_texts().end()) return recheck::Doubt{true, "no lemma is called " + name};
  const auto written = read_file(folder + "/lemmas/" + name + ".smt2");
  if (!written) return recheck::Doubt{true, "lemmas/" + name + ".smt2 is missing"};
  if (*written != known->second) return recheck::Doubt{true, "lemmas/" + name + ".smt2 is another"};
  return ask(*written, scratch, hangs);
}

std::string model_path(const std::string& folder, const std::string& decision) {
  return folder + "/models/" + decision + ".pml";
}
// The model that was written is this one, but for its comments in front, and all claims hold of it.
std::optional<recheck::Doubt> prove_model(const protocol::Model& model, const std::string& folder) {
  const std::string name = "models/" + model.decision + ".pml", first = "#define MONITORS";
  const auto written = read_file(model_path(folder, model.decision));
  if (!written) return recheck::Doubt{true, name + " is missing"};
  const std::string text = model.text();
  const std::size_t from = written->find(first);
  if (from == std::string::npos || written->substr(from) != text.substr(text.find(first))) {
    return recheck::Doubt{true, name + " is another"};
  }
  for (const protocol::Answer& a : check_model(model)) {
    if (a.kind == protocol::Answer::Kind::holds) continue;
    const bool broken = a.kind == protocol::Answer::Kind::broken;
    return recheck::Doubt{broken, a.claim + ": " + (broken ? "a run breaks it" : a.why)};
  }
  return std::nullopt;
}

// What several claims of an obligation have in common is said once.
void tell(const char* what, const std::vector<std::string>& lines, std::ostream& out) {
  for (std::size_t from = 0, to = 0; from < lines.size(); from = to) {
    while (to < lines.size() && lines[to] == lines[from]) ++to;
    out << what << lines[from];
    if (to - from > 1) out << " (" << to - from << " claims)";
    out << "\n";
  }
}

// The files of the folder that say what is proved, and of what. Lemmas and models are held against
// those that this program knows.
std::vector<std::string> read_of(const std::string& folder, const Compilation& c) {
  std::vector<std::string> all = {"specification", "verification.json"};
  for (const std::string& path : c.dependencies) {
    all.push_back(fs::weakly_canonical(path)
                      .lexically_relative(fs::weakly_canonical(folder))
                      .generic_string());
  }
  return all;
}

}  // namespace

std::string write_certificates(const Compilation& c, const verify::Report& report,
                               const std::string& folder) {
  const fs::path common = common_folder(c.dependencies);
  std::vector<OutputFile> files;
  const auto place = [&](const std::string& path) {
    if (path == standard_input) return std::string("specification.rta");
    return fs::weakly_canonical(path).lexically_relative(common).string();
  };
  for (const std::string& path : c.dependencies) {
    std::optional<std::string> text;
    if (path == standard_input) {
      text = std::string(c.sources.text(c.spec->name_range.file));
    } else {
      text = read_file(path);
    }
    if (!text) return "cannot read " + path + " again";
    files.push_back({folder + "/sources/" + place(path), std::move(*text)});
  }
  std::set<std::string> lemmas;
  for (const verify::Decision& d : report.decisions) {
    for (const verify::Obligation& o : d.obligations) {
      for (const verify::Claim& claim : o.claims) {
        if (claim.what == "lemma") lemmas.insert(claim.values.at("name"));
      }
      if (!o.model.empty()) files.push_back({model_path(folder, d.name), o.model});
    }
  }
  for (const std::string& name : lemmas) {
    const auto known = lemma_texts().find(name);
    if (known != lemma_texts().end()) {
      files.push_back({folder + "/lemmas/" + name + ".smt2", known->second});
    }
  }
  files.push_back({folder + "/specification", place(c.dependencies.front()) + "\n"});
  files.push_back({folder + "/verification.json", verify::to_json(report, false)});
  std::vector<std::pair<std::string, std::string_view>> to_seal;
  for (const OutputFile& file : files) {
    to_seal.emplace_back(file.path.substr(folder.size() + 1), file.text);
  }
  files.push_back({folder + "/" + seals_name, seals_of(std::move(to_seal))});
  return write_all(files);
}

int recheck_certificates(const Options& options, Compilation& c, std::ostream& out) {
  const std::string& folder = options.recheck;
  auto name = read_file(folder + "/specification");
  const auto report = read_file(folder + "/verification.json");
  if (!name || !report) {
    return refuse(c, diag::Code::cannot_read, "`" + folder + "` holds no certificates",
                  "`rtac verify SPEC -o DIR` writes them");
  }
  while (!name->empty() && name->back() == '\n') name->pop_back();
  Options of_spec = options;
  of_spec.spec = folder + "/sources/" + *name;
  check_only(of_spec, c);
  if (!c.spec) return c.unreadable ? exit_usage : exit_spec_errors;
  const TemporaryFolder scratch;
  if (!scratch.problem().empty()) {
    return refuse(c, diag::Code::cannot_write, scratch.problem(), "make room, or set TMPDIR");
  }
  bool hangs = false;
  std::vector<std::string> read = read_of(folder, c);
  const recheck::Provers provers{[&](const std::string& lemma) {
                                   read.push_back("lemmas/" + lemma + ".smt2");
                                   return prove(lemma, folder, scratch.path(), hangs);
                                 },
                                 [&](const protocol::Model& model) {
                                   read.push_back("models/" + model.decision + ".pml");
                                   return prove_model(model, folder);
                                 }};
  const recheck::Outcome outcome = recheck::recheck(*c.spec, c.sources, *report, provers);
  const std::vector<std::string> broken = broken_seals(folder, read);
  for (const std::string& file : broken) {
    out << "not proved: `" << file << "` is not what was written: its seal is broken\n";
  }
  tell("not proved: ", outcome.failed, out);
  tell("unknown: ", outcome.open, out);
  tell("refuted, as the report says: ", outcome.refuted, out);
  tell("unknown, as the report says: ", outcome.unknown, out);
  out << outcome.obligations << " obligations, " << outcome.claims << " claims, "
      << outcome.failed.size() + broken.size() << " not proved, " << outcome.open.size()
      << " unknown; the report leaves " << outcome.refuted.size() << " obligations refuted and "
      << outcome.unknown.size() << " unknown\n";
  if (!outcome.failed.empty() || !broken.empty() || !outcome.refuted.empty()) return exit_violation;
  return outcome.open.empty() && outcome.unknown.empty() ? exit_clean : exit_inconclusive;
}

}  // namespace rtac::driver
