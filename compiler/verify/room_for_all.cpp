#include "compiler/verify/room_for_all.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/support/words.h"
#include "compiler/verify/common_place.h"

namespace rtac::verify {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

geometry::Point place(double x_mm, double y_mm) {
  return {analysis::metres_of(static_cast<std::int64_t>(x_mm)),
          analysis::metres_of(static_cast<std::int64_t>(y_mm))};
}

// How many lines a net has each way.
int lines_for(std::size_t corners) {
  constexpr double looks_max = 200'000;
  return static_cast<int>(
      std::clamp(std::sqrt(looks_max / static_cast<double>(corners + 1)), 12.0, 64.0));
}

// From the first to the last whole millimetre of a side.
struct Side {
  double low = infinite, high = -infinite;
  void take(const Rational& m) {
    low = std::min(low, m.get_d() * 1000), high = std::max(high, m.get_d() * 1000);
  }
  [[nodiscard]] double at(int line, int lines) const {
    return std::clamp(std::round(low + (high - low) * line / lines), std::ceil(low),
                      std::floor(high));
  }
};

// How far apart the centres of any two robots have to be to be given back both, and how much of
// that is asked for. Neither is held then: each reckons with its own reach, and with that of the
// other one from a message that is as old as it may be; both are measured beside where they are.
struct Apart {
  std::int64_t centres_mm = 0, asked_mm = 0;
};
Apart apart_of(const Subject& s) {
  const ir::Decision& d = s.decision;
  Apart most;
  for (const ir::Monitor& m : d.monitors) {
    std::int64_t asked_mm = analysis::sure_separation_mm(m.property, d.facts.params);
    if (m.return_when) {
      asked_mm = std::max(asked_mm, analysis::sure_separation_mm(*m.return_when, d.facts.params));
    }
    if (asked_mm == 0) continue;
    const std::int64_t ahead_us = m.lookahead.duration ? m.lookahead.duration_us : 0;
    const std::int64_t centres_mm =
        asked_mm + 2 * d.body.position_error_mm + analysis::return_clearance_mm(d, ahead_us) +
        analysis::return_clearance_mm(d, ahead_us + d.body.hears_age_us);
    if (centres_mm > most.centres_mm) most = {centres_mm, asked_mm};
  }
  return most;
}

std::size_t robots_of(const Subject& s) {
  return static_cast<std::size_t>(s.decision.robots);
}

// Where robots are given back in a zone that is so much wider: it grows less than it is told.
Floor grown_floor(const Subject& s, const std::vector<Need>& zones, std::int64_t by_mm) {
  const Rational by_m = analysis::metres_of(by_mm) - geometry::offset_excess_m();
  Floor floor;
  geometry::Region common = geometry::Region::everywhere();
  for (const Need& need : zones) {
    const geometry::Region wide = s.exact(need.zone).grow(by_m);
    const auto deep = analysis::within(wide, need.clearance_mm);
    common = deep ? common.intersect(*deep) : geometry::Region();
    floor.corners += wide.vertices();
  }
  floor.around = common.rings();
  floor.has = [common](const geometry::Point& at) { return common.contains(at); };
  return floor;
}

// The least growth on every side of the one zone that robots are given back in, in centimetres,
// with which there is room for all of them. none: there are several such zones, or it is one of
// many corners, for which it takes long.
std::optional<std::int64_t> growth_mm(const Subject& s, const std::vector<Need>& zones,
                                      const Apart& apart) {
  constexpr std::int64_t step_mm = 10, most_mm = 100'000;
  constexpr std::size_t vertices_max = 40;
  const bool one = !zones.empty() && std::ranges::all_of(zones, [&](const Need& need) {
    return need.zone == zones.front().zone;
  });
  if (!one || s.module[zones.front().zone].name.empty()) return std::nullopt;
  if (s.exact(zones.front().zone).vertices() > vertices_max) return std::nullopt;
  const auto fits = [&](std::int64_t by_mm) {
    return RoomForAll(robots_of(s), grown_floor(s, zones, by_mm)).centres(apart.centres_mm);
  };
  std::int64_t low = 0, high = step_mm;
  while (!fits(high)) {
    low = high, high *= 2;
    if (low >= most_mm) return std::nullopt;
  }
  while (high - low > step_mm) {
    const std::int64_t middle = (low + high) / (2 * step_mm) * step_mm;
    (fits(middle) ? high : low) = middle;
  }
  return high;
}

// Where robots are placed one by one there is not room in every wider zone: the least growth, and
// somewhat more.
void offer(const Subject& s, const std::vector<Need>& zones, const RoomForAll& room,
           const Apart& apart, Obligation& o) {
  const auto most_mm = room.most_apart_mm(apart.centres_mm);
  const std::int64_t left_mm = most_mm.value_or(0) - (apart.centres_mm - apart.asked_mm);
  o.repair = left_mm <= 0 ? "" : "a distance of at most " + metres(left_mm) + " works";
  o.besides = true;
  o.or_else = "a wider zone is needed";
  const auto by_mm = growth_mm(s, zones, apart);
  for (const std::int64_t more_mm : {0, 10, 20, 50, 100, 200}) {
    if (by_mm) o.mends.emplace_back(WiderZone{s.module[zones.front().zone].name, *by_mm + more_mm});
  }
}

}  // namespace

