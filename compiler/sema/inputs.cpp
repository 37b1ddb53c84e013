#include "compiler/sema/inputs.h"

#include "compiler/sema/import_schedule.h"
#include "compiler/sema/limits.h"
#include "compiler/sema/quantity.h"
#include "compiler/sema/types.h"
#include "compiler/sema/units.h"
#include "compiler/sema/value.h"

namespace rtac::sema {

namespace {

// language rule 13: what `grid` says, else 1 mm, 1 mm/s, 1 mrad, 1 us, 1 ppm; a bare number counts
// as a share.
Rational default_resolution(const Spec& spec, const ValueType& type, const Dimension& dimension) {
  if (type.kind == TypeKind::integer) return 1;
  for (const GridStep& grid : spec.grids) {
    if (grid.dimension == dimension) return grid.value.value;
  }
  const bool fine = dimension == dims::number || dimension == dims::time || dimension.ratio != 0;
  return fine ? Rational(1, 1000000) : Rational(1, 1000);
}

bool is_number(const ValueType& type) {
  return type.kind != TypeKind::boolean && type.kind != TypeKind::enumeration &&
         type.kind != TypeKind::zone && type.kind != TypeKind::path;
}

struct Range {
  Quantity least, most;
};

// The unit of `1 m` or `-1 m`, as the factor to SI; nullopt when it is written in another way.
std::optional<Rational> factor_of(const syntax::Expr& expr, const Dimension& due) {
  const auto* number = std::get_if<syntax::NumberLit>(&expr.node);
  if (number == nullptr) {
    const auto* unary = std::get_if<syntax::Unary>(&expr.node);
    if (unary == nullptr || unary->op != syntax::UnaryOp::negate) return std::nullopt;
    return factor_of(*unary->operand, due);
  }
  if (!number->unit) return std::nullopt;
  const auto meaning = parse_unit(number->unit->text);
  return meaning && meaning->dimension == due ? std::optional(meaning->factor) : std::nullopt;
}

// The lower end of a range; `0 .. 3 m/s` takes the unit of the upper one.
std::optional<Quantity> lower_end(Context& context, const syntax::Expr& least,
                                  const syntax::Expr& most, const Due& due) {
  const auto factor = factor_of(most, due.dimension);
  if (!factor || due.dimension == dims::number || bare_number(least) == nullptr) {
    return quantity(context, least, due);
  }
  auto end = quantity(context, least, {dims::number, due.what, due.limit});
  if (end) end->value *= *factor;
  return end;
}

std::optional<Quantity> whole(Context& context, const std::optional<Quantity>& number,
                              const std::string& what) {
  if (!number || number->value.get_den() == 1) return number;
  const std::int64_t below = fits_int64(number->value) ? floor_to_int(number->value) : 0;
  context.report(Finding(Code::quantity_out_of_range, number->range,
                         what + " cannot be " + to_decimal(number->value))
                     .label("must be a whole number")
                     .help(std::to_string(below) + " or " + std::to_string(below + 1) + " works"));
  return std::nullopt;
}

std::optional<Range> check_range(Context& context, const syntax::Expr& least,
                                 const syntax::Expr& most, const ValueType& type) {
  if (is_error(least) || is_error(most)) return std::nullopt;
  const bool bare = type.dimension == dims::number;
  const bool is_vector = type.kind == TypeKind::vector;
  const std::string name = is_vector ? (type.space ? "vector3" : "vector") : "real";
  const bool takes_unit = bare && (is_vector || type.kind == TypeKind::real);
  auto to = quantity(context, most,
                     {type.dimension, "the largest value", Limit::any, "", takes_unit ? name : ""});
  // Most often one unit goes for both: a mistake in it is not one of the lower end as well.
  if (!to) return std::nullopt;
  auto from = lower_end(context, least, most, {type.dimension, "the least value"});
  if (type.kind == TypeKind::integer) {
    from = whole(context, from, "the least value");
    to = whole(context, to, "the largest value");
  }
  if (!from || !to) return std::nullopt;
  if (from->value < to->value) return Range{*from, *to};
  SourceRange both = from->range;
  both.end = to->range.end;
  const bool one_value = from->value == to->value;
  const std::string turned =
      show(to->value, type.dimension) + " .. " + show(from->value, type.dimension);
  Finding finding(Code::range_empty, both,
                  "the range from " + show(from->value, type.dimension) + " to " +
                      show(to->value, type.dimension) +
                      (one_value ? " has one value only" : " is empty"));
  finding.label("must go from a smaller value to a larger one")
      .help(one_value ? "give two different ends" : "write `" + turned + "`");
  if (!one_value) finding.replace(both, turned);
  context.report(finding);
  return std::nullopt;
}

// Times that the clock can count in microseconds with room to spare: a day, and 30 years.
constexpr int period_s_max = 86'400;
constexpr int age_s_max = 1'000'000'000;

bool within_limit(Context& context, const Quantity& duration, int most_s, const std::string& what,
                  const std::string& instead) {
  if (duration.value <= most_s) return true;
  const std::string limit = show(Rational(most_s), dims::time);
  context.report(Finding(Code::limit_exceeded, duration.range,
                         what + " of " + show(duration.value, dims::time) + " is too long")
                     .label("at most " + limit)
                     .help("up to " + limit + " work" + instead));
  return false;
}

// What is measured in its own way, with its own range, error and resolution.
struct Part {
  Dimension dimension;
  const char* name;  // empty: the input as a whole
};
std::vector<Part> parts_of(const ValueType& type) {
  if (type.kind == TypeKind::pose) return {{dims::length, "position"}, {dims::angle, "heading"}};
  if (type.kind == TypeKind::twist) return {{dims::speed, "linear"}, {dims::turn_rate, "angular"}};
  return {{type.dimension, ""}};
}

class InputChecker {
 public:
  InputChecker(Context& context, std::uint32_t index)
      : context_(context),
        input_(context.spec.inputs[index]),
        written_(*context.inputs[index].node) {}

