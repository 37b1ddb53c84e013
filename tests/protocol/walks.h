// Generated kernels under inputs that nobody would send: what they find, and who drives.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace rtac::protocol::test {

struct Found {
  bool violated, clear, safer, gives_back, engaged;
};
// A step: what the kernel was given and has found, and what it has decided.
struct Row {
  const char* step;  // of the model: on_time, again, missed
  bool surrender, holding, promised;
  std::vector<Found> found;
  int mode, reason;
  bool promised_after;
};

struct Scene {
  std::int64_t x_mm = 0, y_mm = 0, vx_mmps = 0, vy_mmps = 0, charge_ppm = 950'000;
  std::int64_t other_x_mm = 0, other_y_mm = 0;
  bool seen = true, other_seen = true;
  int plan = 0;  // way-points
};

// Where a robot may be given back to its advanced controller, where the others are then, and how
// far everything reaches.
struct Place {
  std::int64_t x_mm, y_mm, other_x_mm, other_y_mm, extent_mm;
};

class Walker {
 public:
  Walker(Place place, unsigned seed) : place_(place), random_(seed) {}
  std::int64_t in(std::int64_t lo, std::int64_t hi) {
    return std::uniform_int_distribution<std::int64_t>(lo, hi)(random_);
  }
  bool one_in(int n) { return in(1, n) == 1; }

  // A scene lasts for some ticks, so that return conditions may hold for their time.
  const Scene& next() {
    if (left_-- > 0) return scene_;
    left_ = static_cast<int>(one_in(2) ? in(0, 3) : in(4, 16));
    scene_ = {};
    scene_.x_mm = place_.x_mm;
    scene_.y_mm = place_.y_mm;
    scene_.other_x_mm = place_.other_x_mm;
    scene_.other_y_mm = place_.other_y_mm;
    if (one_in(3)) return scene_;
    if (one_in(2)) scene_.x_mm = in(-200, place_.extent_mm + 200);
    if (one_in(2)) scene_.y_mm = in(-200, place_.extent_mm + 200);
    if (one_in(3)) scene_.vx_mmps = in(-220, 220);
    if (one_in(3)) scene_.vy_mmps = in(-220, 220);
    if (one_in(3)) scene_.charge_ppm = in(10'000, 999'000);
    if (one_in(3)) {
      scene_.other_x_mm = scene_.x_mm + in(-700, 700);
      scene_.other_y_mm = scene_.y_mm + in(-700, 700);
    }
    scene_.seen = !one_in(10);
    scene_.other_seen = !one_in(10);
    if (one_in(4)) scene_.plan = static_cast<int>(in(1, 3));
    return scene_;
  }

 private:
  Place place_;
  std::mt19937 random_;
  Scene scene_;
  int left_ = 0;
};

template <class Point>
void set(Point& p, std::int64_t x, std::int64_t y, std::int64_t stamp_us, bool valid) {
  p.x_lo = p.x_hi = x;
  p.y_lo = p.y_hi = y;
  p.stamp_us = stamp_us;
  p.valid = valid;
}

template <class In>
void observe(In& in, const Scene& s, Walker& walker, std::int64_t now_us) {
  in = {};
  set(in.position, s.x_mm, s.y_mm, now_us, s.seen);
  set(in.velocity, s.vx_mmps, s.vy_mmps, now_us, s.seen);
  in.battery.lo = in.battery.hi = s.charge_ppm;
  in.battery.stamp_us = now_us;
  in.battery.valid = 1;
  if constexpr (requires { in.heading.lo; }) {
    in.heading.stamp_us = now_us;
    in.heading.valid = s.seen;
  }
  in.plan.valid = 1;
  in.plan.count = s.plan;
  for (int i = 0; i < s.plan; ++i) {
    in.plan.x[i] = walker.in(0, 5'000);
    in.plan.y[i] = walker.in(0, 5'000);
  }
  for (auto& other : in.others) {
    set(other.position, s.other_x_mm, s.other_y_mm, now_us, s.other_seen);
    set(other.velocity, 0, 0, now_us, s.other_seen);
    other.lease_end_us = INT64_MIN;
    other.plan.valid = 1;
  }
}

template <class Result>
Found found_of(const Result& r) {
  constexpr int is_false = 0, is_true = 2;
  Found f{};
  f.violated = r.now == is_false;
  f.clear = r.ahead == is_true;
  f.safer = r.safer == is_true;
  f.gives_back = true;
  if constexpr (requires { r.returns; }) f.gives_back = r.returns == is_true;
  f.engaged = r.engaged != 0;
  return f;
}

// `ticks` steps of a kernel: most of them in time, some again, late, or of a clock turned back.
template <class State, class In, class Out>
std::vector<Row> walk(void (*init)(State*), void (*step)(State*, const In*, std::int64_t, Out*),
                      std::int64_t period_us, Place place, int ticks, unsigned seed) {
  Walker walker(place, seed);
  State state{};
  Out out{};
  In in{};
  init(&state);
  std::int64_t time_us = 10'000'000, lease_end_us = INT64_MIN;
  std::vector<Row> rows;
  for (int t = 0; t < ticks; ++t) {
    Row row{};
    row.step = "on_time";
    std::int64_t now_us = time_us += period_us;
    if (t > 0 && walker.one_in(25)) {
      row.step = "again";
      now_us = time_us -= period_us;
    } else if (t > 0 && walker.one_in(40)) {
      row.step = "missed";
      now_us = time_us += 2 * period_us;
    } else if (t > 0 && walker.one_in(40)) {
      row.step = "missed";
      time_us -= period_us;
      now_us = time_us - 1;
    }
    observe(in, walker.next(), walker, now_us);
    in.holding = row.holding = walker.one_in(3);
    in.surrender = row.surrender = walker.one_in(12);
    row.promised = now_us < lease_end_us;
    step(&state, &in, now_us, &out);
    lease_end_us = out.lease_end_us;
    for (const auto& result : out.monitors) row.found.push_back(found_of(result));
    row.mode = out.mode;
    row.reason = out.found.reason;
    row.promised_after = now_us < lease_end_us;
    rows.push_back(row);
  }
  return rows;
}

// A process that puts rows into the rules of a model and compares what they decide.
std::string recorded(const std::vector<Row>& rows);

}  // namespace rtac::protocol::test
