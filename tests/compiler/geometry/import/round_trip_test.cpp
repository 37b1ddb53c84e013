// Random areas written in each format and read again are the same areas; and whatever bytes of such
// a text are changed, reading ends in areas or in a failure that has its place.
#include <charconv>
#include <functional>
#include <random>

#include "tests/compiler/geometry/import/testing.h"

namespace rtac::geometry::import {
namespace {

constexpr std::size_t rounds = 200;

std::string text_of(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

// Around a place in mid-latitudes, so that swapping the axes stays on the globe, too.
class Choices {
 public:
  explicit Choices(std::uint32_t seed) : random_(seed) {}

  std::size_t below(std::size_t end) { return random_() % end; }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Ring ring() {
    Ring result;
    for (std::size_t i = 3 + below(6); i > 0; --i) {
      result.positions.push_back({between(-80, 80), between(-80, 80)});
    }
    return result;
  }
  Polygon polygon(std::size_t holes) {
    Polygon result{ring(), {}};
    for (std::size_t i = below(holes + 1); i > 0; --i) result.holes.push_back(ring());
    return result;
  }

 private:
  std::mt19937 random_;
};

std::string joined(const std::vector<std::string>& items, const std::string& between) {
  std::string result;
  for (const std::string& item : items) result += (result.empty() ? "" : between) + item;
  return result;
}

using Writer = std::function<std::string(Position)>;

// With the first position again at the end, unless the format leaves it out.
std::string ring_text(const Ring& ring, const Writer& write, const std::string& between,
                      bool is_closed = true) {
  std::vector<std::string> items;
  for (const Position position : ring.positions) items.push_back(write(position));
  if (is_closed) items.push_back(items.front());
  return joined(items, between);
}

std::string json_longitude_first(Position position) {
  return "[" + text_of(position.x) + "," + text_of(position.y) + "]";
}
std::string json_latitude_first(Position position) {
  return json_longitude_first({position.y, position.x});
}

std::vector<const Ring*> rings_of(const Polygon& polygon) {
  std::vector<const Ring*> result{&polygon.outer};
  for (const Ring& hole : polygon.holes) result.push_back(&hole);
  return result;
}

std::string json_rings(const Polygon& polygon) {
  std::vector<std::string> rings;
  for (const Ring* ring : rings_of(polygon)) {
    rings.push_back("[" + ring_text(*ring, json_longitude_first, ",") + "]");
  }
  return "[" + joined(rings, ",") + "]";
}

std::string geojson(const Polygon& polygon) {
  return R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":)" +
         json_rings(polygon) + "}}";
}
std::string ed318(const Polygon& polygon) {
  return R"({"type":"Feature","properties":{"identifier":"A","type":"CONDITIONAL"},"geometry":{"type":"Polygon","coordinates":)" +
         json_rings(polygon) + "}}";
}
std::string ed269(const Polygon& polygon) {
  return R"({"features":[{"identifier":"A","restriction":"CONDITIONAL","applicability":[{"permanent":"YES"}],"geometry":[{"uomDimensions":"M","horizontalProjection":{"type":"Polygon","coordinates":)" +
         json_rings(polygon) + "}}]}]}";
}
std::string wkt(const Polygon& polygon) {
  const auto write = [](Position position) {
    return text_of(position.x) + " " + text_of(position.y);
  };
  std::vector<std::string> rings;
  for (const Ring* ring : rings_of(polygon)) {
    rings.push_back("(" + ring_text(*ring, write, ", ") + ")");
  }
  return "POLYGON (" + joined(rings, ", ") + ")";
}
std::string kml(const Polygon& polygon) {
  const auto write = [](Position position) {
    return text_of(position.x) + "," + text_of(position.y);
  };
  std::string result = "<kml><Placemark><Polygon>";
  for (const Ring* ring : rings_of(polygon)) {
    const std::string boundary = ring == &polygon.outer ? "outerBoundaryIs" : "innerBoundaryIs";
    result += "<" + boundary + "><LinearRing><coordinates>" + ring_text(*ring, write, "\n") +
              "</coordinates></LinearRing></" + boundary + ">";
  }
  return result + "</Polygon></Placemark></kml>";
}
std::string plan(const Polygon& polygon) {
  return R"({"fileType":"Plan","version":1,"geoFence":{"version":2,"circles":[],"polygons":[{"version":1,"inclusion":true,"polygon":[)" +
         ring_text(polygon.outer, json_latitude_first, ",", false) + "]}]}}";
}
std::string waypoints(const Polygon& polygon) {
  const std::string count = std::to_string(polygon.outer.positions.size());
  int index = 0;
  const auto write = [&](Position position) {
    return std::to_string(index++) + "\t0\t3\t5001\t" + count + "\t0\t0\t0\t" +
           text_of(position.y) + "\t" + text_of(position.x) + "\t0\t1";
  };
  return "QGC WPL 110\n" + ring_text(polygon.outer, write, "\n", false) + "\n";
}

struct Style {
  Format format;
  std::string (*write)(const Polygon&);
  std::size_t holes;  // at most
};

const std::vector<Style>& styles() {
  static const std::vector<Style> all{{Format::geojson, geojson, 3},
                                      {Format::wkt, wkt, 3},
                                      {Format::kml, kml, 3},
                                      {Format::qgc_plan, plan, 0},
                                      {Format::waypoints, waypoints, 0},
                                      {Format::ed269, ed269, 3},
                                      {Format::ed318, ed318, 3}};
  return all;
}

bool has_same_positions(const Ring& a, const Ring& b) {
  return std::equal(a.positions.begin(), a.positions.end(), b.positions.begin(), b.positions.end(),
                    [](Position p, Position q) { return p == q; });
}

TEST(RoundTrip, PolygonsAreTheSame) {
  Choices choices(4);
  for (const Style& style : styles()) {
    for (std::size_t round = 0; round < rounds; ++round) {
      const Polygon polygon = choices.polygon(style.holes);
      const std::string text = style.write(polygon);
      const Area area = only_area(style.format, text);
      ASSERT_EQ(area.parts.size(), 1U) << text;
      const Polygon& read_again = polygon_of(area);
      ASSERT_TRUE(has_same_positions(polygon.outer, read_again.outer)) << text;
      ASSERT_EQ(polygon.holes.size(), read_again.holes.size()) << text;
      for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
        ASSERT_TRUE(has_same_positions(polygon.holes[i], read_again.holes[i])) << text;
      }
    }
  }
}

TEST(RoundTrip, ChangedTextsEndInAreasOrAFailure) {
  const std::string bytes = "0123456789.,-+eE \n\t\"[]{}()<>/:;&#xX\xff";
  Choices choices(5);
  for (const Style& style : styles()) {
    for (std::size_t round = 0; round < rounds; ++round) {
      std::string text = style.write(choices.polygon(style.holes));
      for (std::size_t i = 1 + choices.below(3); i > 0; --i) {
        const std::size_t at = choices.below(text.size());
        switch (choices.below(3)) {
          case 0:
            text[at] = bytes[choices.below(bytes.size())];
            break;
          case 1:
            text.erase(at, 1 + choices.below(5));
            break;
          default:
            text.insert(at, text.substr(choices.below(text.size()), 1 + choices.below(20)));
        }
      }
      failure_of(style.format, text);
    }
  }
}

// 10^7 vertices are refused after the first two million of them, whatever the format.
TEST(RoundTrip, EnormousOutlinesAreRefused) {
  constexpr std::size_t vertices = 10'000'000;
  const auto repeated = [](const std::string& begin, const std::string& item) {
    std::string text = begin;
    text.reserve(begin.size() + vertices * item.size());
    for (std::size_t i = 0; i < vertices; ++i) text += item;
    return text;
  };
  const std::string json = repeated(R"({"type":"Polygon","coordinates":[[)", "[1,2],");
  EXPECT_TRUE(contains(failure_of(Format::geojson, json), "more than 2000000 positions"));
  EXPECT_TRUE(contains(failure_of(Format::ed269, json), "more than 2000000 positions"));
  EXPECT_TRUE(contains(failure_of(Format::wkt, repeated("POLYGON((", "1 2,")),
                       "more than 2000000 positions"));
  EXPECT_TRUE(contains(failure_of(Format::kml, repeated("<kml><Placemark><Polygon><outerBoundaryIs>"
                                                        "<LinearRing><coordinates>",
                                                        "1,2 ") +
                                                   "</coordinates></LinearRing></outerBoundaryIs>"
                                                   "</Polygon></Placemark></kml>"),
                       "more than 2000000 positions"));
  EXPECT_TRUE(contains(
      failure_of(Format::waypoints, repeated("QGC WPL 110\n", "0 0 0 5003 9 0 0 0 1 2 0 1\n")),
      "at most 268435456 are read"));
}

TEST(RoundTrip, EnormousTextsAndNumbersAreRefused) {
  std::string many;
  many.resize(20'000'000, '1');
  EXPECT_LT(failure_of(Format::geojson, R"({"type":")" + many + "\"}").size(), 300U);
  EXPECT_LT(failure_of(Format::geojson, R"({"type":)" + many + "}").size(), 300U);
  EXPECT_LT(failure_of(Format::wkt, "POLYGON((" + many + " 0").size(), 300U);
  EXPECT_LT(failure_of(Format::kml, "<kml><" + many).size(), 300U);
  EXPECT_LT(failure_of(Format::waypoints, "QGC WPL 110\n" + many).size(), 300U);
}

}  // namespace
}  // namespace rtac::geometry::import
