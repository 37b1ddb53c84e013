#include "compiler/sema/robots.h"

#include <map>
#include <string_view>
#include <utility>

#include "compiler/sema/bounds.h"
#include "compiler/sema/quantity.h"

namespace rtac::sema {

using syntax::Relation;

namespace {

class KindChecker {
 public:
  KindChecker(Context& context, KindId id)
      : context_(context),
        kind_(context.spec.kinds[index_of(id)]),
        written_(*context.kinds[index_of(id)].node),
        id_(id) {}

  void check() {
    for (const syntax::RobotClause& clause : written_.clauses) {
      std::visit([&](const auto& node) { this->clause(clause.range, node); }, clause.node);
    }
    demand("body", "body radius 11 cm;");
    demand("motion", "motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }");
    const bool unicycle = kind_.motion.model == MotionModel::unicycle;
    demand("output", unicycle ? "output drive : twist;" : "output thrust : acceleration;");
    demand("latency", "latency 40 ms;");
    check_output();
    check_space();
  }

 private:
  [[nodiscard]] std::string owner() const { return "`" + kind_.name + "`"; }

  // The first clause of its sort; a later one is reported.
  bool first(const std::string& key, const SourceRange& range) {
    const auto [place, added] = seen_.emplace(key, range);
    if (!added) context_.duplicate_clause(range, place->second, "`" + key + "`");
    return added;
  }

  void demand(const std::string& key, const std::string& example) {
    if (seen_.count(key) == 0) {
      context_.missing_clause(kind_.name_range, owner(), "`" + key + "`", example);
    }
  }

  // A value that the grammar lets the author leave out: "the `word` of `owner`".
  struct Part {
    std::string word, owner;
    Dimension dimension;
    Limit limit;
    std::string example;
  };
  Quantity part(const SourceRange& clause, const syntax::ExprPtr& expr, const Part& part) {
    if (!expr) {
      context_.missing_clause(clause, "`" + part.owner + "`", "`" + part.word + "`", part.example);
      return {0, clause};
    }
    const std::string what =
        part.owner == "latency" ? "`latency`" : "the `" + part.word + "` of `" + part.owner + "`";
    const Due due{part.dimension, what, part.limit};
    return quantity(context_, *expr, due).value_or(Quantity{0, expr->range});
  }

  void clause(const SourceRange& range, const syntax::BodyClause& body) {
    if (!first("body", range)) return;
    kind_.radius =
        part(range, body.radius, {"radius", "body", dims::length, Limit::positive, "radius 11 cm"});
  }

  void clause(const SourceRange& range, const syntax::MotionClause& written) {
    if (!first("motion", range)) return;
    kind_.motion.range = range;
    const std::string& model = written.model.text;
    if (model != "point" && model != "unicycle") {
      context_.unknown_word(written.model, "a motion model", {"point", "unicycle"});
      return;
    }
    const bool unicycle = model == "unicycle";
    kind_.motion.model = unicycle ? MotionModel::unicycle : MotionModel::point;
    motion_known_ = true;
    std::vector<BoundRule> rules{
        {"speed", Relation::at_most, dims::speed, Limit::positive, true, "speed <= 0.5 m/s",
         "at least 0.001 m/s works, and no less than its recoveries drive at"},
        {"accel", Relation::at_most, dims::acceleration, Limit::positive, true, "accel <= 1 m/s^2",
         "at least 0.001 m/s^2 is due, and what its zones ask for beyond"},
        {"brake", Relation::at_least, dims::acceleration, Limit::any, true, "brake >= 1 m/s^2"}};
    if (unicycle) {
      rules.push_back({"turn", Relation::at_most, dims::turn_rate, Limit::positive, true,
                       "turn <= 2 rad/s",
                       "at least 0.001 rad/s is due, and what its zones ask for beyond"});
      rules.push_back({"turn_accel", Relation::at_most, dims::turn_acceleration, Limit::positive,
                       false, "turn_accel <= 10 rad/s^2",
                       "at least 0.001 rad/s^2 is due, and what its zones ask for beyond"});
    } else {
      rules.push_back({"disturbance", Relation::at_most, dims::acceleration, Limit::not_negative,
                       false, "disturbance <= 0.1 m/s^2"});
    }
    BoundValues values = check_bounds(context_, suited(written.bounds, unicycle), rules,
                                      "the motion of " + owner(), range);
    kind_.motion.speed = values["speed"].quantity;
    kind_.motion.accel = values["accel"].quantity;
    kind_.motion.brake = values["brake"].quantity;
    if (values["turn"].good) kind_.motion.turn = values["turn"].quantity;
    if (values["turn_accel"].good) kind_.motion.turn_accel = values["turn_accel"].quantity;
    if (values["disturbance"].good) kind_.motion.disturbance = values["disturbance"].quantity;
  }

