// Quantifiers over fleets, which kernels run as loops: each says what the same property says that
// is written out robot by robot, to the last bit of its margins, and the reference agrees.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "compiler/driver/replay.h"
#include "tests/differential/engines.h"
#include "tests/differential/traces.h"

namespace rtac::differential {
namespace {

constexpr std::size_t robots = 6, steps = 200;

std::string replaced(std::string text, char variable, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(variable, at)) != std::string::npos; at += by.size()) {
    text.replace(at, 1, by);
  }
  return text;
}
std::string bot(std::size_t index) {
  return "bots[" + std::to_string(index) + "]";
}
// One for each robot but those that are left out, in brackets.
using Each = std::function<std::string(std::size_t)>;
std::string joined(const std::string& by, std::size_t first_left_out, const Each& each) {
  std::string text;
  for (std::size_t k = 0; k < robots; ++k) {
    if (k == first_left_out) continue;
    text += (text.empty() ? "(" : by) + ("(" + each(k) + ")");
  }
  return text + ")";
}

struct Property {
  std::string quantified, written_out;
};
// `P`, `Q` in the bodies stand for robots.
std::vector<Property> over_one() {
  const std::string bodies[] = {
      "P.battery >= 30 %",
      "distance(P, gate) >= 50 cm and P.battery > 20 %",
      "P.battery >= 30 % or distance(P, gate) < 1 m",
      "P inside yard and not P.speed > 0.5 m/s",
      "clearance(P, yard) >= 20 cm",
      "once[0 s, 3 s](P.battery >= 30 %) and P.battery > 10 %",
      "P.battery >= 30 % since[0 s, 4 s] distance(P, gate) >= 1 m",
      "max[0 s, 2 s](P.speed) + 0.1 m/s <= 0.6 m/s",
      "age(P.position) <= 500 ms and P.battery >= 20 %",
      "open and P.battery >= 30 %",
      "mode == busy or P.battery >= 30 %",
  };
  std::vector<Property> all;
  for (const std::string& body : bodies) {
    const auto of = [&](std::size_t k) { return replaced(body, 'P', bot(k)); };
    const std::string quantified = replaced(body, 'P', "p");
    const auto choice = [&](std::size_t k) { return "if " + of(k) + " then 1 else 0"; };
    all.push_back({"forall p : Rover : " + quantified, joined(" and ", robots, of)});
    all.push_back({"exists p : Rover : " + quantified, joined(" or ", robots, of)});
    all.push_back(
        {"not exists p : Rover, p != bots[2] : " + quantified, "not " + joined(" or ", 2, of)});
    all.push_back(
        {"count(p : Rover : " + quantified + ") >= 3", joined(" + ", robots, choice) + " >= 3"});
    all.push_back({"open implies forall p : Rover : " + quantified,
                   "open implies " + joined(" and ", robots, of)});
    all.push_back({"historically[0 s, 2 s] (exists p : Rover : " + quantified + ")",
                   "historically[0 s, 2 s] " + joined(" or ", robots, of)});
  }
  return all;
}
std::vector<Property> over_two() {
  std::vector<Property> all;
  const std::string bodies[] = {
      "distance(P, Q) >= 50 cm",
      "P.battery >= Q.battery - 10 % or distance(P, Q) > 1 m",
      "once[0 s, 2 s](distance(P, Q) >= 1 m)",
      "P.speed <= 0.5 m/s and Q.battery + P.battery >= 50 %",
  };
  for (const std::string& body : bodies) {
    const auto pair = [&](std::size_t p, std::size_t q) {
      return replaced(replaced(body, 'P', bot(p)), 'Q', bot(q));
    };
    const auto inner = [&](const std::string& by) {
      return
          [=](std::size_t p) { return joined(by, p, [&](std::size_t q) { return pair(p, q); }); };
    };
    const std::string quantified = replaced(replaced(body, 'P', "p"), 'Q', "q");
    const std::string others = " q : Rover, q != p : " + quantified;
    all.push_back({"forall p : Rover : forall" + others, joined(" and ", robots, inner(" and "))});
    all.push_back({"forall p : Rover : exists" + others, joined(" and ", robots, inner(" or "))});
    all.push_back({"exists p : Rover : (forall" + others + ") or p.battery >= 90 %",
                   joined(" or ", robots, [&](std::size_t p) {
                     return inner(" and ")(p) + " or " + bot(p) + ".battery >= 90 %";
                   })});
    all.push_back(
        {"forall p : Rover : count(" + others.substr(1) + ") <= 4",
         joined(" and ", robots, [&](std::size_t p) {
           return joined(" + ", p,
                         [&](std::size_t q) { return "if " + pair(p, q) + " then 1 else 0"; }) +
                  " <= 4";
         })});
  }
  return all;
}
// Nested calls, as there are no more than two operands written at once.
std::string folded(const std::string& function, const Each& each) {
  std::string text = each(0);
  for (std::size_t k = 1; k < robots; ++k) text = function + "(" + text + ", " + each(k) + ")";
  return text;
}
std::vector<Property> of_quantities() {
  std::vector<Property> all;
  const std::pair<std::string, std::string> compared[] = {
      {"distance(P, gate)", " <= 80 cm"},
      {"distance(P, gate) - h", " > 60 cm"},  // raising h tightens
      {"abs(P.battery - 50 %)", " > 20 %"},
      {"P.speed * 2", " <= 90 cm/s"},
  };
  for (const std::string function : {"min", "max"}) {
    for (const auto& [body, limit] : compared) {
      const std::string fold = function + "(p : Rover : " + replaced(body, 'P', "p") + ")";
      const std::string folds =
          folded(function, [&body = body](std::size_t k) { return replaced(body, 'P', bot(k)); });
      // a comparison of all is that of each (rule 4.6)
      const bool is_any = (function == "min") == (limit[1] == '<');
      const std::string each =
          joined(is_any ? " or " : " and ", robots, [&body = body, &limit = limit](std::size_t k) {
            return replaced(body, 'P', bot(k)) + limit;
          });
      all.push_back({fold + limit, each});
      all.push_back({"previously (" + fold + limit + ")", "previously " + each});
      all.push_back(
          {"min[0 s, 2 s](" + fold + ")" + limit, "min[0 s, 2 s](" + folds + ")" + limit});
    }
  }
  return all;
}

