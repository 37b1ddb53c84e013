// Every message points at a line and column: positions must hold at all edges of a file.
#include "compiler/support/source.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

namespace rtac {
namespace {

TEST(SourceManager, FindsLinesAndColumns) {
  SourceManager sources;
  const FileId file = sources.add("a.rta", "ab\ncd\n");
  EXPECT_EQ(sources.position(file, 0).line, 1U);
  EXPECT_EQ(sources.position(file, 1).column, 2U);
  EXPECT_EQ(sources.position(file, 2).line, 1U);  // the line break belongs to its line
  EXPECT_EQ(sources.position(file, 3).line, 2U);
  EXPECT_EQ(sources.position(file, 3).column, 1U);
  EXPECT_EQ(sources.position(file, 6).line, 3U);
}

TEST(SourceManager, ClampsBeyondTheEnd) {
  SourceManager sources;
  const FileId file = sources.add("a.rta", "ab");
  EXPECT_EQ(sources.position(file, 99).column, 3U);
  EXPECT_EQ(sources.text(SourceRange{file, 1, 99}), "b");
  EXPECT_EQ(sources.text(SourceRange{file, 5, 9}), "");
  EXPECT_EQ(sources.line_text(file, 9), "");
  EXPECT_EQ(sources.line_text(file, 0), "");
}

TEST(SourceManager, StripsBothKindsOfLineBreaks) {
  SourceManager sources;
  const FileId file = sources.add("a.rta", "ab\r\ncd\nef");
  EXPECT_EQ(sources.line_text(file, 1), "ab");
  EXPECT_EQ(sources.line_text(file, 2), "cd");
  EXPECT_EQ(sources.line_text(file, 3), "ef");
}

TEST(SourceManager, AcceptsAnEmptyFile) {
  SourceManager sources;
  const FileId file = sources.add("a.rta", "");
  EXPECT_EQ(sources.position(file, 0).line, 1U);
  EXPECT_EQ(sources.line_text(file, 1), "");
}

TEST(SourceManager, PartsOfAFileHaveTheirPlaceInIt) {
  SourceManager sources;
  const FileId part = sources.add_part("a.csv", "1,2\n3,4", 7, 100);
  EXPECT_EQ(sources.position(part, 0).line, 7U);
  EXPECT_EQ(sources.position(part, 6).line, 8U);
  EXPECT_EQ(sources.position(part, 6).column, 3U);
  EXPECT_EQ(sources.offset_in_file(part, 6), 106U);
  EXPECT_EQ(sources.line_text(part, 8), "3,4");
  EXPECT_EQ(sources.line_text(part, 6), "");
  EXPECT_EQ(sources.line_text(part, 9), "");
}

TEST(SourceManager, KeepsReferencesWhenFilesAreAdded) {
  // Ids stay valid while imports are loaded.
  SourceManager sources;
  const FileId first = sources.add("first.rta", "one");
  for (int i = 0; i < 100; ++i) sources.add("more.rta", "more");
  EXPECT_EQ(sources.path(first), "first.rta");
  EXPECT_EQ(sources.text(first), "one");
  EXPECT_EQ(sources.file_count(), 101U);
}

TEST(SourceManagerLoad, ReadsBytesAsTheyAre) {
  const std::string path = testing::TempDir() + "rtac_source_test.rta";
  {
    std::ofstream out{path, std::ios::binary};
    out << std::string("a\0b\r\n", 5);
  }
  SourceManager sources;
  std::string why;
  const auto file = sources.load(path, why);
  ASSERT_TRUE(file);
  EXPECT_EQ(sources.text(*file), std::string_view("a\0b\r\n", 5));
  EXPECT_EQ(sources.path(*file), path);
  std::remove(path.c_str());
}

TEST(SourceManagerLoad, SaysWhyAFileCannotBeRead) {
  SourceManager sources;
  std::string why;
  EXPECT_FALSE(sources.load(testing::TempDir() + "no_such_file.rta", why));
  EXPECT_EQ(why, "No such file or directory");
  EXPECT_FALSE(sources.load(testing::TempDir(), why));
  EXPECT_EQ(why, "Is a directory");
  EXPECT_EQ(sources.file_count(), 0U);
}

}  // namespace
}  // namespace rtac
