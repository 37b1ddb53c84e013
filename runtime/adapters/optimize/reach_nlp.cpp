#include "reach_nlp.h"

#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#include <cmath>
#include <cstddef>
#include <exception>
#include <mutex>
#include <utility>

namespace rtac::optimize {
namespace {

using Ipopt::Index;
using Ipopt::Number;

constexpr double smoothing_mps = 1e-4;  // see worst_case.h
constexpr double unbounded = 2e19;      // Ipopt takes anything beyond 1e19 for infinity
constexpr int iterations_max = 300;
constexpr double tolerance = 1e-9;

// |x_at - x_from|^2 / radius^2 <= 1; `from` < 0: the constant `centre` instead of x_from.
struct Ball {
  Index at, from;
  Vec2 centre;
  double radius;
};

class ReachNlp : public Ipopt::TNLP {
 public:
  ReachNlp(const ReachProblem& problem, Candidate start)
      : problem_(problem),
        candidate_(std::move(start)),
        step_s_(problem.horizon_s / problem.intervals) {
    add_balls();
  }
  [[nodiscard]] const Candidate& candidate() const { return candidate_; }
  [[nodiscard]] bool has_result() const { return has_result_; }

  bool get_nlp_info(Index& n, Index& m, Index& jacobian_size, Index& hessian_size,
                    IndexStyleEnum& style) override {
    n = variables();
    m = static_cast<Index>(balls_.size());
    jacobian_size = hessian_size = 0;
    for (const Ball& ball : balls_) {
      jacobian_size += ball.from < 0 ? 2 : 4;
      hessian_size += ball.from < 0 ? 2 : 6;
    }
    hessian_size += 3;  // of the objective, at the last velocity
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
      g_lower[i] = -unbounded;
      g_upper[i] = 1;
    }
    return true;
  }

  bool get_starting_point(Index, bool, Number* x, bool init_z, Number*, Number*, Index,
                          bool init_lambda, Number*) override {
    put(candidate_.start, 0, x);
    for (Index k = 0; k <= problem_.intervals; ++k) {
      put(candidate_.velocities[static_cast<std::size_t>(k)], at(k), x);
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
    put(-1.0 * n, 0, gradient);
    for (Index k = 0; k <= problem_.intervals; ++k) put(-weight_s(k) * n, at(k), gradient);
    const double s = smooth_speed(v), half = 1 / (2 * problem_.brake_mps2);
    const Vec2 g = half * (s * n + (dot(n, v) / s) * v);
    gradient[at(problem_.intervals)] -= g.x;
    gradient[at(problem_.intervals) + 1] -= g.y;
    return true;
  }

  bool eval_g(Index, const Number* x, bool, Index m, Number* g) override {
    for (Index i = 0; i < m; ++i) {
      const Vec2 d = difference(ball(i), x);
      g[i] = dot(d, d) / (ball(i).radius * ball(i).radius);
    }
    return true;
  }

  bool eval_jac_g(Index, const Number* x, bool, Index m, Index, Index* rows, Index* columns,
                  Number* values) override {
    Index entry = 0;
    const auto add = [&](Index row, Index column, double value) {
      if (values == nullptr) {
        rows[entry] = row;
        columns[entry] = column;
      } else {
        values[entry] = value;
      }
      ++entry;
    };
    for (Index i = 0; i < m; ++i) {
      const Ball& b = ball(i);
      const Vec2 d = values == nullptr ? Vec2{} : (2 / (b.radius * b.radius)) * difference(b, x);
      add(i, b.at, d.x);
      add(i, b.at + 1, d.y);
      if (b.from < 0) continue;
      add(i, b.from, -d.x);
      add(i, b.from + 1, -d.y);
    }
    return true;
  }

  // Lower triangle; Ipopt sums entries at the same place.
  bool eval_h(Index, const Number* x, bool, Number objective_factor, Index m,
              const Number* multipliers, bool, Index, Index* rows, Index* columns,
              Number* values) override {
    Index entry = 0;
    const auto add = [&](Index row, Index column, double value) {
      if (values == nullptr) {
        rows[entry] = row;
        columns[entry] = column;
      } else {
        values[entry] = value;
      }
      ++entry;
    };
    for (Index i = 0; i < m; ++i) {
      const Ball& b = ball(i);
      const double c = values == nullptr ? 0 : 2 * multipliers[i] / (b.radius * b.radius);
      for (Index axis = 0; axis < 2; ++axis) {
        add(b.at + axis, b.at + axis, c);
        if (b.from < 0) continue;
        add(b.from + axis, b.from + axis, c);
        add(b.at + axis, b.from + axis, -c);  // `from` precedes `at`
      }
    }
    const Curvature c = values == nullptr ? Curvature{} : curvature(last(x), objective_factor);
    const Index v = at(problem_.intervals);
    add(v, v, c.xx);
    add(v + 1, v, c.xy);
    add(v + 1, v + 1, c.yy);
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
      balls_.push_back({0, -1, problem_.position, problem_.position_error_m});
    }
    if (problem_.velocity_error_mps > 0) {
      balls_.push_back({at(0), -1, problem_.velocity, problem_.velocity_error_mps});
      if (capped) balls_.push_back({at(0), -1, Vec2{}, problem_.speed_mps});
    }
    for (Index k = 1; k <= problem_.intervals; ++k) {
      balls_.push_back({at(k), at(k - 1), Vec2{}, problem_.accel_mps2 * step_s_});
      if (capped) balls_.push_back({at(k), -1, Vec2{}, problem_.speed_mps});
    }
  }

