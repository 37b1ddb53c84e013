#include "program.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <future>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>

#include "conservatism.h"
#include "rtac/sim/picture.h"
#include "summary.h"
#include "tighten.h"
#include "trace.h"

namespace rtac::simulate {
namespace {

using sim::Tape;

constexpr std::uint64_t jobs_max = 1024;

// What went wrong; empty: nothing. A folder can be opened, and not be read.
std::string read_file(const std::string& path, std::string& text) {
  constexpr std::size_t block_bytes = std::size_t{1} << 16, bytes_max = std::size_t{1} << 30;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             std::fclose);
  if (file == nullptr) return std::strerror(errno);
  std::vector<char> block(block_bytes);
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
    text.append(block.data(), count);
    if (text.size() > bytes_max) return "it is larger than 1 GiB";
  }
  return std::ferror(file.get()) != 0 ? std::strerror(errno) : "";
}

// Without the carriage returns that a mailer or an editor has put before the ends of lines.
std::string lines_of_unix(const std::string& text) {
  std::string lines;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '\r' || k + 1 == text.size() || text[k + 1] != '\n') lines += text[k];
  }
  return lines;
}

Problem unwritten(const std::string& path) {
  return {"cannot write the run to `" + path + "`: " + std::strerror(errno),
          "`--trace FILE` names another place", false, cannot_write};
}

// Whether there can be such a file, before anything is played, and without one where nothing is
// found.
Problem has_room(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty() && !std::filesystem::is_directory(folder, error)) {
    errno = std::filesystem::exists(folder, error) ? ENOTDIR : ENOENT;
    return unwritten(path);
  }
  errno = EISDIR;
  if (std::filesystem::is_directory(path, error)) return unwritten(path);
  const bool replaces = std::filesystem::exists(path, error);
  const std::string asked = replaces ? path : folder.empty() ? "." : folder.string();
  if (::access(asked.c_str(), W_OK) != 0) return unwritten(path);
  return {};
}

class Program {
 public:
  explicit Program(std::ostream& out) : out_(out) {}

  Problem prepare(const std::vector<std::string>& arguments) {
    for (std::size_t k = 0; k + 1 < arguments.size(); k += 2)
      flags_[arguments[k]] = arguments[k + 1];
    std::string manifest;
    if (std::string why = read_file(flags_["--manifest"], manifest); !why.empty()) {
      return {"cannot read the manifest `" + flags_["--manifest"] + "`: " + why, "", false,
              cannot_read};
    }
    if (Problem problem = read_manifest(manifest, case_)) return problem;
    if (Problem problem = kernel_.load(flags_["--kernel"])) return problem;
    functions_.resize(case_.decisions.size());
    for (std::size_t d = 0; d < case_.decisions.size(); ++d) {
      if (Problem problem = kernel_.find(case_.decisions[d], functions_[d])) return problem;
    }
    return scenario();
  }

  Problem simulate(int& status) {
    if (flags_.count("--measure") != 0) return measure();
    return flags_.count("--replay") != 0 ? replay(status) : all_runs(status);
  }

 private:
  Problem scenario() {
    if (flags_.count("--scenario") != 0) {
      std::string text;
      if (std::string why = read_file(flags_["--scenario"], text); !why.empty()) {
        return {"cannot read the scenario `" + flags_["--scenario"] + "`: " + why,
                "give a JSON file", false, cannot_read};
      }
      if (Problem problem = read_scenario(text, scenario_)) {
        problem.message = "`" + flags_["--scenario"] + "`: " + problem.message;
        return problem;
      }
    }
    if (flags_.count("--trace") != 0) {
      if (Problem problem = has_room(flags_["--trace"])) return problem;
    }
    if (flags_.count("--seed") != 0) scenario_.seed = whole("--seed");
    if (flags_.count("--runs") != 0) scenario_.runs = whole("--runs");
    if (flags_.count("--core-s") != 0) until_s_ = core_seconds() + double(whole("--core-s"));
    if (flags_.count("--jobs") != 0) jobs_ = whole("--jobs");
    if (jobs_ == 0 || jobs_ > jobs_max) {
      return {"`--jobs " + flags_["--jobs"] + "`: from 1 to " + std::to_string(jobs_max) +
                  " runs can be played at once",
              "the number of processors works"};
    }
    if (scenario_.runs == 0) return {"`--runs 0` simulates nothing", "`--runs 1` works"};
    if (flags_.count("--adversary") != 0) scenario_.adversary = flags_["--adversary"];
    for (std::size_t d = 0; d < case_.decisions.size(); ++d) {
      if (Problem problem = check_jitter(case_.decisions[d], functions_[d])) return problem;
    }
    if (Problem problem = check_inputs(scenario_, case_)) return problem;
    return check_names(scenario_, case_);
  }
  // What comes later than is declared is no attack: no look-ahead covers it.
  Problem check_jitter(const DecisionCase& decision, const Kernel::Functions& functions) {
    if (scenario_.jitter_us <= functions.jitter_us) return {};
    std::ostringstream most_ms;
    most_ms << static_cast<double>(functions.jitter_us) / 1e3;
    return {
        "`jitter_ms` of the scenario is more than decision `" + decision.name + "` allows for",
        "a number up to " + most_ms.str() + " works, or declare a longer `jitter` of the decision"};
  }
  std::uint64_t whole(const char* flag) {
    constexpr int decimal = 10;
    return std::strtoull(flags_[flag].c_str(), nullptr, decimal);
  }

