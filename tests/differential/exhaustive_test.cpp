// Small scope: every formula of one and two operators on every three-valued trace of a length, by
// all engines, against the definitions. Most mistakes with the past show in something small.
#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "tests/conformance/formula.h"
#include "tests/differential/engines.h"
#include "tests/slow.h"
#include "tests/turn.h"

namespace rtac::differential {
namespace {

using conformance::Formula;
using conformance::FormulaPtr;
using conformance::Op;
using conformance::Trace;
using conformance::Traces;

constexpr std::size_t ticks = 4;
constexpr std::int64_t second_us = 1000000;

struct Operator {
  Op op;
  std::int64_t from = 0;
  std::optional<std::int64_t> to;
  bool binary;
};

std::vector<Operator> operators() {
  std::vector<Operator> all = {{Op::logical_not, 0, {}, false}, {Op::previously, 0, {}, false},
                               {Op::held, 1, {}, false},        {Op::held, 2, {}, false},
                               {Op::logical_and, 0, {}, true},  {Op::logical_or, 0, {}, true},
                               {Op::implies, 0, {}, true},      {Op::iff, 0, {}, true},
                               {Op::logical_xor, 0, {}, true},  {Op::within, 0, {}, true},
                               {Op::within, 1, {}, true}};
  const std::pair<std::int64_t, std::optional<std::int64_t>> windows[] = {
      {0, 0}, {0, 1}, {1, 1}, {1, 2}, {0, std::nullopt}, {1, std::nullopt}};
  for (const auto& [from, to] : windows) {
    all.push_back({Op::once, from, to, false});
    all.push_back({Op::historically, from, to, false});
    all.push_back({Op::since, from, to, true});
  }
  return all;
}

FormulaPtr atom(const char* name) {
  auto f = std::make_shared<Formula>();
  f->name = name;
  return f;
}
FormulaPtr apply(const Operator& o, FormulaPtr left, FormulaPtr right) {
  return std::make_shared<Formula>(
      Formula{o.op, "", o.from, o.to, std::move(left), o.binary ? std::move(right) : nullptr});
}

// Two operators, the inner one on the left or on the right of the outer one; or one alone.
struct Pair {
  FormulaPtr formula, inner;
};
std::vector<Pair> formulas() {
  std::vector<Pair> all;
  for (const Operator& outer : operators()) {
    all.push_back({apply(outer, atom("p"), atom("q")), nullptr});
    for (const Operator& inner : operators()) {
      const FormulaPtr f = apply(inner, atom("p"), atom("q"));
      // beside it either atom, on either side
      all.push_back({apply(outer, f, atom("p")), f});
      if (!outer.binary) continue;
      all.push_back({apply(outer, f, atom("q")), f});
      all.push_back({apply(outer, atom("p"), f), f});
      all.push_back({apply(outer, atom("q"), f), f});
    }
  }
  return all;
}

std::vector<Traces> traces() {
  std::size_t count = 1;
  for (std::size_t i = 0; i < 2 * ticks; ++i) count *= 3;
  std::vector<Traces> all;
  for (std::size_t n = 0; n < count; ++n) {
    std::size_t rest = n;
    Traces one;
    for (const char* name : {"p", "q"}) {
      for (std::size_t i = 0; i < ticks; ++i, rest /= 3) one[name] += "01?"[rest % 3];
    }
    all.push_back(std::move(one));
  }
  return all;
}

std::string specification(const std::vector<Pair>& pairs) {
  std::string text = "spec small;\nperiod 1 s;\ninput p, q : bool;\n";
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    text += "monitor m" + std::to_string(k) + " { \"E-1: small\" always " +
            text_of(*pairs[k].formula, "") + "; }\n";
  }
  return text;
}

Steps steps_of(const Traces& traces) {
  Steps run;
  for (std::size_t i = 0; i < ticks; ++i) {
    Step step{static_cast<std::int64_t>(i) * second_us, {}};
    for (const char* name : {"p", "q"}) {
      const char value = traces.at(name)[i];
      driver::Observed o{{}, step.now_us, true};
      o.reading.kind =
          value == '?' ? interp::Reading::Kind::unknown : interp::Reading::Kind::number;
      o.reading.number = interp::Decimal(value == '1' ? 1 : 0);
      step.inputs.push_back(o);
    }
    run.push_back(std::move(step));
  }
  return run;
}

class SmallScope : public ::testing::Test {
 protected:
  void SetUp() override {
    pairs_ = formulas();
    traces_ = traces();
    checked_ = check(specification(pairs_), Until::kernel);
    ASSERT_EQ(checked_->problem, "");
  }
  // What is expected is found once for all of them.
  void compare(const std::vector<driver::Engine*>& engines) const {
    std::size_t different = 0;
    for (std::size_t n = 0; n < traces_.size(); ++n) {
      if (!rtac::test::is_due(n)) continue;
      std::vector<std::vector<std::string>> found;
      for (driver::Engine* const engine : engines) {
        engine->restart();
        found.push_back(judge(*engine, steps_of(traces_[n])));
      }
      for (std::size_t k = 0; k < pairs_.size(); ++k) {
        const Trace expected = evaluate_by_runs(*pairs_[k].formula, traces_[n]);
        for (std::size_t e = 0; e < found.size(); ++e) {
          if (found[e][k] == expected || ++different > 3) continue;
          ADD_FAILURE() << "engine " << e << ": " << text_of(*pairs_[k].formula, "") << "\n  p "
                        << traces_[n].at("p") << "\n  q " << traces_[n].at("q") << "\n  expected "
                        << expected << "\n  found    " << found[e][k];
        }
      }
    }
    EXPECT_EQ(different, 0u);
  }

  std::vector<Pair> pairs_;
  std::vector<Traces> traces_;
  std::unique_ptr<Checked> checked_;
};

TEST_F(SmallScope, KernelVerdictsAndReferenceFollowTheDefinitions) {
  const auto code = driver::kernel_code(checked_->compilation);
  const driver::LoadedKernel kernel = load(code, {}, Speed::of_building);
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const driver::LoadedKernel verdicts = load_verdicts(code, {}, Speed::of_building);
  ASSERT_NE(verdicts.engine, nullptr) << verdicts.problem;
  const auto reference = driver::make_interpreter(*checked_->compilation.spec);
  compare({kernel.engine.get(), verdicts.engine.get(), reference.get()});
}

// Every operator meets every other one as its operand, when that is true, false and unknown, and
// every one of both is itself found true, false and unknown.
TEST_F(SmallScope, HasEveryPairOfOperatorsWithEveryValue) {
  std::map<std::tuple<Op, Op, char>, std::size_t> inner, outer;
  for (const Pair& pair : pairs_) {
    if (pair.inner == nullptr) continue;
    for (const Traces& traces : traces_) {
      for (const char value : evaluate_by_runs(*pair.inner, traces)) {
        ++inner[{pair.formula->op, pair.inner->op, value}];
      }
      for (const char value : evaluate_by_runs(*pair.formula, traces)) {
        ++outer[{pair.formula->op, pair.inner->op, value}];
      }
    }
  }
  constexpr std::size_t kinds = static_cast<std::size_t>(Op::within);  // behind `atom`
  EXPECT_EQ(inner.size(), kinds * kinds * 3);
  EXPECT_EQ(outer.size(), kinds * kinds * 3);
}

TEST(SlowTests, AreThere) {
  EXPECT_EQ(rtac::test::slow_tests_gone("differential"), std::set<std::string>{});
}

}  // namespace
}  // namespace rtac::differential
