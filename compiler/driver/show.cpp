#include "compiler/driver/show.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "compiler/driver/driver.h"
#include "compiler/driver/files.h"
#include "compiler/driver/lock_up.h"
#include "compiler/sema/visit.h"

namespace rtac::driver {
namespace {

using Json = nlohmann::ordered_json;
using verify::Kind;
using verify::Obligation;

// As long as a person waits for an attempt, in core seconds, and how many there are, of all
// obligations together: large fleets are slow, and partial results are results.
constexpr int attempt_core_s = 20, attempts_max = 6;

// `yard` of `specs/yard.rta`.
std::string stem_of(const std::string& path) {
  const std::string name = path.substr(path.find_last_of('/') + 1);
  const std::size_t dot = name.find_last_of('.');
  return path == "-" ? "specification" : name.substr(0, dot == 0 ? std::string::npos : dot);
}

bool about_return(const Obligation& o) {
  return o.kind == Kind::p2b || o.kind == Kind::joint_return;
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

// What recoveries cost that take over from each other without end, or that wait for each other: the
// charge that was to lead home. As long as a battery lasts that is only just enough.
Json aimed_at_charge(const std::string& charge, int runs, int duration_s) {
  Json drained = Json::object();
  drained["about"] = charge;
  drained["runs"] = runs;
  drained["starts"] = "tight";
  drained["duration_s"] = duration_s;
  return drained;
}

// A recovery that lasts for ever takes its time: until it has spent what robots had at a fence, of
// batteries neither full nor empty. Who only pushes may do so beside a dock, which charges them.
std::vector<Json> aimed_at_rest(const std::vector<std::string>& robots, const std::string& charge) {
  Json rests = Json::object();
  rests["about"] = charge;
  rests["duration_s"] = 3600;
  for (const std::string& robot : robots) rests["starts"][robot]["battery"] = 0.4;
  Json pushed = rests;
  pushed["adversary"] = "push-at-fence";
  pushed["runs"] = 6;
  rests["runs"] = 12;  // as many as there are adversaries
  return {std::move(pushed), std::move(rests)};
}

Json place(const std::vector<std::int64_t>& mm) {
  constexpr double mm_per_m = 1000;
  Json at = Json::array();
  for (const std::int64_t each : mm) at.push_back(static_cast<double>(each) / mm_per_m);
  return at;
}

Json starts_at(const verify::Start& start, const std::vector<std::string>& robots) {
  Json all = Json::object();
  all[robots.front()]["at"] = place(start.place_mm);
  for (std::size_t i = 0; i < start.others_mm.size() && i + 1 < robots.size(); ++i) {
    all[robots[i + 1]]["at"] = place(start.others_mm[i]);
  }
  return all;
}

// From where the recovery of one monitor leads to where another one is false.
Json aimed_at_start(const Obligation& o, const verify::Start& start,
                    const std::vector<std::string>& robots) {
  constexpr double full_ppm = 1e6;
  Json there = Json::object();
  there["about"] = o.monitor;
  there["runs"] = 12;  // as many as there are adversaries
  there["duration_s"] = 60;
  there["starts"] = starts_at(start, robots);
  if (start.battery_ppm) {
    there["starts"][robots.front()]["battery"] =
        std::min(1.0, static_cast<double>(*start.battery_ppm) / full_ppm);
  }
  return there;
}

// Robots that hold beside each other, measured as they are: who waits for whom is all there is to
// it.
Json aimed_at_lock_up(const Obligation& o, const verify::Start& start,
                      const std::vector<std::string>& robots) {
  constexpr int kept_s = 120;  // in which each of them has looked for a way ten times
  Json there = Json::object();
  there["about"] = o.monitor;
  there["runs"] = 4;
  there["adversary"] = "chase-fence";
  there["noise"] = "none";
  there["return_within_s"] = kept_s;
  there["duration_s"] = kept_s + 1;
  there["starts"] = starts_at(start, robots);
  return there;
}

// Scenarios in which it would be seen, the likeliest first.
std::vector<Json> aimed_at(const Obligation& o, const std::vector<std::string>& robots,
                           const std::string& charge) {
  if (o.in_turns) {
    if (charge.empty()) return {};
    return {aimed_at_charge(charge, 20, 3600)};
  }
  // with each of the adversaries
  if (o.declared) return {aimed_at_charge(o.monitor, 12, 1200)};
  std::vector<Json> all;
  if (o.locked_within_mm) {
    for (const verify::Start& start : o.starts) all.push_back(aimed_at_lock_up(o, start, robots));
    return all;
  }
  Json about = Json::object();
  if (!o.monitor.empty()) about["about"] = o.monitor;
  if (about_return(o)) {
    // no recovery of a fleet that fits its field takes longer to begin
    constexpr std::int64_t begins_s = 30;
    const std::int64_t kept_s = o.patience_s + begins_s;
    about["return_within_s"] = kept_s;
    about["duration_s"] = 2 * kept_s + begins_s;
    about["runs"] = 20;
    if (o.place_mm) {
      Json there = about;
      there["starts"][robots.front()]["at"] = place({o.place_mm->first, o.place_mm->second});
      all.push_back(std::move(there));
    }
    for (const verify::Start& start : o.starts) {
      Json there = about;
      there["starts"][robots.front()]["at"] = place(start.place_mm);
      all.push_back(std::move(there));
    }
    all.push_back(std::move(about));
    return all;
  }
  Json anywhere = about, tight = std::move(about);
  anywhere["runs"] = 60;
  tight["runs"] = 20;
  tight["starts"] = "tight";
  tight["duration_s"] = 300;
  Json deaf = tight, undecided = tight;
  deaf["duration_s"] = 3600;  // until a recovery that waits for others has spent the charge
  deaf["deaf_from_s"] = 5;
  deaf["runs"] = 4;
  for (const verify::Start& start : o.starts) all.push_back(aimed_at_start(o, start, robots));
  all.push_back(std::move(anywhere));
  all.push_back(std::move(tight));
  if (o.kind == Kind::keeps && o.monitor == charge) {
    for (Json& rests : aimed_at_rest(robots, charge)) all.push_back(std::move(rests));
  }
  if (robots.size() > 1) all.push_back(std::move(deaf));
  if (o.kind != Kind::p1a) return all;
  // its errors may be hidden by what other bounds have to spare
  undecided["undecided"] = true;
  undecided["duration_s"] = 1;
  return {std::move(all.front()), std::move(undecided)};
}

class Showing {
 public:
  Showing(const Options& options, Simulator& simulator, Compilation& c)
      : options_(options), simulator_(simulator), c_(c) {}

  void show(const verify::Decision& d, Obligation& o) {
    std::vector<std::string> robots;
    for (const sema::Robot& r : c_.spec->robots) {
      if ((*c_.spec)[r.kind].name == d.kind) robots.push_back(r.name);
    }
    if (robots.empty()) return;
    int tried = 0;
    bool cut = false;
    for (Json& scenario : aimed_at(o, robots, charge_of(d, o.in_turns))) {
      blame(d, o, scenario);
      if (attempts_ == attempts_max) break;
      ++attempts_;
      ++tried;
      const std::string file = simulator_.folder() + "/aimed.json";
      const std::string trace = simulator_.folder() + "/violation.trace";
      if (!write_all({{file, scenario.dump()}}).empty()) return;
      std::string table;
      const int status = simulator_.run({"--scenario", file, "--trace", trace, "--until", "shown",
                                         "--core-s", std::to_string(attempt_core_s)},
                                        c_, table);
      if (status == exit_violation && shows(trace, scenario, o)) return keep(trace, o);
      cut = cut || table.find("the time was up") != std::string::npos;
    }
    // nothing is claimed: the model may have runs that no robot has, and others keep to `held`
    if (o.in_turns || o.declared) return;
    o.not_shown = tried == 0 ? "the time was up"
                  : cut      ? "no run under attack has shown it until the time was up"
                             : "no run under attack has shown it";
  }

 private:
  // That a recovery may break it: a run in which it fails says nothing of others.
  static bool accepted(const sema::Decision& d, sema::MonitorId id) {
    return std::ranges::any_of(d.acknowledgements, [&](const auto& a) { return a.monitor == id; });
  }
  // What counts is that its own recovery drives into the violation, and none of those of which it
  // is accepted that they may break the property.
  void blame(const verify::Decision& d, const Obligation& o, Json& scenario) const {
    if (!o.unmet.empty()) scenario["unmet"] = o.unmet;
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
    } else if (o.kind == Kind::p2a && own != nullptr && own->recover) {
      scenario["driven_by"] = (*c_.spec)[*own->recover].name;
    }
  }
  // The first monitor of the decision that speaks of charge; "": there is none, or, if it has to be
  // kept, it is accepted that it need not be.
  [[nodiscard]] std::string charge_of(const verify::Decision& d, bool kept) const {
    for (const sema::Decision& written : c_.spec->decisions) {
      if (written.name != d.name) continue;
      for (const sema::MonitorId id : written.priority) {
        bool charge = false;
        sema::for_each_expr(*(*c_.spec)[id].always, [&](const sema::Expr& e) {
          const auto* signal = std::get_if<sema::SignalRef>(&e.node);
          charge = charge || std::holds_alternative<sema::EnergyTo>(e.node) ||
                   (signal != nullptr && signal->signal == sema::Signal::battery);
        });
        if (charge) return kept && accepted(written, id) ? "" : (*c_.spec)[id].name;
      }
    }
    return "";
  }
  // Of robots that wait for each other, only what nobody else has a part in.
  static bool shows(const std::string& trace, const Json& scenario, const Obligation& o) {
    if (!o.locked_within_mm) return true;
    const auto run = read_file(trace);
    return run && locks_up(*run, scenario["starts"].size(), *o.locked_within_mm);
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
  int attempts_ = 0, kept_ = 0;
};

}  // namespace

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
      if (in_motion(o) || o.in_turns || o.declared) showing.show(d, o);
      if (!(o.in_turns || o.declared) || !has_shown(o)) continue;
      o.status = verify::Status::refuted;
      o.claims.clear();
      const std::string run = std::string(o.trace.empty() ? "" : "recorded ") + "run";
      if (o.in_turns) {
        o.because += ", and so do they in a " + run + ", until a property fails";
      } else {
        o.because += "; in a " + run + " they keep it waiting until `" + o.monitor + "` fails";
      }
    }
  }
}

}  // namespace rtac::driver
