// What the checks of one specification share: the specification that grows, the names, the
// declarations as written, and the way to report.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/diagnostics/engine.h"
#include "compiler/geometry/import/areas.h"
#include "compiler/sema/finding.h"
#include "compiler/sema/names.h"
#include "compiler/sema/spec.h"
#include "compiler/syntax/ast.h"

namespace rtac::sema {

using diag::Code;

// One declaration as written; its place in the list is its id.
template <class T>
struct Declared {
  const T* node;
  SourceRange range;  // of the whole item
};

// What a written type says. Points and vectors are quantities of `dimension`, two or, in space,
// three of them.
enum class TypeKind { boolean, integer, real, enumeration, point, vector, pose, twist, zone, path };
struct ValueType {
  TypeKind kind = TypeKind::real;
  Dimension dimension;
  std::optional<EnumId> enumeration;
  std::optional<std::uint32_t> length;  // of an array; most edges of a zone, way-points of a path
  bool space = false;                   // of points and vectors: three components
  FrameId frame = map_frame;            // of points, vectors, poses, zones and paths
  FrameId of = map_frame;               // of a pose: the frame that it places
};

// A function: its body is put in the place of every call.
enum class FunctionState { fresh, open, good, faulty };
struct Function {
  const syntax::FunItem* node;
  FunctionState state = FunctionState::fresh;
  std::vector<ValueType> parameters;
  ValueType result;
};

// A numbered fleet: its members stand one behind the other in Spec::robots.
struct NumberedFleet {
  std::uint32_t first, count;
};

// A value of an enumeration, by its own name.
struct EnumValue {
  EnumId type;
  std::uint32_t value;
};

// What a kind of robot needs so that a property or a controller can be computed.
enum class Need { position, heading, velocity, battery, hears, plan, energy };

class Context {
 public:
  Context(diag::Engine& engine, const syntax::Program& program);

  // Nothing is said about an item that the parser has mended by a guess, or by reason of one.
  void report(const Finding& finding);

  // Is the place within such an item?
  [[nodiscard]] bool damaged(const SourceRange& place) const;
  // Is there such an item, or has the parser lost one? Then nothing is said about what seems to be
  // missing in the specification as a whole.
  [[nodiscard]] bool broken_tree() const { return broken_tree_; }

  // The index of the declaration of this name; otherwise reports what the name is, if anything.
  // A name that is not declared is reported once, however often it is used.
  std::optional<std::uint32_t> resolve(const syntax::Name& name, Sort sort);
  template <class Id>
  std::optional<Id> resolve(const syntax::Name& name, Sort sort) {
    const auto index = resolve(name, sort);
    return index ? std::optional<Id>(Id{*index}) : std::nullopt;
  }

  // Is this the first use of a name that is not declared? Nothing is said about later ones.
  bool first_unknown(const syntax::Name& name);
  // A name that was declared as two things stands for neither: nothing is said about its uses.
  void withdraw(const std::string& name);
  // Reports that nothing of this sort has the name.
  void unknown(const syntax::Name& name, Sort sort);

  // Is there still a suggestion for an unknown name? Each looks at all names that are declared; a
  // flood of mistakes, which nobody reads to its end, must not take the square of its length.
  [[nodiscard]] bool may_suggest() { return suggestions_++ < suggestions_max; }
  // The help where there is none.
  static std::string without_suggestion();

  // A property has come to nothing: a mistake must have been reported. Otherwise the checker itself
  // is wrong, and the specification is refused as a whole.
  void must_have_said() { silent_ = silent_ || !engine_.has_errors(); }
  [[nodiscard]] bool silent() const { return silent_; }

  // Reports that `owner` lacks a clause; `example` shows one that would do.
  void missing_clause(const SourceRange& owner_range, const std::string& owner,
                      const std::string& what, const std::string& example);
  // Reports a second clause where one may stand.
  void duplicate_clause(const SourceRange& range, const SourceRange& first,
                        const std::string& what);
  // Reports a word that is none of `allowed`.
  void unknown_word(const syntax::Name& word, const std::string& what,
                    const std::vector<std::string>& allowed);

  // Does the kind declare what is needed? A declaration with mistakes counts: they were reported.
  [[nodiscard]] bool has(KindId kind, Need need) const;
  // Reports, once per kind and need, that the kind lacks it. `user` says who needs it.
  void require(KindId kind, Need need, const SourceRange& range, const std::string& user);
  // Reports, once per site and kind, a robot of the kind for which the site has no place.
  void require_places(SiteId site, KindId kind, const SourceRange& range);

  Spec spec;
  Symbols symbols;
  std::vector<Declared<syntax::ZoneItem>> zones;
  std::vector<Declared<syntax::RobotItem>> kinds;
  std::vector<Declared<syntax::ControllerItem>> controllers;
  std::vector<Declared<syntax::MonitorItem>> monitors;
  std::vector<Declared<syntax::DecisionItem>> decisions;
  std::vector<Declared<syntax::InputItem>> inputs;  // one for each name of an item
  std::vector<Declared<syntax::ParamItem>> params;
  std::vector<Declared<syntax::MonitorItem>> watches;
  std::vector<Function> functions;
  std::vector<EnumValue> enum_values;
  std::vector<NumberedFleet> fleets;
  std::vector<Declared<syntax::AgentItem>> agents;  // one for each agent of an item
  std::vector<NumberedFleet> agent_groups;
  // What a zone moves with, by ZoneId; filled by check_carriers.
  std::map<ZoneId, std::variant<InputId, RobotId>> carriers;
  std::map<InputId, ZoneId> received_zones;                         // filled by check_inputs
  std::map<std::pair<RobotId, std::string>, InputId> robot_inputs;  // what monitors ask of robots
  std::vector<ValueType> input_types;  // by InputId; filled by check_inputs
  std::set<InputId> faulty_inputs, used_inputs;
  std::set<ParamId> faulty_params, used_params;
  std::set<std::string> refused_functions;  // a built-in one has their name
  // A mistake leaves open whether a robot has a height: nothing is said about what does not suit
  // it.
  bool height_unclear = false;
  bool period_written = false;  // it may have a mistake
  const std::vector<syntax::ZoneFile>& zone_files;
  // Each file is read once, however many zones are taken from it.
  std::map<std::string, std::variant<geometry::import::Areas, geometry::import::Failure>>
      read_files;
  bool origin_written = false;      // it may have a mistake
  std::set<KindId> faulty_outputs;  // how the robot follows its commands is open
  std::set<SiteId> faulty_sites;  // a place of theirs has a mistake: which robots lack one is open

 private:
  static constexpr int suggestions_max = 200;

  diag::Engine& engine_;
  int suggestions_ = 0;
  std::set<std::string> lost_names_;  // that may be declared in text that is not in the tree
  bool all_names_lost_ = false;       // that text was not even read
  bool broken_tree_ = false;
  bool silent_ = false;
  std::vector<SourceRange> damaged_items_;
  std::set<std::string> reported_names_;
  std::set<std::pair<KindId, Need>> reported_needs_;
  std::set<std::pair<SiteId, KindId>> reported_sites_;
};

// Number of an id, for tables.
template <class Id>
std::uint32_t index_of(Id id) {
  return static_cast<std::uint32_t>(id);
}

// Nothing is said about an expression that the parser could not read.
inline bool is_error(const syntax::Expr& expr) {
  return std::holds_alternative<syntax::ErrorExpr>(expr.node);
}

}  // namespace rtac::sema
