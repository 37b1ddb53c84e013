#include "compiler/driver/zone_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "compiler/support/rational.h"

namespace rtac::driver {
namespace {

constexpr double plot_width = 720, plot_height_most = 720, plot_height_least = 160;  // px
constexpr double left = 70, legend_width = 470, gap = 24, line_height = 18;
// Of everything that reaches farther, the complement of a zone, only what is near the rest is
// drawn.
constexpr double unbounded_m = 535'000;

// Okabe and Ito, "Color Universal Design", 2008: told apart by people with any kind of colour
// vision; after the last one they begin again with another stroke.
constexpr std::array<const char*, 6> colours{"#0072B2", "#D55E00", "#009E73",
                                             "#CC79A7", "#56B4E9", "#E69F00"};
constexpr std::array<const char*, 3> strokes{"", "9 3", "2 3"};

std::string number(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value == 0 ? 0.0 : value);
  return text.data();
}
std::string metres_of(double value_m) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.12g m", value_m == 0 ? 0.0 : value_m);
  return text.data();
}

// Text of a specification within XML; bytes that XML forbids become spaces.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return out;
}

struct Box {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty = true;
  void add(double x, double y) {
    x0 = empty ? x : std::min(x0, x);
    y0 = empty ? y : std::min(y0, y);
    x1 = empty ? x : std::max(x1, x);
    y1 = empty ? y : std::max(y1, y);
    empty = false;
  }
};

void add(Box& box, const geometry::Ring& ring) {
  for (const geometry::Point& p : ring) {
    const double x = p.x.get_d(), y = p.y.get_d();
    if (std::abs(x) < unbounded_m && std::abs(y) < unbounded_m) box.add(x, y);
  }
}

Box box_of(const ZoneSheet& sheet) {
  Box box;
  for (const ZoneLayer& layer : sheet.layers) {
    for (const geometry::PolygonWithHoles& part : layer.region.polygons()) {
      add(box, part.outer);
      for (const geometry::Ring& hole : part.holes) add(box, hole);
    }
  }
  for (const SiteMark& site : sheet.sites) box.add(site.x_m, site.y_m);
  if (box.empty) box.add(0, 0);
  const double margin = std::max({0.04 * (box.x1 - box.x0), 0.04 * (box.y1 - box.y0), 0.05});
  return {box.x0 - margin, box.y0 - margin, box.x1 + margin, box.y1 + margin, false};
}

// 1, 2 or 5 times a power of ten, at most `value`.
double round_length(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double head = value / power;
  return (head >= 5 ? 5 : head >= 2 ? 2 : 1) * power;
}

class Sheet {
 public:
  Sheet(const ZoneSheet& sheet, std::size_t index, double top, std::string& out)
      : sheet_(sheet), index_(index), top_(top), out_(out), box_(box_of(sheet)) {
    const double width_m = box_.x1 - box_.x0, height_m = box_.y1 - box_.y0;
    scale_ = std::min(plot_width / width_m, plot_height_most / height_m);
    width_ = width_m * scale_;
    height_ = std::max(height_m * scale_, plot_height_least);
    // what is narrow or flat stands in the middle
    x_shift_ = (plot_width - width_) / 2;
    y_shift_ = (height_ - height_m * scale_) / 2;
    width_ = plot_width;
  }

  // The place below it.
  double draw() {
    frame_and_grid();
    out_ += "<g clip-path=\"url(#clip" + std::to_string(index_) + ")\">\n";
    for (std::size_t i = 0; i < sheet_.layers.size(); ++i) layer(i);
    out_ += "</g>\n";
    for (const SiteMark& site : sheet_.sites) mark(site);
    scale_bar();
    return std::max(top_ + height_ + 60, legend());
  }

 private:
  [[nodiscard]] double px(double x_m) const { return left + x_shift_ + (x_m - box_.x0) * scale_; }
  [[nodiscard]] double py(double y_m) const {
    return top_ + height_ - y_shift_ - (y_m - box_.y0) * scale_;
  }
  static const char* colour(std::size_t layer) { return colours[layer % colours.size()]; }
  static const char* stroke(std::size_t layer) {
    return strokes[layer / colours.size() % strokes.size()];
  }

  void text(double x, double y, const std::string& content, const std::string& attributes) {
    out_ += "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\"" + attributes + ">" +
            escaped(content) + "</text>\n";
  }
  void line(double x0, double y0, double x1, double y1, const std::string& attributes) {
    out_ += "<line x1=\"" + number(x0) + "\" y1=\"" + number(y0) + "\" x2=\"" + number(x1) +
            "\" y2=\"" + number(y1) + "\"" + attributes + "/>\n";
  }