  // The clauses of `input a, b : real` are reported once, for the first name.
  bool check(const ValueType& type) {
    shape(input_, type);
    input_.held = written_.max_age_inf;
    const std::vector<Part> parts = parts_of(type);
    bool good = lengths_fit(parts, type);
    for (std::size_t i = 0; good && i < parts.size(); ++i) {
      Measurement& to = i == 0 ? input_ : *input_.turning;
      if (is_number(type)) to.resolution = default_resolution(context_.spec, type, to.dimension);
      good = check_interval(i, parts[i], type, to);
      if (!good && shares_misfit(i, parts[i])) return check_age() && good;
      good = check_error(i, parts[i], type, to) && good;
      good = check_resolution(i, parts[i], type, to) && good;
    }
    return check_age() && good;
  }

 private:
  // Range and error both have a unit of another dimension: that of the type is the mistake, which
  // was reported.
  [[nodiscard]] bool shares_misfit(std::size_t i, const Part& part) const {
    if (i >= written_.error.size()) return false;
    const syntax::Expr& error = *written_.error[i];
    return bare_number(error) == nullptr && !factor_of(error, part.dimension);
  }

  // One entry for all of the input, or one for each part.
  bool lengths_fit(const std::vector<Part>& parts, const ValueType& type) {
    bool good = true;
    const auto check = [&](const std::string& clause, std::size_t count, const SourceRange& range) {
      if (count == 0 || count == parts.size()) return;
      good = false;
      const bool two = parts.size() > 1;
      context_.report(
          Finding(Code::wrong_argument_count, range,
                  "`" + clause + "` of `" + input_.name + "` has " + std::to_string(count) +
                      (count == 1 ? " entry" : " entries") + ", " + describe(context_.spec, type) +
                      " takes " + std::to_string(parts.size()))
              .label(two ? std::string("one for `") + parts[0].name + "`, one for `" +
                               parts[1].name + "`"
                         : "one is due")
              .help(two ? "write both, with a comma between them" : "leave the others out"));
    };
    if (!written_.limits.empty()) {
      const syntax::Limits& last = written_.limits.back();
      check("in", written_.limits.size(), last.most ? last.most->range : input_.name_range);
    }
    if (!written_.error.empty())
      check("error", written_.error.size(), written_.error.back()->range);
    if (!written_.resolution.empty()) {
      check("resolution", written_.resolution.size(), written_.resolution.back()->range);
    }
    return good;
  }

  bool without_effect(const syntax::Expr& expr, const std::string& what, const ValueType& type) {
    if (is_error(expr)) return false;
    const std::string kind = type.kind == TypeKind::boolean   ? "a condition"
                             : type.kind == TypeKind::integer ? "a whole number"
                             : type.kind == TypeKind::zone    ? "a zone"
                             : type.kind == TypeKind::path    ? "a path"
                                                              : "a value of an enumeration";
    context_.report(Finding(Code::clause_without_effect, expr.range,
                            what + " has no effect on `" + input_.name + "`, which is " + kind)
                        .label("only quantities have one")
                        .help("leave it out"));
    return false;
  }

