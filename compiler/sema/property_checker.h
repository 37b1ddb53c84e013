// The checker behind property.h: connectives and comparisons (property.cpp), arithmetic
// (arithmetic.cpp), the past (past.cpp), names and components (signals.cpp), ages (ages.cpp),
// functions (calls.cpp, functions.cpp), and what a property says about points in zones (points.cpp)
// and about robots (atoms.cpp, quantifiers.cpp, members.cpp, member_comparisons.cpp).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/sema/property.h"
#include "compiler/sema/quantity.h"
#include "compiler/sema/value.h"

namespace rtac::sema {

// Deepest nesting of expressions, functions put in their places; most expressions of a property.
inline constexpr int max_depth = 400;
inline constexpr std::size_t max_size = 50'000;

class PropertyChecker {
 public:
  PropertyChecker(Context& context, const PropertyScope& scope)
      : context_(context), scope_(scope) {}

  ExprPtr condition(const syntax::Expr& expr);
  // Checks the body of a function on its own, and all that it calls.
  void function(std::uint32_t index);

 private:
  // A name that is bound inside the expression, by `let` or as an argument.
  struct Local {
    std::string name;
    SourceRange range;
    Value value;
  };
  // What changing a duration does to the truth of the operator that has it.
  enum class Longer { truer, stricter, neither };

  // Any expression; an empty value when it has a mistake. `due` improves unit suggestions.
  Value infer(const syntax::Expr& expr, const std::optional<Dimension>& due = std::nullopt);
  Value infer_node(const syntax::Expr& expr, const std::optional<Dimension>& due);
  ExprPtr quantity_of(const syntax::Expr& expr, const std::optional<Dimension>& due = std::nullopt);
  bool affordable(const syntax::Expr& expr, std::size_t nodes);
  void report_limit(const SourceRange& range, const std::string& what, const std::string& limit);

  // ---- property.cpp: one function for each form of expression.
  ExprPtr constant(const syntax::Expr& expr, const syntax::NumberLit& number,
                   const std::optional<Dimension>& due);
  Value form(const syntax::Expr& expr, const syntax::NumberLit& number);
  Value form(const syntax::Expr& expr, const syntax::BoolLit& truth);
  Value form(const syntax::Expr& expr, const syntax::Unary& unary);
  Value form(const syntax::Expr& expr, const syntax::Binary& binary);
  Value form(const syntax::Expr& expr, const syntax::Quantified& quantified);
  Value form(const syntax::Expr& expr, const syntax::OverFleet& over);
  Value form(const syntax::Expr& expr, const syntax::Conditional& conditional);
  Value form(const syntax::Expr& expr, const syntax::ErrorExpr& error);
  // Zones are not values of a property.
  template <class Node>
  Value form(const syntax::Expr& expr, const Node&) {
    return not_a_quantity(expr, form_of(expr));
  }
  ExprPtr logic(const syntax::Expr& expr, const syntax::Binary& binary, LogicOp op);
  ExprPtr comparison(const syntax::Expr& expr, const syntax::Binary& binary, CompareOp op);
  // What authors of other languages write (foreign.cpp). True, or a value: it has been reported.
  Value zones_or_conditions(const syntax::Expr& expr, const syntax::Binary& binary);
  bool unit_with_blanks(const syntax::Binary& binary);
  bool unit_without_number(const syntax::Expr& expr);
  bool unit_in_brackets(const syntax::Expr& expr, const syntax::Index& index);
  ExprPtr computed_duration(const syntax::Held& held, const syntax::Binary& sum);
  ExprPtr not_a_quantity(const syntax::Expr& expr, const std::string& what);
  ExprPtr as_quantity(const syntax::Expr& expr, Value value);
  Value choice(const syntax::Expr& expr, const Expr& condition, Value then_value, Value else_value);
  static ExprPtr chosen_condition(const syntax::Expr& expr, const Expr& condition,
                                  ExprPtr then_value, ExprPtr else_value);
  Value chosen_parts(const syntax::Expr& expr, const Expr& condition, Value& then_value,
                     Value& else_value);
  bool frames_agree(const SourceRange& range, const std::string& user,
                    const std::optional<FrameId>& left, const std::optional<FrameId>& right);

