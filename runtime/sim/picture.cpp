#include "rtac/sim/picture.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <vector>

#include "legend.h"
#include "panel.h"
#include "pins.h"
#include "svg.h"

namespace rtac::sim {
namespace {

// Longer side of a map: one alone, or as many side by side as make a square of maps.
constexpr double lone_map_px = 720, maps_px = 1160, map_px_min = 240;
constexpr double edge_px = 56;    // left and below a map, for the axes
constexpr double top_px = 16;     // above the first line of text
constexpr double name_px = 26;    // above a map, for the name of its robot
constexpr double margin_m = 0.3;  // shown around the zone
constexpr std::size_t max_pins = 40, panel_pins_min = 6;

struct Layout {
  std::vector<Panel> panels;
  double width_px = 0, height_px = 0;
  Vec2 legend;
};

void include(Panel& panel, Vec2 place) {
  panel.lo_m = {std::min(panel.lo_m.x, place.x), std::min(panel.lo_m.y, place.y)};
  panel.hi_m = {std::max(panel.hi_m.x, place.x), std::max(panel.hi_m.y, place.y)};
}

// The same for all robots, so that their maps can be compared.
Panel common_extent(const Picture& picture, const Recorder& recorder) {
  Panel panel;
  panel.lo_m = {HUGE_VAL, HUGE_VAL};
  panel.hi_m = {-HUGE_VAL, -HUGE_VAL};
  for (std::size_t i = 0; i < picture.zone.edge_count; ++i) {
    include(panel, {1e-3 * picture.zone.edges_mm[4 * i], 1e-3 * picture.zone.edges_mm[4 * i + 1]});
  }
  for (const NamedPlace& dock : picture.docks) include(panel, dock.place);
  for (const Destination& goal : picture.destinations) include(panel, goal.place);
  for (int robot = 0; robot < recorder.robots(); ++robot) {
    for (const TrackPoint& point : recorder.track(robot)) include(panel, point.place);
  }
  if (panel.lo_m.x > panel.hi_m.x) panel.lo_m = panel.hi_m = {0, 0};
  panel.lo_m = panel.lo_m - Vec2{margin_m, margin_m};
  panel.hi_m = panel.hi_m + Vec2{margin_m, margin_m};
  return panel;
}

Layout make_layout(const Picture& picture, const Recorder& recorder) {
  Layout layout;
  const int count = std::max(1, recorder.robots());
  const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
  const double side_px = columns == 1 ? lone_map_px : std::max(map_px_min, maps_px / columns);
  Panel panel = common_extent(picture, recorder);
  const Vec2 extent = panel.hi_m - panel.lo_m;
  const double scale = side_px / std::max(extent.x, extent.y);
  const double header_px = top_px + 26 + 17 * static_cast<double>(picture.notes.size());
  const double above_px = count > 1 ? name_px : 0;
  for (int i = 0; i < count; ++i) {
    panel.robot = i;
    const Vec2 cell{scale * extent.x + edge_px, scale * extent.y + edge_px + above_px};
    const int column = i % columns, row = i / columns;
    panel.map.lo = {edge_px + column * cell.x, header_px + above_px + row * cell.y};
    panel.map.hi = panel.map.lo + scale * extent;
    panel.projection = {
        {panel.map.lo.x - scale * panel.lo_m.x, panel.map.hi.y + scale * panel.lo_m.y}, scale};
    layout.panels.push_back(panel);
  }
  const double right_px = layout.panels[static_cast<std::size_t>(columns - 1)].map.hi.x;
  layout.legend = {right_px + legend_gap_px, header_px};
  layout.width_px = layout.legend.x + legend_width_px;
  layout.height_px = layout.panels.back().map.hi.y + edge_px;
  return layout;
}

void draw_definitions(SvgWriter& svg, const Layout& layout) {
  svg.raw(
      "<defs>\n<pattern id=\"outside\" width=\"9\" height=\"9\" patternUnits=\"userSpaceOnUse\" "
      "patternTransform=\"rotate(45)\"><rect width=\"9\" height=\"9\" fill=\"#ececec\"/>"
      "<line x1=\"0\" y1=\"0\" x2=\"0\" y2=\"9\" stroke=\"#cfcfcf\" stroke-width=\"2.4\"/>"
      "</pattern>\n");
  for (const Panel& panel : layout.panels) {
    svg.raw("<clipPath id=\"" + panel.clip_id() + "\">");
    svg.rect(panel.map.lo, panel.map.hi - panel.map.lo, "");
    svg.raw("</clipPath>\n");
  }
  svg.raw("</defs>\n");
}

void draw_header(SvgWriter& svg, const Picture& picture) {
  double y = top_px + 10;
  svg.text({edge_px, y}, picture.title, "font-size=\"19\" font-weight=\"bold\"");
  for (const std::string& note : picture.notes) {
    y += 17;
    svg.text({edge_px, y}, note, "font-size=\"12.5\" fill=\"#555555\"");
  }
}

// One board a robot, numbered on from map to map.
std::vector<PinBoard> place_all_pins(const Layout& layout, const Picture& picture,
                                     const Recorder& recorder) {
  std::vector<PinBoard> boards(layout.panels.size());
  const std::size_t pins = std::max(panel_pins_min, max_pins / layout.panels.size());
  std::size_t number = 1;
  for (int robot = 0; robot < recorder.robots(); ++robot) {
    const auto i = static_cast<std::size_t>(robot);
    const Panel& panel = layout.panels[i];
    std::vector<SwitchEvent> own;
    for (const SwitchEvent& event : recorder.switches()) {
      if (event.robot == robot) own.push_back(event);
    }
    const PinLimits limits{std::min(pins, max_pins + 1 - std::min(number, max_pins + 1)),
                           static_cast<int>(number)};
    boards[i] = place_pins(own, panel.projection, panel.map, symbol_boxes(panel, picture, recorder),
                           limits);
    number += boards[i].pins.size();
  }
  return boards;
}

}  // namespace

std::string draw_svg(const Picture& picture, const Recorder& recorder) {
  Layout layout = make_layout(picture, recorder);
  const std::vector<PinBoard> boards = place_all_pins(layout, picture, recorder);
  const double legend_end = layout.legend.y + legend_height_px(picture, recorder, boards);
  layout.height_px = std::max(layout.height_px, legend_end + 16);
  SvgWriter svg(layout.width_px, layout.height_px, picture.title);
  draw_definitions(svg, layout);
  svg.rect({0, 0}, {layout.width_px, layout.height_px}, "fill=\"#ffffff\"");
  svg.open_group("font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\" fill=\"#222222\"");
  draw_header(svg, picture);
  for (std::size_t i = 0; i < layout.panels.size(); ++i) {
    const Panel& panel = layout.panels[i];
    if (recorder.robots() > 1) {
      svg.text(panel.map.lo - Vec2{0, 9}, robot_name(picture, panel.robot),
               "font-size=\"15\" font-weight=\"bold\"");
    }
    draw_panel(svg, panel, picture, recorder, boards[i]);
  }
  draw_legend(svg, layout.legend, picture, recorder, boards);
  svg.close_group();
  return svg.finish();
}

namespace {

bool write_all(const std::string& path, const std::string& text) {
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const int error = errno;
  const bool closed = std::fclose(file) == 0;
  if (!written) errno = error;
  return written && closed;
}

}  // namespace

bool write_text_file(const std::string& path, const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status there = fs::status(path, error);
  // A device or a pipe stays what it is.
  if (fs::exists(there) && !fs::is_regular_file(there)) return write_all(path, text);
  // Renaming onto a link would replace the link.
  const fs::path target = fs::exists(there) ? fs::canonical(path, error) : fs::path(path);
  const std::string beside = target.string() + ".tmp";
  if (write_all(beside, text) && std::rename(beside.c_str(), target.c_str()) == 0) return true;
  const int why = errno;
  static_cast<void>(std::remove(beside.c_str()));
  errno = why;
  return false;
}

}  // namespace rtac::sim
