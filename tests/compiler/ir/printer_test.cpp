// The canonical text: goldens and passes rely on it, so every operation has exactly one line.
#include "tests/compiler/ir/testing.h"

namespace rtac::ir::test {
namespace {

TEST(Printer, AModuleReadsAsAWhole) {
  EXPECT_EQ(print(module_with(fence(100))),
            "module study\n"
            "zone room edges 1 cells 0x0 of 100 mm, widest 0 mm at (0, 0)\n"
            "  edge (0, 0) to (1000, 0)\n"
            "decision drive for Cart every 100000 us, return +0 us, dwell 0\n"
            "  body radius 100, errors 0 mm 0 mm/s, accel 0, brake 0, brake lag 0 ms, aside 0 ms "
            "0 permille, hold 0\n"
            "  motion any speed 0 accel 0\n"
            "  motion turn_back speed 0 accel 0\n"
            "  monitor walls \"\" at study.rta:7\n"
            "    horizon 200000 us\n"
            "    property\n"
            "      %0 = clearance room : mm\n"
            "      %1 = const 100 : mm\n"
            "      %2 = at_least %0, %1 : margin\n"
            "      result %2\n"
            "    recovery turn_back route 0 return 0 pass 0\n");
}

TEST(Printer, EveryOperationHasALineOfItsOwn) {
  const ZoneIndex zone{0};
  const SiteIndex site{0};
  BlockMaker b;
  const ValueId q = b.quantity(Const{-5});
  const ValueId charge = b.quantity(Battery{}, Unit::ppm);
  b.quantity(Distance{});
  b.quantity(EnergyTo{site}, Unit::ppm);
  b.quantity(Add{q, q});
  b.quantity(Negate{q});
  b.quantity(Scale{q, 2, 3});
  const ValueId m = b.margin(AtLeast{charge, charge, true});
  b.margin(PlanInZone{zone});
  b.margin(Truth{false});
  b.margin(Not{m});
  b.margin(And{m, m});
  b.margin(Or{m, m});
  b.margin(HeldFor{m, 4, 1});
  BlockMaker inner;
  b.margin(ForOthers{false, std::make_unique<Block>(inner.done(inner.margin(Truth{true})))});
  b.margin(ZoneReach{zone, 5});
  b.margin(LegsInZone{zone, 2, 6});
  b.margin(PointsInZone{zone, 3, 7});
  b.margin(PairReach{8});
  b.margin(LegsApart{2, 9, true});
  b.margin(OnTrack{12});
  b.margin(EnergyReach{site, 10});
  b.margin(ChargeReach{11});
  b.quantity(Speed{}, Unit::mmps);
  b.margin(SpeedReach{13});
  b.margin(ZoneThere{ScheduleIndex{0}});
  b.margin(ThereThroughout{ScheduleIndex{0}, 14});
  const ValueId last = b.margin(GoneThroughout{ScheduleIndex{0}, 15});
  Watch facts;
  facts.schedules.push_back({"fair", {}, {}});
  EXPECT_EQ(print(module_with(fence(0)), &facts, b.done(last), ""),
            "%0 = const -5 : mm\n"
            "%1 = battery : ppm\n"
            "%2 = distance : mm\n"
            "%3 = energy_to dock : ppm\n"
            "%4 = add %0, %0 : mm\n"
            "%5 = negate %0 : mm\n"
            "%6 = scale %0, 2/3 : mm\n"
            "%7 = more_than %1, %1 : margin\n"
            "%8 = plan_in_zone room : margin\n"
            "%9 = false : margin\n"
            "%10 = not %7 : margin\n"
            "%11 = and %7, %7 : margin\n"
            "%12 = or %7, %7 : margin\n"
            "%13 = held_for %7, 4 ticks, slot 1 : margin\n"
            "%14 = for_some_other : margin\n"
            "  %0 = true : margin\n"
            "  result %0\n"
            "%15 = zone_reach room, least 5 : margin\n"
            "%16 = legs_in_zone room, legs 2, need 6 : margin\n"
            "%17 = points_in_zone room, points 3, need 7 : margin\n"
            "%18 = pair_reach least 8 : margin\n"
            "%19 = legs_apart legs 2, need 9, ranked : margin\n"
            "%20 = on_track within 12 : margin\n"
            "%21 = energy_reach dock, reserve 10 : margin\n"
            "%22 = charge_reach least 11 : margin\n"
            "%23 = speed : 1/1000 m/s\n"
            "%24 = speed_reach most 13 : margin\n"
            "%25 = there fair : margin\n"
            "%26 = there_throughout fair, after 14 : margin\n"
            "%27 = gone_throughout fair, after 15 : margin\n"
            "result %27\n");
}

}  // namespace
}  // namespace rtac::ir::test
