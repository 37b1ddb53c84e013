// Quantities with their unit in the type, for the typed inputs of generated modules: what is not
// a length cannot be passed as one. SI inside.
#pragma once

namespace rtac {

template <class Tag>
class Quantity {
 public:
  constexpr explicit Quantity(double si) : si_(si) {}
  [[nodiscard]] constexpr double si() const { return si_; }
  constexpr Quantity operator-() const { return Quantity(-si_); }

 private:
  double si_;
};
using Length = Quantity<struct LengthTag>;      // m
using Speed = Quantity<struct SpeedTag>;        // m/s
using Angle = Quantity<struct AngleTag>;        // rad
using TurnRate = Quantity<struct TurnRateTag>;  // rad/s
using Charge = Quantity<struct ChargeTag>;      // ratio of a full battery

struct Position {  // map frame
  Length x, y;
};
struct Velocity {  // map frame
  Speed x, y;
};
struct Position3 {  // map frame, z up
  Length x, y, z;
};
struct Velocity3 {  // map frame, z up
  Speed x, y, z;
};
struct Pose {  // of one frame in another
  Length x, y;
  Angle heading;  // from the x axis, counter-clockwise
};
struct BodyVelocity {  // of a vehicle along and around itself
  Speed linear;
  TurnRate angular;
};

namespace literals {
constexpr Length operator""_m(long double v) {
  return Length(static_cast<double>(v));
}
constexpr Length operator""_m(unsigned long long v) {
  return Length(static_cast<double>(v));
}
constexpr Speed operator""_mps(long double v) {
  return Speed(static_cast<double>(v));
}
constexpr Speed operator""_mps(unsigned long long v) {
  return Speed(static_cast<double>(v));
}
constexpr Angle operator""_rad(long double v) {
  return Angle(static_cast<double>(v));
}
constexpr Charge operator""_pct(long double v) {
  return Charge(static_cast<double>(v) / 100);
}
constexpr Charge operator""_pct(unsigned long long v) {
  return Charge(static_cast<double>(v) / 100);
}
}  // namespace literals

}  // namespace rtac