  // Limits of the other motion model: says so rather than that the limit is unknown.
  std::vector<const syntax::Bound*> suited(const std::vector<syntax::Bound>& bounds,
                                           bool unicycle) {
    std::vector<const syntax::Bound*> kept;
    for (const syntax::Bound& bound : bounds) {
      const std::string& name = bound.name.text;
      if (!unicycle && (name == "turn" || name == "turn_accel")) {
        report_unsuited(bound, "point", "a point has no heading",
                        "leave it out, or write `motion unicycle`");
      } else if (unicycle && name == "disturbance") {
        report_unsuited(bound, "unicycle", "wheels do not drift",
                        "declare as `accel` and `brake` what the base keeps in spite of it, or "
                        "write `motion point`");
      } else {
        kept.push_back(&bound);
      }
    }
    return kept;
  }
  void report_unsuited(const syntax::Bound& bound, const std::string& model,
                       const std::string& label, const std::string& help) {
    context_.report(Finding(Code::clause_without_effect, bound.name.range,
                            "`" + bound.name.text + "` has no effect on `motion " + model + "`")
                        .label(label)
                        .help(help));
  }

  void clause(const SourceRange& range, const syntax::SenseClause& sense) {
    struct Known {
      const char* name;
      const char* type;
      const char* in_space;  // the type with three components; "": none
      Dimension dimension;
      Limit limit;
      std::optional<Sense> RobotKind::*member;
      const char* example;
    };
    static const Known known[] = {
        {"position", "point", "point3", dims::length, Limit::not_negative, &RobotKind::position,
         "2 cm"},
        {"heading", "angle", "", dims::angle, Limit::not_negative, &RobotKind::heading, "2 deg"},
        {"velocity", "vector", "vector3", dims::speed, Limit::not_negative, &RobotKind::velocity,
         "1 cm/s"},
        {"battery", "ratio", "", dims::ratio, Limit::share, &RobotKind::battery, "0.5 %"}};
    const Known* signal = nullptr;
    for (const Known& candidate : known) {
      if (sense.name.text == candidate.name) signal = &candidate;
    }
    if (signal == nullptr) {
      context_.unknown_word(sense.name, "a signal that a robot senses",
                            {"position", "heading", "velocity", "battery"});
      return;
    }
    const std::string name = signal->name;
    if (!first("sense " + name, range)) return;
    if (!std::string_view(signal->in_space).empty() && sense.type.text == signal->in_space) {
      spaces_[name] = {sense.type.range, true};
    } else if (sense.type.text != signal->type) {
      std::vector<std::string> types{signal->type};
      if (!std::string_view(signal->in_space).empty()) types.emplace_back(signal->in_space);
      context_.unknown_word(sense.type, "the type of `" + name + "`", types);
    } else {
      spaces_[name] = {sense.type.range, false};
    }
    const std::string owner = "sense " + name;
    const Quantity error = part(range, sense.error,
                                {"error", owner, signal->dimension, signal->limit,
                                 std::string("error ") + signal->example});
    const Quantity age =
        part(range, sense.max_age,
             {"max_age", owner, dims::time, Limit::not_negative, "max_age 200 ms"});
    kind_.*signal->member = Sense{error, age};
  }

