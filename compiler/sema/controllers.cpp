#include "compiler/sema/controllers.h"

#include <algorithm>

#include "compiler/sema/quantity.h"
#include "compiler/sema/zones.h"

namespace rtac::sema {

namespace {

class ControllerChecker {
 public:
  ControllerChecker(Context& context, std::uint32_t index)
      : context_(context),
        controller_(context.spec.controllers[index]),
        written_(*context.controllers[index].node) {}

  void check() {
    const auto kind = context_.resolve<KindId>(written_.kind, Sort::robot_kind);
    if (kind) controller_.kind = *kind;
    kind_known_ = kind.has_value();
    std::visit([&](const auto& node) { implementation(node); }, written_.implementation);
  }

 private:
  void implementation(const syntax::ExternTemplate& node) {
    ExternController external;
    if (node.zone) {
      range_ = written_.implementation_range;
      built_in("keeps");
      const auto zone = zone_flown_in(*node.zone);
      external.claim = {zone.value_or(ZoneId{}), speed(node.speed, "keeps")};
    }
    controller_.implementation = std::move(external);
  }
  void implementation(const syntax::SequenceTemplate& sequence) {
    range_ = written_.implementation_range;
    Sequence all;
    for (const syntax::SequenceStep& step : sequence.steps) {
      range_ = step.range;
      auto what = std::visit([&](const auto& node) { return manoeuvre(node); }, step.what);
      if (step.lasts && std::holds_alternative<Route>(what)) report_broken_off();
      std::optional<Quantity> lasts;
      if (step.lasts) lasts = duration(*step.lasts);
      all.steps.push_back({std::move(what), std::move(lasts)});
    }
    controller_.implementation = std::move(all);
  }
  template <class Node>
  void implementation(const Node& node) {
    range_ = written_.implementation_range;
    std::visit([&](const auto& what) { controller_.implementation = what; }, manoeuvre(node));
  }

  Template manoeuvre(const syntax::BrakeTemplate&) {
    built_in("brake_and_hold");
    return BrakeAndHold{};
  }
  Template manoeuvre(const syntax::RetreatTemplate& retreat) {
    built_in("retreat");
    const auto zone = zone_flown_in(retreat.zone);
    return Retreat{zone.value_or(ZoneId{}), speed(retreat.speed, "retreat")};
  }
  Template manoeuvre(const syntax::LoiterTemplate& loiter) {
    built_in("loiter");
    const auto zone = zone_flown_in(loiter.zone);
    return Loiter{zone.value_or(ZoneId{}), speed(loiter.speed, "loiter")};
  }
  Template manoeuvre(const syntax::RouteTemplate& route) {
    built_in("route");
    const auto site = context_.resolve<SiteId>(route.site, Sort::site);
    const auto zone = zone_of_ways(route.zone, "route");
    if (site && kind_known_) {
      context_.require_places(*site, controller_.kind, route.site.range);
    }
    return Route{site.value_or(SiteId{}), zone.value_or(ZoneId{}), speed(route.speed, "route")};
  }
  Template manoeuvre(const syntax::YieldTemplate& yield) {
    built_in("yield");
    const auto zone = zone_of_ways(yield.zone, "yield");
    if (yield.order.text != "id") {
      context_.unknown_word(yield.order, "an order of robots", {"id"});
    }
    return Yield{zone.value_or(ZoneId{}), speed(yield.speed, "yield")};
  }
  // Ways over cells are of the plane: a robot in space keeps its height on them.
  std::optional<ZoneId> zone_of_ways(const syntax::Name& name, const std::string& user) {
    const auto zone = zone_flown_in(name);
    if (!zone || !context_.spec[*zone].has_height) return zone;
    context_.report(
        Finding(Code::spaces_differ, name.range,
                "`" + user + "` keeps its height, and `" + name.text + "` has floors and ceilings")
            .label("a zone of the plane is due here")
            .help("a zone without `box` and `prism` works; `retreat within " + name.text +
                  " ...` moves up and down"));
    return std::nullopt;
  }
  // Of a robot in space it may have floors and ceilings.
  std::optional<ZoneId> zone_flown_in(const syntax::Name& zone) {
    const bool in_space = kind_known_ && context_.spec[controller_.kind].in_space;
    return zone_in_frame(context_, zone, map_frame, Change::refused,
                         in_space ? Height::allowed : Height::refused);
  }
  // Of a robot in the plane nothing is known of how far below the ground is, and how fast it may
  // come nearer.
  Template manoeuvre(const syntax::LandTemplate& land) {
    built_in("land");
    if (kind_known_ && !context_.spec[controller_.kind].in_space) {
      const RobotKind& kind = context_.spec[controller_.kind];
      context_.report(
          Finding(Code::land_without_height, range_,
                  "`land` needs a height, and `" + kind.name + "` has none")
              .label("the robot moves in the plane")
              .note(kind.name_range, "it is declared here")
              .help("declare `sense position : point3 ...` and `sense velocity : vector3 ...`; or "
                    "`brake_and_hold` works: it brings the robot to rest over a place inside the "
                    "zone, and its autopilot may land while the record names this recovery"));
      return BrakeAndHold{};
    }
    if (!land.height) {
      context_.missing_clause(range_, "`land`", "height", "to 0.5 m");
      return BrakeAndHold{};
    }
    const auto height = quantity(context_, *land.height, {dims::length, "the height of `land`"});
    return Land{height.value_or(Quantity{0, land.height->range}), speed(land.speed, "land")};
  }

