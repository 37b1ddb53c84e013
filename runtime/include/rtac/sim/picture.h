// One self-contained SVG of a run: the zone with its holes, the paths in two colours (advanced and
// safe controller), switch points as numbered pins with their reasons, and a legend beside the
// map. The same input gives the same bytes, whatever the locale.
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

struct Picture {
  std::string title;
  std::vector<std::string> notes;        // lines below the title
  ZoneView zone;                         // its tables must outlive the call
  std::vector<std::string> robot_names;  // by index; missing ones become "robot 1", ...
  double radius_m = 0;                   // of the bodies, drawn at the starts
  std::vector<NamedPlace> docks, destinations;
  std::string advanced_controller;  // its name for the legend, may be empty
};

// Points and switches come from `recorder`. At most 40 pins: nearby switches for the same reason
// share one, labels that would overlap are left out, and the legend counts every reason.
std::string draw_svg(const Picture& picture, const Recorder& recorder);

// Whole or not at all: writes beside `path` and renames. False: the file could not be written.
[[nodiscard]] bool write_text_file(const std::string& path, const std::string& text);

}  // namespace rtac::sim
