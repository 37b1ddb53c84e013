#include "compiler/driver/conservatism.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "compiler/driver/driver.h"

namespace rtac::driver {
namespace {

using Json = nlohmann::json;
using verify::Conservatism;

// Doubles that the search itself may add to a distance, m.
constexpr double rounding_m = 1e-6;

Conservatism conservatism_of(const Json& j) {
  Conservatism c;
  c.monitor = j.at("monitor").get<std::string>();
  c.why_not = j.value("why_not", "");
  c.searches = j.at("searches").get<int>();
  c.failures = j.at("failures").get<int>();
  c.ahead_s = j.at("ahead_s").get<double>();
  c.complete = j.at("complete").get<bool>();
  for (const Json& s : j.at("states")) {
    ++c.states;
    const auto found_m = s.at("found_m").get<double>(), bound_m = s.at("bound_m").get<double>();
    if (c.states > 1 && found_m / bound_m <= c.share()) continue;
    c.found_m = found_m;
    c.bound_m = bound_m;
    c.speed_mps = s.at("speed_mps").get<double>();
    c.by = s.at("by").get<std::string>();
  }
  return c;
}

constexpr double mm_per_m = 1000;

void refute(const Conservatism& c, verify::Decision& d) {
  if (!c.why_not.empty() || c.found_m <= c.bound_m + rounding_m) return;
  for (verify::Obligation& o : d.obligations) {
    if (o.kind != verify::Kind::p3 || o.monitor != c.monitor) continue;
    if (o.status == verify::Status::acknowledged) return;
    o.status = verify::Status::refuted;
    o.method = c.by;
    o.because = "from a state that just passes, a motion within the limits goes " +
                std::to_string(std::lround(mm_per_m * (c.found_m - c.bound_m))) + " mm too far";
    o.claims.clear();
  }
}

void take(const std::string& said, verify::Report& report) {
  std::istringstream lines(said);
  std::string line;
  while (std::getline(lines, line)) {
    const Json j = Json::parse(line);
    for (verify::Decision& d : report.decisions) {
      if (d.name != j.at("decision").get<std::string>()) continue;
      for (const Json& m : j.at("monitors")) {
        d.conservatism.push_back(conservatism_of(m));
        refute(d.conservatism.back(), d);
      }
    }
  }
}

}  // namespace

void leave_unmeasured(verify::Report& report, const std::string& why) {
  for (verify::Decision& d : report.decisions) {
    d.conservatism.clear();
    std::string monitor;
    for (const verify::Obligation& o : d.obligations) {
      if (o.monitor.empty() || o.kind == verify::Kind::keeps || o.monitor == monitor) continue;
      monitor = o.monitor;
      Conservatism c;
      c.monitor = monitor;
      c.why_not = why;
      d.conservatism.push_back(std::move(c));
    }
  }
}

void measure_conservatism(Simulator& simulator, Compilation& c, verify::Report& report) {
  std::string said;
  try {
    if (simulator.run({"--measure", "conservatism"}, c, said) == exit_clean) {
      take(said, report);
      return;
    }
    leave_unmeasured(report, "the simulator has failed");
  } catch (const Json::exception&) {
    leave_unmeasured(report, "`rtac-sim` is of another version");
  }
}

}  // namespace rtac::driver
