// Zones without an end, such as all that is outside of an outline: the coordinates of the kernel
// end them, far from where anybody drives, and a grid over all of that says nothing of what is
// near.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/ir/module.h"

namespace rtac::analysis {

// Where coordinates end: the edges there bound nothing.
bool is_at_the_end(const ir::Edge& edge);
// Of a zone of the plane: whether it reaches the end of the coordinates.
bool is_boundless(const ir::ZoneTable& zone);
// Or one with height, at some height.
bool is_boundless(const ir::Module& module, ir::ZoneIndex zone);

struct Box {  // m
  std::int64_t low_x = 0, low_y = 0, high_x = 0, high_y = 0;
  bool operator==(const Box&) const = default;
};
// Around all that bounds such a zone from inside and the places that a robot has to get to, so much
// wider.
Box box_around(const ir::ZoneTable& zone, const std::vector<ir::SiteTable::Place>& places,
               std::int64_t wider_mm);
// "hall & rectangle (-12 m, -12 m) to (15 m, 16 m)": what of the zone lies in the box.
std::string bounded(const ir::ZoneTable& zone, const Box& box);

}  // namespace rtac::analysis
