#include "rtac/sim/picture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "rtac/decision_text.h"
#include "rtac/sim/math.h"
#include "rtac/sim/random.h"
#include "tests/runtime/sim/scene.h"

namespace rtac::sim::testing {
namespace {

std::vector<TruthState> two_at(Vec2 a, Vec2 b) {
  std::vector<TruthState> truths(2);
  truths[0].position = a;
  truths[1].position = b;
  return truths;
}

// Two robots; the first meets the pillar and is turned back, the second drives undisturbed.
Recorder small_run() {
  Recorder recorder(2);
  for (TimeUs i = 0; i <= 60; ++i) {
    const TimeUs t = i * 50 * ms;
    const auto k = static_cast<double>(i);
    const double x = 0.5 + (i <= 30 ? 0.045 * k : 1.35 - 0.02 * (k - 30));
    recorder.observe(t, two_at({x, 2.5}, {3.5, 0.5 + 0.05 * k}));
    const bool safe = i >= 28 && i < 50;
    recorder.mode(0, t, safe ? 1 : 0, safe ? "turn_back" : "follow_plan",
                  safe ? "geofence: leg 0 < margin" : "");
    recorder.mode(1, t, 0, "follow_plan", "");
  }
  return recorder;
}

Picture small_picture(const Room& room) {
  Picture picture;
  picture.title = "Boxes & \"walls\" <test>";
  picture.notes = {"one line below"};
  picture.zone = room.view();
  picture.robot_names = {"r1", "r2"};
  picture.radius_m = 0.11;
  picture.docks = {{{1, 1}, "dock(r1)"}};
  picture.destinations = {{{3.5, 3.5}, "", true, 1}, {{0.5, 3.5}, "shop", false, 0}};
  picture.advanced_controller = "follow_plan";
  return picture;
}

// Every element closes in order and no bare special character stands in text or attributes.
bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < xml.size(); ++i) {
    if (xml[i] == '&') {
      const std::size_t end = xml.find(';', i);
      if (end == std::string::npos || end - i > 6) return false;
    }
    if (xml[i] == '>') return false;
    if (xml[i] != '<') continue;
    const std::size_t end = xml.find('>', i);
    if (end == std::string::npos || xml.find('<', i + 1) < end) return false;
    const std::string tag = xml.substr(i + 1, end - i - 1);
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
    }
    i = end;
  }
  return open.empty();
}

int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++count;
  return count;
}

TEST(Recorder, KeepsSwitchesWithTimePlaceAndReason) {
  const Recorder recorder = small_run();
  ASSERT_EQ(recorder.switches().size(), 2u);
  const SwitchEvent& event = recorder.switches()[0];
  EXPECT_EQ(event.time_us, 1400 * ms);
  EXPECT_NEAR(event.place.x, 0.5 + 0.045 * 28, 1e-12);
  EXPECT_EQ(event.mode, 1);
  EXPECT_EQ(event.controller, "turn_back");
  EXPECT_EQ(recorder.switches()[1].previous_mode, 1);
}

TEST(Recorder, SamplesEveryFiftyMilliseconds) {
  Recorder recorder(1);
  std::vector<TruthState> truths(1);
  for (TimeUs t = 0; t <= 1 * s; t += 1 * ms) recorder.observe(t, truths);
  EXPECT_EQ(recorder.track(0).size(), 21u);
}

TEST(Recorder, MeasuresTheAdvancedShareInTime) {
  const Recorder recorder = small_run();
  EXPECT_NEAR(recorder.advanced_share(0), (60 - 22) / 60.0, 1e-12);
  EXPECT_EQ(recorder.advanced_share(1), 1);
}

TEST(Picture, IsWellFormedWhateverTheTexts) {
  const Room room;
  Picture picture = small_picture(room);
  picture.title = "<&>\"' \x01 \xff \xc3\xa9";
  picture.robot_names = {"</svg>", "\xe2\x82"};
  const std::string svg = draw_svg(picture, small_run());
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_NE(svg.find("&lt;&amp;&gt;&quot;&#39; ? ? \xc3\xa9"), std::string::npos);
}

