#include "compiler/sema/declare.h"

#include <algorithm>

#include "compiler/sema/fleets.h"
#include "compiler/sema/property.h"
#include "compiler/sema/quantity.h"

namespace rtac::sema {

namespace {

// Taken in every sort of declaration.
bool is_built_in(const std::string& name) {
  for (const char* function :
       {"clearance", "distance", "energy_to", "shrink", "grow", "complement"}) {
    if (name == function) return true;
  }
  return false;
}

// Functions of quantities: a signal may have such a name, a function may not.
bool is_built_in_function(const std::string& name) {
  const auto& functions = functions_of_quantities();
  const auto& windowed = aggregate_names();
  return is_built_in(name) ||
         std::find(functions.begin(), functions.end(), name) != functions.end() ||
         std::find(windowed.begin(), windowed.end(), name) != windowed.end();
}

bool is_signal(Sort sort) {
  return sort == Sort::input || sort == Sort::parameter;
}

template <class T>
std::uint32_t next_id(const std::vector<T>& items) {
  return static_cast<std::uint32_t>(items.size());
}

class Declarer {
 public:
  explicit Declarer(Context& context) : context_(context) {}
  void withdraw_unclear() {
    for (const std::string& name : unclear_) context_.withdraw(name);
  }

  void operator()(const SourceRange&, const syntax::ImportItem&) {}

  void operator()(const SourceRange& range, const syntax::ZoneItem& zone) {
    add(zone.name, Sort::zone, next_id(spec().zones));
    spec().zones.push_back({zone.name.text, zone.name.range, nullptr});
    context_.zones.push_back({&zone, range});
  }

  void operator()(const SourceRange& range, const syntax::RobotItem& robot) {
    add(robot.name, Sort::robot_kind, next_id(spec().kinds));
    RobotKind kind{};
    kind.name = robot.name.text;
    kind.name_range = robot.name.range;
    spec().kinds.push_back(std::move(kind));
    context_.kinds.push_back({&robot, range});
  }

  void operator()(const SourceRange&, const syntax::FleetItem& fleet) {
    const auto count = fleet.count ? numbered(*fleet.count) : std::nullopt;
    for (const syntax::Name& member : fleet.members) {
      if (fleet.count) {
        add_numbered(member, count.value_or(0));
        continue;
      }
      add(member, Sort::robot, next_id(spec().robots));
      spec().robots.push_back({member.text, member.range, KindId{UINT32_MAX}});  // not known yet
    }
  }

  void operator()(const SourceRange& range, const syntax::AgentItem& written) {
    std::optional<int> most;
    if (written.count && !is_error(*written.count)) {
      most = rtac::sema::count(context_, *written.count, "the number of agents", 1, max_agents);
    }
    for (const syntax::Name& name : written.names) {
      const std::uint32_t first = next_id(spec().agents);
      const int count = written.count ? most.value_or(0) : 1;
      if (written.count) {
        add(name, Sort::agents, next_id(context_.agent_groups));
        context_.agent_groups.push_back({first, static_cast<std::uint32_t>(count)});
      } else {
        add(name, Sort::agent, first);
      }
      for (int i = 0; i < count; ++i) {
        Agent agent{};
        agent.name = written.count ? name.text + "[" + std::to_string(i) + "]" : name.text;
        agent.name_range = name.range;
        if (written.count) agent.group = name.text;
        spec().agents.push_back(std::move(agent));
        context_.agents.push_back({&written, range});
      }
    }
  }

  // The items of one name make one family of places.
  void operator()(const SourceRange&, const syntax::SiteItem& site) {
    const Symbol* known = context_.symbols.find(site.name.text);
    if (known != nullptr && known->sort == Sort::site) return;
    if (!add(site.name, Sort::site, next_id(spec().sites))) return;
    spec().sites.push_back({site.name.text, {}});
  }

  void operator()(const SourceRange& range, const syntax::ControllerItem& written) {
    add(written.name, Sort::controller, next_id(spec().controllers));
    spec().controllers.push_back({written.name.text, written.name.range,
                                  written.role == syntax::Role::advanced, KindId{},
                                  ExternController{}});
    context_.controllers.push_back({&written, range});
  }

  void operator()(const SourceRange& range, const syntax::MonitorItem& written) {
    if (is_watch(written)) {
      add(written.name, Sort::watch, next_id(spec().watches));
      Watch watch{};
      watch.name = written.name.text;
      watch.name_range = written.name.range;
      watch.range = range;
      spec().watches.push_back(std::move(watch));
      context_.watches.push_back({&written, range});
      return;
    }
    add(written.name, Sort::monitor, next_id(spec().monitors));
    Monitor monitor{};
    monitor.name = written.name.text;
    monitor.name_range = written.name.range;
    monitor.range = range;
    spec().monitors.push_back(std::move(monitor));
    context_.monitors.push_back({&written, range});
  }

  void operator()(const SourceRange& range, const syntax::DecisionItem& written) {
    add(written.name, Sort::decision, next_id(spec().decisions));
    Decision decision{};
    decision.name = written.name.text;
    decision.name_range = written.name.range;
    spec().decisions.push_back(std::move(decision));
    context_.decisions.push_back({&written, range});
  }

