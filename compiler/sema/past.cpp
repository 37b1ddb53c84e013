// Operators of the past and aggregates over windows (language rules 1 and 2).
#include <algorithm>

#include "compiler/sema/property_checker.h"
#include "compiler/sema/suggest.h"
#include "compiler/sema/ticks.h"
#include "compiler/sema/units.h"
#include "compiler/syntax/habits.h"

namespace rtac::sema {

namespace {

struct AggregateName {
  const char* name;
  AggregateOp op;
};
constexpr AggregateName aggregates[] = {
    {"min", AggregateOp::minimum}, {"max", AggregateOp::maximum}, {"mean", AggregateOp::mean},
    {"sum", AggregateOp::sum},     {"count", AggregateOp::count}, {"rate", AggregateOp::rate},
};

// What is wrong with the unit of one is wrong with the other.
bool same_unit(const syntax::Expr& one, const syntax::Expr& other) {
  const auto* a = std::get_if<syntax::NumberLit>(&one.node);
  const auto* b = std::get_if<syntax::NumberLit>(&other.node);
  return a != nullptr && b != nullptr && a->unit && b->unit && a->unit->text == b->unit->text;
}

std::optional<AggregateOp> aggregate_named(const std::string& name) {
  for (const AggregateName& each : aggregates) {
    if (name == each.name) return each.op;
  }
  return std::nullopt;
}

}  // namespace

const std::vector<std::string>& aggregate_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const AggregateName& each : aggregates) all.emplace_back(each.name);
    return all;
  }();
  return names;
}

ExprPtr PropertyChecker::judged_now(ExprPtr built, const std::string& what,
                                    const std::string& instead) {
  const bool looked_ahead = scope_.place == Place::robot_always || other_ != nullptr;
  if (!built || !looked_ahead || !speaks_of_robot(*built)) return built;
  report_looked_ahead(built->range, what, instead);
  return nullptr;
}

void PropertyChecker::report_looked_ahead(const SourceRange& range, const std::string& what,
                                          const std::string& instead) {
  const bool of_pair = other_ != nullptr && scope_.place == Place::robot_return;
  Finding finding(Code::not_for_robots, range,
                  what + (of_pair ? " of another robot cannot stand inside `forall` or `exists`"
                                  : " of the state of a robot cannot be looked ahead"));
  if (of_pair) {
    finding.label("one for each other robot").help("write it around the quantifier");
  } else {
    finding.label("speaks of the robot")
        .help(
            "over inputs and parameters it is judged now, and works here; over the robot it works "
            "in `return when`");
  }
  if (!instead.empty()) finding.help(instead);
  if (function_ != nullptr) finding.note(call_, "it comes into the monitor by this call");
  context_.report(finding);
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::Held& held) {
  ExprPtr operand = condition(*held.operand);
  const auto duration =
      duration_of(*held.duration, "the duration of `for`", Limit::positive, Longer::stricter);
  if (!operand || !duration) return nullptr;
  const bool looked_ahead = scope_.place == Place::robot_always || other_ != nullptr;
  if (looked_ahead && speaks_of_robot(*operand)) {
    Finding finding(Code::held_misplaced, expr.range,
                    std::string("`for` with a duration cannot stand ") +
                        (other_ != nullptr ? "inside `forall` or `exists`" : "in `always`"));
    finding.label("speaks of the robot: only in `return when`")
        .help(other_ != nullptr ? "write it around the quantifier: `(forall ...) for 1 s`"
                                : "judge the present state here, and write `return when ... "
                                  "for 1 s`");
    if (function_ != nullptr) finding.note(call_, "it comes into the monitor by this call");
    context_.report(finding);
    return nullptr;
  }
  return make_condition(expr.range, HeldFor{std::move(operand), *duration});
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::Previously& previously) {
  ExprPtr operand = condition(*previously.operand);
  if (!operand) return nullptr;
  return judged_now(make_condition(expr.range, Previously{std::move(operand)}), "`previously`");
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::Past& past) {
  const bool once = past.op == syntax::PastOp::once;
  const auto interval = interval_of(past.interval ? &*past.interval : nullptr, expr.range,
                                    once ? Longer::truer : Longer::stricter);
  ExprPtr operand = condition(*past.operand);
  if (!interval || !operand) return nullptr;
  const PastOp op = once ? PastOp::once : PastOp::historically;
  return judged_now(make_condition(expr.range, Past{op, *interval, std::move(operand)}),
                    once ? "`once`" : "`historically`");
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::Since& since) {
  ExprPtr left = condition(*since.left);
  const auto interval =
      interval_of(since.interval ? &*since.interval : nullptr, expr.range, Longer::truer);
  ExprPtr right = condition(*since.right);
  if (!interval || !left || !right) return nullptr;
  return judged_now(make_condition(expr.range, Since{*interval, std::move(left), std::move(right)}),
                    "`since`");
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::WithinOf& within) {
  ExprPtr operand = condition(*within.operand);
  const auto duration =
      duration_of(*within.duration, "the duration of `within`", Limit::not_negative, Longer::truer);
  polarity_ = -polarity_;  // an earlier trigger asks for more
  ExprPtr trigger = condition(*within.trigger);
  polarity_ = -polarity_;
  if (!operand || !duration || !trigger) return nullptr;
  return judged_now(
      make_condition(expr.range, WithinOf{std::move(operand), std::move(trigger), *duration}),
      "`within ... of`");
}

