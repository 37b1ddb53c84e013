#include "compiler/driver/replay.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "compiler/codegen/generate.h"
#include "compiler/codegen/names.h"
#include "compiler/driver/decision_replay.h"
#include "compiler/driver/driver.h"
#include "compiler/driver/engine.h"
#include "compiler/driver/kernel_engine.h"
#include "compiler/driver/spool.h"
#include "compiler/interp/clock.h"
#include "compiler/interp/trace.h"
#include "compiler/sema/dimension.h"
#include "compiler/sema/suggest.h"

namespace rtac::driver {
namespace {

void report(Compilation& c, diag::Code code, std::string message, std::string help) {
  c.diagnostics.report({code, std::nullopt, std::move(message), "", {}, std::move(help), {}});
}

// ---- the kernel ---------------------------------------------------------------------------------

// The prefix of the generated names does not matter to anybody.
constexpr const char* kernel_name = "replay";
constexpr const char* kernel_source = "replay_kernel.c";

KernelInterface interface_of(const sema::Spec& spec, const ir::Watch& watch) {
  KernelInterface kernel;
  kernel.prefix = kernel_name;
  kernel.source = kernel_source;
  std::vector<std::size_t> first;  // component of each input of the specification
  std::size_t components = 0;
  for (const sema::Input& input : spec.inputs) {
    first.push_back(components);
    components += input.components.size();
  }
  for (const ir::Channel& input : watch.inputs) {
    for (std::size_t k = 0; k < input.components.size(); ++k) {
      kernel.components.push_back(first[input.declared] + k);
    }
    const bool is_number = input.kind == ir::ChannelKind::number;
    const bool is_zone = input.kind == ir::ChannelKind::zone;
    kernel.inputs.push_back({input.components.size(), is_zone, input.places_most});
    if (is_zone) kernel.zones.push_back(kernel.steps.size());
    for (std::uint32_t k = 0; k < input.components.size(); ++k) {
      kernel.steps.push_back(is_number ? input.grid(k).unit.step : Rational(1));
    }
  }
  for (const ir::Param& param : watch.params) {
    kernel.params.push_back(
        {param.unit.step, param.value, param.range.lo, param.range.hi, param.tightens});
  }
  for (const ir::Unit& unit : watch.units) {
    Rational factor = unit.scale / 1000000;
    for (int i = 0; i < unit.dimension.ratio; ++i) factor *= 100;  // shown in per cent
    for (int i = 0; i > unit.dimension.ratio; --i) factor /= 100;
    kernel.units.push_back({sema::unit_of(unit.dimension), factor});
  }
  kernel.monitors = watch.monitors.size();
  return kernel;
}

int refuse_kernel(Compilation& c, const std::string& problem, bool is_ours) {
  if (is_ours) {
    c.internal_error = problem;
    return exit_internal;
  }
  report(
      c, diag::Code::no_kernel, problem,
      "set CC to a C compiler that makes shared objects, TMPDIR to a folder that can be written, "
      "make room for what the monitors remember, or use `--engine interp`");
  return exit_usage;
}

// ---- the trace ----------------------------------------------------------------------------------

// The newest samples. The components of an input arrive together: one that a row leaves out while
// it has another has no value in this sample.
class Observations {
 public:
  explicit Observations(const sema::Spec& spec) {
    for (const sema::Input& input : spec.inputs) {
      sizes_.push_back(input.components.size());
      is_path_.push_back(input.type == sema::InputType::path);
    }
    for (const std::size_t size : sizes_) components_.resize(components_.size() + size);
  }
  void take(const interp::TraceRow& row) {
    std::size_t begin = 0;
    for (std::size_t input = 0; input < sizes_.size(); ++input) {
      const std::size_t size = sizes_[input];
      bool arrived = false;
      for (std::size_t i = begin; i < begin + size; ++i) {
        arrived = arrived || row.readings[i].kind != interp::Reading::Kind::none;
      }
      const interp::Reading path = components_[begin].reading;
      for (std::size_t i = begin; arrived && i < begin + size; ++i) {
        components_[i] = {row.readings[i], row.time_us, true};
      }
      if (arrived && is_path_[input]) lead_on(begin, path);
      begin += size;
    }
  }
  void judged() {
    for (Observed& component : components_) component.is_new = false;
  }
  [[nodiscard]] const std::vector<Observed>& get() const { return components_; }

 private:
  // A new path starts at its first way-point, unless its index says otherwise; an index alone goes
  // on along the path that is there.
  void lead_on(std::size_t begin, const interp::Reading& before) {
    interp::Reading& path = components_[begin].reading;
    interp::Reading& index = components_[begin + 1].reading;
    if (path.kind == interp::Reading::Kind::none) path = before;
    if (index.kind != interp::Reading::Kind::none) return;
    index.kind = interp::Reading::Kind::number;
    index.number = interp::Decimal(0);
  }

