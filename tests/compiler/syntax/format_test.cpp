// The formatter changes blanks and line ends only, and changes nothing the second time.
#include "compiler/syntax/format.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "compiler/syntax/lexer.h"
#include "tests/compiler/syntax/syntax_test_util.h"

namespace rtac::syntax {
namespace {

std::optional<std::string> format_text(const std::string& text) {
  SourceManager sources;
  diag::Engine engine;
  const FileId file = sources.add("a.rta", text);
  return format(file, sources, engine);
}

std::string formatted(const std::string& text) {
  return format_text(text).value_or("syntax error");
}

// Kinds and texts of the tokens.
std::vector<std::string> tokens_of(const std::string& text) {
  SourceManager sources;
  diag::Engine engine;
  const FileId file = sources.add("a.rta", text);
  std::vector<std::string> result;
  for (const Token& token : tokenize(file, sources, engine)) {
    result.push_back(std::to_string(token.kind) + ' ' + std::string{sources.text(token.range)});
  }
  return result;
}

// Words of the comments, in order; blanks inside them may change at the ends of lines.
std::vector<std::string> comments_of(const std::string& text) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') {
      while (++i < text.size() && text[i] != '"') i += text[i] == '\\' ? 1 : 0;
    } else if (text.compare(i, 2, "//") == 0 || text.compare(i, 2, "/*") == 0) {
      const bool to_line_end = text[i + 1] == '/';
      const std::size_t end = std::min(text.find(to_line_end ? "\n" : "*/", i + 2), text.size());
      std::istringstream words{text.substr(i, end - i)};
      std::string word, comment;
      while (words >> word) comment += word + ' ';
      result.push_back(comment);
      i = end + (to_line_end ? 0 : 1);  // behind both marks: `/* c */*` begins no other one
    }
  }
  return result;
}

void expect_same_meaning_and_rest(const std::string& text) {
  const std::optional<std::string> once = format_text(text);
  ASSERT_TRUE(once) << text;
  EXPECT_EQ(tokens_of(*once), tokens_of(text)) << *once;
  EXPECT_EQ(comments_of(*once), comments_of(text)) << *once;
  EXPECT_EQ(formatted(*once), *once);
}

