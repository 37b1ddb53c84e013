#include "compiler/driver/sim.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "compiler/analysis/derive.h"
#include "compiler/codegen/generate.h"
#include "compiler/codegen/simulation.h"
#include "compiler/driver/decision_engine.h"
#include "compiler/driver/driver.h"
#include "compiler/driver/files.h"
#include "compiler/driver/seals.h"
#include "compiler/driver/shared_object.h"
#include "compiler/driver/sim_glue.h"

namespace rtac::driver {
namespace {

namespace fs = std::filesystem;

// The prefix of the generated names does not matter to anybody.
constexpr const char* sim_kernel_name = "sim";
constexpr const char* sim_kernel_source = "sim_kernel.c";
constexpr const char* nothing_mutated = "nothing is mutated";

int refuse(Compilation& c, diag::Code code, std::string message, std::string help, int status) {
  c.diagnostics.report({code, std::nullopt, std::move(message), "", {}, std::move(help), {}});
  return status;
}

// Beside this program, or wherever $RTAC_SIM says.
std::string simulator() {
  if (const char* const chosen = std::getenv("RTAC_SIM"); chosen != nullptr && *chosen != '\0') {
    return chosen;
  }
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const fs::path beside = self.parent_path() / "rtac-sim";
  return !error && fs::exists(beside, error) ? beside.string() : "rtac-sim";
}

std::string base_name(const std::string& path) {
  return path == "-" ? "standard input" : path.substr(path.find_last_of('/') + 1);
}

// What is generated of the module, which is gone then; what went wrong, or nothing was generated.
std::string compile_kernel(const Options& options, Compilation& c, const std::string& folder) {
  const std::vector<DecisionInterface> decisions =
      decision_interfaces(*c.module, *c.spec, sim_kernel_name);
  codegen::Naming naming;
  naming.stem = naming.space = sim_kernel_name;
  naming.mutant = options.mutant;
  const codegen::Mutant* const mutant = codegen::find_mutant(options.mutant);
  if (mutant != nullptr && !codegen::may_matter(*mutant, *c.module)) return nothing_mutated;
  std::vector<OutputFile> files;
  for (auto& file : codegen::generate(std::move(*c.module), *c.spec, naming)) {
    files.push_back({std::move(file.name), std::move(file.text)});
  }
  if (files.empty()) return nothing_mutated;
  return compile_object(files, sim_glue(decisions, sim_kernel_source), folder);
}

std::vector<std::string> flags_of(const Options& options) {
  const std::pair<const char*, const std::string*> flags[] = {
      {"--scenario", &options.scenario},   {"--seed", &options.seed},
      {"--runs", &options.runs},           {"--jobs", &options.jobs},
      {"--adversary", &options.adversary}, {"--trace", &options.trace_out},
      {"--replay", &options.recorded}};
  std::vector<std::string> words;
  for (const auto& [flag, value] : flags) {
    if (value->empty()) continue;
    words.emplace_back(flag);
    words.push_back(*value);
  }
  return words;
}

// Of each decision, the least of its monitors' shares of places where control comes back.
std::vector<std::string> predictions(const ir::Module& module) {
  std::string all;
  for (const ir::Decision& d : module.decisions) {
    std::optional<int> least;
    for (const analysis::MonitorSummary& s : analysis::summarise(module, d)) {
      if (!s.zone.empty()) least = std::min(least.value_or(s.share.returns), s.share.returns);
    }
    if (least) all += (all.empty() ? "" : ",") + d.name + "=" + std::to_string(*least);
  }
  if (all.empty()) return {};
  return {"--predicted", all};
}

constexpr std::array every_way = {Agents::as_declared, Agents::stand, Agents::walk_up};
const char* file_of(Agents agents) {
  return agents == Agents::stand     ? "/standing.json"
         : agents == Agents::walk_up ? "/walking_up.json"
                                     : "/simulation.json";
}
// The same specification, whose agents take no step, or count however slow a robot is.
std::string manifest_where(Agents agents, const std::string& manifest) {
  constexpr double never_mps = -1;  // nobody is as slow
  auto told = nlohmann::ordered_json::parse(manifest);
  for (auto& decision : told["decisions"]) {
    if (!decision.contains("agents")) continue;
    if (agents == Agents::walk_up) decision["rest_mps"] = never_mps;
    if (agents != Agents::stand) continue;
    for (auto& agent : decision["agents"]) agent["speed_mps"] = 0;
  }
  return told.dump() + "\n";
}

// What the program has not understood, as it says itself: a line, after a tab what would work, and
// perhaps after another one which diagnostic it is.
int report_refusal(Compilation& c, const std::string& said, int status) {
  std::istringstream words(said);
  std::string message, help, number;
  std::getline(words, message, '\t');
  std::getline(words, help, '\t');
  std::getline(words, number);
  for (std::string* text : {&message, &help}) {
    while (!text->empty() && text->back() == '\n') text->pop_back();
  }
  auto code = status == exit_usage ? diag::Code::bad_scenario : diag::Code::cannot_simulate;
  for (const auto named : {diag::Code::cannot_read, diag::Code::cannot_write}) {
    if (number == std::to_string(static_cast<int>(named))) code = named;
  }
  return refuse(c, code, std::move(message), std::move(help), status);
}

}  // namespace

int Simulator::build(const Options& options, Compilation& c) {
  const codegen::Simulation told = codegen::simulation(
      *c.module, *c.spec, c.tables, base_name(options.spec), codegen::find_mutant(options.mutant));
  if (!told.problems.empty()) {
    return refuse(c, diag::Code::cannot_simulate, told.problems.front(),
                  "decisions with a period of a fleet can be simulated, whose monitors speak of "
                  "zones, distances and charge",
                  exit_inconclusive);
  }
  predicted_ = predictions(*c.module);
  std::string problem = folder_.problem();
  std::vector<OutputFile> manifests;
  for (const Agents agents : every_way) {
    manifests.push_back({folder() + file_of(agents), manifest_where(agents, told.manifest)});
    sums_[static_cast<std::size_t>(agents)] = sum_of(manifests.back().text);
  }
  if (problem.empty()) problem = write_all(manifests);
  if (problem.empty()) problem = compile_kernel(options, c, folder());
  if (problem == nothing_mutated) return refuse_mutant(options, c);
  if (problem.empty()) return exit_clean;
  return refuse(c, diag::Code::no_kernel, problem,
                "set CC to a C compiler, TMPDIR to a folder that can be written", exit_usage);
}

Agents Simulator::agents_of(const std::string& trace) const {
  constexpr int head_lines = 3;  // the manifest is named in the third one
  std::ifstream in(trace);
  std::string line;
  for (int k = 0; k < head_lines; ++k) std::getline(in, line);
  for (const Agents agents : every_way) {
    if (line == "manifest " + sums_[static_cast<std::size_t>(agents)]) return agents;
  }
  return Agents::as_declared;
}

int Simulator::run(const std::vector<std::string>& flags, Compilation& c, std::string& said,
                   Agents agents) {
  const std::string out = folder() + "/said", wrong = folder() + "/wrong";
  std::vector<std::string> words{simulator(), "--kernel", folder() + "/kernel.so", "--manifest",
                                 folder() + file_of(agents)};
  words.insert(words.end(), flags.begin(), flags.end());
  const ProgramResult result = run_program(words, out, wrong);
  if (!result.started) {
    return refuse(c, diag::Code::no_kernel,
                  "the simulator `" + words.front() + "` cannot be started: " + result.problem,
                  "install `rtac-sim` beside `rtac`, or name it in $RTAC_SIM", exit_usage);
  }
  said = read_file(out).value_or("");
  if (result.status == exit_clean || result.status == exit_violation) return result.status;
  if (result.status == exit_usage || result.status == exit_inconclusive) {
    return report_refusal(c, read_file(wrong).value_or(""), result.status);
  }
  c.internal_error = "the simulator has failed: " + read_file(wrong).value_or("");
  return exit_internal;
}

int simulate(const Options& options, Compilation& c, std::ostream& out) {
  Simulator simulator;
  if (const int status = simulator.build(options, c); status != exit_clean) return status;
  std::vector<std::string> flags = flags_of(options);
  flags.insert(flags.end(), simulator.predicted().begin(), simulator.predicted().end());
  std::string said;
  const int status = simulator.run(flags, c, said, simulator.agents_of(options.recorded));
  out << said;
  return status;
}

int simulate_shares(const std::string& runs, const Options& options, Compilation& c,
                    std::ostream& out) {
  Simulator simulator;
  if (const int status = simulator.build(options, c); status != exit_clean) return status;
  std::vector<std::string> flags{"--shares", "yes", "--runs", runs};
  flags.insert(flags.end(), simulator.predicted().begin(), simulator.predicted().end());
  std::string said;
  const int status = simulator.run(flags, c, said);
  if (!said.empty()) out << "\nsimulated, " << runs << " runs of 30 s:\n" << said;
  return status;
}

}  // namespace rtac::driver