bool PropertyChecker::whole_ticks(const Quantity& duration, Limit limit, Longer longer) {
  const auto& period = context_.spec.period;
  // The period of a robot's monitor is that of its decision: triggers.cpp.
  if (scope_.of_robot() || !period) return true;
  Stricter stricter = Stricter::neither;
  if (longer != Longer::neither && polarity_ != 0) {
    const bool longer_is_stricter = (longer == Longer::stricter) == (polarity_ > 0);
    stricter = longer_is_stricter ? Stricter::above : Stricter::below;
  }
  if (!whole_periods(context_, duration, *period, "the monitors without a robot have this period",
                     stricter, limit)) {
    return false;
  }
  return window_holds(context_, duration, *period);
}

std::optional<Quantity> PropertyChecker::duration_of(const syntax::Expr& expr,
                                                     const std::string& what, Limit limit,
                                                     Longer longer) {
  if (is_error(expr)) return std::nullopt;
  const auto duration = quantity(context_, expr, {dims::time, what, limit});
  return duration && whole_ticks(*duration, limit, longer) ? duration : std::nullopt;
}

// `[0 s, 2]`: the end that lacks a unit is in that of the other one.
bool PropertyChecker::ends_share_unit(const syntax::Expr& from, const syntax::Expr& to) {
  const auto& low = std::get<syntax::NumberLit>(from.node);
  const auto& high = std::get<syntax::NumberLit>(to.node);
  const std::string& unit = (low.unit ? low : high).unit->text;
  const auto meaning = parse_unit(unit);
  if (!meaning || meaning->dimension != dims::time) return true;  // which is told first
  const syntax::Expr& bare = low.unit ? to : from;
  const std::string& number = std::get<syntax::NumberLit>(bare.node).text;
  context_.report(Finding(Code::unit_missing, bare.range,
                          "`" + number + "` has no unit where a time (s) is due")
                      .label("an interval reaches from one time to another")
                      .help("write `" + number + " " + unit + "`")
                      .insert_after(bare.range, " " + unit));
  return false;
}

// Mistakes of both ends at once, which are one mistake: `[0, 10]`, and `inf` where it cannot stand.
bool PropertyChecker::ends_fit(const syntax::Interval& written) {
  const syntax::Name* from = name_in(*written.from);
  if (from != nullptr && from->text == "inf" && local("inf") == nullptr) {
    context_.report(Finding(Code::not_constant, written.from->range,
                            "an interval cannot begin without an end in the past")
                        .label("only the upper end may be `inf`")
                        .help("write `[0 s, inf]`"));
    return false;
  }
  const auto* low = written.to ? std::get_if<syntax::NumberLit>(&written.from->node) : nullptr;
  const auto* high = written.to ? std::get_if<syntax::NumberLit>(&written.to->node) : nullptr;
  if (low == nullptr || high == nullptr || (low->unit && high->unit)) return true;
  if (low->unit || high->unit) return ends_share_unit(*written.from, *written.to);
  const std::string unit = " " + likely_unit(dims::time, high->value);
  context_.report(
      Finding(Code::unit_missing, written.range,
              "`" + low->text + "` and `" + high->text + "` have no unit where times (s) are due")
          .label("an interval reaches from one time to another")
          .help("write `[" + low->text + unit + ", " + high->text + unit + "]`")
          .insert_after(written.from->range, unit)
          .insert_after(written.to->range, unit));
  return false;
}

