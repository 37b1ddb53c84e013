// One self-contained SVG of a run: a map for each robot with the zone and its holes, the robot's
// path in two colours (advanced and safe controller), switch points as numbered pins with their
// reasons, and a legend beside the maps. The same input gives the same bytes, whatever the locale.
#pragma once

#include <string>
#include <vector>

#include "rtac/sim/recorder.h"
#include "rtac/zone.h"

namespace rtac::sim {

struct NamedPlace {
  Vec2 place;
  std::string name;  // may be empty
};

inline constexpr int every_robot = -1;

struct Destination {
  Vec2 place;
  std::string name;         // may be empty
  bool reached = true;      // false: given up
  int robot = every_robot;  // whose map shows it
};

// Where a requirement was broken, by the true state.
struct ViolationMark {
  Vec2 place;
  std::string text;  // "SR-1"
  int robot = every_robot;
};

struct Picture {
  std::string title;
  std::vector<std::string> notes;        // lines below the title
  ZoneView zone;                         // its tables must outlive the call
  std::vector<std::string> robot_names;  // by index; missing ones become "robot 1", ...
  double radius_m = 0;                   // of the bodies, drawn at the starts
  std::vector<NamedPlace> docks;
  std::vector<Destination> destinations;
  std::vector<ViolationMark> violations;
  std::string advanced_controller;  // its name for the legend, may be empty
};

// Points and switches come from `recorder`. Every switch is a dot; at most 40 pins name reasons:
// nearby switches for the same reason share one, pins and labels that would overlap are left out,
// and the legend counts every reason.
std::string draw_svg(const Picture& picture, const Recorder& recorder);

// What the words of a reason mean ("leg 2 (r1)": a leg of the plan ...); empty for other texts.
std::string reason_meaning(const std::string& reason);

// Whole or not at all: writes beside `path` and renames; what is no ordinary file, such as a
// device, is written to as it is. False: it could not be written, and errno says why.
[[nodiscard]] bool write_text_file(const std::string& path, const std::string& text);

}  // namespace rtac::sim
