#include "reach_nlp.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "ipopt_session.h"

namespace rtac::optimize {
namespace {

using Ipopt::Index;
using Ipopt::Number;

constexpr double smoothing_mps = 1e-4;  // see worst_case.h

// |x_at - centre|^2 / radius^2 <= 1
struct Ball {
  Index at;
  Vec2 centre;
  double radius;
};

class ReachNlp : public Ipopt::TNLP {
 public:
  ReachNlp(const ReachProblem& problem, Candidate start)
      : problem_(problem),
        candidate_(std::move(start)),
        step_s_(problem.horizon_s / problem.intervals),
        step_mps_(problem.accel_mps2 * step_s_) {
    add_balls();
  }
  [[nodiscard]] const Candidate& candidate() const { return candidate_; }
  [[nodiscard]] bool has_result() const { return has_result_; }

  bool get_nlp_info(Index& n, Index& m, Index& jacobian_size, Index& hessian_size,
                    IndexStyleEnum& style) override {
    n = variables();
    m = static_cast<Index>(balls_.size()) + 2 * problem_.intervals;
    jacobian_size = 2 * static_cast<Index>(balls_.size()) + 6 * problem_.intervals;
    hessian_size = 2 * static_cast<Index>(balls_.size()) + 3;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* lower, Number* upper, Index m, Number* g_lower,
                       Number* g_upper) override {
    for (Index i = 0; i < n; ++i) {
      lower[i] = -unbounded;
      upper[i] = unbounded;
    }
    // A ball of radius zero has no interior: an exact measurement fixes the variables instead.
    if (problem_.position_error_m <= 0) fix(problem_.position, 0, lower, upper);
    if (problem_.velocity_error_mps <= 0) fix(problem_.velocity, at(0), lower, upper);
    for (Index i = 0; i < m; ++i) {
      const bool inside_ball = i < first_step();
      g_lower[i] = inside_ball ? -unbounded : 0;
      g_upper[i] = inside_ball ? 1 : 0;
    }
    return true;
  }

  bool get_starting_point(Index, bool, Number* x, bool init_z, Number*, Number*, Index,
                          bool init_lambda, Number*) override {
    put(candidate_.start, 0, x);
    for (Index k = 0; k <= problem_.intervals; ++k) {
      put(velocity(k), at(k), x);
    }
    for (Index k = 0; k < problem_.intervals; ++k) {
      put((1 / step_mps_) * (velocity(k + 1) - velocity(k)), control(k), x);
    }
    return !init_z && !init_lambda;
  }

  bool eval_f(Index, const Number* x, bool, Number& value) override {
    const Vec2 v = last(x), n = problem_.normal;
    double reach = dot(n, get(x, 0)) + dot(n, v) * smooth_speed(v) / (2 * problem_.brake_mps2);
    for (Index k = 0; k <= problem_.intervals; ++k) reach += weight_s(k) * dot(n, get(x, at(k)));
    value = -reach;
    return true;
  }

  bool eval_grad_f(Index, const Number* x, bool, Number* gradient) override {
    const Vec2 v = last(x), n = problem_.normal;
    std::fill_n(gradient, variables(), 0.0);
    put(-1.0 * n, 0, gradient);
    for (Index k = 0; k <= problem_.intervals; ++k) put(-weight_s(k) * n, at(k), gradient);
    const double s = smooth_speed(v), half = 1 / (2 * problem_.brake_mps2);
    const Vec2 g = half * (s * n + (dot(n, v) / s) * v);
    gradient[at(problem_.intervals)] -= g.x;
    gradient[at(problem_.intervals) + 1] -= g.y;
    return true;
  }

  bool eval_g(Index, const Number* x, bool, Index, Number* g) override {
    for (Index i = 0; i < first_step(); ++i) {
      const Vec2 d = difference(ball(i), x);
      g[i] = dot(d, d) / (ball(i).radius * ball(i).radius);
    }
    for (Index k = 0; k < problem_.intervals; ++k) {
      put(get(x, at(k + 1)) - get(x, at(k)) - step_mps_ * get(x, control(k)), first_step() + 2 * k,
          g);
    }
    return true;
  }

  bool eval_jac_g(Index, const Number* x, bool, Index, Index, Index* rows, Index* columns,
                  Number* values) override {
    SparseEntries entries{rows, columns, values};
    for (Index i = 0; i < first_step(); ++i) {
      const Ball& b = ball(i);
      const Vec2 d = values == nullptr ? Vec2{} : (2 / (b.radius * b.radius)) * difference(b, x);
      entries.add(i, b.at, d.x);
      entries.add(i, b.at + 1, d.y);
    }
    for (Index k = 0; k < problem_.intervals; ++k) {
      for (Index axis = 0; axis < 2; ++axis) {
        const Index row = first_step() + 2 * k + axis;
        entries.add(row, at(k + 1) + axis, 1);
        entries.add(row, at(k) + axis, -1);
        entries.add(row, control(k) + axis, -step_mps_);
      }
    }
    return true;
  }