  void operator()(const SourceRange&, const syntax::PeriodItem&) {}
  void operator()(const SourceRange&, const syntax::ClockItem&) {}
  void operator()(const SourceRange&, const syntax::ScaleItem&) {}
  void operator()(const SourceRange&, const syntax::GridItem&) {}
  void operator()(const SourceRange&, const syntax::AssumeItem&) {}
  void operator()(const SourceRange&, const syntax::OriginItem&) {}

  void operator()(const SourceRange&, const syntax::FrameItem& written) {
    for (const syntax::Name& name : written.names) {
      if (name.text == spec()[map_frame].name) {
        context_.report(Finding(Code::duplicate_name, name.range, "the frame `map` always exists")
                            .label("declared again")
                            .help("leave it out: it is the frame of what names none"));
        continue;
      }
      if (!add(name, Sort::frame, next_id(spec().frames))) continue;
      spec().frames.push_back({name.text, name.range});
    }
  }

  void operator()(const SourceRange& range, const syntax::InputItem& written) {
    for (const syntax::Name& name : written.names) {
      add(name, Sort::input, next_id(spec().inputs));
      Input input{};
      input.name = name.text;
      input.name_range = name.range;
      spec().inputs.push_back(std::move(input));
      context_.inputs.push_back({&written, range});
    }
  }

  void operator()(const SourceRange& range, const syntax::ParamItem& written) {
    add(written.name, Sort::parameter, next_id(spec().params));
    Param param{};
    param.name = written.name.text;
    param.name_range = written.name.range;
    spec().params.push_back(std::move(param));
    context_.params.push_back({&written, range});
  }

  // The values share the space of names: a name means one thing in the whole specification.
  void operator()(const SourceRange&, const syntax::EnumItem& written) {
    const EnumId id{next_id(spec().enumerations)};
    add(written.name, Sort::enumeration, index_of(id));
    Enumeration enumeration{written.name.text, written.name.range, {}};
    for (const syntax::Name& value : written.values) {
      // one whose name is taken stays a value of its enumeration, so that nothing else is said of
      // it
      const bool is_new = add(value, Sort::enum_value, next_id(context_.enum_values));
      const auto number = static_cast<std::uint32_t>(enumeration.values.size());
      if (is_new) context_.enum_values.push_back({id, number});
      enumeration.values.push_back(value.text);
    }
    spec().enumerations.push_back(std::move(enumeration));
  }

  void operator()(const SourceRange&, const syntax::FunItem& written) {
    add(written.name, Sort::function, next_id(context_.functions));
    context_.functions.push_back({&written, FunctionState::fresh, {}, {}});
  }

 private:
  // Clauses that only a robot can have say that the robot was forgotten.
  static bool is_watch(const syntax::MonitorItem& written) {
    return !written.variable && !written.kind && written.ahead.empty() && written.recover.empty() &&
           written.return_when.empty() && written.hold.empty();
  }

  Spec& spec() { return context_.spec; }

  // The size of a numbered fleet; its members are declared here, so that names find them.
  std::optional<int> numbered(const syntax::Expr& written) {
    if (is_error(written)) return std::nullopt;
    return rtac::sema::count(context_, written, "the size of a fleet", 1, max_fleet);
  }
  void add_numbered(const syntax::Name& fleet, int count) {
    add(fleet, Sort::fleet, next_id(context_.fleets));
    context_.fleets.push_back({next_id(spec().robots), static_cast<std::uint32_t>(count)});
    for (int i = 0; i < count; ++i) {
      spec().robots.push_back({fleet.text + "[" + std::to_string(i) + "]", fleet.range,
                               KindId{UINT32_MAX}, static_cast<std::uint32_t>(i), fleet.text});
    }
  }

  bool add(const syntax::Name& name, Sort sort, std::uint32_t index) {
    if (sort == Sort::function ? is_built_in_function(name.text)
                               : is_built_in(name.text) && !is_signal(sort)) {
      context_.report(Finding(Code::duplicate_name, name.range,
                              "`" + name.text + "` is the name of a built-in function")
                          .label("taken")
                          .help("choose another name"));
      if (sort == Sort::function) context_.refused_functions.insert(name.text);
      return false;
    }
    const Symbol* first = context_.symbols.add(name.text, {sort, index, name.range});
    if (first == nullptr) return true;
    context_.report(
        Finding(Code::duplicate_name, name.range, "the name `" + name.text + "` is declared twice")
            .label("declared again as " + a_name_of(sort))
            .note(first->range, std::string("the ") + name_of(first->sort) + " is declared here")
            .help("give one of them another name"));
    if (sort != first->sort || has_type(sort)) unclear_.push_back(name.text);
    return false;
  }

  // Two of a sort may differ in what may be done with them.
  static bool has_type(Sort sort) {
    return sort == Sort::input || sort == Sort::parameter || sort == Sort::function;
  }

  Context& context_;
  std::vector<std::string> unclear_;  // declared twice, and not as the same
};

}  // namespace

void declare_all(Context& context, const syntax::Program& program) {
  Declarer declare(context);
  for (const syntax::File& file : program.files) {
    for (const syntax::Item& item : file.items) {
      std::visit([&](const auto& node) { declare(item.range, node); }, item.node);
    }
  }
  declare.withdraw_unclear();
}

}  // namespace rtac::sema
