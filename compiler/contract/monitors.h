// What the properties of monitors claim of a view, in ACSL: of now, of everything within reach, and
// of the return condition. Made of the checked expressions.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "compiler/sema/spec.h"

namespace rtac::contract {

// One condition; several of a monitor are joined by `and`.
struct Claim {
  enum class Kind { zone, company, energy } kind;
  std::string zone;        // its name, of `zone`
  std::int64_t least = 0;  // mm or ppm, rounded up
};

struct MonitorClaims {
  std::string name;
  std::vector<Claim> claims;
  bool has_return = false;
  std::set<std::string> zones;  // that the property or the return condition is about
  std::string gap;              // why nothing is claimed; empty: all of it is
};
MonitorClaims claims_of(const sema::Spec& spec, const sema::Monitor& monitor);

// A decision with what its contracts are made of; lengths in mm, times in us, on the safe side.
struct DecisionFacts {
  const sema::Spec* spec;
  const sema::Decision* decision;
  const sema::RobotKind* kind;
  std::string prefix, name;
  std::vector<MonitorClaims> monitors;
  std::set<std::string> zones;
  bool has_company = false, has_energy = false, has_heading = false;
  std::size_t robots = 0, runs = 0;
  std::int64_t radius_mm = 0, speed_mmps = 0, latency_us = 0, period_us = 0, tracking_mm = 0;
};
DecisionFacts facts_of(const sema::Spec& spec, const sema::Decision& decision,
                       const std::string& prefix);

// What monitor `i` claims of now, under `motion`; and of everything within reach under it, for a
// time in us. Both are expressions of C or ACSL; `legs` says whether the plan is judged, too.
std::string claimed_now(const DecisionFacts& facts, std::size_t i, const std::string& motion);
struct Within {
  std::string motion, horizon_us, legs;
  bool sets = true;  // the view's sets within reach are those of that motion and time
};
std::string claimed_ahead(const DecisionFacts& facts, std::size_t i, const Within& within);

// Contracts of the functions that judge the monitors; `given`: what they may rely on.
std::string monitor_contracts(const DecisionFacts& facts, const std::string& given);

}  // namespace rtac::contract
