// Why the pieces cover the band. Let p lie on the chosen side, q a nearest boundary point, and
// |p - q| <= d. The open segment p-q meets no boundary, so p sees q from the chosen side.
//  - q inside an edge: p - q is perpendicular to the edge, so p lies in the rectangle that the edge
//    sweeps when it moves by d to that side. The rectangle built here moves by lambda * N with N
//    the edge turned by a right angle (exact) and lambda a rational >= d / |N|: it contains the
//    true one.
//  - q a vertex: the wedge through which p is seen has an angle above 180 degrees (in a smaller one
//    an edge of the wedge would be nearer) and p - q lies between the normals of its two edges.
//    The fan built here spans at least those normals and consists of corners of a polygon that
//    contains the disc of radius d.
// Where rings touch, each wedge is part of the wedges of both rings there, so looking at each ring
// alone adds pieces but misses none.
#include "compiler/geometry/offset.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/ring.h"

namespace rtac::geometry {
namespace {

// A length along straight edges that is given away, to keep the rationals short.
constexpr unsigned kEdgeExcessBits = 21;  // 2^-21 m: half a micrometre

// The smallest multiple of 2^-bits that is at least sqrt(value), or the exact root.
Rational root_up(const Rational& value, unsigned bits) {
  if (mpz_perfect_square_p(value.get_num_mpz_t()) != 0 &&
      mpz_perfect_square_p(value.get_den_mpz_t()) != 0) {
    return Rational(sqrt(value.get_num()), sqrt(value.get_den()));
  }
  mpz_class scaled = value.get_num() << (2 * bits);
  mpz_cdiv_q(scaled.get_mpz_t(), scaled.get_mpz_t(), value.get_den_mpz_t());
  mpz_class root = sqrt(scaled);
  if (root * root < scaled) ++root;
  Rational result(root, mpz_class(1) << bits);
  result.canonicalize();
  return result;
}

// lambda >= d / |N|, with |lambda N| - d <= 2^-kEdgeExcessBits.
Rational scale_up(const Rational& distance, const Rational& squared_length) {
  // log2 |N|, at least: the excess of lambda is multiplied by |N|.
  const std::size_t whole = mpz_sizeinbase(mpz_class(squared_length).get_mpz_t(), 2);
  return root_up(distance * distance / squared_length,
                 kEdgeExcessBits + static_cast<unsigned>(whole / 2 + 1));
}

// Directions enough that the corners of the circumscribed polygon stick out by no more than the
// excess: half the angle between two directions is at most 1 / count, so by less than
// r (1 / cos(1 / count) - 1) < 0.6 r / count^2.
std::size_t directions_for(const Rational& radius, const Rational& excess) {
  constexpr std::int64_t fewest = 4;  // of which the bound above is true
  const Rational square = Rational(3, 5) * radius / excess;
  return static_cast<std::size_t>(std::max(fewest, ceil_to_int(root_up(square, 0))));
}

Rational det(const Point& u, const Point& v) {
  return u.x * v.y - u.y * v.x;
}

// 0 for angles in [0, 180) degrees, 1 for the rest: with `det`, an exact order by angle.
int half_plane(const Point& u) {
  return u.y > 0 || (u.y == 0 && u.x > 0) ? 0 : 1;
}
bool angle_less(const Point& u, const Point& v) {
  const int hu = half_plane(u);
  const int hv = half_plane(v);
  return hu != hv ? hu < hv : det(u, v) > 0;
}

// A polygon about the origin that contains the disc, with its edges' normals in order of angle.
struct Disc {
  std::vector<Point> normals;
  Ring corners;  // corners[i] between normals[i] and normals[i + 1]
};

// centre, then the corners that cover the sector from direction `from` counter-clockwise to `to`
// (less than 180 degrees).
Ring fan(const Point& centre, const Point& from, const Point& to, const Disc& disc) {
  const std::size_t n = disc.normals.size();
  const auto sector_of = [&](const Point& u) {
    // The last normal at or before u: its edge's corner before it starts the cover.
    const auto after = std::upper_bound(disc.normals.begin(), disc.normals.end(), u, angle_less);
    return static_cast<std::size_t>(after - disc.normals.begin()) + n - 1;
  };
  // The part of the polygon in directions between normals[i] and normals[i + 1] lies between
  // corners[i - 1] and corners[i + 1].
  const std::size_t first = sector_of(from) % n;
  const std::size_t last = sector_of(to) % n;
  Ring ring{centre};
  const std::size_t steps = (last + n - first) % n + 2;
  for (std::size_t k = 0; k <= steps; ++k) {
    const Point& corner = disc.corners[(first + n - 1 + k) % n];
    ring.push_back({centre.x + corner.x, centre.y + corner.y});
  }
  return ring;
}

Ring swept_rectangle(const Point& a, const Point& b, const Point& normal, const Rational& scale,
                     BandSide side) {
  const Point a2{a.x + scale * normal.x, a.y + scale * normal.y};
  const Point b2{b.x + scale * normal.x, b.y + scale * normal.y};
  return side == BandSide::interior ? Ring{a, b, b2, a2} : Ring{b, a, a2, b2};
}

void add_band(const Ring& ring, const Rational& distance, BandSide side, const Disc& disc,
              std::vector<Ring>& pieces) {
  const std::size_t n = ring.size();
  // The region is on the left of every edge.
  std::vector<Point> normals(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % n];
    normals[i] =
        side == BandSide::interior ? Point{a.y - b.y, b.x - a.x} : Point{b.y - a.y, a.x - b.x};
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Point& incoming = normals[(i + n - 1) % n];
    const Point& outgoing = normals[i];
    const int turn = sgn(det(incoming, outgoing));
    if (side == BandSide::interior && turn < 0) {
      pieces.push_back(fan(ring[i], outgoing, incoming, disc));
    } else if (side == BandSide::exterior && turn > 0) {
      pieces.push_back(fan(ring[i], incoming, outgoing, disc));
    }
    const Rational squared = outgoing.x * outgoing.x + outgoing.y * outgoing.y;
    pieces.push_back(
        swept_rectangle(ring[i], ring[(i + 1) % n], outgoing, scale_up(distance, squared), side));
  }
}

// (1 - t^2, 2 t) / (1 + t^2), at the angle 2 atan t, for every t in [0, 1); then the other three
// quadrants by quarter turns.
std::vector<Point> quadrant_directions(const std::vector<Rational>& parameters) {
  std::vector<Point> directions;
  directions.reserve(4 * parameters.size());
  for (const Rational& t : parameters) {
    const Rational square = t * t;
    directions.push_back({(1 - square) / (1 + square), 2 * t / (1 + square)});
  }
  for (std::size_t i = 0; i < 3 * parameters.size(); ++i) {
    const Point u = directions[i];
    directions.push_back({-u.y, u.x});
  }
  return directions;
}

}  // namespace