  // A line of JSON for each decision.
  Problem measure() {
    constexpr double core_s = 20;
    for (std::size_t d = 0; d < case_.decisions.size(); ++d) {
      Told told;
      if (Problem p = draw_inputs(case_.decisions[d], scenario_, scenario_.seed, 0, told)) return p;
      DecisionCase decision = with_inputs(case_.decisions[d], told);
      decision.surroundings.open = open_at(decision.calendar, early_us + decision.memory_us);
      const double share_s = core_s / static_cast<double>(case_.decisions.size());
      out_ << tightness_json(decision, measure_tightness(decision, functions_[d], share_s));
    }
    return {};
  }
  Problem all_runs(int& status) {
    status = exit_clean;
    for (std::size_t d = 0; d < case_.decisions.size(); ++d) {
      if (!concerned(case_.decisions[d])) continue;
      if (Problem problem = runs_of(d, status)) return problem;
    }
    return {};
  }
  // It has the monitor that the scenario is about, if that is about one.
  [[nodiscard]] bool concerned(const DecisionCase& decision) const {
    return scenario_.about.empty() ||
           std::any_of(decision.monitors.begin(), decision.monitors.end(),
                       [&](const MonitorCase& m) { return m.name == scenario_.about; });
  }
  // `decision`: with the inputs that were drawn.
  Problem prepared(std::size_t index, std::uint64_t seed, Setup& setup, DecisionCase& decision) {
    constexpr std::uint64_t draws = 8;  // of inputs for which there are places
    const DecisionCase& open = case_.decisions[index];
    Problem problem;
    for (std::uint64_t n = 0; n < (open.inputs.empty() ? 1 : draws); ++n) {
      problem = draw_inputs(open, scenario_, seed, n, setup.told);
      if (problem) return problem;
      decision = with_inputs(open, setup.told);
      problem = make_setup(decision, scenario_, seed, setup);
      if (problem) continue;
      charge(decision, functions_[index], scenario_, setup);
      tighten(decision, functions_[index], scenario_, setup);
      return {};
    }
    return problem;
  }
  // What one seed came to.
  struct Attempt {
    Setup setup;
    Outcome outcome;
    Problem problem;
  };
  void attempt(std::size_t index, std::uint64_t seed, Attempt& to) {
    Tape none;
    DecisionCase decision;
    to.problem = prepared(index, seed, to.setup, decision);
    if (to.problem) return;
    to.problem = run(decision, functions_[index], to.setup, none, to.outcome, until_s_);
    if (!as_asked(to.setup.asked, to.outcome.drove)) to.outcome.violation = {};
  }
  // Runs know nothing of each other: as many at once as there are jobs. What one of them throws is
  // thrown here, when all have ended.
  std::vector<Attempt> attempts(std::size_t index, std::uint64_t first, std::uint64_t count) {
    std::vector<Attempt> all(count);
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t k = next++; k < all.size(); k = next++) attempt(index, first + k, all[k]);
    };
    std::vector<std::future<void>> others;
    for (std::uint64_t job = 1; job < std::min(jobs_, count); ++job) {
      others.push_back(std::async(std::launch::async, work));
    }
    work();
    for (std::future<void>& other : others) other.get();
    return all;
  }
  // Added in the order of the seeds, so that what is told is the same whatever the number of jobs.
  Problem runs_of(std::size_t index, int& status) {
    constexpr std::uint64_t batch = 8;  // runs of a job, so that none waits long for the others
    const std::uint64_t at_once = jobs_ == 1 ? 1 : jobs_ * batch;
    const DecisionCase& decision = case_.decisions[index];
    Summary summary(decision, predicted(decision));
    const double begin_s = core_seconds();
    Setup first;
    const Setup* found = nullptr;
    std::uint64_t done = 0;
    bool enough = false;
    while (!enough && done < scenario_.runs && core_seconds() <= until_s_) {
      const std::uint64_t count = std::min(at_once, scenario_.runs - done);
      for (const Attempt& a : attempts(index, scenario_.seed + done, count)) {
        if (a.problem) return a.problem;
        enough = a.outcome.cut;
        if (enough) break;
        summary.add(a.setup, a.outcome);
        ++done;
        if (found != nullptr || !counts(a.setup, a.outcome)) continue;
        first = a.setup;
        found = &first;
        enough = flags_.count("--until") != 0;
        if (enough) break;
      }
    }
    if (flags_.count("--shares") != 0) return tell_share(decision, summary, status);
    out_ << summary.text(core_seconds() - begin_s);
    if (found == nullptr && done < scenario_.runs) {
      out_ << "the time was up after " << done << " of " << scenario_.runs << " runs\n";
    }
    if (found == nullptr) return {};
    status = exit_violation;
    return record(index, first);
  }

  // Whoever asks for one finding gets that one; a property that is violated is one for all others.
  [[nodiscard]] bool counts(const Setup& setup, const Outcome& outcome) const {
    const bool violated = flags_.count("--until") == 0 && outcome.violation.time_us != never_us;
    return violated || shown(setup, outcome);
  }

  Problem tell_share(const DecisionCase& decision, const Summary& summary, int& status) {
    out_ << "decision " << decision.name << ", " << summary.advanced();
    if (summary.violations() > 0) {
      out_ << "; a property was violated in " << summary.violations() << " of " << scenario_.runs
           << " runs, `rtac sim` records one";
      status = exit_violation;
    }
    out_ << "\n";
    return {};
  }
  // Of `NAME=PERCENT,...`, the number of this decision.
  std::optional<int> predicted(const DecisionCase& decision) {
    const std::string all = "," + flags_["--predicted"] + ",", key = "," + decision.name + "=";
    const std::size_t at = all.find(key);
    if (at == std::string::npos) return std::nullopt;
    return std::atoi(all.c_str() + at + key.size());
  }

  // The same run once more, with a tape.
  Problem record(std::size_t index, const Setup& setup) {
    const DecisionCase decision = with_inputs(case_.decisions[index], setup.told);
    Tape tape = Tape::recorder();
    Outcome outcome;
    if (Problem p = run(decision, functions_[index], setup, tape, outcome)) return p;
    tell(decision, setup, outcome);
    const std::string path =
        flags_.count("--trace") != 0 ? flags_["--trace"] : case_.specification + ".trace";
    if (!sim::write_text_file(path, trace_text(case_, decision, setup, outcome, tape.written()))) {
      return unwritten(path);
    }
    out_ << "the run is in " << path << "; `rtac sim SPEC --replay " << path
         << "` plays it again\n";
    return {};
  }
  void tell(const DecisionCase& decision, const Setup& setup, const Outcome& outcome) {
    constexpr double us_per_s = 1e6;
    tell(decision, setup, outcome.kept);
    const sim::Violation& v = outcome.violation;
    if (v.time_us == never_us) return;
    const auto monitor = static_cast<std::size_t>(v.monitor);
    const MonitorCase& m = decision.monitors[monitor];
    out_ << "\nviolated: " << m.name << " (" << m.text << ") by "
         << decision.robots[static_cast<std::size_t>(v.robot)] << " at "
         << static_cast<double>(v.time_us) / us_per_s << " s, "
         << (decision.calendar.empty() ? "" : utc_text(setup.begins_us + v.time_us) + ", ")
         << "down to " << margin_text(m, outcome.least[monitor].value)
         << (v.time_us == 0 ? ", where the scenario lets it start" : "") << "\n  --seed "
         << setup.seed << " --runs 1 --adversary " << setup.adversary->name << "\n";
    tell_inputs(decision, setup);
  }

  void tell_inputs(const DecisionCase& decision, const Setup& setup) {
    if (!decision.inputs.empty()) out_ << "  with " << text_of(decision, setup.told) << "\n";
  }
  void tell(const DecisionCase& decision, const Setup& setup, const Kept& kept) {
    constexpr double us_per_s = 1e6;
    if (kept.robot < 0) return;
    const MonitorCase& m = decision.monitors[static_cast<std::size_t>(
        setup.about >= 0 ? setup.about : std::max(0, kept.mode - 1))];
    if (setup.undecided) {
      out_ << "\nundecided: " << decision.robots[static_cast<std::size_t>(kept.robot)]
           << " was driven from " << static_cast<double>(kept.from_us) / us_per_s << " s to "
           << static_cast<double>(kept.until_us) / us_per_s << " s by a command that " << m.name
           << " had not looked so far ahead for\n";
      tell_inputs(decision, setup);
      return;
    }
    out_ << "\nnot given back: " << decision.robots[static_cast<std::size_t>(kept.robot)] << " by "
         << m.name << ", from " << static_cast<double>(kept.from_us) / us_per_s << " s to "
         << static_cast<double>(kept.until_us) / us_per_s << " s, while " << m.recovery.name
         << " drove\n";
    tell_inputs(decision, setup);
  }

  Problem replay(int& status) {
    std::string text;
    if (std::string why = read_file(flags_["--replay"], text); !why.empty()) {
      return {"cannot read the recorded run `" + flags_["--replay"] + "`: " + why,
              "`rtac sim` writes one when a property is violated", false, cannot_read};
    }
    text = lines_of_unix(text);
    Trace trace;
    if (Problem problem = read_trace(text, case_, trace)) return problem;
    std::size_t index = 0;
    while (case_.decisions[index].name != trace.decision) ++index;
    const DecisionCase decision = with_inputs(case_.decisions[index], trace.setup.told);
    Tape tape = Tape::player(trace.tape);
    Outcome outcome;
    if (Problem p = run(decision, functions_[index], trace.setup, tape, outcome)) return p;
    const std::string again = trace_text(case_, decision, trace.setup, outcome, tape.written());
    if (flags_.count("--trace") != 0 && !sim::write_text_file(flags_["--trace"], again)) {
      return unwritten(flags_["--trace"]);
    }
    if (again != text) return differs(text, again);  // what else it shows means nothing
    tell(decision, trace.setup, outcome);
    status = counts(trace.setup, outcome) ? exit_violation : exit_clean;
    out_ << "the run was played again, the same to the last bit\n";
    return {};
  }
  static Problem differs(const std::string& recorded, const std::string& again) {
    std::size_t line = 1, k = 0;
    for (; k < recorded.size() && k < again.size() && recorded[k] == again[k]; ++k) {
      if (recorded[k] == '\n') ++line;
    }
    // The last line speaks of all the others.
    if (again.compare(0, again.rfind("\nhash ") + 1, recorded, 0, recorded.rfind("\nhash ") + 1) ==
        0) {
      return {"the recorded run was changed, where nothing depends on it: its hash is another one",
              "record it again, with the seed and the adversary that it names", true};
    }
    return {"played again, the run is another one from line " + std::to_string(line) + " on",
            "it was changed, or the kernel is not the one that it was recorded with", true};
  }

  std::ostream& out_;
  std::map<std::string, std::string> flags_;
  Case case_;
  Kernel kernel_;
  std::vector<Kernel::Functions> functions_;
  Scenario scenario_;
  double until_s_ = std::numeric_limits<double>::infinity();
  std::uint64_t jobs_ = 1;
};

}  // namespace

int run_program(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err) {
  Program program(out);
  int status = exit_clean;
  Problem problem = program.prepare(arguments);
  if (!problem) problem = program.simulate(status);
  if (!problem) return status;
  err << problem.message << "\t" << problem.help;
  if (problem.code != 0) err << "\t" << problem.code;
  err << "\n";
  return problem.inconclusive ? exit_inconclusive : exit_usage;
}

}  // namespace rtac::simulate
