#include <algorithm>

#include "rtac/safe/manoeuvre.h"
#include "rtac/safe/pace.h"
#include "rtac/safe/pilot.h"

namespace rtac::safe {
namespace {

// Below the resolution of a millimetre grid: the clearance "does not fall" up to this.
constexpr double loss_m = 2e-3;

class ClearanceAtLeast : public PlaceTest {
 public:
  explicit ClearanceAtLeast(double clearance_m) : clearance_m_(clearance_m) {}
  [[nodiscard]] bool accepts(Vec2, double clearance_m) const override {
    return clearance_m >= clearance_m_;
  }

 private:
  double clearance_m_;
};

}  // namespace

void RetreatManoeuvre::engage(const Observation&) {
  stay();
  next_look_us_ = never_us;
}

void RetreatManoeuvre::decide(const Observation& observation, Gate, bool at_rest) {
  // On the way nothing is reconsidered; the pilot comes to rest at its end or when the gate closes.
  if (!at_rest || observation.now_us < next_look_us_) return;
  next_look_us_ = observation.now_us + pace::look_every_us;
  look(observation);
}

void RetreatManoeuvre::look(const Observation& observation) {
  stay();
  const double now_m = signed_clearance(*setting_.zone, at_);
  if (now_m >= setting_.return_clearance_m) return;
  // The way ends a little short of its last point, by a measurement: aim deeper, so that the place
  // is good when it is reached.
  const double slack_m = end_reach_m(setting_) + setting_.limits.position_error_m;
  FixedList<double, 5> wanted;
  if (room_m_ > 0) (void)wanted.push(setting_.return_clearance_m + slack_m + room_m_);
  (void)wanted.push(setting_.return_clearance_m + slack_m);
  (void)wanted.push(setting_.return_clearance_m);
  if (now_m < setting_.limits.radius_m) {  // outside: any place inside is better than here
    (void)wanted.push(setting_.route_clearance_m);
    (void)wanted.push(setting_.limits.radius_m + slack_m);
  }
  for (const bool around_held : {true, false}) {
    const RouteQuery from_here = query(observation, around_held);
    for (const double wanted_m : wanted) {
      if (wanted_m <= now_m || !find(from_here, now_m, wanted_m)) continue;
      if (now_m >= setting_.limits.radius_m) run_out(from_here);
      return;
    }
  }
  stay();
}

bool RetreatManoeuvre::find(const RouteQuery& from_here, double now_m, double wanted_m) {
  if (find_straight(from_here, now_m, wanted_m)) return true;
  // A leg in sight that is short enough, or else the shorter one of that and of what is searched:
  // so the compiler knows how long a way can be (analysis: liveness).
  const ClearanceAtLeast test(wanted_m);
  Path straight;
  const bool in_sight = route_.straight_to_place(from_here, test, now_m - loss_m, straight);
  const double straight_m = in_sight ? length_m(from_here.start, straight) : 0;
  const bool outside = now_m < setting_.limits.radius_m;  // no detours there
  if (!outside && !(in_sight && straight_m <= 2 * wanted_m)) {
    RouteQuery along = from_here;
    along.clearance_m = std::min(setting_.route_clearance_m, now_m);
    const bool found = route_.to_place(along, test, way_);
    if (!in_sight || (found && route_.way_length_m() < straight_m)) return found;
  }
  way_ = straight;
  return in_sight;
}

// Control is given back where the way leads to, often while the robot still moves: it passes there
// at full speed, and slows down beyond, where the clearance is no less. A robot that crept up to
// that place would keep control for longer than the way takes.
void RetreatManoeuvre::run_out(const RouteQuery& from_here) {
  const std::size_t last = way_.points.size() - 1;
  const Vec2 end = way_.points[last];
  const Vec2 from = last > 0 ? way_.points[last - 1] : from_here.start;
  const double leg_m = norm(end - from);
  if (leg_m < 1e-6) return;
  const Vec2 beyond = end + (run_out_m(setting_) / leg_m) * (end - from);
  const double least_m = signed_clearance(*setting_.zone, end) - loss_m;
  if (!route_.leg_allowed(from_here, end, beyond)) return;
  if (keeps_clearance(*setting_.zone, end, beyond, least_m)) way_.points[last] = beyond;
}

// Straight away from the nearest point of the boundary, or straight in through it. Clearance cannot
// fall on that leg: t after p it is at least `wanted` less what is left of the leg, which is the
// clearance at p plus t.
bool RetreatManoeuvre::find_straight(const RouteQuery& from_here, double now_m, double wanted_m) {
  const ZoneView& zone = *setting_.zone;
  const Vec2 p = from_here.start, boundary = nearest_boundary(zone, p);
  const double distance_m = norm(p - boundary);
  if (distance_m < 1e-6) return false;  // on it: no direction to tell
  const Vec2 inward = ((now_m < 0 ? -1.0 : 1.0) / distance_m) * (p - boundary);
  const Vec2 q = boundary + wanted_m * inward;
  if (signed_clearance(zone, q) < wanted_m - 1e-6) return false;
  if (!route_.leg_allowed(from_here, p, q)) return false;
  stay();
  return way_.points.push(q);
}

}  // namespace rtac::safe