  // ---- quantifiers.cpp: every other robot of the kind of the monitored one.
  // What stands before the last colon: `q : Rover, q != r`.
  struct Head {
    const SourceRange& range;
    const syntax::Name& variable;
    const syntax::Name& kind;
    const syntax::ExprPtr& guard;
  };
  bool not_nested(const Head& head);
  bool may_be_agents(const syntax::Name& name);
  bool quantifier_fits(const Head& head);
  bool guard_fits(const Head& head);
  [[nodiscard]] const SourceRange* taken_at(std::string_view name) const;
  bool variable_fits(const Head& head);
  Value over_others(const syntax::Expr& expr, const syntax::OverFleet& over);

  // ---- members.cpp: robots by name, in monitors without a robot.
  // Is it one of `forall q : Rover` here, `r1`, or `bots[3]`?
  [[nodiscard]] bool names_robot(const syntax::Expr& expr) const;
  // Any robot, also in the monitor of one.
  [[nodiscard]] bool says_robot(const syntax::Expr& expr) const;
  // The values of two operands; one report stands for two robots.
  std::pair<Value, Value> both(const syntax::Expr& left, const syntax::Expr& right);
  // Reports what is wrong with it.
  std::optional<RobotId> robot_named(const syntax::Expr& expr);
  Value robot_signal(const syntax::Expr& expr, const syntax::Member& member);
  std::optional<InputId> robot_input(RobotId robot, const std::string& signal,
                                     const SourceRange& range);
  std::optional<InputId> robot_plan(RobotId robot, const SourceRange& range);
  Value distance_of_bodies(const syntax::Expr& expr, const syntax::Call& call);
  // The robots that the head goes through; nullopt: it has a mistake.
  std::optional<std::vector<RobotId>> members(const Head& head);
  bool excludes(const syntax::Expr& guard, const Head& head, std::vector<RobotId>& out);
  Value quantified_members(const syntax::Expr& expr, const syntax::Quantified& quantified);
  Value over_members(const syntax::Expr& expr, const syntax::OverFleet& over);
  ExprPtr counted(const SourceRange& range, std::vector<ExprPtr> conditions);
  static ExprPtr joined(const SourceRange& range, LogicOp op, std::vector<ExprPtr> parts);

  // ---- agents.cpp: what moves by itself, in monitors of robots.
  [[nodiscard]] bool names_agent(const syntax::Expr& expr) const;
  ExprPtr agent_as_value(const syntax::Expr& expr, const syntax::Name& name);
  ExprPtr distance_from_agent(const syntax::Expr& expr, const syntax::Expr& written);
  Value quantified_agents(const syntax::Expr& expr, const syntax::Quantified& quantified);

  // ---- member_comparisons.cpp
  // A comparison; one of `min` or `max` over members is that of each of them.
  ExprPtr compare(const SourceRange& range, CompareOp op, ExprPtr left, ExprPtr right);
  ExprPtr compare_while_open(const SourceRange& range, CompareOp op, ExprPtr left, ExprPtr right);
  bool afford_copy(const SourceRange& range, const ExprPtr& left, const ExprPtr& right);
  ExprPtr compare_choice(const SourceRange& range, CompareOp op, const ExprPtr& left,
                         const ExprPtr& right, ExprPtr& place);
  ExprPtr compare_members(const SourceRange& range, CompareOp op, const ExprPtr& left,
                          const ExprPtr& right, ExprPtr& place, bool rising);

