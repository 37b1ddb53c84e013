// Words of clauses are keywords only at their places: an author may name a zone `dock` or `speed`.
#include <gtest/gtest.h>

#include "tests/compiler/syntax/syntax_test_util.h"

namespace rtac::syntax {
namespace {

constexpr const char* kClauseWords[] = {
#define RTAC_WORD(token, text, kind) RTAC_WORD_##kind(text)
#define RTAC_WORD_item(text)
#define RTAC_WORD_reserved(text)
#define RTAC_WORD_soft(text) text,
#define RTAC_WORD_clause(text) text,
#include "compiler/syntax/words.def"
#undef RTAC_WORD_clause
#undef RTAC_WORD_soft
#undef RTAC_WORD_reserved
#undef RTAC_WORD_item
};
constexpr const char* kReservedWords[] = {
#define RTAC_WORD_item(text) text,
#define RTAC_WORD_reserved(text) text,
#define RTAC_WORD_soft(text)
#define RTAC_WORD_clause(text)
#include "compiler/syntax/words.def"
#undef RTAC_WORD_clause
#undef RTAC_WORD_soft
#undef RTAC_WORD_reserved
#undef RTAC_WORD_item
#undef RTAC_WORD
};

class ClauseWord : public testing::TestWithParam<const char*> {};

// Every place where a name may stand.
TEST_P(ClauseWord, IsANameEverywhereElse) {
  const std::string w = GetParam();
  const std::string text =
      "spec " + w + ";\nzone " + w + " = " + w + " - grow(" + w + ", 1 m);\nrobot " + w +
      " {\n  motion " + w + " { " + w + " <= 1 m/s at " + w + "; }\n  sense " + w + " : " + w +
      " error " + w + " max_age " + w + ";\n  input " + w + " : " + w + "[" + w +
      "] tracking <= " + w + ";\n  output " + w + " : " + w + ";\n  latency " + w + ";\n}\nfleet " +
      w + ", " + w + " : " + w + ";\nsite " + w + "(" + w + ") = " + w + ";\ncontroller " + w +
      " : safe for " + w + " = retreat within " + w + " speed " + w + ";\ncontroller " + w +
      " : safe for " + w + " = route to " + w + " within " + w + " speed " + w + ";\ncontroller " +
      w + " : safe for " + w + " = yield within " + w + " speed " + w + " order " + w +
      ";\ncontroller " + w + " : safe for " + w + " = sequence loiter within " + w + " speed " + w +
      " for " + w + " then brake_and_hold;\nmonitor " + w + " for " + w + " : " + w +
      " {\n  always forall " + w + " : " + w + ", " + w + " : " + w + "." + w + " >= " + w + "(" +
      w + ") for " + w + ";\n  ahead " + w + ", " + w + " waypoints, " + w +
      " unsound \"x\";\n  recover " + w + ";\n  return when " + w + ";\n}\ndecision " + w +
      " for " + w + " {\n  advanced " + w + ";\n  safe " + w + ";\n  on " + w + ";\n  period " + w +
      ";\n  priority " + w + " > " + w + ";\n  acknowledge " + w + " may break " + w +
      " \"x\";\n}\n";
  Parsed parsed{text};
  EXPECT_EQ(parsed.messages(), "");
  EXPECT_EQ(parsed.file.items.size(), 10U);
}

INSTANTIATE_TEST_SUITE_P(Words, ClauseWord, testing::ValuesIn(kClauseWords),
                         [](const auto& test) { return std::string{test.param}; });

class ReservedWord : public testing::TestWithParam<const char*> {};

TEST_P(ReservedWord, IsNoName) {
  const std::string word = GetParam();
  Parsed parsed{"fleet a, " + word + " : K;"};
  EXPECT_EQ(parsed.codes(), std::vector<int>{1006}) << parsed.messages();
}

INSTANTIATE_TEST_SUITE_P(Words, ReservedWord, testing::ValuesIn(kReservedWords),
                         [](const auto& test) { return std::string{test.param}; });

}  // namespace
}  // namespace rtac::syntax
