#include "compiler/codegen/simulation_property.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/codegen/code.h"
#include "compiler/sema/dimension.h"
#include "compiler/sema/received.h"
#include "compiler/sema/visit.h"

namespace rtac::codegen {
namespace {

using Json = nlohmann::ordered_json;
using sema::Expr;

class Tree {
 public:
  Tree(const sema::Spec& spec, sema::KindId kind, const ir::TableMap& tables, Facts& facts)
      : spec_(spec), kind_(kind), tables_(tables), facts_(facts) {}

  Json of(const Expr& e) {
    return std::visit([&](const auto& node) { return this->node(e, node); }, e.node);
  }
  [[nodiscard]] const std::string& why() const { return why_; }

 private:
  template <class Id>
  static std::uint32_t index(Id id) {
    return static_cast<std::uint32_t>(id);
  }
  Json refuse(const std::string& what) {
    if (why_.empty()) why_ = what;
    return nullptr;
  }
  Json with(const char* op, const std::vector<sema::ExprPtr>& operands) {
    Json j{{"op", op}, {"of", Json::array()}};
    for (const sema::ExprPtr& each : operands) j["of"].push_back(of(*each));
    return j;
  }
  static Json with(const char* op, Json operand) {
    return Json{{"op", op}, {"of", Json::array({std::move(operand)})}};
  }