std::string specification(const std::vector<Property>& properties) {
  std::string text = R"(spec s;
period 1 s;
enum Mode { idle, busy }
robot Rover {
  body    radius 10 cm;
  motion  point { speed <= 1 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense   position : point  error 1 cm   max_age 1500 ms;
  sense   velocity : vector error 1 cm/s max_age 1500 ms;
  sense   battery  : ratio  error 1 %    max_age 1500 ms;
  output  push : acceleration;
  latency 20 ms;
}
fleet bots : Rover[6];
zone yard = rectangle (-1.5 m, -1.5 m) to (1.5 m, 1.5 m) - circle (0 m, 0 m) radius 40 cm;
input gate : point in -2 .. 2 m max_age inf;
input open : bool max_age inf;
input mode : Mode max_age inf;
param h : length in 0 m .. 0.3 m = 0.1 m;
)";
  for (std::size_t k = 0; k < properties.size(); ++k) {
    const std::string number = std::to_string(k);
    text += "monitor q" + number + " { \"R1: loops\" always " + properties[k].quantified + "; }\n";
    text += "monitor w" + number + " { \"R2: lines\" always " + properties[k].written_out + "; }\n";
  }
  return text;
}

// By what the specification has as inputs: those of robots among them.
std::vector<Signal> signals_of_fleet(const sema::Spec& spec) {
  std::vector<Signal> all;
  for (const sema::Input& input : spec.inputs) {
    Signal s{input.name,
             "",
             Signal::Kind::quantity,
             input.components.size(),
             -2'000'000,
             2'000'000,
             true,
             "",
             1000,
             0,
             ""};
    const bool is_charge = input.name.find("battery") != std::string::npos;
    const bool is_velocity = input.name.find("velocity") != std::string::npos;
    if (is_charge) s.least = 0, s.most = 1'000'000, s.error = 10'000;
    if (is_velocity) s.least = -700'000, s.most = 700'000;
    if (!is_charge && input.robot) s.error = 10'000;
    if (input.name == "open") s.kind = Signal::Kind::truth;
    if (input.enumeration) s.kind = Signal::Kind::choice;
    all.push_back(s);
  }
  return all;
}

