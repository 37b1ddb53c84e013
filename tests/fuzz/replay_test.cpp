// Every text that is kept for the fuzzer goes through every subject, with any compiler: what was
// found once is not found again.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "tests/fuzz/subjects.h"

namespace rtac::fuzz {
namespace {

std::vector<std::filesystem::path> zone_files() {
  std::vector<std::filesystem::path> result;
  const auto root = std::filesystem::path{RTAC_SOURCE_DIR} / "tests/fuzz/zones";
  for (const auto& entry : std::filesystem::directory_iterator(root)) {
    result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::filesystem::path> texts() {
  std::vector<std::filesystem::path> result;
  for (const char* folder : {"tests/fuzz/corpus", "tests/golden", "specs"}) {
    const auto root = std::filesystem::path{RTAC_SOURCE_DIR} / folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      if (entry.path().extension() == ".rta") result.push_back(entry.path());
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

using Subject = std::string (*)(std::string_view);

void expect_sound(Subject subject) {
  const auto all = texts();
  ASSERT_GE(all.size(), 50U);
  for (const auto& path : all) EXPECT_EQ(subject(content(path)), "") << path;
}

// Cut anywhere, a text is what an author has typed so far: an editor checks that, too.
void expect_sound_when_cut(Subject subject, std::size_t stride) {
  for (const auto& path : texts()) {
    const std::string text = content(path);
    for (std::size_t end = stride; end < text.size(); end += stride) {
      ASSERT_EQ(subject(std::string_view(text).substr(0, end)), "") << path << " up to " << end;
    }
  }
}

TEST(FuzzReplay, Lexer) {
  expect_sound(run_lexer);
}
TEST(FuzzReplay, Parser) {
  expect_sound(run_parser);
}
TEST(FuzzReplay, Check) {
  expect_sound(run_check);
}
TEST(FuzzReplay, Compiler) {
  expect_sound(run_compiler);
}
TEST(FuzzReplay, CutTextsThroughTheParser) {
  expect_sound_when_cut(run_parser, 97);
}
TEST(FuzzReplay, CutTextsThroughTheCheck) {
  expect_sound_when_cut(run_check, 89);
}

TEST(FuzzReplay, ZoneFiles) {
  const auto all = zone_files();
  ASSERT_GE(all.size(), 10U);
  for (const auto& path : all) EXPECT_EQ(run_zones(content(path)), "") << path;
}
TEST(FuzzReplay, CutZoneFiles) {
  for (const auto& path : zone_files()) {
    const std::string text = content(path);
    for (std::size_t end = 0; end < text.size(); end += 7) {
      ASSERT_EQ(run_zones(std::string_view(text).substr(0, end)), "") << path << " up to " << end;
    }
  }
}

}  // namespace
}  // namespace rtac::fuzz
