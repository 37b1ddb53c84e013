// Private: what one robot measures, chosen by an attack within the declared errors and ages.
#pragma once

#include <array>

#include "rtac/sim/hostile.h"
#include "rtac/sim/random.h"
#include "truth_log.h"

namespace rtac::sim {

class HostileSenses {
 public:
  HostileSenses(const Arena& arena, const Hostility& hostility, int robot);

  // All that is sensed now.
  void measure(TimeUs now_us, const TruthLog& log, Observation& observation);
  // Position and velocity for an announcement that is sent now.
  void announce(TimeUs now_us, const TruthLog& log, Announcement& announcement);
  // Nothing arrives from other robots now.
  [[nodiscard]] bool deaf(TimeUs now_us) const {
    return faulty(Sense::announcements, now_us) ||
           (hostility_.deaf_from_us != never_us && now_us >= hostility_.deaf_from_us);
  }

 private:
  struct Fault {
    Sense sense = Sense::position;
    bool broken = false;  // else lost
    TimeUs from_us = never_us, until_us = never_us;
  };
  [[nodiscard]] TimeUs age(Sense sense, TimeUs max_age_us);
  [[nodiscard]] TimeUs told_age(TimeUs max_age_us) const;
  [[nodiscard]] bool faulty(Sense sense, TimeUs now_us) const {
    return fault_.sense == sense && fault_.from_us <= now_us && now_us < fault_.until_us;
  }
  void plan_faults(TimeUs now_us);
  // Moves on to the sample of that age; null: there is no newer one.
  template <class T>
  const TruthState* take(Sense sense, TimeUs now_us, TimeUs max_age_us, const TruthLog& log,
                         Sample<T>& sample);
  // For the whole run: where the errors of position and velocity point to, and the sign of others.
  struct Lasting {
    Vec3 position, velocity;
    double sign = 1;
  };
  [[nodiscard]] Lasting draw_lasting() const;
  [[nodiscard]] Vec3 offset(double error, Vec3 lasting);
  [[nodiscard]] double offset(double error);
  void aim(TimeUs now_us);

  const Arena& arena_;
  Hostility hostility_;
  int robot_;
  Random random_;
  bool old_position_;  // which sense is the old one, where they differ
  double turn_rad_;    // by which aimed noise misses its direction
  Lasting lasting_;
  Vec3 away_{1, 0, 0};  // from the threat
  TimeUs aimed_us_ = never_us;
  Fault fault_;
  Sample<Vec3> position_, velocity_;
  Sample<double> heading_, battery_;
  TimeUs announced_position_us_ = never_us, announced_velocity_us_ = never_us;
};

}  // namespace rtac::sim