  // ---- equality.cpp
  ExprPtr equality(const syntax::Expr& expr, const syntax::Binary& binary);
  ExprPtr same_numbers(const syntax::Expr& expr, const syntax::Binary& binary, ExprPtr left,
                       ExprPtr right);
  ExprPtr same_values(const syntax::Expr& expr, const syntax::Binary& binary, const Value& left,
                      const Value& right);
  // Both of one enumeration.
  ExprPtr same_value(const syntax::Expr& expr, const Value& left, const Value& right);
  ExprPtr not_comparable(const syntax::Binary& binary, const Value& left, const Value& right);

  // ---- arithmetic.cpp
  Value arithmetic(const syntax::Expr& expr, const syntax::Binary& binary, ArithmeticOp op);
  ExprPtr scalars(const syntax::Expr& expr, const syntax::Binary& binary, ArithmeticOp op,
                  ExprPtr left, ExprPtr right);
  Value pairs(const syntax::Expr& expr, const syntax::Binary& binary, ArithmeticOp op, Pair left,
              Pair right);
  Value scaled(const syntax::Expr& expr, const syntax::Binary& binary, ArithmeticOp op, Pair pair,
               ExprPtr factor);
  Value negated(const syntax::Expr& expr, Value operand);
  bool divisor_fits(const syntax::Expr& divisor, const Expr& typed);
  Value wrong_operand(const SourceRange& range, const std::string& message,
                      const std::string& help);
  Value form(const syntax::Expr& expr, const syntax::PointLit& point);
  bool lacks_callee(const syntax::Expr& expr, const syntax::PointLit& point);

  // ---- past.cpp; every operator is judged now, also in the monitor of a robot.
  Value form(const syntax::Expr& expr, const syntax::Held& held);
  Value form(const syntax::Expr& expr, const syntax::Previously& previously);
  Value form(const syntax::Expr& expr, const syntax::Past& past);
  Value form(const syntax::Expr& expr, const syntax::Since& since);
  Value form(const syntax::Expr& expr, const syntax::WithinOf& within);
  Value form(const syntax::Expr& expr, const syntax::Aggregate& aggregate);
  ExprPtr aggregate_of(const syntax::Expr& expr, AggregateOp op, Interval interval,
                       const syntax::Expr& operand);
  bool ends_share_unit(const syntax::Expr& from, const syntax::Expr& to);
  bool ends_fit(const syntax::Interval& written);
  std::optional<Interval> interval_of(const syntax::Interval* written, const SourceRange& place,
                                      Longer wider);
  std::optional<Quantity> duration_of(const syntax::Expr& expr, const std::string& what,
                                      Limit limit, Longer longer);
  bool whole_ticks(const Quantity& duration, Limit limit, Longer longer);
  void unknown_aggregate(const syntax::Name& name);
  bool window_fits(const syntax::Aggregate& aggregate, AggregateOp op, const Interval& interval);
  // `built`, unless it says something of a robot where that is looked ahead or where there is one
  // for each other robot: then that is reported of `what`, with what says the same there, if any.
  ExprPtr judged_now(ExprPtr built, const std::string& what, const std::string& instead = "");
  void report_looked_ahead(const SourceRange& range, const std::string& what,
                           const std::string& instead);

  // ---- signals.cpp
  Value form(const syntax::Expr& expr, const syntax::NameRef& reference);
  Value form(const syntax::Expr& expr, const syntax::Member& member);
  Value form(const syntax::Expr& expr, const syntax::Index& index);
  std::optional<std::size_t> place_in(const syntax::Index& index, std::size_t length);
  Value form(const syntax::Expr& expr, const syntax::Let& let);
  Value declared(const syntax::Expr& expr, const syntax::Name& name, const Symbol& symbol);
  Value input_value(const SourceRange& range, InputId input);
  Value param_value(const SourceRange& range, ParamId param);
  Value enum_member(const syntax::Member& member, EnumId type);
  bool signal_allowed(const SourceRange& range, const syntax::Name& name, Sort sort);
  // Whether an input or a bound name stands in it: then `distance` is one of points.
  [[nodiscard]] bool speaks_of_points(const syntax::Expr& expr) const;
  [[nodiscard]] const Local* local(std::string_view name) const;
  // `also`: what else than values may stand here.
  void unknown_name(const syntax::Name& name, const std::vector<Sort>& also = {});
  [[nodiscard]] std::vector<Sort> places_of_robots() const;
  // Reports names that are not declared where a point, a robot or a zone may stand.
  bool place_known(const syntax::Expr& place, const std::vector<Sort>& also);
  bool places_known(const std::vector<syntax::ExprPtr>& places);
  [[nodiscard]] std::vector<std::string> visible_names() const;

