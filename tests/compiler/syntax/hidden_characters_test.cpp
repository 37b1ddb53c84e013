// A safety engineer who reads a page must read what is compiled: characters that reorder, hide or
// end what an editor shows are refused, and never sent to a terminal as they are.
#include <gtest/gtest.h>

#include "tests/compiler/syntax/syntax_test_util.h"

namespace rtac::syntax {
namespace {

constexpr int hidden = static_cast<int>(diag::Code::hidden_character);
constexpr int unknown = static_cast<int>(diag::Code::unknown_character);

// Overrides, embeddings and isolates of direction, everywhere: in comments and texts they show a
// clause where there is none.
TEST(HiddenCharacters, ThatReorderAreRefusedEverywhere) {
  for (const char* character :
       {"\u202A", "\u202B", "\u202C", "\u202D", "\u202E", "\u2066", "\u2067", "\u2068", "\u2069"}) {
    const std::string c = character;
    EXPECT_EQ(Parsed{"zone a = b; // " + c + "x\n"}.codes(), std::vector<int>{hidden});
    EXPECT_EQ(Parsed{"zone a = b; /* " + c + "x */"}.codes(), std::vector<int>{hidden});
    EXPECT_EQ(Parsed{"monitor m { \"" + c + "x\" }"}.codes(), std::vector<int>{hidden});
    EXPECT_EQ(Parsed{"zone a" + c + " = b;"}.codes(), std::vector<int>{hidden});
  }
}

// An editor starts a line at each of these, the compiler does not: behind `//` an author would see
// a clause that is not compiled.
TEST(HiddenCharacters, ThatOnlyAnEditorTakesForTheEndOfALineAreRefused) {
  for (const char* character : {"\r", "\v", "\f", "\u0085", "\u2028", "\u2029"}) {
    const std::string text = std::string{"zone a = b; // note"} + character + "zone c = d;\n";
    EXPECT_EQ(Parsed{text}.codes(), std::vector<int>{hidden}) << text;
  }
}

TEST(HiddenCharacters, AtTheEndOfEveryLineAreOneMistake) {
  EXPECT_EQ(Parsed{"zone a = b;\rzone c = d;\rzone e = f;\r"}.codes(), std::vector<int>{hidden});
}

TEST(HiddenCharacters, OfLineEndsAndTabsAreText) {
  EXPECT_EQ(Parsed{"zone a = b;\r\n\tzone c = d; // x\r\n"}.messages(), "");
}

// Escape sequences of a terminal could hide lines of a report.
TEST(HiddenCharacters, ThatControlATerminalAreRefused) {
  Parsed parsed{"monitor m { \"\x1b[2J\" }"};
  EXPECT_EQ(parsed.codes(), std::vector<int>{hidden});
  EXPECT_EQ(parsed.messages().find('\x1b'), std::string::npos);
}

// Joiners and marks belong to scripts and emoji, so a text may have them; code may not.
TEST(HiddenCharacters, OfScriptsAreRefusedOutsideCommentsAndTexts) {
  for (const char* character : {"\u200B", "\u200D", "\u200F", "\u00AD", "\u2060", "\uFEFF"}) {
    const std::string c = character;
    EXPECT_EQ(Parsed{"monitor m { \"a" + c + "b\" /* " + c + " */ }"}.messages(), "");
    Parsed parsed{"zone a = b " + c + ";"};
    EXPECT_EQ(parsed.codes(), std::vector<int>{unknown});
    EXPECT_EQ(parsed.messages().find(c), std::string::npos) << "sent as it is";
    EXPECT_EQ(Parsed{"zone fr" + c + "ee = b;"}.codes(), std::vector<int>{unknown});
  }
}

}  // namespace
}  // namespace rtac::syntax
