#include "compiler/driver/show.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/analysis/told.h"
#include "compiler/driver/aims.h"
#include "compiler/driver/driver.h"
#include "compiler/driver/files.h"
#include "compiler/driver/in_turns.h"
#include "compiler/driver/lock_up.h"
#include "compiler/driver/process.h"
#include "compiler/driver/standing.h"
#include "compiler/sema/visit.h"

namespace rtac::driver {
namespace {

using verify::Kind;
using verify::Obligation;

// In core seconds, of all obligations together: as long as a person waits for runs, unless
// `--attack` says otherwise; large fleets are slow, and partial results are results. What shows
// anything mostly does so within the first second: every attempt gets that before one gets more.
constexpr double all_core_s = 12, first_core_s = 1, then_core_s = 4;
// What nothing but a run refutes gets so much beside something that is shown: whatever comes of it,
// the specification is refuted.
constexpr double besides_core_s = 6;
// The simulator counts whole seconds.
constexpr double least_core_s = 0.5;

// `yard` of `specs/yard.rta`.
std::string stem_of(const std::string& path) {
  const std::string name = path.substr(path.find_last_of('/') + 1);
  const std::size_t dot = name.find_last_of('.');
  return path == "-" ? "specification" : name.substr(0, dot == 0 ? std::string::npos : dot);
}

// A run has shown it, whether or not that could be kept.
bool has_shown(const Obligation& o) {
  return !o.trace.empty() || !o.not_recorded.empty();
}
// A run can show it.
bool in_motion(const Obligation& o) {
  return o.status == verify::Status::refuted && (about_return(o) || !o.monitor.empty()) &&
         o.not_shown.empty();
}

// Whether agents walk up to who stands is what a run is about, or nobody's fault.
Agents agents_for(const Obligation& o) {
  if (o.unending) return Agents::stand;
  const bool walked_up = o.method == verify::by_diagnostic(diag::Code::agent_unkept);
  return walked_up ? Agents::walk_up : Agents::as_declared;
}

// One obligation, and the scenarios that are not played to their end.
struct Sought {
  Obligation* of;
  std::vector<Scenario> scenarios;
  bool tried = false, cut = false;
  std::string run{};      // the file of the one that shows it
  std::string refused{};  // why the simulator has not played one
  // The surest first: an argument refutes it; a run does, which is likely; or perhaps.
  [[nodiscard]] int rank() const {
    if (of->in_turns || (of->declared && !of->by_a_run)) return 2;
    return of->by_a_run ? 1 : 0;
  }
};

// How many runs the simulator has played before its time was up, of several decisions the fewest;
// none: it has played all.
std::optional<std::uint64_t> played(const std::string& table) {
  constexpr std::string_view before = "the time was up after ";
  constexpr int decimal = 10;
  std::optional<std::uint64_t> least;
  std::size_t at = 0;
  while ((at = table.find(before, at)) != std::string::npos) {
    at += before.size();
    const std::uint64_t runs = std::strtoull(table.c_str() + at, nullptr, decimal);
    least = std::min(least.value_or(runs), runs);
  }
  return least;
}
// From the seed on where the time was up.
void go_on(Scenario& scenario, std::uint64_t played) {
  scenario["seed"] = scenario.value("seed", std::uint64_t{1}) + played;
  scenario["runs"] = scenario["runs"].get<std::uint64_t>() - played;
}

class Showing {
 public:
  Showing(const Options& options, Simulator& simulator, Compilation& c)
      : options_(options), simulator_(simulator), c_(c), left_s_(attack_core_s(options)) {}

  void add(const verify::Decision& d, Obligation& o) {
    std::vector<std::string> robots;
    for (const sema::Robot& r : c_.spec->robots) {
      if ((*c_.spec)[r.kind].name == d.kind) robots.push_back(r.name);
    }
    if (robots.empty()) return;
    Sought sought{&o, aimed_at(o, *c_.spec, robots, charge_of(d, o.in_turns.has_value()))};
    for (Scenario& scenario : sought.scenarios) blame(d, o, scenario);
    all_.push_back(std::move(sought));
  }

  void run() {
    std::vector<Sought*> order;
    for (Sought& each : all_) order.push_back(&each);
    std::ranges::stable_sort(order, {}, &Sought::rank);
    for (const double most_s : {first_core_s, then_core_s, left_s_}) {
      for (Sought* each : order) attack(*each, most_s);
    }
    for (Sought& each : all_) {
      each.of->played = each.tried && each.refused.empty();
      if (!each.run.empty()) {
        keep(each.run, *each.of);
      } else if (each.rank() < 2) {  // else nothing is claimed: no robot may have the model's run
        each.of->not_shown = !each.refused.empty() ? each.refused
                             : !each.tried         ? "the time was up"
                             : each.cut ? "no run under attack has shown it until the time was up"
                                        : "no run under attack has shown it";
      }
    }
  }

