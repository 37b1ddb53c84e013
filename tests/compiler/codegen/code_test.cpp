// Texts of the author in comments and strings of C: they stay readable and never end early.
#include "compiler/codegen/code.h"

#include <gtest/gtest.h>

#include <chrono>
#include <sstream>

namespace rtac::codegen {
namespace {

std::string comment(const std::string& text, Code::Style style) {
  Code code;
  code.comment(text);
  return code.print(style);
}

TEST(Comments, CannotBeEndedOrNestedByTheirText) {
  EXPECT_EQ(comment("a */ b /* c", Code::Style::c), "/* a * / b / * c */\n");
  EXPECT_EQ(comment("*/*/", Code::Style::c).find("*/", 2),
            comment("*/*/", Code::Style::c).size() - 3);
}

TEST(Comments, DoNotJoinTheirLineWithTheNext) {
  for (const std::string text : {"ends with \\", "ends with ?\?/"}) {
    const std::string line = comment(text, Code::Style::cpp);
    EXPECT_NE(line[line.size() - 2], '\\');
    EXPECT_NE(line[line.size() - 2], '/');
  }
}

TEST(Comments, AreBrokenIntoLines) {
  std::string text;
  for (int i = 0; i < 60; ++i) text += "word ";
  for (const Code::Style style : {Code::Style::c, Code::Style::cpp}) {
    std::string line;
    std::istringstream lines(comment(text, style));
    int count = 0;
    while (std::getline(lines, line)) {
      EXPECT_LE(line.size(), 100u);
      ++count;
    }
    EXPECT_GT(count, 2);
  }
}

TEST(Strings, AreQuotedForCAndWithoutTrigraphs) {
  EXPECT_EQ(quoted("a\"b\\c"), "\"a\\\"b\\\\c\"");
  EXPECT_EQ(quoted("tab\tline\n"), "\"tab\\011line\\012\"");
  EXPECT_EQ(quoted("what?\?/"), "\"what?\\?/\"");
  EXPECT_EQ(quoted("\xc3\xab"), "\"\xc3\xab\"");
}

TEST(Blocks, AreIndentedAndDirectivesAreNot) {
  Code code;
  code.block("if (x)", [](Code& body) { body.line("#define A 1").line("y();"); });
  EXPECT_EQ(code.print(Code::Style::c), "if (x) {\n#define A 1\n  y();\n}\n");
}

// Behind commas and connectives, before `?` and `:`, never within 96 characters of the last break.
TEST(Wrapped, BreaksWhereAnExpressionMayAndKeepsItsText) {
  std::string text = "x = f(a, b)", kept;
  for (int i = 0; i < 40; ++i) text += " && some_name || g(h, i) ? first : second";
  Code code;
  wrapped(code, text);
  std::istringstream lines(code.print(Code::Style::c));
  std::string line;
  for (int count = 0; std::getline(lines, line); ++count) {
    EXPECT_LE(line.size(), 96U) << line;
    const std::string part = count == 0 ? line : line.substr(4);
    EXPECT_TRUE(count == 0 || line.substr(0, 4) == "    ") << line;
    EXPECT_NE(part[0], ' ') << line;
    kept += (count == 0 ? "" : " ") + part;
  }
  EXPECT_EQ(kept, text);
}

// Megabytes on one line, of a fleet whose pairs are all compared, take no longer than to copy.
TEST(Wrapped, LooksAtEachCharacterOnce) {
  std::string text = "x";
  for (int i = 0; i < 300'000; ++i) text += " && y";  // no comma, no `||`, no `?` anywhere
  const auto start = std::chrono::steady_clock::now();
  Code code;
  wrapped(code, text);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

}  // namespace
}  // namespace rtac::codegen