class Members : public ::testing::TestWithParam<int> {
 protected:
  static std::vector<Property> properties() {
    return GetParam() == 0 ? over_one() : GetParam() == 1 ? over_two() : of_quantities();
  }
  void SetUp() override {
    properties_ = properties();
    checked_ = check(specification(properties_), Until::kernel);
    ASSERT_EQ(checked_->problem, "");
    code_ = driver::kernel_code(checked_->compilation);
    Troubles troubles;
    std::mt19937 random(unsigned(GetParam()) + 1);
    const sema::Spec& spec = *checked_->compilation.spec;
    run_ = random_run(random, steps, signals_of_fleet(spec), spec.params, troubles);
  }
  std::vector<Property> properties_;
  std::unique_ptr<Checked> checked_;
  driver::KernelCode code_;
  Steps run_;
};

TEST_P(Members, SayWhatIsSaidOfEachOne) {
  const driver::LoadedKernel kernel = load(code_, {}, Speed::of_building);
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const Findings found = find(*kernel.engine, code_.interface, run_);
  const auto interpreter = driver::make_interpreter(*checked_->compilation.spec);
  const std::vector<std::string> exact = judge(*interpreter, run_);
  std::size_t decided = 0;
  for (std::size_t k = 0; k < properties_.size(); ++k) {
    SCOPED_TRACE(properties_[k].quantified);
    for (std::size_t step = 0; step < run_.size(); ++step) {
      const Finding &loop = found[2 * k][step], &lines = found[2 * k + 1][step];
      ASSERT_EQ(loop.verdict, lines.verdict) << "step " << step;
      ASSERT_TRUE(compare(loop.lo, lines.lo) == 0 && compare(loop.hi, lines.hi) == 0)
          << "step " << step;
      if (loop.verdict == '?') continue;
      ++decided;
      ASSERT_EQ(loop.verdict, exact[2 * k][step]) << "step " << step;
    }
  }
  EXPECT_GT(decided, properties_.size() * run_.size() / 5);
}

TEST_P(Members, AreJudgedAlikeByTheEntryForVerdicts) {
  const driver::LoadedKernel whole = load(code_, {}, Speed::of_building);
  const driver::LoadedKernel alone = load_verdicts(code_, {}, Speed::of_building);
  ASSERT_NE(whole.engine, nullptr) << whole.problem;
  ASSERT_NE(alone.engine, nullptr) << alone.problem;
  const std::vector<std::string> first = judge(*whole.engine, run_),
                                 second = judge(*alone.engine, run_);
  for (std::size_t k = 0; k < properties_.size(); ++k) {
    EXPECT_EQ(first[2 * k], second[2 * k]) << properties_[k].quantified;
  }
}

// Quantifiers are the same text for each robot; what is written out is not.
TEST_P(Members, AreLoopsInTheKernel) {
  std::string text;
  for (const driver::OutputFile& file : code_.files) {
    if (file.path == code_.interface.source) text = file.text;
  }
  std::size_t loops = 0;
  for (std::size_t k = 0; k < properties_.size(); ++k) {
    const std::string number = std::to_string(k);
    loops += text.find(" q" + number + "_now_all_0(") != std::string::npos ? 1 : 0;
    EXPECT_EQ(text.find(" w" + number + "_now_all_0("), std::string::npos)
        << properties_[k].written_out;
  }
  EXPECT_GT(loops, properties_.size() / 2);
}

// 128 robots have 16,256 pairs: their text would be 11 MB, one by one.
TEST(LargeFleets, HaveSmallKernels) {
  std::string text =
      specification({{"forall p : Rover : forall q : Rover, q != p : "
                      "distance(p, q) >= 50 cm",
                      "open"}});
  text.replace(text.find("Rover[6]"), 8, "Rover[128]");
  const auto checked = check(text, Until::kernel);
  ASSERT_EQ(checked->problem, "");
  const driver::KernelCode code = driver::kernel_code(checked->compilation);
  for (const driver::OutputFile& file : code.files) EXPECT_LT(file.text.size(), 700'000u);
  const driver::LoadedKernel kernel = load(code, {}, Speed::of_building);
  EXPECT_NE(kernel.engine, nullptr) << kernel.problem;
}

INSTANTIATE_TEST_SUITE_P(All, Members, ::testing::Values(0, 1, 2));

}  // namespace
}  // namespace rtac::differential
