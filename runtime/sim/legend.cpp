#include "legend.h"

#include "rtac/sim/table.h"

namespace rtac::sim {
namespace {

// Two colours that stay apart for colour-blind readers (Okabe and Ito's palette).
constexpr const char* advanced_colour = "#0072B2";
constexpr const char* safe_colour = "#D55E00";
constexpr const char* dashes[] = {"", "7 3", "2 2.5", "10 3 2 3"};
constexpr int dash_kinds = 4;

std::string stroke_style(const std::string& colour, const std::string& width, int robot) {
  std::string style = "stroke=\"" + colour + "\" stroke-width=\"" + width + "\"";
  const std::string dash = dashes[robot % dash_kinds];
  if (!dash.empty()) style += " stroke-dasharray=\"" + dash + "\"";
  return style;
}

constexpr double line_px = 20;
constexpr double symbol_px = 44;  // from the legend's edge to its texts
constexpr double reason_font_px = 11.5;

// Writes the legend line by line, or only measures it.
class Legend {
 public:
  Legend(SvgWriter* svg, Vec2 corner) : svg_(svg), corner_(corner) {}
  [[nodiscard]] double height_px() const { return y_; }
  [[nodiscard]] Vec2 symbol() const { return {corner_.x + 18, corner_.y + y_ + 9}; }
  [[nodiscard]] SvgWriter* svg() const { return svg_; }

  void heading(const std::string& text) {
    if (y_ > 0) y_ += 10;
    write(0, text, "font-size=\"13\" font-weight=\"bold\"");
    y_ += line_px + 2;
  }
  void entry(const std::string& text) {
    write(symbol_px, text, "font-size=\"12.5\"");
    y_ += line_px;
  }
  void sample_line(const std::string& style) {
    if (svg_ == nullptr) return;
    const double y = symbol().y;
    svg_->line({corner_.x, y}, {corner_.x + 36, y}, style);
  }
  void small(double indent, const std::string& text) {
    write(indent, text, "font-size=\"11.5\" fill=\"#444444\"");
    y_ += line_px - 4;
  }
  void count(int number, const std::string& text) {
    if (svg_ != nullptr) {
      svg_->text({corner_.x + 36, corner_.y + y_ + 13}, std::to_string(number),
                 "font-size=\"12.5\" text-anchor=\"end\" font-weight=\"bold\"");
    }
    entry(text);
  }

 private:
  void write(double indent, const std::string& text, const char* attributes) {
    if (svg_ == nullptr || text.empty()) return;
    svg_->text({corner_.x + indent, corner_.y + y_ + 13}, text, attributes);
  }
  SvgWriter* svg_;
  Vec2 corner_;
  double y_ = 0;
};

// Breaks at spaces so that no line exceeds the width, unless a single word does.
std::vector<std::string> wrapped(const std::string& text, double font_px, double width_px) {
  std::vector<std::string> lines(1);
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = std::min(text.find(' ', i), text.size());
    const std::string word = text.substr(i, end - i);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (!lines.back().empty() && text_width_px(longer, font_px) > width_px) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
    i = end + 1;
  }
  return lines;
}

void write_controllers(Legend& legend, const Picture& picture, const Recorder& recorder) {
  legend.heading("Who drives");
  const std::string name =
      picture.advanced_controller.empty() ? "" : " (" + picture.advanced_controller + ")";
  legend.sample_line(path_style(0, false));
  legend.entry("advanced controller" + name);
  legend.sample_line(path_style(0, true));
  legend.entry("safe controllers");
  if (recorder.robots() < 2) return;
  for (int robot = 0; robot < recorder.robots(); ++robot) {
    legend.sample_line(stroke_style("#222222", "1.7", robot));
    legend.entry(robot_name(picture, robot));
  }
}

void write_symbols(Legend& legend, const Picture& picture) {
  legend.heading("Map");
  SvgWriter* svg = legend.svg();
  if (svg != nullptr) {
    svg->rect(legend.symbol() - Vec2{12, 7}, {24, 14},
              "fill=\"url(#outside)\" stroke=\"#333333\" stroke-width=\"1.2\"");
  }
  legend.entry("not allowed");
  if (svg != nullptr) draw_start(*svg, legend.symbol(), start_radius_px, "");
  legend.entry("start");
  if (!picture.docks.empty()) {
    if (svg != nullptr) draw_dock(*svg, legend.symbol());
    legend.entry("charging dock");
  }
  if (!picture.destinations.empty()) {
    if (svg != nullptr) draw_destination(*svg, legend.symbol());
    legend.entry("destination");
  }
}

std::string pin_list(const std::vector<int>& pins) {
  if (pins.empty()) return "no pin";
  std::string text = pins.size() == 1 ? "pin " : "pins ";
  for (std::size_t i = 0; i < pins.size(); ++i) {
    std::size_t last = i;
    while (last + 1 < pins.size() && pins[last + 1] == pins[last] + 1) ++last;
    if (i > 0) text += ", ";
    text += std::to_string(pins[i]);
    if (last > i) text += (last > i + 1 ? "\u2013" : ", ") + std::to_string(pins[last]);
    i = last;
  }
  return text;
}

void write_switches(Legend& legend, const PinBoard& board) {
  legend.heading("Switches to a safe controller");
  if (board.reasons.empty()) legend.small(0, "none");
  const double width = legend_width_px - symbol_px;
  for (const ReasonCount& reason : board.reasons) {
    legend.count(reason.count, reason.controller);
    for (const std::string& line : wrapped(reason.reason, reason_font_px, width)) {
      legend.small(symbol_px, line);
    }
    for (const std::string& line : wrapped(pin_list(reason.pins), reason_font_px, width)) {
      legend.small(symbol_px, line);
    }
    legend.small(0, "");
  }
  if (board.returns == 0) return;
  if (legend.svg() != nullptr) {
    legend.svg()->circle(legend.symbol() - Vec2{22, 0}, 2.2,
                         "fill=\"#ffffff\" stroke=\"#0072B2\" stroke-width=\"1.2\"");
  }
  legend.count(board.returns, board.returns == 1 ? "return to the advanced controller"
                                                 : "returns to the advanced controller");
}

void write_legend(Legend& legend, const Picture& picture, const Recorder& recorder,
                  const PinBoard& board) {
  write_controllers(legend, picture, recorder);
  write_symbols(legend, picture);
  write_switches(legend, board);
}

std::string tooltip(const Pin& pin) {
  std::string text = pin.first.controller + ": " + pin.first.reason + " at " +
                     fixed(1e-6 * static_cast<double>(pin.first.time_us), 2) + " s, (" +
                     fixed(pin.first.place.x, 2) + " m, " + fixed(pin.first.place.y, 2) + " m)";
  if (pin.count > 1) text += ", and " + std::to_string(pin.count - 1) + " more nearby";
  return text;
}

}  // namespace

