// Values that cross the interfaces of the runtime. SI units, map frame, angles in radians.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace rtac {

using TimeUs = std::int64_t;                   // microseconds of the robot's clock
inline constexpr TimeUs never_us = INT64_MIN;  // stamp of something that was never received

struct Vec2 {
  double x = 0, y = 0;
};
inline Vec2 operator+(Vec2 a, Vec2 b) {
  return {a.x + b.x, a.y + b.y};
}
inline Vec2 operator-(Vec2 a, Vec2 b) {
  return {a.x - b.x, a.y - b.y};
}
inline Vec2 operator*(double k, Vec2 a) {
  return {k * a.x, k * a.y};
}
inline double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
// Not std::hypot, whose last bit depends on the processor: what a run did is replayed elsewhere.
inline double norm(Vec2 a) {
  return std::sqrt(dot(a, a));
}

struct Vec3 {
  double x = 0, y = 0, z = 0;
};
inline Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(double k, Vec3 a) {
  return {k * a.x, k * a.y, k * a.z};
}
inline double norm(Vec3 a) {
  return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);  // of the plane to the last bit where z is 0
}

// Outputs of a controller.
struct Twist {  // body frame
  double speed_mps = 0;
  double turn_radps = 0;
};
struct Acceleration {  // map frame, m/s^2
  Vec2 value_mps2;
  double up_mps2 = 0;  // of robots in space
};

// A value with the time it was true at. `stamp_us == never_us`: none yet.
template <class T>
struct Sample {
  T value{};
  TimeUs stamp_us = never_us;
};

// A list with a fixed capacity: the runtime allocates nothing after start.
template <class T, std::size_t Capacity>
class FixedList {
 public:
  static constexpr std::size_t capacity = Capacity;
  [[nodiscard]] bool push(const T& value) {  // false: full, nothing stored
    if (size_ == Capacity) return false;
    items_[size_++] = value;
    return true;
  }
  void clear() { size_ = 0; }
  void resize_down(std::size_t size) { size_ = size < size_ ? size : size_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return items_[i]; }
  const T& operator[](std::size_t i) const { return items_[i]; }
  T* begin() { return items_.data(); }
  T* end() { return items_.data() + size_; }
  const T* begin() const { return items_.data(); }
  const T* end() const { return items_.data() + size_; }
  const T& back() const { return items_[size_ - 1]; }

 private:
  std::array<T, Capacity> items_{};
  std::size_t size_ = 0;
};

inline constexpr std::size_t max_waypoints = 64;
inline constexpr std::size_t max_robots = 256;
inline constexpr std::size_t max_monitors = 16;

// Way-points and the next one to reach. Swapped whole, never edited in place by its reader.
struct Path {
  FixedList<Vec2, max_waypoints> points;
  std::size_t index = 0;  // next target; == size: nothing left
  TimeUs stamp_us = never_us;
  [[nodiscard]] bool finished() const { return index >= points.size(); }
};

// Length of the way that is left, from `from` on (m).
inline double length_m(Vec2 from, const Path& path) {
  double sum_m = 0;
  for (std::size_t i = path.index; i < path.points.size(); ++i) {
    sum_m += norm(path.points[i] - from);
    from = path.points[i];
  }
  return sum_m;
}

// What a robot tells the others (`hears other robots`).
struct Announcement {
  Sample<Vec2> position, velocity;  // its own measurements, with its own stamps
  Sample<bool> present;  // is it there at all (open fleets)? Absence is said, not inferred
  TimeUs lease_end_us = never_us;  // HELD: promises not to leave its hold before this time
  bool claims = false;             // it waits to go on (a parked robot does not)
  int urgency = 0;                 // grows while it waits, until it has delivered
  bool errand = false;   // a recovery has somewhere to go (to charge): others nearby claim nothing
  bool blocked = false;  // it found no way around the others and asks for passage
  Path plan;             // what it follows, or would follow if the way were free
  double height_m = 0, climb_mps = 0;  // as those of an observation
  // The place that it holds, as its recovery has it (Halt). Errors and pushes that last put it
  // beside that, and what it measures with it.
  std::optional<Vec3> hold;
};