  std::vector<std::size_t> sizes_;
  std::vector<bool> is_path_;
  std::vector<Observed> components_;
};

// What is asked for, and what answers it. Without an engine there is nothing of that sort to judge.
struct Judges {
  std::unique_ptr<Engine> watches;
  std::unique_ptr<DecisionReplay> decisions;
  std::string only;  // name of a monitor; empty: all
};

class Replay {
 public:
  Replay(const sema::Spec& spec, Judges& judges) : spec_(spec), judges_(judges) {
    if (const auto shortest = shortest_period(spec, judges)) base_.emplace(*shortest);
    if (judges_.watches) watch_clock_.emplace(spec.period->value);
  }

  // The trace has to be read to its end before anything is said.
  std::optional<interp::TraceError> run(std::istream& in) {
    interp::TraceReader reader(in, spec_);
    if (!reader.read_header()) return reader.error();
    if (judges_.decisions) judges_.decisions->choose(reader.robots());
    print_header();
    Observations observations(spec_);
    interp::TraceRow row;
    while (reader.read_row(row)) {
      observations.take(row);
      if (judges_.decisions) judges_.decisions->take(row);
      // A further row of a tick counts at the next one.
      const bool judged = step_watches(row.time_us, observations);
      const bool decided = judges_.decisions && judges_.decisions->step(row.time_us);
      const interp::Tick tick = base_ ? base_->at(row.time_us) : printed_;
      if (judged || decided) print(tick, row.time);
    }
    if (reader.error() || printed_ > 0) return reader.error();
    // Only decisions on plans wait for something: findings of nothing would look like good ones.
    return reader.error_of_all("no row of the trace has a plan to judge",
                               "each proposal stands in a row of its own: `1 2; 3.5 2`, or `none`");
  }
  [[nodiscard]] bool violated() const {
    return violated_ || (judges_.decisions && judges_.decisions->violated());
  }
  Spool& findings() { return findings_; }

 private:
  // None: plans alone are judged, whenever they come.
  static std::optional<Rational> shortest_period(const sema::Spec& spec, const Judges& judges) {
    std::optional<Rational> shortest;
    if (judges.decisions) shortest = judges.decisions->shortest_period_s();
    if (!judges.watches) return shortest;
    return shortest ? std::min(*shortest, spec.period->value) : spec.period->value;
  }
  [[nodiscard]] bool is_shown(std::size_t monitor) const {
    return judges_.only.empty() || judges_.only == spec_.watches[monitor].name;
  }
  // False: it is not time for the next tick.
  bool step_watches(std::int64_t time_us, Observations& observations) {
    if (!judges_.watches) return false;
    const interp::Tick tick = watch_clock_->at(time_us);
    if (tick == before_) return false;
    before_ = tick;
    judges_.watches->step(time_us, observations.get(), judgements_);
    observations.judged();
    return true;
  }
  void print_header() {
    line_ = "tick,time";
    for (std::size_t k = 0; judges_.watches && k < spec_.watches.size(); ++k) {
      if (!is_shown(k)) continue;
      for (const char* field : {".verdict", ".margin", ".unit"}) {
        line_.append(",").append(spec_.watches[k].name).append(field);
      }
    }
    if (judges_.decisions) judges_.decisions->print_header(line_);
    findings_ << line_.append("\n");
  }
  void print(interp::Tick tick, const std::string& time) {
    line_ = std::to_string(tick);
    line_.append(",").append(time);
    for (std::size_t k = 0; k < judgements_.size(); ++k) {
      if (!is_shown(k)) continue;
      const Judgement& judgement = judgements_[k];
      line_.append(",").append(word(judgement.verdict));
      line_.append(",").append(judgement.margin);
      line_.append(",").append(judgement.unit);
      violated_ = violated_ || judgement.verdict == interp::Verdict::no;
    }
    if (judges_.decisions) judges_.decisions->print(line_);
    findings_ << line_.append("\n");
    ++printed_;
  }

