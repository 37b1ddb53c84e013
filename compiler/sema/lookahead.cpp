// The clause `ahead 200 ms, 2 waypoints` of a monitor.
#include <map>

#include "compiler/sema/monitors.h"
#include "compiler/sema/quantity.h"
#include "compiler/sema/suggest.h"
#include "compiler/sema/units.h"

namespace rtac::sema {

namespace {

// Largest number of way-points that a decision looks ahead.
constexpr int max_waypoints_ahead = 16;

class AheadChecker {
 public:
  AheadChecker(Context& context, const syntax::MonitorItem& monitor,
               const std::optional<KindId>& kind)
      : context_(context), monitor_(monitor), kind_(kind) {}

  Ahead check() {
    ahead_.range = monitor_.name.range;
    if (!monitor_.ahead.empty()) {
      ahead_.range = monitor_.ahead.front().range;
      ahead_.range.end = monitor_.ahead.back().range.end;
    }
    for (const syntax::AheadTerm& written : monitor_.ahead) {
      std::visit([&](const auto& node) { term(written.range, node); }, written.node);
    }
    check_combination();
    return std::move(ahead_);
  }

 private:
  bool first(const std::string& what, const SourceRange& range) {
    const auto [place, added] = seen_.emplace(what, range);
    if (!added) context_.duplicate_clause(range, place->second, what);
    return added;
  }

  void term(const SourceRange& range, const syntax::AheadDuration& written) {
    if (const auto* name = std::get_if<syntax::NameRef>(&written.duration->node)) {
      if (name->name.text == "command") return command(range, written);
    }
    if (is_misspelt_waypoints(*written.duration)) return;
    if (!first("the duration of `ahead`", range)) return;
    duration_range_ = range;
    ahead_.duration = quantity(context_, *written.duration,
                               {dims::time, "the duration of `ahead`", Limit::positive,
                                "leave `ahead` out, and the least that works is taken"});
    if (!written.unsound || !reason_given(range, *written.unsound)) return;
    ahead_.duration_unsound = written.unsound->text;
    warn(range, "a duration below the reaction time of the module is allowed");
  }

  // `2 wayponts` is no duration.
  bool is_misspelt_waypoints(const syntax::Expr& duration) {
    const auto* number = std::get_if<syntax::NumberLit>(&duration.node);
    if (number == nullptr || !number->unit || parse_unit(number->unit->text)) return false;
    const auto meant = nearest(number->unit->text, {"waypoint", "waypoints"});
    if (!meant) return false;
    has_waypoints_ = true;
    context_.report(Finding(Code::unknown_unit, number->unit->range,
                            "the unit `" + number->unit->text + "` is not known")
                        .label("neither a unit nor way-points")
                        .help("did you mean `" + *meant + "`?")
                        .replace(number->unit->range, *meant));
    return true;
  }

  // `ahead command`: where the robot will be when it does what it is told, which has to be known.
  void command(const SourceRange& range, const syntax::AheadDuration& written) {
    if (!first("`command`", range)) return;
    command_range_ = range;
    ahead_.command = true;
    if (written.unsound) {
      context_.report(Finding(Code::clause_without_effect, written.unsound->range,
                              "`ahead command` is sound, whatever its reason")
                          .label("no reason is due")
                          .help("leave it out"));
    }
    if (!kind_ || context_.faulty_outputs.count(*kind_) > 0) return;
    const RobotKind& kind = context_.spec[*kind_];
    if (kind.output == OutputType::twist) {
      context_.report(Finding(Code::output_unsuited, range,
                              "`ahead command` needs to know how `" + kind.name +
                                  "` follows its commands, and a twist does not say")
                          .label("a twist is followed within limits, not at once")
                          .help("`ahead 200 ms` works: under any control"));
    } else if (!kind.output_error) {
      context_.report(
          Finding(Code::limit_missing, range,
                  "`ahead command` needs the `error` of the output of `" + kind.name + "`")
              .label("how exactly it follows commands is not declared")
              .note(kind.name_range, "the robot is declared here")
              .help("write `output " + kind.output_name +
                    " : acceleration error 0.05 m/s^2;` with a bound between the "
                    "commanded and the true acceleration"));
    }
  }

  // `ahead 200 ms and 2 waypoints`
  bool is_joined_by_and(const syntax::Expr& count) {
    const auto* joined = std::get_if<syntax::Binary>(&count.node);
    if (joined == nullptr || joined->op != syntax::BinaryOp::logical_and) return false;
    const SourceRange& left = joined->left->range;
    context_.report(Finding(Code::quantity_expected, joined->op_range,
                            "what is looked at is listed, not joined by `and`")
                        .label("a `,` is due")
                        .help("write `ahead 200 ms, 2 waypoints`")
                        .replace({left.file, left.end, joined->op_range.end}, ","));
    return true;
  }