  [[nodiscard]] std::string subject(const std::string& clause, const Part& part) const {
    return "the `" + clause + "` of `" + input_.name + (*part.name ? "." : "") + part.name + "`";
  }

  bool check_interval(std::size_t i, const Part& part, const ValueType& type, Measurement& to) {
    if (i >= written_.limits.size()) return true;
    const syntax::Limits& limits = written_.limits[i];
    if (!limits.least || !limits.most) return true;
    if (!is_number(type)) return without_effect(*limits.least, "a range", type);
    ValueType of_part = type;
    of_part.dimension = part.dimension;
    const auto range = check_range(context_, *limits.least, *limits.most, of_part);
    if (!range) return false;
    to.least = range->least;
    to.most = range->most;
    return true;
  }

  bool check_error(std::size_t i, const Part& part, const ValueType& type, Measurement& to) {
    if (i >= written_.error.size()) return true;
    const syntax::Expr& error = *written_.error[i];
    if (!is_number(type) || type.kind == TypeKind::integer) {
      return without_effect(error, "an error", type);
    }
    to.error =
        quantity(context_, error, {part.dimension, subject("error", part), Limit::not_negative});
    return to.error.has_value();
  }

  bool check_resolution(std::size_t i, const Part& part, const ValueType& type, Measurement& to) {
    if (i >= written_.resolution.size()) return true;
    const syntax::Expr& resolution = *written_.resolution[i];
    if (!is_number(type) || type.kind == TypeKind::integer) {
      return without_effect(resolution, "a resolution", type);
    }
    const auto step = quantity(context_, resolution,
                               {part.dimension, subject("resolution", part), Limit::positive});
    if (step) to.resolution = step->value;
    return step.has_value();
  }

  bool check_age() {
    if (!written_.max_age || input_.held) return true;
    input_.max_age =
        quantity(context_, *written_.max_age,
                 {dims::time, "the `max_age` of `" + input_.name + "`", Limit::not_negative});
    return input_.max_age && within_limit(context_, *input_.max_age, age_s_max, "a `max_age`",
                                          "; `max_age inf` holds the last value");
  }

