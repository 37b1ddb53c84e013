// What an application plugs in, and what the templates implement.
#pragma once

#include <optional>

#include "rtac/decision.h"
#include "rtac/types.h"

namespace rtac {

// An advanced controller: nobody has verified it, so it may do anything but block: it is called on
// the thread of the ticks, after the decision, or before it where the decision judges commands
// (`ahead command`; then also while a recovery drives), and its time is part of the declared
// latency. The output takes effect as it is; what is not finite or beyond the limits is for the SDK
// to refuse.
template <class Output>
class Controller {
 public:
  virtual ~Controller() = default;
  virtual Output command(const Observation& observation) = 0;
};

struct Leg {  // straight, map frame, metres
  Vec2 from, to;
};
// How a robot has come to rest, or is about to: handed on by one recovery to the next.
struct Halt {
  bool latched = false;    // it holds its place; else it still brakes, or drives
  Vec3 place;              // that it holds
  std::optional<Leg> leg;  // that it drives, or was stopped on: from there it moves on
  double leg_mps = 0;      // the speed that leg is driven with: how far beside it a stop may end
  TimeUs since_us = never_us;  // measurements of later show the halt; never_us: it has not begun
  TimeUs seen_us = never_us;   // the newest one of these
};

// A safe controller: never blocks, is asked every tick while it drives.
template <class Output>
class SafeController {
 public:
  virtual ~SafeController() = default;
  // Called on the tick of the hand-over, before the first command. A velocity that is not a number
  // is replaced by the last one that was, with its stamp: what a blind brake has to go by.
  virtual void engage(const Observation& observation) = 0;
  // Called after it where another recovery has driven until now and tells how it halts. Who takes
  // over goes on with it: a place that is latched anew at every hand-over would wander off with the
  // errors of the measurements.
  virtual void go_on(const Halt&) {}
  // How it halts, or drives, now: for the `go_on` of the recovery that takes over. Nothing: it has
  // nothing to hand on, and the next one brakes and latches for itself.
  [[nodiscard]] virtual std::optional<Halt> halt() const { return std::nullopt; }
  // `gate` is binding: `hold` means brake and hold, `away_only` allows motion only along which no
  // distance to a HELD robot shrinks.
  virtual Output command(const Observation& observation, Gate gate) = 0;
  // False: it is not, or not known to be, where it claims to stay, and brakes whatever the gate.
  [[nodiscard]] virtual bool keeps_claim(const Observation&) const { return true; }
  // Latched in its position hold: at rest, where a position shows it that was measured since, and
  // meaning to stay. False as soon as it wants to move, so that the decision module stops renewing
  // the HELD lease.
  [[nodiscard]] virtual bool holding() const = 0;
  // It found no way because of robots that stand, and asks them for passage.
  [[nodiscard]] virtual bool blocked() const { return false; }
  // It has reached what it wanted and makes no claim on the way (charging at the dock).
  [[nodiscard]] virtual bool parked() const { return false; }
  // It only ever stands where it has come to rest.
  [[nodiscard]] virtual bool stands() const { return false; }
  // The robot is seen outside of where it moves, and is led in.
  [[nodiscard]] virtual bool leads_in(const Observation&) const { return false; }
  // It goes to a place of its own (a dock): the pending destination waits without being stalled.
  [[nodiscard]] virtual bool errand() const { return false; }
  // The way it follows or would follow; empty when it has none. For announcements.
  [[nodiscard]] virtual const Path* path() const { return nullptr; }
};

struct Disc {  // map frame
  Vec2 centre;
  double radius_m = 0;
};
struct PlanRequest {
  int robot = 0;                          // index in its fleet
  Vec2 start, goal;                       // map frame, metres; the start is measured
  FixedList<Disc, max_robots> obstacles;  // robots that stand
};
// Called on the thread of the ticks, between two of them: nobody decides while it works. On a robot
// its effort has to be bounded so that it ends before the next tick is due; it may allocate.
class Planner {
 public:
  virtual ~Planner() = default;
  // false: no plan found within the planner's bounded effort; `plan` is then unspecified.
  virtual bool plan(const PlanRequest& request, Path& plan) = 0;
};

// The application layer: which place a robot visits next.
class TaskSource {
 public:
  virtual ~TaskSource() = default;
  // false: no more tasks, ever. The robot stands from now on and is not asked about again.
  virtual bool next(int robot, Vec2& destination) = 0;
  virtual void completed(int robot, Vec2 destination, TimeUs now_us) = 0;
  virtual void skipped(int robot, Vec2 destination, TimeUs now_us) = 0;
};

// What the runtime needs of one robot's SDK. The simulator is one; a ROS node is another.
template <class Output>
class RobotSdk {
 public:
  virtual ~RobotSdk() = default;
  // Newest samples and announcements received until now. Leaves plan, self, robots alone.
  virtual void sense(Observation& observation) = 0;
  // Called once a period; the command holds until the next one. No safety property covers a runtime
  // that is late or gone: when no command comes for a period, stop the robot.
  virtual void actuate(const Output& output) = 0;
  // To all other robots of the fleet, who receive it through their `sense`.
  virtual void announce(const Announcement& announcement) = 0;
};
template <class Output>
class FleetSdk {
 public:
  virtual ~FleetSdk() = default;
  virtual RobotSdk<Output>& robot(int index) = 0;
  // The clock of all stamps and leases, in us; it never goes backwards.
  [[nodiscard]] virtual TimeUs now_us() const = 0;
  // Returns when the clock reads at least `time_us` (a simulator advances it), false to stop.
  virtual bool wait_until(TimeUs time_us) = 0;
};

}  // namespace rtac
