// Random traces of three robots and of plain inputs, for replays: samples are missing, late, no
// numbers, off the grid and beyond their ranges, and ticks are missed.
#pragma once

#include <map>
#include <random>
#include <string>
#include <vector>

namespace rtac::differential {

// A row is whole when every robot has sensed all that it can, at rest.
struct FleetTrace {
  std::string text;
  std::vector<bool> whole;  // by row
};

// The robots of the traces, and two of their controllers; `field` is a zone of the specification.
inline constexpr const char* quads = R"(robot Quad {
  body   radius 10.05 cm;
  motion point { speed <= 0.5 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense  position : point  error 1 cm   max_age 100 ms;
  sense  velocity : vector error 1 cm/s max_age 100 ms;
  sense  battery  : ratio  error 1 %    max_age 200 ms;
  hears  other robots max_age 150 ms, present;
  output thrust : acceleration;
  latency 20 ms;
  energy { drive <= 0.5 %/m; idle <= 0.01 %/s; drain <= 0.2 %/s; charge >= 1 %/s at home; held <= 30 s; detour <= 1 m; }
}
fleet q1, q2, q3 : Quad;
site home = (-1 m, -1 m);
zone nest = rectangle (-2.3 m, -2.3 m) to (-0.4 m, -0.4 m);  // within all zones of the monitors
controller policy  : advanced for Quad extern;
controller inwards : safe for Quad = retreat within nest speed 0.2 m/s;
)";

// Of robots q1, q2 and q3 of an open fleet, which sense position, velocity and battery, within 4 m
// of the origin; inputs `permit : bool`, `load : real` of 0 .. 11 and `mode` of idle and busy; a
// period of 50 ms.
class FleetTracer {
 public:
  explicit FleetTracer(std::uint32_t seed) : random_(seed) {}
  FleetTrace trace(int rows);

 private:
  bool chance(unsigned one_in) { return random_() % one_in == 0; }
  double uniform(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }
  std::string number(double value);
  std::string coordinate();
  std::string charge();
  std::string at_rest();
  std::string sometimes(const std::string& value);
  std::string any();
  std::mt19937 random_;
};

// The findings of a replay: cells by row and name of the column.
using FindingRow = std::map<std::string, std::string>;
using FindingTable = std::vector<FindingRow>;
FindingTable finding_table(const std::string& text);

}  // namespace rtac::differential
