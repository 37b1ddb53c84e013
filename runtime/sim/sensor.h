// Private: one sense of one robot, with its own clock, noise and faults.
#pragma once

#include <vector>

#include "rtac/sim/random.h"
#include "rtac/sim/world.h"

namespace rtac::sim {

// Delay of a sample or message whose age at use may come up to `max_age_us`, when one is taken
// every max_age/2: with 1 ms of reserve for the reader.
inline TimeUs delivery_delay_us(TimeUs max_age_us) {
  const TimeUs delay = max_age_us / 2 - 1000;
  return delay > 0 ? delay : 0;
}

// The faults of one sense.
template <class T>
class FaultList {
 public:
  void add(const Fault& fault, Random& random);
  [[nodiscard]] bool drops(TimeUs stamp_us) const;
  // The value as the faults make it; `before` is the last one that no fault touched.
  // `jumps`: whether jumps apply (a jump of a position leaves the velocity beside it alone).
  [[nodiscard]] T applied(T value, const T& before, TimeUs stamp_us, bool jumps = true) const;
  [[nodiscard]] bool active(TimeUs stamp_us) const;

 private:
  struct Entry {
    Fault fault;
    T offset{};
  };
  std::vector<Entry> entries_;
};

enum class ValueRange {
  open,   // any value
  level,  // of a place or a velocity: its height is 0, and the noise has none
  angle,  // wrapped to (-pi, pi]
  ratio   // clamped to [0, 1]: nearer to the truth, so still within the error
};

template <class T>
class Sensor {
 public:
  // Takes the first fix at time 0.
  Sensor(TimeUs max_age_us, double error, NoiseModel noise, ValueRange range, Random random,
         const T& truth);

  // INT64_MAX: measured on reading only.
  [[nodiscard]] TimeUs next_us() const { return next_us_; }
  void take(TimeUs now_us, const T& truth);
  // The newest sample that has arrived.
  const Sample<T>& read(TimeUs now_us, const T& truth);
  // A measurement outside the sense's own rhythm, untouched by its faults.
  [[nodiscard]] T measure(const T& truth, Random& random) const;
  void inject(const Fault& fault) { faults_.add(fault, random_); }

 private:
  void store(TimeUs now_us, const T& truth);

  TimeUs period_us_;
  TimeUs delay_us_;
  TimeUs next_us_ = INT64_MAX;
  double error_;
  NoiseModel noise_;
  ValueRange range_;
  Random random_;
  FaultList<T> faults_;
  Sample<T> arrived_, under_way_;  // the delay is shorter than the period: never two under way
  T before_fault_{};
};

extern template class FaultList<Vec2>;
extern template class FaultList<Vec3>;
extern template class FaultList<double>;
extern template class Sensor<Vec3>;
extern template class Sensor<double>;

}  // namespace rtac::sim