  // ---- calls.cpp
  Value form(const syntax::Expr& expr, const syntax::Call& call);
  Value other_call(const syntax::Expr& expr, const syntax::Call& call, const Symbol* symbol);
  Value minimum_or_maximum(const syntax::Expr& expr, const syntax::Call& call, MathOp op);
  Value absolute(const syntax::Expr& expr, const syntax::Call& call);
  Value square_root(const syntax::Expr& expr, const syntax::Call& call);
  Value norm(const syntax::Expr& expr, const syntax::Call& call);
  Value dot(const syntax::Expr& expr, const syntax::Call& call);
  Value clamp(const syntax::Expr& expr, const syntax::Call& call);
  Value distance_of_points(const syntax::Expr& expr, const syntax::Call& call);
  Value math(const syntax::Expr& expr, MathOp op, const Dimension& dimension,
             std::vector<ExprPtr> operands, const std::string& instead = "");
  std::optional<std::vector<ExprPtr>> quantities(const std::vector<syntax::ExprPtr>& arguments,
                                                 const std::string& user);
  bool one_dimension(const std::string& user, const std::vector<const syntax::Expr*>& written,
                     const std::vector<const Expr*>& typed);
  std::optional<Pair> pair_of(const syntax::Expr& expr, Pair::Kind due, const std::string& user);
  std::optional<Pair> as_pair(const syntax::Expr& expr, Value value, Pair::Kind due,
                              const std::string& user);

  // ---- ages.cpp
  Value age(const syntax::Expr& expr, const syntax::Call& call);
  ExprPtr age_of_sense(const syntax::Expr& expr, const syntax::Name& field, Subject who);
  ExprPtr age_of_member(const syntax::Expr& expr, const syntax::Member& member);
  bool ageless_robot(const syntax::Expr& argument);

  // ---- points.cpp
  struct Placed {  // a point, or a body around its centre
    Pair centre;
    Rational radius;  // m; 0 of a point
  };
  struct CentreGap {
    ExprPtr gap;  // from the centre
    Rational radius;
    ZoneId zone;
  };
  struct Centre {
    ExprPtr x, y;  // m
    ExprPtr z;     // null: in the plane
  };
  static Centre centre_of(Pair& place);
  ExprPtr inside_of(const syntax::Expr& expr, Centre place, ZoneId zone);
  ExprPtr comparison(const SourceRange& range, CompareOp op, ExprPtr left, ExprPtr right);
  ExprPtr gap_of(const syntax::Expr& expr, Centre place, ZoneId zone);
  [[nodiscard]] bool says_zone(const syntax::Expr& expr) const;
  std::optional<Placed> placed(const syntax::Expr& expr, const std::string& user);
  static ExprPtr less_radius(const syntax::Expr& expr, ExprPtr gap, const Rational& radius);
  ExprPtr distance_of_zones(const syntax::Expr& expr, const syntax::Expr& first,
                            const syntax::Expr& second);
  std::optional<CentreGap> centre_gap(const syntax::Expr& expr, const syntax::Call& call,
                                      const std::string& user);
  std::optional<Pair> place_of(const syntax::Expr& expr, const std::string& user);
  std::optional<ZoneId> zone_around(const std::optional<FrameId>& of, bool in_space,
                                    const syntax::Expr& zone);
  bool seen_from_carrier(const syntax::Expr& expr, ZoneId zone, Pair& place);
  ExprPtr inside_while_open(const SourceRange& range, ZoneId zone, ExprPtr inside);
  ExprPtr gap_while_open(const SourceRange& range, ZoneId zone, bool endless, ExprPtr gap);
  ExprPtr point_inside(const syntax::Expr& expr, const syntax::Binary& binary);
  ExprPtr clearance_of_place(const syntax::Expr& expr, const syntax::Call& call);
  ExprPtr distance_to_zone(const syntax::Expr& expr, const syntax::Call& call);

