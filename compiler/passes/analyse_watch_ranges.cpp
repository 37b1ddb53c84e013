#include "compiler/passes/analyse_watch_ranges.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <vector>

#include "compiler/ir/grid_help.h"
#include "compiler/ir/operands.h"
#include "compiler/ir/weights.h"
#include "compiler/sema/dimension.h"

namespace rtac::passes {
namespace {

using namespace ir;

// Beyond it an age is unknown: 2^50 us, 35 years (kernel: AGE_MAX_US).
constexpr Range number_of_robots{0, std::int64_t{1} << 16};  // more than any fleet has
constexpr std::int64_t age_max_us = std::int64_t{1} << 50;

// Places beyond it are held against no zone: products of the kernel fit 63 bits up to here. Zones
// end at 2^29 mm; a quarter of that is room for the error of a measured place.
constexpr std::int64_t place_mm_max = (std::int64_t{1} << 29) + (std::int64_t{1} << 27);

// Legs are held against zones on the map alone. Far from them distances are known to 2^32 mm, and
// what a leg may fall below is half of the map's diagonal more.
constexpr std::int64_t map_mm_max = std::int64_t{1} << 29, trail_mm_max = std::int64_t{1} << 33;

Rational exact(std::int64_t value) {
  return Rational(static_cast<long>(value));
}

// An interval that may still be too large.
struct Wide {
  Rational lo, hi;
  bool declared = true;
};
Wide wide(const Range& r) {
  return {exact(r.lo), exact(r.hi), r.declared};
}
Wide hull(std::initializer_list<Rational> ends, bool declared) {
  return {std::min(ends), std::max(ends), declared};
}
Wide product(const Wide& a, const Wide& b) {
  return hull(
      {Rational(a.lo * b.lo), Rational(a.lo * b.hi), Rational(a.hi * b.lo), Rational(a.hi * b.hi)},
      a.declared && b.declared);
}
Wide absolute(const Wide& a) {
  const Rational one = abs(a.lo), other = abs(a.hi);
  const bool has_zero = sgn(a.lo) <= 0 && sgn(a.hi) >= 0;
  return {has_zero ? Rational(0) : std::min(one, other), std::max(one, other), a.declared};
}
// Outward; of what is not negative.
std::int64_t root(const Rational& value, bool up) {
  const mpz_class whole(sgn(value) < 0 ? mpz_class(0)
                                       : mpz_class(value.get_num() / value.get_den()));
  const mpz_class down = sqrt(whole);
  return down.get_si() + (up && down * down < whole ? 1 : 0);
}

class WatchRanges {
 public:
  WatchRanges(const Module& module, const Watch& watch, diag::Engine& diagnostics)
      : module_(module), watch_(watch), span_max_(span_max(module)), diagnostics_(diagnostics) {}

  void block(Block& block) {
    block_ = &block;
    refused_.assign(block.values.size(), false);
    for (std::size_t i = 0; i < block.values.size(); ++i) {
      Value& value = block.values[i];
      value_ = &value;
      follows_refused_ = is_made_of_refused(value);
      refused_[i] = follows_refused_;
      if (value.unit) value.range = checked(std::visit(*this, value.op));
      follows_refused_ = false;
      if (std::holds_alternative<AtLeast>(value.op)) weight(std::get<AtLeast>(value.op));
    }
  }