  void term(const SourceRange& range, const syntax::AheadWaypoints& written) {
    if (!first("the number of `waypoints`", range)) return;
    has_waypoints_ = true;
    if (is_joined_by_and(*written.count)) return;
    const auto number =
        count(context_, *written.count, "the number of `waypoints`", 1, max_waypoints_ahead);
    ahead_.waypoints = number.value_or(1);
    if (kind_) context_.require(*kind_, Need::plan, range, "`waypoints`");
  }

  void term(const SourceRange& range, const syntax::WaypointsOnly& written) {
    if (!first("`waypoints only`", range)) return;
    ahead_.waypoints_only = true;
    only_range_ = range;
    unsound_term(range, written.unsound, "`waypoints only`", "what happens between decisions");
  }

  void term(const SourceRange& range, const syntax::PointsOnly& written) {
    if (!first("`points only`", range)) return;
    ahead_.points_only = true;
    if (!only_range_) only_range_ = range;
    unsound_term(range, written.unsound, "`points only`", "the legs between way-points");
  }

  void unsound_term(const SourceRange& range, const std::optional<syntax::Text>& reason,
                    const std::string& term, const std::string& ignored) {
    if (!reason) {
      context_.report(
          Finding(Code::unsound_reason_missing, range, term + " is unsound: it ignores " + ignored)
              .label("must be declared")
              .help("write " + term.substr(0, term.size() - 1) +
                    " unsound \"why\"` with the reason, which goes into the evidence")
              .insert_after(range, " unsound \"why\""));
      return;
    }
    if (!reason_given(range, *reason)) return;
    std::string& all = ahead_.unsound_reason;
    if (all.empty()) {
      all = reason->text;
    } else if (all != reason->text) {
      all += "; " + reason->text;
    }
    warn(range, term + " ignores " + ignored);
  }

  bool reason_given(const SourceRange& range, const syntax::Text& reason) {
    if (reason.text.find_first_not_of(" \t") != std::string::npos) return true;
    context_.report(Finding(Code::unsound_reason_missing, range, "the reason is empty")
                        .label("no reason")
                        .help("say why an unsound look-ahead is acceptable here"));
    return false;
  }

  void warn(const SourceRange& range, const std::string& what) {
    context_.report(
        Finding(Code::unsound_lookahead, range,
                "the look-ahead of `" + monitor_.name.text + "` is unsound: " + what)
            .label("declared unsound")
            .help(std::string("for comparison only: a sound look-ahead has a duration") +
                  (has_plan() ? " and judges legs, `ahead 200 ms, 2 waypoints`"
                              : ", or none is written, and the least that works is "
                                "taken")));
  }
  // Of no robot in particular, any may have one.
  [[nodiscard]] bool has_plan() const { return !kind_ || context_.spec[*kind_].plan.has_value(); }

  void check_combination() {
    if (only_range_ && !has_waypoints_) {
      context_.report(Finding(Code::waypoints_missing, *only_range_,
                              "the look-ahead does not say how many way-points it judges")
                          .label("no number of `waypoints`")
                          .help("write `ahead 2 waypoints, ...`"));
    }
    if (ahead_.waypoints_only && command_range_) {
      context_.report(Finding(Code::clause_without_effect, *command_range_,
                              "`command` has no effect beside `waypoints only`")
                          .label("would be ignored")
                          .note(*only_range_, "`waypoints only` drops what is within reach")
                          .help("leave out one of the two"));
    }
    if (ahead_.waypoints_only && duration_range_) {
      context_.report(Finding(Code::clause_without_effect, *duration_range_,
                              "the duration has no effect beside `waypoints only`")
                          .label("would be ignored")
                          .note(*only_range_, "`waypoints only` drops the duration check")
                          .help("leave out one of the two"));
    }
  }

  Context& context_;
  const syntax::MonitorItem& monitor_;
  std::optional<KindId> kind_;
  Ahead ahead_;
  std::map<std::string, SourceRange> seen_;
  std::optional<SourceRange> duration_range_, only_range_, command_range_;
  bool has_waypoints_ = false;
};

}  // namespace

Ahead check_ahead(Context& context, const syntax::MonitorItem& monitor,
                  const std::optional<KindId>& kind) {
  return AheadChecker(context, monitor, kind).check();
}

}  // namespace rtac::sema
