#include "compiler/analysis/zone_trials.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "compiler/analysis/dials.h"
#include "compiler/analysis/sides.h"

namespace rtac::analysis {
namespace {

using sema::ZoneExpr;
using sema::ZoneExprPtr;
using sema::ZoneOp;

// Writes a zone of others.
class Writer {
 public:
  Writer(const sema::Spec& spec, const ir::Module& module, const SourceRange& range)
      : spec_(spec), module_(module), range_(range) {}

  // Null: a part is not written anywhere, or all that there is lies outside of something.
  ZoneExprPtr common(const std::vector<ZonePart>& parts) const {
    ZoneExprPtr all, without;
    for (const ZonePart& part : parts) {
      const auto hole = part.either.size() == 1 ? outside_of(part.either[0]) : std::nullopt;
      if (hole) {
        join(without, ZoneOp::unite, offset(make(sema::ZoneRef{*hole}), part.off_mm));
        continue;
      }
      ZoneExprPtr some;
      for (const ir::ZoneIndex zone : part.either) {
        const auto id = named(module_[zone].name);
        if (!id) return nullptr;
        join(some, ZoneOp::unite, make(sema::ZoneRef{*id}));
      }
      join(all, ZoneOp::intersect, offset(std::move(some), -part.off_mm));
    }
    if (all && without) join(all, ZoneOp::subtract, std::move(without));
    return all;
  }
  std::optional<sema::ZoneId> named(const std::string& name) const {
    const auto found = std::ranges::find(spec_.zones, name, &sema::Zone::name);
    if (name.empty() || found == spec_.zones.end() || found->has_height) return std::nullopt;
    return sema::ZoneId(found - spec_.zones.begin());
  }

 private:
  template <class Node>
  ZoneExprPtr make(Node node) const {
    auto made = std::make_unique<ZoneExpr>();
    made->range = range_;
    made->node = std::move(node);
    return made;
  }
  ZoneExprPtr offset(ZoneExprPtr of, std::int64_t by_mm) const {
    return by_mm == 0 ? std::move(of) : make(sema::ZoneOffset{std::move(of), metres_of(by_mm)});
  }
  void join(ZoneExprPtr& to, ZoneOp op, ZoneExprPtr more) const {
    to = to ? make(sema::ZoneBinary{op, std::move(to), std::move(more)}) : std::move(more);
  }
  // The zone that a table is the rest of the plane of.
  std::optional<sema::ZoneId> outside_of(ir::ZoneIndex zone) const {
    const std::string outside = "outside_of_", &name = module_[zone].name;
    return name.starts_with(outside) ? named(name.substr(outside.size())) : std::nullopt;
  }

  const sema::Spec& spec_;
  const ir::Module& module_;
  SourceRange range_;
};

}  // namespace

std::optional<bool> works_within(Trials& trials, const Fault& fault, const SourceRange& all_of,
                                 const std::string& recovery, const ir::Module& module,
                                 ir::ZoneIndex from, const std::vector<ZonePart>& parts) {
  sema::Spec& spec = trials.spec();
  const auto old = Writer(spec, module, {}).named(module[from].name);
  if (!old) return std::nullopt;
  const sema::Zone& moved_in = spec.zones[static_cast<std::size_t>(*old)];
  ZoneExprPtr value = Writer(spec, module, moved_in.value->range).common(parts);
  if (!value) return std::nullopt;
  sema::Zone zone{"", moved_in.name_range, std::move(value), moved_in.frame, false, {}};
  std::string name;
  for (const ZonePart& part : parts) {
    for (const ir::ZoneIndex of : part.either) name += module[of].name + " ";
    name += std::to_string(part.off_mm) + ";";
  }
  return works_in_zone(trials, fault, all_of, recovery, name, *old, std::move(zone));
}

}  // namespace rtac::analysis
