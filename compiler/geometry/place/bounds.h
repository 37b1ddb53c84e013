// How far imported zones may be from where they belong, in metres. All of it is about the azimuthal
// equidistant projection of the WGS 84 ellipsoid about an origin; the derivation is in
// compiler/docs/adr/0007-projection-of-imported-zones.md. Doubles, rounded up where they leave this
// folder.
#pragma once

namespace rtac::geometry {

// Distances are bounded between places that lie at most so much farther from the origin than the
// zone does.
inline constexpr double around_m = 1'000;
// Zones farther from the origin are refused.
inline constexpr double reach_m_max = 100'000;

// Distances on the map are true or too large, by at most this much, between any two places within
// `reach_m` of the origin: d^3 / (3 b^2), from Rauch's comparison theorem.
double distance_error_m(double reach_m);

// An edge in degrees: from one position to the other, longitude and latitude changing evenly.
struct DegreeEdge {
  double longitude_a_deg, latitude_a_deg, longitude_b_deg, latitude_b_deg;
};
// No part of the edge moves faster than its length would let it: an upper bound of that length.
double length_m_up(const DegreeEdge& edge);
// Per metre: an edge, and likewise the shortest way between its ends, deviates from the straight
// line on the map by at most length^2 times an eighth of this.
double bend_per_m(const DegreeEdge& edge);

}  // namespace rtac::geometry
