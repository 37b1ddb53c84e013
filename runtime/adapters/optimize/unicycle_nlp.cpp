#include "unicycle_nlp.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "ipopt_session.h"

namespace rtac::optimize {
namespace {

using Ipopt::Index;
using Ipopt::Number;

class UnicycleNlp : public Ipopt::TNLP {
 public:
  UnicycleNlp(const UnicycleProblem& problem, UnicycleCandidate start)
      : q_(problem),
        candidate_(std::move(start)),
        n_(problem.intervals),
        step_s_(problem.horizon_s / problem.intervals),
        normal_rad_(std::atan2(problem.normal.y, problem.normal.x)) {}
  [[nodiscard]] const UnicycleCandidate& candidate() const { return candidate_; }
  [[nodiscard]] bool has_result() const { return has_result_; }

  bool get_nlp_info(Index& n, Index& m, Index& jacobian_size, Index& hessian_size,
                    IndexStyleEnum& style) override {
    n = 2 * (n_ + 1);
    m = first_step() + 2 * n_ + bends();
    jacobian_size = 2 * first_step() + 4 * n_ + 3 * bends();
    hessian_size = 3 * first_step() + 7 * n_ + 3;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index, Number* lower, Number* upper, Index, Number* g_lower,
                       Number* g_upper) override {
    for (Index k = 0; k <= n_; ++k) {
      lower[speed(k)] = 0;
      upper[speed(k)] = std::isfinite(q_.speed_mps) ? q_.speed_mps : unbounded;
      lower[heading(k)] = -unbounded;
      upper[heading(k)] = unbounded;
    }
    lower[heading(0)] = q_.heading_rad - q_.heading_error_rad;
    upper[heading(0)] = q_.heading_rad + q_.heading_error_rad;
    // An error of zero leaves no interior: exact measurements fix the variables instead.
    if (q_.velocity_error_mps <= 0) lower[speed(0)] = upper[speed(0)] = norm(q_.velocity);
    if (first_step() > 0) {
      g_lower[0] = -unbounded;
      g_upper[0] = q_.velocity_error_mps * q_.velocity_error_mps;
    }
    for (Index k = 0; k < n_; ++k) {
      const Index row = first_step() + 2 * k;
      g_lower[row] = -q_.brake_mps2 * step_s_;
      g_upper[row] = q_.accel_mps2 * step_s_;
      g_lower[row + 1] = -q_.turn_radps * step_s_;
      g_upper[row + 1] = q_.turn_radps * step_s_;
    }
    for (Index k = 0; k < bends(); ++k) {
      const Index row = first_step() + 2 * n_ + k;
      g_lower[row] = -q_.turn_accel_radps2 * step_s_ * step_s_;
      g_upper[row] = q_.turn_accel_radps2 * step_s_ * step_s_;
    }
    return true;
  }

  bool get_starting_point(Index, bool, Number* x, bool init_z, Number*, Number*, Index,
                          bool init_lambda, Number*) override {
    for (Index k = 0; k <= n_; ++k) {
      x[speed(k)] = candidate_.speeds_mps[static_cast<std::size_t>(k)];
      x[heading(k)] = candidate_.headings_rad[static_cast<std::size_t>(k)];
    }
    return !init_z && !init_lambda;
  }

  // What it drives in an interval: its mean speed along its mean heading; then the stop.
  bool eval_f(Index, const Number* x, bool, Number& value) override {
    value = -stop_m(x) * std::cos(x[heading(n_)] - normal_rad_);
    for (Index k = 0; k < n_; ++k) value -= mean_m(x, k) * std::cos(mean_rad(x, k));
    return true;
  }

  bool eval_grad_f(Index, const Number* x, bool, Number* gradient) override {
    std::fill_n(gradient, 2 * (n_ + 1), 0.0);
    for (Index k = 0; k < n_; ++k) {
      const double c = std::cos(mean_rad(x, k)), s = std::sin(mean_rad(x, k));
      for (const Index j : {k, k + 1}) {
        gradient[speed(j)] -= step_s_ / 2 * c;
        gradient[heading(j)] += mean_m(x, k) / 2 * s;
      }
    }
    const double turned = x[heading(n_)] - normal_rad_;
    gradient[speed(n_)] -= x[speed(n_)] / q_.brake_mps2 * std::cos(turned);
    gradient[heading(n_)] += stop_m(x) * std::sin(turned);
    return true;
  }

  bool eval_g(Index, const Number* x, bool, Index, Number* g) override {
    if (first_step() > 0) {
      const Vec2 d = x[speed(0)] * pointing(x[heading(0)]) - q_.velocity;
      g[0] = dot(d, d);
    }
    for (Index k = 0; k < n_; ++k) {
      g[first_step() + 2 * k] = x[speed(k + 1)] - x[speed(k)];
      g[first_step() + 2 * k + 1] = x[heading(k + 1)] - x[heading(k)];
    }
    for (Index k = 0; k < bends(); ++k) {
      g[first_step() + 2 * n_ + k] = x[heading(k + 2)] - 2 * x[heading(k + 1)] + x[heading(k)];
    }
    return true;
  }