  // Position and velocity are both of the plane or both of space, and wheels drive in the plane.
  void check_space() {
    const auto position = spaces_.find("position"), velocity = spaces_.find("velocity");
    if (position == spaces_.end()) {
      context_.height_unclear = true;  // its type is unknown, or has been lost
      return;
    }
    const bool high = position->second.second;
    if (velocity != spaces_.end() && velocity->second.second != high) {
      const std::string due = high ? "vector3" : "vector";
      context_.report(Finding(Code::spaces_differ, velocity->second.first,
                              "the position of " + owner() +
                                  (high ? " is in space" : " is in the plane") +
                                  ", and its velocity is not")
                          .label(high ? "of the plane" : "of space")
                          .note(position->second.first, "the position is declared here")
                          .help("write `" + due + "`")
                          .replace(velocity->second.first, due));
      kind_.in_space = high;  // as its position says
      return;
    }
    if (!high) return;
    kind_.in_space = true;
    if (motion_known_ && kind_.motion.model == MotionModel::unicycle) {
      context_.report(Finding(Code::spaces_differ, position->second.first,
                              "a unicycle drives in the plane, and its position is in space")
                          .label("has a height")
                          .note(kind_.motion.range, "the motion is declared here")
                          .help("write `point` and `vector`, or `motion point`"));
      return;
    }
    if (kind_.plan) {
      report_not_in_space(kind_.plan->range, "follow plans",
                          "way-points have no height: leave the plan out");
    }
    if (kind_.energy) {
      report_not_in_space(kind_.energy->range, "have `energy`",
                          "ways are priced in the plane: leave it out");
    }
  }
  void report_not_in_space(const SourceRange& range, const std::string& what,
                           const std::string& help) {
    context_.report(
        Finding(Code::not_in_space, range, "robots in space cannot " + what + " yet")
            .label(owner() + " has a height")
            .note(spaces_.at("position").first, "its position is in space")
            .help(help + "; or write `point` and `vector`, which works for a robot that keeps its "
                         "height"));
  }

  void clause(const SourceRange& range, const syntax::HearsClause& hears) {
    if (!first("hears", range)) return;
    kind_.hears_max_age =
        part(range, hears.max_age,
             {"max_age", "hears other robots", dims::time, Limit::not_negative, "max_age 200 ms"});
    kind_.open_fleet = hears.present;
  }

  void clause(const SourceRange& range, const syntax::InputClause& input) {
    if (input.name.text != "plan") {
      context_.unknown_word(input.name, "an input of a robot", {"plan"});
      return;
    }
    if (!first("input plan", range)) return;
    if (input.type.text != "path") {
      context_.unknown_word(input.type, "the type of `plan`", {"path"});
    }
    PlanInput plan{};
    plan.range = range;
    if (!input.capacity) {
      context_.missing_clause(range, "`input plan`", "capacity", "path[64]");
    } else {
      plan.capacity =
          count(context_, *input.capacity, "the capacity of `plan`", 1, max_path).value_or(1);
    }
    plan.tracking =
        part(range, input.tracking,
             {"tracking", "input plan", dims::length, Limit::not_negative, "tracking <= 10 cm"});
    kind_.plan = plan;
  }

  void clause(const SourceRange& range, const syntax::OutputClause& output) {
    if (!first("output", range)) return;
    kind_.output_name = output.name.text;
    output_range_ = output.type.range;
    if (output.type.text == "twist") {
      kind_.output = OutputType::twist;
    } else if (output.type.text == "acceleration") {
      kind_.output = OutputType::acceleration;
    } else {
      output_range_.reset();
      context_.unknown_word(output.type, "an output of a robot", {"twist", "acceleration"});
    }
    if (output.error && output_range_) output_error(*output.error);
    const bool lost = output.error && !kind_.output_error;
    if (lost && kind_.output == OutputType::acceleration) context_.faulty_outputs.insert(id_);
  }

  // How far the robot is from doing what it is told. A twist takes its time, and how is not
  // declared.
  void output_error(const syntax::Expr& written) {
    if (kind_.output == OutputType::twist) {
      context_.report(
          Finding(Code::clause_without_effect, written.range, "an `error` has no effect on a twist")
              .label("how a base follows it is bounded by its motion")
              .help("leave it out"));
      return;
    }
    kind_.output_error = quantity(
        context_, written, {dims::acceleration, "the `error` of the output", Limit::not_negative});
  }