  Wide operator()(const Const& v) const { return {exact(v.value), exact(v.value), true}; }
  Wide operator()(const Input& v) const {
    const ChannelGrid& c = watch_.inputs[v.channel].grid(v.component);
    const Rational error = exact(c.error_steps);
    return {exact(c.range.lo) - error, exact(c.range.hi) + error, c.range.declared};
  }
  // An age is unknown without a sample, not of any length.
  Wide operator()(const Age&) const { return {0, exact(age_max_us), false}; }
  Wide operator()(const SensedAge&) const { return {0, exact(age_max_us), false}; }
  Wide operator()(const ParamValue& v) const { return wide(watch_.params[v.param].range); }
  Wide operator()(const Add& v) const {
    const Wide a = of(v.a), b = of(v.b);
    return {a.lo + b.lo, a.hi + b.hi, a.declared && b.declared};
  }
  Wide operator()(const Negate& v) const {
    const Wide a = of(v.a);
    return {-a.hi, -a.lo, a.declared};
  }
  Wide operator()(const Scale& v) {
    // the kernel multiplies before it divides
    const Wide times = product(of(v.a), {exact(v.num), exact(v.num), true});
    checked(times);
    const Rational den = exact(v.den);
    return {exact_floor(times.lo / den), exact_ceil(times.hi / den), times.declared};
  }
  Wide operator()(const Multiply& v) const { return product(of(v.a), of(v.b)); }
  Wide operator()(const Minimum& v) const {
    const Wide a = of(v.a), b = of(v.b);
    return {std::min(a.lo, b.lo), std::min(a.hi, b.hi), a.declared && b.declared};
  }
  Wide operator()(const Maximum& v) const {
    const Wide a = of(v.a), b = of(v.b);
    return {std::max(a.lo, b.lo), std::max(a.hi, b.hi), a.declared && b.declared};
  }
  Wide operator()(const Absolute& v) const { return absolute(of(v.a)); }
  Wide operator()(const Root& v) {
    const Wide a = of(v.a);
    if (sgn(a.lo) < 0) refuse_root(a);
    return {exact(root(a.lo, false)), exact(root(a.hi, true)), a.declared};
  }
  Wide operator()(const Norm& v) {
    const Wide a = absolute(of(v.a)), b = absolute(of(v.b));
    const Wide squares{a.lo * a.lo + b.lo * b.lo, a.hi * a.hi + b.hi * b.hi,
                       a.declared && b.declared};
    if (!fits(squares)) return checked_as_wide(squares);
    return {exact(root(squares.lo, false)), exact(root(squares.hi, true)), squares.declared};
  }
  Wide operator()(const PointClearance& v) {
    const Wide x = of(v.a), y = of(v.b);
    if (!fits_below(x, place_mm_max) || !fits_below(y, place_mm_max)) refuse_place(x, y);
    const bool declared = x.declared && y.declared;
    if (watch_[v.within].channel) return of_received(x, y);
    return {-exact(root(farthest(watch_[v.within], x, y), true)), exact(deepest(watch_[v.around])),
            declared};
  }
  Wide operator()(const SolidClearance& v) {
    const Wide x = of(v.a), y = of(v.b), z = of(v.c);
    for (const Wide* c : {&x, &y, &z}) {
      if (!fits_below(*c, place_mm_max)) {
        refuse_place(x, y, &z);
        break;
      }
    }
    const bool declared = x.declared && y.declared && z.declared;
    return {-exact(root(farthest(watch_[v.within], x, y, z), true)),
            exact(deepest(watch_[v.around])), declared};
  }
  Wide operator()(const TrailClearance& v) {
    on_map(v.trail);
    const bool received = watch_[v.within].channel.has_value();
    return {-exact(trail_mm_max), exact(received ? trail_mm_max : deepest(watch_[v.around])),
            false};
  }
  Wide operator()(const TrailDistance& v) {
    on_map(v.trail);
    on_map(v.other);
    return {0, exact(trail_mm_max), false};
  }
  Wide operator()(const Between& v) const { return {exact(v.lo), exact(v.hi), true}; }
  Wide operator()(const Phase& v) {
    const Wide angle = of(v.a);
    const Wide fine = product(angle, {exact(v.least_q16), exact(v.most_q16), true});
    if (!fits(fine)) refuse_angle(v, angle);
    constexpr std::int64_t q16 = 1 << 16;
    return {exact_floor(fine.lo / exact(q16)), exact_ceil(fine.hi / exact(q16)), angle.declared};
  }
  Wide operator()(const Sine& v) const { return share(v.a); }
  Wide operator()(const Cosine& v) const { return share(v.a); }
  Wide operator()(const Choose& v) const {
    const Wide a = of(v.a), b = of(v.b);
    return {std::min(a.lo, b.lo), std::max(a.hi, b.hi), a.declared && b.declared};
  }
  Wide operator()(const Aggregate& v) {
    const std::int64_t ticks = v.window.to - v.window.from + 1;
    if (v.fold == Fold::count) {
      return {0, v.window.to < 0 ? exact(age_max_us) : exact(ticks), true};
    }
    const Wide a = of(v.a);
    if (!a.declared && !fits_below(a, span_max_)) refuse_undeclared(a);
    switch (v.fold) {
      case Fold::minimum:
      case Fold::maximum:
        return a;
      case Fold::mean:
      case Fold::sum: {
        const Wide sum{std::min(Rational(a.lo * exact(ticks)), Rational(0)),
                       std::max(Rational(a.hi * exact(ticks)), Rational(0)), a.declared};
        if (v.fold == Fold::sum) return sum;
        checked(sum);
        return a;
      }
      case Fold::rate:
        return {a.lo - a.hi, a.hi - a.lo, a.declared};
      case Fold::count:
        break;
    }
    return a;
  }
  // of facts
  Wide operator()(const Battery& v) const { return of_robot(v); }
  Wide operator()(const Speed& v) const { return of_robot(v); }
  Wide operator()(const Altitude& v) const { return of_robot(v); }
  Wide operator()(const Clearance& v) const { return of_robot(v); }
  Wide operator()(const EnergyTo& v) const { return of_robot(v); }
  Wide operator()(const AgentDistance& v) const { return of_robot(v); }
  Wide operator()(const CountOthers&) const {
    Wide any = wide(number_of_robots);
    any.declared = false;
    return any;
  }
  // Other operations of robots never occur here (verified IR), and margins have no range.
  template <class Other>
  Wide operator()(const Other&) const {
    return {0, 0, true};
  }

