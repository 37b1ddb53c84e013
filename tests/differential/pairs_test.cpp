// Every operator as an operand of every other one that takes it, at every place, found true, false
// and unknown, with an operand that is found true, false and unknown; of quantities, to reach some
// limit, not to reach it, and neither.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "tests/differential/batch.h"
#include "tests/differential/probe.h"
#include "tests/turn.h"

namespace rtac::differential {
namespace {

constexpr std::size_t parts = 8;  // a kernel each
// Of so many parts each test looks at those whose turn it is (tests/turn.h): one of them at least,
// where eight take turns.
constexpr std::size_t parts_each = 8;
constexpr std::size_t runs = 12, steps = 40, formulas_min = 200;

// One of the types that a pair may have, on these leaves.
struct Variant {
  const Operator* outer;
  std::size_t place;  // of the inner one
  const Operator* inner;
  std::size_t leaves, beside;  // where the leaves begin, inside and beside it
  [[nodiscard]] Formula operand() const {
    std::vector<std::string> operands;
    for (const Type type : inner->operands)
      operands.push_back(leaf(type, leaves + operands.size()));
    return {applied(*inner, operands, 0), inner->result};
  }
  [[nodiscard]] Formula whole() const {
    std::vector<std::string> operands;
    for (const Type type : outer->operands)
      operands.push_back(leaf(type, beside + operands.size()));
    operands[place] = operand().text;
    return {applied(*outer, operands, 1), outer->result};
  }
};
// Two operators by their names.
struct Pair {
  std::string text;
  std::vector<Variant> variants;
};

std::vector<Pair> pairs() {
  std::map<std::tuple<std::string, std::size_t, std::string>, std::vector<Variant>> all;
  for (const Operator& outer : operators()) {
    for (std::size_t i = 0; i < outer.operands.size(); ++i) {
      for (const Operator& inner : operators()) {
        if (!fits(inner.result, outer.operands[i])) continue;
        all[{outer.name, i, inner.name}].push_back({&outer, i, &inner, 0, 2});
      }
    }
  }
  std::vector<Pair> pairs;
  for (auto& [name, typed] : all) {
    const auto& [outer, place, inner] = name;
    // every type is the first one of some pairs
    const auto turn = static_cast<std::ptrdiff_t>(pairs.size() % typed.size());
    std::rotate(typed.begin(), typed.begin() + turn, typed.end());
    const std::size_t types = typed.size();
    for (const auto& [leaves, beside] : {std::pair(0, 1), std::pair(1, 0), std::pair(2, 2)}) {
      for (std::size_t k = 0; k < types; ++k) {
        typed.push_back(typed[k]);
        typed.back().leaves = static_cast<std::size_t>(leaves);
        typed.back().beside = static_cast<std::size_t>(beside);
      }
    }
    pairs.push_back(
        {"`" + inner + "` as operand " + std::to_string(place + 1) + " of `" + outer + "`",
         std::move(typed)});
  }
  return pairs;
}

class Pairs : public ::testing::TestWithParam<std::size_t> {
 protected:
  void take(std::size_t part) {
    part_ = part;
    mine_.clear(), settled_.clear(), conditions_.clear(), at_.clear();
    const std::vector<Pair> all = pairs();
    for (std::size_t i = part; i < all.size(); i += parts) mine_.push_back(all[i]);
    std::vector<std::size_t> open(mine_.size());
    for (std::size_t i = 0; i < open.size(); ++i) open[i] = i;
    for (std::size_t round = 0; !open.empty(); ++round) {
      ASSERT_NO_FATAL_FAILURE(settle(round, open));
    }
    lines_ = {monitor_of_robots()};
    for (const std::string& condition : conditions_) {
      at_[condition] = lines_.size();
      lines_.push_back(monitor_line(lines_.size(), condition));
    }
  }
  // Takes the variants of this round that have every verdict; `open` keeps the other pairs. The
  // last variant counts whatever it has.
  void settle(std::size_t round, std::vector<std::size_t>& open) {
    std::vector<Formula> formulas;
    for (const std::size_t i : open) {
      const Variant& variant = mine_[i].variants[round];
      formulas.push_back(measured(variant.whole()));
      formulas.push_back(measured(variant.operand()));
    }
    std::string problem;
    const auto found = probe(formulas, {seed(), runs, steps}, problem);
    ASSERT_EQ(problem, "");
    std::vector<std::size_t> left;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const Probed &whole = found[2 * k], &inside = found[2 * k + 1];
      const bool is_last = round + 1 == mine_[open[k]].variants.size();
      if (!is_last && std::min(whole.rarest, inside.rarest) == 0) {
        left.push_back(open[k]);
        continue;
      }
      settled_.push_back({open[k], whole.condition, inside.condition});
      conditions_.insert({whole.condition, inside.condition});
    }
    open = std::move(left);
  }
  [[nodiscard]] std::uint32_t seed() const { return static_cast<std::uint32_t>(part_) + 1; }
  [[nodiscard]] std::set<char> verdicts(const Batch& batch, const std::string& condition) const {
    const std::string letters = batch.verdicts(at_.at(condition));
    return {letters.begin(), letters.end()};
  }

  void judge();

  struct Settled {
    std::size_t pair;
    std::string whole, inside;
  };
  std::size_t part_ = 0;
  std::vector<Pair> mine_;
  std::vector<Settled> settled_;
  std::set<std::string> conditions_;
  std::vector<std::string> lines_;
  std::map<std::string, std::size_t> at_;  // the monitor of a condition
};

void Pairs::judge() {
  const Batch batch(seed(), 0, steps, lines_, runs);
  ASSERT_EQ(batch.problem(), "");
  ASSERT_EQ(batch.refused(), "");
  ASSERT_GE(batch.size(), formulas_min);
  const driver::LoadedKernel loaded = load(batch.code(), {}, Speed::of_building);
  ASSERT_NE(loaded.engine, nullptr) << loaded.problem;
  const Batch::Result result = batch.compare(*loaded.engine);
  EXPECT_EQ(result.different, 0u) << result.first;
  const driver::LoadedKernel alone = load_verdicts(batch.code(), {}, Speed::of_building);
  ASSERT_NE(alone.engine, nullptr) << alone.problem;
  EXPECT_EQ(batch.disagreement(*loaded.engine, *alone.engine), "");
  const std::set<char> every{'0', '1', '?'};
  ASSERT_EQ(settled_.size(), mine_.size());
  for (const Settled& pair : settled_) {
    EXPECT_EQ(verdicts(batch, pair.whole), every)
        << "missing: " << mine_[pair.pair].text << ", " << pair.whole;
    EXPECT_EQ(verdicts(batch, pair.inside), every)
        << "missing inside: " << mine_[pair.pair].text << ", " << pair.inside;
  }
}

TEST_P(Pairs, AreJudgedAlikeWithEveryValue) {
  std::size_t judged = 0;
  for (std::size_t part = GetParam(); part < GetParam() + parts_each; ++part) {
    if (!rtac::test::is_due(part)) continue;
    ASSERT_NO_FATAL_FAILURE(take(part));
    ASSERT_NO_FATAL_FAILURE(judge());
    ++judged;
  }
  EXPECT_GT(judged, 0U) << "no part had its turn";
}

INSTANTIATE_TEST_SUITE_P(Parts, Pairs, ::testing::Range(std::size_t{0}, parts, parts_each));

}  // namespace
}  // namespace rtac::differential