  bool eval_jac_g(Index, const Number* x, bool, Index, Index, Index* rows, Index* columns,
                  Number* values) override {
    SparseEntries entries{rows, columns, values};
    if (first_step() > 0) {
      const Measured m = values == nullptr ? Measured{} : measured(x);
      entries.add(0, speed(0), m.by_speed);
      entries.add(0, heading(0), m.by_heading);
    }
    for (Index k = 0; k < n_; ++k) {
      const Index row = first_step() + 2 * k;
      entries.add(row, speed(k + 1), 1);
      entries.add(row, speed(k), -1);
      entries.add(row + 1, heading(k + 1), 1);
      entries.add(row + 1, heading(k), -1);
    }
    for (Index k = 0; k < bends(); ++k) {
      const Index row = first_step() + 2 * n_ + k;
      entries.add(row, heading(k + 2), 1);
      entries.add(row, heading(k + 1), -2);
      entries.add(row, heading(k), 1);
    }
    return true;
  }

  // Lower triangle; Ipopt sums entries at the same place.
  bool eval_h(Index, const Number* x, bool, Number factor, Index, const Number* multipliers, bool,
              Index, Index* rows, Index* columns, Number* values) override {
    SparseEntries entries{rows, columns, values};
    const bool asked = values != nullptr;
    if (first_step() > 0) {
      const Measured m = asked ? measured(x) : Measured{};
      const double weight = asked ? multipliers[0] : 0;
      entries.add(speed(0), speed(0), weight * 2);
      entries.add(heading(0), speed(0), weight * m.by_both);
      entries.add(heading(0), heading(0), weight * m.by_heading_twice);
    }
    for (Index k = 0; k < n_; ++k) {
      const double c = asked ? factor * std::cos(mean_rad(x, k)) * mean_m(x, k) / 4 : 0;
      const double s = asked ? factor * std::sin(mean_rad(x, k)) * step_s_ / 4 : 0;
      for (const Index i : {k, k + 1}) {
        entries.add(heading(i), speed(k), s);
        entries.add(heading(i), speed(k + 1), s);
        entries.add(heading(i), heading(i), c);
      }
      entries.add(heading(k + 1), heading(k), c);
    }
    const double turned = asked ? x[heading(n_)] - normal_rad_ : 0;
    const double c = factor * std::cos(turned), s = factor * std::sin(turned);
    entries.add(speed(n_), speed(n_), asked ? -c / q_.brake_mps2 : 0);
    entries.add(heading(n_), speed(n_), asked ? s * x[speed(n_)] / q_.brake_mps2 : 0);
    entries.add(heading(n_), heading(n_), asked ? c * stop_m(x) : 0);
    return true;
  }

  void finalize_solution(Ipopt::SolverReturn, Index, const Number* x, const Number*, const Number*,
                         Index, const Number*, const Number*, Number, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    for (Index k = 0; k <= n_; ++k) {
      candidate_.speeds_mps[static_cast<std::size_t>(k)] = x[speed(k)];
      candidate_.headings_rad[static_cast<std::size_t>(k)] = x[heading(k)];
    }
    has_result_ = true;
  }

 private:
  // |speed (cos, sin) - velocity|^2, its slopes and its second derivatives.
  struct Measured {
    double by_speed = 0, by_heading = 0, by_both = 0, by_heading_twice = 0;
  };
  [[nodiscard]] Measured measured(const Number* x) const {
    const Vec2 way = pointing(x[heading(0)]);
    const double along = dot(way, q_.velocity);
    const double aside = way.x * q_.velocity.y - way.y * q_.velocity.x;  // slope of `along`
    const double v = x[speed(0)];
    return {2 * (v - along), -2 * v * aside, -2 * aside, 2 * v * along};
  }

  [[nodiscard]] static Index speed(Index k) { return k; }
  [[nodiscard]] Index heading(Index k) const { return n_ + 1 + k; }
  // Constraints: the error of the velocity, if any; speed and heading of each interval; then how
  // fast the turn rate changes between intervals.
  [[nodiscard]] Index first_step() const { return q_.velocity_error_mps > 0 ? 1 : 0; }
  [[nodiscard]] Index bends() const { return q_.turn_accel_radps2 > 0 ? n_ - 1 : 0; }
  [[nodiscard]] static Vec2 pointing(double rad) { return {std::cos(rad), std::sin(rad)}; }
  [[nodiscard]] double mean_m(const Number* x, Index k) const {
    return step_s_ * (x[speed(k)] + x[speed(k + 1)]) / 2;
  }
  [[nodiscard]] double mean_rad(const Number* x, Index k) const {
    return (x[heading(k)] + x[heading(k + 1)]) / 2 - normal_rad_;
  }
  [[nodiscard]] double stop_m(const Number* x) const {
    return x[speed(n_)] * x[speed(n_)] / (2 * q_.brake_mps2);
  }

  const UnicycleProblem& q_;
  UnicycleCandidate candidate_;
  Index n_;
  double step_s_, normal_rad_;
  bool has_result_ = false;
};

}  // namespace

SolveStatus solve(const UnicycleProblem& problem, UnicycleCandidate& candidate) {
  const Ipopt::SmartPtr<UnicycleNlp> nlp = new UnicycleNlp(problem, candidate);
  const SolveStatus status = run_ipopt(Ipopt::SmartPtr<Ipopt::TNLP>(GetRawPtr(nlp)));
  if (!nlp->has_result()) return SolveStatus::failed;
  candidate = nlp->candidate();
  return status;
}

}  // namespace rtac::optimize
