#include "compiler/sema/types.h"

#include <algorithm>
#include <iterator>

#include "compiler/sema/frames.h"
#include "compiler/sema/quantity.h"
#include "compiler/sema/robots.h"
#include "compiler/sema/suggest.h"
#include "compiler/sema/units.h"

namespace rtac::sema {

namespace {

struct NamedType {
  const char* name;
  TypeKind kind;
  Dimension dimension;
  bool takes_unit;
  bool space = false;
};
constexpr NamedType named_types[] = {
    {"bool", TypeKind::boolean, dims::number, false},
    {"int", TypeKind::integer, dims::number, false},
    {"real", TypeKind::real, dims::number, true},
    {"point", TypeKind::point, dims::length, false},
    {"vector", TypeKind::vector, dims::number, true},
    {"point3", TypeKind::point, dims::length, false, true},
    {"vector3", TypeKind::vector, dims::number, true, true},
    {"pose", TypeKind::pose, dims::length, false},
    {"twist", TypeKind::twist, dims::speed, false},
    {"zone", TypeKind::zone, dims::number, false},
    {"path", TypeKind::path, dims::length, false},
    {"length", TypeKind::real, dims::length, false},
    {"time", TypeKind::real, dims::time, false},
    {"speed", TypeKind::real, dims::speed, false},
    {"acceleration", TypeKind::real, dims::acceleration, false},
    {"angle", TypeKind::real, dims::angle, false},
    {"ratio", TypeKind::real, dims::ratio, false},
};

// Types of other languages.
struct ForeignType {
  const char *name, *ours;
};
constexpr ForeignType foreign_types[] = {
    {"boolean", "bool"},
    {"Boolean", "bool"},
    {"Bool", "bool"},
    {"integer", "int"},
    {"Integer", "int"},
    {"uint", "int"},
    {"int8", "int"},
    {"int16", "int"},
    {"int32", "int"},
    {"int64", "int"},
    {"uint8", "int"},
    {"uint16", "int"},
    {"uint32", "int"},
    {"uint64", "int"},
    {"nat", "int"},
    {"float", "real`, or with a unit `real [m/s]"},
    {"double", "real`, or with a unit `real [m/s]"},
    {"float32", "real`, or with a unit `real [m/s]"},
    {"float64", "real`, or with a unit `real [m/s]"},
    {"number", "real`, or with a unit `real [m/s]"},
    {"string", "enum Gear { park, drive }"},
    {"String", "enum Gear { park, drive }"},
    {"velocity", "speed`, or of a vector `vector [m/s]"},
    {"duration", "time"},
    {"distance", "length"},
    {"percent", "ratio"},
    {"point2", "point"},
    {"vector2", "vector"},
    {"pose2", "pose of base"},
};

// What has turns about three axes: the integer kernel has none.
bool turns_in_space(const std::string& name) {
  constexpr const char* names[] = {"pose3",    "twist3",     "quaternion",
                                   "rotation", "transform3", "orientation"};
  return std::any_of(std::begin(names), std::end(names),
                     [&](const char* each) { return name == each; });
}

std::vector<std::string> known_types(const Context& context) {
  std::vector<std::string> names;
  for (const NamedType& type : named_types) names.push_back(type.name);
  for (const std::string& name : context.symbols.names_of(Sort::enumeration)) {
    names.push_back(name);
  }
  return names;
}

void report_unknown_type(Context& context, const syntax::Name& name) {
  const auto names = known_types(context);
  if (!context.first_unknown(name)) return;
  Finding finding(Code::unknown_type, name.range, "there is no type `" + name.text + "`");
  finding.label("not a type").help(did_you_mean(name.text, names, "types"));
  const auto foreign =
      std::find_if(std::begin(foreign_types), std::end(foreign_types),
                   [&](const ForeignType& each) { return name.text == each.name; });
  if (turns_in_space(name.text)) {
    finding.help(
        "turns in space are not computed here: compute the `point3` or `vector3` outside, and pass "
        "it as `input ... error e`");
  } else if (foreign != std::end(foreign_types)) {
    finding.help(std::string("write `") + foreign->ours + "`");
  } else if (const auto likely = nearest(name.text, names)) {
    finding.replace(name.range, *likely);
  }
  context.report(finding);
}

std::optional<ValueType> element_type(Context& context, const syntax::Name& name,
                                      bool& takes_unit) {
  for (const NamedType& type : named_types) {
    if (name.text != type.name) continue;
    takes_unit = type.takes_unit;
    ValueType result;
    result.kind = type.kind;
    result.dimension = type.dimension;
    result.space = type.space;
    return result;
  }
  const Symbol* symbol = context.symbols.find(name.text);
  if (symbol == nullptr) {
    report_unknown_type(context, name);
    return std::nullopt;
  }
  const auto id = context.resolve<EnumId>(name, Sort::enumeration);
  if (!id) return std::nullopt;
  return ValueType{TypeKind::enumeration, dims::number, *id, std::nullopt};
}

void report_unit_without_effect(Context& context, const syntax::TypeRef& written,
                                const SourceRange& range, const std::string& unit) {
  context.report(Finding(Code::clause_without_effect, range,
                         "the type `" + written.name.text + "` has no unit of its own")
                     .label("has no effect")
                     .help("leave it out, or write `real [" + unit + "]`"));
}

bool apply_unit(Context& context, const syntax::TypeRef& written, bool takes_unit,
                ValueType& type) {
  if (!written.unit) return true;
  const syntax::Unit& unit = *written.unit;
  if (!takes_unit) {
    report_unit_without_effect(context, written, unit.range, unit.text);
    return false;
  }
  const auto meaning = parse_unit(unit.text);
  if (meaning) {
    type.dimension = meaning->dimension;
    return true;
  }
  Finding finding(Code::unknown_unit, unit.range, "the unit `" + unit.text + "` is not known");
  finding.label("not a unit");
  if (is_celsius(unit.text)) {
    finding.help("write `K`: temperatures are 273.15 more than in degrees Celsius");
  } else if (const auto likely = suggest_unit(unit.text, std::nullopt)) {
    finding.help("did you mean `" + *likely + "`?").replace(unit.range, *likely);
  } else {
    finding.help("units are products of m, s, rad, %, kg, A, K and the like: `m/s^2`, `%/m`");
  }
  context.report(finding);
  return false;
}

// `@ gps` of what has coordinates, `of base` of a pose.
bool apply_frames(Context& context, const syntax::TypeRef& written, ValueType& type) {
  const bool is_pose = type.kind == TypeKind::pose;
  const bool has_frame = is_pose || type.kind == TypeKind::point || type.kind == TypeKind::vector ||
                         type.kind == TypeKind::zone || type.kind == TypeKind::path;
  const auto without_effect = [&](const syntax::Name& name, const std::string& what) {
    context.report(Finding(Code::clause_without_effect, name.range,
                           "the type `" + written.name.text + "` has no " + what)
                       .label("has no effect")
                       .help("leave it out"));
    return false;
  };
  if (written.frame && !has_frame) return without_effect(*written.frame, "coordinates in a frame");
  if (written.of && !is_pose) return without_effect(*written.of, "frame that it places");
  if (is_pose && !written.of) {
    context.missing_clause(written.range, "the pose", "frame that it places", "pose of base");
    return false;
  }
  const auto frame = frame_of(context, written.frame);
  const auto of = frame_of(context, written.of);
  if (!frame || !of) return false;
  if (is_pose && *frame == *of) {
    context.report(Finding(Code::clause_without_effect, written.of->range,
                           "this pose places `" + written.of->text + "` in itself")
                       .label("the frame that it is in")
                       .help("name two frames: `pose of base @ map`"));
    return false;
  }
  type.frame = *frame;
  type.of = *of;
  return true;
}

// `path[m]`, `zone[m]`: both are in metres, and the brackets say how large they may be.
void report_unit_for_size(Context& context, const SourceRange& range, bool is_path) {
  const std::string what = is_path ? "path" : "zone";
  const std::string parts = is_path ? "way-points" : "edges";
  context.report(
      Finding(Code::clause_without_effect, range, "a " + what + " has no unit of its own")
          .label("the number of its most " + parts + " is due")
          .help("it arrives in metres; write how many " + parts + " it may have, `" +
                (is_path ? "path[16]" : "zone[64]") + "`"));
}

bool apply_length(Context& context, const syntax::TypeRef& written, ValueType& type) {
  const bool is_zone = type.kind == TypeKind::zone;
  const bool is_path = type.kind == TypeKind::path;
  if (written.length.empty() && is_path) {
    context.missing_clause(written.range, "the path",
                           "most way-points, so that its memory is fixed", "path[16]");
    return false;
  }
  if (written.length.empty() && is_zone) {
    context.missing_clause(written.range, "the zone", "most edges, so that its memory is fixed",
                           "zone[64]");
  }
  if (written.length.empty()) return !is_zone;
  const syntax::Expr& first = *written.length.front();
  if (is_error(first)) return false;
  if (written.length.size() > 1 && (is_path || is_zone)) {
    const std::string what = is_path ? "path" : "zone";
    context.report(Finding(Code::limit_exceeded, written.length[1]->range,
                           "an input is one " + what + ", not several")
                       .label("the second number")
                       .help("its only number is that of its most " +
                             std::string(is_path ? "way-points, `path[16]`" : "edges, `zone[64]`") +
                             "; declare each " + what + " as an input of its own"));
    return false;
  }
  if (written.length.size() > 1) {
    context.report(Finding(Code::limit_exceeded, written.length[1]->range,
                           "arrays of arrays do not exist: an array has 1 dimension")
                       .label("the second one")
                       .help("write one array with all the elements, such as `" +
                             written.name.text + "[12]` for 3 rows of 4, or one input a row"));
    return false;
  }
  // behind other types than quantities a unit in brackets is read as a length: `bool [m]`
  const auto* name = std::get_if<syntax::NameRef>(&first.node);
  if (name != nullptr && parse_unit(name->name.text) && (is_path || is_zone)) {
    report_unit_for_size(context, first.range, is_path);
    return false;
  }
  if (name != nullptr && parse_unit(name->name.text)) {
    report_unit_without_effect(context, written, first.range, name->name.text);
    return false;
  }
  const auto length = is_zone ? count(context, first, "the most edges of a zone", 3, max_zone_edges)
                      : is_path
                          ? count(context, first, "the most way-points of a path", 1, max_path)
                          : count(context, first, "the length of an array", 1, max_array);
  if (length) type.length = static_cast<std::uint32_t>(*length);
  return length.has_value();
}

}  // namespace

std::optional<ValueType> check_type(Context& context, const syntax::TypeRef& written,
                                    MayBeZone may_be_zone) {
  bool takes_unit = false;
  auto type = element_type(context, written.name, takes_unit);
  if (type && type->kind == TypeKind::path && may_be_zone == MayBeZone::no) {
    context.report(Finding(Code::wrong_argument, written.range, "only an input is of type `path`")
                       .label("not an input")
                       .help("declare `input plan : path[16] max_age 1 s;`, and pass the quantity "
                             "that is made of it, such as `distance(plan, p)`"));
    return std::nullopt;
  }
  if (type && type->kind == TypeKind::zone && may_be_zone == MayBeZone::no) {
    context.report(Finding(Code::wrong_argument, written.range, "only an input is of type `zone`")
                       .label("not an input")
                       .help("declare `input fence : zone[64] max_age inf;`, and name it where a "
                             "place is held against it: `p inside fence`"));
    return std::nullopt;
  }
  if (!type || !apply_unit(context, written, takes_unit, *type) ||
      !apply_frames(context, written, *type) || !apply_length(context, written, *type)) {
    return std::nullopt;
  }
  return type;
}

}  // namespace rtac::sema
