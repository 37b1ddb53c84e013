#include "rtac/stack/plan_executor.h"

#include <algorithm>
#include <chrono>

#include "rtac/safe/manoeuvre.h"
#include "rtac/sample.h"

namespace rtac::stack {

namespace {

Sample<Vec2> commanded(const Acceleration& output, TimeUs now_us) {
  return {output.value_mps2, now_us};
}
Sample<Vec2> commanded(const Twist&, TimeUs) {
  return {};  // the compiler refuses to judge twists
}
double commanded_up(const Acceleration& output) {
  return output.up_mps2;
}
double commanded_up(const Twist&) {
  return 0;
}

}  // namespace

template <class Output>
PlanExecutor<Output>::PlanExecutor(int index, int robots, const RobotParts<Output>& parts,
                                   const SystemOptions& options, SystemObserver& observer)
    : index_(index),
      parts_(parts),
      options_(options),
      observer_(observer),
      watchdog_(parts.period_us, options.late_periods) {
  observation_.self = index;
  observation_.robots = robots;
  observation_.others.reserve(static_cast<std::size_t>(robots));
}

template <class Output>
void PlanExecutor<Output>::handle(const ExecutorEvent& event) {
  std::visit([this](const auto& e) { this->on(e); }, event);
}

template <class Output>
SafeController<Output>* PlanExecutor<Output>::active() const {
  return mode_ == 0 ? nullptr : parts_.recoveries[static_cast<std::size_t>(mode_ - 1)];
}

template <class Output>
int PlanExecutor<Output>::surrender_mode() const {
  return parts_.decision->info().surrender_mode;
}

template <class Output>
void PlanExecutor<Output>::on(const Tick& tick) {
  const bool late = watchdog_.expired(tick.now_us);
  sense(tick.now_us);
  follow_progress();
  observation_.plan = plan_;
  propose();
  decide();
  watchdog_.stepped(tick.now_us);
  const Output output = command(late && options_.protect);
  sdk_->actuate(output);
  remember(output);
  announce();
  report();
}

template <class Output>
void PlanExecutor<Output>::on(const NewPlan& plan) {
  // A plan that comes while a recovery drives is of the past; the robot asks again later.
  if (mode_ != 0 || !situation_.has_destination) return;
  plan_ = plan.path;
  observer_.on_plan(index_, plan_, plan.safe);
}

template <class Output>
void PlanExecutor<Output>::on(const Situation& situation) {
  // A plan belongs to its destination; a robot that gives control up follows none.
  const bool other_goal = !situation.has_destination || !situation_.has_destination ||
                          norm(situation.destination - situation_.destination) > 0;
  if (other_goal || situation.surrender) drop_plan();
  situation_ = situation;
}

template <class Output>
void PlanExecutor<Output>::drop_plan() {
  plan_.points.clear();
  plan_.index = 0;
  plan_.stamp_us = never_us;
}

template <class Output>
void PlanExecutor<Output>::sense(TimeUs now_us) {
  observation_.now_us = now_us;
  sdk_->sense(observation_);
  observation_.now_us = now_us;
  observation_.claims = claims();
  observation_.urgency = situation_.urgency;
  if (is_finite(velocity_of(observation_))) {
    last_velocity_ = observation_.velocity;
    last_climb_mps_ = observation_.climb_mps;
  }
  has_position_ =
      usable(observation_.position, now_us, parts_.limits.position_age_us, parts_.period_us);
}

// A way-point that is not the last one is passed where the next leg can be followed as declared.
template <class Output>
double PlanExecutor<Output>::passing_m() const {
  const bool last = plan_.index + 1 == plan_.points.size();
  const double tracking_m = parts_.limits.tracking_m;
  return last || tracking_m <= 0 ? options_.reach_m : std::min(options_.reach_m, tracking_m);
}

template <class Output>
void PlanExecutor<Output>::follow_progress() {
  if (!has_position_ || !situation_.has_destination) return;
  const Vec2 p = observation_.position.value;
  bool arrived = false;
  if (mode_ == 0) {
    while (!plan_.finished() && norm(plan_.points[plan_.index] - p) <= passing_m()) {
      ++plan_.index;
    }
    arrived = !plan_.points.empty() && plan_.finished();
  } else {
    // A recovery may happen to pass the destination: that counts.
    arrived = norm(situation_.destination - p) <= options_.reach_m;
  }
  if (!arrived) return;
  drop_plan();
  situation_.has_destination = false;
  robot_->post(PathCompleted{observation_.now_us});
}

// A robot that comes first asks for passage, and this one is on its way: the advanced controller
// gives up control, so that a recovery can make room. The asker may stop asking while it moves on,
// so the way stays free for a while.
template <class Output>
bool PlanExecutor<Output>::in_the_way() {
  const int asker = safe::asks_for_passage(observation_);
  if (asker >= 0 && has_position_ &&
      safe::distance_to_way(observation_.position.value,
                            observation_.others[static_cast<std::size_t>(asker)],
                            observation_.now_us) < 2 * options_.pass_gap_m) {
    aside_until_us_ = observation_.now_us + options_.aside_us;
  }
  const bool aside = observation_.now_us < aside_until_us_;
  // on its way to a place aside: it stays there as long as if it had been asked there
  if (aside && mode_ == surrender_mode() && !active()->holding()) {
    aside_until_us_ = observation_.now_us + options_.aside_us;
  }
  return aside;
}

template <class Output>
void PlanExecutor<Output>::decide() {
  using Clock = std::chrono::steady_clock;
  const SafeController<Output>* recovery = active();
  const bool holding = recovery != nullptr && recovery->holding();
  const auto begin = options_.measure_decisions ? Clock::now() : Clock::time_point{};
  record_ = parts_.decision->step(observation_, holding, situation_.surrender || in_the_way());
  record_.robot = index_;
  if (options_.measure_decisions) {
    record_.decision_ns =
        std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - begin).count();
  }
  const int recoveries = static_cast<int>(parts_.recoveries.size());
  const int mode = std::clamp(record_.mode, 0, recoveries);
  if (mode != 0 &&
      !parts_.recoveries[static_cast<std::size_t>(mode - 1)]->keeps_claim(observation_)) {
    record_.gate = Gate::hold;
    record_.reason = Reason::claim;
  }
  observer_.on_decision(record_);
  switch_to(options_.protect ? mode : 0);
}

