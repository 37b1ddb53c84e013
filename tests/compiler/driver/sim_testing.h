// Tests of `rtac sim` on specifications with a yard.
#pragma once

#include <cstdlib>
#include <string>

#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {

// A rover whose look-ahead is `ahead`, in a yard of its own.
inline std::string yard(const std::string& ahead, const std::string& always = "r inside yard") {
  return R"(spec yard_patrol;
zone yard = rectangle (0 m, 0 m) to (8 m, 8 m);
robot Rover {
  body     radius 20 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 2 cm    max_age 50 ms;
  sense    velocity : vector  error 2 cm/s  max_age 50 ms;
  hears    other robots       max_age 100 ms;
  input    plan : path[4]     tracking <= 10 cm;
  output   thrust : acceleration;
  latency  20 ms;
}
fleet r1, r2 : Rover;
controller patrol    : advanced for Rover extern;
controller turn_back : safe for Rover = retreat within yard speed 0.3 m/s;
monitor fence for r : Rover { "R1: it stays in the yard" always )" +
         always + "; ahead " + ahead + R"(; recover turn_back; }
decision drive for Rover { advanced patrol; period 50 ms; priority fence; }
)";
}
// A pillar stands in the yard, and the recovery knows of it.
inline std::string with_pillar(const std::string& always) {
  const std::string zones =
      "zone pillar = rectangle (3 m, 3 m) to (4 m, 4 m);\nzone free = yard - pillar;\nrobot Rover";
  return edited(edited(yard("50 ms", always), "robot Rover", zones), "within yard", "within free");
}

class Simulations : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
  void TearDown() override {
    ::unsetenv("RTAC_SIM");
    InFolder::TearDown();
  }
  // Without what depends on the machine: how many robot-hours a core-second.
  static std::string steady(const std::string& table) { return table.substr(table.find('\n')); }
  // Of a monitor's row: `name recovery drives % margin m`.
  static double least_m(const std::string& table, const std::string& row) {
    const std::size_t margin = table.find('%', table.rfind(row));
    return margin == std::string::npos ? 1e9 : std::strtod(table.c_str() + margin + 1, nullptr);
  }
  static std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
      ++found;
    }
    return found;
  }
};

}  // namespace rtac::driver::test