 private:
  // Each of its scenarios, for so long at most.
  void attack(Sought& sought, double most_s) {
    std::vector<Scenario> open;
    for (Scenario& scenario : sought.scenarios) {
      if (!sought.run.empty()) return;
      const double may_s = std::min(most_s, left_for(sought));
      if (may_s < least_core_s) {
        open.push_back(std::move(scenario));
        continue;
      }
      sought.tried = true;
      if (const auto done = play(sought, scenario, may_s)) {
        go_on(scenario, *done);
        open.push_back(std::move(scenario));
      }
    }
    sought.cut = !open.empty();
    sought.scenarios = std::move(open);
  }
  [[nodiscard]] double left_for(const Sought& sought) const {
    return shown_ > 0 && sought.rank() > 0 ? std::min(left_s_, besides_s_) : left_s_;
  }
  // How many of its runs are played, where that are not all of them and none has shown it.
  std::optional<std::uint64_t> play(Sought& sought, const Scenario& scenario, double most_s) {
    const std::string file = simulator_.folder() + "/aimed.json";
    const std::string trace = simulator_.folder() + "/shown-" + std::to_string(shown_);
    if (!write_all({{file, scenario.dump()}}).empty()) return std::nullopt;
    const double begin_s = core_seconds_of_children();
    std::string table;
    const int status = simulator_.run({"--scenario", file, "--trace", trace, "--until", "shown",
                                       "--core-s", std::to_string(std::lround(most_s))},
                                      c_, table, agents_for(*sought.of));
    const double took_s = core_seconds_of_children() - begin_s;
    left_s_ -= took_s;
    if (shown_ > 0 && sought.rank() > 0) besides_s_ -= took_s;
    if (status != exit_violation && status != exit_clean) sought.refused = why_not_played();
    if (status != exit_violation) return played(table);
    if (!shows(trace, scenario, *sought.of)) return played_up_to(trace, scenario);
    sought.run = trace;
    ++shown_;
    return std::nullopt;
  }
  [[nodiscard]] std::string why_not_played() const {
    if (!c_.internal_error.empty()) return c_.internal_error;
    return c_.diagnostics.all().empty() ? "" : c_.diagnostics.all().back().message;
  }
  // Of robots that wait for each other, only what nobody else has a part in; of recoveries that
  // take over from each other, only what they have done so often that it goes on; and of one that
  // is measured exactly, which is not waited for as long as ways take, that it stands.
  static bool shows(const std::string& trace, const Scenario& scenario, Obligation& o) {
    constexpr int often = 10;
    const bool of_turns = o.in_turns && scenario.contains("return_within_s");
    const bool is_to_stand = about_return(o) && !o.lock_up && scenario.contains("noise");
    if (!o.lock_up && !of_turns && !is_to_stand) return true;
    const auto run = read_file(trace);
    if (is_to_stand) return run && stands(*run, scenario["starts"].begin().key());
    if (!of_turns) return run && locks_up(*run, scenario["starts"].size(), *o.lock_up);
    const int taken = run ? turns_taken(*run, o.in_turns->modes) : 0;
    if (taken < often) return false;
    o.in_turns->seen = taken;
    return true;
  }
  // How many runs of a scenario are played with a recorded one; none: all are, or nobody can tell.
  static std::optional<std::uint64_t> played_up_to(const std::string& trace,
                                                   const Scenario& scenario) {
    constexpr std::string_view before = "\nseed ";
    constexpr int decimal = 10;
    const auto run = read_file(trace);
    const std::size_t at = run ? run->find(before) : std::string::npos;
    if (at == std::string::npos) return std::nullopt;
    const std::uint64_t seed = std::strtoull(run->c_str() + at + before.size(), nullptr, decimal);
    const std::uint64_t runs = seed + 1 - scenario.value("seed", std::uint64_t{1});
    return runs < scenario["runs"].get<std::uint64_t>() ? std::optional(runs) : std::nullopt;
  }
  // That a recovery may break it: a run in which it fails says nothing of others.
  static bool accepted(const sema::Decision& d, sema::MonitorId id) {
    return std::ranges::any_of(d.acknowledgements, [&](const auto& a) { return a.monitor == id; });
  }
  // A zone comes or goes while nobody leads out, whoever drives.
  static bool passes(const Obligation& o) {
    return o.method == verify::by_diagnostic(diag::Code::window_may_pass) ||
           o.method == verify::by_diagnostic(diag::Code::window_without_way_out);
  }
  // Inputs alone have its recovery drive, and have no part in when control is given back: as they
  // stay what they are in a run, that would be no matter of where it leads.
  [[nodiscard]] bool is_asked_for(const std::string& monitor) const {
    const auto m = std::ranges::find(c_.spec->monitors, monitor, &sema::Monitor::name);
    return m != c_.spec->monitors.end() && m->return_when && !sema::speaks_of_robot(*m->always) &&
           analysis::inputs_in(*c_.spec, *m->return_when).empty();
  }
  // What counts is that its own recovery drives into the violation, and none of those of which it
  // is accepted that they may break the property.
  void blame(const verify::Decision& d, const Obligation& o, Scenario& scenario) const {
    if (!o.unmet.empty()) scenario["unmet"] = o.unmet;
    if (o.kind == Kind::p2b && is_asked_for(o.monitor)) scenario["unmet"] = o.monitor;
    if (o.in_turns || o.monitor.empty() || about_return(o)) return;
    const sema::Monitor* own = nullptr;
    for (const sema::Decision& written : c_.spec->decisions) {
      if (written.name != d.name) continue;
      for (const sema::Acknowledgement& a : written.acknowledgements) {
        const std::string& recovery = (*c_.spec)[a.recovery].name;
        if ((*c_.spec)[a.monitor].name != o.monitor || recovery == o.recovery) continue;
        scenario["not_driven_by"].push_back(recovery);
      }
      for (const sema::MonitorId id : written.priority) {
        if ((*c_.spec)[id].name == o.monitor) own = &(*c_.spec)[id];
      }
    }
    if (o.declared) return;  // whoever keeps it waiting, its own recovery drives in the end
    if (o.kind == Kind::keeps) {
      scenario["driven_by"] = o.recovery;
    } else if (o.kind == Kind::p2a && own != nullptr && own->recover && !passes(o)) {
      scenario["driven_by"] = (*c_.spec)[*own->recover].name;
    }
  }
  // The first monitor of the decision that speaks of charge; "": there is none, or, if it has to be
  // kept, it is accepted that it need not be.
  [[nodiscard]] std::string charge_of(const verify::Decision& d, bool kept) const {
    for (const sema::Decision& written : c_.spec->decisions) {
      if (written.name != d.name) continue;
      for (const sema::MonitorId id : written.priority) {
        const sema::Expr& property = *(*c_.spec)[id].always;
        const bool charge =
            sema::speaks_of<sema::EnergyTo>(property) || sema::speaks_of_charge(property);
        if (charge) return kept && accepted(written, id) ? "" : (*c_.spec)[id].name;
      }
    }
    return "";
  }
  // The run is shown, whether or not it can be kept: one of hours may be longer than what is read
  // again.
  void keep(const std::string& trace, Obligation& o) {
    const std::string number = kept_ == 0 ? "" : "-" + std::to_string(kept_ + 1);
    const std::string place = options_.output.empty()
                                  ? stem_of(options_.spec) + number + ".trace"
                                  : options_.output + "/violation" + number + ".trace";
    const auto run = read_file(trace);
    if (!run) {
      o.not_recorded = "the run is too long";
      return;
    }
    if (!write_all({{place, *run}}).empty()) {
      o.not_recorded = "`" + place + "` cannot be written";
      return;
    }
    ++kept_;
    o.trace = place;
  }

