// Which table of the module stands for which zone or site of the specification.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::ir {

struct TableMap {
  std::vector<std::optional<ZoneIndex>> zones;  // by ZoneId
  // by KindId, then by SiteId: the places of a site differ from kind to kind
  std::vector<std::vector<std::optional<SiteIndex>>> sites;

  // by ZoneId: what points are held against, within the zone and around it
  struct Regions {
    RegionIndex within, around;
  };
  std::vector<std::optional<Regions>> regions;
  struct Solids {  // the same of zones with height
    SolidIndex within, around;
  };
  std::vector<std::optional<Solids>> solids;

  // How far zones are apart: between two steps of 1 mm, or, where curves and offsets leave it open,
  // between more.
  struct Gap {
    std::int64_t lo_mm, hi_mm;
    bool open;  // strictly between two neighbouring steps
  };
  std::map<std::pair<sema::ZoneId, sema::ZoneId>, Gap> gaps;
  static std::pair<sema::ZoneId, sema::ZoneId> pair(const sema::ZoneDistance& of) {
    return std::minmax(of.zone, of.other);
  }

  [[nodiscard]] ZoneIndex zone(sema::ZoneId id) const {
    return *zones[static_cast<std::uint32_t>(id)];
  }
  [[nodiscard]] const Regions& region(sema::ZoneId id) const {
    return *regions[static_cast<std::uint32_t>(id)];
  }
  [[nodiscard]] const Solids& solid(sema::ZoneId id) const {
    return *solids[static_cast<std::uint32_t>(id)];
  }
  [[nodiscard]] SiteIndex site(sema::KindId kind, sema::SiteId id) const {
    return *sites[static_cast<std::uint32_t>(kind)][static_cast<std::uint32_t>(id)];
  }
};

}  // namespace rtac::ir
