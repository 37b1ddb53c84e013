#include "sensor.h"

#include <algorithm>
#include <limits>

namespace rtac::sim {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Vec3 noise_of(const Vec3& /*kind*/, double error, NoiseModel model, ValueRange range,
              Random& random) {
  if (model == NoiseModel::none || !(error > 0)) return {};
  const bool uniform = model == NoiseModel::uniform;
  if (range != ValueRange::level) return uniform ? random.in_ball(error) : random.on_sphere(error);
  const Vec2 off = uniform ? random.in_disc(error) : random.on_circle(error);
  return {off.x, off.y, 0};
}

double noise_of(double /*kind*/, double error, NoiseModel model, ValueRange /*range*/,
                Random& random) {
  if (model == NoiseModel::none || !(error > 0)) return 0;
  return model == NoiseModel::uniform ? random.uniform(-error, error) : error * random.sign();
}

Vec2 offset_of(const Vec2& /*kind*/, double jump, Random& random) {
  return random.on_circle(jump);
}
Vec3 offset_of(const Vec3& /*kind*/, double jump, Random& random) {
  const Vec2 level = random.on_circle(jump);
  return {level.x, level.y, 0};
}
double offset_of(double /*kind*/, double jump, Random& /*random*/) {
  return jump;
}

void set_nan(Vec2& value) {
  value = {not_a_number, not_a_number};
}
void set_nan(Vec3& value) {
  value = {not_a_number, not_a_number, not_a_number};
}
void set_nan(double& value) {
  value = not_a_number;
}

Vec3 ranged(const Vec3& value, ValueRange /*range*/) {
  return value;
}
double ranged(double value, ValueRange range) {
  if (!std::isfinite(value)) return value;  // a fault that must stay visible
  if (range == ValueRange::angle) return wrap_angle(value);
  return range == ValueRange::ratio ? clamp(value, 0, 1) : value;
}

bool covers(const Fault& fault, TimeUs stamp_us) {
  return fault.from_us <= stamp_us && stamp_us < fault.until_us;
}

}  // namespace

template <class T>
void FaultList<T>::add(const Fault& fault, Random& random) {
  Entry entry{fault, T{}};
  if (fault.kind == FaultKind::jump) entry.offset = offset_of(T{}, fault.jump, random);
  entries_.push_back(entry);
}

template <class T>
bool FaultList<T>::drops(TimeUs stamp_us) const {
  return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.fault.kind == FaultKind::drop && covers(entry.fault, stamp_us);
  });
}

template <class T>
bool FaultList<T>::active(TimeUs stamp_us) const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [&](const Entry& entry) { return covers(entry.fault, stamp_us); });
}

template <class T>
T FaultList<T>::applied(T value, const T& before, TimeUs stamp_us, bool jumps) const {
  for (const Entry& entry : entries_) {
    if (!covers(entry.fault, stamp_us)) continue;
    switch (entry.fault.kind) {
      case FaultKind::drop:
        break;
      case FaultKind::nan:
        set_nan(value);
        break;
      case FaultKind::freeze:
        value = before;
        break;
      case FaultKind::jump:
        if (jumps) value = value + entry.offset;
        break;
    }
  }
  return value;
}

template <class T>
Sensor<T>::Sensor(TimeUs max_age_us, double error, NoiseModel noise, ValueRange range,
                  Random random, const T& truth)
    : period_us_(max_age_us / 2),
      delay_us_(delivery_delay_us(max_age_us)),
      error_(error),
      noise_(noise),
      range_(range),
      random_(random) {
  // The offset is at most one period, so that the first fix is replaced before it is too old.
  if (period_us_ > 0) next_us_ = 1 + random_.below(period_us_);
  store(0, truth);
  arrived_ = under_way_;
}

template <class T>
T Sensor<T>::measure(const T& truth, Random& random) const {
  return ranged(truth + noise_of(T{}, error_, noise_, range_, random), range_);
}

template <class T>
void Sensor<T>::store(TimeUs now_us, const T& truth) {
  T value = measure(truth, random_);
  if (faults_.drops(now_us)) return;
  if (faults_.active(now_us)) {
    value = ranged(faults_.applied(value, before_fault_, now_us), range_);
  } else {
    before_fault_ = value;
  }
  arrived_ = under_way_;
  under_way_ = {value, now_us};
}

template <class T>
void Sensor<T>::take(TimeUs now_us, const T& truth) {
  store(now_us, truth);
  next_us_ = now_us + period_us_;
}

template <class T>
const Sample<T>& Sensor<T>::read(TimeUs now_us, const T& truth) {
  if (period_us_ <= 0) {
    store(now_us, truth);
    return under_way_;
  }
  return under_way_.stamp_us + delay_us_ <= now_us ? under_way_ : arrived_;
}

template class FaultList<Vec2>;
template class FaultList<Vec3>;
template class FaultList<double>;
template class Sensor<Vec3>;
template class Sensor<double>;

}  // namespace rtac::sim