  void frame_and_grid() {
    const std::string place = "x=\"" + number(left) + "\" y=\"" + number(top_) + "\" width=\"" +
                              number(width_) + "\" height=\"" + number(height_) + "\"";
    out_ += "<clipPath id=\"clip" + std::to_string(index_) + "\"><rect " + place +
            "/></clipPath>\n<rect " + place + " fill=\"#fff\" stroke=\"#888\"/>\n";
    const double step_m = round_length(90 / scale_);
    for (double x = std::ceil(x_at(left) / step_m) * step_m; px(x) <= left + width_; x += step_m) {
      line(px(x), top_, px(x), top_ + height_, " class=\"grid\"");
      text(px(x), top_ + height_ + 16, metres_of(snapped(x, step_m)), " class=\"axis\"");
    }
    for (double y = std::ceil(y_at(top_ + height_) / step_m) * step_m; py(y) >= top_; y += step_m) {
      line(left, py(y), left + width_, py(y), " class=\"grid\"");
      text(left - 6, py(y) + 4, metres_of(snapped(y, step_m)), " class=\"axis side\"");
    }
  }
  [[nodiscard]] double x_at(double x) const { return box_.x0 + (x - left - x_shift_) / scale_; }
  [[nodiscard]] double y_at(double y) const {
    return box_.y0 + (top_ + height_ - y_shift_ - y) / scale_;
  }
  static double snapped(double value, double step) { return std::round(value / step) * step; }

  void path(const geometry::Region& region, const std::string& attributes) {
    if (region.empty()) return;
    out_ += "<path d=\"";
    const auto ring = [&](const geometry::Ring& points) {
      char command = 'M';
      for (const geometry::Point& p : points) {
        out_ += command + number(px(p.x.get_d())) + " " + number(py(p.y.get_d()));
        command = 'L';
      }
      out_ += "Z";
    };
    for (const geometry::PolygonWithHoles& part : region.polygons()) {
      ring(part.outer);
      for (const geometry::Ring& hole : part.holes) ring(hole);
    }
    out_ += "\" fill-rule=\"evenodd\"" + attributes + "/>\n";
  }

  // What is drawn first is wider, so that it is seen where any other zone has the same boundary;
  // the first of many has no more than 8 px.
  std::string outline(std::size_t i) const {
    const auto after = static_cast<double>(sheet_.layers.size() - 1 - i);
    const auto all = static_cast<double>(sheet_.layers.size());
    const double width = 2 + std::min(1.5, 6 / all) * after;
    const std::string dashes = stroke(i);
    return std::string(" stroke=\"") + colour(i) + "\" stroke-width=\"" + number(width) + "\"" +
           (dashes.empty() ? "" : " stroke-dasharray=\"" + dashes + "\"");
  }
  static std::string erosion_outline(std::size_t i, std::size_t erosion) {
    constexpr std::array<const char*, 4> dashes{"7 4", "3 3", "1 3", "10 3 2 3"};
    const std::string dash = dashes[erosion % dashes.size()];
    return std::string(" fill=\"none\" stroke=\"") + colour(i) +
           "\" stroke-width=\"1.3\" stroke-dasharray=\"" + dash + "\"";
  }

  void layer(std::size_t i) {
    const ZoneLayer& layer = sheet_.layers[i];
    path(layer.region,
         std::string(" fill=\"") + colour(i) + "\" fill-opacity=\"0.12\"" + outline(i));
    for (std::size_t e = 0; e < layer.erosions.size(); ++e) {
      path(layer.erosions[e].region, erosion_outline(i, e));
    }
  }

  void mark(const SiteMark& site) {
    const double x = px(site.x_m), y = py(site.y_m);
    out_ += "<path d=\"M" + number(x - 6) + " " + number(y) + "H" + number(x + 6) + "M" +
            number(x) + " " + number(y - 6) + "V" + number(y + 6) +
            "\" stroke=\"#000\" stroke-width=\"2\"/>\n<circle cx=\"" + number(x) + "\" cy=\"" +
            number(y) + "\" r=\"4\" fill=\"none\" stroke=\"#000\"/>\n";
    text(x + 9, y - 6, site.name, " class=\"site\"");
  }

  void scale_bar() {
    const double length_m = round_length(200 / scale_);
    const double y = top_ + height_ + 36, end = left + length_m * scale_;
    line(left, y, end, y, " class=\"bar\"");
    line(left, y - 5, left, y + 5, " class=\"bar\"");
    line(end, y - 5, end, y + 5, " class=\"bar\"");
    text(end + 8, y + 4, metres_of(length_m), "");
  }

