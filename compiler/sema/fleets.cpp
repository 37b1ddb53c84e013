#include "compiler/sema/fleets.h"

#include "compiler/sema/quantity.h"
#include "compiler/sema/zones.h"

namespace rtac::sema {

namespace {

template <class Node, class Visit>
void for_each_item(const syntax::Program& program, Visit&& visit) {
  for (const syntax::File& file : program.files) {
    for (const syntax::Item& item : file.items) {
      if (const auto* node = std::get_if<Node>(&item.node)) visit(item, *node);
    }
  }
}

void check_fleet_size(Context& context, KindId kind, const SourceRange& range) {
  int robots = 0;
  for (const Robot& robot : context.spec.robots) robots += robot.kind == kind ? 1 : 0;
  if (robots <= max_fleet) return;
  context.report(Finding(Code::quantity_out_of_range, range,
                         "a fleet of " + std::to_string(robots) + " robots is too large")
                     .label("at most " + std::to_string(max_fleet) + " robots of one kind")
                     .help("a fleet of up to " + std::to_string(max_fleet) + " robots works"));
}

// The earlier place that `robot` would have at the site, too.
const Site::Place* earlier_place(const Site& site, const std::optional<RobotId>& robot) {
  for (const Site::Place& place : site.places) {
    if (!robot || !place.robot || *place.robot == *robot) return &place;
  }
  return nullptr;
}

void check_site(Context& context, const syntax::Item& item, const syntax::SiteItem& written) {
  const Symbol* symbol = context.symbols.find(written.name.text);
  if (symbol == nullptr || symbol->sort != Sort::site) return;  // reported as a duplicate name
  Site& site = context.spec.sites[symbol->index];
  Site::Place place{std::nullopt, {}, item.range};
  bool good = true;
  if (written.robot) {
    place.robot = resolve_robot(context, written.robot->name, written.robot->number.get());
    good = place.robot.has_value();
  }
  if (good) {
    if (const Site::Place* earlier = earlier_place(site, place.robot)) {
      const std::string whose =
          place.robot ? "`" + context.spec[*place.robot].name + "`" : "some robot";
      context.report(Finding(Code::duplicate_name, written.name.range,
                             "`" + site.name + "` has two places for " + whose)
                         .label("the second place")
                         .note(earlier->range, "the first place is here")
                         .help("keep one of them"));
      good = false;
    }
  }
  const auto position = check_point(context, *written.position, "a place");
  if (position) place.position = *position;
  if (good) {
    site.places.push_back(place);
  } else {
    context.faulty_sites.insert(SiteId{symbol->index});
  }
}

// The robots of one name stand one behind the other.
std::size_t members_of(const Context& context, const syntax::FleetItem& fleet,
                       const std::string& name, std::size_t first) {
  if (!fleet.count) return 1;
  const auto& robots = context.spec.robots;
  std::size_t count = 0;
  const auto follows = [&](const Robot& robot) {
    return robot.fleet == name && robot.number == count;
  };
  while (first + count < robots.size() && follows(robots[first + count])) ++count;
  return count;
}

}  // namespace

std::optional<std::uint32_t> resolve_numbered(Context& context, const syntax::Name& name,
                                              const syntax::Expr* number, const Numbered& what) {
  const Symbol* symbol = context.symbols.find(name.text);
  if (symbol == nullptr || symbol->sort != what.group) {
    const auto found = context.resolve(name, what.one);
    if (!found || number == nullptr) return found;
    context.report(Finding(Code::wrong_sort, number->range, "`" + name.text + "` is " + what.a_one)
                       .label("has no number")
                       .note(symbol->range, "`" + name.text + "` is declared here")
                       .help("write `" + name.text + "`"));
    return std::nullopt;
  }
  const std::string member = what.member;
  const NumberedFleet& group = what.groups[symbol->index];
  if (number == nullptr) {
    context.report(
        Finding(Code::wrong_sort, name.range, "`" + name.text + "` is " + what.a_group)
            .label("which of its " + member + "s?")
            .note(symbol->range, "`" + name.text + "` is declared here")
            .help("write `" + name.text + "[0]` with the number of a " + member + what.also));
    return std::nullopt;
  }
  if (group.count == 0 || is_error(*number)) return std::nullopt;  // reported
  const auto index =
      count(context, *number, "the number of a " + member + " of `" + name.text + "`", 0,
            static_cast<int>(group.count) - 1);
  if (!index) return std::nullopt;
  return group.first + static_cast<std::uint32_t>(*index);
}

std::optional<RobotId> resolve_robot(Context& context, const syntax::Name& name,
                                     const syntax::Expr* number) {
  const auto found =
      resolve_numbered(context, name, number,
                       {Sort::robot, Sort::fleet, context.fleets, "one robot, not a fleet",
                        "a fleet, not one robot", "robot"});
  return found ? std::optional<RobotId>(RobotId{*found}) : std::nullopt;
}

void check_fleets(Context& context, const syntax::Program& program) {
  std::size_t next = 0;
  for_each_item<syntax::FleetItem>(
      program, [&](const syntax::Item&, const syntax::FleetItem& fleet) {
        const auto kind = context.resolve<KindId>(fleet.kind, Sort::robot_kind);
        for (std::size_t i = 0; i < fleet.members.size(); ++i) {
          // A robot of an unknown kind belongs to none.
          const std::size_t end = next + members_of(context, fleet, fleet.members[i].text, next);
          while (next < end) context.spec.robots[next++].kind = kind.value_or(KindId{UINT32_MAX});
        }
        if (kind) check_fleet_size(context, *kind, fleet.kind.range);
      });
}

void check_sites(Context& context, const syntax::Program& program) {
  for_each_item<syntax::SiteItem>(program,
                                  [&](const syntax::Item& item, const syntax::SiteItem& site) {
                                    check_site(context, item, site);
                                  });
}

}  // namespace rtac::sema
