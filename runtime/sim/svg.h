// Private: writes SVG elements. Coordinates are pixels, one decimal.
#pragma once

#include <string>
#include <string_view>

#include "rtac/types.h"

namespace rtac::sim {

// For text and attribute values; control characters and malformed UTF-8 become '?'.
std::string xml_escaped(std::string_view text);

class SvgWriter {
 public:
  SvgWriter(double width, double height, std::string_view title);
  void raw(std::string_view text) { out_ += text; }
  void open_group(std::string_view attributes);
  void close_group() { out_ += "</g>\n"; }
  void line(Vec2 a, Vec2 b, std::string_view attributes);
  void rect(Vec2 corner, Vec2 size, std::string_view attributes);
  void circle(Vec2 centre, double radius, std::string_view attributes,
              std::string_view tooltip = {});
  void path(std::string_view data, std::string_view attributes);
  void text(Vec2 at, std::string_view content, std::string_view attributes);
  // With a white outline below it, so that it is read over lines and hatching.
  void text_with_halo(Vec2 at, std::string_view content, std::string_view attributes);
  [[nodiscard]] std::string finish();

 private:
  std::string out_;
};

std::string pixels(double value);
std::string pixels(Vec2 point);  // "x,y"

}  // namespace rtac::sim