  const Options& options_;
  Simulator& simulator_;
  Compilation& c_;
  std::vector<Sought> all_;
  double left_s_, besides_s_ = besides_core_s;
  int shown_ = 0, kept_ = 0;
};

}  // namespace

double attack_core_s(const Options& options) {
  return options.attack_s.empty() ? all_core_s : std::stod(options.attack_s);
}

void leave_open(verify::Report& report) {
  for (verify::Decision& d : report.decisions) {
    for (Obligation& o : d.obligations) {
      const bool refuted = o.by_a_run && o.status == verify::Status::refuted;
      if (refuted && !has_shown(o)) o.status = verify::Status::unknown;
    }
  }
}

void leave_unshown(verify::Report& report, const std::string& why) {
  for (verify::Decision& d : report.decisions) {
    for (Obligation& o : d.obligations) {
      if (in_motion(o)) o.not_shown = why;
    }
  }
}

void show(const Options& options, Simulator& simulator, Compilation& c, verify::Report& report) {
  Showing showing(options, simulator, c);
  for (verify::Decision& d : report.decisions) {
    for (Obligation& o : d.obligations) {
      if (in_motion(o) || o.in_turns || o.declared) showing.add(d, o);
    }
  }
  showing.run();
  for (verify::Decision& d : report.decisions) {
    for (Obligation& o : d.obligations) {
      if (!(o.in_turns || o.declared) || !has_shown(o)) continue;
      o.status = verify::Status::refuted;
      o.claims.clear();
      const std::string run = std::string(o.trace.empty() ? "" : "recorded ") + "run";
      if (o.in_turns) {
        o.because += ", and so do they in a " + run + ", ";
        o.because += o.in_turns->seen == 0 ? "until a property fails"
                                           : std::to_string(o.in_turns->seen) +
                                                 " times, while control is not given back for " +
                                                 std::to_string(turns_last_s) + " s";
      } else {
        o.because += "; in a " + run + " they keep it waiting until `" + o.monitor + "` fails";
      }
    }
  }
}

}  // namespace rtac::driver
