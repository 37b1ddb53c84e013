#include "compiler/sema/units.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "compiler/sema/suggest.h"

namespace rtac::sema {

namespace {

struct UnitSymbol {
  const char* text;
  Dimension dimension;
  Rational factor;
};

// pi rounded up at the 20th decimal. As a bound from above (an error, a turn rate) an angle in
// degrees is on the safe side; in a property its excess of less than 4e-21 rad is 17 orders of
// magnitude below the grid that it is rounded to.
Rational pi_up() {
  return Rational("314159265358979323847/100000000000000000000");
}

const std::vector<UnitSymbol>& symbols() {
  static const Dimension energy{.m = 2, .s = -2, .kg = 1};
  static const Dimension power_dimension{.m = 2, .s = -3, .kg = 1};
  static const Dimension voltage{.m = 2, .s = -3, .kg = 1, .A = -1};
  static const std::vector<UnitSymbol> table = {
      {"m", dims::length, 1},
      {"cm", dims::length, Rational(1, 100)},
      {"mm", dims::length, Rational(1, 1000)},
      {"km", dims::length, 1000},
      {"um", dims::length, Rational(1, 1000000)},
      {"s", dims::time, 1},
      {"ms", dims::time, Rational(1, 1000)},
      {"us", dims::time, Rational(1, 1000000)},
      {"min", dims::time, 60},
      {"h", dims::time, 3600},
      {"rad", dims::angle, 1},
      {"mrad", dims::angle, Rational(1, 1000)},
      {"deg", dims::angle, Rational(pi_up() / 180)},
      {"%", dims::ratio, Rational(1, 100)},
      {"kg", {.kg = 1}, 1},
      {"g", {.kg = 1}, Rational(1, 1000)},
      {"A", {.A = 1}, 1},
      {"mA", {.A = 1}, Rational(1, 1000)},
      {"Ah", {.s = 1, .A = 1}, 3600},
      {"K", {.K = 1}, 1},
      {"V", voltage, 1},
      {"mV", voltage, Rational(1, 1000)},
      {"J", energy, 1},
      {"kJ", energy, 1000},
      {"Wh", energy, 3600},
      {"kWh", energy, 3600000},
      {"W", power_dimension, 1},
      {"kW", power_dimension, 1000},
      {"N", {.m = 1, .s = -2, .kg = 1}, 1},
      {"Hz", {.s = -1}, 1},
      {"kHz", {.s = -1}, 1000},
  };
  return table;
}

// Spellings that people use; they are not accepted, only understood.
struct Spelling {
  const char* text;
  const char* unit;
};
constexpr Spelling spellings[] = {
    {"meter", "m"},       {"metre", "m"},        {"meters", "m"},        {"metres", "m"},
    {"centimeter", "cm"}, {"centimetre", "cm"},  {"millimeter", "mm"},   {"millimetre", "mm"},
    {"sec", "s"},         {"secs", "s"},         {"second", "s"},        {"seconds", "s"},
    {"msec", "ms"},       {"millisecond", "ms"}, {"milliseconds", "ms"}, {"usec", "us"},
    {"minute", "min"},    {"minutes", "min"},    {"mins", "min"},        {"hr", "h"},
    {"hour", "h"},        {"hours", "h"},        {"degree", "deg"},      {"degrees", "deg"},
    {"radian", "rad"},    {"radians", "rad"},    {"rads", "rad"},        {"percent", "%"},
    {"pct", "%"},         {"mps", "m/s"},        {"kph", "km/h"},        {"kmh", "km/h"},
    {"rps", "rad/s"},     {"mps2", "m/s^2"},     {"cms", "cm/s"},        {"mms", "mm/s"},
    {"gram", "g"},        {"grams", "g"},        {"amp", "A"},           {"amps", "A"},
    {"volt", "V"},        {"volts", "V"},        {"watt", "W"},          {"watts", "W"},
    {"joule", "J"},       {"joules", "J"},       {"kelvin", "K"},        {"hertz", "Hz"},
    {"newton", "N"},
};

constexpr int power_max = 32;  // no product has a larger one

struct Factor {
  std::string symbol;
  int exponent = 1;  // negative behind a `/`
};

// One factor of a unit: "s^2" -> {s, 2}.
std::optional<Factor> split_power(std::string_view text, bool below) {
  Factor factor{std::string(text), below ? -1 : 1};
  const std::size_t caret = text.find('^');
  if (caret == std::string_view::npos) return factor;
  factor.symbol = std::string(text.substr(0, caret));
  std::string_view digits = text.substr(caret + 1);
  if (!digits.empty() && digits.front() == '-') {
    factor.exponent = -factor.exponent;
    digits.remove_prefix(1);
  }
  const bool is_number =
      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!is_number || digits.empty() || digits.size() > 2 || digits.front() == '0') {
    return std::nullopt;
  }
  const int power = std::stoi(std::string(digits));
  if (power > power_max) return std::nullopt;
  factor.exponent *= power;
  return factor;
}

// More factors than any unit has; longer products would be slow to multiply out.
constexpr std::size_t factors_max = 16;

std::optional<std::vector<Factor>> split(std::string_view text) {
  std::vector<Factor> factors;
  bool below = false;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find_first_of("*/", begin), text.size());
    const auto factor = split_power(text.substr(begin, end - begin), below);
    if (!factor || factor->symbol.empty() || factors.size() == factors_max) return std::nullopt;
    factors.push_back(*factor);
    below = end < text.size() && text[end] == '/';
    begin = end + 1;
  }
  return factors;
}

