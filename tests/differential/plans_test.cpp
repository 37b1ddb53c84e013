// Random plans against zones with corners and holes: what the kernel finds of a proposal against
// what it is on exact numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "tests/compiler/driver/testing.h"

namespace rtac::differential {
namespace {

using driver::test::Outcome;
using driver::test::rtac;

constexpr const char* draughts = R"(spec draughts;
zone room = rectangle (-4 m, -4 m) to (4 m, 4 m);
zone maze = polygon [(-3 m, -3 m), (3 m, -3.5 m), (1 m, 0 m), (3.5 m, 3 m), (0 m, 1.501 m), (-3.333 m, 3 m)] hole [(-1 m, -1 m), (0 m, -1 m), (-0.5 m, 0 m)];
robot Quad {
  body   radius 10 cm;
  motion point { speed <= 0.5 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense  position : point  error 1 cm   max_age 100 ms;
  sense  velocity : vector error 1 cm/s max_age 100 ms;
  input  plan : path[6] tracking <= 10 cm;
  output thrust : acceleration;
  latency 20 ms;
}
fleet q : Quad;
controller dreamer : advanced for Quad extern;
controller careful : safe for Quad extern;
monitor square for r : Quad { "R1: in" always r.plan inside room - rectangle (-1 m, -1 m) to (1 m, 1 m); }
monitor maze_ok for r : Quad { "R2: in" always r.plan inside maze; }
monitor round for r : Quad { "R3: in" always r.plan inside circle (0 m, 0 m) radius 3 m or r.plan inside shrink(maze, 10 cm); }
decision choose for Quad { advanced dreamer; safe careful; on plan; priority square > maze_ok > round; }
)";

// Legs short and long, through corners, along edges, on and off the grid, and of no length.
class Proposer {
 public:
  explicit Proposer(unsigned seed) : random_(seed) {}
  std::string trace(int rows) {
    std::string text = "time,q.plan\n";
    for (int row = 0; row < rows; ++row) text += std::to_string(row) + "," + plan() + "\n";
    return text;
  }

 private:
  std::string plan() {
    if (random_() % 40 == 0) return random_() % 2 == 0 ? "none" : "nan";
    std::string text = point();
    for (auto k = random_() % 7; k > 0; --k) text += "; " + point();
    return text;
  }
  std::string point() { return number(coordinate(0)) + " " + number(coordinate(1)); }
  double coordinate(int axis) {
    const double corners[] = {-4, 4, -1, 1, 0, 3, -3, -3.333, 1.501, -3.5};
    std::uniform_real_distribution<double> near(-0.01, 0.01), any(-4.2, 4.2), step(-0.7, 0.7);
    double& at = at_[axis];
    switch (random_() % 6) {
      case 0:
        return at = corners[random_() % 10];
      case 1:
        return at = corners[random_() % 10] + near(random_);
      case 2:
        return at = any(random_);
      case 3:
        return at;
      default:
        return at += step(random_);
    }
  }
  std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, random_() % 4 == 0 ? "%.5f" : "%.3f", value);
    return text;
  }
  std::mt19937 random_;
  double at_[2] = {-2, -2};
};

std::vector<std::vector<std::string>> table(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

class Plans : public driver::test::InFolder {};

// What the kernel has decided is so, and its margin is at most 5 mm below the exact one; of the
// choice of two zones the worse leg may be another one, so that only verdicts are compared.
TEST_F(Plans, AreJudgedConservativelyAndTightly) {
  driver::test::write("draughts.rta", draughts);
  driver::test::write("trace.csv", Proposer(7).trace(4000));
  const Outcome kernel = rtac({"replay", "draughts.rta", "trace.csv"});
  const Outcome reference = rtac({"replay", "draughts.rta", "trace.csv", "--engine", "interp"});
  ASSERT_EQ(kernel.err + reference.err, "");
  const auto found = table(kernel.out), exact = table(reference.out);
  ASSERT_EQ(found.size(), 4001U);
  ASSERT_EQ(exact.size(), found.size());
  int decided[2] = {0, 0}, open = 0;
  for (std::size_t row = 1; row < found.size(); ++row) {
    for (const std::size_t at : {2U, 5U, 8U}) {
      SCOPED_TRACE("row " + std::to_string(row) + ", " + found[0][at] + ": exact " +
                   exact[row][at + 1] + ", found " + found[row][at + 1]);
      const std::string& verdict = found[row][at];
      if (verdict == "unknown") {
        open += exact[row][at] != "unknown" ? 1 : 0;
      } else {
        ++decided[verdict == "true" ? 1 : 0];
        EXPECT_EQ(exact[row][at], verdict);
      }
      const double below = std::stod(exact[row][at + 1]) - std::stod(found[row][at + 1]);
      if (!std::isnan(below) && at != 8) {
        EXPECT_GE(below, 0);
        EXPECT_LE(below, 0.005);
      }
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(decided[0], 2000);
  EXPECT_GT(decided[1], 500);
  EXPECT_LT(open, 2000);
}

}  // namespace
}  // namespace rtac::differential
