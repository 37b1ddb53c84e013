#include "compiler/sema/context.h"

#include <algorithm>

#include "compiler/sema/suggest.h"

namespace rtac::sema {

namespace {

Code unknown_code(Sort sort) {
  switch (sort) {
    case Sort::zone:
      return Code::unknown_zone;
    case Sort::robot_kind:
      return Code::unknown_robot_kind;
    case Sort::robot:
    case Sort::fleet:
      return Code::unknown_robot;
    case Sort::site:
      return Code::unknown_site;
    case Sort::controller:
      return Code::unknown_controller;
    case Sort::monitor:
      return Code::unknown_monitor;
    case Sort::watch:
      return Code::unknown_monitor;
    case Sort::enumeration:
      return Code::unknown_type;
    case Sort::function:
      return Code::unknown_function;
    case Sort::frame:
      return Code::unknown_frame;
    case Sort::decision:
    case Sort::input:
    case Sort::parameter:
    case Sort::enum_value:
    case Sort::agent:
    case Sort::agents:
      return Code::unknown_name;
  }
  return Code::unknown_name;
}

struct NeedText {
  const char* what;
  const char* example;
};

NeedText text_of(Need need) {
  switch (need) {
    case Need::position:
      return {"does not sense its position",
              "add `sense position : point error 2 cm max_age 200 ms;`"};
    case Need::heading:
      return {"does not sense its heading",
              "add `sense heading : angle error 2 deg max_age 200 ms;`"};
    case Need::velocity:
      return {"does not sense its velocity",
              "add `sense velocity : vector error 1 cm/s max_age 200 ms;`"};
    case Need::battery:
      return {"does not sense its battery", "add `sense battery : ratio error 0.5 % max_age 5 s;`"};
    case Need::hears:
      return {"does not hear other robots", "add `hears other robots max_age 200 ms;`"};
    case Need::plan:
      return {"has no input `plan`", "add `input plan : path[64] tracking <= 10 cm;`"};
    case Need::energy:
      return {"has no energy clause",
              "add `energy { drive <= 0.4 %/m; idle <= 0.01 %/s; drain <= 0.2 %/s; charge >= 1 "
              "%/s at dock; held <= 60 s; detour <= 3 m; }` with its own numbers"};
  }
  return {"", ""};
}

template <class Clause>
bool any_clause(const syntax::RobotItem& robot) {
  for (const auto& clause : robot.clauses) {
    if (std::holds_alternative<Clause>(clause.node)) return true;
  }
  return false;
}

// A misspelt signal counts, and `pos` or `odom` may be any: they were reported.
bool senses(const syntax::RobotItem& robot, const char* name) {
  for (const auto& clause : robot.clauses) {
    const auto* sense = std::get_if<syntax::SenseClause>(&clause.node);
    if (sense == nullptr) continue;
    const std::string& written = sense->name.text;
    const bool is_signal =
        nearest(written, {"position", "heading", "velocity", "battery"}).has_value();
    if (nearest(written, {name}) || !is_signal) return true;
  }
  return false;
}

}  // namespace

Context::Context(diag::Engine& engine, const syntax::Program& program)
    : zone_files(program.zone_files), engine_(engine), all_names_lost_(program.import_failed) {
  bool lost_items = program.import_failed;
  for (const syntax::File& file : program.files) {
    lost_names_.insert(file.loss.names.begin(), file.loss.names.end());
    all_names_lost_ = all_names_lost_ || file.loss.rest;
    lost_items = lost_items || file.loss.items || file.loss.rest;
    for (const syntax::Item& item : file.items) {
      if (item.damaged) damaged_items_.push_back(item.range);
    }
  }
  broken_tree_ = lost_items || !damaged_items_.empty();
}

bool Context::damaged(const SourceRange& place) const {
  return std::any_of(damaged_items_.begin(), damaged_items_.end(), [&](const SourceRange& item) {
    return item.file == place.file && item.begin <= place.begin && place.begin <= item.end;
  });
}

void Context::report(const Finding& finding) {
  const diag::Diagnostic& found = finding.diagnostic();
  const bool about_height = found.code == Code::spaces_differ || found.code == Code::not_in_space ||
                            found.code == Code::land_without_height;
  if (height_unclear && about_height) return;
  if (found.range && damaged(*found.range)) return;
  for (const diag::Note& note : found.notes) {
    if (note.range && damaged(*note.range)) return;
  }
  engine_.report(found);
}

std::optional<std::uint32_t> Context::resolve(const syntax::Name& name, Sort sort) {
  const Symbol* symbol = symbols.find(name.text);
  if (symbol != nullptr && symbol->sort == sort) return symbol->index;
  height_unclear = height_unclear || sort == Sort::robot_kind;
  // what an input is of an unknown type is open
  if (symbol != nullptr && symbol->sort == Sort::input &&
      faulty_inputs.count(InputId{symbol->index}) > 0) {
    return std::nullopt;
  }
  const bool is_path = symbol != nullptr && symbol->sort == Sort::input &&
                       input_types[symbol->index].kind == TypeKind::path;
  const bool are_agents = symbol != nullptr && symbol->sort == Sort::agents;
  if (are_agents && sort == Sort::robot_kind) {
    report(Finding(Code::wrong_sort, name.range, "`" + name.text + "` are agents, not robots")
               .label("a kind of robot is due")
               .note(symbol->range, "`" + name.text + "` is declared here")
               .help("monitors of robots go through them: `forall p : " + name.text +
                     " : distance(r, p) >= 1 m` behind `monitor m for r : Kind`"));
  } else if (is_path && sort == Sort::zone) {
    report(Finding(Code::wrong_sort, name.range, "`" + name.text + "` is a path, but a zone is due")
               .label("a zone is due")
               .note(symbol->range, "`" + name.text + "` is declared here")
               .help("write `distance(p, " + name.text + ") <= 1 m` for what stays near it, `" +
                     name.text + " inside Z` for where it leads"));
  } else if (symbol != nullptr) {
    report(Finding(Code::wrong_sort, name.range,
                   "`" + name.text + "` is " + a_name_of(symbol->sort) + ", but " +
                       a_name_of(sort) + " is due")
               .label(a_name_of(sort) + " is due")
               .note(symbol->range, "`" + name.text + "` is declared here")
               .help(may_suggest()
                         ? did_you_mean(name.text, symbols.names_of(sort), plural_of(sort))
                         : without_suggestion()));
  } else if (first_unknown(name)) {
    unknown(name, sort);
  }
  return std::nullopt;
}

void Context::unknown(const syntax::Name& name, Sort sort) {
  Finding finding(unknown_code(sort), name.range,
                  std::string("there is no ") + name_of(sort) + " `" + name.text + "`");
  finding.label(std::string("no ") + name_of(sort) + " has this name");
  if (!may_suggest()) {
    report(finding.help(without_suggestion()));
    return;
  }
  const std::vector<std::string> names = symbols.names_of(sort);
  finding.help(did_you_mean(name.text, names, plural_of(sort)));
  if (const auto likely = nearest(name.text, names)) finding.replace(name.range, *likely);
  report(finding);
}

std::string Context::without_suggestion() {
  return "declare it, or mend the first mistakes: only the first " +
         std::to_string(suggestions_max) + " have suggestions";
}

bool Context::first_unknown(const syntax::Name& name) {
  if (all_names_lost_ || name.text.empty() || lost_names_.count(name.text) > 0) return false;
  return !damaged(name.range) && reported_names_.insert(name.text).second;
}

void Context::withdraw(const std::string& name) {
  symbols.remove(name);
  lost_names_.insert(name);
}

void Context::missing_clause(const SourceRange& owner_range, const std::string& owner,
                             const std::string& what, const std::string& example) {
  report(Finding(Code::clause_missing, owner_range, owner + " has no " + what)
             .label("no " + what)
             .help("add `" + example + "`"));
}

void Context::duplicate_clause(const SourceRange& range, const SourceRange& first,
                               const std::string& what) {
  report(Finding(Code::duplicate_clause, range, what + " stands twice")
             .label("the second one")
             .note(first, "the first one is here")
             .help("keep one of them"));
}

void Context::unknown_word(const syntax::Name& word, const std::string& what,
                           const std::vector<std::string>& allowed) {
  if (word.text.empty()) return;
  Finding finding(Code::unknown_word, word.range, "`" + word.text + "` is not " + what);
  finding.label("not " + what);
  if (allowed.size() == 1) {
    finding.help("write `" + allowed.front() + "`").replace(word.range, allowed.front());
  } else if (const auto likely = nearest(word.text, allowed)) {
    finding.help("did you mean `" + *likely + "`?").replace(word.range, *likely);
  } else {
    finding.help("possible are " + listing(allowed));
  }
  report(finding);
}

bool Context::has(KindId kind, Need need) const {
  const syntax::RobotItem& robot = *kinds[index_of(kind)].node;
  switch (need) {
    case Need::position:
      return senses(robot, "position");
    case Need::heading:
      return senses(robot, "heading");
    case Need::velocity:
      return senses(robot, "velocity");
    case Need::battery:
      return senses(robot, "battery");
    case Need::hears:
      return any_clause<syntax::HearsClause>(robot);
    case Need::plan:
      return any_clause<syntax::InputClause>(robot);
    case Need::energy:
      return any_clause<syntax::EnergyClause>(robot);
  }
  return false;
}

void Context::require(KindId kind, Need need, const SourceRange& range, const std::string& user) {
  if (has(kind, need) || damaged(spec[kind].name_range) || damaged(range)) return;
  if (!reported_needs_.insert({kind, need}).second) return;
  const RobotKind& robot = spec[kind];
  const NeedText text = text_of(need);
  report(Finding(Code::sense_missing, range,
                 user + " cannot be computed: `" + robot.name + "` " + text.what)
             .label("needs what `" + robot.name + "` does not have")
             .note(robot.name_range, "`" + robot.name + "` " + text.what)
             .help(text.example));
}

void Context::require_places(SiteId site, KindId kind, const SourceRange& range) {
  const Site& family = spec[site];
  if (broken_tree_ || faulty_sites.count(site) > 0) return;
  for (const Site::Place& place : family.places) {
    if (!place.robot) return;
  }
  for (std::uint32_t i = 0; i < spec.robots.size(); ++i) {
    const Robot& robot = spec.robots[i];
    if (robot.kind != kind) continue;
    bool found = false;
    for (const Site::Place& place : family.places) found = found || place.robot == RobotId{i};
    if (found || !reported_sites_.insert({site, kind}).second) continue;
    report(
        Finding(Code::site_incomplete, range,
                "`" + family.name + "` has no place for `" + robot.name + "`")
            .label("every `" + spec[kind].name + "` needs one")
            .note(robot.name_range, "`" + robot.name + "` belongs to the fleet here")
            .help("add `site " + family.name + "(" + robot.name + ") = (x, y);` with its place"));
  }
}

}  // namespace rtac::sema
