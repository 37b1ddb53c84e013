// A compiled decision that is asked one thing: would it let the advanced controller go on here?
#pragma once

#include <optional>
#include <vector>

#include "kernel.h"

namespace rtac::simulate {

// From any robot, m.
inline constexpr Vec3 far_away{4e4, 4e4, 4e4};

// A robot as it is measured, or as it is.
struct Moving {
  Vec3 position, velocity;  // m, m/s
  double heading_rad = 0, battery = 1;
};

// What robot `self` observes where all of them are measured so, at their oldest, and propose that.
// The position is never older than the velocity: what has happened to a robot between the two is
// then bounded by its acceleration alone.
Observation observed(const DecisionCase& decision, int self, const std::vector<Moving>& robots,
                     TimeUs now_us, Vec3 proposed);

// Steps a decision about robots that have stood so for as long as its properties look back, up to
// the tick before `begin_us`.
void remember(KernelDecision& kernel, const DecisionCase& decision, int self,
              const std::vector<Moving>& standing, TimeUs begin_us);

class Oracle {
 public:
  // Of the robot `self`. All of it outlives the oracle. `begins_us`: what its clock
  // shows; nothing: any time.
  Oracle(const DecisionCase& decision, const Kernel::Functions& kernel, int self,
         std::optional<TimeUs> begins_us = std::nullopt);
  Oracle(const Oracle&) = delete;
  Oracle& operator=(const Oracle&) = delete;

  // From where it asks from now on: a state of all robots in which control is with the advanced
  // controller after a while. False: it never is, and the one before stays.
  bool settle(const std::vector<Moving>& robots);
  // What a monitor says is found true of robots that have just been started.
  bool holds(const std::vector<Moving>& robots, std::size_t monitor);
  // Where agents are seen from now on, by agent; at first all of them are far away.
  void place_agents(const std::vector<Vec3>& places) { agents_ = places; }
  // What is proposed to be sent from now on, m/s^2; until then it was nothing.
  void propose(Vec3 acceleration) { proposed_ = acceleration; }
  // The look-ahead of a monitor passes in the tick after, with samples as old as they may be.
  bool passes(const std::vector<Moving>& robots, std::size_t monitor);

  // Ages of the samples that it is asked with.
  [[nodiscard]] TimeUs position_age_us() const;
  [[nodiscard]] TimeUs velocity_age_us() const;

 private:
  void start(const std::vector<Moving>& robots);
  const DecisionRecord& step(const std::vector<Moving>& robots, Vec3 proposed);
  int ticks_until_advanced(const std::vector<Moving>& robots);

  const DecisionCase& decision_;
  int self_;
  std::vector<Vec3> agents_;
  Vec3 proposed_;
  KernelDecision kernel_;
  std::vector<Moving> settled_;
  int ticks_ = 0;
  TimeUs now_us_ = 0;
};

}  // namespace rtac::simulate