TEST(Picture, MatchesTheGolden) {
  // RTAC_BLESS=1 rewrites the golden from the present output.
  const Room room;
  const std::string svg = draw_svg(small_picture(room), small_run());
  EXPECT_TRUE(is_well_formed(svg));
  const std::string path = RTAC_SOURCE_DIR "/tests/runtime/sim/golden/small_run.svg";
  if (std::getenv("RTAC_BLESS") != nullptr) {
    ASSERT_TRUE(write_text_file(path, svg));
  }
  std::ifstream file(path, std::ios::binary);
  const std::string golden{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(svg == golden) << "the picture differs from " << path;
}

// The map of one robot: the group of its path.
std::string path_group(const std::string& svg, int robot) {
  std::size_t from = 0;
  for (int i = 0; i <= robot; ++i) from = svg.find("class=\"path\"", from + 1);
  return svg.substr(from, svg.find("</g>", from) - from);
}

// Advanced and safe controller are told apart by colour, robots by having a map each.
TEST(Picture, UsesExactlyTwoColoursForThePaths) {
  const Room room;
  const std::string svg = draw_svg(small_picture(room), small_run());
  ASSERT_EQ(occurrences(svg, "class=\"path\""), 2);
  const std::string first = path_group(svg, 0), second = path_group(svg, 1);
  EXPECT_EQ(occurrences(first, "<path"), 2);
  EXPECT_EQ(occurrences(first, "stroke=\"#0072B2\""), 1);
  EXPECT_EQ(occurrences(first, "stroke=\"#D55E00\""), 1);
  EXPECT_EQ(occurrences(second, "<path"), 1);
  EXPECT_EQ(occurrences(second, "stroke=\"#0072B2\""), 1);
}

// A robot alone needs no name above its map, and gets a larger one.
TEST(Picture, GivesARobotAloneTheWholeRoom) {
  const Room room;
  Recorder alone(1);
  alone.observe(0, two_at({1, 1}, {2, 2}));
  const std::string one = draw_svg(small_picture(room), alone);
  EXPECT_EQ(occurrences(one, "<clipPath"), 1);
  EXPECT_NE(one.find("width=\"720.0\""), std::string::npos);
  EXPECT_EQ(occurrences(draw_svg(small_picture(room), Recorder(5)), "<clipPath"), 5);
}

// Reached and skipped destinations look different, on the map of their robot and in the legend.
TEST(Picture, TellsReachedFromSkippedDestinations) {
  const Room room;
  Picture picture = small_picture(room);
  const std::string both = draw_svg(picture, small_run());
  EXPECT_EQ(occurrences(both, "fill=\"#8fc98f\""), 2);  // a diamond on one map, one in the legend
  EXPECT_EQ(occurrences(both, "destination, skipped"), 1);
  EXPECT_EQ(occurrences(both, ">shop</text>"), 2);  // text and its halo, on one map
  picture.destinations.pop_back();
  EXPECT_EQ(occurrences(draw_svg(picture, small_run()), "destination, skipped"), 0);
}

// A violated requirement is marked where it was worst; a clean run does not mention any.
TEST(Picture, MarksViolations) {
  const Room room;
  Picture picture = small_picture(room);
  EXPECT_EQ(occurrences(draw_svg(picture, small_run()), "violated"), 0);
  picture.violations = {{{2, 2}, "SR-1", 0}};
  const std::string svg = draw_svg(picture, small_run());
  EXPECT_EQ(occurrences(svg, ">SR-1</text>"), 2);  // text and its halo
  EXPECT_EQ(occurrences(svg, "stroke=\"#b00020\""), 2);
}

// No word of a decision record's reason is left without an explanation in the legend.
TEST(Picture, ExplainsEveryReason) {
  const MonitorInfo monitor{};
  const DecisionInfo info{"", "", "", "", &monitor, 1, 1};
  DecisionRecord record;
  record.info = &info;
  int reasons = 0;
  for (int k = 1; k <= INT8_MAX; ++k) {
    record.reason = static_cast<Reason>(k);
    char text[100];
    if (reason_text(record, text, sizeof text) == 0) break;
    EXPECT_NE(reason_meaning(text), "") << text;
    ++reasons;
  }
  EXPECT_GE(reasons, static_cast<int>(Reason::surrendered));
  EXPECT_EQ(reason_meaning("something else"), "");
}

// Switches at random places, all for one of five reasons.
Recorder busy_run(int switches) {
  Recorder recorder(2);
  Random random(8);
  for (int i = 0; i < switches; ++i) {
    const TimeUs t = i * s;
    recorder.observe(t, two_at({random.uniform(0, 4), random.uniform(0, 4)}, {1, 1}));
    const std::string reason = "reason " + std::to_string(random.below(5));
    recorder.mode(0, t, i % 2, i % 2 == 1 ? "turn_back" : "follow_plan", reason);
  }
  return recorder;
}

// Centres of the pins' heads.
std::vector<Vec2> pins_of(const std::string& svg) {
  std::vector<Vec2> centres;
  const std::string head = " r=\"8.0\"";
  for (std::size_t i = svg.find(head); i != std::string::npos; i = svg.find(head, i + 1)) {
    const std::size_t from = svg.rfind("<circle", i);
    Vec2 centre;
    if (std::sscanf(svg.c_str() + from, "<circle cx=\"%lf\" cy=\"%lf\"", &centre.x, &centre.y) ==
        2) {
      centres.push_back(centre);
    }
  }
  return centres;
}

// A crowd of switches stays readable: a limited number of pins, none over another one; every
// switch is counted, and has a dot.
TEST(Picture, ShowsAtMostFortyPinsAndCountsEverySwitch) {
  const Room room;
  const std::string svg = draw_svg(small_picture(room), busy_run(1000));
  EXPECT_TRUE(is_well_formed(svg));
  const std::vector<Vec2> pins = pins_of(svg);
  EXPECT_GE(pins.size(), 15u);
  EXPECT_LE(pins.size(), 41u);  // with the one of the legend
  for (std::size_t i = 0; i < pins.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_GE(length(pins[i] - pins[k]), 16.0) << i << " " << k;
  }
  EXPECT_GT(occurrences(svg, "r=\"2.2\" fill=\"#222222\""), 300);  // those nearby share a dot
  EXPECT_NE(svg.find(">499</text>"), std::string::npos);  // returns: the run starts advanced
  EXPECT_EQ(occurrences(svg, ">turn_back</text>"), 1);    // one list for each safe controller
  for (int k = 0; k < 5; ++k) {
    EXPECT_NE(svg.find(">reason " + std::to_string(k) + " \u2013 pin"), std::string::npos) << k;
  }
}

TEST(Picture, OfNothingIsStillAPicture) {
  const std::string svg = draw_svg(Picture{}, Recorder(0));
  EXPECT_TRUE(is_well_formed(svg));
}

TEST(TextFile, IsWrittenWholeOrNotAtAll) {
  EXPECT_FALSE(write_text_file("/nowhere/at/all.svg", "text"));
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / "rtac_sim_picture_test.txt";
  EXPECT_TRUE(write_text_file(path.string(), "whole"));
  std::ifstream file(path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "whole");
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".tmp"));
  std::filesystem::remove(path);
}

// Renaming onto them would leave an ordinary file in their place.
TEST(TextFile, DevicesAndLinksStayWhatTheyAre) {
  namespace fs = std::filesystem;
  EXPECT_TRUE(write_text_file("/dev/null", "text"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  if (fs::is_character_file("/dev/full")) {
    EXPECT_FALSE(write_text_file("/dev/full", "text"));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
  }
  const fs::path folder = fs::temp_directory_path() / "rtac_sim_picture_test";
  fs::create_directories(folder);
  EXPECT_FALSE(write_text_file(folder.string(), "text"));
  std::ofstream(folder / "file") << "before";
  fs::create_symlink("file", folder / "link");
  EXPECT_TRUE(write_text_file((folder / "link").string(), "after"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  std::ifstream file(folder / "file");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "after");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace rtac::sim::testing