std::vector<Point> unit_directions(std::size_t count) {
  // Equal steps of t make steps of the angle 2 atan t of at most 2 / count.
  std::vector<Rational> parameters;
  for (std::size_t i = 0; i < count; ++i) {
    parameters.emplace_back(static_cast<unsigned long>(i), static_cast<unsigned long>(count));
    parameters.back().canonicalize();
  }
  return quadrant_directions(parameters);
}

std::vector<Point> regular_directions(std::size_t count) {
  std::vector<Rational> parameters;
  for (std::size_t i = 0; i < count / 4; ++i) {
    const double angle = M_PI * static_cast<double>(i) / static_cast<double>(count);
    parameters.emplace_back(static_cast<unsigned long>(std::lround(std::tan(angle) * 4096)),
                            4096UL);
    parameters.back().canonicalize();
  }
  return quadrant_directions(parameters);
}

Ring circumscribed(const Point& centre, const Rational& radius,
                   const std::vector<Point>& directions) {
  Ring ring;
  ring.reserve(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Point& u = directions[i];
    const Point& v = directions[(i + 1) % directions.size()];
    const Rational scale = radius / (1 + u.x * v.x + u.y * v.y);
    ring.push_back({centre.x + scale * (u.x + v.x), centre.y + scale * (u.y + v.y)});
  }
  return ring;
}

Ring inscribed(const Point& centre, const Rational& radius, const std::vector<Point>& directions) {
  Ring ring;
  ring.reserve(directions.size());
  for (const Point& u : directions) {
    ring.push_back({centre.x + radius * u.x, centre.y + radius * u.y});
  }
  return ring;
}

std::vector<Ring> boundary_band(const std::vector<PolygonWithHoles>& parts,
                                const Rational& distance, const Rational& excess, BandSide side) {
  Disc disc;
  disc.normals = unit_directions(directions_for(distance, excess));
  disc.corners = circumscribed(Point{}, distance, disc.normals);
  std::vector<Ring> pieces;
  for (const PolygonWithHoles& part : parts) {
    add_band(part.outer, distance, side, disc, pieces);
    for (const Ring& hole : part.holes) add_band(hole, distance, side, disc, pieces);
  }
  return pieces;
}

}  // namespace rtac::geometry