const UnitSymbol* find_symbol(std::string_view text) {
  for (const UnitSymbol& symbol : symbols()) {
    if (symbol.text == text) return &symbol;
  }
  return nullptr;
}

// Known symbols that one wrong factor may stand for, the likeliest first.
std::vector<std::string> candidates_for(const std::string& wrong) {
  struct Candidate {
    int distance;
    std::size_t length_difference;
    std::string unit;
  };
  std::vector<Candidate> found;
  const auto consider = [&](std::string_view spelling, const char* unit, int tolerated) {
    const int distance = edit_distance(wrong, spelling);
    if (distance > tolerated) return;
    const std::size_t difference = spelling.size() > wrong.size() ? spelling.size() - wrong.size()
                                                                  : wrong.size() - spelling.size();
    found.push_back({distance, difference, unit});
  };
  for (const UnitSymbol& symbol : symbols()) consider(symbol.text, symbol.text, 1);
  for (const Spelling& spelling : spellings) {
    consider(spelling.text, spelling.unit, wrong.size() >= 5 ? 1 : 0);
  }
  std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance
                                    : a.length_difference < b.length_difference;
  });
  std::vector<std::string> units;
  for (const Candidate& candidate : found) {
    // a known spelling, capitals apart, is no other unit's
    if (candidate.distance > found.front().distance && found.front().distance == 0) break;
    units.push_back(candidate.unit);
  }
  return units;
}

// `text` with every factor `wrong` replaced.
std::string with_factor(const std::string& text, const std::string& wrong,
                        const std::string& replacement) {
  std::string result;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find_first_of("*/^", begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    result += part == wrong ? replacement : part;
    if (end < text.size()) result += text[end];
    begin = end + 1;
  }
  return result;
}

}  // namespace

std::optional<UnitMeaning> parse_unit(std::string_view text) {
  const auto factors = split(text);
  if (!factors) return std::nullopt;
  UnitMeaning meaning{dims::number, 1};
  for (const Factor& factor : *factors) {
    if (factor.symbol == "1") continue;
    const UnitSymbol* symbol = find_symbol(factor.symbol);
    if (symbol == nullptr) return std::nullopt;
    meaning.dimension = meaning.dimension * power(symbol->dimension, factor.exponent);
    for (int i = 0; i < factor.exponent; ++i) meaning.factor *= symbol->factor;
    for (int i = 0; i > factor.exponent; --i) meaning.factor /= symbol->factor;
  }
  return meaning;
}

bool is_celsius(std::string_view written) {
  constexpr std::string_view names[] = {"C", "degC", "celsius", "Celsius", "centigrade"};
  return std::find(std::begin(names), std::end(names), written) != std::end(names);
}

std::optional<std::string> suggest_unit(std::string_view written,
                                        const std::optional<Dimension>& due) {
  const std::string text(written);
  // `m/s2` is a power without its sign: nothing else is meant by a digit behind a symbol.
  std::string powered;
  for (const char c : text) {
    const bool digit = c >= '0' && c <= '9';
    if (digit && !powered.empty() &&
        std::isalpha(static_cast<unsigned char>(powered.back())) != 0) {
      powered += '^';
    }
    powered += c;
  }
  if (powered != text && parse_unit(powered)) return powered;
  const auto factors = split(text);
  if (!factors) return std::nullopt;
  std::vector<std::string> possible{text};
  for (const Factor& factor : *factors) {
    if (factor.symbol == "1" || find_symbol(factor.symbol) != nullptr) continue;
    std::vector<std::string> next;
    for (const std::string& base : possible) {
      for (const std::string& unit : candidates_for(factor.symbol)) {
        next.push_back(with_factor(base, factor.symbol, unit));
      }
    }
    possible = std::move(next);
  }
  std::optional<std::string> first;
  for (const std::string& unit : possible) {
    const auto meaning = parse_unit(unit);
    if (!meaning) continue;
    if (!first) first = unit;
    if (due && meaning->dimension == *due) return unit;
  }
  return first;
}

std::string likely_unit(const Dimension& due, const Rational& number) {
  if (due == dims::time && number.get_den() == 1 && number >= 10) return "ms";
  return unit_of(due);
}

}  // namespace rtac::sema
