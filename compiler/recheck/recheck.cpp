#include "compiler/recheck/recheck.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "compiler/recheck/claims.h"

namespace rtac::recheck {
namespace {

using Json = nlohmann::json;

struct Entry {
  std::string kind, monitor, recovery, status;
  std::vector<Claim> claims;
};
struct Part {
  std::string decision;
  std::vector<Entry> entries;
};

std::string text(const Json& j, const char* key) {
  const auto at = j.find(key);
  return at != j.end() && at->is_string() ? at->get<std::string>() : "";
}

// nullopt: it is no report.
std::optional<std::vector<Part>> read(const std::string& report) {
  const Json j = Json::parse(report, nullptr, false);
  if (!j.is_object() || !j.contains("decisions") || !j["decisions"].is_array()) return std::nullopt;
  std::vector<Part> parts;
  for (const Json& d : j["decisions"]) {
    if (!d.is_object() || !d.contains("obligations") || !d["obligations"].is_array()) {
      return std::nullopt;
    }
    Part part{text(d, "decision"), {}};
    for (const Json& o : d["obligations"]) {
      if (!o.is_object()) return std::nullopt;
      Entry e{
          text(o, "obligation"), text(o, "monitor"), text(o, "recovery"), text(o, "status"), {}};
      if (o.contains("claims")) {
        for (const Json& c : o["claims"]) {
          if (!c.is_object()) return std::nullopt;
          Claim claim;
          for (const auto& [key, value] : c.items()) {
            if (!value.is_string()) return std::nullopt;
            (key == "claim" ? claim.what : claim.values[key]) = value.get<std::string>();
          }
          e.claims.push_back(std::move(claim));
        }
      }
      part.entries.push_back(std::move(e));
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

class Check {
 public:
  Check(const sema::Spec& spec, const SourceManager& sources, const ProveLemma& prove)
      : spec_(spec), claims_(spec, sources, prove) {}

  Outcome run(const std::vector<Part>& parts) {
    for (const sema::Decision& d : spec_.decisions) {
      const auto part = std::find_if(parts.begin(), parts.end(),
                                     [&](const Part& p) { return p.decision == d.name; });
      if (part == parts.end()) {
        fail("nothing is said of decision `" + d.name + "`");
        continue;
      }
      complete(d, *part);
      for (const Entry& e : part->entries) entry(d, e);
    }
    return std::move(out_);
  }

 private:
  void fail(std::string why) { out_.failed.push_back(std::move(why)); }
  static std::string whom(const sema::Decision& d, const Entry& e) {
    return d.name + ", " + e.kind + (e.monitor.empty() ? "" : " of `" + e.monitor + "`") +
           (e.recovery.empty() ? "" : " while `" + e.recovery + "` drives");
  }
  static const Entry* find(const Part& part, const std::string& kind, const std::string& monitor,
                           const std::string& recovery = "") {
    for (const Entry& e : part.entries) {
      if (e.kind == kind && e.monitor == monitor && e.recovery == recovery) return &e;
    }
    return nullptr;
  }

  // theory, well-formed RTA modules: what there has to be.
  void complete(const sema::Decision& d, const Part& part) {
    const auto need = [&](const std::string& kind, const std::string& monitor,
                          const std::string& recovery = "") {
      if (find(part, kind, monitor, recovery) != nullptr) return;
      Entry missing{kind, monitor, recovery, "", {}};
      fail(whom(d, missing) + ": it is missing");
    };
    need("P1b", "");
    for (const sema::MonitorId id : d.priority) {
      const std::string& name = spec_[id].name;
      for (const char* kind : {"P2a", "P2b", "P3", "satisfiable"}) need(kind, name);
      if (d.on_plan) continue;
      need("P1a", name);
      for (const sema::MonitorId other : d.priority) {
        if (other != id && spec_[other].recover) need("C", name, spec_[*spec_[other].recover].name);
      }
    }
    if (d.on_plan) return;
    need("joint return", "");
    need("initial", "");
  }

  void entry(const sema::Decision& d, const Entry& e) {
    ++out_.obligations;
    if (e.status == "acknowledged") {
      if (!accepted(d, e)) fail(whom(d, e) + ": nobody acknowledges it");
      return;
    }
    if (e.status == "unknown" || e.status == "refuted") return;  // nothing is claimed
    if (e.status != "proved") return fail(whom(d, e) + ": `" + e.status + "` is no status");
    rests_on(d, e);
    for (const Claim& claim : e.claims) {
      ++out_.claims;
      const auto doubt = claims_.check(claim);
      if (!doubt) continue;
      (doubt->refuted ? out_.failed : out_.open)
          .push_back(whom(d, e) + ": " + claim.what + ": " + doubt->why);
    }
  }

  // What the specification accepts in its own words.
  bool accepted(const sema::Decision& d, const Entry& e) const {
    for (const sema::MonitorId id : d.priority) {
      const sema::Monitor& m = spec_[id];
      if (m.name != e.monitor) continue;
      if (e.kind == "P1a" || e.kind == "P3") {
        return m.ahead.duration_unsound || !m.ahead.unsound_reason.empty();
      }
      if (e.kind == "P2b" && m.hold_reason) return true;
      std::string recovery = e.recovery;
      if (recovery.empty() && m.recover) recovery = spec_[*m.recover].name;
      return std::any_of(d.acknowledgements.begin(), d.acknowledgements.end(), [&](const auto& a) {
        return spec_[a.recovery].name == recovery && spec_[a.monitor].name == m.name;
      });
    }
    return false;
  }

  static bool has(const Entry& e, const std::string& what, const Values& values = {}) {
    return std::any_of(e.claims.begin(), e.claims.end(), [&](const Claim& c) {
      return c.what == what && std::all_of(values.begin(), values.end(), [&](const auto& v) {
               const auto at = c.values.find(v.first);
               return at != c.values.end() && at->second == v.second;
             });
    });
  }
  void need(const sema::Decision& d, const Entry& e, const std::string& what, Values values = {},
            bool named = true) {
    if (named) values["decision"] = d.name;
    if (!has(e, what, values)) fail(whom(d, e) + ": it rests on no claim `" + what + "`");
  }

  // A proof that leaves out a part proves nothing.
  void rests_on(const sema::Decision& d, const Entry& e) {
    const Values of_monitor{{"monitor", e.monitor}};
    if (e.kind == "P1b") return need(d, e, "output");
    if (e.kind == "initial") return need(d, e, "start");
    if (d.on_plan && e.kind != "satisfiable") return need(d, e, "judged");
    if (e.kind == "P1a") return need(d, e, "horizon", of_monitor);
    if (e.kind == "not vacuous") return need(d, e, "fails", of_monitor);
    if (e.kind == "joint return") return joint(d, e);
    const sema::Monitor* const m = monitor(d, e.monitor);
    if (m == nullptr) return fail(whom(d, e) + ": there is no such monitor");
    if (e.kind == "P2a") return keeps(d, e, *m);
    if (e.kind == "P2b") return returns(d, e, *m);
    if (e.kind == "P3") {
      need(d, e, "limits");
      need(d, e, "return", of_monitor);
      return need(d, e, "lemma", {{"name", "return_implies_ahead"}}, false);
    }
    if (e.kind == "C") return keeps_other(d, e, *m);
    if (e.kind == "satisfiable" && e.claims.empty()) fail(whom(d, e) + ": it rests on no claim");
  }
  const sema::Monitor* monitor(const sema::Decision& d, const std::string& name) const {
    for (const sema::MonitorId id : d.priority) {
      if (spec_[id].name == name) return &spec_[id];
    }
    return nullptr;
  }

  void joint(const sema::Decision& d, const Entry& e) {
    if (has(e, "no_fences", {{"decision", d.name}})) return;
    std::set<std::string> zones, places;
    for (const sema::MonitorId id : d.priority) {
      for (const sema::ZoneId zone : kept_in(*spec_[id].always)) {
        zones.insert(claims_.zones().name(zone));
      }
    }
    for (const Claim& c : e.claims) {
      if (c.what != "place") continue;
      places.insert(c.values.count("x_mm") + c.values.count("y_mm") == 2
                        ? c.values.at("x_mm") + " " + c.values.at("y_mm")
                        : "");
      zones.erase(c.values.count("zone") != 0 ? c.values.at("zone") : "");
    }
    if (!zones.empty()) fail(whom(d, e) + ": nothing is said of zone `" + *zones.begin() + "`");
    if (places.size() > 1) fail(whom(d, e) + ": it is not one place");
  }
  // Each zone that a recovery moves within lies in each zone that the property keeps the robot in.
  void within(const sema::Decision& d, const Entry& e, const sema::Controller& recovery,
              const std::vector<sema::ZoneId>& fences) {
    for (const sema::ZoneId inner : moves_within(recovery)) {
      for (const sema::ZoneId outer : fences) {
        if (inner == outer) continue;
        const NamedZones& zones = claims_.zones();
        need(d, e, "contained", {{"inner", zones.name(inner)}, {"outer", zones.name(outer)}},
             false);
      }
    }
  }
  void keeps(const sema::Decision& d, const Entry& e, const sema::Monitor& m) {
    need(d, e, "limits");
    need(d, e, "recovery", {{"monitor", m.name}});
    if (m.recover) within(d, e, spec_[*m.recover], held_by(*m.always));
    if (all_zones(*m.always).empty()) return;
    for (const char* lemma : {"capsule", "disc", "stop_difference"}) {
      need(d, e, "lemma", {{"name", lemma}}, false);
    }
  }
  void returns(const sema::Decision& d, const Entry& e, const sema::Monitor& m) {
    if (m.recover && !moves_within(spec_[*m.recover]).empty() && !all_zones(*m.always).empty()) {
      return need(d, e, "ways", {{"monitor", m.name}});
    }
    if (e.claims.empty()) fail(whom(d, e) + ": it rests on no claim");
  }
  void keeps_other(const sema::Decision& d, const Entry& e, const sema::Monitor& m) {
    for (const sema::MonitorId id : d.priority) {
      const sema::Monitor& driving = spec_[id];
      if (!driving.recover || spec_[*driving.recover].name != e.recovery) continue;
      if (&driving == &m) continue;
      if (has(e, "outranks", {{"decision", d.name}, {"higher", m.name}, {"lower", driving.name}})) {
        continue;
      }
      within(d, e, spec_[*driving.recover], held_by(*m.always));
    }
  }

  const sema::Spec& spec_;
  Claims claims_;
  Outcome out_;
};

}  // namespace

Outcome recheck(const sema::Spec& spec, const SourceManager& sources, const std::string& report,
                const ProveLemma& prove) {
  const auto parts = read(report);
  if (!parts) {
    Outcome out;
    out.failed.emplace_back("verification.json is no report of `rtac verify`");
    return out;
  }
  return Check(spec, sources, prove).run(*parts);
}

}  // namespace rtac::recheck
