// Habits of other languages: one error each, at the foreign word, whose help says what works here.
#include <gtest/gtest.h>

#include "tests/compiler/syntax/syntax_test_util.h"

namespace rtac::syntax {
namespace {

struct Case {
  std::string written, at, help;
};

void expect_help(const Case& each, const std::string& text) {
  Parsed parsed{text};
  ASSERT_EQ(parsed.engine.all().size(), 1U) << parsed.messages();
  const diag::Diagnostic& report = parsed.engine.all().front();
  EXPECT_EQ(parsed.sources.text(*report.range), each.at) << parsed.messages();
  std::string help = report.help;
  for (const diag::FixIt& fix : report.fixits) help += " fix:" + fix.replacement;
  EXPECT_NE(help.find(each.help), std::string::npos) << parsed.messages();
}

std::string monitor(const std::string& property) {
  return "spec d;\ninput open : bool;\nmonitor m { \"R\" always " + property + "; }\n";
}

// Operators of future time, and other names of those of the past.
TEST(Foreign, OperatorsOfTemporalLogic) {
  for (const Case& each : {
           Case{"eventually[0 s, 2 s] open", "eventually", "`once[0 s, 2 s] x`"},
           Case{"open implies F moving", "F", "`x within 2 s of y`"},
           Case{"G open", "G", "`historically[0 s, 2 s] x`"},
           Case{"open and globally moving", "globally", "`historically[0 s, 2 s] x`"},
           Case{"not always open", "always", "`historically[0 s, 2 s] x`"},
           Case{"not next open", "next", "`previously x`"},
           Case{"open until moving", "until", "`x since y`"},
           Case{"open within 2 s after moving", "after", "`x within 2 s of y`"},
           Case{"since[0 s, 1 s](open, moving)", "since", "`moving since[0 s, 2 s] started`"},
       }) {
    SCOPED_TRACE(each.written);
    expect_help(each, monitor(each.written));
  }
}

TEST(Foreign, SignsOfOtherLanguages) {
  for (const Case& each : {
           Case{"speed**2 <= 1 m^2/s^2", "*", "`x * x`"},
           Case{"gear == Gear::park", ":", "`Gear.park`"},
           Case{"gear == \"park\"", "\"park\"", "without quotes"},
           Case{"gear = park", "=", "`==` compares"},
           Case{"gear is park", "is", "`==`"},
       }) {
    SCOPED_TRACE(each.written);
    expect_help(each, monitor(each.written));
  }
}

TEST(Foreign, ItemsOfOtherLanguages) {
  for (const Case& each : {
           Case{"const K = 3 m;", "const", "`param gap"},
           Case{"def f(a : bool) : bool = a;", "def", "`fun slow"},
           Case{"var x : bool;", "var", "`input open : bool;`"},
           Case{"property p = open;", "property", "`monitor calm"},
           Case{"output y : bool;", "output", "what monitors find is their output"},
           Case{"input door-open : bool;", "-", "`door_open`"},
           Case{"fun f(a : bool) -> bool = a;", "->", ":"},
           Case{"input x : real [m] max_age 1 s in 0 m .. 1 m;", "in", "stand in this order"},
       }) {
    SCOPED_TRACE(each.written);
    expect_help(each, "spec d;\n" + each.written + "\n");
  }
}

TEST(Foreign, ClausesOfOtherLanguages) {
  expect_help({"", "never", "`always not x`"},
              "spec d;\ninput x : bool;\nmonitor m { \"R\" never x; }\n");
}

// A monitor without a robot is shown one, not a fence.
TEST(Foreign, RecoveriesKnowZonesByTheirNames) {
  const std::string back = "spec d;\ncontroller back : safe for Cart = ";
  expect_help({"", "-", "`zone inner = room - grow(pit, 10 cm);`"},
              back + "retreat within room - grow(pit, 10 cm) speed 0.1 m/s;");
  expect_help({"", "&", "`zone inner = room & hall;`, `within inner`"},
              back + "route to dock within room & hall speed 0.1 m/s;");
  expect_help({"", "(", "`zone inner = shrink(room, 1 m);`"},
              back + "loiter within shrink(room, 1 m) speed 0.1 m/s;");
  expect_help({"", "|", "`zone inner = room | hall;`"}, back + "yield within room | hall;");
  // what cannot be told as it is written
  expect_help({"", "-", "`zone inner = shrink(yard, 10 cm);`"},
              back + "retreat within room -\n hall speed 0.1 m/s;");
  Parsed landing{back + "land to 2 m (slowly) speed 0.1 m/s;"};
  EXPECT_EQ(landing.messages().find("zone inner"), std::string::npos) << landing.messages();
}

TEST(Foreign, ExamplesSuitTheMonitor) {
  expect_help({"", ";", "`always speed <= 1 m/s;`"}, monitor("open or"));
  expect_help({"", ";", "`always r inside room;`"},
              "spec d;\nmonitor m for r : K { \"R\" always r inside a or; recover b; }\n");
}

// Such words are names like others where nothing is wrong.
TEST(Foreign, WordsAreNames) {
  Parsed parsed{"spec d;\ninput next, until, G : bool;\nmonitor m { \"R\" always next or G; }\n"};
  EXPECT_EQ(parsed.messages(), "");
}

}  // namespace
}  // namespace rtac::syntax
