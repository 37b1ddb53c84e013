// Each pass alone, on modules built by hand: what it turns into what, and what it refuses.
#include "compiler/diagnostics/engine.h"
#include "compiler/passes/analyse_ranges.h"
#include "compiler/passes/expand_lookahead.h"
#include "compiler/passes/pipeline.h"
#include "compiler/passes/share_values.h"
#include "tests/compiler/ir/testing.h"

namespace rtac::passes {
namespace {

using namespace ir;
using ir::test::BlockMaker;
using ir::test::fence;
using ir::test::module_with;

struct Expanded {
  Module module;
  diag::Engine diagnostics;
  std::string text() const {
    return print(module, &module.decisions[0].facts, *module.decisions[0].monitors[0].ahead, "");
  }
};

Expanded expand(Block property, Lookahead look = {true, 200'000, 2, false},
                RecoveryKind recovery = RecoveryKind::route, bool acknowledged = false) {
  Expanded e{module_with(std::move(property)), {}};
  e.module.decisions[0].monitors[0].lookahead = look;
  e.module.decisions[0].monitors[0].recovery.kind = recovery;
  e.module.decisions[0].monitors[0].recovery.charges = recovery == RecoveryKind::route;
  if (acknowledged) e.module.decisions[0].acknowledgements = {{"turn_back", "walls", "a test"}};
  e.module.decisions[0].hold_reserve_ppm = 1000;
  expand_lookahead(e.module, e.diagnostics);
  return e;
}
std::string first_code(const diag::Engine& engine) {
  return engine.all().empty() ? "" : diag::info(engine.all()[0].code).name;
}

// 151 = radius 100 + tracking 50 + 1 for rounded way-points.
TEST(ExpandLookahead, AFenceIsJudgedWithinReachAndOnLegs) {
  EXPECT_EQ(expand(fence(30)).text(),
            "%0 = zone_reach room, least 30 : margin\n"
            "%1 = legs_in_zone room, legs 2, need 181 : margin\n"
            "%2 = and %0, %1 : margin\n"
            "%3 = on_track within 50 : margin\n"
            "%4 = and %2, %3 : margin\nresult %4\n");
}

TEST(ExpandLookahead, AStrictFenceKeepsOneStepMore) {
  EXPECT_NE(expand(fence(30, true)).text().find("zone_reach room, least 31"), std::string::npos);
}

TEST(ExpandLookahead, WithoutWaypointsThereAreNoLegs) {
  EXPECT_EQ(expand(fence(30), {true, 200'000, 0, false}).text(),
            "%0 = zone_reach room, least 30 : margin\nresult %0\n");
}

TEST(ExpandLookahead, PointsOnlyLeavesTheTrackingOut) {
  EXPECT_EQ(expand(fence(30), {false, 0, 1, true}).text(),
            "%0 = points_in_zone room, points 1, need 130 : margin\nresult %0\n");
}

// not there, or far enough: gone for as long as the recovery takes, from where it knows a way.
TEST(ExpandLookahead, AZoneThatComesIsGoneUntilTheRecoveryHasLedOut) {
  const auto ahead = [](RecoveryKind recovery, bool keeps_out) {
    BlockMaker b;
    const ValueId gap = b.quantity(Clearance{ZoneIndex{0}});
    const ValueId least = b.quantity(Const{30});
    const ValueId far = b.margin(AtLeast{gap, least, false});
    const ValueId there = b.margin(ZoneThere{ScheduleIndex{0}});
    const ValueId wanted =
        keeps_out ? b.margin(Or{b.margin(Not{there}), far}) : b.margin(And{there, far});
    Expanded e{module_with(b.done(wanted)), {}};
    Decision& d = e.module.decisions[0];
    d.facts.schedules.push_back({"fair", {}, {}});
    d.monitors[0].lookahead = {true, 200'000, 0, false};
    d.monitors[0].recovery.kind = recovery;
    d.monitors[0].recovery.leave_us = 7'000'000;
    d.monitors[0].recovery.leave_least_mm = 90;
    expand_lookahead(e.module, e.diagnostics);
    return e.text();
  };
  EXPECT_EQ(ahead(RecoveryKind::route, true),
            "%0 = gone_throughout fair, after 7000000 : margin\n"
            "%1 = zone_reach room, least 90 : margin\n"
            "%2 = and %0, %1 : margin\n"
            "%3 = zone_reach room, least 30 : margin\n"
            "%4 = or %2, %3 : margin\nresult %4\n");
  EXPECT_EQ(ahead(RecoveryKind::retreat, false),
            "%0 = there_throughout fair, after 7000000 : margin\n"
            "%1 = zone_reach room, least 30 : margin\n"
            "%2 = and %0, %1 : margin\nresult %2\n");
}

// 2 * speed + 5 <= 15, in mm/s: speed <= 5; strictly: 4.
TEST(ExpandLookahead, ASpeedIsAtMostSomething) {
  const auto ahead = [](bool at_most, bool strict) {
    BlockMaker b;
    const ValueId speed = b.quantity(Speed{}, Unit::mmps);
    const ValueId twice = b.quantity(Scale{speed, 2, 1}, Unit::mmps);
    const ValueId more = b.quantity(Add{twice, b.quantity(Const{5}, Unit::mmps)}, Unit::mmps);
    const ValueId limit = b.quantity(Const{15}, Unit::mmps);
    return expand(
        b.done(b.margin(at_most ? AtLeast{limit, more, strict} : AtLeast{more, limit, strict})));
  };
  EXPECT_EQ(ahead(true, false).text(), "%0 = speed_reach most 5 : margin\nresult %0\n");
  EXPECT_EQ(ahead(true, true).text(), "%0 = speed_reach most 4 : margin\nresult %0\n");
  EXPECT_EQ(ahead(true, false).module.decisions[0].monitors[0].unit, Unit::mmps);
  EXPECT_EQ(first_code(ahead(false, false).diagnostics), "atom_without_transformer");
}

// 3 * gap - 10 >= 15, that is gap >= 25/3: rounded up.
TEST(ExpandLookahead, LinearFormsEndAsOneLeastValueRoundedUp) {
  BlockMaker b;
  const ValueId gap = b.quantity(Clearance{ZoneIndex{0}});
  const ValueId three = b.quantity(Scale{gap, 3, 1});
  const ValueId ten = b.quantity(Const{10});
  const ValueId less = b.quantity(Negate{ten});
  const ValueId left = b.quantity(Add{three, less});
  const ValueId right = b.quantity(Const{15});
  EXPECT_NE(expand(b.done(b.margin(AtLeast{left, right, false}))).text().find("least 9 "),
            std::string::npos);
}

TEST(ExpandLookahead, AConstantLeastValueMayBeWrittenOnTheLeftOfASum) {
  // -5 >= -gap, that is gap >= 5
  BlockMaker b;
  const ValueId gap = b.quantity(Clearance{ZoneIndex{0}});
  const ValueId minus = b.quantity(Negate{gap});
  const ValueId five = b.quantity(Const{-5});
  EXPECT_NE(expand(b.done(b.margin(AtLeast{five, minus, false}))).text().find("least 5 "),
            std::string::npos);
}

Block separation(std::int64_t least_mm) {
  BlockMaker body;
  const ValueId gap = body.quantity(Distance{});
  const ValueId least = body.quantity(Const{least_mm});
  Block inner = body.done(body.margin(AtLeast{gap, least, false}));
  BlockMaker b;
  return b.done(b.margin(ForOthers{true, std::make_unique<Block>(std::move(inner))}));
}

// 332 = two radii, 80, tracking 50, and 2 for rounded way-points of both.
TEST(ExpandLookahead, ASeparationIsJudgedInsideTheQuantifierAndRemembered) {
  const Expanded e = expand(separation(80));
  EXPECT_EQ(e.text(),
            "%0 = for_all_others : margin\n"
            "  %0 = pair_reach least 80 : margin\n"
            "  %1 = legs_apart legs 2, need 332 : margin\n"
            "  %2 = and %0, %1 : margin\n  result %2\n"
            "%1 = on_track within 50 : margin\n"
            "%2 = and %0, %1 : margin\nresult %2\n");
  EXPECT_EQ(e.module.decisions[0].monitors[0].separation_mm, 80);
  EXPECT_EQ(e.module.decisions[0].monitors[0].unit, Unit::mm);
}

TEST(ExpandLookahead, TheChargeForAWayKeepsTheReserveForHoldsToo) {
  BlockMaker b;
  const ValueId charge = b.quantity(Battery{}, Unit::ppm);
  const ValueId way = b.quantity(EnergyTo{SiteIndex{0}}, Unit::ppm);
  const ValueId five = b.quantity(Const{50'000}, Unit::ppm);
  const ValueId due = b.quantity(Add{way, five}, Unit::ppm);
  const Expanded e = expand(b.done(b.margin(AtLeast{charge, due, true})));
  EXPECT_EQ(e.text(), "%0 = energy_reach dock, reserve 51001 : margin\nresult %0\n");
  EXPECT_EQ(e.module.decisions[0].monitors[0].unit, Unit::ppm);
}

Block charge_of(std::int64_t least_ppm, bool strict = false) {
  BlockMaker b;
  const ValueId charge = b.quantity(Battery{}, Unit::ppm);
  const ValueId least = b.quantity(Const{least_ppm}, Unit::ppm);
  return b.done(b.margin(AtLeast{charge, least, strict}));
}
constexpr Lookahead no_waypoints{true, 200'000, 0, false};

// The recovery drives to the dock from wherever the charge stops sufficing: 20 % must be left
// there.
TEST(ExpandLookahead, AConstantChargeKeepsTheWayOfItsRecoveryInReserve) {
  const Expanded e = expand(charge_of(200'000), no_waypoints);
  EXPECT_EQ(e.text(), "%0 = energy_reach dock, reserve 201000 : margin\nresult %0\n");
  EXPECT_TRUE(e.diagnostics.all().empty());
  EXPECT_NE(expand(charge_of(200'000, true), no_waypoints).text().find("201001"),
            std::string::npos);
}

// A retreat, a yield or an external recovery spends charge that no table bounds.
TEST(ExpandLookahead, AChargeThatTheRecoverySpendsUncountedIsRefused) {
  for (const RecoveryKind kind :
       {RecoveryKind::retreat, RecoveryKind::yield, RecoveryKind::external}) {
    const Expanded e = expand(charge_of(200'000), no_waypoints, kind);
    EXPECT_EQ(first_code(e.diagnostics), "recovery_spends_charge");
    EXPECT_NE(e.diagnostics.all()[0].help.find("acknowledge turn_back may break walls"),
              std::string::npos);
  }
}

TEST(ExpandLookahead, AChargeThatTheRecoveryMayBreakIsLookedAheadAlone) {
  const Expanded e = expand(charge_of(200'000), no_waypoints, RecoveryKind::retreat, true);
  EXPECT_EQ(e.text(), "%0 = charge_reach least 200000 : margin\nresult %0\n");
  EXPECT_TRUE(e.diagnostics.all().empty());
}

// The charge for the way to one site says nothing of the way to another one.
TEST(ExpandLookahead, TheChargeForAWayNeedsARecoveryThatDrivesIt) {
  BlockMaker b;
  const ValueId charge = b.quantity(Battery{}, Unit::ppm);
  const ValueId way = b.quantity(EnergyTo{SiteIndex{0}}, Unit::ppm);
  Expanded e{module_with(b.done(b.margin(AtLeast{charge, way, false}))), {}};
  e.module.sites.push_back(e.module.sites[0]);
  Recovery& recovery = e.module.decisions[0].monitors[0].recovery;
  recovery.kind = RecoveryKind::route;
  recovery.charges = true;
  recovery.site = SiteIndex{1};
  expand_lookahead(e.module, e.diagnostics);
  EXPECT_EQ(first_code(e.diagnostics), "recovery_spends_charge");
}

// language, rule 6.7: where nobody charges the robot idling takes what is left.
TEST(ExpandLookahead, AWayToWhereNobodyChargesIsRefused) {
  Expanded e{module_with(charge_of(200'000)), {}};
  Recovery& recovery = e.module.decisions[0].monitors[0].recovery;
  recovery.kind = RecoveryKind::route;
  expand_lookahead(e.module, e.diagnostics);
  EXPECT_EQ(first_code(e.diagnostics), "recovery_spends_charge");
  EXPECT_NE(e.diagnostics.all()[0].message.find("ends where nobody charges the robot"),
            std::string::npos);
}

// language, rule 9: what `ahead` asks for is done, refused, or said to add nothing.
TEST(ExpandLookahead, WaypointsThatAddNothingToAChargeAreTold) {
  const Expanded e = expand(charge_of(200'000));
  EXPECT_EQ(first_code(e.diagnostics), "waypoints_not_needed");
  EXPECT_FALSE(e.diagnostics.has_errors());
  EXPECT_TRUE(expand(fence(30)).diagnostics.all().empty());
}

TEST(ExpandLookahead, WaypointsOnlyDropsTheDurationOfASeparationToo) {
  const Expanded e = expand(separation(80), {false, 0, 2, false});
  EXPECT_EQ(e.text().find("pair_reach"), std::string::npos) << e.text();
  EXPECT_NE(e.text().find("legs_apart legs 2"), std::string::npos);
}

TEST(ExpandLookahead, PointsOnlyOfASeparationIsRefused) {
  EXPECT_EQ(first_code(expand(separation(80), {false, 0, 2, true}).diagnostics),
            "clause_without_effect");
}

TEST(ExpandLookahead, WaypointsOnlyOfAChargeIsRefused) {
  EXPECT_EQ(first_code(expand(charge_of(200'000), {false, 0, 2, false}).diagnostics),
            "clause_without_effect");
}

// language, rules 9.6 and 9.8: commands tell where the robot goes, and no agent.
TEST(ExpandLookahead, CommandsThatTellNothingAreRefusedByWhatTheMonitorSpeaksOf) {
  Lookahead commands{true, 200'000, 0, false};
  commands.command = true;
  BlockMaker b;
  const ValueId gap = b.quantity(AgentDistance{AgentIndex{0}});
  const ValueId least = b.quantity(Const{300});
  const Expanded agent = expand(b.done(b.margin(AtLeast{gap, least, false})), commands);
  EXPECT_EQ(first_code(agent.diagnostics), "clause_without_effect");
  EXPECT_NE(agent.diagnostics.all()[0].help.find("where an agent will be"), std::string::npos);
  const Expanded charge = expand(charge_of(200'000), commands);
  EXPECT_EQ(first_code(charge.diagnostics), "clause_without_effect");
  EXPECT_NE(charge.diagnostics.all()[0].help.find("`distance` from other robots"),
            std::string::npos);
}

// The margin is that of the atom that decides, in its unit: no unit fits both of these.
TEST(ExpandLookahead, AtomsOfDifferentUnitsLeaveTheUnitOpen) {
  BlockMaker b;
  const ValueId charge = b.quantity(Battery{}, Unit::ppm);
  const ValueId least = b.quantity(Const{200'000}, Unit::ppm);
  const ValueId enough = b.margin(AtLeast{charge, least, false});
  const ValueId gap = b.quantity(Clearance{ZoneIndex{0}});
  const ValueId zero = b.quantity(Const{0});
  const ValueId inside = b.margin(AtLeast{gap, zero, false});
  const Expanded e = expand(b.done(b.margin(And{enough, inside})));
  EXPECT_EQ(e.module.decisions[0].monitors[0].unit, std::nullopt);
  EXPECT_EQ(expand(fence(0)).module.decisions[0].monitors[0].unit, Unit::mm);
  EXPECT_EQ(expand(charge_of(0)).module.decisions[0].monitors[0].unit, Unit::ppm);
}

TEST(ExpandLookahead, DistributesOverAndAndOr) {
  for (const bool both : {true, false}) {
    BlockMaker b;
    const ValueId t = b.margin(Truth{true});
    const ValueId f = b.margin(Truth{false});
    const std::string text = expand(b.done(both ? b.margin(And{t, f}) : b.margin(Or{t, f}))).text();
    EXPECT_EQ(text, std::string("%0 = true : margin\n%1 = false : margin\n%2 = ") +
                        (both ? "and" : "or") + " %0, %1 : margin\nresult %2\n");
  }
}

void expect_refused(Block property) {
  const Expanded e = expand(std::move(property));
  EXPECT_EQ(first_code(e.diagnostics), "atom_without_transformer") << e.text();
}

TEST(ExpandLookahead, RefusesWhatHasNoTransformer) {
  BlockMaker upper;  // 100 >= gap
  const ValueId gap = upper.quantity(Clearance{ZoneIndex{0}});
  const ValueId most = upper.quantity(Const{100});
  expect_refused(upper.done(upper.margin(AtLeast{most, gap, false})));

  BlockMaker negated;
  const ValueId t = negated.margin(Truth{true});
  expect_refused(negated.done(negated.margin(Not{t})));

  BlockMaker held;
  const ValueId u = held.margin(Truth{true});
  expect_refused(held.done(held.margin(HeldFor{u, 1, 0})));

  BlockMaker half_price;  // battery >= energy / 2: the price of the way is not halved by halving it
  const ValueId charge = half_price.quantity(Battery{}, Unit::ppm);
  const ValueId way = half_price.quantity(EnergyTo{SiteIndex{0}}, Unit::ppm);
  const ValueId half = half_price.quantity(Scale{way, 1, 2}, Unit::ppm);
  expect_refused(half_price.done(half_price.margin(AtLeast{charge, half, false})));

  BlockMaker cancelled;  // gap >= gap says nothing that could be looked ahead
  const ValueId g = cancelled.quantity(Clearance{ZoneIndex{0}});
  expect_refused(cancelled.done(cancelled.margin(AtLeast{g, g, false})));
}

TEST(ExpandLookahead, ADecisionOnPlansHasNothingAheadAndNoNegation) {
  BlockMaker b;
  const ValueId in = b.margin(PlanInZone{ZoneIndex{0}});
  Module good = module_with(b.done(in));
  good.decisions[0].on_plan = true;
  diag::Engine diagnostics;
  expand_lookahead(good, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_FALSE(good.decisions[0].monitors[0].ahead.has_value());

  BlockMaker c;
  const ValueId inside = c.margin(PlanInZone{ZoneIndex{0}});
  Module bad = module_with(c.done(c.margin(Not{inside})));
  bad.decisions[0].on_plan = true;
  expand_lookahead(bad, diagnostics);
  EXPECT_EQ(first_code(diagnostics), "atom_without_transformer");
}

TEST(ShareValues, ComputesEachValueOnceAndOnlyIfItIsNeeded) {
  BlockMaker b;
  const ValueId zero = b.quantity(Const{0});
  const ValueId again = b.quantity(Const{0});
  b.quantity(Const{7});  // nobody needs it
  const ValueId gap = b.quantity(Clearance{ZoneIndex{0}});
  const ValueId one = b.margin(AtLeast{gap, zero, false});
  const ValueId two = b.margin(AtLeast{gap, again, false});
  Module m = module_with(b.done(b.margin(And{one, two})));
  diag::Engine diagnostics;
  share_values(m, diagnostics);
  EXPECT_EQ(print(m, &m.decisions[0].facts, m.decisions[0].monitors[0].property, ""),
            "%0 = const 0 : mm\n%1 = clearance room : mm\n%2 = at_least %1, %0 : margin\n"
            "%3 = and %2, %2 : margin\nresult %3\n");
  EXPECT_EQ(verify(m), std::nullopt);
}

TEST(ShareValues, KeepsRunsOfTicksWithSlotsOfTheirOwnApart) {
  BlockMaker b;
  const ValueId t = b.margin(Truth{true});
  const ValueId one = b.margin(HeldFor{t, 5, 0});
  const ValueId two = b.margin(HeldFor{t, 5, 1});
  Module m = module_with(b.done(b.margin(And{one, two})));
  diag::Engine diagnostics;
  share_values(m, diagnostics);
  EXPECT_EQ(m.decisions[0].monitors[0].property.values.size(), 4u);
}

TEST(ShareValues, KeepsZonesApart) {
  BlockMaker b;
  const ValueId one = b.quantity(Clearance{ZoneIndex{0}});
  const ValueId two = b.quantity(Clearance{ZoneIndex{1}});
  Module m = module_with(b.done(b.margin(AtLeast{one, two, false})));
  m.zones.push_back(m.zones[0]);
  m.zones[1].name = "hall";
  diag::Engine diagnostics;
  share_values(m, diagnostics);
  EXPECT_EQ(m.decisions[0].monitors[0].property.values.size(), 3u);
}

diag::Engine ranges_of(Module& m) {
  diag::Engine diagnostics;
  analyse_ranges(m, diagnostics);
  return diagnostics;
}

TEST(AnalyseRanges, SumsAndFactorsGrowTheRange) {
  BlockMaker b;
  const ValueId gap = b.quantity(Clearance{ZoneIndex{0}});
  const ValueId twice = b.quantity(Add{gap, gap});
  const ValueId third = b.quantity(Scale{twice, -1, 3});
  Module m = module_with(b.done(b.margin(AtLeast{third, gap, false})));
  EXPECT_FALSE(ranges_of(m).has_errors());
  const Block& p = m.decisions[0].monitors[0].property;
  EXPECT_EQ(p[twice].range->hi, std::int64_t{1} << 32);
  // outward by one: the kernel rounds outward
  EXPECT_LE(p[third].range->lo, -((std::int64_t{1} << 32) / 3) - 1);
  EXPECT_GE(p[third].range->hi, (std::int64_t{1} << 32) / 3 + 1);
}

// 2^31 * 2^17 is the limit of 2^48; the message names the factor that works.
TEST(AnalyseRanges, AFactorThatOverflowsIsRefusedWithTheLargestOne) {
  for (const std::int64_t factor : {131'072, 131'073}) {
    BlockMaker b;
    const ValueId gap = b.quantity(Clearance{ZoneIndex{0}});
    const ValueId scaled = b.quantity(Scale{gap, factor, 1'000'000});
    Module m = module_with(b.done(b.margin(AtLeast{scaled, gap, false})));
    const diag::Engine e = ranges_of(m);
    EXPECT_EQ(e.has_errors(), factor == 131'073);
    if (e.has_errors()) {
      EXPECT_NE(e.all()[0].help.find("131072"), std::string::npos);
    }
  }
}

TEST(AnalyseRanges, AConstantBeyondTheKernelIsRefused) {
  Module m = module_with(fence((std::int64_t{1} << 48) + 1));
  EXPECT_EQ(first_code(ranges_of(m)), "value_out_of_range");
}

TEST(AnalyseRanges, HorizonsSpeedsAndAccelerationsHaveLimits) {
  Module horizon = module_with(fence(0));
  horizon.decisions[0].monitors[0].lookahead.duration_us = 60'000'001;
  EXPECT_EQ(first_code(ranges_of(horizon)), "value_out_of_range");
  Module speed = module_with(fence(0));
  speed.decisions[0].motions[0].speed_mmps = 100'001;
  EXPECT_EQ(first_code(ranges_of(speed)), "value_out_of_range");
  Module accel = module_with(fence(0));
  accel.decisions[0].motions[1].accel_mmps2 = 1'000'001;
  EXPECT_EQ(first_code(ranges_of(accel)), "value_out_of_range");
}

TEST(Pipeline, RunsAllPassesInOrderAndVerifiesAfterEach) {
  Module m = module_with(fence(30));
  diag::Engine diagnostics;
  std::string ran;
  EXPECT_EQ(run_pipeline(m, diagnostics, [&](const Pass& p) { ran += std::string(p.name) + " "; }),
            std::nullopt);
  EXPECT_EQ(ran, "expand_lookahead share_values analyse_ranges find_vacuous ");
  EXPECT_TRUE(m.decisions[0].monitors[0].property.values[0].range.has_value());
}

TEST(Pipeline, AMalformedModuleIsABugOfThePassThatLeftIt) {
  Module m = module_with(fence(30));
  m.zones.push_back(m.zones[0]);
  diag::Engine diagnostics;
  const auto problem = run_pipeline(m, diagnostics, {});
  ASSERT_TRUE(problem.has_value());
  EXPECT_EQ(problem->rfind("after pass expand_lookahead: ", 0), 0u) << *problem;
}

}  // namespace
}  // namespace rtac::passes