inline Vec3 position_of(const Announcement& heard) {
  return {heard.position.value.x, heard.position.value.y, heard.height_m};
}

// What each robot of a fleet has said, by fleet index (below max_robots). It holds those that were
// written to or reserved, and takes no room for others: of these nothing was heard. References stay
// valid when it grows. Only growing allocates.
class Announcements {
 public:
  void reserve(std::size_t robots) {
    if (robots > heard_.size()) heard_.resize(robots);
  }
  [[nodiscard]] std::size_t size() const { return heard_.size(); }
  Announcement& operator[](std::size_t robot) {
    reserve(robot + 1);
    return heard_[robot];
  }
  const Announcement& operator[](std::size_t robot) const {
    return robot < heard_.size() ? heard_[robot] : nothing;
  }

 private:
  static const Announcement nothing;
  std::deque<Announcement> heard_;
};
inline const Announcement Announcements::nothing{};

// What a controller and a decision module see of one robot: measurements, never the true state.
struct Observation {
  TimeUs now_us = 0;
  int self = 0;  // index in its fleet
  Sample<Vec2> position, velocity;
  Sample<double> heading;  // rad, counter-clockwise from +x
  Sample<double> battery;  // 1 = full
  Path plan;
  // By fleet index; the own entry stays empty. A robot never heard of has stamp never_us.
  Announcements others;
  int robots = 1;
  // The place of this robot in the order of the way, as others hear it (see goes_first).
  bool claims = true;
  int urgency = 0;
  // Of a decision that judges commands (`ahead command`): the acceleration that was sent after the
  // last step, and the one that the advanced controller proposes to be sent after this one, in
  // m/s^2. Both belong to the step; a stamp of never_us says that there is none.
  Sample<Vec2> sent{}, proposed{};
  // Of robots in space: the third components of position and velocity, of the same samples, and of
  // those commands.
  double height_m = 0, climb_mps = 0;
  double sent_up_mps2 = 0, proposed_up_mps2 = 0;
};

inline Vec3 position_of(const Observation& seen) {
  return {seen.position.value.x, seen.position.value.y, seen.height_m};
}
inline Vec3 velocity_of(const Observation& seen) {
  return {seen.velocity.value.x, seen.velocity.value.y, seen.climb_mps};
}

// The order of the way: who waits to go on comes before who does not, then who has waited longer,
// then the smaller index. Manners only: who is wrong about it waits too long, or meets the
// separation test.
inline bool goes_first(const Observation& seen, int other) {
  const Announcement& heard = seen.others[static_cast<std::size_t>(other)];
  if (heard.claims != seen.claims) return heard.claims;
  if (heard.urgency != seen.urgency) return heard.urgency > seen.urgency;
  return other < seen.self;
}

// Limits of a kind of robot, as declared in its specification. Generated modules export them; the
// simulator and the safe controllers take them from there, so that nobody states them twice.
struct RobotLimits {
  double radius_m = 0;
  bool unicycle = false;
  double speed_mps = 0, accel_mps2 = 0, brake_mps2 = 0;
  double turn_radps = 0, turn_accel_radps2 = 0;  // 0: not a unicycle / unbounded
  double position_error_m = 0, velocity_error_mps = 0, heading_error_rad = 0, battery_error = 0;
  TimeUs position_age_us = 0, velocity_age_us = 0, heading_age_us = 0, battery_age_us = 0;
  TimeUs hears_age_us = 0;
  TimeUs latency_us = 0;
  double tracking_m = 0;
  double drive_per_m = 0, idle_per_s = 0, drain_per_s = 0, charge_per_s = 0;  // of a full battery
  double disturbance_mps2 = 0;  // pushes the robot, whoever drives; errors of the output count in
  bool in_space = false;        // it moves up and down, too: all of these are of space
};

}  // namespace rtac