 private:
  [[nodiscard]] Wide of(ValueId id) const { return wide(*(*block_)[id].range); }
  // A kind of robot declares no range: what the numbers of the kernel hold says nothing of a tick
  // at which it is unknown.
  [[nodiscard]] Wide of_robot(const Op& op) const {
    Wide any = wide(range_of_robot(module_, op));
    any.declared = false;
    return any;
  }
  // A sine or cosine in units of 2^-30; of what has no range it has one all the same.
  [[nodiscard]] Wide share(ValueId phase) const {
    const Rational one = exact(std::int64_t{1} << 30);
    return {-one, one, of(phase).declared};
  }
  static Rational exact_floor(const Rational& v) {
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), v.get_num().get_mpz_t(), v.get_den().get_mpz_t());
    return Rational(whole);
  }
  static Rational exact_ceil(const Rational& v) { return -exact_floor(Rational(-v)); }
  void on_map(const Trail& t) {
    for (std::size_t i = 0; i + 1 < t.own.size(); i += 2) {
      const Wide x = of(t.own[i]), y = of(t.own[i + 1]);
      if (!fits_below(x, map_mm_max) || !fits_below(y, map_mm_max)) {
        refuse_place(x, y, nullptr, map_mm_max);
      }
    }
  }
  static bool fits_below(const Wide& w, std::int64_t limit) {
    return w.lo >= -exact(limit) && w.hi <= exact(limit);
  }
  // Square of a distance that no place is farther from the region: of vertices, the one whose
  // farthest corner is nearest.
  static Rational farthest(const Region& region, const Wide& x, const Wide& y) {
    std::optional<Rational> least;
    for (const Edge& e : region.edges) {
      const Rational dx = std::max(abs(Rational(x.lo - e.ax)), abs(Rational(x.hi - e.ax)));
      const Rational dy = std::max(abs(Rational(y.lo - e.ay)), abs(Rational(y.hi - e.ay)));
      const Rational square = dx * dx + dy * dy;
      if (!least || square < *least) least = square;
    }
    return *least;
  }
  // Of a zone that may be anywhere on the grid, and anything.
  static Wide of_received(const Wide& x, const Wide& y) {
    const Rational reach = exact(std::int64_t{1} << 29);
    const Rational dx = std::max(abs(x.lo), abs(x.hi)) + reach;
    const Rational dy = std::max(abs(y.lo), abs(y.hi)) + reach;
    return {-exact(root(dx * dx + dy * dy, true)), reach, false};
  }
  // No place of the region is farther from its boundary.
  static std::int64_t deepest(const Region& region) {
    std::int64_t x0 = region.edges[0].ax, x1 = x0, y0 = region.edges[0].ay, y1 = y0;
    for (const Edge& e : region.edges) {
      x0 = std::min<std::int64_t>(x0, e.ax), x1 = std::max<std::int64_t>(x1, e.ax);
      y0 = std::min<std::int64_t>(y0, e.ay), y1 = std::max<std::int64_t>(y1, e.ay);
    }
    return (std::min(x1 - x0, y1 - y0) + 1) / 2;
  }
  // The same in space.
  [[nodiscard]] Rational farthest(const Solid& solid, const Wide& x, const Wide& y,
                                  const Wide& z) const {
    std::optional<Rational> least;
    for (const Slab& slab : solid.slabs) {
      const Rational across = farthest(watch_[slab.region], x, y);
      for (const std::int32_t height : {slab.floor_mm, slab.ceiling_mm}) {
        const Rational dz = std::max(abs(Rational(z.lo - height)), abs(Rational(z.hi - height)));
        const Rational square = across + dz * dz;
        if (!least || square < *least) least = square;
      }
    }
    return *least;
  }
  [[nodiscard]] std::int64_t deepest(const Solid& solid) const {
    std::vector<Edge> edges;
    for (const Slab& slab : solid.slabs) {
      std::ranges::copy(watch_[slab.region].edges, std::back_inserter(edges));
    }
    const std::int64_t height =
        std::int64_t{solid.slabs.back().ceiling_mm} - solid.slabs.front().floor_mm;
    return std::min(deepest({"", false, std::move(edges), {}}), (height + 1) / 2);
  }
  [[nodiscard]] bool is_made_of_refused(const Value& value) const {
    bool result = false;
    for_each_operand(
        value.op, [&](ValueId id) { result = result || refused_[static_cast<std::uint32_t>(id)]; });
    return result;
  }
  static bool fits(const Wide& w) { return fits_below(w, quantity_max); }

