#include "compiler/driver/aims.h"

#include <algorithm>
#include <map>
#include <utility>

namespace rtac::driver {
namespace {

using verify::Kind;
using verify::Obligation;

// What recoveries cost that take over from each other without end, or that wait for each other: the
// charge that was to lead home. As long as a battery lasts that is only just enough.
Scenario aimed_at_charge(const std::string& charge, int runs, int duration_s) {
  Scenario drained = Scenario::object();
  drained["about"] = charge;
  drained["runs"] = runs;
  drained["starts"] = "tight";
  drained["duration_s"] = duration_s;
  return drained;
}

Scenario place(const std::vector<std::int64_t>& mm) {
  constexpr double mm_per_m = 1000;
  Scenario at = Scenario::array();
  for (const std::int64_t each : mm) at.push_back(static_cast<double>(each) / mm_per_m);
  return at;
}

// One robot rests at its dock, as good as empty, so that the others wait for it for as long as that
// may take.
Scenario aimed_at_the_dock(const Obligation& o, const std::vector<std::string>& robots) {
  Scenario queue = aimed_at_charge(o.monitor, 12, 3600);
  queue["starts"] = Scenario::object();
  for (const std::string& robot : robots) queue["starts"][robot]["battery"] = "tight";
  queue["starts"][o.dock->robot]["at"] = place({o.dock->at_mm.first, o.dock->at_mm.second});
  return queue;
}

// The first robots where the start says, all others out of their way.
Scenario starts_at(const Obligation& o, const verify::Start& start,
                   const std::vector<std::string>& robots) {
  Scenario all = Scenario::object();
  if (start.place_mm.empty()) return all;
  std::vector<std::vector<std::int64_t>> places_mm{start.place_mm};
  places_mm.insert(places_mm.end(), start.others_mm.begin(), start.others_mm.end());
  places_mm.insert(places_mm.end(), o.aside_mm.begin(), o.aside_mm.end());
  for (std::size_t i = 0; i < std::min(places_mm.size(), robots.size()); ++i) {
    all[robots[i]]["at"] = place(places_mm[i]);
  }
  return all;
}
Scenario starts_in_trouble(const Obligation& o, const std::vector<std::string>& robots) {
  return starts_at(o, {{o.place_mm->first, o.place_mm->second}}, robots);
}

// A recovery that lasts for ever takes its time: until it has spent what robots had at a fence, of
// batteries neither full nor empty. Who only pushes may do so beside a dock, which charges them;
// the first one begins where it is known that nobody is given back.
std::vector<Scenario> aimed_at_rest(const Obligation& o, const std::vector<std::string>& robots) {
  Scenario rests = Scenario::object();
  rests["about"] = o.monitor;
  rests["duration_s"] = 3600;
  if (o.place_mm) rests["starts"] = starts_in_trouble(o, robots);
  for (const std::string& robot : robots) rests["starts"][robot]["battery"] = 0.4;
  Scenario pushed = rests;
  pushed["adversary"] = "push-at-fence";
  pushed["runs"] = 6;
  rests["runs"] = 12;  // as many as there are adversaries
  return {std::move(pushed), std::move(rests)};
}

// What a scenario says of inputs of which all components are told; the others are drawn.
Scenario inputs_told(const sema::Spec& spec, const std::vector<analysis::ToldInput>& told) {
  std::map<sema::InputId, std::map<std::uint32_t, Scenario>> by_component;
  for (const auto& [id, component, value] : told) {
    const sema::Input& input = spec[id];
    if (component == analysis::age_component(input)) continue;  // within what it is declared to be
    Scenario is = value.get_d();
    if (input.type == sema::InputType::boolean) {
      is = sgn(value) != 0;
    } else if (input.type == sema::InputType::enumeration) {
      is = spec[*input.enumeration].values[static_cast<std::size_t>(floor_to_int(value))];
    }
    by_component[id][component] = std::move(is);
  }
  Scenario all = Scenario::object();
  for (auto& [id, components] : by_component) {
    const sema::Input& input = spec[id];
    if (components.size() < input.components.size()) continue;
    Scenario values = Scenario::array();
    for (auto& [component, is] : components) values.push_back(std::move(is));
    all[input.name] = components.size() == 1 ? values[0] : std::move(values);
  }
  return all;
}

// Inputs with which the `return when` of a monitor lets go: what else they may be is waited for.
std::vector<analysis::ToldInput> that_let_go(const sema::Spec& spec, const std::string& monitor) {
  const auto m = std::ranges::find(spec.monitors, monitor, &sema::Monitor::name);
  if (m == spec.monitors.end() || !m->return_when) return {};
  return analysis::told_to_be(spec, *m->return_when, true, analysis::ToldHow::seen).inputs;
}

// From where nothing leads back as long as the robot is measured there, from the start on, whoever
// drives before.
Scenario aimed_at_what_is_seen(Scenario there, const Obligation& o, const verify::Start& start,
                               const sema::Spec& spec, const std::vector<std::string>& robots) {
  constexpr std::int64_t kept_s = 30;  // long enough to tell that it stands
  there["runs"] = 4;
  there["return_within_s"] = kept_s;
  there["duration_s"] = kept_s + 1;
  there["noise"] = "none";
  there["starts"] = starts_at(o, start, robots);
  there["inputs"] = inputs_told(spec, start.told);
  return there;
}

// From where the recovery of one monitor leads to where another one is false.
Scenario aimed_at_start(const Obligation& o, const verify::Start& start,
                        const std::vector<std::string>& robots) {
  constexpr double full_ppm = 1e6;
  Scenario there = Scenario::object();
  there["about"] = o.monitor;
  there["runs"] = 12;  // as many as there are adversaries
  there["duration_s"] = 60;
  there["starts"] = starts_at(o, start, robots);
  if (start.battery_ppm) {
    there["starts"][robots.front()]["battery"] =
        std::min(1.0, static_cast<double>(*start.battery_ppm) / full_ppm);
  }
  if (start.place_mm.empty()) {
    // what a battery is measured with is taken to be as old as it is: fresh, the look-ahead has
    // least to spare
    there["adversary"] = "fresh-samples";
    there["runs"] = 24;
    there["duration_s"] = 30;
  }
  return there;
}

// Where one leads to where another one takes over, and anywhere; and what that costs.
std::vector<Scenario> aimed_at_turns(const Obligation& o, const std::vector<std::string>& robots,
                                     const std::string& charge) {
  constexpr int begins_s = 30;
  std::vector<Scenario> all;
  if (!o.in_turns->modes.empty()) {
    Scenario turns = Scenario::object();
    turns["runs"] = 12;  // as many as there are adversaries
    turns["return_within_s"] = turns_last_s;
    turns["duration_s"] = turns_last_s + begins_s;
    const auto begin_at = [&](const verify::Start& start) {
      all.push_back(turns);
      all.back()["starts"] = starts_at(o, start, robots);
    };
    if (!o.starts.empty()) begin_at(o.starts.front());
    all.push_back(turns);
    std::for_each(o.starts.begin() + (o.starts.empty() ? 0 : 1), o.starts.end(), begin_at);
  }
  if (!charge.empty()) all.push_back(aimed_at_charge(charge, 20, 3600));
  return all;
}

// Robots that hold beside each other: who waits for whom is all there is to it. From each start
// they are first measured as they are; from some only errors have them wait: then with all
// adversaries, and nothing is lost of what they tell each other. One over the other they wait only
// where errors last.
std::vector<Scenario> aimed_at_lock_ups(const Obligation& o,
                                        const std::vector<std::string>& robots) {
  constexpr int kept_s = 120;  // in which each of them has looked for a way ten times
  constexpr int exact_runs = 4, runs = 24;
  const bool errors_last = o.lock_up->errors_last;
  std::vector<Scenario> all, noisy;
  for (const verify::Start& start : o.starts) {
    Scenario there = Scenario::object();
    there["about"] = o.monitor;
    there["return_within_s"] = kept_s;
    there["duration_s"] = kept_s + 1;
    there["starts"] = starts_at(o, start, robots);
    Scenario more = there;
    there["runs"] = errors_last ? runs : exact_runs;
    there["adversary"] = errors_last ? "lasting-errors" : "bang-bang";
    if (!errors_last) there["noise"] = "none";
    all.push_back(std::move(there));
    if (errors_last) continue;
    more["runs"] = runs;
    more["fault_every_s"] = 0;
    noisy.push_back(std::move(more));
  }
  std::ranges::move(noisy, std::back_inserter(all));
  return all;
}

}  // namespace

bool about_return(const Obligation& o) {
  return o.kind == Kind::p2b || o.kind == Kind::joint_return;
}

std::vector<Scenario> aimed_at(const Obligation& o, const sema::Spec& spec,
                               const std::vector<std::string>& robots, const std::string& charge) {
  if (o.in_turns) return aimed_at_turns(o, robots, charge);
  if (o.declared) {
    std::vector<Scenario> all{aimed_at_charge(o.monitor, 12, 1200)};  // with each adversary
    if (o.dock) all.push_back(aimed_at_the_dock(o, robots));
    return all;
  }
  // whoever keeps the other monitor engaged does so until the charge is gone
  if (o.unending) return {aimed_at_charge(o.monitor, 20, 3600)};
  if (o.lock_up) return aimed_at_lock_ups(o, robots);
  std::vector<Scenario> all;
  Scenario about = Scenario::object();
  if (!o.monitor.empty()) about["about"] = o.monitor;
  if (about_return(o)) {
    // no recovery of a fleet that fits its field takes longer to begin
    constexpr std::int64_t begins_s = 30;
    const std::int64_t kept_s = o.patience_s + begins_s;
    about["return_within_s"] = kept_s;
    about["duration_s"] = 2 * kept_s + begins_s;
    about["runs"] = 20;
    about["inputs"] = inputs_told(spec, that_let_go(spec, o.monitor));
    for (const verify::Start& start : o.starts) {
      if (start.seen_there) all.push_back(aimed_at_what_is_seen(about, o, start, spec, robots));
    }
    if (o.place_mm) {
      Scenario there = about;
      there["starts"] = starts_in_trouble(o, robots);
      all.push_back(std::move(there));
    }
    for (const verify::Start& start : o.starts) {
      if (start.seen_there) continue;
      Scenario there = about;
      there["starts"] = starts_at(o, start, robots);
      all.push_back(there);
      there["ages"] = "unequal";  // that the motion may have changed in between counts as well
      all.push_back(std::move(there));
    }
    if (o.monitor == charge && !charge.empty()) {
      Scenario low = about;  // it engages soon
      low["starts"] = "tight";
      all.push_back(std::move(low));
    }
    all.push_back(std::move(about));
    return all;
  }
  Scenario anywhere = about, tight = std::move(about);
  anywhere["runs"] = 60;
  tight["runs"] = 20;
  tight["starts"] = "tight";
  tight["duration_s"] = std::clamp<std::int64_t>(o.patience_s, 300, 3600);
  Scenario deaf = tight, undecided = tight;
  deaf["duration_s"] = 3600;  // until a recovery that waits for others has spent the charge
  deaf["deaf_from_s"] = 5;
  deaf["runs"] = 4;
  for (const verify::Start& start : o.starts) all.push_back(aimed_at_start(o, start, robots));
  std::vector<Scenario> rests;
  if (o.kind == Kind::keeps && o.monitor == charge) rests = aimed_at_rest(o, robots);
  // first where it is known that nobody is given back
  if (o.place_mm) all.insert(all.end(), rests.begin(), rests.end());
  all.push_back(std::move(anywhere));
  all.push_back(std::move(tight));
  if (!o.place_mm) all.insert(all.end(), rests.begin(), rests.end());
  if (robots.size() > 1) all.push_back(std::move(deaf));
  if (o.kind != Kind::p1a) return all;
  // its errors may be hidden by what other bounds have to spare
  undecided["undecided"] = true;
  undecided["duration_s"] = 1;
  return {std::move(all.front()), std::move(undecided)};
}

}  // namespace rtac::driver