std::string read(const std::filesystem::path& path) {
  std::ifstream in{path};
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::vector<std::filesystem::path> specs_in(const std::string& folder) {
  std::vector<std::filesystem::path> result;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(RTAC_SOURCE_DIR + folder)) {
    if (entry.path().extension() == ".rta") result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool has_syntax_error(const std::string& text) {
  return !Parsed{text}.codes().empty();
}

// Zones of files are operands: signs behind their words are operators, and long ones are broken
// in front of the words.
TEST(Format, ZonesOfFiles) {
  EXPECT_EQ(formatted("origin  47.3977 deg,8.5456 deg ;\n"
                      "zone a=import \"a.plan\"exclusions-import \"b.wkt\"in m-c;\n"),
            "origin 47.3977 deg, 8.5456 deg;\n"
            "zone   a = import \"a.plan\" exclusions - import \"b.wkt\" in m - c;\n");
  EXPECT_EQ(
      formatted("zone a=import \"a.json\"scheduled-c;\nzone b=import \"a.json\"scheduled during "
                "08:00..09:00;\n"),
      "zone a = import \"a.json\" scheduled - c;\n"
      "zone b = import \"a.json\" scheduled during 08:00 .. 09:00;\n");
  EXPECT_EQ(formatted("zone long_name = import \"a_folder/and_a_long_name.json\" feature \"one of "
                      "many\" flat \"everything here stays on the ground\";\n"),
            "zone long_name = import \"a_folder/and_a_long_name.json\"\n"
            "                 feature \"one of many\"\n"
            "                 flat \"everything here stays on the ground\";\n");
}

TEST(Format, ZonesWithHeightsThatMoveOrComeAndGo) {
  EXPECT_EQ(formatted("zone long_name = import \"a_folder/and_a_long_name.json\" feature \"one of "
                      "many\" heights amsl at -432.5m scheduled-other during 08:00..09:00 or "
                      "mon,tue 10:00..12:00;\n"),
            "zone long_name = import \"a_folder/and_a_long_name.json\"\n"
            "                 feature \"one of many\"\n"
            "                 heights amsl at -432.5 m\n"
            "                 scheduled - other\n"
            "                 during 08:00 .. 09:00 or mon, tue 10:00 .. 12:00;\n");
  EXPECT_EQ(
      formatted("zone bubble = circle (0 m, 0 m) radius 4.5 m | rectangle (1 m, 1 m) to (2 m, "
                "2 m) | heights around around during 08:00 .. 09:00;\n"),
      "zone bubble = circle (0 m, 0 m) radius 4.5 m | rectangle (1 m, 1 m) to (2 m, 2 m) | "
      "heights\n"
      "              around around\n"
      "              during 08:00 .. 09:00;\n");
}

TEST(Format, KeepsTokensAndCommentsOfAllSpecifications) {
  int formatted_count = 0;
  for (const char* folder : {"/specs", "/tests", "/examples"}) {
    for (const auto& path : specs_in(folder)) {
      const std::string text = read(path);
      if (has_syntax_error(text)) continue;
      SCOPED_TRACE(path);
      expect_same_meaning_and_rest(text);
      ++formatted_count;
    }
  }
  EXPECT_GE(formatted_count, 60);
}

// The specifications that a reader starts with are written as the formatter writes.
TEST(Format, LeavesTheSpecificationsOfTheStudiesAsTheyAre) {
  for (const char* folder : {"/specs", "/examples"}) {
    for (const auto& path : specs_in(folder)) {
      const std::string text = read(path);
      EXPECT_EQ(formatted(text), text) << path;
    }
  }
}

// The tokens of a text with other blanks, line ends and comments between them. Units end with the
// line of their number, so a number is not torn from its unit, nor `real [` from its own.
std::string with_other_blanks(const std::string& text, std::mt19937& random) {
  static const std::string blanks[] = {"",
                                       " ",
                                       "  ",
                                       "\n",
                                       "\n\n\n",
                                       "\t",
                                       "\r\n",
                                       " /* c */ ",
                                       " // c\n",
                                       "\n// own\n",
                                       "\n\n/* b */\n",
                                       "\n /* two\n lines */ ",
                                       "\n/* 1 */ /* 2 */ /* 3 */",
                                       " /* 4 */\n/* 5 */ // 6\n",
                                       "\n\n/* in */ "};
  SourceManager sources;
  diag::Engine engine;
  const FileId file = sources.add("a.rta", text);
  const std::vector<Token> tokens = tokenize(file, sources, engine);
  std::string result;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const TokenKind kind = tokens[i].kind;
    const bool is_mark = kind != T::IDENT && kind != T::NUMBER && kind != T::MOMENT &&
                         kind != T::MINUS && kind != T::DOT && kind != T::DOT_DOT &&
                         !find_word(kind);
    const std::string blank = kind == T::UNIT ? " " : blanks[random() % std::size(blanks)];
    result += blank.empty() && !is_mark ? " " : blank;
    result += sources.text(tokens[i].range);
  }
  return result;
}

TEST(Format, KeepsTokensWhateverTheBlanks) {
  std::mt19937 random{7};
  std::vector<std::string> texts{kMonitors};
  for (const auto& path : specs_in("/specs")) texts.push_back(read(path));
  for (const std::string& text : texts) {
    for (int round = 0; round < 100; ++round) {
      const std::string mixed = with_other_blanks(text, random);
      ASSERT_EQ(tokens_of(mixed), tokens_of(text)) << mixed;
      expect_same_meaning_and_rest(mixed);
      if (HasFailure()) return;
    }
  }
}

// ... of every specification of the repository, so that a comment has stood at every place of every
// construct.
TEST(Format, KeepsCommentsBetweenAllTokens) {
  std::mt19937 random{11};
  for (const char* folder : {"/specs", "/tests", "/examples", "/compiler"}) {
    for (const auto& path : specs_in(folder)) {
      const std::string text = read(path);
      if (has_syntax_error(text)) continue;
      SCOPED_TRACE(path);
      for (int round = 0; round < 3; ++round) {
        const std::string mixed = with_other_blanks(text, random);
        ASSERT_EQ(tokens_of(mixed), tokens_of(text)) << mixed;
        expect_same_meaning_and_rest(mixed);
        if (HasFailure()) return;
      }
    }
  }
}

TEST(Format, RefusesTextsWithMistakes) {
  EXPECT_EQ(format_text("zone a = ;"), std::nullopt);
  EXPECT_EQ(format_text("zone a = b"), std::nullopt);
  EXPECT_EQ(format_text("zone a = \"b"), std::nullopt);
}

TEST(Format, PutsOneItemOrClauseOnALine) {
  EXPECT_EQ(formatted("spec a;zone b=c;monitor m for r:K{always d;\nrecover e;}"),
            "spec a;\n"
            "zone b = c;\n"
            "monitor m for r : K {\n"
            "  always  d;\n"
            "  recover e;\n"
            "}\n");
}

TEST(Format, KeepsAShortBlockOnItsLine) {
  EXPECT_EQ(formatted("monitor m{\"R1: x\"always a;}"), "monitor m { \"R1: x\" always a; }\n");
  const std::string name(60, 'n');
  EXPECT_EQ(formatted("monitor m { \"R1: x\" always " + name + " or " + name + "; }"),
            "monitor m {\n  \"R1: x\"\n  always " + name + "\n         or " + name + ";\n}\n");
}

TEST(Format, AlignsColumnsOfNeighbours) {
  EXPECT_EQ(formatted("zone a=b;\nzone long = c;\n\nfleet x : K;\nsite s=(1 m,2 m);\n"),
            "zone a    = b;\n"
            "zone long = c;\n"
            "\n"
            "fleet x : K;\n"
            "site  s = (1 m, 2 m);\n");
  EXPECT_EQ(formatted("input open,moving:bool;\ninput speed:real[m/s]in 0..3m/s;\nenum G{a,b}\n"),
            "input open, moving : bool;\n"
            "input speed        : real [m/s] in 0 .. 3 m/s;\n"
            "enum  G { a, b }\n");
}

TEST(Format, AlignsTheSignalsOfARobot) {
  EXPECT_EQ(formatted("robot T {\nsense position:point error 2 cm max_age 100 ms;\n"
                      "sense heading : angle error 2 deg max_age 1 s;\nhears other robots max_age "
                      "200 ms;\nlatency 4 ms;\n}\n"),
            "robot T {\n"
            "  sense    position : point  error 2 cm   max_age 100 ms;\n"
            "  sense    heading  : angle  error 2 deg  max_age 1 s;\n"
            "  hears    other robots      max_age 200 ms;\n"
            "  latency  4 ms;\n"
            "}\n");
}

TEST(Format, BreaksLongConditionsAtTheirWeakestOperator) {
  const std::string a(40, 'a');
  const std::string b(40, 'b');
  EXPECT_EQ(formatted("monitor m {\n always " + a + " and " + b + " implies " + a + " or x;\n}"),
            "monitor m {\n"
            "  always " +
                a + " and " + b +
                "\n"
                "         implies " +
                a +
                " or x;\n"
                "}\n");
  EXPECT_EQ(formatted("monitor m {\n always (" + a + " and " + b + " and " + a + ");\n}"),
            "monitor m {\n"
            "  always (" +
                a +
                "\n"
                "          and " +
                b +
                "\n"
                "          and " +
                a +
                ");\n"
                "}\n");
}

TEST(Format, KeepsLinesThatTheAuthorBeganAtOperators) {
  EXPECT_EQ(formatted("zone a = b\n  | c\n- d;\n"), "zone a = b\n       | c\n       - d;\n");
  EXPECT_EQ(formatted("zone\na\n=\nb;\n"), "zone a = b;\n");
}

TEST(Format, KeepsCommentsAtTheirPlaces) {
  EXPECT_EQ(formatted("\n\n// head\n\n\n\nzone a=b;// behind\n/* own */\nzone c=/* in */d;\n"
                      "monitor m { // start\n\n always x // why\n;\n\n// end\n}// last"),
            "// head\n"
            "\n"
            "zone a = b;  // behind\n"
            "/* own */\n"
            "zone c = /* in */ d;\n"
            "monitor m {  // start\n"
            "  always x  // why\n"
            "         ;\n"
            "\n"
            "  // end\n"
            "}  // last\n");
}

TEST(Format, KeepsTheOrderOfCommentsInFrontOfAClosingBrace) {
  EXPECT_EQ(formatted("enum G { a, b\n/*c*/ /*d*/ }"), "enum G {\n  a, b\n/*c*/ /*d*/ }\n");
  EXPECT_EQ(formatted("monitor m {\nalways p; /*0*/ /*1*/ /*2*/ }"),
            "monitor m {\n  always p;\n/*0*/ /*1*/ /*2*/ }\n");
}

// The empty line above a comment on the line of an item is that above the item.
TEST(Format, KeepsTheEmptyLineAboveACommentInFrontOfAnItem) {
  const std::string kept =
      "site  a = b;\n"
      "fleet c : D;\n"
      "\n"
      "/* in */ site  e = f;\n"
      "fleet g : H;\n";
  EXPECT_EQ(formatted(kept), kept);
}

TEST(Format, KeepsCommentsUnderEachOther) {
  EXPECT_EQ(formatted("zone a = b;       // one\nzone cc = dd;     // two\nzone e = f; // three\n"),
            "zone a  = b;   // one\n"
            "zone cc = dd;  // two\n"
            "zone e  = f;  // three\n");
}

TEST(Format, SetsSignsAndWordsApart) {
  EXPECT_EQ(
      formatted("monitor m { always once [ 0 s ,inf ] not( a ) and min [0 s,1 s] ( x )>=- 1 m/s "
                "- t [ 2 ] . y and f ( x )*speed ( y )<=(1 m); }"),
      "monitor m {\n"
      "  always once[0 s, inf] not (a)\n"
      "         and min[0 s, 1 s](x) >= -1 m/s - t[2].y\n"
      "         and f(x) * speed(y) <= (1 m);\n"
      "}\n");
}

TEST(Format, WritesTheSizeOfAZoneLikeThatOfAnArray) {
  EXPECT_EQ(formatted("input fence:zone [ 64 ] @gps max_age inf;"),
            "input fence : zone[64] @ gps max_age inf;\n");
}

// A unit belongs to the line of its number: joining lines would make one of a name.
TEST(Format, LeavesATextThatBlanksWouldChange) {
  const std::string text = "input   a : real[\nm];\n";
  EXPECT_EQ(formatted(text), text);
}

TEST(Format, WritesMonitorsAsAuthorsDo) {
  const std::string text = kMonitors;
  const std::string once = formatted(text);
  EXPECT_NE(once.find("fun    slow(v : real [m/s], limit : real [m/s]) : bool = v <= limit;\n"),
            std::string::npos)
      << once;
  EXPECT_NE(once.find("  always once[0 s, 2 s] open implies speed <= 0.3 m/s;\n"),
            std::string::npos)
      << once;
}

TEST(Format, BeginsTheBodyOfALongFunctionOnALineOfItsOwn) {
  const std::string a(50, 'a');
  EXPECT_EQ(formatted("fun f(v : real [m/s], w : real [m/s]) : bool = " + a + " or w;"),
            "fun f(v : real [m/s], w : real [m/s]) : bool =\n    " + a + " or w;\n");
}

TEST(Format, KeepsMomentsWhole) {
  EXPECT_EQ(formatted("clock   utc ;zone a=b during monday ,friday 07:30..16:00 or "
                      "2026-05-01T08:00Z..2026-05-01T18:00Z;"),
            "clock utc;\nzone  a = b during monday, friday 07:30 .. 16:00 or 2026-05-01T08:00Z .. "
            "2026-05-01T18:00Z;\n");
}

TEST(Format, IsFastOnLongLists) {
  std::string points = "(0 m, 0 m)";
  for (int i = 0; i < 50'000; ++i) points += ",(1 m,2 m)";
  const std::string text = formatted("zone a = polygon [" + points + "];");
  EXPECT_GT(std::count(text.begin(), text.end(), '\n'), 5'000);
}

}  // namespace
}  // namespace rtac::syntax