  Range checked(const Wide& w) {
    if (fits(w)) return {floor_to_int(w.lo), ceil_to_int(w.hi), w.declared};
    report("this value ranges over " + shown(w) + ", more than the kernel holds",
           "the kernel holds " + std::string("2^61 steps of ") +
               sema::show(value_->unit->step, value_->unit->dimension),
           "narrower ranges (`in a .. b`) or a coarser `resolution` of the inputs work");
    return {-quantity_max, quantity_max, w.declared};
  }
  Wide checked_as_wide(const Wide& w) {
    report("the squares of this norm leave the kernel's 62 bits", "",
           "inputs within +-2^29 steps of their resolution work: declare `in a .. b` or a coarser "
           "`resolution`");
    return {0, exact(quantity_max), w.declared};
  }
  void refuse_place(const Wide& x, const Wide& y, const Wide* z = nullptr,
                    std::int64_t most_mm = place_mm_max) {
    const Unit& unit = *value_->unit;
    const std::string height = z != nullptr ? ", in height over " + shown(*z, unit) : "";
    report("this place ranges over " + shown(x, unit) + " and " + shown(y, unit) + height +
               ", beyond the grid of zones",
           "coordinates of at most " +
               sema::show(Rational(exact(most_mm) * unit.step), unit.dimension) + " work",
           "declare a range (`in a .. b`) of the inputs that it is made of");
  }
  void refuse_root(const Wide& a) {
    const Unit& unit = *(*block_)[std::get<Root>(value_->op).a].unit;
    report("the root of something that may be negative: its operand ranges over " + shown(a, unit),
           "", "`sqrt(max(x, 0))` works, or a range of the inputs that leaves negative ones out");
  }
  void refuse_angle(const Phase& v, const Wide& a) {
    const Unit& unit = *(*block_)[v.a].unit;
    report("the angle of this turn ranges over " + shown(a, unit) + ", more than the kernel holds",
           "", "declare the range of the angle (`in -180 .. 180 deg`), or a coarser `resolution`");
  }
  void refuse_undeclared(const Wide& a) {
    report("this value ranges over " + shown(a) + " and its inputs have no declared range", "",
           "declare ranges (`in a .. b`) of the inputs, or bound it: `min(max(x, a), b)`");
  }
  void weight(const AtLeast& v) {
    const Unit& unit = *(*block_)[v.a].unit;
    const Weight weight = weight_of(unit);
    if (weight.num > 0 && unit.is_fine_enough()) return;
    const Rational counted = unit.weight();
    if (counted >= 1 && counted <= exact(1'000'000'000'000)) return refuse_fraction(v, unit);
    report("margins cannot be counted in millionths of the scale " +
               sema::show(unit.scale, unit.dimension),
           "one step is " + sema::show(unit.step, unit.dimension),
           "a `scale` between a millionth and a million of the `resolution` works");
  }
  // The scale is near enough, but 64 bits do not hold the fraction: a degree is none of a radian.
  void refuse_fraction(const AtLeast& v, const Unit& unit) {
    const auto is_input = [&](ValueId id) {
      return std::holds_alternative<Input>((*block_)[id].op);
    };
    const auto round = round_resolution(unit);
    const bool is_of_input = round && (is_input(v.a) || is_input(v.b));
    report("margins count millionths of the scale " + sema::show(unit.scale, unit.dimension) +
               ", and the step here is no simple fraction of it",
           "one step is about " + sema::show(unit.step, unit.dimension),
           is_of_input ? "`resolution " + *round +
                             "` at the input works, with constants that are multiples of it"
                       : "resolutions of the inputs with a few decimals in SI units work, and "
                         "constants that are multiples of them");
  }
  static std::string shown(const Wide& w, const Unit& unit) {
    return "[" + sema::show(Rational(w.lo * unit.step), unit.dimension) + ", " +
           sema::show(Rational(w.hi * unit.step), unit.dimension) + "]";
  }
  [[nodiscard]] std::string shown(const Wide& w) const { return shown(w, *value_->unit); }
  // The range of what is made of a refused value is that of no input: it is not reported again.
  void report(std::string what, std::string label, std::string help) {
    if (follows_refused_) return;
    refused_[static_cast<std::size_t>(value_ - block_->values.data())] = true;
    diagnostics_.report({diag::Code::value_out_of_range,
                         value_->source,
                         std::move(what),
                         std::move(label),
                         {},
                         std::move(help),
                         {}});
  }

