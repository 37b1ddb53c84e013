#include "compiler/ir/watch_builder.h"

#include <algorithm>

#include "compiler/ir/source_text.h"
#include "compiler/ir/watch_blocks.h"
#include "compiler/sema/dimension.h"
#include "compiler/sema/origin.h"

namespace rtac::ir {
namespace {

class WatchBuilder {
 public:
  WatchBuilder(const sema::Spec& spec, const SourceManager& sources, const TableMap& tables,
               diag::Engine& diagnostics)
      : spec_(spec), sources_(sources), tables_(tables), diagnostics_(diagnostics) {}

  Watch run(const Signals& signals, std::vector<Region> regions, std::vector<Solid> solids) {
    watch_.regions = std::move(regions);
    watch_.solids = std::move(solids);
    watch_.period_us = spec_.period ? floor_to_int(spec_.period->value * 1'000'000) : 1;
    watch_.in_utc = spec_.utc_clock.has_value();
    if (spec_.origin) {
      const geometry::Origin origin = sema::in_degrees(*spec_.origin);
      watch_.origin = Origin{origin.latitude_deg, origin.longitude_deg};
    }
    add_signals(signals);
    for (Region& region : watch_.regions) {
      if (region.channel) region.channel = channel_of(watch_, region.name);
    }
    watch_.units.push_back({{}, 1, 1});
    for (const sema::Watch& from : spec_.watches) monitor(from);
    return std::move(watch_);
  }

 private:
  // All but those that only monitors of robots speak of.
  void add_signals(const Signals& signals) {
    UsedSignals here, there;
    for (const sema::Watch& watch : spec_.watches) here.add(spec_, *watch.always);
    for (const sema::Monitor& monitor : spec_.monitors) there.add(spec_, monitor);
    for (std::uint32_t i = 0; i < signals.inputs.size(); ++i) {
      const sema::InputId id{i};
      if (here.inputs.count(id) == 0 && there.inputs.count(id) > 0) continue;
      watch_.inputs.push_back(signals.inputs[i]);
    }
    for (std::uint32_t i = 0; i < signals.params.size(); ++i) {
      const sema::ParamId id{i};
      if (here.params.count(id) == 0 && there.params.count(id) > 0) continue;
      watch_.params.push_back(signals.params[i]);
    }
  }

  void monitor(const sema::Watch& from) {
    PlainMonitor to;
    to.name = from.name;
    to.requirement_id = from.requirement_id;
    to.requirement_text = from.requirement_text;
    const std::string& path = sources_.path(from.name_range.file);
    to.file = path.substr(path.find_last_of('/') + 1);
    to.line = sources_.position(from.name_range.file, from.name_range.begin).line;
    to.text = one_line(sources_.text(from.always_range));
    to.source = from.always_range;
    to.property = build_watch_block(*from.always, spec_, sources_, tables_, watch_, diagnostics_,
                                    nullptr, from.margin_full);
    watch_.monitors.push_back(std::move(to));
  }

  const sema::Spec& spec_;
  const SourceManager& sources_;
  const TableMap& tables_;
  diag::Engine& diagnostics_;
  Watch watch_;
};

}  // namespace

Rational scale_of(const sema::Spec& spec, const sema::Dimension& dimension) {
  for (const sema::MarginScale& scale : spec.scales) {
    if (scale.dimension == dimension) return scale.value.value;
  }
  return default_scale(dimension);
}

std::optional<Watch> build_watch(const sema::Spec& spec, const Signals& signals,
                                 const SourceManager& sources, std::vector<Region> regions,
                                 std::vector<Solid> solids, const TableMap& tables,
                                 diag::Engine& diagnostics) {
  if (spec.watches.empty()) return std::nullopt;
  return WatchBuilder(spec, sources, tables, diagnostics)
      .run(signals, std::move(regions), std::move(solids));
}

}  // namespace rtac::ir
