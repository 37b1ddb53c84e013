#include "compiler/analysis/magnitudes.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/dials.h"
#include "compiler/analysis/repairs.h"
#include "compiler/sema/visit.h"

namespace rtac::analysis {
namespace {

using diag::Code;

// Far above any robot, and small enough that products of three of them fit int64 on the grid.
const Rational length_max_m = 1000, speed_max_mps = 100, accel_max_mps2 = 1000, time_max_s = 60,
               turn_max = 1000, energy_max = 1000, hold_max_s = 1'000'000;
// Of steps and conditions that somebody waits for.
const Rational lasts_max_s = 86'400;
// A brake is rounded down to the grid and then divides.
const Rational least_accel_mps2(1, 1000);
const Rational extent_m(536'870'912, 1000);
// The share of the brake that may be needed against what pushes: a hold asks for the rest. Of holds
// under attack, errors at their bounds, none was lost below 0.85.
const Rational holdable_share(3, 4);

class Checker {
 public:
  Checker(const sema::Spec& spec, Trials* trials, diag::Engine& diagnostics)
      : spec_(spec), trials_(trials), diagnostics_(diagnostics) {}

  void run() {
    for (const sema::RobotKind& kind : spec_.kinds) check(kind);
    for (const sema::Decision& d : spec_.decisions) {
      if (d.period) most("the period", *d.period, time_max_s, "s");
    }
    for (const sema::Monitor& m : spec_.monitors) {
      if (m.ahead.duration) most("the look-ahead", *m.ahead.duration, time_max_s, "s");
      check(m);
    }
    for (const sema::Controller& c : spec_.controllers) check(c);
    for (const sema::Site& site : spec_.sites) {
      for (const sema::Site::Place& place : site.places) check(site, place);
    }
  }