Floor floor_of(const Subject& s, const std::vector<Need>& all) {
  Floor floor;
  geometry::Region common = geometry::Region::everywhere();
  for (const Need& need : all) {
    const auto deep = analysis::within(s.exact(need.zone), need.clearance_mm);
    common = deep ? common.intersect(*deep) : geometry::Region();
    floor.corners += s.exact(need.zone).vertices();
  }
  floor.around = common.rings();
  floor.has = IsClear(s, all);
  return floor;
}

void offer_room(const Subject& s, const std::vector<Need>& zones, Obligation& o) {
  offer(s, zones, RoomForAll(robots_of(s), floor_of(s, zones)), apart_of(s), o);
}

Obligation all_at_once(const Subject& s, const std::vector<Need>& zones, const Floor& floor,
                       Obligation o) {
  const Apart apart = apart_of(s);
  if (robots_of(s) < 2 || apart.asked_mm == 0 || zones.empty()) return o;
  const std::string robots = std::to_string(robots_of(s));
  const RoomForAll room(robots_of(s), floor);
  const auto centres = room.centres(apart.centres_mm);
  if (!centres) {
    o.status = Status::unknown;
    o.method = "no proof";
    o.because = "no places were found where " + robots + " robots are given back, their centres " +
                metres(apart.centres_mm) + " apart";
    if (s.is_read) offer(s, floor.z_mm ? std::vector<Need>() : zones, room, apart, o);
    o.claims.clear();
    return o;
  }
  o.because += "; there is room for " + robots;
  for (std::size_t k = 0; k < centres->size(); ++k) {
    const std::int64_t x_mm = in_mm((*centres)[k].x), y_mm = in_mm((*centres)[k].y);
    for (const Need& need : zones) {
      Claim claim = place_claim(s, need.zone, x_mm, y_mm, need.clearance_mm);
      if (floor.z_mm) claim.values["z_mm"] = std::to_string(*floor.z_mm);
      claim.values["robot"] = std::to_string(k);
      o.claims.push_back(std::move(claim));
    }
  }
  return o;
}

// A net over all of it.
RoomForAll::RoomForAll(std::size_t robots, const Floor& floor) : robots_(robots) {
  Side across, up;
  for (const geometry::Ring& ring : floor.around) {
    for (const geometry::Point& p : ring) across.take(p.x), up.take(p.y);
  }
  if (across.low > across.high) return;
  const int lines = lines_for(floor.corners);
  for (int row = 0; row <= lines; ++row) {
    for (int column = 0; column <= lines; ++column) {
      const Spot at{across.at(column, lines), up.at(row, lines)};
      if (floor.has(place(at.x, at.y))) by_row_.push_back(at);
    }
  }
  by_column_ = by_row_;
  std::ranges::sort(
      by_column_, [](const Spot& a, const Spot& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
}

double RoomForAll::square(const Spot& a, const Spot& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

// Each place that is far enough from those before it.
RoomForAll::Spots RoomForAll::one_by_one(const Spots& net, double apart_mm) const {
  Spots taken;
  for (const Spot& at : net) {
    if (taken.size() == robots_) break;
    const bool far = std::ranges::all_of(
        taken, [&](const Spot& other) { return square(at, other) >= apart_mm * apart_mm; });
    if (far) taken.push_back(at);
  }
  return taken;
}

// From one place on, always the one that is farthest from all before it.
RoomForAll::Spots RoomForAll::farthest_first(std::size_t first, double apart_mm) const {
  Spots taken{by_row_[first]};
  std::vector<double> nearest(by_row_.size(), infinite);
  while (taken.size() < robots_) {
    for (std::size_t k = 0; k < by_row_.size(); ++k) {
      nearest[k] = std::min(nearest[k], square(by_row_[k], taken.back()));
    }
    const auto next = std::ranges::max_element(nearest);
    if (*next < apart_mm * apart_mm) break;
    taken.push_back(by_row_[static_cast<std::size_t>(next - nearest.begin())]);
  }
  return taken;
}

// What is found last may be too few.
RoomForAll::Spots RoomForAll::found(double apart_mm) const {
  if (by_row_.empty()) return {};
  Spots best = one_by_one(by_row_, apart_mm);
  if (best.size() < robots_) best = one_by_one(by_column_, apart_mm);
  constexpr std::size_t firsts = 8;  // spread over the rows
  for (std::size_t k = 0; k < firsts && best.size() < robots_; ++k) {
    best = farthest_first(k * (by_row_.size() - 1) / (firsts - 1), apart_mm);
  }
  return best;
}

std::optional<std::vector<geometry::Point>> RoomForAll::centres(std::int64_t apart_mm) const {
  const Spots spots = found(static_cast<double>(apart_mm));
  if (spots.size() < robots_) return std::nullopt;
  std::vector<geometry::Point> centres;
  std::ranges::transform(spots, std::back_inserter(centres),
                         [](const Spot& at) { return place(at.x, at.y); });
  return centres;
}

std::optional<std::int64_t> RoomForAll::most_apart_mm(std::int64_t below_mm) const {
  std::int64_t low = 1, high = below_mm;
  if (!centres(low)) return std::nullopt;
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (centres(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace rtac::verify