  [[nodiscard]] Index variables() const { return 2 * (problem_.intervals + 2); }
  [[nodiscard]] static Index at(Index k) { return 2 * (k + 1); }  // of velocity k
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
    return get(x, b.at) - (b.from < 0 ? b.centre : get(x, b.from));
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
  double step_s_;
  std::vector<Ball> balls_;
  bool has_result_ = false;
};

// MUMPS, the linear solver of this build of Ipopt, keeps global state.
std::mutex& solver_in_use() {
  static std::mutex mutex;
  return mutex;
}

bool set_options(Ipopt::IpoptApplication& app) {
  auto options = app.Options();
  return options->SetIntegerValue("print_level", 0) && options->SetStringValue("sb", "yes") &&
         options->SetIntegerValue("max_iter", iterations_max) &&
         options->SetNumericValue("tol", tolerance) &&
         options->SetStringValue("linear_solver", "mumps") &&
         // An empty name: no option file of the working directory is read.
         app.Initialize("") == Ipopt::Solve_Succeeded;
}

SolveStatus status_of(Ipopt::ApplicationReturnStatus status) {
  return status == Ipopt::Solve_Succeeded || status == Ipopt::Solved_To_Acceptable_Level
             ? SolveStatus::converged
             : SolveStatus::stopped_early;
}

}  // namespace

SolveStatus solve(const ReachProblem& problem, Candidate& candidate) {
  const std::lock_guard<std::mutex> owner(solver_in_use());
  try {
    const bool console = false;
    Ipopt::SmartPtr<Ipopt::IpoptApplication> app = new Ipopt::IpoptApplication(console);
    if (!set_options(*app)) return SolveStatus::failed;
    Ipopt::SmartPtr<ReachNlp> nlp = new ReachNlp(problem, candidate);
    const auto status = status_of(app->OptimizeTNLP(GetRawPtr(nlp)));
    if (!nlp->has_result()) return SolveStatus::failed;
    candidate = nlp->candidate();
    return status;
  } catch (const std::exception&) {
    return SolveStatus::failed;
  } catch (const Ipopt::IpoptException&) {  // not derived from std::exception
    return SolveStatus::failed;
  }
}

}  // namespace rtac::optimize
