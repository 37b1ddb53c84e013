// One local search by Ipopt, the only door to it.
#pragma once

#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>

#include "solve_status.h"

namespace rtac::optimize {

constexpr double unbounded = 2e19;  // Ipopt takes anything beyond 1e19 for infinity

// Ipopt asks first for the places of a sparse matrix (`values` null), later for its values.
struct SparseEntries {
  Ipopt::Index* rows;
  Ipopt::Index* columns;
  Ipopt::Number* values;
  Ipopt::Index next = 0;
  void add(Ipopt::Index row, Ipopt::Index column, double value) {
    if (values == nullptr) {
      rows[next] = row;
      columns[next] = column;
    } else {
      values[next] = value;
    }
    ++next;
  }
};

// Silent, without an option file. One after the other: MUMPS, the linear solver of this build of
// Ipopt, keeps global state.
SolveStatus run_ipopt(const Ipopt::SmartPtr<Ipopt::TNLP>& nlp);

}  // namespace rtac::optimize