  // ---- ways.cpp: legs and paths
  struct HeldWay {
    Way way;          // of one place: a point, or a body around its centre
    Rational radius;  // m; 0 of all but a body
  };
  [[nodiscard]] bool says_way(const syntax::Expr& expr) const;
  // Reports one in the monitor of a robot.
  bool ways_allowed(const syntax::Expr& expr);
  Value way_of(const syntax::Expr& expr, const syntax::Call& call);
  std::optional<Pair> body_in_way(const syntax::Expr& written, const std::string& user);
  bool way_in_plane(const syntax::Expr& written, const Pair& place);
  Value led_on(const syntax::Expr& written, Way way);
  std::optional<HeldWay> held_way(const syntax::Expr& expr, const std::string& user);
  std::optional<ZoneId> zone_around_way(const Way& way, const syntax::Expr& zone);
  static ExprPtr extreme_of(const SourceRange& range, std::vector<ExprPtr> gaps, bool greatest);
  static ExprPtr while_given(const SourceRange& range, const Way& way, ExprPtr gap);
  ExprPtr way_inside(const syntax::Expr& expr, const syntax::Binary& binary);
  ExprPtr gap_of_way(const SourceRange& range, const Way& way, ZoneId zone, bool greatest);
  ExprPtr clearance_of_way(const syntax::Expr& expr, const syntax::Call& call);
  ExprPtr way_from_zone(const syntax::Expr& expr, const HeldWay& held, const syntax::Expr& written);
  ExprPtr distance_of_ways(const syntax::Expr& expr, const syntax::Call& call);

  // ---- space.cpp: points, vectors and frames
  bool agree(const SourceRange& range, const std::string& user, const Pair& left,
             const Pair& right);
  bool in_plane(const syntax::Expr& expr, const std::string& user, const Pair& pair);
  std::optional<std::pair<Pair, Pair>> vectors(const syntax::Call& call);
  ExprPtr product(const syntax::Expr& expr, ExprPtr left, ExprPtr right);
  static ExprPtr sum(const syntax::Expr& expr, ArithmeticOp op, ExprPtr left, ExprPtr right);
  ExprPtr cross_term(const syntax::Expr& expr, const ExprPtr& a, const ExprPtr& b, const ExprPtr& c,
                     const ExprPtr& d);
  Value cross(const syntax::Expr& expr, const syntax::Call& call);
  Value rotate(const syntax::Expr& expr, const syntax::Call& call);
  bool rotate_swapped(const syntax::Expr& expr, const Value& first, const Value& second);
  Value transform(const syntax::Expr& expr, const syntax::Call& call);
  Value rotated(const syntax::Expr& expr, const Pair& pair, const Expr& angle);

  // ---- functions.cpp
  Value call_function(const syntax::Expr& expr, const syntax::Call& call, std::uint32_t index);
  bool check_function(const syntax::Call& call, std::uint32_t index);
  void check_signature(Function& function);
  bool check_body(Function& function);
  bool result_fits(const Function& function, const Value& body);
  bool frame_misfits(const syntax::Expr& written, const Value& value, const ValueType& type,
                     const std::string& user);
  bool argument_fits(const syntax::Expr& written, const Value& value, const ValueType& type,
                     const std::string& function, const std::string& parameter);

