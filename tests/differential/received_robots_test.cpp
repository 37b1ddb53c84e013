// Robots that are held against zones that are received: what the kernel finds of a property now
// against what it is on exact numbers, and what it finds within reach against what it finds of the
// same zone when that is compiled in. Zones come, change and grow too old, on the grid and off it;
// samples are missing, late, and no numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "compiler/support/rational.h"
#include "tests/compiler/driver/testing.h"
#include "tests/differential/fleet_trace.h"

namespace rtac::differential {
namespace {

using driver::test::Outcome;
using driver::test::rtac;

const std::string robot_and_controllers = R"(spec flyer;
robot Quad {
  body   radius 10.05 cm;
  motion point { speed <= 2 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense  position : point  error 1 cm   max_age 100 ms;
  sense  velocity : vector error 1 cm/s max_age 100 ms;
  output thrust : acceleration;
  latency 20 ms;
}
fleet q : Quad;
controller policy : advanced for Quad extern;
controller stop   : safe for Quad = brake_and_hold;
)";
// Those that keep it in, and those that keep it out.
const std::string in = R"(
monitor stays for r : Quad { "R1: in" always r inside fence; recover stop; hold when violated "a test"; }
monitor clear for r : Quad { "R2: well in" always 2 * clearance(r, fence) >= 30 cm; ahead 200 ms; recover stop; hold when violated "a test"; }
)";
const std::string out = R"(
monitor leaves for r : Quad { "R3: out" always distance(r, fence) >= 10 cm; recover stop; hold when violated "a test"; return when distance(r, fence) > 20 cm for 100 ms; }
monitor either for r : Quad { "R4: well out or slow" always distance(r, fence) >= 50 cm or r.speed <= 50 cm/s; recover stop; hold when violated "a test"; }
)";
std::string flyer(const std::string& monitors, const std::string& order, const std::string& fence) {
  return robot_and_controllers + monitors +
         "decision fly for Quad { advanced policy; period 50 ms; priority " + order + "; }\n" +
         fence + "\n";
}
const std::vector<std::string> names = {"stays", "clear", "leaves", "either"};

class ReceivedByRobots : public driver::test::InFolder,
                         public ::testing::WithParamInterface<unsigned> {
 protected:
  double any(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool chance(unsigned one_in) { return random_() % one_in == 0; }
  static std::string decimal(double value, int digits) {
    unsigned long unit = 1;
    for (int i = 0; i < digits; ++i) unit *= 10;
    Rational rounded(std::lround(value * static_cast<double>(unit)), unit);
    rounded.canonicalize();
    return to_decimal(rounded);
  }
  // The corners of a star about a place, in metres: on the grid of 1 mm, or anywhere.
  void star(bool on_grid, int count, double size) {
    const int digits = on_grid ? 3 : 6;
    const double x = any(-4, 4), y = any(-4, 4);
    corners_.clear();
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * 3.14159265358979 * (i + any(0, 0.7)) / count;
      const double radius = any(0.4, 1) * size;
      corners_.emplace_back(decimal(x + radius * std::cos(angle), digits),
                            decimal(y + radius * std::sin(angle), digits));
    }
  }
  std::string wkt() const {
    std::string text;
    for (const auto& [x, y] : corners_) text += x + " " + y + ", ";
    return "\"POLYGON ((" + text + corners_[0].first + " " + corners_[0].second + "))\"";
  }
  std::string polygon() const {
    std::string text;
    for (const auto& [x, y] : corners_) {
      text += (text.empty() ? "(" : ", (") + x + " m, " + y + " m)";
    }
    return "polygon [" + text + "]";
  }
  // At rest or not; near a corner, near the boundary, or anywhere.
  std::string robot() {
    double x = any(-8, 8), y = any(-8, 8);
    if (!corners_.empty() && !chance(3)) {
      const std::size_t i = random_() % corners_.size(), j = (i + 1) % corners_.size();
      const double t = static_cast<double>(random_() % 5) / 4, off = chance(2) ? 0.3 : 0.02;
      const auto between = [&](const std::string& a, const std::string& b) {
        return std::stod(a) + t * (std::stod(b) - std::stod(a)) + any(-off, off);
      };
      x = between(corners_[i].first, corners_[j].first);
      y = between(corners_[i].second, corners_[j].second);
    }
    const int digits = chance(4) ? 6 : 3;
    std::string cells = decimal(x, digits) + "," + decimal(y, digits);
    if (chance(25)) cells = "nan,1";
    if (chance(25)) cells = ",";
    const double speed = chance(2) ? 0 : 1.4;
    return cells + "," + decimal(any(-speed, speed), 3) + "," + decimal(any(-speed, speed), 3);
  }

  void compare(const std::string& monitor, FindingRow& exact, FindingRow& found) {
    for (const char* const field : {".verdict", ".return"}) {
      const auto cell = found.find(monitor + field);
      if (cell == found.end()) continue;
      ++of_[monitor + field + " " + cell->second];
      if (cell->second == "unknown") continue;
      EXPECT_EQ(exact[monitor + field], cell->second) << field;
    }
    // The property fails only where the look-ahead does.
    if (found[monitor + ".ahead"] == "true") {
      EXPECT_EQ(exact[monitor + ".verdict"], "true");
      ++of_[monitor + " ahead"];
    }
    if (exact[monitor + ".unit"] != found[monitor + ".unit"]) return;
    const double below =
        std::stod(exact[monitor + ".margin"]) - std::stod(found[monitor + ".margin"]);
    if (std::isnan(below)) return;  // both infinite
    EXPECT_GT(below, -1e-9);
  }
  std::mt19937 random_{GetParam()};
  std::vector<std::pair<std::string, std::string>> corners_;
  std::map<std::string, int> of_;
};