std::string robot_name(const Picture& picture, int robot) {
  const auto i = static_cast<std::size_t>(robot);
  return i < picture.robot_names.size() ? picture.robot_names[i]
                                        : "robot " + std::to_string(robot + 1);
}

std::string path_style(int robot, bool safe) {
  return stroke_style(safe ? safe_colour : advanced_colour, safe ? "2.4" : "1.7", robot);
}

void draw_destination(SvgWriter& svg, Vec2 at) {
  svg.path("M" + pixels(at - Vec2{0, 5}) + "L" + pixels(at + Vec2{5, 0}) + "L" +
               pixels(at + Vec2{0, 5}) + "L" + pixels(at - Vec2{5, 0}) + "Z",
           "fill=\"#ffffff\" stroke=\"#777777\" stroke-width=\"1.3\"");
}

void draw_dock(SvgWriter& svg, Vec2 at) {
  svg.rect(at - Vec2{9, 9}, {18, 18},
           "rx=\"3\" fill=\"#ffffff\" stroke=\"#222222\" stroke-width=\"1.5\"");
  // A flash.
  svg.path("M" + pixels(at + Vec2{1.5, -7}) + "L" + pixels(at + Vec2{-4.5, 1.2}) + "L" +
               pixels(at + Vec2{-0.6, 1.2}) + "L" + pixels(at + Vec2{-1.6, 7}) + "L" +
               pixels(at + Vec2{4.5, -1.6}) + "L" + pixels(at + Vec2{0.6, -1.6}) + "Z",
           "fill=\"#222222\"");
}

void draw_start(SvgWriter& svg, Vec2 at, double body_px, const std::string& name) {
  svg.circle(at, start_radius_px, "fill=\"#ffffff\" stroke=\"#222222\" stroke-width=\"1.8\"");
  svg.circle(at, 2, "fill=\"#222222\"");
  if (name.empty()) return;
  svg.text_with_halo(at + Vec2{body_px + start_name_px, 4}, name,
                     "font-size=\"12\" font-weight=\"bold\"");
}

void draw_pin(SvgWriter& svg, const Pin& pin) {
  svg.circle(pin.centre_px, pin_radius_px,
             "fill=\"#ffffff\" stroke=\"#222222\" stroke-width=\"1.3\"", tooltip(pin));
  svg.text(pin.centre_px + Vec2{0, 3.4}, std::to_string(pin.number),
           "font-size=\"9.5\" font-weight=\"bold\" text-anchor=\"middle\" "
           "pointer-events=\"none\"");
}

double legend_height_px(const Picture& picture, const Recorder& recorder, const PinBoard& board) {
  Legend legend(nullptr, {0, 0});
  write_legend(legend, picture, recorder, board);
  return legend.height_px();
}

void draw_legend(SvgWriter& svg, Vec2 corner, const Picture& picture, const Recorder& recorder,
                 const PinBoard& board) {
  Legend legend(&svg, corner);
  write_legend(legend, picture, recorder, board);
}

}  // namespace rtac::sim
