// The forms that the help of syntax errors shows are what an author copies: each can be parsed.
#include "compiler/syntax/forms.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/compiler/syntax/syntax_test_util.h"

namespace rtac::syntax {
namespace {

std::string in_block(const Form& form) {
  const std::string text{form.text};
  switch (form.block) {
    case Block::items:
      return text;
    case Block::robot:
      return "robot Cart { " + text + " }";
    case Block::limits:
      return "robot Cart { motion point { " + text + " } }";
    case Block::energy:
      return "robot Cart { energy { " + text + " } }";
    case Block::monitor:
      return "monitor m { " + text + " }";
    case Block::decision:
      return "decision d for Cart { " + text + " }";
    case Block::values:
      return "enum Gear { " + text + " }";
  }
  return {};
}

TEST(Forms, CanBeParsed) {
  for (const Form& form : all_forms()) {
    EXPECT_EQ(Parsed{in_block(form)}.messages(), "") << form.text;
  }
}

// A word that starts items has a form, otherwise an error behind it would show another one's.
TEST(Forms, ExistForEveryItem) {
  std::set<TokenKind> known;
  for (const Form& form : all_forms()) {
    if (form.block == Block::items) known.insert(form.first);
  }
  for (const Word& word : all_words()) {
    if (word.word_kind != WordKind::item && word.word_kind != WordKind::soft) continue;
    EXPECT_TRUE(known.count(word.kind)) << word.text;
  }
}

std::string help_of(const std::string& text) {
  Parsed parsed{text};
  return parsed.engine.all().empty() ? "no report" : parsed.engine.all().front().help;
}

// What is shown is the form of the construct, the clause or the block that the mistake stands in.
TEST(Forms, AreThoseOfTheMistake) {
  EXPECT_EQ(help_of("zone z = ;"), "the form is `zone room = rectangle (0 m, 0 m) to (5 m, 5 m);`");
  EXPECT_EQ(help_of("zone z = circle (1 m, 1 m) ;"), "the form is `circle (1 m, 1 m) radius 2 m`");
  EXPECT_EQ(help_of("zone z = room minus pillar;"),
            "the form is `zone free = shrink(room, 30 cm) - pillar;`");
  EXPECT_EQ(help_of("controller c : safe for Cart = route ;"),
            "the form is `route to dock within free speed 0.1 m/s`");
  EXPECT_EQ(help_of("controller c : safe for K = land speed 0.5 m/s;"),
            "the form is `land to 0 m speed 0.5 m/s`");
  EXPECT_EQ(
      help_of("controller c : safe for Cart = extern keeps inside z speed <= 1 m/s;"),
      "the form is `controller bought : safe for Cart extern keeps inside room speed <= 1 m/s;`");
  EXPECT_EQ(help_of("controller c : safe for Cart = sequence retreat within z speed 0.4 m/s;"),
            "the form is `controller calm : safe for Cart = sequence brake_and_hold for 2 s then "
            "retreat within room speed 0.4 m/s;`");
  EXPECT_EQ(help_of("controller c : advanced for Cart;"),
            "the form is `controller pilot : advanced for Cart extern;`");
  EXPECT_EQ(help_of("robot Cart {\n  latency ;\n}"), "the form is `latency 40 ms;`");
  EXPECT_EQ(help_of("robot Cart {\n  motion point { speed 1 m/s; }\n}"),
            "the form is `speed <= 1 m/s;`");
  EXPECT_EQ(help_of("robot Cart {\n  energy { drive 1 %/m; }\n}"),
            "the form is `drive <= 0.4 %/m;`");
  EXPECT_EQ(help_of("monitor m for r : Cart {\n  \"text\"\n  12;\n}"),
            "a clause looks like `always r inside room;`");
  EXPECT_EQ(help_of("monitor m {\n  \"text\"\n  12;\n}"),
            "a clause looks like `always speed <= 1 m/s;`");
  EXPECT_EQ(help_of("input x : real in 0 .. ;"),
            "the form is `input speed : real [m/s] in 0 .. 3 m/s error 1 cm/s max_age 100 ms;`");
  EXPECT_EQ(help_of("enum Gear { park 3 }"), "the form is `park, drive, reverse`");
  EXPECT_EQ(help_of("fun f(x) : bool = x;"),
            "the form is `fun slow(v : real [m/s]) : bool = v <= 1 m/s;`");
  EXPECT_EQ(help_of("assume x unchecked;"),
            "the form is `assume gear == park unchecked \"bench test\";`");
  EXPECT_EQ(help_of("12;"),
            "an item looks like `input open : bool;` or `zone room = rectangle (0 m, 0 m) to (5 m, "
            "5 m);`");
}

// What an operand is part of may lack its next word: the form is that of the construct.
TEST(Forms, AreThoseOfTheOperatorThatIsOpen) {
  const auto help_in = [](const std::string& condition) {
    return help_of("monitor m { always " + condition + "; }");
  };
  EXPECT_EQ(help_in("once[0 s] a"), "the form is `once[0 s, 2 s] open`");
  EXPECT_EQ(help_in("a since[0 s] b"), "the form is `moving since[0 s, 2 s] started`");
  EXPECT_EQ(help_in("a since"), "the form is `moving since[0 s, 2 s] started`");
  EXPECT_EQ(help_in("min[0 s, 1 s] <= 1 m"), "the form is `mean[0 s, 1 s](speed)`");
  EXPECT_EQ(help_in("a since b[0 s, 1 s]"),
            "the form is `moving since[0 s, 2 s] started` or `mean[0 s, 1 s](speed)`");
  EXPECT_EQ(help_in("once mean[0 s, 1 s] <= 1 m"),
            "the form is `once[0 s, 2 s] open` or `mean[0 s, 1 s](speed)`");
  EXPECT_EQ(help_in("if a then b"), "the form is `if open then 1 m/s else 2 m/s`");
  EXPECT_EQ(help_in("let x = 1 m"), "the form is `let gap = p.x - q.x in abs(gap) >= 1 m`");
}

}  // namespace
}  // namespace rtac::syntax
