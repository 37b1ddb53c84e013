// Random decisions: a fixed fleet, and monitors whose properties and return conditions are random
// formulas of what decisions may say: of plain inputs, of the past, of the robot and of others.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace rtac::differential {

class DecisionGenerator {
 public:
  explicit DecisionGenerator(std::uint32_t seed) : random_(seed) {}
  // One line: the monitor `mK`. Every other one speaks of plain inputs alone in its property.
  std::string monitor(std::size_t k);

 private:
  // What may stand there: facts are judged now, and what is looked ahead is of a few forms.
  enum class Place { fact, ahead, now };
  std::size_t below(std::size_t count) { return random_() % count; }
  template <class List>
  std::string one_of(const List& list) {
    return list[below(list.size())];
  }
  std::string window(bool may_be_endless);
  std::string duration();
  std::string less_or_more();
  std::string input_atom();
  std::string number(int depth);
  std::string robot_atom();   // as it can be looked ahead
  std::string robot_claim();  // as it can be judged now
  std::string length(int depth);
  std::string past(int depth, Place place);
  std::string condition(int depth, Place place);

  std::mt19937 random_;
};

// The specification of these monitors, of which monitor k stands in the line `first_line` + k.
struct DecisionPage {
  std::string text;
  std::size_t first_line;
};
DecisionPage decision_page(const std::vector<std::string>& monitors);

}  // namespace rtac::differential