  const sema::Spec& spec_;
  Judges& judges_;
  std::optional<interp::Clock> base_;  // of the column `tick`: the shortest period
  interp::Tick printed_ = 0;           // rows
  std::optional<interp::Clock> watch_clock_;
  interp::Tick before_ = -1;
  std::vector<Judgement> judgements_;
  Spool findings_;
  std::string line_;
  bool violated_ = false;
};

enum class Sort { none, watch, decision };

// What the monitor is that the user asked for; none and an error: there is no such one.
Sort sort_of(const Options& options, Compilation& c) {
  std::vector<std::string> names;
  for (const sema::Watch& watch : c.spec->watches) names.push_back(watch.name);
  const std::size_t plain = names.size();
  for (const sema::Decision& d : c.spec->decisions) {
    for (const sema::MonitorId id : d.priority) names.push_back((*c.spec)[id].name);
  }
  const auto found = std::find(names.begin(), names.end(), options.monitor);
  if (found != names.end()) {
    return found - names.begin() < std::ptrdiff_t(plain) ? Sort::watch : Sort::decision;
  }
  report(c, diag::Code::usage,
         "no monitor that can be replayed is called `" + options.monitor + "`",
         sema::did_you_mean(options.monitor, names, "monitors"));
  return Sort::none;
}

bool open(const std::string& path, std::ifstream& file, Compilation& c) {
  std::error_code ignored;
  std::string why = "it is a directory";
  if (!std::filesystem::is_directory(path, ignored)) {
    file.open(path, std::ios::binary);
    if (file) return true;
    why = std::strerror(errno);
  }
  report(c, diag::Code::cannot_read, "cannot read `" + path + "`: " + why,
         "give the path of a .csv file, or - for standard input");
  return false;
}

// Of the trace the row at fault alone is kept: it may be longer than memory.
void report_row(const Options& options, Compilation& c, const interp::TraceError& error) {
  const FileId row =
      c.sources.add_part(options.trace == "-" ? "<stdin>" : options.trace, error.row.text,
                         static_cast<std::uint32_t>(error.row.line), error.row.offset);
  const SourceRange range{row, static_cast<std::uint32_t>(error.begin),
                          static_cast<std::uint32_t>(error.end)};
  c.diagnostics.report({diag::Code::bad_trace, range, error.message, "", {}, error.help, {}});
}

int run(const Options& options, Compilation& c, Judges& judges, std::ostream& out) {
  std::ifstream file;
  if (options.trace != "-" && !open(options.trace, file, c)) return exit_usage;
  Replay replay(*c.spec, judges);
  const auto error = replay.run(options.trace == "-" ? std::cin : file);
  if (error) {
    report_row(options, c, *error);
    return exit_usage;
  }
  if (const std::string problem = replay.findings().release(out); !problem.empty()) {
    report(c, diag::Code::cannot_write, problem, "make room, or give a place that can be written");
    return exit_usage;
  }
  return replay.violated() ? exit_violation : exit_clean;
}

}  // namespace

KernelCode kernel_code(Compilation& c) {
  KernelCode code;
  if (c.module->watch) code.interface = interface_of(*c.spec, *c.module->watch);
  codegen::Naming naming;
  naming.stem = naming.space = kernel_name;
  naming.source = c.spec->name;
  for (auto& file : codegen::generate(std::move(*c.module), *c.spec, naming)) {
    code.files.push_back({file.name, std::move(file.text)});
  }
  c.module.reset();
  return code;
}

namespace {

// The generated kernel for what is wanted; the result is exit_clean, or why there is none.
int make_kernels(const Options& options, Compilation& c, bool watches, bool decisions,
                 Judges& judges) {
  std::vector<DecisionInterface> interfaces;
  if (decisions) interfaces = decision_interfaces(*c.module, *c.spec, kernel_name);
  const KernelCode code = kernel_code(c);
  if (watches) {
    LoadedKernel loaded = load_kernel(code.files, code.interface);
    if (!loaded.engine) return refuse_kernel(c, loaded.problem, loaded.is_ours);
    judges.watches = std::move(loaded.engine);
  }
  if (interfaces.empty()) return exit_clean;
  LoadedDecisions loaded =
      load_decisions(code.files, kernel_source, interfaces, c.spec->robots.size());
  if (!loaded.engine) return refuse_kernel(c, loaded.problem, false);
  judges.decisions = std::make_unique<DecisionReplay>(*c.spec, std::move(interfaces),
                                                      std::move(loaded.engine), options.monitor);
  return exit_clean;
}

// A decision that robots of a fleet take.
bool has_decisions(const sema::Spec& spec) {
  return std::any_of(spec.decisions.begin(), spec.decisions.end(), [&](const sema::Decision& d) {
    return std::any_of(spec.robots.begin(), spec.robots.end(),
                       [&](const sema::Robot& r) { return r.kind == d.kind; });
  });
}

}  // namespace

int replay(const Options& options, Compilation& c, std::ostream& out) {
  bool watches = !c.spec->watches.empty();
  bool decisions = has_decisions(*c.spec);
  if (!watches && !decisions) {
    report(c, diag::Code::usage, "`" + c.spec->name + "` has no monitor that can be replayed",
           "monitors without a robot can, and decisions that robots of a fleet take");
    return exit_usage;
  }
  if (!options.monitor.empty()) {
    const Sort sort = sort_of(options, c);
    if (sort == Sort::none) return exit_usage;
    watches = sort == Sort::watch;
    decisions = sort == Sort::decision;
  }
  Judges judges;
  judges.only = options.monitor;
  if (options.engine == EngineKind::kernel) {
    const int status = make_kernels(options, c, watches, decisions, judges);
    if (status != exit_clean) return status;
  } else {
    if (watches) judges.watches = make_interpreter(*c.spec);
    if (decisions) {
      judges.decisions = std::make_unique<DecisionReplay>(
          *c.spec, judged_decisions(*c.spec), make_decision_interpreter(*c.spec), options.monitor);
    }
  }
  return run(options, c, judges, out);
}

}  // namespace rtac::driver