  void report_broken_off() {
    context_.report(
        Finding(Code::clause_without_effect, range_, "a way that is broken off leads nowhere")
            .label("goes on with another step before it arrives")
            .help("`route` works as the last step of a `sequence`"));
  }
  std::optional<Quantity> duration(const syntax::Expr& expr) {
    return quantity(context_, expr, {dims::time, "how long a step lasts", Limit::positive});
  }

  // What every template needs: it is safe, and it steers by what the robot senses.
  void built_in(const std::string& name) {
    if (written_.role == syntax::Role::advanced) {
      context_.report(Finding(Code::wrong_role, range_,
                              "`" + name + "` is a safe controller, but `" + controller_.name +
                                  "` is declared as advanced")
                          .label("a safe controller")
                          .help("write `safe` instead of `advanced`, or `extern` for a controller "
                                "of your own"));
    }
    if (!kind_known_) return;
    const std::string user = "`" + name + "`";
    const SourceRange& range = range_;
    context_.require(controller_.kind, Need::position, range, user);
    context_.require(controller_.kind, Need::velocity, range, user);
    if (context_.spec[controller_.kind].motion.model == MotionModel::unicycle) {
      context_.require(controller_.kind, Need::heading, range, user + " on a unicycle");
    }
  }

  Quantity speed(const syntax::ExprPtr& expr, const std::string& name) {
    if (!expr) {
      context_.missing_clause(range_, "`" + name + "`", "`speed`", "speed 0.1 m/s");
      return {0, range_};
    }
    const auto value =
        quantity(context_, *expr,
                 {dims::speed, "the speed of `" + name + "`", Limit::positive, speeds_that_work()});
    if (!value) return {0, expr->range};
    if (kind_known_) compare_with_limit(*value);
    return *value;
  }

  // The slowest recovery that makes way in spite of the error of its velocity, where nothing pushes
  // it (analysis/derive.cpp); 1 mm/s: the grid.
  static Rational slowest(const RobotKind& kind) {
    const bool steers = kind.motion.model == MotionModel::point && !kind.in_space;
    const Rational least =
        steers && kind.velocity ? Rational(2 * kind.velocity->error.value) : Rational(0);
    return Rational(std::max<std::int64_t>(1, ceil_to_int(Rational(least * 1000))), 1000);
  }
  // "": no speed does; that is found where it is derived, as is what pushes the robot.
  std::string speeds_that_work() const {
    if (!kind_known_) return "";
    const RobotKind& kind = context_.spec[controller_.kind];
    const Rational &most = kind.motion.speed.value, least = slowest(kind);
    if (most < least || disturbance_of(kind) > 0) return "";
    return show(least, dims::speed) + " to " + show(most, dims::speed) + " works";
  }

  void compare_with_limit(const Quantity& speed) {
    const RobotKind& kind = context_.spec[controller_.kind];
    const Quantity& limit = kind.motion.speed;
    if (limit.value <= 0 || speed.value <= limit.value) return;  // 0: reported already
    const std::string most = show(limit.value, dims::speed);
    // the robot itself is too slow for any recovery: its limit is what has to change
    const bool slow_robot = limit.value < slowest(kind);
    context_.report(Finding(Code::limit_contradictory, speed.range,
                            "`" + controller_.name + "` drives at " +
                                show(speed.value, dims::speed) + ", but `" + kind.name +
                                "` reaches at most " + most)
                        .label("faster than the robot")
                        .note(limit.range, "the limit is declared here")
                        .help(slow_robot ? "no speed of a recovery works with that limit: a limit "
                                           "of at least " +
                                               show(speed.value, dims::speed) + " works"
                                         : "a speed of at most " + most + " works"));
  }

  Context& context_;
  Controller& controller_;
  const syntax::ControllerItem& written_;
  SourceRange range_;  // of the template, or of the step of a sequence, that is looked at
  bool kind_known_ = false;
};

}  // namespace

void check_controllers(Context& context) {
  for (std::uint32_t i = 0; i < context.controllers.size(); ++i) {
    ControllerChecker(context, i).check();
  }
}

}  // namespace rtac::sema
