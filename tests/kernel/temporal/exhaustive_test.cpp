// Small scope, whole: every trace up to a length over false, unknown and true, every small window.
#include <cmath>

#include "tests/kernel/temporal/reference.h"
#include "tests/slow.h"

namespace rtac::temporal_test {
namespace {

// Trace number `n` over the given truth values.
History trace(std::int64_t n, std::size_t length, const std::vector<int>& over) {
  History x;
  for (std::size_t i = 0; i < length; ++i) {
    x.push_back(truth(over[std::size_t(n) % over.size()]));
    n /= std::int64_t(over.size());
  }
  return x;
}
std::int64_t traces(std::size_t length, std::size_t over) {
  return std::int64_t(std::pow(double(over), double(length)) + 0.5);
}

struct Pair {
  Operator verdicts, margins;
};

// Of atoms without a margin, verdicts and margins are the same thing.
void compare(Pair& ops, std::int32_t kind, const History& a, const History& b, const Window& w) {
  ops.verdicts.start();
  ops.margins.start();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const probe_value want = past(kind, a, b, std::int64_t(i), w);
    const probe_value bare = ops.verdicts.step(a[i], b[i]), full = ops.margins.step(a[i], b[i]);
    ASSERT_EQ(verdict(bare), verdict(want)) << w << " at " << i;
    ASSERT_EQ(bare.lo, want.lo) << w << " at " << i;
    ASSERT_EQ(bare.hi, want.hi) << w << " at " << i;
    ASSERT_EQ(full.lo, want.lo) << w << " at " << i;
    ASSERT_EQ(full.hi, want.hi) << w << " at " << i;
  }
}

void all_of_one(std::int32_t kind) {
  for (const Window& w : windows(4)) {
    Pair ops{Operator(kind, w, false), Operator(kind, w, true)};
    for (std::int64_t n = 0; n < traces(7, 3); ++n) {
      const History x = trace(n, 7, {0, 1, 2});
      compare(ops, kind, x, x, w);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}
// All pairs of traces up to a length, as a tree: what they have in common is evaluated once.
class AllOfTwo {
 public:
  AllOfTwo(const Window& w, std::size_t length) : w_(w) {
    for (std::size_t i = 0; i <= length; ++i) {
      ops_.push_back({Operator(PROBE_SINCE, w, false), Operator(PROBE_SINCE, w, true)});
    }
  }
  void run(const std::vector<int>& over) {
    const std::size_t now = a_.size();
    if (now + 1 == ops_.size()) return;
    for (const int a : over) {
      for (const int b : over) {
        a_.push_back(truth(a));
        b_.push_back(truth(b));
        ASSERT_NO_FATAL_FAILURE(step(now));
        run(over);
        if (testing::Test::HasFatalFailure()) return;
        a_.pop_back();
        b_.pop_back();
      }
    }
  }

 private:
  void step(std::size_t now) {
    Pair& next = ops_[now + 1];
    next.verdicts.take(ops_[now].verdicts);
    next.margins.take(ops_[now].margins);
    const probe_value want = since(a_, b_, std::int64_t(now), w_);
    const probe_value bare = next.verdicts.step(a_[now], b_[now]);
    const probe_value full = next.margins.step(a_[now], b_[now]);
    const bool same =
        bare.lo == want.lo && bare.hi == want.hi && full.lo == want.lo && full.hi == want.hi;
    ASSERT_TRUE(same) << w_ << " at " << now;
  }

  const Window w_;
  std::vector<Pair> ops_;  // by the number of ticks that they have seen
  History a_, b_;
};
void all_of_two(std::size_t length, const std::vector<int>& over) {
  for (const Window& w : windows(4)) {
    AllOfTwo all(w, length);
    ASSERT_NO_FATAL_FAILURE(all.run(over));
  }
}

TEST(Exhaustive, OnceIsSomeTickOfTheWindow) {
  // Rule 2: nothing of an empty window; [0, 0] is now.
  all_of_one(PROBE_ONCE);
}

TEST(Exhaustive, HistoricallyIsEveryTickOfTheWindow) {
  // Rule 2: true of an empty window.
  all_of_one(PROBE_HISTORICALLY);
}

TEST(Exhaustive, PreviouslyIsTheTickBeforeAndFalseAtFirst) {
  // Rule 2; its window says nothing.
  Pair ops{Operator(PROBE_PREVIOUSLY, {}, false), Operator(PROBE_PREVIOUSLY, {}, true)};
  for (std::int64_t n = 0; n < traces(7, 3); ++n) {
    const History x = trace(n, 7, {0, 1, 2});
    ASSERT_NO_FATAL_FAILURE(compare(ops, PROBE_PREVIOUSLY, x, x, {}));
  }
}

TEST(Exhaustive, SinceNeedsAllTicksAfterTheWitness) {
  // Rule 2: the tick of the witness itself is free, the present one is not.
  all_of_two(7, {0, 2});
}

TEST(Exhaustive, SinceOfUnknownsIsTwoBooleanRuns) {
  // Rule 3: what must be and what may be, each with its own stamps.
  all_of_two(5, {0, 1, 2});
}

TEST(ExhaustiveAtLength, SinceOfUnknowns) {
  // The same for all five million pairs of traces of length 7.
  all_of_two(7, {0, 1, 2});
}

TEST(SlowTests, AreThere) {
  EXPECT_EQ(rtac::test::slow_tests_gone("temporal"), std::set<std::string>{});
}

}  // namespace
}  // namespace rtac::temporal_test