template <class Output>
void PlanExecutor<Output>::switch_to(int mode) {
  if (mode == mode_) return;
  const bool leaves_advanced = mode_ == 0;
  const std::optional<Halt> halt = leaves_advanced ? std::nullopt : active()->halt();
  mode_ = mode;
  if (mode_ != 0) engage(*active());
  if (mode_ != 0 && halt) active()->go_on(*halt);
  if (!leaves_advanced) return;
  const bool of_plan = record_.reason == Reason::waypoint || record_.reason == Reason::leg ||
                       record_.reason == Reason::over_capacity;
  const bool waits = record_.reason_other >= 0;
  const bool rejected = of_plan && !waits && !plan_.points.empty();
  drop_plan();
  observation_.plan = plan_;
  robot_->post(PlanLost{observation_.now_us, rejected, waits});
}

// What the advanced controller would send is judged before it is sent, and also while a recovery
// drives: it says whether control can go back.
template <class Output>
void PlanExecutor<Output>::propose() {
  if (!parts_.decision->info().judges_commands) return;
  proposal_ = parts_.advanced->command(observation_);
  observation_.proposed = commanded(proposal_, observation_.now_us);
  observation_.proposed_up_mps2 = commanded_up(proposal_);
}

template <class Output>
void PlanExecutor<Output>::remember(const Output& output) {
  if (parts_.decision->info().judges_commands) {
    observation_.sent = commanded(output, observation_.now_us);
    observation_.sent_up_mps2 = commanded_up(output);
  }
}

// A velocity that arrives broken must not hide the one that came before: without it a point mass
// cannot brake at all, and coasts.
template <class Output>
void PlanExecutor<Output>::engage(SafeController<Output>& recovery) {
  const Sample<Vec2> measured = observation_.velocity;
  const double measured_climb_mps = observation_.climb_mps;
  observation_.velocity = last_velocity_;
  observation_.climb_mps = last_climb_mps_;
  recovery.engage(observation_);
  observation_.velocity = measured;
  observation_.climb_mps = measured_climb_mps;
}

template <class Output>
Output PlanExecutor<Output>::command(bool late) {
  SafeController<Output>* recovery = active();
  if (late) {
    // The decision is of now, but nobody looked for too long: one tick of braking is always safe.
    observer_.on_late(index_, observation_.now_us);
    if (recovery == nullptr) {
      recovery = parts_.recoveries[0];
      engage(*recovery);
    }
    return recovery->command(observation_, Gate::hold);
  }
  if (recovery == nullptr) {
    const bool judged = parts_.decision->info().judges_commands;
    return judged ? proposal_ : parts_.advanced->command(observation_);
  }
  return recovery->command(observation_, record_.gate);
}