  Context& context_;
  Input& input_;
  const syntax::InputItem& written_;
};

// What the names of one item share is copied, so that a mistake in it is reported once.
void copy_clauses(const Input& from, Input& to) {
  const std::string name = to.name;
  const SourceRange range = to.name_range;
  to = from;
  to.name = name;
  to.name_range = range;
}

}  // namespace

namespace {

// How a scalar of this type arrives.
InputType input_type_of(TypeKind kind) {
  switch (kind) {
    case TypeKind::boolean:
      return InputType::boolean;
    case TypeKind::integer:
      return InputType::integer;
    case TypeKind::enumeration:
      return InputType::enumeration;
    case TypeKind::zone:
      return InputType::zone;
    case TypeKind::path:
      return InputType::path;
    case TypeKind::real:
    case TypeKind::point:
    case TypeKind::vector:
    case TypeKind::pose:
    case TypeKind::twist:
      return InputType::real;
  }
  return InputType::real;
}

// Of one element.
std::vector<std::string> components_of(const ValueType& type) {
  switch (type.kind) {
    case TypeKind::boolean:
    case TypeKind::integer:
    case TypeKind::enumeration:
    case TypeKind::real:
    case TypeKind::zone:
      return {""};
    case TypeKind::point:
    case TypeKind::vector:
      return type.space ? std::vector<std::string>{"x", "y", "z"}
                        : std::vector<std::string>{"x", "y"};
    case TypeKind::pose:
      return {"x", "y", "heading"};
    case TypeKind::twist:
      return {"linear", "angular"};
    case TypeKind::path:  // its way-points, and the next one
      return {"", "index"};
  }
  return {""};
}

}  // namespace

void shape(Input& input, const ValueType& type) {
  input.type = input_type_of(type.kind);
  input.enumeration = type.enumeration;
  const std::vector<Part> parts = parts_of(type);
  input.dimension = parts.front().dimension;
  input.turning.reset();
  if (parts.size() > 1) input.turning.emplace().dimension = parts.back().dimension;
  const std::vector<std::string> element = components_of(type);
  input.element_size = static_cast<std::uint32_t>(element.size());
  input.components = element;
  if (type.kind == TypeKind::zone) input.edges_most = type.length.value_or(0);
  if (type.kind == TypeKind::path) input.places_most = type.length.value_or(0);
  if (!type.length || type.kind == TypeKind::zone || type.kind == TypeKind::path) return;
  input.components.clear();
  for (std::uint32_t i = 0; i < *type.length; ++i) {
    for (const std::string& part : element) {
      input.components.push_back(std::to_string(i) + (part.empty() ? "" : "." + part));
    }
  }
}

// Monitors name it as they do a zone.
static void add_received_zone(Context& context, InputId id) {
  const Input& input = context.spec[id];
  if (input.type != InputType::zone || context.faulty_inputs.count(id) > 0) return;
  auto value =
      std::make_unique<ZoneExpr>(ZoneExpr{input.name_range, ZoneReceived{id, input.edges_most}});
  auto& zones = context.spec.zones;
  context.received_zones.emplace(id, ZoneId{static_cast<std::uint32_t>(zones.size())});
  zones.push_back(
      {input.name, input.name_range, std::move(value), context.input_types[index_of(id)].frame});
}

void check_inputs(Context& context) {
  for (std::uint32_t i = 0; i < context.inputs.size(); ++i) {
    const InputId id{i};
    const bool again = i > 0 && context.inputs[i].node == context.inputs[i - 1].node;
    if (again) {
      copy_clauses(context.spec.inputs[i - 1], context.spec.inputs[i]);
      context.input_types.push_back(context.input_types.back());
      if (context.faulty_inputs.count(InputId{i - 1}) > 0) context.faulty_inputs.insert(id);
      add_received_zone(context, id);
      continue;
    }
    const auto type = check_type(context, context.inputs[i].node->type, MayBeZone::yes);
    context.input_types.push_back(type.value_or(ValueType{}));
    const bool good = type && InputChecker(context, i).check(*type);
    if (good) round_limits(context.spec.inputs[i]);
    if (!good || context.damaged(context.inputs[i].range)) context.faulty_inputs.insert(id);
    add_received_zone(context, id);
  }
}

namespace {

bool param_type_fits(Context& context, const Param& param, const syntax::ParamItem& written,
                     const ValueType& type) {
  const bool scalar = type.kind == TypeKind::integer || type.kind == TypeKind::real;
  if (scalar && !type.length) return true;
  context.report(Finding(Code::wrong_argument, written.type.range,
                         "the parameter `" + param.name + "` must be a single quantity")
                     .label("not a single quantity")
                     .help("write `int`, `real [m/s]`, or a dimension such as `length`"));
  return false;
}

bool check_param(Context& context, Param& param, const syntax::ParamItem& written) {
  const auto type = check_type(context, written.type);
  if (!type || !param_type_fits(context, param, written, *type)) return false;
  param.dimension = type->dimension;
  param.resolution = default_resolution(context.spec, *type, type->dimension);
  if (!written.least || !written.most || !written.value) {
    context.missing_clause(param.name_range, "the parameter `" + param.name + "`",
                           "range and value", "in 0.1 m .. 0.5 m = 0.2 m");
    return false;
  }
  const auto range = check_range(context, *written.least, *written.most, *type);
  const std::string what = "the value of `" + param.name + "`";
  auto value = quantity(context, *written.value, {type->dimension, what});
  if (type->kind == TypeKind::integer) value = whole(context, value, what);
  if (!range || !value) return false;
  param.least = range->least;
  param.most = range->most;
  param.value = *value;
  if (value->value >= param.least.value && value->value <= param.most.value) return true;
  const std::string within =
      show(param.least.value, param.dimension) + " to " + show(param.most.value, param.dimension);
  context.report(Finding(Code::quantity_out_of_range, value->range,
                         what + " cannot be " + show(value->value, param.dimension))
                     .label("outside the range of the parameter")
                     .note(param.least.range, "the range begins here")
                     .help("a value from " + within + " works"));
  return false;
}

class SettingsChecker {
 public:
  explicit SettingsChecker(Context& context) : context_(context) {}

  template <class Node>
  void item(const SourceRange&, const Node&) {}

  void item(const SourceRange& range, const syntax::PeriodItem& written) {
    if (period_) {
      context_.duplicate_clause(range, *period_, "`period`");
      return;
    }
    period_ = range;
    context_.period_written = true;
    if (is_error(*written.value)) return;
    const auto period =
        quantity(context_, *written.value, {dims::time, "the period", Limit::positive});
    if (period && within_limit(context_, *period, period_s_max, "a period", "") &&
        on_the_clock(*period)) {
      context_.spec.period = *period;
    }
  }

  void item(const SourceRange& range, const syntax::ClockItem& written) {
    clock_written_ = true;
    if (written.name.text != "utc") {
      context_.report(Finding(Code::unknown_word, written.name.range,
                              "there is no clock `" + written.name.text + "`")
                          .label("not a clock")
                          .help("`clock utc;` counts microseconds since 1970-01-01T00:00Z"));
      return;
    }
    if (context_.spec.utc_clock) {
      context_.duplicate_clause(range, *context_.spec.utc_clock, "`clock`");
      return;
    }
    context_.spec.utc_clock = range;
  }

