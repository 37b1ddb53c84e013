// Small modules built by hand.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "compiler/ir/module.h"
#include "compiler/ir/printer.h"
#include "compiler/ir/verifier.h"

namespace rtac::ir::test {

class BlockMaker {
 public:
  ValueId quantity(Op op, Unit unit = Unit::mm) { return add(std::move(op), unit); }
  ValueId margin(Op op) { return add(std::move(op), std::nullopt); }
  Block done(ValueId result) {
    block_.result = result;
    return std::move(block_);
  }

 private:
  ValueId add(Op op, std::optional<Unit> unit) {
    block_.values.push_back({std::move(op), unit, std::nullopt, {}});
    return ValueId(block_.values.size() - 1);
  }
  Block block_;
};

// clearance room >= least
inline Block fence(std::int64_t least_mm, bool strict = false) {
  BlockMaker b;
  const ValueId gap = b.quantity(Clearance{ZoneIndex{0}});
  const ValueId least = b.quantity(Const{least_mm});
  return b.done(b.margin(AtLeast{gap, least, strict}));
}

// One zone, one site, one periodic decision with one monitor of this property.
inline Module module_with(Block property) {
  Module m;
  m.name = "study";
  ZoneTable zone;
  zone.name = "room";
  zone.edges = {{0, 0, 1000, 0, 1 << 30, 0}};
  m.zones.push_back(zone);
  SiteTable site;
  site.name = "dock";
  m.sites.push_back(site);
  Decision d;
  d.name = "drive";
  d.kind = "Cart";
  d.period_us = 100'000;
  d.body.radius_mm = 100;
  d.body.tracking_mm = 50;
  d.motions.resize(2);
  d.motions[0].name = "any";
  d.motions[1].name = "turn_back";
  Monitor monitor;
  monitor.name = "walls";
  monitor.file = "study.rta";
  monitor.line = 7;
  monitor.recovery.name = "turn_back";
  monitor.lookahead.duration_us = 200'000;
  monitor.lookahead.waypoints = 2;
  monitor.property = std::move(property);
  d.monitors.push_back(std::move(monitor));
  m.decisions.push_back(std::move(d));
  return m;
}

}  // namespace rtac::ir::test
