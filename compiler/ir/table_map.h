// Which table of the module stands for which zone or site of the specification.
#pragma once

#include <optional>
#include <vector>

#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::ir {

struct TableMap {
  std::vector<std::optional<ZoneIndex>> zones;  // by ZoneId
  // by KindId, then by SiteId: the places of a site differ from kind to kind
  std::vector<std::vector<std::optional<SiteIndex>>> sites;

  [[nodiscard]] ZoneIndex zone(sema::ZoneId id) const {
    return *zones[static_cast<std::uint32_t>(id)];
  }
  [[nodiscard]] SiteIndex site(sema::KindId kind, sema::SiteId id) const {
    return *sites[static_cast<std::uint32_t>(kind)][static_cast<std::uint32_t>(id)];
  }
};

}  // namespace rtac::ir