  // A twist is a speed along the heading and a turn rate; only a unicycle can follow it.
  void check_output() {
    if (!output_range_) context_.faulty_outputs.insert(id_);  // lost, or of another type
    const bool twist = kind_.output == OutputType::twist;
    const bool unicycle = kind_.motion.model == MotionModel::unicycle;
    if (!motion_known_ || !output_range_ || twist == unicycle) return;
    const std::string right = unicycle ? "twist" : "acceleration";
    context_.report(Finding(Code::output_unsuited, *output_range_,
                            std::string("`motion ") + (unicycle ? "unicycle" : "point") +
                                "` cannot follow the output `" +
                                (twist ? "twist" : "acceleration") + "`")
                        .label("does not suit the motion")
                        .note(kind_.motion.range, "the motion is declared here")
                        .help("write `" + right + "`")
                        .replace(*output_range_, right));
  }

  void clause(const SourceRange& range, const syntax::LatencyClause& latency) {
    if (!first("latency", range)) return;
    kind_.latency = part(range, latency.value,
                         {"time", "latency", dims::time, Limit::not_negative, "latency 40 ms"});
  }

  void clause(const SourceRange& range, const syntax::EnergyClause& written) {
    if (!first("energy", range)) return;
    static const std::vector<BoundRule> rules{
        {"drive", Relation::at_most, dims::ratio_per_length, Limit::not_negative, true,
         "drive <= 0.4 %/m"},
        {"idle", Relation::at_most, dims::ratio_per_time, Limit::not_negative, true,
         "idle <= 0.01 %/s"},
        {"drain", Relation::at_most, dims::ratio_per_time, Limit::not_negative, true,
         "drain <= 0.2 %/s"},
        {"charge", Relation::at_least, dims::ratio_per_time, Limit::positive, true,
         "charge >= 1 %/s at dock"},
        {"held", Relation::at_most, dims::time, Limit::not_negative, true, "held <= 60 s"},
        {"detour", Relation::at_most, dims::length, Limit::not_negative, true, "detour <= 3 m"}};
    std::vector<const syntax::Bound*> bounds;
    for (const syntax::Bound& bound : written.bounds) bounds.push_back(&bound);
    BoundValues values = check_bounds(context_, bounds, rules, "the energy of " + owner(), range);
    Energy energy{range,
                  values["drive"].quantity,
                  values["idle"].quantity,
                  values["drain"].quantity,
                  values["charge"].quantity,
                  charging_site(values["charge"].written),
                  values["held"].quantity,
                  values["detour"].quantity};
    for (const syntax::Bound& bound : written.bounds) {
      if (values.count(bound.name.text) > 0) check_at(bound);  // others are unknown: reported
    }
    if (values["idle"].good && values["drain"].good && energy.drain.value < energy.idle.value) {
      report_drain(energy);
    }
    kind_.energy = energy;
  }

  SiteId charging_site(const syntax::Bound* charge) {
    if (charge == nullptr) return SiteId{};
    if (!charge->at) {
      context_.missing_clause(charge->name.range, "`charge`", "place", "at dock");
      return SiteId{};
    }
    const auto site = context_.resolve<SiteId>(*charge->at, Sort::site);
    if (site) context_.require_places(*site, id_, charge->at->range);
    return site.value_or(SiteId{});
  }

  void check_at(const syntax::Bound& bound) {
    if (!bound.at || bound.name.text == "charge") return;
    context_.report(
        Finding(Code::clause_without_effect, bound.at->range,
                "`at " + bound.at->text + "` has no effect on `" + bound.name.text + "`")
            .label("only `charge` depends on a place")
            .help("leave it out"));
  }

  void report_drain(const Energy& energy) {
    const std::string idle = show(energy.idle.value, dims::ratio_per_time);
    context_.report(Finding(Code::limit_contradictory, energy.drain.range,
                            "`drain` of " + show(energy.drain.value, dims::ratio_per_time) +
                                " is less than `idle` of " + idle)
                        .label("the most that any motion takes")
                        .note(energy.idle.range, "at rest it takes up to " + idle)
                        .help("`drain` of at least " + idle + " works"));
  }

  Context& context_;
  RobotKind& kind_;
  const syntax::RobotItem& written_;
  KindId id_;
  std::map<std::string, SourceRange> seen_;
  // Of position and velocity: where the type is written, and whether it is one of space.
  std::map<std::string, std::pair<SourceRange, bool>> spaces_;
  std::optional<SourceRange> output_range_;
  bool motion_known_ = false;
};

}  // namespace

void check_kinds(Context& context) {
  for (std::uint32_t i = 0; i < context.kinds.size(); ++i) KindChecker(context, KindId{i}).check();
}

}  // namespace rtac::sema