const std::string head = "time,q.position.x,q.position.y,q.velocity.x,q.velocity.y,fence\n";

TEST_P(ReceivedByRobots, AreJudgedConservativelyAndTightly) {
  constexpr int rows = 3000;
  std::string text = head;
  std::int64_t now_ms = 0;
  for (int row = 0; row < rows; ++row) {
    now_ms += chance(40) ? std::lround(any(100, 2500)) : 50;  // at times steps are missed
    std::string zone;
    if (row > 20 && chance(30)) {
      star(chance(2), 3 + static_cast<int>(random_() % 30), any(1, 8));
      zone = wkt();
    }
    text += decimal(static_cast<double>(now_ms) / 1000, 3) + "," + robot() + "," + zone + "\n";
  }
  driver::test::write("flyer.rta", flyer(in + out, "stays > clear > leaves > either",
                                         "input fence : zone[128] max_age 2 s;"));
  driver::test::write("trace.csv", text);
  const Outcome kernel = rtac({"replay", "flyer.rta", "trace.csv"});
  const Outcome reference = rtac({"replay", "flyer.rta", "trace.csv", "--engine", "interp"});
  ASSERT_EQ(kernel.err + reference.err, "");
  FindingTable found = finding_table(kernel.out), exact = finding_table(reference.out);
  ASSERT_GT(found.size(), rows / 2U);
  ASSERT_EQ(exact.size(), found.size());
  for (std::size_t row = 0; row < exact.size(); ++row) {
    for (const std::string& monitor : names) {
      SCOPED_TRACE(monitor + " in row " + std::to_string(row) + ": exact " +
                   exact[row][monitor + ".margin"] + ", found " + found[row][monitor + ".margin"]);
      compare(monitor, exact[row], found[row]);
      if (HasFailure()) return;
    }
    // before the first one nothing is known, whatever the robot does
    if (row < 15) {
      EXPECT_EQ(found[row]["stays.verdict"], "unknown");
      EXPECT_EQ(found[row]["mode"], "stop");
    }
  }
  for (const std::string& monitor : names) {
    for (const char* const verdict : {".verdict true", ".verdict false", ".verdict unknown"}) {
      EXPECT_GT(of_[monitor + verdict], 50) << monitor << verdict;
    }
    EXPECT_GT(of_[monitor + " ahead"], 20) << monitor;
  }
}

// One zone, at the start, on the grid: its tables are those of a zone that is compiled in.
TEST_P(ReceivedByRobots, LookAheadAsOfAZoneThatIsCompiledIn) {
  constexpr int rows = 1000;
  star(true, 8 + static_cast<int>(random_() % 20), any(8, 10));
  std::string received = head, fixed = head.substr(0, head.rfind(',')) + "\n";
  std::string at;
  for (int row = 0; row < rows; ++row) {
    if (row % 5 == 0) at = robot();  // for as long as it takes until control is given back
    const std::string cells = decimal(row * 0.05, 3) + "," + at;
    received += cells + "," + (row == 0 ? wkt() : "") + "\n";
    fixed += cells + "\n";
  }
  driver::test::write("received.csv", received);
  driver::test::write("fixed.csv", fixed);
  for (const bool inside : {true, false}) {
    const std::string& monitors = inside ? in : out;
    const std::string order = inside ? "stays > clear" : "leaves > either";
    driver::test::write("received.rta",
                        flyer(monitors, order, "input fence : zone[128] max_age inf;"));
    driver::test::write("fixed.rta", flyer(monitors, order, "zone fence = " + polygon() + ";"));
    const Outcome one = rtac({"replay", "received.rta", "received.csv"});
    const Outcome other = rtac({"replay", "fixed.rta", "fixed.csv"});
    ASSERT_EQ(one.err + other.err, "");
    FindingTable is = finding_table(one.out), due = finding_table(other.out);
    ASSERT_EQ(is.size(), static_cast<std::size_t>(rows));
    ASSERT_EQ(due.size(), is.size());
    int ahead = 0, driven = 0, same = 0;
    for (std::size_t row = 0; row < is.size(); ++row) {
      SCOPED_TRACE("row " + std::to_string(row));
      for (std::size_t k = inside ? 0 : 2; k < (inside ? 2U : 4U); ++k) {
        for (const char* const field : {".verdict", ".ahead"}) {
          EXPECT_EQ(is[row][names[k] + field], due[row][names[k] + field]) << names[k] << field;
        }
        ahead += is[row][names[k] + ".ahead"] == "true" ? 1 : 0;
        same += is[row][names[k] + ".margin"] == due[row][names[k] + ".margin"] ? 1 : 0;
      }
      EXPECT_EQ(is[row]["mode"], due[row]["mode"]);
      driven += is[row]["mode"] == "policy" ? 1 : 0;
      if (HasFailure()) return;
    }
    EXPECT_GT(ahead, 100);
    EXPECT_GT(driven, 10);
    EXPECT_GT(same, rows);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ReceivedByRobots, ::testing::Values(1U, 2U, 3U));

}  // namespace
}  // namespace rtac::differential
