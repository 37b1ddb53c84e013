// No input may crash the front end or exhaust the stack: it ends with messages.
#include <gtest/gtest.h>

#include <cstddef>
#include <random>

#include "tests/compiler/syntax/syntax_test_util.h"

namespace rtac::syntax {
namespace {

std::string repeat(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

TEST(HostileInput, DeepBracketsGiveOneError) {
  for (const char* bracket : {"(", "[", "{"}) {
    EXPECT_EQ(Parsed{"zone a = " + repeat(bracket, 100'000)}.codes().back(), 1014) << bracket;
  }
  EXPECT_EQ(Parsed{"zone a = " + repeat("f(", 100'000)}.codes(), std::vector<int>{1014});
}

TEST(HostileInput, LongChainsOfOperatorsGiveOneError) {
  // They nest in the tree, though not in the text.
  for (const char* part :
       {"not ", "- ", "a + ", "a implies ", "forall q : K : ", "once ", "historically[0 s, 1 s] ",
        "previously ", "a since ", "a within 1 s of ", "if a then b else ", "let x = a in ",
        "let x = if a then b else c in "}) {
    EXPECT_EQ(Parsed{"zone a = " + repeat(part, 100'000) + "b;"}.codes(), std::vector<int>{1014})
        << part;
  }
  for (const char* part : {".b", "[2]", " for 1 s", " since[0 s, 1 s] b", " within 1 s of b"}) {
    EXPECT_EQ(Parsed{"zone a = a" + repeat(part, 100'000) + ";"}.codes(), std::vector<int>{1014})
        << part;
  }
}

// What nests without end through places that an operator chain does not reach.
TEST(HostileInput, ConstructsInsideThemselvesGiveOneError) {
  const auto nested = [](const std::string& open, const std::string& close, int count) {
    return "assume " + repeat(open, count) + "a" + repeat(close, count) + " unchecked \"x\";";
  };
  for (const auto& [open, close] :
       std::vector<std::pair<std::string, std::string>>{{"min[0 s, 1 s](", ")"},
                                                        {"once[0 s, ", "] a"},
                                                        {"a[", "]"},
                                                        {"if ", " then b else c"},
                                                        {"let x = ", " in x"},
                                                        {"if a then ", " else c"}}) {
    EXPECT_EQ(Parsed{nested(open, close, 100'000)}.codes(), std::vector<int>{1014}) << open;
    EXPECT_EQ(Parsed{nested(open, close, 150)}.messages(), "") << open;
  }
}

// The message says the limit, so that an author knows what would work.
TEST(HostileInput, LimitsAreNamed) {
  EXPECT_NE(Parsed{"assume " + repeat("once ", 1000) + "a checked by m;"}.messages().find(
                "more than 400 levels"),
            std::string::npos);
  EXPECT_NE(Parsed{"period " + std::string(65, '9') + " ms;"}.messages().find("at most 64 digits"),
            std::string::npos);
  EXPECT_EQ(Parsed{"input x : int in 0 .. 1e65;"}.codes(), std::vector<int>{1013});
}

TEST(HostileInput, DeepNestingThroughManyShortChainsStaysBounded) {
  // Each bracket holds a chain below the limit; together they would be far too high.
  std::string text = "b";
  for (int i = 0; i < 60; ++i) text = "polygon [(" + repeat("- ", 300) + text + ", c)]";
  EXPECT_EQ(Parsed{"zone a = " + text + ";"}.codes().front(), 1014);
}

TEST(HostileInput, LimitsAreGenerous) {
  // 150 brackets and a union of 300 zones are accepted.
  EXPECT_EQ(Parsed{"zone a = " + repeat("(", 150) + "b" + repeat(")", 150) + ";"}.messages(), "");
  EXPECT_EQ(Parsed{"zone a = b" + repeat(" | b", 300) + ";"}.messages(), "");
}

// What the help of 1014 says: brackets around groups of a chain add up to few levels.
TEST(HostileInput, ALongChainWorksInGroups) {
  const std::string group = "(a" + repeat(" or a", 99) + ")";
  const auto assumed = [](const std::string& text) {
    return Parsed{"assume " + text + " unchecked \"x\";"};
  };
  EXPECT_EQ(assumed(group + repeat(" or " + group, 19)).messages(), "");
  EXPECT_NE(assumed("a" + repeat(" or a", 1999)).messages().find("(a or b) or (c or d)"),
            std::string::npos);
}

TEST(HostileInput, LongListsAreNotDeep) {
  Parsed parsed{"zone a = polygon [(0, 0)" + repeat(", (1 m, 2 m)", 50'000) + "];"};
  EXPECT_EQ(parsed.messages(), "");
}

TEST(HostileInput, ZeroBytesAndBinaryFilesAreNotText) {
  using namespace std::string_literals;
  EXPECT_EQ(Parsed{"spec a;\0zone b = c;"s}.codes(), std::vector<int>{1015});
  EXPECT_EQ(Parsed{"\x7f"
                   "ELF\x02\x01\x01\0\0\0"s}
                .codes(),
            std::vector<int>{1015});
  EXPECT_EQ(Parsed{"\xFF\xFEs\0p\0"s}.codes(), std::vector<int>{1015});          // UTF-16
  EXPECT_EQ(Parsed{"// \xC0\x80 \n"s}.codes(), std::vector<int>{1015});          // overlong
  EXPECT_EQ(Parsed{"// \xED\xA0\x80 \n"s}.codes(), std::vector<int>{1015});      // surrogate
  EXPECT_EQ(Parsed{"// \xF4\x90\x80\x80 \n"s}.codes(), std::vector<int>{1015});  // too large
  EXPECT_EQ(Parsed{"// cut \xE2\x82"s}.codes(), std::vector<int>{1015});
}

TEST(HostileInput, EdgesOfFilesAreHarmless) {
  EXPECT_EQ(Parsed{""}.messages(), "");
  EXPECT_EQ(Parsed{"\n"}.messages(), "");
  EXPECT_EQ(Parsed{"spec a;"}.messages(), "");
  EXPECT_EQ(Parsed{"spec a; // no line break"}.messages(), "");
  EXPECT_EQ(Parsed{"\xEF\xBB\xBFspec a;\r\nzone b = c;\r\n"}.messages(), "");
  EXPECT_EQ(Parsed{"// \u00E4\u00F6\u00FC /* \n/* ** // */ spec a; /**/"}.messages(), "");
  EXPECT_EQ(Parsed{"spec"}.codes(), std::vector<int>{1017});
  EXPECT_EQ(Parsed{"}"}.codes(), std::vector<int>{1001});
  EXPECT_EQ(Parsed{"\""}.codes(), std::vector<int>{1009});
  EXPECT_EQ(Parsed{"zone a = \"b\\"}.codes(), std::vector<int>{1009});
}

TEST(HostileInput, FloodsOfMistakesEndEarly) {
  EXPECT_LE(Parsed{repeat("@ ", 100'000)}.codes().size(), 21U);
  EXPECT_LE(Parsed{repeat("zone a = b c;\n", 20'000)}.codes().size(), 21U);
  EXPECT_LE(Parsed{repeat("\u00E9 ", 50'000)}.codes().size(), 21U);
  EXPECT_LE(Parsed{repeat("; ", 100'000)}.codes().size(), 21U);
  EXPECT_LE(Parsed{repeat("} ", 100'000)}.codes().size(), 21U);
}

TEST(HostileInput, RandomTokensNeverCrash) {
  const std::vector<std::string> words{
      "spec ",   "zone ",   "robot ",      "monitor ", "decision ", "{ ",         "} ",
      "( ",      ") ",      "[ ",          "] ",       "; ",        ": ",         ", ",
      "= ",      "a ",      "1 ",          "2 m/s ",   "\"t\" ",    "always ",    "for ",
      "not ",    "forall ", "+ ",          ">= ",      "inside ",   "\n",         "ahead ",
      "/* ",     "*/ ",     "\" ",         "@ ",       "% ",        "=> ",        "\u2264 ",
      "energy ", "motion ", "polygon ",    "at ",      "body ",     "radius ",    "hole ",
      ". ",      "import ", "priority ",   "input ",   "period ",   "param ",     "enum ",
      "fun ",    "scale ",  "assume ",     "checked ", "by ",       "unchecked ", "in ",
      "of ",     ".. ",     "if ",         "then ",    "else ",     "let ",       "once ",
      "since ",  "within ", "previously ", "real ",    "inf ",      "1..2 ",      "\nperiod ",
      "\ninput "};
  std::mt19937 random{1};
  for (int round = 0; round < 3000; ++round) {
    std::string text;
    const auto length = 1 + random() % 60;
    for (std::size_t i = 0; i < length; ++i) text += words[random() % words.size()];
    Parsed parsed{text};
    EXPECT_LE(parsed.codes().size(), 21U);
    EXPECT_EQ(parsed.tree().empty(), parsed.file.items.empty() && !parsed.file.spec);
    EXPECT_EQ(print(parsed.file).empty(), parsed.file.items.empty() && !parsed.file.spec);
    EXPECT_EQ(parsed.messages().empty(), parsed.codes().empty());
  }
}

}  // namespace
}  // namespace rtac::syntax