// It has something to do: a destination, or a recovery with an errand of its own. A robot without
// either that makes room for others still makes no claim, and a destination waits for an errand.
template <class Output>
bool PlanExecutor<Output>::claims() const {
  const SafeController<Output>* recovery = active();
  if (recovery != nullptr) {
    if (recovery->parked()) return false;
    if (recovery->errand()) return true;
  }
  if (somebody_has_an_errand()) return false;
  return situation_.has_destination || (recovery != nullptr && recovery->blocked());
}

template <class Output>
bool PlanExecutor<Output>::somebody_has_an_errand() const {
  for (int j = 0; j < observation_.robots; ++j) {
    const Announcement& other = observation_.others[static_cast<std::size_t>(j)];
    if (j == index_ || other.position.stamp_us == never_us) continue;
    const double distance_m = norm(other.position.value - observation_.position.value);
    if (other.errand && other.claims && distance_m < options_.near_gaps * options_.pass_gap_m) {
      return true;
    }
  }
  return false;
}

template <class Output>
void PlanExecutor<Output>::announce() {
  const SafeController<Output>* recovery = active();
  Announcement& out = announcement_;
  out.position = observation_.position;
  out.velocity = observation_.velocity;
  out.height_m = observation_.height_m;
  out.climb_mps = observation_.climb_mps;
  out.present = {true, observation_.now_us};
  // Without protection nothing keeps the promise that the record speaks of.
  out.lease_end_us = options_.protect ? record_.lease_end_us : never_us;
  const std::optional<Halt> halt = recovery != nullptr ? recovery->halt() : std::nullopt;
  out.hold = halt && halt->latched ? std::optional(halt->place) : std::nullopt;
  out.claims = claims();
  out.urgency = situation_.urgency;
  out.errand = recovery != nullptr && recovery->errand();
  out.blocked = false;
  // Any other recovery has its own reasons to go anywhere.
  const bool held_for_stack = (mode_ == 0 || mode_ == surrender_mode()) && situation_.blocked;
  if (held_for_stack) {
    out.blocked = true;
    out.plan = situation_.way;
  } else if (recovery == nullptr) {
    out.plan = plan_;
  } else {
    out.blocked = recovery->blocked();
    if (const Path* path = recovery->path(); path != nullptr) {
      out.plan = *path;
    } else {
      out.plan = Path{};
    }
  }
  sdk_->announce(out);
}

// Who comes first keeps its way: the next stretch of it counts as taken.
template <class Output>
void PlanExecutor<Output>::keep_clear_of_way(const Announcement& other, Report& report) const {
  Vec2 from = other.position.value;
  double left_m = options_.way_ahead_m;
  if (!(options_.pass_gap_m > 0)) return;  // nobody keeps a distance
  for (std::size_t i = other.plan.index; i < other.plan.points.size() && left_m > 0; ++i) {
    const Vec2 leg = other.plan.points[i] - from;
    const double leg_m = norm(leg);
    const double step_m = 0.5 * options_.pass_gap_m;
    for (double at_m = 0; at_m < std::min(leg_m, left_m); at_m += step_m) {
      const Vec2 place = from + (at_m / leg_m) * leg;
      const double radius_m = std::min(options_.pass_gap_m, norm(place - report.position) - 0.01);
      if (radius_m > 0 && report.standing.size() + 2 < max_robots) {
        (void)report.standing.push({place, radius_m});
      }
    }
    left_m -= leg_m;
    from = other.plan.points[i];
  }
}

template <class Output>
void PlanExecutor<Output>::report() {
  Report out;
  out.now_us = observation_.now_us;
  out.mode = mode_;
  out.errand = active() != nullptr && active()->errand();
  out.has_position = has_position_;
  out.position = observation_.position.value;
  out.has_plan = !plan_.points.empty();
  out.remaining_m = length_m(observation_.position.value, plan_);
  for (int j = 0; j < observation_.robots; ++j) {
    const Announcement& other = observation_.others[static_cast<std::size_t>(j)];
    if (j == index_ || other.position.stamp_us == never_us) continue;
    const bool stands = safe::is_held(other, observation_.now_us) ||
                        norm(other.velocity.value) < options_.standing_mps;
    if (!has_position_) continue;
    if (!stands) {
      if (!goes_first(observation_, j)) continue;
      keep_clear_of_way(other, out);
      continue;
    }
    const double distance_m = norm(other.position.value - out.position);
    // Who stands far away will have moved on before this robot gets there.
    if (distance_m > options_.near_gaps * options_.pass_gap_m) continue;
    // Standing closer than the gap already, it may still drive away.
    const double radius_m = std::min(options_.pass_gap_m, distance_m - 0.01);
    if (radius_m > 0) (void)out.standing.push({other.position.value, radius_m});
  }
  robot_->post(out);
}

template class PlanExecutor<Twist>;
template class PlanExecutor<Acceleration>;

}  // namespace rtac::stack
