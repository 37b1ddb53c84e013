// The sample files: recognised by name and content, and read as a whole.
#include <fstream>
#include <sstream>

#include "tests/compiler/geometry/import/testing.h"

namespace rtac::geometry::import {
namespace {

struct Sample {
  const char* file;
  Format format;
  std::size_t areas, refused, parts, notes;
};

constexpr Sample samples[] = {
    {"bare_polygon.geojson", Format::geojson, 1, 0, 1, 0},
    {"collection.geojson", Format::geojson, 3, 1, 3, 1},
    {"collection.wkt", Format::wkt, 2, 2, 0, 1},
    {"fence.plan", Format::qgc_plan, 2, 0, 2, 1},
    {"fence.waypoints", Format::waypoints, 2, 0, 2, 2},
    {"folders.kml", Format::kml, 3, 2, 1, 0},
    {"layers.ed318.json", Format::ed318, 1, 1, 0, 1},
    {"metres.wkt", Format::wkt, 4, 3, 1, 0},
    {"stack.ed269.json", Format::ed269, 1, 0, 2, 0},
};

std::string content(const std::string& file) {
  std::ifstream in(RTAC_SOURCE_DIR "/tests/fuzz/zones/" + file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::ostream& operator<<(std::ostream& out, const Sample& sample) {
  return out << sample.file;
}

class Samples : public testing::TestWithParam<Sample> {};

TEST_P(Samples, AreRecognisedAndRead) {
  const Sample& sample = GetParam();
  const std::string text = content(sample.file);
  EXPECT_EQ(format_of(sample.file, text), sample.format);
  const Areas areas = areas_of(sample.format, text);
  std::size_t refused = 0, parts = 0;
  for (const Area& area : areas.areas) {
    refused += area.refusal ? 1U : 0U;
    parts += area.parts.size();
  }
  EXPECT_EQ(areas.areas.size(), sample.areas);
  EXPECT_EQ(refused, sample.refused);
  EXPECT_EQ(parts, sample.parts);
  EXPECT_EQ(areas.notes.size(), sample.notes);
}

INSTANTIATE_TEST_SUITE_P(Files, Samples, testing::ValuesIn(samples));

}  // namespace
}  // namespace rtac::geometry::import
