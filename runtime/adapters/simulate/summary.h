// What many runs of a decision came to, as a table.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "run.h"

namespace rtac::simulate {

class Summary {
 public:
  // `predicted_percent`: of the places, where the compiler says that control comes back.
  explicit Summary(const DecisionCase& decision,
                   std::optional<int> predicted_percent = std::nullopt);
  void add(const Setup& setup, const Outcome& outcome);

  [[nodiscard]] std::uint64_t violations() const { return violations_; }
  [[nodiscard]] double robot_hours() const;
  // How much of the time the advanced controller had, and how far that is from what was predicted.
  [[nodiscard]] std::string advanced() const;
  // `core_s`: how long it took, on one core; 0: not to be told.
  [[nodiscard]] std::string text(double core_s) const;

 private:
  struct Least {
    sim::LeastMargin margin;
    std::uint64_t seed = 0;
    std::string adversary;
  };
  struct Tally {
    std::uint64_t runs = 0, violations = 0;
    std::int64_t ticks = 0, advanced = 0, engagements = 0;
    TimeUs robot_time_us = 0;
  };
  void tally(Tally& to, const Outcome& outcome) const;
  [[nodiscard]] std::string attacks() const;
  [[nodiscard]] std::string monitors() const;

  const DecisionCase& decision_;
  std::optional<int> predicted_percent_;
  std::uint64_t violations_ = 0;
  Tally all_;
  std::map<std::string, Tally> by_adversary_;
  std::vector<std::int64_t> ticks_;  // by mode
  std::vector<Least> least_;         // by monitor
};

// A margin in the unit of its monitor; in scales of it where the monitor mixes units.
std::string margin_text(const MonitorCase& monitor, double scales);

}  // namespace rtac::simulate
