// One robot of a fleet, as a process of its own runs it (a ROS node for each robot): its decision,
// its recoveries, where the other robot and a person are, and what it says about itself. The cart
// drives along the hall towards the person.
#include <cstdio>
#include <optional>

#include "one_robot_system.h"
#include "rtac/decision_text.h"
#include "rtac/sample.h"

namespace {

class Node {
 public:
  explicit Node(int self) : cart_(self) {
    seen_.self = self;
    seen_.robots = one_robot::System::robots;
  }

  // What was measured, each with its time; what arrives from others, by their number.
  void sense(rtac::Vec2 position_m, rtac::Vec2 velocity_mps, rtac::TimeUs stamp_us) {
    seen_.position = {position_m, stamp_us};
    seen_.velocity = {velocity_mps, stamp_us};
    if (rtac::is_finite(velocity_mps)) last_velocity_ = seen_.velocity;
  }
  void hear(int robot, const rtac::Announcement& said) {
    seen_.others[static_cast<std::size_t>(robot)] = said;
  }
  void see_person(rtac::Position at, rtac::TimeUs stamp_us) {
    cart_.guard.person_position(at, stamp_us);
  }

  // Once a period, by a timer: what to send to the motors.
  rtac::Acceleration step(rtac::TimeUs now_us, rtac::Acceleration proposed) {
    seen_.now_us = now_us;
    const bool holding = mode_ != 0 && cart_.recovery(mode_).holding();
    record_ = cart_.guard.step(seen_, holding, false);
    if (record_.mode != mode_) hand_over(record_.mode);
    return mode_ == 0 ? proposed : cart_.recovery(mode_).command(seen_, record_.gate);
  }
  const rtac::DecisionRecord& record() const { return record_; }

  // After each step, for the other robots.
  rtac::Announcement announcement() {
    rtac::Announcement said;
    said.position = seen_.position;
    said.velocity = seen_.velocity;
    said.lease_end_us = record_.lease_end_us;
    said.claims = true;  // it has somewhere to go
    if (mode_ == 0) return said;
    if (const auto halt = cart_.recovery(mode_).halt(); halt && halt->latched) {
      said.hold = halt->place;
    }
    said.blocked = cart_.recovery(mode_).blocked();
    if (const rtac::Path* way = cart_.recovery(mode_).path()) said.plan = *way;
    return said;
  }

 private:
  // A recovery goes on where another one has driven until now. A velocity that is no number would
  // hide the last one that was, which a blind brake has to go by.
  void hand_over(int mode) {
    const std::optional<rtac::Halt> halt = mode_ == 0 ? std::nullopt : cart_.recovery(mode_).halt();
    mode_ = mode;
    if (mode_ == 0) return;
    const rtac::Sample<rtac::Vec2> measured = seen_.velocity;
    seen_.velocity = last_velocity_;
    cart_.recovery(mode_).engage(seen_);
    seen_.velocity = measured;
    if (halt) cart_.recovery(mode_).go_on(*halt);
  }

  one_robot::System::Robot cart_;
  rtac::Observation seen_;
  rtac::Sample<rtac::Vec2> last_velocity_;
  rtac::DecisionRecord record_;
  int mode_ = 0;
};

}  // namespace

int main() {
  using namespace rtac::literals;
  const int self = one_robot::System::robot_number("right");
  const int other = one_robot::System::robot_number("left");
  if (self < 0 || other < 0) return 1;
  Node node(self);

  // The true cart: it drives at 0.5 m/s, and follows what it is told.
  rtac::Vec2 at{5, 5}, v{0.5, 0};
  int mode = 0;
  for (rtac::TimeUs now_us = 0; now_us < 20'000'000; now_us += 100'000) {
    rtac::Announcement left;
    left.position = {{2, 5}, now_us};
    left.velocity = {{0, 0}, now_us};
    node.sense(at, v, now_us);
    node.hear(other, left);
    node.see_person({15_m, 5_m}, now_us);
    const rtac::Acceleration told = node.step(now_us, {});
    if (node.record().mode != mode) {
      char reason[100];
      mode = node.record().mode;
      rtac::reason_text(node.record(), reason, sizeof reason);
      std::printf("%.1f s, x = %.2f m: %s drives, %s\n", static_cast<double>(now_us) / 1e6, at.x,
                  rtac::mode_name(node.record()), reason);
    }
    at = at + 0.1 * v + 0.005 * told.value_mps2;
    v = v + 0.1 * told.value_mps2;
  }
  const bool promises = node.announcement().lease_end_us > 20'000'000;
  std::printf("at rest at x = %.1f m, %s\n", at.x, promises ? "and says that it stays" : "moving");
  return 0;
}
