// Zones as a picture for people: self-contained SVG.
#pragma once

#include <string>
#include <vector>

#include "compiler/driver/zone_layers.h"

namespace rtac::driver {

// The same sheets give the same text. `title` stands above them.
std::string zone_svg(const std::string& title, const std::vector<ZoneSheet>& sheets);

}  // namespace rtac::driver
