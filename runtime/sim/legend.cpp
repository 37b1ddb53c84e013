#include "legend.h"

#include <algorithm>
#include <array>

#include "rtac/sim/math.h"
#include "symbols.h"

namespace rtac::sim {
namespace {

constexpr double line_px = 20;
constexpr double symbol_px = 44;  // from the legend's edge to its texts
constexpr double reason_px = 80;  // ... and to the reasons below a controller's name
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
  void small(double indent, const std::string& text, bool bold = false) {
    write(indent, text,
          bold ? "font-size=\"11.5\" font-weight=\"bold\"" : "font-size=\"11.5\" fill=\"#444444\"");
    y_ += line_px - 4;
  }
  // Before the text of the same line.
  void count(int number) {
    if (svg_ == nullptr) return;
    svg_->text({corner_.x + reason_px - 8, corner_.y + y_ + 13}, std::to_string(number),
               "font-size=\"11.5\" text-anchor=\"end\" font-weight=\"bold\"");
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

void write_controllers(Legend& legend, const Picture& picture) {
  legend.heading("Who drives");
  const std::string name =
      picture.advanced_controller.empty() ? "" : " (" + picture.advanced_controller + ")";
  legend.sample_line(path_style(false));
  legend.entry("advanced controller" + name);
  legend.sample_line(path_style(true));
  legend.entry("safe controllers");
}

template <class Draw>
void symbol_entry(Legend& legend, const std::string& text, const Draw& draw) {
  if (legend.svg() != nullptr) draw(*legend.svg(), legend.symbol());
  legend.entry(text);
}

bool any_destination(const Picture& picture, bool reached) {
  return std::any_of(picture.destinations.begin(), picture.destinations.end(),
                     [&](const Destination& goal) { return goal.reached == reached; });
}

void write_symbols(Legend& legend, const Picture& picture, bool switches) {
  legend.heading("Map");
  symbol_entry(legend, "not allowed", [](SvgWriter& svg, Vec2 at) {
    svg.rect(at - Vec2{12, 7}, {24, 14},
             "fill=\"url(#outside)\" stroke=\"#333333\" stroke-width=\"1.2\"");
  });
  symbol_entry(legend, "start",
               [](SvgWriter& svg, Vec2 at) { draw_start(svg, at, start_radius_px, ""); });
  symbol_entry(legend, "end of the run", draw_end);
  if (!picture.docks.empty()) symbol_entry(legend, "charging dock", draw_dock);
  for (const bool reached : {true, false}) {
    if (!any_destination(picture, reached)) continue;
    symbol_entry(legend, reached ? "destination, reached" : "destination, skipped",
                 [&](SvgWriter& svg, Vec2 at) { draw_destination(svg, at, reached); });
  }
  if (!picture.violations.empty()) {
    symbol_entry(legend, "requirement violated, at its worst", draw_violation);
  }
  if (!switches) return;
  symbol_entry(legend, "a safe controller takes over",
               [](SvgWriter& svg, Vec2 at) { draw_switch(svg, at, ""); });
  symbol_entry(legend, "... with its number in the lists below",
               [](SvgWriter& svg, Vec2 at) { draw_number(svg, at, "n", ""); });
  symbol_entry(legend, "the advanced controller drives again", draw_return);
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

// The reasons of one safe controller below its name.
void write_reasons(Legend& legend, const PinBoard& board, const std::string& controller) {
  legend.small(symbol_px, controller, true);
  for (const ReasonCount& reason : board.reasons) {
    if (reason.controller != controller) continue;
    const double width = legend_width_px - reason_px;
    const std::string text = reason.reason + " \u2013 " + pin_list(reason.pins);
    legend.count(reason.count);
    for (const std::string& line : wrapped(text, reason_font_px, width)) {
      legend.small(reason_px, line);
    }
  }
}

void write_switches(Legend& legend, const PinBoard& board, const std::string& of_robot) {
  legend.heading("Switches to a safe controller" + of_robot);
  if (board.reasons.empty()) legend.small(symbol_px, "none");
  std::vector<std::string> written;
  for (const ReasonCount& reason : board.reasons) {
    if (std::find(written.begin(), written.end(), reason.controller) != written.end()) continue;
    written.push_back(reason.controller);
    write_reasons(legend, board, reason.controller);
  }
  if (board.returns == 0) return;
  legend.count(board.returns);
  legend.small(reason_px, board.returns == 1 ? "return to the advanced controller"
                                             : "returns to the advanced controller");
}

struct Meaning {
  const char* begins;   // a reason begins with it
  const char* written;  // in the legend
  const char* text;
};
constexpr std::array<Meaning, 12> meanings{{
    {"margin", "margin", "what the robot can reach before a recovery has acted is not all safe"},
    {"waypoint ", "waypoint k", "way-point k of the plan is not safe"},
    {"leg ", "leg k", "leg k of the plan is not safe; leg 0 begins at the robot"},
    {"violated", "violated", "the property is false already"},
    {"within error", "within error", "undecided within the sensing errors"},
    {"input: ", "input", "an input is missing, too old or out of range"},
    {"returning", "returning", "what gives control back does not hold yet"},
    {"starting", "starting", "what gives control back has not held since the start"},
    {"plan over capacity", "plan over capacity", "the plan is longer than declared"},
    {"surrendered", "surrendered",
     "the advanced side gave up control by itself: it waits for a robot, or it is parked"},
    {"tracking", "tracking", "the robot is further off its plan than declared"},
    {"recovery breaks its claim", "recovery breaks its claim",
     "the external recovery leaves what it promised to keep; it brakes"},
}};

const Meaning* find_meaning(const std::string& reason) {
  const auto found = std::find_if(meanings.begin(), meanings.end(), [&](const Meaning& meaning) {
    return reason.rfind(meaning.begins, 0) == 0;
  });
  return found == meanings.end() ? nullptr : &*found;
}

// Of the words that occur.
void write_meanings(Legend& legend, const std::vector<PinBoard>& boards) {
  std::array<bool, meanings.size()> occurs{};
  for (const PinBoard& board : boards) {
    for (const ReasonCount& reason : board.reasons) {
      const Meaning* meaning = find_meaning(reason.reason);
      if (meaning != nullptr) occurs[static_cast<std::size_t>(meaning - meanings.data())] = true;
    }
  }
  if (std::find(occurs.begin(), occurs.end(), true) == occurs.end()) return;
  legend.heading("What the reasons mean");
  for (std::size_t i = 0; i < meanings.size(); ++i) {
    if (!occurs[i]) continue;
    const std::string text = std::string(meanings[i].written) + ": " + meanings[i].text;
    for (const std::string& line : wrapped(text, reason_font_px, legend_width_px)) {
      legend.small(0, line);
    }
  }
}

void write_legend(Legend& legend, const Picture& picture, const Recorder& recorder,
                  const std::vector<PinBoard>& boards) {
  write_controllers(legend, picture);
  write_symbols(legend, picture, !recorder.switches().empty());
  if (recorder.switches().empty()) {
    legend.heading("Switches to a safe controller");
    legend.small(symbol_px, "none");
    return;
  }
  for (int robot = 0; robot < recorder.robots(); ++robot) {
    const std::string name = recorder.robots() > 1 ? ": " + robot_name(picture, robot) : "";
    write_switches(legend, boards[static_cast<std::size_t>(robot)], name);
  }
  write_meanings(legend, boards);
}

}  // namespace

std::string robot_name(const Picture& picture, int robot) {
  const auto i = static_cast<std::size_t>(robot);
  return i < picture.robot_names.size() ? picture.robot_names[i]
                                        : "robot " + std::to_string(robot + 1);
}

std::string reason_meaning(const std::string& reason) {
  const Meaning* meaning = find_meaning(reason);
  return meaning == nullptr ? "" : meaning->text;
}

double legend_height_px(const Picture& picture, const Recorder& recorder,
                        const std::vector<PinBoard>& boards) {
  Legend legend(nullptr, {0, 0});
  write_legend(legend, picture, recorder, boards);
  return legend.height_px();
}

void draw_legend(SvgWriter& svg, Vec2 corner, const Picture& picture, const Recorder& recorder,
                 const std::vector<PinBoard>& boards) {
  Legend legend(&svg, corner);
  write_legend(legend, picture, recorder, boards);
}

}  // namespace rtac::sim