  void item(const SourceRange& range, const syntax::ScaleItem& written) {
    const auto scale = positive_constant(context_, *written.value, "a scale of margins");
    if (!scale) return;
    for (const MarginScale& earlier : context_.spec.scales) {
      if (earlier.dimension != scale->dimension) continue;
      context_.duplicate_clause(range, earlier.value.range,
                                "a scale for " + describe(scale->dimension));
      return;
    }
    context_.spec.scales.push_back({scale->dimension, {scale->value, written.value->range}});
  }

  void item(const SourceRange&, const syntax::GridItem& written) {
    for (const syntax::ExprPtr& each : written.steps) grid(*each);
  }

  // Windows of time mean nothing on a clock that starts anywhere. Of a schedule that could not be
  // taken, why it could not is the mistake.
  void finish() {
    if (clock_written_ || context_.broken_tree()) return;
    for (std::size_t i = 0; i < context_.zones.size(); ++i) {
      const syntax::ZoneItem& zone = *context_.zones[i].node;
      const bool was_read = context_.spec.zones[i].value != nullptr;
      const auto* const scheduled = was_read ? scheduled_in(*zone.value) : nullptr;
      if (zone.during.empty() && scheduled == nullptr) continue;
      context_.report(Finding(Code::clock_missing,
                              scheduled != nullptr ? scheduled->range : zone.during.front().range,
                              "windows of time need a clock in UTC")
                          .label("which time is it?")
                          .help("write `clock utc;`: time and stamps then count from "
                                "1970-01-01T00:00Z")
                          .insert_after(context_.spec.name_range, ";\nclock utc"));
      return;
    }
  }

 private:
  void grid(const syntax::Expr& written) {
    if (is_error(written)) return;
    const auto step = positive_constant(context_, written, "a step of the grid");
    if (!step || !robots_agree(written, *step)) return;
    for (const GridStep& earlier : context_.spec.grids) {
      if (earlier.dimension != step->dimension) continue;
      context_.duplicate_clause(written.range, earlier.value.range,
                                "a grid for " + describe(step->dimension));
      return;
    }
    context_.spec.grids.push_back({step->dimension, {step->value, written.range}});
  }

  // Decisions have one grid: mm and ppm.
  bool robots_agree(const syntax::Expr& written, const Measure& step) {
    if (context_.kinds.empty()) return true;
    const bool length = step.dimension == dims::length;
    const Rational due(1, length ? 1000 : 1000000);
    const bool fixed = length || step.dimension == dims::ratio;
    if (!fixed || step.value == due) return true;
    context_.report(Finding(Code::quantity_out_of_range, written.range,
                            "robots are on a grid of " + show(due, step.dimension) + ", not of " +
                                show(step.value, step.dimension))
                        .label("this specification has robots")
                        .help("leave it out, and write `resolution " +
                              show(step.value, step.dimension) +
                              "` at the inputs of monitors without a robot"));
    return false;
  }

  // language rule 1: the clock counts microseconds.
  bool on_the_clock(const Quantity& period) {
    const Rational in_us = period.value * 1000000;
    if (in_us.get_den() == 1) return true;
    const Rational below(mpz_class(in_us.get_num() / in_us.get_den()));
    std::string works = to_decimal(Rational(below + 1)) + " us";
    if (below > 0) works = to_decimal(below) + " us or " + works;
    context_.report(Finding(Code::quantity_out_of_range, period.range,
                            "the period of " + show(period.value, dims::time) +
                                " is not a whole number of microseconds")
                        .label("must be a multiple of 1 us")
                        .help(works + " works"));
    return false;
  }

  Context& context_;
  std::optional<SourceRange> period_;
  bool clock_written_ = false;  // it may have a mistake
};

}  // namespace

void check_params(Context& context) {
  for (std::uint32_t i = 0; i < context.params.size(); ++i) {
    const bool good = check_param(context, context.spec.params[i], *context.params[i].node);
    if (!good || context.damaged(context.params[i].range)) {
      context.faulty_params.insert(ParamId{i});
    }
  }
}

void check_settings(Context& context, const syntax::Program& program) {
  SettingsChecker checker(context);
  for (const syntax::File& file : program.files) {
    for (const syntax::Item& item : file.items) {
      std::visit([&](const auto& node) { checker.item(item.range, node); }, item.node);
    }
  }
  checker.finish();
}

}  // namespace rtac::sema
