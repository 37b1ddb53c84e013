// rtac_bench [--json FILE] [--quick] [--only
// step|fleet|simulation|watch|compiler|geometry|zones|kills|shares]
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

#include "rtac/sim/picture.h"
#include "tests/bench/benchmarks.h"

namespace {

struct Arguments {
  std::string json, only;
  rtac::bench::Effort effort;
  bool good = true;
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  for (int i = 1; i < argc && a.good; ++i) {
    const std::string flag = argv[i];
    if (flag == "--quick") {
      a.effort = {3, 1, 4, 2, 3, 2'000, 2, 9, 1, 30};
    } else if (flag == "--json" && i + 1 < argc) {
      a.json = argv[++i];
    } else if (flag == "--only" && i + 1 < argc) {
      a.only = argv[++i];
      a.good = a.only == "step" || a.only == "fleet" || a.only == "simulation" ||
               a.only == "watch" || a.only == "compiler" || a.only == "geometry" ||
               a.only == "zones" || a.only == "kills" || a.only == "shares";
    } else {
      a.good = false;
    }
    if (!a.good) {
      std::cerr << "rtac_bench: cannot make sense of `" << argv[i] << "`\n"
                << "usage: rtac_bench [--json FILE] [--quick] [--only "
                   "step|fleet|simulation|watch|compiler|geometry|zones|kills|shares]\n";
    }
  }
  return a;
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments a = parse(argc, argv);
  if (!a.good) return 2;
  const auto wanted = [&](const char* group) { return a.only.empty() || a.only == group; };
  rtac::bench::Report report;
  bool measured = true;
  if (wanted("step")) {
    const rtac::bench::StepSubject study{"step", "delivery", "3"};
    measured = rtac::bench::measure_steps(study, a.effort, report) && measured;
    measured = rtac::bench::measure_hundred(a.effort, report) && measured;
  }
  if (wanted("fleet")) measured = rtac::bench::measure_fleets(a.effort, report) && measured;
  if (wanted("simulation"))
    measured = rtac::bench::measure_simulation(a.effort, report) && measured;
  if (wanted("watch")) measured = rtac::bench::measure_watch(a.effort, report) && measured;
  if (wanted("compiler")) measured = rtac::bench::measure_compiler(a.effort, report) && measured;
  // Before `zones`: children start with the memory that is in use.
  if (wanted("geometry")) measured = rtac::bench::measure_geometry(a.effort, report) && measured;
  if (wanted("zones")) measured = rtac::bench::measure_zones(a.effort, report) && measured;
  if (wanted("kills")) measured = rtac::bench::measure_kills(a.effort, report) && measured;
  if (wanted("shares")) measured = rtac::bench::measure_shares(a.effort, report) && measured;
  std::cout << report.text();
  if (!a.json.empty() && !rtac::sim::write_text_file(a.json, report.json())) {
    std::cerr << "rtac_bench: cannot write `" << a.json << "`\n";
    return 2;
  }
  return measured ? 0 : 1;
}