  const Module& module_;
  const Watch& watch_;
  const std::int64_t span_max_;
  diag::Engine& diagnostics_;
  const Block* block_ = nullptr;
  const Value* value_ = nullptr;
  std::vector<bool> refused_;     // of the values of the block
  bool follows_refused_ = false;  // the present value is made of one of them
};

}  // namespace

Range range_of_robot(const Module& module, const Op& op) {
  if (std::holds_alternative<CountOthers>(op)) return number_of_robots;
  constexpr std::int64_t gap_mm = std::int64_t{1} << 31;  // any distance within the extent
  constexpr std::int64_t speed_mmps = 1 << 30;
  if (std::holds_alternative<Speed>(op)) return {0, speed_mmps};
  if (std::holds_alternative<Battery>(op)) return {-2'000'000, 3'000'000};
  const auto* energy = std::get_if<EnergyTo>(&op);
  if (!energy) return {-gap_mm, gap_mm};
  std::int64_t most = no_way;
  for (const auto& place : module[energy->site].places) {
    for (const std::int32_t cost : place.cost_ppm) most = std::max<std::int64_t>(most, cost);
  }
  return {0, most};
}

void analyse_watch_ranges(Module& module, diag::Engine& diagnostics) {
  const auto analyse = [&](Watch& watch) {
    WatchRanges ranges(module, watch, diagnostics);
    for (PlainMonitor& monitor : watch.monitors) ranges.block(monitor.property);
  };
  for (Decision& decision : module.decisions) analyse(decision.facts);
  if (module.watch) analyse(*module.watch);
}

}  // namespace rtac::passes
