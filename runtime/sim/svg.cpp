#include "svg.h"

#include "rtac/sim/table.h"

namespace rtac::sim {
namespace {

// Bytes of the well-formed UTF-8 sequence that starts at `i`, 0 if it is none.
std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto lead = static_cast<unsigned char>(text[i]);
  if (lead < 0x80) return lead == '\t' || lead == '\n' || lead >= 0x20 ? 1 : 0;
  const std::size_t bytes =
      lead >= 0xC2 && lead < 0xE0 ? 2 : (lead >= 0xE0 && lead < 0xF0 ? 3 : (lead < 0xF5 ? 4 : 0));
  if (lead < 0xC2 || bytes == 0 || i + bytes > text.size()) return 0;
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((static_cast<unsigned char>(text[i + k]) & 0xC0u) != 0x80u) return 0;
  }
  const auto second = static_cast<unsigned char>(text[i + 1]);
  const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool surrogate = lead == 0xED && second >= 0xA0;
  const bool beyond = lead == 0xF4 && second >= 0x90;
  return overlong || surrogate || beyond ? 0 : bytes;
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t bytes = utf8_length(text, i);
    if (bytes == 0) {
      out += '?';
      ++i;
      continue;
    }
    switch (text[i]) {
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
      case '\'':
        out += "&#39;";
        break;
      default:
        out.append(text.substr(i, bytes));
    }
    i += bytes;
  }
  return out;
}

std::string pixels(double value) {
  return fixed(value, 1);
}
std::string pixels(Vec2 point) {
  return pixels(point.x) + "," + pixels(point.y);
}

SvgWriter::SvgWriter(double width, double height, std::string_view title) {
  const std::string size = pixels(width) + " " + pixels(height);
  out_ += "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 " + size +
          "\" width=\"" + pixels(width) + "\" height=\"" + pixels(height) + "\">\n";
  out_ += "<title>" + xml_escaped(title) + "</title>\n";
}

void SvgWriter::open_group(std::string_view attributes) {
  out_ += "<g " + std::string(attributes) + ">\n";
}

void SvgWriter::line(Vec2 a, Vec2 b, std::string_view attributes) {
  out_ += "<line x1=\"" + pixels(a.x) + "\" y1=\"" + pixels(a.y) + "\" x2=\"" + pixels(b.x) +
          "\" y2=\"" + pixels(b.y) + "\" " + std::string(attributes) + "/>\n";
}

void SvgWriter::rect(Vec2 corner, Vec2 size, std::string_view attributes) {
  out_ += "<rect x=\"" + pixels(corner.x) + "\" y=\"" + pixels(corner.y) + "\" width=\"" +
          pixels(size.x) + "\" height=\"" + pixels(size.y) + "\" " + std::string(attributes) +
          "/>\n";
}

void SvgWriter::circle(Vec2 centre, double radius, std::string_view attributes,
                       std::string_view tooltip) {
  out_ += "<circle cx=\"" + pixels(centre.x) + "\" cy=\"" + pixels(centre.y) + "\" r=\"" +
          pixels(radius) + "\" " + std::string(attributes);
  out_ += tooltip.empty() ? "/>\n" : "><title>" + xml_escaped(tooltip) + "</title></circle>\n";
}

void SvgWriter::path(std::string_view data, std::string_view attributes) {
  out_ += "<path d=\"" + std::string(data) + "\" " + std::string(attributes) + "/>\n";
}

void SvgWriter::text(Vec2 at, std::string_view content, std::string_view attributes) {
  out_ += "<text x=\"" + pixels(at.x) + "\" y=\"" + pixels(at.y) + "\" " + std::string(attributes) +
          ">" + xml_escaped(content) + "</text>\n";
}

void SvgWriter::text_with_halo(Vec2 at, std::string_view content, std::string_view attributes) {
  text(at, content,
       std::string(attributes) +
           " stroke=\"#ffffff\" stroke-width=\"3.5\" stroke-opacity=\"0.9\" "
           "stroke-linejoin=\"round\" aria-hidden=\"true\"");
  text(at, content, attributes);
}

std::string SvgWriter::finish() {
  return out_ + "</svg>\n";
}

}  // namespace rtac::sim