  Json node(const Expr&, const sema::Constant& c) {
    return {{"op", "const"}, {"value", nearest_double(c.value)}};
  }
  Json node(const Expr&, const sema::Truth& t) { return {{"op", "truth"}, {"value", t.value}}; }
  Json node(const Expr&, const sema::SignalRef& s) {
    if (s.signal == sema::Signal::altitude) return {{"op", "altitude"}};
    return {{"op", s.signal == sema::Signal::battery ? "battery" : "speed"},
            {"other", s.subject == sema::Subject::other}};
  }
  Json node(const Expr&, const sema::Clearance& c) { return in_zone("clearance", c.zone); }
  Json node(const Expr&, const sema::InsideZone& i) { return in_zone("inside", i.zone); }
  Json in_zone(const char* op, sema::ZoneId zone) {
    if (const auto by = sema::received_by(spec_, zone)) {
      return refuse("the zone `" + spec_[by->input].name + "`, which is received while it runs");
    }
    return {{"op", op}, {"zone", index(tables_.zone(zone))}};
  }
  Json node(const Expr&, const sema::AgentDistance& a) {
    return {{"op", "agent_distance"}, {"agent", static_cast<std::uint32_t>(a.agent)}};
  }
  Json node(const Expr&, const sema::Distance&) { return {{"op", "distance"}}; }
  Json node(const Expr&, const sema::EnergyTo& e) {
    return {{"op", "energy_to"}, {"site", index(tables_.site(kind_, e.site))}};
  }
  Json node(const Expr&, const sema::ParamRef& p) {
    return {{"op", "const"}, {"value", nearest_double(spec_[p.param].value.value)}};
  }
  Json node(const Expr&, const sema::Arithmetic& a) {
    static const char* const names[] = {"add", "subtract", "multiply", "divide", "negate"};
    return with(names[static_cast<std::size_t>(a.op)], a.operands);
  }
  Json node(const Expr&, const sema::Compare& c) {
    const bool swaps = c.op == sema::CompareOp::less || c.op == sema::CompareOp::less_equal;
    const bool strict = c.op == sema::CompareOp::less || c.op == sema::CompareOp::greater;
    Json left = of(*c.left), right = of(*c.right);
    if (swaps) std::swap(left, right);
    return {{"op", "at_least"},
            {"of", Json::array({std::move(left), std::move(right)})},
            {"strict", strict},
            {"scale", scale(c.left->dimension)}};
  }
  // One metre, one per cent; otherwise what the specification says.
  double scale(const sema::Dimension& dimension) const {
    for (const sema::MarginScale& s : spec_.scales) {
      if (s.dimension == dimension) return nearest_double(s.value.value);
    }
    return dimension == sema::dims::ratio ? 0.01 : 1.0;
  }
  Json node(const Expr&, const sema::Logic& l) {
    const auto operand = [&](std::size_t k) { return of(*l.operands[k]); };
    const auto both = [](const char* op, Json a, Json b) {
      return Json{{"op", op}, {"of", Json::array({std::move(a), std::move(b)})}};
    };
    switch (l.op) {
      case sema::LogicOp::logical_not:
        return with("not", l.operands);
      case sema::LogicOp::logical_and:
        return with("and", l.operands);
      case sema::LogicOp::logical_or:
        return with("or", l.operands);
      case sema::LogicOp::implies:
        return both("or", with("not", operand(0)), operand(1));
      case sema::LogicOp::iff:
        return both("and", both("or", with("not", operand(0)), operand(1)),
                    both("or", operand(0), with("not", operand(1))));
      case sema::LogicOp::logical_xor:
        return both("or", both("and", with("not", operand(0)), operand(1)),
                    both("and", operand(0), with("not", operand(1))));
    }
    return nullptr;
  }
  Json node(const Expr&, const sema::ForOthers& f) {
    return with(f.universal ? "forall" : "exists", of(*f.body));
  }
  Json node(const Expr&, const sema::CountOthers& c) { return with("count", of(*c.body)); }
  Json node(const Expr&, const sema::InputRef& i) {
    if (spec_[i.input].type == sema::InputType::boolean) return told(i.input, i.component, 1);
    return input("input", i.input, i.component);
  }
  Json node(const Expr&, const sema::IsValue& i) { return told(i.input, i.component, i.value); }
  // Some value is that of both.
  Json node(const Expr&, const sema::SameValue& s) {
    Json same{{"op", "or"}, {"of", Json::array()}};
    const auto count =
        static_cast<std::uint32_t>(spec_[*spec_[s.left.input].enumeration].values.size());
    for (std::uint32_t value = 0; value < count; ++value) {
      same["of"].push_back(
          Json{{"op", "and"},
               {"of", Json::array({told(s.left.input, s.left.component, value),
                                   told(s.right.input, s.right.component, value)})}});
    }
    return same;
  }
  Json node(const Expr&, const sema::Math& m) {
    static const char* const names[] = {"min", "max", "abs", "sqrt", "norm", "sin", "cos"};
    return with(names[static_cast<std::size_t>(m.op)], m.operands);
  }
  Json node(const Expr&, const sema::Choice& c) {
    return {{"op", "choice"},
            {"of", Json::array({of(*c.condition), of(*c.then_value), of(*c.else_value)})}};
  }
  // A number, or a truth that holds where the input is `value`.
  Json input(const char* op, sema::InputId id, std::uint32_t component) {
    const std::string& name = spec_[id].name;
    if (facts_.inputs.count(name) == 0) {
      return refuse("the plain input `" + name + "`, which nothing simulates");
    }
    return {{"op", op}, {"input", name}, {"component", component}};
  }
  Json told(sema::InputId id, std::uint32_t component, std::uint32_t value) {
    Json j = input("told", id, component);
    if (!j.is_null()) j["is"] = value;
    return j;
  }
  Json node(const Expr&, const sema::ZoneOpen& o) {
    const auto at = std::find(facts_.timed.begin(), facts_.timed.end(), o.zone);
    const auto number = at - facts_.timed.begin();
    if (at == facts_.timed.end()) facts_.timed.push_back(o.zone);
    return {{"op", "open"}, {"openings", number}};
  }
  // Measured anew in every tick.
  Json node(const Expr&, const sema::AgeOf&) { return {{"op", "const"}, {"value", 0.0}}; }
  Json node(const Expr& e, const sema::HeldFor& h) { return past(e, *h.operand); }
  Json node(const Expr& e, const sema::Previously& p) { return past(e, *p.operand); }
  Json node(const Expr& e, const sema::Past& p) { return past(e, *p.operand); }
  // Of an interval that begins before now, both have to hold; otherwise it is as if it began now.
  Json node(const Expr& e, const sema::Since& s) {
    if (s.interval.from.value == 0) return past(e, *s.right);
    Json both = Json{{"op", "and"}, {"of", Json::array()}};
    for (const Expr* each : {s.left.get(), s.right.get()}) {
      both["of"].push_back(past(e, *each));
    }
    return both;
  }
  Json node(const Expr& e, const sema::WithinOf& w) {
    Json missed = with("not", past(e, *w.trigger));
    return {{"op", "or"}, {"of", Json::array({past(e, *w.operand), std::move(missed)})}};
  }
  Json node(const Expr& e, const sema::Aggregate& a) {
    switch (a.op) {
      case sema::AggregateOp::minimum:
      case sema::AggregateOp::maximum:
      case sema::AggregateOp::mean:
        return past(e, *a.operand);
      case sema::AggregateOp::rate:
        return {{"op", "const"}, {"value", 0.0}};
      case sema::AggregateOp::sum:
      case sema::AggregateOp::count:
        break;
    }
    return refuse("how often something was so, which runs do not count");
  }
  // What has always been so.
  Json past(const Expr& all, const Expr& operand) {
    bool changes = sema::speaks_of_robot(all);
    sema::for_each_expr(all, [&](const Expr& each) {
      changes = changes || std::holds_alternative<sema::ZoneOpen>(each.node);
    });
    if (changes) {
      return refuse("the past of robots or of zones with times, which runs do not follow");
    }
    return of(operand);
  }
  // Plans, and how old measurements are.
  template <class Other>
  Json node(const Expr&, const Other&) {
    return refuse("what the true state of a robot does not tell");
  }

