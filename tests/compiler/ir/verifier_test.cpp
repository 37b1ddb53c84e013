// Each rule that passes rely on: a module that breaks it is found, by what it breaks.
#include "tests/compiler/ir/testing.h"

namespace rtac::ir::test {
namespace {

std::string problem(const Module& module) {
  return verify(module).value_or("");
}
std::string problem_of(Block property) {
  return problem(module_with(std::move(property)));
}

TEST(Verifier, AcceptsAFence) {
  EXPECT_EQ(problem_of(fence(100)), "");
}

TEST(Verifier, TheResultIsAValueOfTheBlock) {
  Block b = fence(100);
  b.result = ValueId{3};
  EXPECT_NE(problem_of(std::move(b)).find("not one of its values"), std::string::npos);
  EXPECT_NE(problem_of(Block{}).find("not one of its values"), std::string::npos);
}

TEST(Verifier, TheResultIsAMargin) {
  Block b = fence(100);
  b.result = ValueId{0};
  EXPECT_NE(problem_of(std::move(b)).find("not a margin"), std::string::npos);
}

TEST(Verifier, AValueIsComputedBeforeItIsUsed) {
  BlockMaker b;
  const ValueId gap = b.quantity(Clearance{ZoneIndex{0}});
  EXPECT_NE(problem_of(b.done(b.margin(AtLeast{gap, ValueId{1}, false}))).find("before"),
            std::string::npos);
}

TEST(Verifier, AQuantityHasAUnitAndAMarginHasNone) {
  BlockMaker a;
  a.margin(Const{1});
  EXPECT_NE(problem_of(a.done(a.margin(Truth{true}))).find("without a unit"), std::string::npos);
  BlockMaker b;
  b.quantity(Truth{true});
  EXPECT_NE(problem_of(b.done(b.margin(Truth{true}))).find("with a unit"), std::string::npos);
}

// An age says nothing of what is within reach: a fact has it, once a tick.
TEST(Verifier, AgesOfMeasurementsAreOfFacts) {
  BlockMaker b;
  const ValueId age = b.quantity(SensedAge{Sensed::position});
  EXPECT_NE(problem_of(b.done(b.margin(AtLeast{age, age, false}))).find("in a decision"),
            std::string::npos);
}

TEST(Verifier, AZoneThatIsReceivedIsOneOfTheDecision) {
  const auto problem_with = [](std::vector<Received> received, ChannelKind kind, bool on_plan) {
    BlockMaker b;
    const ValueId gap = b.quantity(ReceivedClearance{ReceivedIndex{0}});
    const ValueId least = b.quantity(Const{100});
    b.margin(ReceivedReach{ReceivedIndex{0}, 100});
    Module m = module_with(b.done(b.margin(AtLeast{gap, least, false})));
    Watch& facts = m.decisions[0].facts;
    facts.period_us = 100'000;
    Channel channel;
    channel.name = "fence";
    channel.kind = kind;
    channel.components = {""};
    channel.held = true;
    channel.edges_most = 8;
    facts.inputs.push_back(channel);
    facts.received = std::move(received);
    m.decisions[0].on_plan = on_plan;
    return problem(m);
  };
  const Received fence{"fence", 0, false}, other{"fence", 1, true};
  EXPECT_EQ(problem_with({fence}, ChannelKind::zone, false), "");
  EXPECT_NE(problem_with({}, ChannelKind::zone, false).find("no such zone that is received"),
            std::string::npos);
  for (const Received& wrong : {fence, other}) {
    const ChannelKind kind = wrong.channel == 0 ? ChannelKind::truth : ChannelKind::zone;
    EXPECT_NE(problem_with({wrong}, kind, false).find("by an input that is none"),
              std::string::npos);
  }
  EXPECT_NE(problem_with({fence}, ChannelKind::zone, true), "");
}

TEST(Verifier, UnitsOfOperandsAgree) {
  BlockMaker b;
  const ValueId gap = b.quantity(Clearance{ZoneIndex{0}});
  const ValueId charge = b.quantity(Battery{}, Unit::ppm);
  EXPECT_NE(problem_of(b.done(b.margin(AtLeast{gap, charge, false}))).find("units differ"),
            std::string::npos);
  BlockMaker c;
  const ValueId one = c.quantity(Const{1});
  const ValueId margin = c.margin(Truth{true});
  c.quantity(Add{one, margin});
  EXPECT_NE(problem_of(c.done(margin)).find("units differ"), std::string::npos);
}

TEST(Verifier, ConnectivesTakeMargins) {
  BlockMaker b;
  const ValueId one = b.quantity(Const{1});
  const ValueId truth = b.margin(Truth{true});
  EXPECT_NE(problem_of(b.done(b.margin(And{truth, one}))).find("connective"), std::string::npos);
  BlockMaker c;
  const ValueId two = c.quantity(Const{2});
  EXPECT_NE(problem_of(c.done(c.margin(Not{two}))).find("connective"), std::string::npos);
}

TEST(Verifier, AFactorHasAPositiveDenominator) {
  BlockMaker b;
  const ValueId gap = b.quantity(Clearance{ZoneIndex{0}});
  const ValueId scaled = b.quantity(Scale{gap, 1, 0});
  EXPECT_NE(problem_of(b.done(b.margin(AtLeast{scaled, gap, false}))).find("denominator"),
            std::string::npos);
}

TEST(Verifier, TablesExist) {
  BlockMaker b;
  const ValueId gap = b.quantity(Clearance{ZoneIndex{1}});
  EXPECT_NE(problem_of(b.done(b.margin(AtLeast{gap, gap, false}))).find("no such zone"),
            std::string::npos);
  BlockMaker c;
  EXPECT_NE(problem_of(c.done(c.margin(EnergyReach{SiteIndex{1}, 0}))).find("no such site"),
            std::string::npos);
}

// A kernel reads it at the cell where a robot is, whatever is there.
TEST(Verifier, AWayHasAPriceForEachCell) {
  const auto of = [](std::size_t prices) {
    BlockMaker b;
    Module m = module_with(b.done(b.margin(EnergyReach{SiteIndex{0}, 0})));
    m.zones[0].cells.clearance_mm_lo = {100, 200, 300};
    m.sites[0].places.push_back({"one", 0, 0, std::vector<std::int32_t>(prices)});
    return verify(m).value_or("");
  };
  EXPECT_EQ(of(3), "");
  for (const std::size_t few : {0, 2}) {
    EXPECT_NE(of(few).find("a way without a price"), std::string::npos) << of(few);
  }
}

TEST(Verifier, SchedulesExistAndLookForward) {
  BlockMaker b;
  EXPECT_NE(problem_of(b.done(b.margin(ZoneThere{ScheduleIndex{0}}))).find("no such schedule"),
            std::string::npos);
  BlockMaker c;
  EXPECT_NE(problem_of(c.done(c.margin(GoneThroughout{ScheduleIndex{0}, -1}))).find("no such"),
            std::string::npos);
  Module m = module_with(fence(100));
  m.decisions[0].facts.schedules.push_back({"fair", {{5, 4}}, {}});
  EXPECT_NE(problem(m).find("out of order"), std::string::npos);
}

TEST(Verifier, NamesOfTablesDiffer) {
  Module m = module_with(fence(100));
  m.zones.push_back(m.zones[0]);
  EXPECT_NE(problem(m).find("two zones named room"), std::string::npos);
  Module n = module_with(fence(100));
  n.sites.push_back(n.sites[0]);
  EXPECT_NE(problem(n).find("two sites named dock"), std::string::npos);
}

TEST(Verifier, AnotherRobotStandsInsideAQuantifierOnly) {
  BlockMaker b;
  const ValueId gap = b.quantity(Distance{});
  EXPECT_NE(problem_of(b.done(b.margin(AtLeast{gap, gap, false}))).find("another robot"),
            std::string::npos);
  BlockMaker c;
  EXPECT_NE(problem_of(c.done(c.margin(PairReach{0}))).find("another robot"), std::string::npos);
  BlockMaker d;
  EXPECT_NE(problem_of(d.done(d.margin(LegsApart{1, 0, false}))).find("another robot"),
            std::string::npos);
}

Block others(Block body) {
  BlockMaker b;
  return b.done(b.margin(ForOthers{true, std::make_unique<Block>(std::move(body))}));
}

TEST(Verifier, QuantifiersAreCheckedInsideAndDoNotNest) {
  BlockMaker good;
  const ValueId gap = good.quantity(Distance{});
  EXPECT_EQ(problem_of(others(good.done(good.margin(AtLeast{gap, gap, false})))), "");
  Block wrong = fence(100);
  wrong.result = ValueId{9};
  EXPECT_NE(problem_of(others(std::move(wrong))), "");
  EXPECT_NE(problem_of(others(others(fence(100)))).find("inside for_others"), std::string::npos);
}

TEST(Verifier, ARunOfTicksHasItsSlotInTheState) {
  BlockMaker b;
  const ValueId truth = b.margin(Truth{true});
  Module m = module_with(fence(100));
  m.decisions[0].monitors[0].return_when = b.done(b.margin(HeldFor{truth, 5, 0}));
  EXPECT_NE(problem(m).find("slot"), std::string::npos);
  m.decisions[0].held_slots = 1;
  EXPECT_EQ(problem(m), "");
}

TEST(Verifier, APlanIsJudgedByADecisionOnPlansOnly) {
  BlockMaker b;
  Module m = module_with(b.done(b.margin(PlanInZone{ZoneIndex{0}})));
  EXPECT_NE(problem(m).find("periodic"), std::string::npos);
  m.decisions[0].on_plan = true;
  EXPECT_EQ(problem(m), "");
}

TEST(Verifier, EveryRecoveryHasAMotion) {
  Module m = module_with(fence(100));
  m.decisions[0].motions.pop_back();
  EXPECT_NE(problem(m).find("one motion per recovery"), std::string::npos);
}

TEST(Verifier, LooksAtEveryBlockOfAMonitor) {
  Block wrong = fence(100);
  wrong.result = ValueId{0};
  Module m = module_with(fence(100));
  m.decisions[0].monitors[0].ahead = std::move(wrong);
  EXPECT_NE(problem(m), "");
}

}  // namespace
}  // namespace rtac::ir::test
