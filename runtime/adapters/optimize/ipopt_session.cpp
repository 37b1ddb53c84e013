#include "ipopt_session.h"

#include <exception>
#include <mutex>

namespace rtac::optimize {
namespace {

constexpr int iterations_max = 100;
constexpr double tolerance = 1e-9;

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

}  // namespace

SolveStatus run_ipopt(const Ipopt::SmartPtr<Ipopt::TNLP>& nlp) {
  const std::lock_guard<std::mutex> owner(solver_in_use());
  try {
    const bool console = false;
    Ipopt::SmartPtr<Ipopt::IpoptApplication> app = new Ipopt::IpoptApplication(console);
    if (!set_options(*app)) return SolveStatus::failed;
    const Ipopt::ApplicationReturnStatus status = app->OptimizeTNLP(nlp);
    return status == Ipopt::Solve_Succeeded || status == Ipopt::Solved_To_Acceptable_Level
               ? SolveStatus::converged
               : SolveStatus::stopped_early;
  } catch (const std::exception&) {
    return SolveStatus::failed;
  } catch (const Ipopt::IpoptException&) {  // not derived from std::exception
    return SolveStatus::failed;
  }
}

}  // namespace rtac::optimize
