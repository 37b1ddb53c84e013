// Ways that lead nowhere nearer to another robot, from all places of a square and off all places of
// the other one's. In m.
#pragma once

#include "compiler/recheck/legs.h"

namespace rtac::recheck {

double farthest(const Box& a, const Box& b);
double nearest(const Box& a, const Box& b);
// On the way from p to c the distance from q does not fall, for all p and q.
bool recedes(Place c, const Box& from, const Box& other);
// Which side of the other robot one is on, on either axis: -1 or 1.
struct Side {
  int x, y;
};
// As above where p is on that side of q, also if it is on none: then it is nowhere there.
bool recedes(Place c, const Box& from, const Box& other, Side side);
// The same of all q that p is off in a direction between that side's diagonal and one of its axes,
// however near to it.
enum class Axis { x, y };
bool recedes(Place c, const Box& from, Side side, Axis axis);
// It falls at first, for all of them.
bool comes_nearer(Place c, const Box& from, const Box& other);

}  // namespace rtac::recheck
