#include "compiler/sema/declare.h"

namespace rtac::sema {

namespace {

bool is_built_in(const std::string& name) {
  for (const char* function : {"clearance", "distance", "energy_to", "shrink", "grow"}) {
    if (name == function) return true;
  }
  return false;
}

template <class T>
std::uint32_t next_id(const std::vector<T>& items) {
  return static_cast<std::uint32_t>(items.size());
}

class Declarer {
 public:
  explicit Declarer(Context& context) : context_(context) {}

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
    for (const syntax::Name& member : fleet.members) {
      add(member, Sort::robot, next_id(spec().robots));
      spec().robots.push_back({member.text, member.range, KindId{UINT32_MAX}});  // not known yet
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

 private:
  Spec& spec() { return context_.spec; }

  bool add(const syntax::Name& name, Sort sort, std::uint32_t index) {
    if (is_built_in(name.text)) {
      context_.report(Finding(Code::duplicate_name, name.range,
                              "`" + name.text + "` is the name of a built-in function")
                          .label("taken")
                          .help("choose another name"));
      return false;
    }
    const Symbol* first = context_.symbols.add(name.text, {sort, index, name.range});
    if (first == nullptr) return true;
    context_.report(
        Finding(Code::duplicate_name, name.range, "the name `" + name.text + "` is declared twice")
            .label(std::string("declared again as a ") + name_of(sort))
            .note(first->range, std::string("the ") + name_of(first->sort) + " is declared here")
            .help("give one of them another name"));
    return false;
  }

  Context& context_;
};

}  // namespace

void declare_all(Context& context, const syntax::Program& program) {
  Declarer declare(context);
  for (const syntax::File& file : program.files) {
    for (const syntax::Item& item : file.items) {
      std::visit([&](const auto& node) { declare(item.range, node); }, item.node);
    }
  }
}

}  // namespace rtac::sema
