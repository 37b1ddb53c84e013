// An outline in degrees that takes minutes to move by the error of the map.
#pragma once

#include <string>

namespace rtac::test {

// Needles 60 cm wide and 110 m long, 20,002 of their vertices sharp: the positions of a closed
// ring, without the brackets around them.
inline std::string needles_in_degrees() {
  std::string ring = "[8.5,47.39]";
  constexpr int needles = 10'001;
  for (int i = 0; i < needles; ++i) {
    const auto east = [](int eighths) {
      const std::string digits = std::to_string(eighths * 4);
      return "[8.5" + std::string(6 - digits.size(), '0') + digits;
    };
    ring += "," + east(2 * i) + ",47.4]," + east(2 * i + 1) + ",47.401]";
  }
  return ring + ",[8.59,47.4],[8.59,47.39],[8.5,47.39]";
}

}  // namespace rtac::test
