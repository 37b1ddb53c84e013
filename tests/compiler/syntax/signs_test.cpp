// One sign for another, and brackets that are missing or too many: one error, whose fix-it gives
// what was meant.
#include "compiler/syntax/signs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "tests/compiler/syntax/syntax_test_util.h"

namespace rtac::syntax {
namespace {

std::string mended(const std::string& text, std::vector<diag::FixIt> fixits) {
  std::sort(fixits.begin(), fixits.end(),
            [](const auto& a, const auto& b) { return a.range.begin > b.range.begin; });
  std::string result = text;
  for (const diag::FixIt& each : fixits) {
    result.replace(each.range.begin, each.range.end - each.range.begin, each.replacement);
  }
  return result;
}

struct Case {
  const char* written;
  const char* meant;
};

void expect_mended(const std::vector<Case>& cases) {
  for (const Case& each : cases) {
    SCOPED_TRACE(each.written);
    const Parsed parsed{each.written};
    ASSERT_EQ(parsed.engine.error_count(), 1) << parsed.messages();
    EXPECT_EQ(mended(each.written, parsed.engine.all()[0].fixits), each.meant);
    EXPECT_EQ(Parsed{each.meant}.messages(), "");
  }
}

TEST(Signs, BracketsOfAnotherKind) {
  expect_mended({
      {"enum G { a, b (\ninput p : bool;", "enum G { a, b }\ninput p : bool;"},
      {"enum G { a, b )\ninput p : bool;", "enum G { a, b }\ninput p : bool;"},
      {"enum G ( a, b )\ninput p : bool;", "enum G { a, b }\ninput p : bool;"},
      {"enum G [ a, b }\ninput p : bool;", "enum G { a, b }\ninput p : bool;"},
      {"monitor m ( \"R1\" always p; }", "monitor m { \"R1\" always p; }"},
      {"monitor m { \"R1\" always p; ]", "monitor m { \"R1\" always p; }"},
      {"monitor m { always once{0 s, 2 s] p; }", "monitor m { always once[0 s, 2 s] p; }"},
      {"monitor m { always once[0 s, 2 s) p; }", "monitor m { always once[0 s, 2 s] p; }"},
      {"monitor m { always abs(rate{0 s, 1 s](v)) <= 1; }",
       "monitor m { always abs(rate[0 s, 1 s](v)) <= 1; }"},
      {"monitor m { always age[v) <= 1 s; }", "monitor m { always age(v) <= 1 s; }"},
      {"monitor m { always distance[p, q] <= 1 m; }",
       "monitor m { always distance(p, q) <= 1 m; }"},
      {"input w : path(16) max_age 1 s;", "input w : path[16] max_age 1 s;"},
      {"monitor m { always p implies {a or b} and c; }",
       "monitor m { always p implies (a or b) and c; }"},
      {"robot T { motion point { speed <= 1 m/s; ]\n  latency 1 ms;\n}",
       "robot T { motion point { speed <= 1 m/s; }\n  latency 1 ms;\n}"},
  });
}

TEST(Signs, OfAnotherKind) {
  expect_mended({
      {"input f ; zone[8];", "input f : zone[8];"},
      {"input f = bool;", "input f : bool;"},
      {"param h ; length in 0 m .. 1 m = 1 m;", "param h : length in 0 m .. 1 m = 1 m;"},
      {"zone a : b;", "zone a = b;"},
      {"monitor m { \"R1: x\" always p; ;\nmonitor n { always q; }",
       "monitor m { \"R1: x\" always p; }\nmonitor n { always q; }"},
      {"monitor m { always p;\n;\nmonitor n { always q; }",
       "monitor m { always p;\n}\nmonitor n { always q; }"},
      {"monitor m { always p, }", "monitor m { always p; }"},
      {"monitor m { always age(v; >= 5 ms; }", "monitor m { always age(v) >= 5 ms; }"},
      {"monitor m { always (p and q; or s; }", "monitor m { always (p and q) or s; }"},
      {"monitor m { always once[0 s : 2 s] p; }", "monitor m { always once[0 s , 2 s] p; }"},
      {"monitor m for r : K { always p; ahead 1 s, 2 waypoints,\n  recover s; }",
       "monitor m for r : K { always p; ahead 1 s, 2 waypoints;\n  recover s; }"},
      {"robot T { motion point { speed <= 1 m/s} accel <= 1 m/s^2; } latency 1 ms; }",
       "robot T { motion point { speed <= 1 m/s; accel <= 1 m/s^2; } latency 1 ms; }"},
      {"robot T { energy { idle <= 1 %/s; charge } 2 %/s at dock; } }",
       "robot T { energy { idle <= 1 %/s; charge >= 2 %/s at dock; } }"},
  });
}

TEST(Signs, BracketsAtTheirPlaces) {
  expect_mended({
      {"monitor m { always distance(p, q <= 2 m; }", "monitor m { always distance(p, q) <= 2 m; }"},
      {"monitor m { always b >= energy_to(dock(r) + 5 %; }",
       "monitor m { always b >= energy_to(dock(r)) + 5 %; }"},
      {"monitor m { always count[0 s, 9 s](p <= 5; }",
       "monitor m { always count[0 s, 9 s](p) <= 5; }"},
      {"monitor m { always abs(rate[0 s, 1 s](v) <= 8 and p; }",
       "monitor m { always abs(rate[0 s, 1 s](v)) <= 8 and p; }"},
      {"monitor m { always min(q : K, q != r : distance(r, q) >= 1 m; }",
       "monitor m { always min(q : K, q != r : distance(r, q)) >= 1 m; }"},
      {"monitor m { always distance((p, q) <= 2 m; }",
       "monitor m { always distance(p, q) <= 2 m; }"},
      {"monitor m { always slow((top, 2 m/s); }", "monitor m { always slow(top, 2 m/s); }"},
      {"monitor m { always abs(distance((p, q)) <= 2 m; }",
       "monitor m { always abs(distance(p, q)) <= 2 m; }"},
      {"zone a = rectangle ((0 m, 0 m) to (3 m, 3 m);",
       "zone a = rectangle (0 m, 0 m) to (3 m, 3 m);"},
      {"zone a = shrink((rectangle (0 m, 0 m) to (3 m, 3 m), 1 m);",
       "zone a = shrink(rectangle (0 m, 0 m) to (3 m, 3 m), 1 m);"},
      // a point by its coordinates, and terms, keep both
      {"monitor m { always free((1 m, 2 m); }", "monitor m { always free((1 m, 2 m)); }"},
      {"monitor m { always norm((x, y) <= 1 m; }", "monitor m { always norm((x, y)) <= 1 m; }"},
      {"monitor m { always abs((a - b) * 2 <= 1 m; }",
       "monitor m { always abs((a - b) * 2) <= 1 m; }"},
      {"monitor m { always ((p or q) and s; }", "monitor m { always ((p or q) and s); }"},
  });
}

TEST(Signs, OfBoundsFollowTheirNames) {
  expect_mended({
      {"robot T { motion point { speed => 1 m/s; brake >= 1 m/s^2; } }",
       "robot T { motion point { speed <= 1 m/s; brake >= 1 m/s^2; } }"},
      {"robot T { motion point { speed <= 1 m/s; brake =< 1 m/s^2; } }",
       "robot T { motion point { speed <= 1 m/s; brake >= 1 m/s^2; } }"},
      {"robot T { energy { charge \u2264 1 %/s at dock; } }",
       "robot T { energy { charge >= 1 %/s at dock; } }"},
      {"monitor m { always v => 1 m/s; }", "monitor m { always v >= 1 m/s; }"},
  });
}

TEST(Signs, DecimalsStandBehindAPoint) {
  expect_mended({
      {"origin 47,3977 deg, 8.5456 deg;", "origin 47.3977 deg, 8.5456 deg;"},
      {"zone a = circle (0,5 m, 1 m) radius 2 m;", "zone a = circle (0.5 m, 1 m) radius 2 m;"},
      {"input v : point in 0 .. 3 m error 0,5 cm;", "input v : point in 0 .. 3 m error 0.5 cm;"},
      {"monitor m { always v <= 1,5 m/s; }", "monitor m { always v <= 1.5 m/s; }"},
  });
  // two values
  for (const char* text :
       {"monitor m { always wait(3,5 s); }", "zone a = circle (0,5 m) radius 2 m;",
        "monitor m { always once[0,5 s] p; }"}) {
    EXPECT_EQ(Parsed{text}.messages(), "");
  }
}

TEST(Signs, UnitsStandBehindNumbers) {
  expect_mended({
      {"monitor m { always v <= limit m/s; }", "monitor m { always v <= limit; }"},
      {"monitor m { always v <= 2 * limit m/s^2 and p; }",
       "monitor m { always v <= 2 * limit and p; }"},
      {"monitor m { always abs(v) m <= 3 m; }", "monitor m { always abs(v) <= 3 m; }"},
  });
}

TEST(Signs, KeepWordsApart) {
  expect_mended({{"monitor m { always p)and q; }", "monitor m { always p and q; }"}});
}

// The number that is due is the author's to say: leaving out the sign would leave a unit alone.
TEST(Signs, NumbersThatAreMissing) {
  for (const char* text : {"monitor m { always v <= ; m/s; }", "input v : speed in 0 .. ) m/s;",
                           "robot T { motion point { brake >= ; m/s^2; } }",
                           "monitor m { always v <= ; m/s and p; }"}) {
    const Parsed parsed{text};
    ASSERT_EQ(parsed.engine.error_count(), 1) << parsed.messages();
    EXPECT_TRUE(parsed.engine.all()[0].fixits.empty()) << parsed.messages();
    EXPECT_EQ(
        parsed.engine.all()[0].help.rfind("write the number that is meant, such as `3 m/s", 0), 0U)
        << parsed.messages();
  }
}

// A sign that may stand for something is not taken away.
TEST(Signs, ThatMayStandForSomething) {
  for (const char* text :
       {"monitor m {\n  = always p; }", "monitor m {\n  ;\n  always p; }", "period 100 );",
        "; warm { always p; }", "zone a = ; (0 m, 0 m) to (5 m, 5 m);", "input v : real [m/];",
        "input v : real [m] in 0 .. 3 m error 1 cm 100 ms;", "monitor m { always (v 3 m); }"}) {
    const Parsed parsed{text};
    ASSERT_EQ(parsed.engine.error_count(), 1) << parsed.messages();
    EXPECT_TRUE(parsed.engine.all()[0].fixits.empty()) << parsed.messages();
  }
}

// A number behind an operand ends no clause.
TEST(Signs, OperatorsThatAreMissing) {
  for (const char* text :
       {"monitor m { always v 2 m/s; }", "monitor m { always p and v 2 m/s; }",
        "monitor m { always if p then v 1 m/s else q; }", "monitor m { always (v 3 m); }"}) {
    const Parsed parsed{text};
    ASSERT_EQ(parsed.engine.error_count(), 1) << parsed.messages();
    const auto& found = parsed.engine.all()[0];
    EXPECT_EQ(found.message.rfind("expected an operator after `v`", 0), 0U) << parsed.messages();
    EXPECT_TRUE(found.fixits.empty()) << parsed.messages();
  }
}

TEST(Signs, CommentsInUnits) {
  for (const char* text : {"input v : speed in 0 .. 3 m//s error 1 cm/s;\ninput p : bool;",
                           "robot T {\n  motion point { speed <= 4 m//s; }\n  latency 1 ms;\n}",
                           "monitor m { always v <= 3 m//s; }\nmonitor n { always p; }"}) {
    const Parsed parsed{text};
    ASSERT_EQ(parsed.engine.error_count(), 1) << parsed.messages();
    EXPECT_EQ(Parsed{mended(text, parsed.engine.all()[0].fixits)}.messages(), "");
  }
}

TEST(Signs, BraceBehindTheName) {
  expect_mended({{"spec a{\nmonitor m { always p; }", "spec a;\nmonitor m { always p; }"}});
}

// Sema knows the units; what repairs take for one behind a name must be all of them.
TEST(Signs, KnowEveryUnit) {
  std::ifstream file(RTAC_SOURCE_DIR "/compiler/sema/units.cpp");
  const std::string units{std::istreambuf_iterator<char>(file), {}};
  const std::size_t table = units.find("table = {");
  ASSERT_NE(table, std::string::npos);
  const std::string entries = units.substr(table, units.find("};", table) - table);
  const std::regex entry(R"re(\n\s+\{"([A-Za-z]+)",)re");
  const std::sregex_iterator end;
  int count = 0;
  for (std::sregex_iterator each(entries.begin(), entries.end(), entry); each != end; ++each) {
    EXPECT_TRUE(is_unit_word((*each)[1].str())) << (*each)[1].str();
    ++count;
  }
  EXPECT_GE(count, 25);
}

}  // namespace
}  // namespace rtac::syntax