  // Lower triangle; Ipopt sums entries at the same place.
  bool eval_h(Index, const Number* x, bool, Number objective_factor, Index,
              const Number* multipliers, bool, Index, Index* rows, Index* columns,
              Number* values) override {
    SparseEntries entries{rows, columns, values};
    for (Index i = 0; i < first_step(); ++i) {
      const Ball& b = ball(i);
      const double c = values == nullptr ? 0 : 2 * multipliers[i] / (b.radius * b.radius);
      entries.add(b.at, b.at, c);
      entries.add(b.at + 1, b.at + 1, c);
    }
    const Curvature c = values == nullptr ? Curvature{} : curvature(last(x), objective_factor);
    const Index v = at(problem_.intervals);
    entries.add(v, v, c.xx);
    entries.add(v + 1, v, c.xy);
    entries.add(v + 1, v + 1, c.yy);
    return true;
  }

  void finalize_solution(Ipopt::SolverReturn, Index, const Number* x, const Number*, const Number*,
                         Index, const Number*, const Number*, Number, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    candidate_.start = get(x, 0);
    for (Index k = 0; k <= problem_.intervals; ++k) {
      candidate_.velocities[static_cast<std::size_t>(k)] = get(x, at(k));
    }
    has_result_ = true;
  }

 private:
  struct Curvature {
    double xx = 0, xy = 0, yy = 0;
  };

  void add_balls() {
    const bool capped = std::isfinite(problem_.speed_mps);
    if (problem_.position_error_m > 0) {
      balls_.push_back({0, problem_.position, problem_.position_error_m});
    }
    if (problem_.velocity_error_mps > 0) {
      balls_.push_back({at(0), problem_.velocity, problem_.velocity_error_mps});
      if (capped) balls_.push_back({at(0), Vec2{}, problem_.speed_mps});
    }
    for (Index k = 1; k <= problem_.intervals; ++k) {
      balls_.push_back({control(k - 1), Vec2{}, 1.0});
      if (capped) balls_.push_back({at(k), Vec2{}, problem_.speed_mps});
    }
  }

  [[nodiscard]] Index variables() const { return control(problem_.intervals); }
  [[nodiscard]] static Index at(Index k) { return 2 * (k + 1); }  // of velocity k
  [[nodiscard]] Index control(Index k) const { return at(problem_.intervals + 1) + 2 * k; }
  // Constraints: the balls, then two equations for each interval.
  [[nodiscard]] Index first_step() const { return static_cast<Index>(balls_.size()); }
  [[nodiscard]] Vec2 velocity(Index k) const {
    return candidate_.velocities[static_cast<std::size_t>(k)];
  }
  [[nodiscard]] const Ball& ball(Index i) const { return balls_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] static Vec2 get(const Number* x, Index i) { return {x[i], x[i + 1]}; }
  [[nodiscard]] Vec2 last(const Number* x) const { return get(x, at(problem_.intervals)); }
  static void put(Vec2 value, Index i, Number* x) {
    x[i] = value.x;
    x[i + 1] = value.y;
  }
  static void fix(Vec2 value, Index i, Number* lower, Number* upper) {
    put(value, i, lower);
    put(value, i, upper);
  }
  // Velocities are linear on each interval, so the trapezoidal rule gives the position exactly.
  [[nodiscard]] double weight_s(Index k) const {
    return k == 0 || k == problem_.intervals ? step_s_ / 2 : step_s_;
  }
  [[nodiscard]] static double smooth_speed(Vec2 v) {
    return std::sqrt(dot(v, v) + smoothing_mps * smoothing_mps);
  }
  [[nodiscard]] static Vec2 difference(const Ball& b, const Number* x) {
    return get(x, b.at) - b.centre;
  }
  // Second derivatives of the objective by the last velocity:
  // (n v' + v n') / s + (n.v) (I / s - v v' / s^3), s the smooth speed, over 2 brake, negated.
  [[nodiscard]] Curvature curvature(Vec2 v, double factor) const {
    const Vec2 n = problem_.normal;
    const double s = smooth_speed(v), nv = dot(n, v);
    const double c = -factor / (2 * problem_.brake_mps2 * s);
    return {c * (2 * n.x * v.x + nv * (1 - v.x * v.x / (s * s))),
            c * (n.x * v.y + n.y * v.x - nv * v.x * v.y / (s * s)),
            c * (2 * n.y * v.y + nv * (1 - v.y * v.y / (s * s)))};
  }

  const ReachProblem& problem_;
  Candidate candidate_;
  double step_s_, step_mps_;  // of an interval: its length, and the change of velocity at full push
  std::vector<Ball> balls_;
  bool has_result_ = false;
};

}  // namespace

SolveStatus solve(const ReachProblem& problem, Candidate& candidate) {
  const Ipopt::SmartPtr<ReachNlp> nlp = new ReachNlp(problem, candidate);
  const SolveStatus status = run_ipopt(Ipopt::SmartPtr<Ipopt::TNLP>(GetRawPtr(nlp)));
  if (!nlp->has_result()) return SolveStatus::failed;
  candidate = nlp->candidate();
  return status;
}

}  // namespace rtac::optimize
