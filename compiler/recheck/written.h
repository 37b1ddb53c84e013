// What a verification.json says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

struct Entry {
  std::string kind, monitor, recovery, status;
  std::vector<Claim> claims;
};
struct Part {
  std::string decision, robot;
  std::vector<Entry> entries;
};
struct Report {
  std::string spec;
  std::vector<Part> parts;
};

// nullopt: it is no report, or not a whole one, or it says something twice.
std::optional<Report> read_report(const std::string& report);

// nullptr: it is not there.
const Entry* find(const Part& part, const std::string& kind, const std::string& monitor,
                  const std::string& recovery = "");
const Claim* claim_of(const Entry& entry, const std::string& what);
// One of which all of these are so.
const Claim* claim_with(const Entry& entry, const std::string& what, const Values& values);
bool has(const Entry& entry, const std::string& what, const Values& values = {});
// "fly, P2b of `walls`".
std::string whom(const sema::Decision& d, const Entry& entry);
// Of the recovery of several monitors: whether it is about what happens while it drives for this
// one.
bool speaks_of(const Entry& entry, const sema::Monitor& driving);
// It is proved, or accepted as far as what others do goes, and its claims are all the rest.
bool is_shown(const Entry& entry);

}  // namespace rtac::recheck
