#include "compiler/verify/report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace rtac::verify {
namespace {

constexpr std::array statuses = {Status::proved, Status::acknowledged, Status::unknown,
                                 Status::refuted};

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

// Whom it is about: `geofence`, `give_way, battery`, `home for charge, fence`, or nobody in
// particular.
std::string whom(const Obligation& o) {
  if (o.recovery.empty()) return o.monitor;
  std::string engaged;
  for (const std::string& each : o.engaged) engaged += (engaged.empty() ? " for " : " and ") + each;
  return o.recovery + engaged + ", " + o.monitor;
}

std::string decimals(double value, const char* format = "%.2f") {
  constexpr std::size_t widest = 64;
  std::array<char, widest> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}
void add_conservatism(const Conservatism& c, std::size_t about, std::string& out) {
  out += "  conservatism " + padded(c.monitor, about);
  if (!c.why_not.empty()) {
    out += "not measured: " + c.why_not + "\n";
    return;
  }
  out += "worst found " + decimals(c.found_m, "%.3f") + " m of " + decimals(c.bound_m, "%.3f") +
         " m (" + decimals(c.share()) + "): " + c.by + " at " + decimals(c.speed_mps) + " m/s, " +
         decimals(c.ahead_s) + " s ahead; " + std::to_string(c.states) + " states, " +
         std::to_string(c.searches) + " searches";
  if (c.failures > 0) out += ", " + std::to_string(c.failures) + " without a result";
  out += c.complete ? "\n" : "; the time was up\n";
}

std::string milliseconds(std::int64_t micros, const char* format = "%.1f ms") {
  return decimals(double(micros) / 1000, format);
}

void add_decision(const Decision& d, std::string& out) {
  std::size_t about = 0;
  for (const Obligation& o : d.obligations) about = std::max(about, whom(o).size());
  out += "decision " + d.name + " for " + d.kind + "\n";
  for (const Obligation& o : d.obligations) {
    out += "  " + padded(name(o.kind), 13) + padded(whom(o), about + 2) +
           padded(name(o.status), 14) + milliseconds(o.micros, "%8.1f ms  ") + o.method + ": " +
           o.because + "\n";
    if (!o.repair.empty()) out += "  " + padded("", 13) + "what works: " + o.repair + "\n";
    if (!o.trace.empty()) out += "  " + padded("", 13) + "shown by " + o.trace + "\n";
    if (!o.not_recorded.empty()) {
      out += "  " + padded("", 13) + "shown, not recorded: " + o.not_recorded + "\n";
    }
    if (!o.not_shown.empty()) out += "  " + padded("", 13) + "not shown: " + o.not_shown + "\n";
  }
  for (const Conservatism& c : d.conservatism) add_conservatism(c, about + 2, out);
}

nlohmann::ordered_json json_of(const Conservatism& c) {
  nlohmann::ordered_json j;
  j["monitor"] = c.monitor;
  j["measured"] = c.why_not.empty();
  if (!c.why_not.empty()) {
    j["because"] = c.why_not;
    return j;
  }
  j["found_m"] = c.found_m;
  j["bound_m"] = c.bound_m;
  j["share"] = c.share();
  j["by"] = c.by;
  j["speed_mps"] = c.speed_mps;
  j["ahead_s"] = c.ahead_s;
  j["states"] = c.states;
  j["searches"] = c.searches;
  j["failures"] = c.failures;
  j["complete"] = c.complete;
  return j;
}
nlohmann::ordered_json json_of(const Obligation& o, bool with_times) {
  nlohmann::ordered_json j;
  j["obligation"] = name(o.kind);
  if (!o.monitor.empty()) j["monitor"] = o.monitor;
  if (!o.recovery.empty()) j["recovery"] = o.recovery;
  if (!o.engaged.empty()) j["engaged"] = o.engaged;
  j["status"] = name(o.status);
  j["method"] = o.method;
  j["because"] = o.because;
  if (!o.repair.empty()) j["repair"] = o.repair;
  if (!o.trace.empty()) j["trace"] = o.trace;
  if (!o.not_recorded.empty()) j["not_recorded"] = o.not_recorded;
  if (!o.not_shown.empty()) j["not_shown"] = o.not_shown;
  if (with_times) j["milliseconds"] = double(o.micros) / 1000;
  if (o.claims.empty()) return j;
  for (const Claim& claim : o.claims) {
    nlohmann::ordered_json c;
    c["claim"] = claim.what;
    for (const auto& [key, value] : claim.values) c[key] = value;
    j["claims"].push_back(std::move(c));
  }
  return j;
}

}  // namespace

std::string to_text(const Report& report) {
  std::string out;
  std::array<int, statuses.size()> counts{};
  for (const Decision& d : report.decisions) {
    add_decision(d, out);
    for (const Obligation& o : d.obligations) {
      for (std::size_t i = 0; i < statuses.size(); ++i)
        counts[i] += o.status == statuses[i] ? 1 : 0;
    }
  }
  if (!report.complete)
    out +=
        "no module could be built: the other obligations are not looked at, and there are no "
        "certificates\n";
  if (report.decisions.empty()) out += "no decision: nothing is obliged\n";
  std::string sums;
  for (std::size_t i = 0; i < statuses.size(); ++i) {
    sums += (i == 0 ? "" : ", ") + std::to_string(counts[i]) + " " + name(statuses[i]);
  }
  return out + sums + " in " + milliseconds(report.micros) + "\n";
}

std::string to_json(const Report& report, bool with_times) {
  nlohmann::ordered_json j;
  j["spec"] = report.spec;
  j["complete"] = report.complete;
  if (with_times) j["milliseconds"] = double(report.micros) / 1000;
  j["decisions"] = nlohmann::ordered_json::array();
  for (const Decision& d : report.decisions) {
    nlohmann::ordered_json of;
    of["decision"] = d.name;
    of["robot"] = d.kind;
    of["obligations"] = nlohmann::ordered_json::array();
    for (const Obligation& o : d.obligations) of["obligations"].push_back(json_of(o, with_times));
    for (const Conservatism& c : d.conservatism) of["conservatism"].push_back(json_of(c));
    j["decisions"].push_back(std::move(of));
  }
  return j.dump(2) + "\n";
}

}  // namespace rtac::verify