 private:
  void check(const sema::RobotKind& k) {
    most("the radius", k.radius, length_max_m, "m");
    most("the speed", k.motion.speed, speed_max_mps, "m/s");
    most("the acceleration", k.motion.accel, accel_max_mps2, "m/s^2");
    least("the acceleration", k.motion.accel, least_accel_mps2, "m/s^2");
    most("the brake", k.motion.brake, accel_max_mps2, "m/s^2");
    if (k.motion.brake.value <= 0) return refuse_no_brake(k);  // all that is left divides by it
    least("the brake", k.motion.brake, least_accel_mps2, "m/s^2");
    const auto disturbance = [](sema::RobotKind& of) { return &*of.motion.disturbance; };
    const auto output = [](sema::RobotKind& of) { return &*of.output_error; };
    if (k.motion.disturbance) {
      check_push({"the disturbance", *k.motion.disturbance, disturbance}, k, {});
    }
    if (k.output_error) {
      const Rational pushed = k.motion.disturbance ? k.motion.disturbance->value : Rational(0);
      check_push({"the error of the output", *k.output_error, output}, k, pushed);
    }
    if (k.motion.turn) {
      most("the turn rate", *k.motion.turn, turn_max, "rad/s");
      // a millionth: the time of a turn stays below a year
      least("the turn rate", *k.motion.turn, Rational(1, 1'000'000), "rad/s");
    }
    if (k.motion.turn_accel) {
      least("the turn acceleration", *k.motion.turn_accel, Rational(1, 1'000'000), "rad/s^2");
    }
    sense(k.position, length_max_m, "m", time_max_s);
    sense(k.velocity, speed_max_mps, "m/s", time_max_s);
    sense(k.heading, turn_max, "rad", time_max_s);
    // a battery is slow: its samples may be older than those of a motion
    sense(k.battery, Rational(1), "of a full battery", 60 * time_max_s);
    if (k.hears_max_age) most("the age", *k.hears_max_age, time_max_s, "s");
    if (k.plan) most("the tracking", k.plan->tracking, length_max_m, "m");
    most("the latency", k.latency, time_max_s, "s");
    if (k.energy) energy(*k.energy);
  }
  void refuse_no_brake(const sema::RobotKind& k) {
    std::optional<Rational> works;
    if (trials_ != nullptr) {
      sema::Motion& motion = trials_->spec().kinds[std::size_t(&k - spec_.kinds.data())].motion;
      // who speeds up and brakes alike is the usual robot
      works = nearest(motion.brake, "brake" + k.name, k.motion.accel.value,
                      fault_of(Code::limit_contradictory, k.motion.brake.range));
    }
    diagnostics_.report(
        {Code::limit_contradictory,
         k.motion.brake.range,
         "`" + k.name + "` cannot stop: `brake` is " + to_decimal(k.motion.brake.value) + " m/s^2",
         "must be more than 0",
         {},
         works ? "at least " + to_decimal(*works) + " m/s^2 works"
               : as_tried(trials_,
                          "give the least deceleration that the robot is sure to reach; no "
                          "brake alone mends all of this specification"),
         {}});
  }
  struct Push {
    std::string what;
    const sema::Quantity& value;
    std::function<sema::Quantity*(sema::RobotKind&)> of;
  };
  // What the brake has left divides, and is rounded down to the grid; who is pushed harder than it
  // speeds up never gets back to its place. `others`: what pushes besides.
  void check_push(const Push& push, const sema::RobotKind& k, const Rational& others) {
    const Rational held = std::min(Rational(k.motion.brake.value * holdable_share),
                                   Rational(k.motion.brake.value - 2 * least_accel_mps2)) -
                          others;
    const Rational followed = k.motion.accel.value - 2 * least_accel_mps2 - others;
    if (push.value.value <= std::min(held, followed)) return;
    const auto number = static_cast<std::size_t>(&k - spec_.kinds.data());
    const Fault fault = fault_of(Code::limit_contradictory, push.value.range);
    std::vector<std::string> works;
    const auto offer = [&](const char* before, const std::optional<Rational>& value) {
      if (value) works.push_back(before + to_decimal(*value) + " m/s^2");
    };
    if (trials_ != nullptr) {
      sema::Motion& motion = trials_->spec().kinds[number].motion;
      const auto most = std::min(held, followed);
      const Rational all = push.value.value + others;
      offer("at most ",
            nearest(*push.of(trials_->spec().kinds[number]), push.what + k.name, most, fault));
      if (push.value.value > held) {
        offer("a `brake` of at least ",
              nearest(motion.brake, "brake" + k.name, Rational(all / holdable_share), fault));
      }
      if (push.value.value > followed) {
        offer("an `accel` of at least ",
              nearest(motion.accel, "accel" + k.name, Rational(all + 2 * least_accel_mps2), fault));
      }
    }
    refuse(push, k, others, push.value.value > held,
           works.empty()
               ? as_tried(trials_,
                          "no number alone works: a stronger brake and `accel` are needed, or less "
                          "that pushes, or a faster recovery")
               : joined(works) + " works");
  }
  // The number nearest to the written one that works, in m/s^2; none: others have to change with
  // it.
  std::optional<Rational> nearest(sema::Quantity& number, const std::string& name,
                                  const Rational& guess, const Fault& fault) {
    constexpr int per_unit = 1000;
    const bool grows = guess > number.value;
    const std::int64_t steps = floor_to_int(Rational(guess * per_unit)) + (grows ? 1 : 0);
    if (steps < 1) return std::nullopt;
    const std::int64_t far = grows ? floor_to_int(Rational(accel_max_mps2 * per_unit)) : 1;
    const auto found =
        quantity_that_works(*trials_, {fault, per_unit, 0, steps, far}, name, number);
    if (!found) return std::nullopt;
    Rational value(static_cast<long>(*found), per_unit);
    value.canonicalize();
    return value;
  }
  void refuse(const Push& push, const sema::RobotKind& k, const Rational& others, bool of_brake,
              const std::string& help) {
    const sema::Quantity& limit = of_brake ? k.motion.brake : k.motion.accel;
    const std::string value = to_decimal(limit.value) + " m/s^2";
    std::vector<diag::Note> notes = {
        {limit.range, of_brake ? "a hold needs a quarter of the brake of " + value
                               : "who is led back to its place speeds up by " + value +
                                     " at most, which has to be more than what pushes"}};
    if (others > 0) {
      notes.push_back({k.motion.disturbance->range,
                       "the disturbance takes " + to_decimal(others) + " m/s^2 of it besides"});
    }
    diagnostics_.report({Code::limit_contradictory,
                         push.value.range,
                         push.what + " leaves `" + k.name + "` too little of its " +
                             (of_brake ? "brake" : "`accel`"),
                         "a robot that holds its place may be carried off",
                         std::move(notes),
                         help,
                         {}});
  }
  void energy(const sema::Energy& e) {
    most("`drive`", e.drive, energy_max, "of a full battery per m");
    most("`idle`", e.idle, energy_max, "of a full battery per s");
    most("`drain`", e.drain, energy_max, "of a full battery per s");
    most("`held`", e.held, hold_max_s, "s");
    most("`detour`", e.detour, hold_max_s, "m");
  }
  void sense(const std::optional<sema::Sense>& s, const Rational& error, const char* unit,
             const Rational& age_s) {
    if (!s) return;
    most("the error", s->error, error, unit);
    most("the age", s->max_age, age_s, "s");
  }
  // Control is not given back before it is over.
  void lasts(const sema::Quantity& q, const char* what) {
    if (q.value <= lasts_max_s) return;
    diagnostics_.report({Code::quantity_out_of_range,
                         q.range,
                         std::string(what) + " lasts " + to_decimal(Rational(q.value / 3600)) +
                             " h: control is not given back before it is over",
                         "longer than a day",
                         {},
                         "at most 24 h works",
                         {}});
  }
  void check(const sema::Monitor& m) {
    if (!m.return_when) return;
    sema::for_each_expr(*m.return_when, [&](const sema::Expr& e) {
      const auto* held = std::get_if<sema::HeldFor>(&e.node);
      if (held != nullptr) lasts(held->duration, "the `for` of a return condition");
    });
  }
  void check(const sema::Controller& c) {
    const auto* sequence = std::get_if<sema::Sequence>(&c.implementation);
    if (sequence == nullptr) return;
    for (const auto& step : sequence->steps) {
      if (step.lasts) lasts(*step.lasts, "the step");
    }
  }
  void check(const sema::Site& site, const sema::Site::Place& place) {
    if (abs(place.position.x) <= extent_m && abs(place.position.y) <= extent_m) return;
    diagnostics_.report({Code::site_outside_zone,
                         place.range,
                         "the place of `" + site.name + "` lies beyond the grid",
                         "",
                         {},
                         "coordinates of at most 536 km work",
                         {}});
  }

  void most(const char* what, const sema::Quantity& q, const Rational& limit, const char* unit) {
    if (q.value > limit) report(what, q, "at most " + to_decimal(limit) + " " + unit + " fits");
  }
  void least(const char* what, const sema::Quantity& q, const Rational& limit, const char* unit) {
    if (q.value < limit) report(what, q, "at least " + to_decimal(limit) + " " + unit + " fits");
  }
  void report(const char* what, const sema::Quantity& q, std::string help) {
    diagnostics_.report({Code::value_out_of_range,
                         q.range,
                         std::string(what) + " does not fit the integer kernel",
                         "",
                         {},
                         std::move(help),
                         {}});
  }

  const sema::Spec& spec_;
  Trials* trials_;
  diag::Engine& diagnostics_;
};

}  // namespace

void check_magnitudes(const sema::Spec& spec, Trials* trials, diag::Engine& diagnostics) {
  Checker(spec, trials, diagnostics).run();
}

}  // namespace rtac::analysis
