#include "compiler/recheck/acceptable.h"

#include <algorithm>

#include "compiler/recheck/coming_in.h"
#include "compiler/sema/templates.h"

namespace rtac::recheck {

Claim lies_in_claim(Claims& claims, const sema::Controller& recovery, sema::ZoneId inner,
                    sema::ZoneId outer) {
  NamedZones& zones = claims.zones();
  const bool flat = zones.region(inner) != nullptr && zones.region(outer) == nullptr;
  return {flat && !sema::claim_of(recovery) ? "level" : "contained",
          {{"inner", zones.name(inner)}, {"outer", zones.name(outer)}}};
}

Rational standoff_needed(const sema::Spec& spec, const sema::Decision& d,
                         const sema::Monitor& driving, const sema::Monitor& m, sema::ZoneId inner,
                         sema::ZoneId outer) {
  const Rational gap = gap_of(spec, *m.always, outer);
  // a step of the grid is no more than touching
  if (gap <= Rational(1, 1000)) return 0;
  if (sema::claim_of(spec[*driving.recover])) return gap;  // it may be anywhere in its zone
  const bool has_it = &driving == &m || relied_on(spec, d, driving);
  if (inner == outer || (has_it && sure_gap_of(spec, *driving.always, inner) >= gap)) return 0;
  return gap;
}

namespace {

std::optional<Doubt> beyond(const sema::Controller& recovery, const std::string& what,
                            bool refuted = true) {
  return Doubt{refuted, "nobody can accept that `" + recovery.name + "` leads out of " + what};
}

// One zone in another one, and as far from its boundary as is asked.
std::optional<Doubt> leads_out_of(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                                  const sema::Monitor& m, sema::ZoneId inner, sema::ZoneId outer) {
  const sema::Controller& recovery = spec[*m.recover];
  if (inner == outer && !sema::claim_of(recovery)) return std::nullopt;
  Claim claim = lies_in_claim(claims, recovery, inner, outer);
  const std::string name = "`" + claims.zones().name(outer) + "`";
  if (const auto doubt = claims.check(claim)) return beyond(recovery, name, doubt->refuted);
  const Rational gap = standoff_needed(spec, d, m, m, inner, outer);
  if (gap == 0) return std::nullopt;
  // the same boundary, under another name
  const Claim back{"contained",
                   {{"inner", claim.values["outer"]}, {"outer", claim.values["inner"]}}};
  if (!sema::claim_of(recovery) && !claims.check(back)) return std::nullopt;
  claim.values["standoff_mm"] = std::to_string(floor_to_int(Rational(gap * 1000)));
  if (const auto doubt = claims.check(claim)) {
    return beyond(recovery, "what is " + to_decimal(gap) + " m inside " + name, doubt->refuted);
  }
  return std::nullopt;
}

// Of several zones of which one is enough, in the plane: all that they have together.
bool lies_in_one_of(Claims& claims, sema::ZoneId inner, const std::vector<Held>& sides) {
  const geometry::Region* const own = claims.zones().region(inner);
  geometry::Region all;
  for (const Held& side : sides) {
    const geometry::Region* const region = claims.zones().region(side.zone);
    if (region == nullptr) return true;  // in space each step in the middle of them is told
    all = all.unite(*region);
  }
  return own == nullptr || all.contains(*own);
}

}  // namespace

std::optional<Doubt> leads_elsewhere(const sema::Spec& spec, const sema::Decision& d,
                                     Claims& claims, const sema::Monitor& m) {
  const sema::Controller& recovery = spec[*m.recover];
  if (sema::templates_of(recovery).empty() && !sema::claim_of(recovery)) {
    return Doubt{true, "nobody can accept what `" + recovery.name + "` does, as it claims nothing"};
  }
  for (const sema::ZoneId inner : moves_within(recovery)) {
    for (const std::vector<Held>& sides : held_in(spec, *m.always)) {
      if (sides.size() == 1) {
        if (auto doubt = leads_out_of(spec, d, claims, m, inner, sides[0].zone)) return doubt;
      } else if (!lies_in_one_of(claims, inner, sides)) {
        return beyond(recovery, "all zones of an `or`");
      }
    }
  }
  if (keeps_its_heights(spec, d, claims, recovery, *m.always)) return std::nullopt;
  return beyond(recovery, "the heights that `" + m.name + "` allows");
}

}  // namespace rtac::recheck
