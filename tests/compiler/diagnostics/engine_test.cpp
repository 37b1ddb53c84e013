// The engine decides what counts: one mistake once, and only errors stop a build.
#include "compiler/diagnostics/engine.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace rtac::diag {
namespace {

Diagnostic make(Code code, std::optional<SourceRange> range, std::string message) {
  return {code, range, std::move(message), {}, {}, {}, {}};
}

TEST(Engine, KeepsTheSameCodeAtTheSameRangeOnce) {
  Engine engine;
  const SourceRange range{FileId{0}, 1, 2};
  engine.report(make(Code::unexpected_token, range, "first"));
  engine.report(make(Code::unexpected_token, range, "second"));
  ASSERT_EQ(engine.all().size(), 1U);
  EXPECT_EQ(engine.all()[0].message, "first");
  EXPECT_EQ(engine.error_count(), 1);
}

TEST(Engine, KeepsOtherCodesAndOtherRanges) {
  Engine engine;
  engine.report(make(Code::unexpected_token, SourceRange{FileId{0}, 1, 2}, "a"));
  engine.report(make(Code::missing_semicolon, SourceRange{FileId{0}, 1, 2}, "b"));
  engine.report(make(Code::unexpected_token, SourceRange{FileId{0}, 1, 3}, "c"));
  engine.report(make(Code::unexpected_token, SourceRange{FileId{1}, 1, 2}, "d"));
  EXPECT_EQ(engine.all().size(), 4U);
}

TEST(Engine, ComparesMessagesWhenThereIsNoRange) {
  // Two missing files are two mistakes.
  Engine engine;
  engine.report(make(Code::cannot_read, std::nullopt, "cannot read `a`"));
  engine.report(make(Code::cannot_read, std::nullopt, "cannot read `b`"));
  engine.report(make(Code::cannot_read, std::nullopt, "cannot read `b`"));
  EXPECT_EQ(engine.all().size(), 2U);
}

TEST(Engine, DoesNotCountWarningsAsErrors) {
  Engine engine;
  engine.report(make(Code::unsound_lookahead, SourceRange{}, "w"));
  EXPECT_FALSE(engine.has_errors());
  engine.report(make(Code::unexpected_token, SourceRange{}, "e"));
  EXPECT_TRUE(engine.has_errors());
  EXPECT_EQ(engine.error_count(), 1);
}

TEST(Codes, HaveUniqueNumbersAndNames) {
  std::set<int> numbers;
  std::set<std::string> names;
  for (const CodeInfo& code : all_codes()) {
    EXPECT_TRUE(numbers.insert(static_cast<int>(code.code)).second) << code.name;
    EXPECT_TRUE(names.insert(code.name).second) << code.name;
    EXPECT_NE(std::string{code.title}, "");
    EXPECT_EQ(&info(code.code), &code);
  }
}

}  // namespace
}  // namespace rtac::diag
