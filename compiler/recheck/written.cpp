#include "compiler/recheck/written.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace rtac::recheck {
namespace {

using Json = nlohmann::json;

std::string text(const Json& j, const char* key) {
  const auto at = j.find(key);
  return at != j.end() && at->is_string() ? at->get<std::string>() : "";
}

// nullopt: it is none, or has a key twice, of which each reader may take another one.
std::optional<Json> object_of(const std::string& report) {
  using Event = Json::parse_event_t;
  std::vector<std::set<std::string>> keys;
  bool twice = false;
  const auto look = [&](int, Event event, Json& parsed) {
    if (event == Event::object_start) keys.emplace_back();
    if (event == Event::object_end) keys.pop_back();
    if (event == Event::key) twice |= !keys.back().insert(parsed.get<std::string>()).second;
    return true;
  };
  Json j = Json::parse(report, look, false);
  return j.is_object() && !twice ? std::optional(std::move(j)) : std::nullopt;
}

}  // namespace

std::optional<Report> read_report(const std::string& report) {
  const auto object = object_of(report);
  if (!object) return std::nullopt;
  const Json& j = *object;
  const bool whole = j.contains("complete") && j["complete"] == true;
  if (!whole || !j.contains("decisions") || !j["decisions"].is_array()) return std::nullopt;
  std::vector<Part> parts;
  for (const Json& d : j["decisions"]) {
    if (!d.is_object() || !d.contains("obligations") || !d["obligations"].is_array()) {
      return std::nullopt;
    }
    Part part{text(d, "decision"), text(d, "robot"), {}};
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
  return Report{text(j, "spec"), std::move(parts)};
}

const Entry* find(const Part& part, const std::string& kind, const std::string& monitor,
                  const std::string& recovery) {
  for (const Entry& e : part.entries) {
    if (e.kind == kind && e.monitor == monitor && e.recovery == recovery) return &e;
  }
  return nullptr;
}

const Claim* claim_of(const Entry& entry, const std::string& what) {
  for (const Claim& claim : entry.claims) {
    if (claim.what == what) return &claim;
  }
  return nullptr;
}

bool speaks_of(const Entry& entry, const sema::Monitor& driving) {
  return std::any_of(entry.claims.begin(), entry.claims.end(), [&](const Claim& c) {
    return c.what == "recovery" && recheck::text(c.values, "monitor") == driving.name;
  });
}

bool is_shown(const Entry& entry) {
  return entry.status == "proved" || (entry.status == "acknowledged" && !entry.claims.empty());
}

const Claim* claim_with(const Entry& e, const std::string& what, const Values& values) {
  const auto found = std::ranges::find_if(e.claims, [&](const Claim& c) {
    return c.what == what && std::all_of(values.begin(), values.end(), [&](const auto& v) {
             const auto at = c.values.find(v.first);
             return at != c.values.end() && at->second == v.second;
           });
  });
  return found == e.claims.end() ? nullptr : &*found;
}

bool has(const Entry& e, const std::string& what, const Values& values) {
  return claim_with(e, what, values) != nullptr;
}

std::string whom(const sema::Decision& d, const Entry& e) {
  return d.name + ", " + e.kind + (e.monitor.empty() ? "" : " of `" + e.monitor + "`") +
         (e.recovery.empty() ? "" : " while `" + e.recovery + "` drives");
}

}  // namespace rtac::recheck