  // Returns the place below it.
  double legend() {
    const double x = left + plot_width + gap;
    double y = top_ + 12;
    for (std::size_t i = 0; i < sheet_.layers.size(); ++i) {
      const ZoneLayer& layer = sheet_.layers[i];
      out_ += "<rect x=\"" + number(x) + "\" y=\"" + number(y - 11) +
              "\" width=\"26\" height=\"14\" fill=\"" + colour(i) + "\" fill-opacity=\"0.12\"" +
              outline(i) + "/>\n";
      text(x + 36, y, layer.name, " class=\"name\"");
      text(x + 36, y += line_height, layer.origin, " class=\"origin\"");
      if (!layer.conditions.empty()) text(x + 36, y += line_height, layer.conditions, "");
      text(x + 36, y += line_height, size_of(layer.region), " class=\"origin\"");
      for (std::size_t e = 0; e < layer.erosions.size(); ++e) erosion(i, e, x, y += line_height);
      for (const std::string& remark : layer.remarks) text(x + 36, y += line_height, remark, "");
      y += line_height + 8;
    }
    if (!sheet_.sites.empty()) {
      out_ += "<path d=\"M" + number(x + 7) + " " + number(y - 4) +
              "h12m-6 -6v12\" stroke=\"#000\"" + " stroke-width=\"2\"/>\n";
      text(x + 36, y, "site", "");
      y += line_height;
    }
    return y;
  }
  void erosion(std::size_t i, std::size_t e, double x, double y) {
    const ZoneErosion& shown = sheet_.layers[i].erosions[e];
    out_ +=
        "<path d=\"M" + number(x) + " " + number(y - 4) + "h26\"" + erosion_outline(i, e) + "/>\n";
    text(x + 36, y,
         metres_of(static_cast<double>(shown.distance_mm) / 1000) + " inside: " + shown.reasons +
             (shown.region.empty() ? " (no place is)" : ""),
         "");
  }
  static std::string size_of(const geometry::Region& region) {
    std::size_t vertices = 0, holes = 0;
    const auto parts = region.polygons();
    bool bounded = true;
    for (const geometry::PolygonWithHoles& part : parts) {
      vertices += part.outer.size();
      holes += part.holes.size();
      for (const geometry::Ring& hole : part.holes) vertices += hole.size();
      for (const geometry::Point& p : part.outer) bounded = bounded && abs(p.x) < unbounded_m;
    }
    const auto count = [](std::size_t n, const char* one, const char* many) {
      return std::to_string(n) + " " + (n == 1 ? one : many);
    };
    std::array<char, 40> area{};
    std::snprintf(area.data(), area.size(), "%.6g m\u00b2", region.area().get_d());
    return count(vertices, "vertex", "vertices") + ", " + count(parts.size(), "part", "parts") +
           ", " + count(holes, "hole", "holes") +
           (bounded ? std::string(", ") + area.data() : ", unbounded");
  }

  const ZoneSheet& sheet_;
  std::size_t index_;
  double top_;
  std::string& out_;
  Box box_;
  double scale_ = 1, width_ = 0, height_ = 0, x_shift_ = 0, y_shift_ = 0;
};

constexpr const char* style =
    "<style>text{font:13px sans-serif;fill:#222}.title{font-size:18px;font-weight:bold}"
    ".name{font-weight:bold;font-size:14px}.origin{fill:#555}.axis{font-size:11px;fill:#555;"
    "text-anchor:middle}.side{text-anchor:end}.grid{stroke:#e4e4e4}.bar{stroke:#222;"
    "stroke-width:2}.site{paint-order:stroke;stroke:#fff;stroke-width:3px}</style>\n";

}  // namespace

std::string zone_svg(const std::string& title, const std::vector<ZoneSheet>& sheets) {
  std::string body;
  double y = 56;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    if (sheets.size() > 1) {
      body += "<text x=\"" + number(left) + "\" y=\"" + number(y) + "\" class=\"name\">frame " +
              escaped(sheets[i].frame) + "</text>\n";
      y += 14;
    }
    y = Sheet(sheets[i], i, y, body).draw() + 30;
  }
  if (sheets.empty()) body += "<text x=\"70\" y=\"70\">no zone has a name</text>\n";
  const std::string width = number(left + plot_width + gap + legend_width);
  const std::string height = number(std::max(y, 100.0));
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
         "\" viewBox=\"0 0 " + width + " " + height + "\" role=\"img\">\n<title>" + escaped(title) +
         "</title>\n" + style + "<rect width=\"100%\" height=\"100%\" " +
         "fill=\"#fafafa\"/>\n<text x=\"" + number(left) + "\" y=\"32\" class=\"title\">" +
         escaped(title) + "</text>\n" + body + "</svg>\n";
}

}  // namespace rtac::driver
