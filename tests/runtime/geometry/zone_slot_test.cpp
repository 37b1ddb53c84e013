// One thread makes zones, another one steps monitors: what the second one looks at is whole and
// alive, and it never waits.
#include "rtac/geometry/zone_slot.h"

#include <gtest/gtest.h>

#include <thread>

namespace rtac {
namespace {

// A zone that says who it is in every number.
std::unique_ptr<HeldZone> zone_of(std::int32_t number) {
  ZoneOutline o;
  o.x_mm = number;
  HeldZone::Arrays arrays;
  arrays.edges.assign(60, number);
  arrays.cells.assign(100, static_cast<std::uint32_t>(number));
  return std::make_unique<HeldZone>(o, std::move(arrays), ZoneOutline{}, HeldZone::Arrays{});
}
// -1: it is torn, or gone.
std::int32_t number_of(const ZoneTable& table) {
  const std::int32_t number = table.within.x_mm;
  for (std::int32_t i = 0; i < 6 * table.within.edge_count; ++i) {
    if (table.within.edges[i] != number) return -1;
  }
  return zone_checksum(table) == table.checksum ? number : -1;
}

TEST(ZoneSlot, OffersTheNewestOnce) {
  ZoneSlot slot;
  std::int32_t seen = 0;
  TimeUs stamp = 0;
  const auto take = [&](const ZoneTable& table, TimeUs stamp_us) {
    seen = number_of(table);
    stamp = stamp_us;
    return true;
  };
  EXPECT_FALSE(slot.offer(take));
  slot.publish(zone_of(1), 10);
  slot.publish(zone_of(2), 20);
  EXPECT_TRUE(slot.offer(take));
  EXPECT_EQ(seen, 2);
  EXPECT_EQ(stamp, 20);
  EXPECT_FALSE(slot.offer(take));
}

TEST(ZoneSlot, KeepsTheOneBeforeWhenTheNewOneIsNotTaken) {
  ZoneSlot slot;
  const ZoneTable* held = nullptr;
  slot.publish(zone_of(1), 0);
  slot.offer([&](const ZoneTable& table, TimeUs) {
    held = &table;
    return true;
  });
  for (std::int32_t k = 2; k < 6; ++k) {
    slot.publish(zone_of(k), 0);
    EXPECT_FALSE(slot.offer([](const ZoneTable&, TimeUs) { return false; }));
  }
  EXPECT_EQ(number_of(*held), 1);
}

// What was taken is looked at again and again, until another one is; sanitizers see more of this.
TEST(ZoneSlot, WhatIsLookedAtStaysAliveWhileOthersArePublished) {
  constexpr std::int32_t zones = 3000;
  ZoneSlot slot;
  std::atomic<bool> done{false};
  std::thread writer([&] {
    for (std::int32_t k = 1; k <= zones; ++k) slot.publish(zone_of(k), k);
    done = true;
  });
  const ZoneTable* held = nullptr;
  std::int32_t newest = 0, refused = 0;
  for (bool last = false; !last;) {
    last = done;
    slot.offer([&](const ZoneTable& table, TimeUs) {
      const std::int32_t number = number_of(table);
      EXPECT_GT(number, newest) << "zones come in order";
      if (number % 7 == 0) {
        ++refused;
        return false;
      }
      newest = number;
      held = &table;
      return true;
    });
    if (held != nullptr && number_of(*held) != newest) {
      ADD_FAILURE() << "zone " << newest << " is gone";
      break;
    }
  }
  writer.join();
  EXPECT_EQ(newest, zones);  // 3000 is no multiple of 7
}

TEST(ZoneSlot, SeveralMayPublish) {
  ZoneSlot slot;
  std::thread one([&] {
    for (std::int32_t k = 0; k < 500; ++k) slot.publish(zone_of(k), k);
  });
  std::thread two([&] {
    for (std::int32_t k = 0; k < 500; ++k) slot.publish(zone_of(k), k);
  });
  for (int k = 0; k < 1000; ++k) {
    slot.offer([](const ZoneTable& table, TimeUs) { return number_of(table) >= 0; });
  }
  one.join();
  two.join();
}

}  // namespace
}  // namespace rtac