  const sema::Spec& spec_;
  const sema::KindId kind_;
  const ir::TableMap& tables_;
  Facts& facts_;
  std::string why_;
};

}  // namespace

namespace {

std::int64_t us_of(const sema::Quantity& time) {
  return ceil_to_int(Rational(time.value * 1'000'000));
}

// From when on an operator over what has always been so is what it is for ever; none: it is of now.
struct LooksBack {
  std::int64_t period_us;
  std::int64_t operator()(const sema::HeldFor& h) const { return us_of(h.duration); }
  std::int64_t operator()(const sema::Previously&) const { return period_us; }
  std::int64_t operator()(const sema::Past& p) const { return us_of(p.interval.from); }
  std::int64_t operator()(const sema::Since& s) const { return us_of(s.interval.from); }
  std::int64_t operator()(const sema::WithinOf& w) const { return us_of(w.duration); }
  std::int64_t operator()(const sema::Aggregate& a) const {
    return us_of(a.op == sema::AggregateOp::rate ? *a.interval.to : a.interval.from);
  }
  template <class Other>
  std::int64_t operator()(const Other&) const {
    return 0;
  }
};

}  // namespace

std::int64_t memory_us(const Expr& e, std::int64_t period_us) {
  std::int64_t below_us = 0;
  sema::for_each_operand(e, [&](const sema::ExprPtr& operand) {
    below_us = std::max(below_us, memory_us(*operand, period_us));
  });
  return below_us + (sema::speaks_of_robot(e) ? 0 : std::visit(LooksBack{period_us}, e.node));
}

std::optional<Json> property_tree(const sema::Spec& spec, sema::KindId kind,
                                  const ir::TableMap& tables, const Expr& property, Facts& facts,
                                  std::string& why) {
  Tree tree(spec, kind, tables, facts);
  Json json = tree.of(property);
  why = tree.why();
  if (!why.empty()) return std::nullopt;
  return json;
}

double nearest_double(const Rational& value) {
  return std::strtod(real(value).c_str(), nullptr);
}

}  // namespace rtac::codegen
