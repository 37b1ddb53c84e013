#include "compiler/driver/outline_notes.h"

#include <algorithm>
#include <utility>

#include "compiler/sema/in_file.h"
#include "compiler/support/overloaded.h"

namespace rtac::driver {
namespace {

using sema::Point;
using Ring = sema::ZonePolygon::Ring;

// Twice the area of the triangle a, b, c: positive when c is on the left of a -> b.
Rational cross(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Neither the outline turns there, nor is it a point that stands within a long edge of a file.
bool is_straight(const Ring& ring, std::size_t i) {
  const std::size_t n = ring.points.size(), before = (i + n - 1) % n;
  if (ring.in_file && i > 0 && ring.in_file->vertices[i] == ring.in_file->vertices[before]) {
    return false;
  }
  return cross(ring.points[before], ring.points[i], ring.points[(i + 1) % n]) == 0;
}

// A simple ring turns as a whole as it does at the lowest of its vertices, of several the leftmost:
// that one is a corner.
bool runs_clockwise(const Ring& ring) {
  const std::size_t n = ring.points.size();
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < n; ++i) {
    const Point &p = ring.points[i], &q = ring.points[lowest];
    if (p.y < q.y || (p.y == q.y && p.x < q.x)) lowest = i;
  }
  return cross(ring.points[(lowest + n - 1) % n], ring.points[lowest],
               ring.points[(lowest + 1) % n]) < 0;
}

// Counts what is mended in rings, and remembers where it is first.
class Notes {
 public:
  void look(const sema::ZonePolygon& polygon) {
    look(polygon.outer, 0);
    for (std::size_t h = 0; h < polygon.holes.size(); ++h) look(polygon.holes[h], h + 1);
  }

  [[nodiscard]] std::vector<OutlineNote> take() const {
    std::vector<OutlineNote> notes;
    const auto add = [&](const Count& of, const char* one, const char* many) {
      if (of.number == 0) return;
      notes.push_back({of.number == 1 ? one : std::to_string(of.number) + many, of.first});
    };
    add(straight_, "1 vertex lies on a line with its neighbours and is left out",
        " vertices lie on a line with their neighbours and are left out");
    add(outlines_, "the outline runs clockwise and is turned",
        " outlines run clockwise and are turned");
    add(holes_, "1 hole runs counter-clockwise and is turned",
        " holes run counter-clockwise and are turned");
    return notes;
  }

 private:
  struct Count {
    std::size_t number = 0;
    std::string first{};
  };
  static void add(Count& count, std::string place) {
    if (count.number++ == 0) count.first = std::move(place);
  }
  // From 1, as authors and files count.
  static std::string vertex_text(const Ring& ring, std::size_t i) {
    return ring.in_file ? sema::vertex_text(*ring.in_file, i) : "vertex " + std::to_string(i + 1);
  }
  static std::string ring_text(const Ring& ring, std::size_t number) {
    if (ring.in_file) return ring.in_file->where;
    return number == 0 ? "" : "hole " + std::to_string(number);
  }
  void look(const Ring& ring, std::size_t number) {
    const std::string name = ring_text(ring, number);
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      if (!is_straight(ring, i)) continue;
      add(straight_, vertex_text(ring, i) + (name.empty() ? "" : " of " + name));
    }
    // Of holes only formats of files say how they run.
    if (number > 0 && !ring.in_file) return;
    if (runs_clockwise(ring) == (number == 0)) add(number == 0 ? outlines_ : holes_, name);
  }

  Count straight_, outlines_, holes_;
};

void look(const sema::ZoneImport& import, Notes& notes) {
  const auto look_at = [&](const sema::ZoneImport::Area& area) {
    for (const auto& part : area.parts) {
      if (const auto* polygon = std::get_if<sema::ZonePolygon>(&part)) notes.look(*polygon);
    }
  };
  for (const auto& group : import.inclusions) std::ranges::for_each(group, look_at);
  std::ranges::for_each(import.exclusions, look_at);
}

void look(const sema::ZoneExpr& expr, Notes& notes) {
  std::visit(Overloaded{
                 [&](const sema::ZonePolygon& node) { notes.look(node); },
                 [](const sema::ZoneCircle&) {},
                 [](const sema::ZoneRef&) {},
                 [&](const sema::ZonePrism& node) { look(*node.base, notes); },
                 [](const sema::ZoneComplement&) {},  // of a zone of its own
                 [&](const sema::ZoneBinary& node) {
                   look(*node.left, notes);
                   look(*node.right, notes);
                 },
                 [&](const sema::ZoneOffset& node) { look(*node.operand, notes); },
                 [&](const sema::ZoneImport& node) { look(node, notes); },
                 [](const sema::ZoneReceived&) {},
             },
             expr.node);
}

}  // namespace

std::vector<OutlineNote> outline_notes(const sema::ZonePolygon& polygon) {
  Notes notes;
  notes.look(polygon);
  return notes.take();
}

std::vector<OutlineNote> outline_notes(const sema::ZoneImport& import) {
  Notes notes;
  look(import, notes);
  return notes.take();
}

std::vector<OutlineNote> outline_notes(const sema::ZoneExpr& expr) {
  Notes notes;
  look(expr, notes);
  return notes.take();
}

}  // namespace rtac::driver
