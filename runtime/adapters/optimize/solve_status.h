// How a local search ended.
#pragma once

namespace rtac::optimize {

enum class SolveStatus { converged, stopped_early, failed };

}  // namespace rtac::optimize
