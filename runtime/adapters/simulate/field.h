// Where robots start and go: near what they can violate.
#pragma once

#include <limits>
#include <vector>

#include "case.h"
#include "rtac/sim/random.h"

namespace rtac::simulate {

// A box along the axes, in m; empty until it holds something. In the plane its heights do not
// matter.
struct Box {
  Vec2 lo{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 hi{-lo.x, -lo.y};
  double bottom = lo.x, top = hi.x;
  static Box everything();
  void hold(Vec2 p);
  void hold_height(double z);
  void join(const Box& other);
  void cut(const Box& other);
  [[nodiscard]] Box grown(double by_m) const;
  [[nodiscard]] bool empty() const { return lo.x > hi.x || lo.y > hi.y || bottom > top; }
};

// Where the properties of a decision may hold: the boxes of the zones that have to hold all of a
// robot, cut with each other. Where only complements bound it, that is a box around their holes
// with room to get fast and to stop again.
class Field {
 public:
  explicit Field(const DecisionCase& decision);

  // Anywhere in the box. In one that is much wider than a robot needs to get fast, every other
  // place is near a boundary: nobody would reach one otherwise.
  Vec2 draw(sim::Random& random) const;
  double draw_height(sim::Random& random) const;
  // The same with twice the room where nothing but holes bounds it. False: it is bounded.
  bool widen();
  [[nodiscard]] const Box& box() const { return box_; }

 private:
  struct Edge {
    Vec2 from, to;
    double until_m = 0;  // the lengths of all edges up to here
  };
  void hold_zone(const ZoneView& zone, Box& holes);
  void hold_all(const sim::Property& p, const DecisionCase& decision, Box& holes);
  Vec2 near_an_edge(sim::Random& random) const;

  Box box_;
  double room_m_ = 0;
  bool open_ = false;  // only holes bound it
  bool near_ = false;
  std::vector<Edge> edges_;  // that lie somewhere, of all zones that properties speak of
};

}  // namespace rtac::simulate
