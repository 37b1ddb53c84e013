#include "rtac/sim/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "legend.h"
#include "pins.h"
#include "rtac/sim/math.h"
#include "rtac/sim/table.h"
#include "svg.h"

namespace rtac::sim {
namespace {

constexpr double map_side_px = 720;   // the longer side
constexpr double edge_px = 56;        // left and below the map, for the axes
constexpr double top_px = 16;         // above the first line of text
constexpr double margin_m = 0.3;      // shown around the zone
constexpr double path_step_px = 1.5;  // finer detail of a path is not drawn

struct Layout {
  Box map;  // pixels
  Vec2 lo_m, hi_m;
  Projection projection;
  double width_px = 0, height_px = 0, header_px = 0;
};

void include(Layout& layout, Vec2 place) {
  layout.lo_m = {std::min(layout.lo_m.x, place.x), std::min(layout.lo_m.y, place.y)};
  layout.hi_m = {std::max(layout.hi_m.x, place.x), std::max(layout.hi_m.y, place.y)};
}

void find_extent(Layout& layout, const Picture& picture, const Recorder& recorder) {
  layout.lo_m = {HUGE_VAL, HUGE_VAL};
  layout.hi_m = {-HUGE_VAL, -HUGE_VAL};
  for (std::size_t i = 0; i < picture.zone.edge_count; ++i) {
    include(layout, {1e-3 * picture.zone.edges_mm[4 * i], 1e-3 * picture.zone.edges_mm[4 * i + 1]});
  }
  for (const NamedPlace& dock : picture.docks) include(layout, dock.place);
  for (const NamedPlace& goal : picture.destinations) include(layout, goal.place);
  for (int robot = 0; robot < recorder.robots(); ++robot) {
    for (const TrackPoint& point : recorder.track(robot)) include(layout, point.place);
  }
  if (layout.lo_m.x > layout.hi_m.x) layout.lo_m = layout.hi_m = {0, 0};
  layout.lo_m = layout.lo_m - Vec2{margin_m, margin_m};
  layout.hi_m = layout.hi_m + Vec2{margin_m, margin_m};
}

Layout make_layout(const Picture& picture, const Recorder& recorder) {
  Layout layout;
  find_extent(layout, picture, recorder);
  const Vec2 extent = layout.hi_m - layout.lo_m;
  const double scale = map_side_px / std::max(extent.x, extent.y);
  layout.header_px = top_px + 26 + 17 * static_cast<double>(picture.notes.size());
  layout.map.lo = {edge_px, layout.header_px};
  layout.map.hi = layout.map.lo + scale * extent;
  layout.projection = {
      {layout.map.lo.x - scale * layout.lo_m.x, layout.map.hi.y + scale * layout.lo_m.y}, scale};
  layout.width_px = layout.map.hi.x + legend_gap_px + legend_width_px;
  layout.height_px = layout.map.hi.y + edge_px;
  return layout;
}

void draw_definitions(SvgWriter& svg, const Layout& layout) {
  svg.raw(
      "<defs>\n<pattern id=\"outside\" width=\"9\" height=\"9\" patternUnits=\"userSpaceOnUse\" "
      "patternTransform=\"rotate(45)\"><rect width=\"9\" height=\"9\" fill=\"#ececec\"/>"
      "<line x1=\"0\" y1=\"0\" x2=\"0\" y2=\"9\" stroke=\"#cfcfcf\" stroke-width=\"2.4\"/>"
      "</pattern>\n<clipPath id=\"map\">");
  svg.rect(layout.map.lo, layout.map.hi - layout.map.lo, "");
  svg.raw("</clipPath>\n</defs>\n");
}

void draw_header(SvgWriter& svg, const Picture& picture) {
  double y = top_px + 10;
  svg.text({edge_px, y}, picture.title, "font-size=\"19\" font-weight=\"bold\"");
  for (const std::string& note : picture.notes) {
    y += 17;
    svg.text({edge_px, y}, note, "font-size=\"12.5\" fill=\"#555555\"");
  }
}

std::string zone_outline(const ZoneView& zone, const Projection& projection) {
  std::string data;
  for (std::size_t ring = 0; ring < zone.ring_count; ++ring) {
    const std::size_t first = zone.ring_start[ring];
    const std::size_t end =
        ring + 1 < zone.ring_count ? zone.ring_start[ring + 1] : zone.edge_count;
    for (std::size_t i = first; i < end; ++i) {
      const Vec2 corner{1e-3 * zone.edges_mm[4 * i], 1e-3 * zone.edges_mm[4 * i + 1]};
      data += (i == first ? "M" : "L") + pixels(projection(corner));
    }
    if (end > first) data += "Z";
  }
  return data;
}

// 1, 2 or 5 times a power of ten, so that about ten lines cross the map.
double grid_step_m(double extent_m) {
  double step = 1;
  while (extent_m / step > 12) step *= 10;
  while (extent_m / step < 1.2) step /= 10;
  if (extent_m / step < 2.5) return step / 5;
  return extent_m / step < 3.5 ? step / 2 : step;
}

std::string tick_text(double value, double step) {
  return fixed(value, step >= 1 ? 0 : (step >= 0.1 ? 1 : 2));
}

void draw_ticks(SvgWriter& svg, const Layout& layout, bool labels) {
  const Vec2 extent = layout.hi_m - layout.lo_m;
  const double step = grid_step_m(std::max(extent.x, extent.y));
  const Box& map = layout.map;
  for (double k = std::ceil(layout.lo_m.x / step); k * step <= layout.hi_m.x; ++k) {
    const double x = layout.projection({k * step, 0}).x;
    if (!labels) {
      svg.line({x, map.lo.y}, {x, map.hi.y}, "");
    } else {
      svg.line({x, map.hi.y}, {x, map.hi.y + 5}, "stroke=\"#444444\"");
      svg.text({x, map.hi.y + 19}, tick_text(k * step, step), "text-anchor=\"middle\"");
    }
  }
  for (double k = std::ceil(layout.lo_m.y / step); k * step <= layout.hi_m.y; ++k) {
    const double y = layout.projection({0, k * step}).y;
    if (!labels) {
      svg.line({map.lo.x, y}, {map.hi.x, y}, "");
    } else {
      svg.line({map.lo.x - 5, y}, {map.lo.x, y}, "stroke=\"#444444\"");
      svg.text({map.lo.x - 9, y + 4}, tick_text(k * step, step), "text-anchor=\"end\"");
    }
  }
}

void draw_zone(SvgWriter& svg, const Layout& layout, const ZoneView& zone) {
  svg.rect(layout.map.lo, layout.map.hi - layout.map.lo, "fill=\"url(#outside)\"");
  const std::string outline = zone_outline(zone, layout.projection);
  svg.path(outline, "fill=\"#ffffff\" fill-rule=\"evenodd\"");
  svg.open_group("stroke=\"#000000\" stroke-opacity=\"0.09\" stroke-width=\"1\"");
  draw_ticks(svg, layout, false);
  svg.close_group();
  svg.path(outline, "fill=\"none\" stroke=\"#333333\" stroke-width=\"1.6\"");
}

void draw_axes(SvgWriter& svg, const Layout& layout) {
  svg.rect(layout.map.lo, layout.map.hi - layout.map.lo, "fill=\"none\" stroke=\"#444444\"");
  svg.open_group("font-size=\"12\" fill=\"#333333\"");
  draw_ticks(svg, layout, true);
  const Vec2 centre = 0.5 * (layout.map.lo + layout.map.hi);
  svg.text({centre.x, layout.map.hi.y + 40}, "x (m)", "text-anchor=\"middle\"");
  const Vec2 side{layout.map.lo.x - 38, centre.y};
  svg.text(side, "y (m)",
           "text-anchor=\"middle\" transform=\"rotate(-90 " + pixels(side.x) + " " +
               pixels(side.y) + ")\"");
  svg.close_group();
}

// The stretches of one robot that one kind of controller drove, as sub-paths of one element.
std::string path_data(const std::vector<TrackPoint>& track, bool safe,
                      const Projection& projection) {
  std::string data;
  Vec2 drawn{};
  bool is_open = false;
  for (std::size_t i = 0; i + 1 < track.size(); ++i) {
    if ((track[i].mode != 0) != safe) {
      is_open = false;
      continue;
    }
    const Vec2 from = projection(track[i].place);
    const Vec2 to = projection(track[i + 1].place);
    if (!is_open) {
      data += "M" + pixels(from);
      drawn = from;
      is_open = true;
    }
    const bool ends = i + 2 == track.size() || (track[i + 1].mode != 0) != safe;
    if (length(to - drawn) < path_step_px && !ends) continue;
    data += "L" + pixels(to);
    drawn = to;
  }
  return data;
}

void draw_paths(SvgWriter& svg, const Layout& layout, const Recorder& recorder) {
  svg.open_group(
      "fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"butt\" clip-path=\"url(#map)\"");
  for (const bool safe : {false, true}) {
    for (int robot = 0; robot < recorder.robots(); ++robot) {
      const std::string data = path_data(recorder.track(robot), safe, layout.projection);
      if (!data.empty()) svg.path(data, path_style(robot, safe));
    }
  }
  svg.close_group();
}

void draw_destinations(SvgWriter& svg, const Layout& layout, const Picture& picture) {
  for (const NamedPlace& goal : picture.destinations) {
    const Vec2 at = layout.projection(goal.place);
    draw_destination(svg, at);
    if (goal.name.empty()) continue;
    svg.text_with_halo(at + Vec2{0, 17}, goal.name,
                       "font-size=\"10.5\" text-anchor=\"middle\" fill=\"#555555\"");
  }
}

void draw_docks(SvgWriter& svg, const Layout& layout, const Picture& picture) {
  for (const NamedPlace& dock : picture.docks) {
    const Vec2 at = layout.projection(dock.place);
    draw_dock(svg, at);
    if (dock.name.empty()) continue;
    svg.text_with_halo(at + Vec2{0, 21}, dock.name, "font-size=\"11\" text-anchor=\"middle\"");
  }
}

// What pins and labels must not cover.
std::vector<Box> symbol_boxes(const Layout& layout, const Picture& picture,
                              const Recorder& recorder) {
  std::vector<Box> boxes;
  for (const NamedPlace& dock : picture.docks) {
    const Vec2 at = layout.projection(dock.place);
    const double half_name = 0.5 * text_width_px(dock.name, 11);
    boxes.push_back(around(at, 10));
    boxes.push_back({at + Vec2{-half_name, 10}, at + Vec2{half_name, 24}});
  }
  for (int robot = 0; robot < recorder.robots(); ++robot) {
    if (recorder.track(robot).empty()) continue;
    const Vec2 at = layout.projection(recorder.track(robot).front().place);
    const double name_px = text_width_px(robot_name(picture, robot), 12);
    const double radius = std::max(start_radius_px, picture.radius_m * layout.projection.scale);
    boxes.push_back(around(at, start_radius_px + 2));
    boxes.push_back({at - Vec2{0, 8}, at + Vec2{radius + start_name_px + name_px, 8}});
  }
  return boxes;
}

void draw_starts(SvgWriter& svg, const Layout& layout, const Picture& picture,
                 const Recorder& recorder) {
  for (int robot = 0; robot < recorder.robots(); ++robot) {
    if (recorder.track(robot).empty()) continue;
    const Vec2 at = layout.projection(recorder.track(robot).front().place);
    const double radius = picture.radius_m * layout.projection.scale;
    if (radius > start_radius_px) {
      svg.circle(at, radius, "fill=\"none\" stroke=\"#222222\" stroke-dasharray=\"2 2\"");
    }
    draw_start(svg, at, std::max(radius, start_radius_px), robot_name(picture, robot));
  }
}

void draw_pins(SvgWriter& svg, const PinBoard& board) {
  for (const Vec2 at : board.returns_px) {
    svg.circle(at, 2.2, "fill=\"#ffffff\" stroke=\"#0072B2\" stroke-width=\"1.2\"");
  }
  for (const Pin& pin : board.pins) {
    svg.line(pin.point_px, pin.centre_px, "stroke=\"#222222\" stroke-width=\"1\"");
    svg.circle(pin.point_px, 2.2, "fill=\"#222222\"");
  }
  for (const Pin& pin : board.pins) {
    if (!pin.has_label) continue;
    const Box& box = pin.label_box;
    svg.text_with_halo({box.lo.x + 2, box.hi.y - 3.5}, pin.label, "font-size=\"10.5\"");
  }
  for (const Pin& pin : board.pins) draw_pin(svg, pin);
}

}  // namespace

std::string draw_svg(const Picture& picture, const Recorder& recorder) {
  Layout layout = make_layout(picture, recorder);
  const PinBoard board = place_pins(recorder.switches(), layout.projection, layout.map,
                                    symbol_boxes(layout, picture, recorder));
  const Vec2 legend_corner{layout.map.hi.x + legend_gap_px, layout.map.lo.y};
  const double legend_end = legend_corner.y + legend_height_px(picture, recorder, board);
  layout.height_px = std::max(layout.height_px, legend_end + 16);
  SvgWriter svg(layout.width_px, layout.height_px, picture.title);
  draw_definitions(svg, layout);
  svg.rect({0, 0}, {layout.width_px, layout.height_px}, "fill=\"#ffffff\"");
  svg.open_group("font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\" fill=\"#222222\"");
  draw_header(svg, picture);
  draw_zone(svg, layout, picture.zone);
  draw_destinations(svg, layout, picture);
  draw_paths(svg, layout, recorder);
  draw_docks(svg, layout, picture);
  draw_starts(svg, layout, picture, recorder);
  draw_pins(svg, board);
  draw_axes(svg, layout);
  draw_legend(svg, legend_corner, picture, recorder, board);
  svg.close_group();
  return svg.finish();
}

bool write_text_file(const std::string& path, const std::string& text) {
  const std::string beside = path + ".tmp";
  std::FILE* file = std::fopen(beside.c_str(), "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const bool closed = std::fclose(file) == 0;
  if (written && closed && std::rename(beside.c_str(), path.c_str()) == 0) return true;
  static_cast<void>(std::remove(beside.c_str()));
  return false;
}

}  // namespace rtac::sim