  // ---- atoms.cpp
  Value robot_name(const syntax::Expr& expr);
  Value robot_member(const syntax::Expr& expr, const syntax::Member& member);
  Value robot_call(const syntax::Expr& expr, const syntax::Call& call);
  ExprPtr inside(const syntax::Expr& expr, const syntax::Binary& binary);
  ExprPtr plan_inside(const syntax::Expr& expr, const syntax::Member& member,
                      const syntax::Expr& zone);
  ExprPtr clearance(const syntax::Expr& expr, const syntax::Call& call);
  ExprPtr distance(const syntax::Expr& expr, const syntax::Call& call);
  bool is_known(const syntax::Expr& expr);
  ExprPtr distance_from_zone(const syntax::Expr& expr, const syntax::Expr& written);
  ExprPtr energy_to(const syntax::Expr& expr, const syntax::Call& call);
  ExprPtr signal(const syntax::Expr& expr, const syntax::Name& field, Subject subject);
  ExprPtr not_scalar(const syntax::Expr& expr, const syntax::Name& field);
  std::optional<SiteId> place_of_self(const syntax::Expr& place);
  bool place_belongs_to_self(const syntax::Expr& robot, const std::string& site);
  // Reports `what` in a monitor without a robot.
  bool robot_allowed(const SourceRange& range, const std::string& what);
  [[nodiscard]] bool in_space() const;  // the monitored robot
  std::optional<ZoneId> zone_of_robot(const syntax::Expr& expr);
  [[nodiscard]] bool is_altitude(const syntax::Member& member) const;
  ExprPtr altitude(const syntax::Expr& expr);

  // The kind of the monitored robot, for examples in messages.
  [[nodiscard]] std::string kind_name() const {
    return scope_.kind ? context_.spec[*scope_.kind].name : "Kind";
  }
  // The robot that an expression names, if it is a variable of this property.
  [[nodiscard]] std::optional<Subject> subject(const syntax::Expr& expr) const;
  // True when `expr` is the monitored robot; else reports.
  bool is_self(const syntax::Expr& expr, const std::string& user);
  [[nodiscard]] bool names_zone(const syntax::Expr& expr) const;
  bool argument_count(const syntax::Expr& expr, const syntax::Call& call, std::size_t due,
                      const std::string& example);
  void require(Need need, const SourceRange& range, const std::string& user);
  void require_motion(const SourceRange& range, const std::string& user);

  // May what stands here name any robot? A function may not.
  [[nodiscard]] bool sees_fleets() const { return !scope_.of_robot() && function_ == nullptr; }
  // May what stands here speak of the monitored robot? A function may not.
  [[nodiscard]] bool sees_robot() const { return scope_.of_robot() && function_ == nullptr; }

  Context& context_;
  const PropertyScope& scope_;
  const syntax::Name* other_ = nullptr;  // the variable of the enclosing quantifier
  // Variables of quantifiers in monitors without a robot, and whom they stand for; innermost last.
  std::vector<std::pair<const syntax::Name*, RobotId>> members_;
  // The same of the innermost quantifier over agents, in a monitor of a robot.
  std::optional<std::pair<const syntax::Name*, AgentId>> agent_;
  std::vector<Local> locals_;           // the innermost last
  const Function* function_ = nullptr;  // the one whose body is looked at
  SourceRange call_;                    // the outermost call that led there
  bool generic_ = false;                // a body on its own: its arguments are not known
  // +1: the property needs this to be true, -1: false; 0: neither, or not known.
  int polarity_ = 1;
  int depth_ = 0;
  int asked_twice_ = 0;  // how many `iff`, `xor` and comparisons of conditions it stands in
  std::size_t size_ = 0;
  bool exhausted_ = false;  // a limit was reached and reported
};

ExprPtr make_quantity(const SourceRange& range, const Dimension& dimension,
                      decltype(Expr::node) node);
ExprPtr make_condition(const SourceRange& range, decltype(Expr::node) node);
// One or two operands.
std::vector<ExprPtr> operands_of(ExprPtr first, ExprPtr second = nullptr);
std::optional<Rational> constant_of(const Expr& expr);
const syntax::Name* name_in(const syntax::Expr& expr);

}  // namespace rtac::sema
