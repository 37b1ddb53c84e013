#include "compiler/sema/dimension.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace rtac::sema {

namespace {

struct Base {
  int Dimension::*exponent;
  const char* symbol;
};
// In the order in which a product of units is written.
constexpr std::array<Base, 7> bases{{{&Dimension::kg, "kg"},
                                     {&Dimension::ratio, "%"},
                                     {&Dimension::rad, "rad"},
                                     {&Dimension::m, "m"},
                                     {&Dimension::A, "A"},
                                     {&Dimension::K, "K"},
                                     {&Dimension::s, "s"}}};

struct Named {
  Dimension dimension;
  const char* name;  // with its article
  const char* unit;
};
const std::array<Named, 20> named_dimensions{{
    {dims::length, "a length", "m"},
    {dims::time, "a time", "s"},
    {dims::speed, "a speed", "m/s"},
    {dims::acceleration, "an acceleration", "m/s^2"},
    {dims::angle, "an angle", "rad"},
    {dims::turn_rate, "a turn rate", "rad/s"},
    {dims::turn_acceleration, "a turn acceleration", "rad/s^2"},
    {dims::ratio, "a ratio", "%"},
    {dims::ratio_per_length, "a ratio per length", "%/m"},
    {dims::ratio_per_time, "a ratio per time", "%/s"},
    {{.m = 2}, "an area", "m^2"},
    {{.kg = 1}, "a mass", "kg"},
    {{.A = 1}, "a current", "A"},
    {{.K = 1}, "a temperature", "K"},
    {{.s = -1}, "a frequency", "Hz"},
    {{.m = 1, .s = -2, .kg = 1}, "a force", "N"},
    {{.m = 2, .s = -2, .kg = 1}, "an energy", "J"},
    {{.m = 2, .s = -3, .kg = 1}, "a power", "W"},
    {{.m = 2, .s = -3, .kg = 1, .A = -1}, "a voltage", "V"},
    {{.s = 1, .A = 1}, "a charge", "Ah"},
}};

void append_factor(std::string& text, const char* separator, const char* symbol, int exponent) {
  if (!text.empty()) text += separator;
  text += symbol;
  if (exponent != 1) text += "^" + std::to_string(exponent);
}

}  // namespace

Dimension operator*(const Dimension& a, const Dimension& b) {
  Dimension product;
  for (const Base& base : bases) {
    product.*base.exponent = a.*base.exponent + b.*base.exponent;
  }
  return product;
}

Dimension operator/(const Dimension& a, const Dimension& b) {
  return a * power(b, -1);
}

Dimension power(const Dimension& base, int exponent) {
  Dimension result;
  for (const Base& entry : bases) result.*entry.exponent = base.*entry.exponent * exponent;
  return result;
}

int largest_exponent(const Dimension& dimension) {
  int largest = 0;
  for (const Base& entry : bases) {
    largest = std::max(largest, std::abs(dimension.*entry.exponent));
  }
  return largest;
}

std::string unit_of(const Dimension& dimension) {
  std::string above;
  std::string below;
  for (const Base& base : bases) {
    const int exponent = dimension.*base.exponent;
    if (exponent > 0) append_factor(above, "*", base.symbol, exponent);
    if (exponent < 0) append_factor(below, "/", base.symbol, -exponent);
  }
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" + below;
}

std::string describe(const Dimension& dimension) {
  if (dimension == dims::number) return "a number without a unit";
  for (const Named& named : named_dimensions) {
    if (named.dimension == dimension) return std::string(named.name) + " (" + named.unit + ")";
  }
  return "a quantity in " + unit_of(dimension);
}

// Numbers that nobody counts the zeros of have an exponent: `1e40`, `2.5e-20`.
static std::string readable(const Rational& value) {
  constexpr std::size_t longest = 18;
  const std::string text = to_decimal(value);
  if (text.size() <= longest || value == 0) return text;
  const std::size_t point = std::min(text.find('.'), text.size());
  std::string digits = text;
  digits.erase(
      std::remove_if(digits.begin(), digits.end(), [](char c) { return c == '.' || c == '-'; }),
      digits.end());
  const auto first = static_cast<long>(digits.find_first_not_of('0'));
  const long whole = static_cast<long>(point) - (text[0] == '-' ? 1 : 0);  // in front of the point
  digits.erase(0, static_cast<std::size_t>(first));
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.size() > longest) return text;
  const long exponent = whole - first - 1;
  if (digits.size() > 1) digits.insert(1, ".");
  return (text[0] == '-' ? "-" : "") + digits + "e" + std::to_string(exponent);
}

std::string show(const Rational& value, const Dimension& dimension) {
  if (dimension == dims::number) return readable(value);
  if (dimension == dims::time && value != 0 && abs(value) < 1) {
    return readable(Rational(value * 1000)) + " ms";
  }
  Rational shown = value;
  // Every power of a ratio is shown in per cent: 0.05 is 5 %.
  for (int i = 0; i < dimension.ratio; ++i) shown *= 100;
  for (int i = 0; i > dimension.ratio; --i) shown /= 100;
  return readable(shown) + " " + unit_of(dimension);
}

}  // namespace rtac::sema
