// What each kind of claim says, held against the specification.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/recheck/numbers.h"
#include "compiler/recheck/recheck.h"
#include "compiler/recheck/zones.h"

namespace rtac::recheck {

using Values = std::map<std::string, std::string>;
struct Claim {
  std::string what;
  Values values;
};

class Claims {
 public:
  Claims(const sema::Spec& spec, const SourceManager& sources, ProveLemma prove)
      : spec_(spec), zones_(spec, sources), prove_(std::move(prove)) {}

  std::optional<Doubt> check(const Claim& claim);
  NamedZones& zones() { return zones_; }
  // What is looked at for the present claim takes too long: it is not known.
  void give_up() { gave_up_ = true; }
  // The clearance in a zone of a robot at rest whose monitors all give control back, at least, when
  // they look `extra` s further ahead for that.
  Rational return_clearance(const sema::Decision& d, sema::ZoneId zone, const Rational& extra);
  // How clear the recovery of a monitor leads to in a zone of the plane, at least: control is given
  // back there by all monitors, whichever it drives for, and by what they ask for of that zone, and
  // of those that it lies in.
  Rational led_to(const sema::Decision& d, const sema::Monitor& driving, sema::ZoneId zone,
                  const Rational& extra);
  // What a recovery within the zone has of its boundary at least where it has led.
  Rational clear_where_led(const sema::Decision& d, sema::ZoneId zone, const Rational& extra);
  // What one monitor asks for of its zones, the body included.
  [[nodiscard]] Rational return_clearance(const sema::Decision& d, const sema::Monitor& m,
                                          const Rational& extra) const;
  // The same of a limit of height, which counts for the centre.
  [[nodiscard]] Rational return_height(const sema::Decision& d, const sema::Monitor& m,
                                       const Rational& extra) const {
    return return_clearance(d, m, extra) - spec_[d.kind].radius.value;
  }
  // What legs in space at that speed keep free, at least, without a standoff.
  [[nodiscard]] Rational leg_in_space(const sema::Decision& d, const Rational& speed) const;
  // What the legs of a recovery within a zone keep free, at least: what a look-ahead by its own
  // limits asks for at its speed, whichever monitor looks furthest, and what its monitor says of
  // that zone.
  [[nodiscard]] Rational leg_clearance(const sema::Decision& d, const sema::Monitor& m,
                                       sema::ZoneId zone) const;

 private:
  [[nodiscard]] bool looks_as_far(const Values& v) const;
  std::optional<Doubt> limits(const Values& v);
  std::optional<Doubt> horizon(const Values& v);
  std::optional<Doubt> returns(const Values& v);
  std::optional<Doubt> output(const Values& v);
  std::optional<Doubt> recovery(const Values& v);
  std::optional<Doubt> contained(const Values& v);
  std::optional<Doubt> level(const Values& v);
  std::optional<Doubt> comes_in(const Values& v);
  std::optional<Doubt> place(const Values& v);
  std::optional<Doubt> returned(const Values& v);
  std::optional<Doubt> seen(const Values& v);
  std::optional<Doubt> told(const Values& v);
  std::optional<Doubt> at_once(const Values& v);
  std::optional<Doubt> lies_clear(sema::ZoneId zone, const Values& v, std::int64_t gap_mm);
  std::optional<Doubt> ways(const Values& v);
  bool bars(const sema::Expr& e, const geometry::Point& at, const Rational& radius);
  std::optional<Doubt> led_in(const sema::Decision& d, const sema::Monitor& m, sema::ZoneId zone,
                              const Cells& cells, const Rational& route);
  std::optional<Doubt> lasts(const Values& v);
  std::optional<Doubt> by_border(const Values& v);
  std::optional<Doubt> around(const Values& v);
  std::optional<Doubt> leaves(const Values& v);
  std::optional<Doubt> parting(const Values& v);
  std::optional<Doubt> legs(const Values& v);
  bool lets_go_at_height(const sema::Decision& d, const sema::Monitor& m, sema::ZoneId zone);
  std::optional<Doubt> in_sight(const sema::Decision& d, sema::ZoneId zone, std::size_t slab,
                                const Values& v);
  std::optional<Doubt> height(const Values& v);
  std::optional<Doubt> landing(const Values& v);
  std::optional<Doubt> outranks(const Values& v);
  std::optional<Doubt> coordinated(const Values& v);
  std::optional<Doubt> sides(const Values& v);
  std::optional<Doubt> fails(const Values& v);
  std::optional<Doubt> known(const Values& v);
  std::optional<Doubt> on_plan(const Values& v);
  std::optional<Doubt> no_fences(const Values& v);

  const sema::Decision* decision(const Values& v) const;

  const sema::Spec& spec_;
  NamedZones zones_;
  ProveLemma prove_;
  bool gave_up_ = false;
  std::map<std::string, std::optional<Doubt>> lemmas_;  // each is proved once
};

// Of legs that keep less free than those of the recovery.
inline constexpr const char* too_near = "the legs of the recovery keep more clear than it says";
Doubt wrong(std::string why);
Rational milli(std::int64_t n);
// What is left of a length where curves and offsets are known from inside.
Rational without_excess(const Rational& length);
Rational micro(std::int64_t n);
// nullopt: there is none, or it is no number.
std::optional<std::int64_t> number(const Values& v, const std::string& key);
std::string text(const Values& v, const std::string& key);
// Of "calm;shut".
std::set<std::string> names_in(const std::string& text);
const sema::Monitor* monitor_of(const sema::Spec& spec, const sema::Decision& d,
                                const std::string& name);

// The zones that a property keeps the robot in whatever else it says, those whose clearance it
// bounds from below, and those of all its atoms.
std::vector<sema::ZoneId> kept_in(const sema::Spec& spec, const sema::Expr& property);
std::vector<sema::ZoneId> asked_in(const sema::Spec& spec, const sema::Expr& property);
std::vector<sema::ZoneId> all_zones(const sema::Expr& property);
// The largest c of `clearance(r, zone) >= c` in a property, whatever its parameters become; and the
// largest that holds wherever the property does, whatever they are.
Rational gap_of(const sema::Spec& spec, const sema::Expr& property, sema::ZoneId zone);
Rational sure_gap_of(const sema::Spec& spec, const sema::Expr& property, sema::ZoneId zone);
// Whether its author says that it looks ahead less far, or at less, than it takes.
inline bool is_unsound(const sema::Ahead& ahead) {
  return ahead.duration_unsound || !ahead.unsound_reason.empty();
}
// Whether a property that has to be true, or false, allows a height, with `gap` to spare of each of
// its limits, or of those from below or above. What is not read as one allows none.
enum class Heights { all, from_below, from_above };
bool keeps_heights(const sema::Spec& spec, const sema::Expr& property, bool value,
                   const Rational& z, const Rational& gap, Heights which = Heights::all);
// The same wherever something is so far inside of a solid, `left`.
bool keeps_heights_inside(const sema::Spec& spec, const sema::Expr& property, bool value,
                          const geometry::Solid& solid, const Rational& left, const Rational& gap);
// The zones that a recovery moves within, of all of its steps.
std::vector<sema::ZoneId> moves_within(const sema::Controller& controller);

}  // namespace rtac::recheck
