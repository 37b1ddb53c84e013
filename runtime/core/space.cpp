#include "rtac/safe/space.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "angles.h"
#include "rtac/safe/manoeuvre.h"
#include "rtac/safe/pace.h"

namespace rtac::safe {
namespace {

constexpr double s_per_us = 1e-6;
constexpr double infinite = std::numeric_limits<double>::infinity();
// As of other retreats: the clearance "does not fall" up to the resolution of the grid.
constexpr double loss_m = 2e-3;
// Looks at clearances in one search, at a glance and as many piece by piece, and cells that are
// tried on one height. At a glance a leg takes one look per slab, so that of up to six slabs all
// heights are looked at (verify: legs_back): 13 heights of twice 7 looks and 24 cells of 7 more,
// for a clearance with the slack of a measurement and for one without. Once they are spent, the
// search ends: no cell is compared any more.
constexpr int looks_max = 8000, cells_tried_max = 24;
// Of doubles: a place that is as clear as is wanted counts as such.
constexpr double rounding_m = 1e-6;

// A rest lets the decision give control back: this many periods are more than its dwell.
constexpr TimeUs rest_periods = 12;

// How the legs of a way are looked at.
enum class How { at_a_glance, piece_by_piece };

double squared(double x) {
  return x * x;
}
double inner(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3 nearest_on(Vec3 from, Vec3 to, Vec3 at) {
  const Vec3 way = to - from;
  const double square = inner(way, way);
  return square > 0 ? from + std::clamp(inner(at - from, way) / square, 0.0, 1.0) * way : to;
}

// What is around a place, looked at so many times at most.
class Sight {
 public:
  explicit Sight(const Setting& setting) : solid_(setting.solid), flat_(setting.zone) {}

  [[nodiscard]] bool spent() const { return looks_ <= 0; }
  double clearance_m(Vec3 p) {
    if (looks_-- <= 0) return -infinite;
    return solid_ != nullptr ? signed_clearance(*solid_, p) : signed_clearance(*flat_, {p.x, p.y});
  }
  // No place of a leg, which is level or upright, is closer to the boundary. At a glance: by the
  // zones of the plane at all heights so near.
  bool leg_is_clear(Vec3 a, Vec3 b, double least_m, How how) {
    return how == How::at_a_glance ? slabs_are_clear(a, b, least_m)
                                   : pieces_are_clear(a, b, least_m);
  }
  // The height z, and others where slabs that lie on each other leave `wanted_m` above a floor or
  // below a ceiling: of each the nearest.
  template <class Visit>
  void heights(double z, double wanted_m, const Visit& visit) const {
    visit(z);
    const std::size_t count = solid_ != nullptr ? solid_->slab_count : 0;
    for (std::size_t first = 0, end = 0; first < count; first = end) {
      end = first + 1;
      while (end < count && solid_->slabs[end].floor_m == solid_->slabs[end - 1].ceiling_m) ++end;
      const double low_m = solid_->slabs[first].floor_m + wanted_m;
      const double high_m = solid_->slabs[end - 1].ceiling_m - wanted_m;
      for (std::size_t i = first; i < end; ++i) {
        const double over_m = solid_->slabs[i].floor_m + wanted_m;
        const double under_m = solid_->slabs[i].ceiling_m - wanted_m;
        if (z < over_m && over_m <= high_m) visit(over_m);
        if (under_m < z && low_m <= under_m) visit(under_m);
      }
    }
  }
  // The zone of the plane at a height; null: there is none.
  [[nodiscard]] const ZoneView* at_height(double z) const {
    if (solid_ == nullptr) return flat_;
    for (std::size_t i = 0; i < solid_->slab_count; ++i) {
      const SlabView& slab = solid_->slabs[i];
      if (slab.floor_m <= z && z <= slab.ceiling_m) return slab.base;
    }
    return nullptr;
  }

 private:
  bool slabs_are_clear(Vec3 a, Vec3 b, double least_m) {
    if (!(least_m > 0)) return false;
    if (solid_ == nullptr) return wall_is_clear(*flat_, a, b, least_m);
    const double low_m = std::min(a.z, b.z), high_m = std::max(a.z, b.z);
    double up_to_m = low_m - least_m;
    for (std::size_t i = 0; i < solid_->slab_count; ++i) {
      const SlabView& slab = solid_->slabs[i];
      const double apart_m = std::max({slab.floor_m - high_m, low_m - slab.ceiling_m, 0.0});
      if (apart_m >= least_m) continue;
      // what a ball around the leg is wide there
      const double beside_m = std::sqrt(least_m * least_m - apart_m * apart_m);
      if (slab.floor_m > up_to_m || !wall_is_clear(*slab.base, a, b, beside_m)) return false;
      up_to_m = slab.ceiling_m;
    }
    return up_to_m >= high_m + least_m;
  }
  bool wall_is_clear(const ZoneView& zone, Vec3 a, Vec3 b, double least_m) {
    if (looks_-- <= 0) return false;
    const Vec2 from{a.x, a.y}, to{b.x, b.y};
    const bool upright = a.x == b.x && a.y == b.y;
    return upright ? signed_clearance(zone, from) >= least_m
                   : keeps_clearance(zone, from, to, least_m);
  }
  // A clearance changes by no more than the way.
  bool pieces_are_clear(Vec3 a, Vec3 b, double least_m) {
    const double length_m = norm(b - a);
    const double middle_m = clearance_m(0.5 * (a + b));
    if (!(middle_m >= least_m)) return false;
    if (middle_m - length_m / 2 >= least_m || length_m <= 2 * loss_m) return true;
    const Vec3 middle = 0.5 * (a + b);
    return pieces_are_clear(a, middle, least_m) && pieces_are_clear(middle, b, least_m);
  }

  const SolidView* solid_;
  const ZoneView* flat_;
  int looks_ = looks_max;
};

// The middles of cells that are clear enough on their level, the nearest first.
template <class Accept>
bool nearest_cell(const ZoneView& zone, Vec3 from, double wanted_m, const Accept& accept) {
  double beyond = -1;  // squares of distances
  for (int tries = 0; tries < cells_tried_max; ++tries) {
    double nearest = infinite;
    Vec3 best;
    for (std::int32_t row = 0; row < zone.rows; ++row) {
      for (std::int32_t column = 0; column < zone.columns; ++column) {
        if (1e-3 * zone.clearance_mm_lo[row * zone.columns + column] < wanted_m) continue;
        const Vec3 middle{1e-3 * (zone.origin_x_mm + (column + 0.5) * zone.cell_mm),
                          1e-3 * (zone.origin_y_mm + (row + 0.5) * zone.cell_mm), from.z};
        const double square = squared(middle.x - from.x) + squared(middle.y - from.y);
        if (square <= beyond || square >= nearest) continue;
        nearest = square;
        best = middle;
      }
    }
    if (nearest == infinite) return false;
    if (accept(best)) return true;
    beyond = nearest;
  }
  return false;
}

// Up or down, and then level, on the height with the shortest way. Straight up or down is looked at
// before any level leg is, where no cell of its own level is nearer: over a wide roof such a leg
// may take all looks, piece by piece, and lead nowhere.
template <class Legs>
void find_place(Sight& sight, Vec3 from, double wanted_m, double least_m, How how, Legs& legs) {
  double best_m = infinite, beside_m = infinite;
  const auto is_place = [&](Vec3 p) { return sight.clearance_m(p) >= wanted_m - rounding_m; };
  const auto look_at = [&](double z, bool beside_too) {
    const Vec3 level{from.x, from.y, z};
    if (sight.spent()) return;
    const double up_m = std::abs(z - from.z);
    if (up_m >= best_m || (up_m > 0 && !sight.leg_is_clear(from, level, least_m, how))) return;
    if (is_place(level)) {
      best_m = up_m;
      legs.clear();
      (void)legs.push(level);
      return;
    }
    const ZoneView* const zone = sight.at_height(z);
    if (!beside_too || zone == nullptr || sight.spent()) return;
    (void)nearest_cell(*zone, level, wanted_m, [&](Vec3 aim) {
      const double way_m = up_m + norm(aim - level);
      if (way_m >= best_m) return true;  // whatever comes after it is no nearer
      if (!is_place(aim) || !sight.leg_is_clear(level, aim, least_m, how)) return sight.spent();
      best_m = way_m;
      legs.clear();
      if (up_m > 0) (void)legs.push(level);
      (void)legs.push(aim);
      return true;
    });
  };
  if (const ZoneView* const zone = sight.at_height(from.z)) {
    (void)nearest_cell(*zone, from, wanted_m, [&](Vec3 aim) {
      beside_m = norm(aim - from);
      return true;
    });
  }
  sight.heights(from.z, wanted_m, [&](double z) {
    if (std::abs(z - from.z) <= beside_m) look_at(z, false);
  });
  sight.heights(from.z, wanted_m, [&](double z) { look_at(z, true); });
}

}  // namespace

void Carried::engage(const Observation& observation) {
  pilot_.engage(observation);
  broken_off_ = legs_;
  leg_broken_off_ = on_leg_;
  legs_.clear();
  on_leg_ = leads_ = carries_ = stopped_ = returning_ = false;
  near_.reset();
  next_look_us_ = never_us;
}

// Another recovery has driven in between: the leg goes on where that has left the robot near it.
void Carried::go_on(const Halt& halt) {
  pilot_.go_on(halt);
  legs_ = broken_off_;
  on_leg_ = stopped_ = leg_broken_off_;
}

std::optional<Halt> Carried::halt() const {
  return leads_ ? hold_on_way() : pilot_.halting();
}

std::optional<Halt> Carried::hold_on_way() const {
  if (!near_) return Halt{};
  auto held = pilot_.halting();
  if (held) held->place = *near_;
  return held;
}

void Carried::hold_at(Vec3 place) {
  Halt held = *pilot_.halting();
  held.place = place;
  pilot_.go_on(held);
}

void Carried::stop() {
  carries_ = false;
  if (!leads_) return;
  pilot_.go_on(*hold_on_way());
  leads_ = false;
  stopped_ = true;
  near_.reset();
}

void Carried::drop_legs() {
  stop();
  legs_.clear();
}

Acceleration Carried::command(const Observation& observation, Gate gate) {
  if (!pilot_.can_steer(observation)) {
    stop();
    return pilot_.brake_blind(observation);
  }
  if (stopped_ && pilot_.latched()) leave_far_leg();
  choose(observation, gate);
  if (!pilot_.latched()) return pilot_.halt(observation);
  if (!legs_.empty()) {
    if (allowed(observation, gate)) {
      carry(observation);
    } else {
      stop();
    }
  }
  return pilot_.halt(observation);
}

void Carried::choose(const Observation& observation, Gate /*gate*/) {
  if (!pilot_.latched() || !legs_.empty() || observation.now_us < next_look_us_) return;
  next_look_us_ = observation.now_us + pace::look_every_us;
  Legs legs;
  look(observation.now_us, held(), legs);
  set_legs(legs);
}

void Carried::set_legs(const Legs& legs) {
  legs_ = legs;
  leg_ = 0;
  if (!legs_.empty() && !returning_) begin_leg();
}

void Carried::begin_leg() {
  leg_from_ = held();
  leg_to_ = legs_[leg_];
  on_leg_ = true;
}

void Carried::carry(const Observation& observation) {
  const Vec3 here = position_of(observation);
  const double step_m = setting_.speed_mps * static_cast<double>(setting_.period_us) * s_per_us;
  const Vec3 to = aim();
  const bool there = pilot_.carry(to, step_m);
  const bool near = norm(held() - here) <= pilot_.sway_m();
  leads_ = !near;
  carries_ = true;
  const Vec3 passed = nearest_on(returning_ ? return_from_ : leg_from_, to, here);
  const bool left = !pilot_.at_rest(observation) || norm(passed - here) > pilot_.sway_m();
  near_ = left ? std::nullopt : std::optional(passed);
  if (!there) return;
  if (returning_) {
    returning_ = false;
    // other legs may have been chosen while it was beside this one
    const bool goes_on = norm(legs_[leg_] - leg_to_) <= 0;
    if (!goes_on) begin_leg();
    return;
  }
  // the hold comes to the end first, and the robot after it, as near as errors that last let it
  if (!near) return;
  leg_from_ = to;
  leg_ended();
  if (++leg_ == legs_.size()) {
    legs_.clear();
    on_leg_ = carries_ = false;
  } else {
    leg_to_ = legs_[leg_];
  }
}

Vec3 Carried::aim() const {
  return returning_ ? nearest_on(leg_from_, leg_to_, held()) : leg_to_;
}

Vec3 Carried::set_out_from(const Observation& observation) const {
  return position_of(observation);
}

Vec3 Carried::recede_from(const Announcement& other) const {
  return position_of(other);
}

Vec3 Carried::on_leg(const Observation& observation) const {
  const Vec3 here = position_of(observation);
  if (!pilot_.latched() || (returning_ && leads_)) return here;
  const bool drives = carries_ && !returning_;
  return drives ? nearest_on(leg_from_, leg_to_, here) : held();
}

Vec3 Carried::on_way(const Observation& observation) const {
  return pilot_.latched() && returning_ ? aim() : on_leg(observation);
}

// Within what is declared a stop ends no further beside its leg: what it bends from the straight
// one (lemma sampled_brake), what errors of the hold lead it aside by while it stops, and its sway.
double Carried::stray_m() const {
  const RobotLimits& l = setting_.limits;
  const double b = l.brake_mps2, d = l.disturbance_mps2;
  const double reaction_s = delay_s(setting_, l.velocity_age_us);
  const double s = setting_.speed_mps + l.velocity_error_mps;
  const double eta_mps = l.velocity_error_mps + (b + d) * reaction_s;
  const double bend_m = (eta_mps * (s + eta_mps) + d * s * s / (2 * b)) / (b - d);
  const double aside_mps = 2 * (pace::hold_max_radps * l.position_error_m + l.velocity_error_mps);
  return bend_m + aside_mps * s / (2 * b) + pilot_.sway_m();
}

// At rest after a stop. Stop by stop, noise would carry it off: where it rests, errors that last
// put it beside its hold, and a hold that was latched there anew would sway from there. So it goes
// back to its leg, at once if it is no further off than it sways, and on from there. But further
// off than a stop explains something else has carried the robot away, and nobody has looked at what
// lies between: its next leg begins here.
void Carried::leave_far_leg() {
  stopped_ = false;
  const Vec3 place = held();
  const Vec3 nearest = on_leg_ ? nearest_on(leg_from_, leg_to_, place) : place;
  const double off_m = norm(place - nearest);
  // what is not a number is not near either
  if (!(off_m <= stray_m())) {
    legs_.clear();
    on_leg_ = false;
    carried_off();
  } else if (off_m <= sway_m()) {
    hold_at(nearest);
  }
  return_from_ = held();
  returning_ = on_leg_;
}

bool Carried::allowed(const Observation& observation, Gate gate) const {
  if (gate == Gate::free) return true;
  if (gate == Gate::hold) return false;
  // beside its leg by no more than its hold sways it counts as back on it
  const bool back = returning_ && norm(aim() - held()) <= sway_m();
  const Vec3 from = back ? aim() : set_out_from(observation);
  const Vec3 way = (back ? leg_to_ : aim()) - from;
  for (int j = 0; j < observation.robots; ++j) {
    const Announcement& other = observation.others[static_cast<std::size_t>(j)];
    if (j == observation.self || !is_held(other, observation.now_us)) continue;
    const Vec3 there = back ? place_of_held(other) : recede_from(other);
    if (!(inner(way, from - there) >= 0)) return false;
  }
  return true;
}

void Land::look(TimeUs /*now_us*/, Vec3 from, Legs& legs) {
  if (from.z <= setting_.land_at_m + sway_m()) return;
  (void)legs.push({from.x, from.y, setting_.land_at_m});
}

bool RetreatInSpace::leads_in(const Observation& observation) const {
  return can_steer(observation) &&
         Sight(setting_).clearance_m(position_of(observation)) < setting_.limits.radius_m;
}

void RetreatInSpace::look(TimeUs /*now_us*/, Vec3 from, Legs& legs) {
  const double now_m = Sight(setting_).clearance_m(from);
  // it may rest as far from where it is held as its hold sways: deeper is better, and nearer to the
  // boundary than that errors that last may keep it from being given back for ever
  const double slack_m = sway_m();
  if (now_m >= setting_.return_clearance_m + slack_m - rounding_m) return;
  const bool outside = now_m < setting_.limits.radius_m;
  const double least_m = (outside ? now_m : std::min(now_m, setting_.route_clearance_m)) - loss_m;
  FixedList<double, 4> wishes;
  (void)wishes.push(setting_.return_clearance_m + slack_m);
  if (now_m < setting_.return_clearance_m) (void)wishes.push(setting_.return_clearance_m);
  if (outside) {
    (void)wishes.push(setting_.route_clearance_m);
    (void)wishes.push(setting_.limits.radius_m + slack_m);
  }
  // At a glance first, and each way of looking with looks of its own: neither takes them away from
  // a wish that the other would fulfil.
  for (const How how : {How::at_a_glance, How::piece_by_piece}) {
    if (how == How::at_a_glance && least_m <= 0) continue;  // no leg is clear then
    Sight sight(setting_);
    for (const double wanted_m : wishes) {
      find_place(sight, from, wanted_m, least_m, how, legs);
      if (!legs.empty()) return;
    }
  }
}

void LoiterInSpace::engage(const Observation& observation) {
  RetreatInSpace::engage(observation);
  rests_since_us_ = never_us;
}

// The clearance at a point is that at the centre less the distance between them, at least: within
// the radius of where it rests, every place is as clear as control asks for, errors included.
void LoiterInSpace::look(TimeUs now_us, Vec3 from, Legs& legs) {
  RetreatInSpace::look(now_us, from, legs);
  if (!legs.empty()) rests_since_us_ = never_us;
  if (!legs.empty()) return;
  if (rests_since_us_ == never_us) rests_since_us_ = now_us;
  if (now_us - rests_since_us_ < rest_periods * setting_.period_us) return;
  rests_since_us_ = never_us;
  Sight sight(setting_);
  const double clear_m = sight.clearance_m(from);
  const double least_m = std::max(setting_.return_clearance_m, setting_.route_clearance_m);
  const double asked_m = least_m + sway_m() + 2 * setting_.limits.position_error_m;
  const double radius_m = std::min(LoiterManoeuvre::radius_m_max, clear_m - asked_m);
  if (radius_m < LoiterManoeuvre::radius_m_max) {
    find_place(sight, from, asked_m + LoiterManoeuvre::radius_m_max + sway_m(),
               std::min(clear_m, least_m) - loss_m, How::at_a_glance, legs);
  }
  if (legs.empty() && radius_m >= LoiterManoeuvre::radius_m_min) lap(from, radius_m, legs);
}

// A level square around the centre, and back to it.
void LoiterInSpace::lap(Vec3 centre, double radius_m, Legs& legs) {
  constexpr int corners = 4;
  for (int i = 0; i <= corners; ++i) {
    const double angle_rad = 2 * detail::pi * i / corners;
    (void)legs.push(centre + radius_m * Vec3{std::cos(angle_rad), std::sin(angle_rad), 0});
  }
  (void)legs.push(centre);  // never more than there may be
}

}  // namespace rtac::safe