std::optional<Interval> PropertyChecker::interval_of(const syntax::Interval* written,
                                                     const SourceRange& place, Longer wider) {
  if (written == nullptr) return Interval{{0, place}, std::nullopt};
  if (!ends_fit(*written)) return std::nullopt;
  const Longer narrower = wider == Longer::truer      ? Longer::stricter
                          : wider == Longer::stricter ? Longer::truer
                                                      : Longer::neither;
  const auto from =
      duration_of(*written->from, "the lower bound of an interval", Limit::not_negative, narrower);
  std::optional<Quantity> to;
  if (!from && written->to && same_unit(*written->from, *written->to)) return std::nullopt;
  if (written->to) {
    to = duration_of(*written->to, "the upper bound of an interval", Limit::not_negative, wider);
    if (!to) return std::nullopt;
  }
  if (!from) return std::nullopt;
  if (!to || from->value <= to->value) return Interval{*from, to};
  context_.report(Finding(Code::interval_reversed, written->range,
                          "the interval goes from " + show(from->value, dims::time) + " back to " +
                              show(to->value, dims::time))
                      .label("ends before it begins")
                      .help("write `[" + show(to->value, dims::time) + ", " +
                            show(from->value, dims::time) + "]`: both count into the past")
                      .replace(written->range, "[" + show(to->value, dims::time) + ", " +
                                                   show(from->value, dims::time) + "]"));
  return std::nullopt;
}

void PropertyChecker::unknown_aggregate(const syntax::Name& name) {
  const std::string& text = name.text;
  const bool order = text == "median" || text == "percentile" || text == "quantile";
  const auto habit = syntax::function_habit(text);
  Finding finding(Code::unknown_function, name.range,
                  "there is no aggregate `" + text + "` over a window");
  finding.label("not an aggregate");
  if (order) {
    finding.help(
        "it needs the whole window sorted every tick: use `min`, `max` or `mean`, or compute it "
        "outside and pass it as an input");
  } else if (habit) {
    finding.help(std::string(*habit));
  } else {
    finding.help(did_you_mean(text, aggregate_names(), "aggregates"));
    if (const auto likely = nearest(text, aggregate_names())) finding.replace(name.range, *likely);
  }
  context_.report(finding);
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::Aggregate& aggregate) {
  const std::string& name = aggregate.name.text;
  const auto op = aggregate_named(name);
  if (!op) {
    unknown_aggregate(aggregate.name);
    return nullptr;
  }
  const auto interval = interval_of(&aggregate.interval, expr.range, Longer::neither);
  if (interval && !window_fits(aggregate, *op, *interval)) return nullptr;
  const Interval window = interval.value_or(Interval{{0, expr.range}, std::nullopt});
  ExprPtr value = aggregate_of(expr, *op, window, *aggregate.operand);
  return interval ? judged_now(std::move(value), "`" + name + "` over a window") : nullptr;
}

ExprPtr PropertyChecker::aggregate_of(const syntax::Expr& expr, AggregateOp op, Interval interval,
                                      const syntax::Expr& operand) {
  if (op == AggregateOp::count) {
    const int outer = polarity_;
    polarity_ = 0;
    ExprPtr counted = condition(operand);
    polarity_ = outer;
    if (!counted) return nullptr;
    return make_quantity(expr.range, dims::number,
                         Aggregate{op, std::move(interval), std::move(counted)});
  }
  ExprPtr quantity = quantity_of(operand);
  if (!quantity) return nullptr;
  const Dimension dimension =
      op == AggregateOp::rate ? quantity->dimension / dims::time : quantity->dimension;
  return make_quantity(expr.range, dimension,
                       Aggregate{op, std::move(interval), std::move(quantity)});
}

bool PropertyChecker::window_fits(const syntax::Aggregate& aggregate, AggregateOp op,
                                  const Interval& interval) {
  const bool extremum = op == AggregateOp::minimum || op == AggregateOp::maximum;
  const std::string name = "`" + aggregate.name.text + "`";
  if (!interval.to && !extremum) {
    context_.report(
        Finding(Code::window_not_finite, aggregate.interval.range,
                name + " over a window without an end grows for ever")
            .label("must be finite")
            .help("give the window an end, as in `" + aggregate.name.text + "[0 s, 10 s](...)`"));
    return false;
  }
  if (op != AggregateOp::rate || interval.from.value < interval.to->value) return true;
  context_.report(Finding(Code::interval_reversed, aggregate.interval.range,
                          "`rate` needs two different ends of its window")
                      .label("no time passes between them")
                      .help("write `rate[0 s, 1 s](...)`: the change over that time"));
  return false;
}

}  // namespace rtac::sema
