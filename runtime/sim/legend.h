// Private: the symbols of a picture and the legend that explains them.
#pragma once

#include <string>

#include "pins.h"
#include "rtac/sim/picture.h"
#include "svg.h"

namespace rtac::sim {

inline constexpr double legend_gap_px = 28;
inline constexpr double legend_width_px = 330;
inline constexpr double start_radius_px = 6;
inline constexpr double start_name_px = 5;  // from the body to its name

std::string robot_name(const Picture& picture, int robot);
// Stroke of a path: colour by controller, dashes by robot.
std::string path_style(int robot, bool safe);

void draw_destination(SvgWriter& svg, Vec2 at);
void draw_dock(SvgWriter& svg, Vec2 at);
// The name stands right of the body.
void draw_start(SvgWriter& svg, Vec2 at, double body_px, const std::string& name);
void draw_pin(SvgWriter& svg, const Pin& pin);

double legend_height_px(const Picture& picture, const Recorder& recorder, const PinBoard& board);
void draw_legend(SvgWriter& svg, Vec2 corner, const Picture& picture, const Recorder& recorder,
                 const PinBoard& board);

}  // namespace rtac::sim
