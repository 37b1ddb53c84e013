#include "compiler/sema/imports.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "compiler/sema/dimension.h"
#include "compiler/sema/frames.h"
#include "compiler/sema/import_areas.h"
#include "compiler/sema/import_schedule.h"
#include "compiler/sema/origin.h"
#include "compiler/sema/quantity.h"
#include "compiler/sema/suggest.h"
#include "compiler/syntax/spelling.h"

namespace rtac::sema {

using geometry::import::AltitudeReference;
using geometry::import::Area;
using geometry::import::Areas;
using geometry::import::Axes;
using geometry::import::Failure;
using geometry::import::Format;
using geometry::import::Part;
using geometry::import::Role;
using geometry::import::Unit;
using syntax::ImportOption;
using syntax::ImportWord;

namespace {

bool has_band(const Part& part) {
  return part.band.floor || part.band.ceiling;
}

class Importer {
 public:
  Importer(Context& context, const syntax::ImportLit& written, FrameId frame)
      : context_(context), written_(written), frame_(frame) {}

  std::optional<ZoneImport> run() {
    if (!take_options() || !read() || !select() || !settle_reading() || !settle_roles() ||
        !settle_limits()) {
      return std::nullopt;
    }
    return place_areas(context_, job_);
  }

 private:
  // ---- what the author says

  bool take_options() {
    for (const ImportOption& option : written_.options) {
      if (option.word == ImportWord::heights) {
        if (!take_level(option)) return false;
        continue;
      }
      const ImportOption*& first = options_[static_cast<std::size_t>(option.word)];
      if (first != nullptr) {
        context_.duplicate_clause(option.range, first->range,
                                  "`" + std::string(syntax::spell(option.word)) + "`");
        return false;
      }
      first = &option;
    }
    return reason_given(ImportWord::flat) && reason_given(ImportWord::timeless);
  }
  [[nodiscard]] const ImportOption* option(ImportWord word) const {
    return options_[static_cast<std::size_t>(word)];
  }
  bool reason_given(ImportWord word) {
    const ImportOption* const given = option(word);
    if (given == nullptr || given->text->text.find_first_not_of(" \t") != std::string::npos) {
      return true;
    }
    context_.missing_clause(
        given->range, "`" + std::string(syntax::spell(word)) + "`", "reason",
        std::string(syntax::spell(word)) +
            (word == ImportWord::flat ? " \"one level\"" : " \"at all times\""));
    return false;
  }
  // `heights amsl at -432 m`: where what heights count from lies.
  bool take_level(const ImportOption& given) {
    if (!known(given.names[0], "a reference of heights", {"agl", "amsl", "wgs84"})) return false;
    const auto reference = reference_of(given.names[0].text);
    const auto level = quantity(context_, *given.level, {dims::length, "a level of reference"});
    if (!level) return false;
    const auto [first, is_new] = levels_.emplace(reference, &given);
    if (!is_new) {
      context_.duplicate_clause(given.range, first->second->range,
                                "`heights " + given.names[0].text + "`");
      return false;
    }
    job_.with_heights = true;
    job_.levels.emplace(reference, level->value);
    return true;
  }
  static AltitudeReference reference_of(const std::string& name) {
    if (name == "agl") return AltitudeReference::ground;
    return name == "amsl" ? AltitudeReference::mean_sea_level : AltitudeReference::ellipsoid;
  }
  static std::string name_of(AltitudeReference reference) {
    switch (reference) {
      case AltitudeReference::ground:
        return "agl";
      case AltitudeReference::mean_sea_level:
        return "amsl";
      case AltitudeReference::ellipsoid:
        return "wgs84";
      case AltitudeReference::unstated:
        break;
    }
    return "";
  }
  // The word of an option is one of those allowed.
  bool known(const syntax::Name& word, const std::string& what,
             const std::vector<std::string>& allowed) {
    if (std::find(allowed.begin(), allowed.end(), word.text) != allowed.end()) return true;
    context_.unknown_word(word, what, allowed);
    return false;
  }

  bool ambiguous(const SourceRange& range, std::string message, std::string label,
                 std::string help) {
    context_.report(Finding(Code::import_ambiguous, range, std::move(message))
                        .label(std::move(label))
                        .help(std::move(help)));
    return false;
  }
  bool without_effect(const ImportOption& given, std::string message, std::string help) {
    context_.report(Finding(Code::clause_without_effect, given.range, std::move(message))
                        .label("has no effect")
                        .help(std::move(help)));
    return false;
  }

  // ---- what the file says

  bool read() {
    const auto& files = context_.zone_files;
    const auto file = std::find_if(files.begin(), files.end(), [&](const syntax::ZoneFile& each) {
      return each.importer == written_.path.range.file && each.written == written_.path.text;
    });
    if (file == files.end()) {  // the parser has said why, where it reads files
      context_.report(Finding(Code::import_not_found, written_.path.range,
                              "the file `" + written_.path.text + "` was not read")
                          .label("not read")
                          .help("the path is relative to the directory of the importing file"));
      return false;
    }
    job_.path = file->path;
    const auto format = geometry::import::format_of(file->path, *file->text);
    if (!format) {
      if (const auto why = geometry::import::no_text(*file->text, {})) return unusable(*why);
      return unusable({"", "the format is none of those that are known",
                       "GeoJSON, WKT, KML, QGroundControl plans and way-points, ED-269 and ED-318 "
                       "are"});
    }
    job_.format = *format;
    auto& known = context_.read_files;
    auto at = known.find(file->path);
    const bool is_new = at == known.end();
    if (is_new) {
      at = known.emplace(file->path, geometry::import::read(*format, *file->text, {})).first;
    }
    if (const auto* failure = std::get_if<Failure>(&at->second)) {
      return is_new && unusable(*failure);  // of one file once
    }
    areas_ = &std::get<Areas>(at->second);
    for (const auto& note : areas_->notes) {
      job_.remarks.push_back(note.where + ": " + note.message);
    }
    return true;
  }
  bool unusable(const Failure& failure) {
    const std::string place = failure.where.empty() ? "" : ", " + failure.where;
    context_.report(Finding(Code::zone_file_unusable, written_.path.range,
                            "`" + job_.path + "`" + place + ": " + failure.message)
                        .label("cannot be used")
                        .help(failure.help + guessed_format()));
    return false;
  }
  // The words of a file tell of these formats, and may have been meant otherwise.
  [[nodiscard]] std::string guessed_format() const {
    const bool is_ed318 = job_.format == Format::ed318;
    if (!is_ed318 && job_.format != Format::ed269) return "";
    return std::string("; the file is read as ") + (is_ed318 ? "ED-318" : "ED-269") +
           ", whose members it has";
  }

  // ---- which of its areas are meant

  static bool goes_by(const Area& area, const std::string& name) {
    return area.name == name || std::find(area.other_names.begin(), area.other_names.end(), name) !=
                                    area.other_names.end();
  }

  bool select() {
    const ImportOption* const feature = option(ImportWord::feature);
    // Areas without a name go by none.
    if (feature != nullptr && feature->text->text.empty()) return unknown_feature(*feature);
    for (const Area& area : areas_->areas) {
      if (feature == nullptr || goes_by(area, feature->text->text)) selected_.push_back(&area);
    }
    if (selected_.empty() && feature != nullptr) return unknown_feature(*feature);
    for (const Area* area : selected_) {
      if (area->refusal) return unusable(*area->refusal);
    }
    return true;
  }
  bool unknown_feature(const ImportOption& feature) {
    std::vector<std::string> names;
    for (const Area& area : areas_->areas) {
      if (!area.name.empty()) names.push_back(area.name);
      names.insert(names.end(), area.other_names.begin(), area.other_names.end());
    }
    const std::string& name = feature.text->text;
    context_.report(
        Finding(Code::unknown_feature, feature.text->range,
                "`" + job_.path + "` has no feature `" + name + "`")
            .label("not in the file")
            .help(names.empty() ? "its features have no names: leave `feature` out to take them all"
                                : did_you_mean(name, names, "features of the file")));
    return false;
  }

  // ---- how its numbers are meant

  bool settle_reading() {
    const ImportOption* const unit = option(ImportWord::unit);
    if (unit != nullptr && !known(unit->names[0], "a unit of a file", {"m", "deg"})) return false;
    Unit meant = areas_->unit;
    if (unit != nullptr) {
      const Unit said = unit->names[0].text == "m" ? Unit::metres : Unit::degrees;
      if (meant != Unit::unstated && meant != said) {
        return without_effect(*unit,
                              "`" + job_.path + "` is in " +
                                  (meant == Unit::degrees ? "degrees" : "metres") +
                                  ", as its format has it",
                              "leave it out");
      }
      meant = said;
    }
    if (meant == Unit::unstated) {
      return ambiguous(
          written_.path.range,
          "`" + job_.path + "` does not say whether its numbers are metres or degrees",
          "in which unit?",
          "write `import \"...\" in m` for metres to the east and to the north, or `in "
          "deg axes longitude latitude` with the axes in their order");
    }
    job_.reading.degrees = meant == Unit::degrees;
    job_.reading.straight_in_degrees = job_.format == Format::geojson ||
                                       job_.format == Format::ed318 || job_.format == Format::wkt;
    return settle_axes() && settle_origin();
  }

  bool settle_axes() {
    const ImportOption* const axes = option(ImportWord::axes);
    Axes meant = areas_->axes;
    if (axes != nullptr) {
      const std::vector<std::string> allowed = {"latitude", "longitude"};
      if (!known(axes->names[0], "an axis", allowed) ||
          !known(axes->names[1], "an axis", allowed)) {
        return false;
      }
      if (axes->names[0].text == axes->names[1].text) {
        return ambiguous(axes->range, "both axes are the " + axes->names[0].text, "twice the same",
                         "write `axes longitude latitude` or `axes latitude longitude`");
      }
      if (!job_.reading.degrees) {
        return without_effect(*axes, "axes of a file in metres are always east and north",
                              "leave it out");
      }
      meant = axes->names[0].text == "latitude" ? Axes::latitude_first : Axes::longitude_first;
    }
    if (job_.reading.degrees && meant == Axes::unstated) {
      return ambiguous(written_.path.range,
                       "`" + job_.path + "` does not say which of its axes is the latitude",
                       "in which order?",
                       "write `axes longitude latitude` or `axes latitude longitude` behind it");
    }
    job_.axes_written = axes != nullptr;
    job_.latitude_first = meant == Axes::latitude_first;
    // Readers put the longitude first where the format states an order: what is said against it
    // turns that, and so does the latitude first where it states none.
    const Axes as_read = areas_->axes == Axes::unstated ? Axes::longitude_first : areas_->axes;
    job_.reading.latitude_first = meant != as_read;
    if (areas_->only_turned && !job_.reading.latitude_first) return off_globe();
    return true;
  }
  // The order of the format, or the one that is written, has positions off the globe.
  bool off_globe() {
    Failure failure = *areas_->only_turned;
    failure.help += ", or `" + axes_text(!job_.latitude_first) + "` behind it";
    return unusable(failure);
  }

  bool settle_origin() {
    if (!job_.reading.degrees) return true;
    if (frame_ != map_frame) {
      report_frames(context_, written_.path.range, "a file in degrees", map_frame, frame_);
      return false;
    }
    if (context_.spec.origin) {
      job_.origin = in_degrees(*context_.spec.origin);
      return true;
    }
    // what was lost by another mistake may be the origin
    if (context_.origin_written || context_.broken_tree()) return false;
    context_.report(Finding(Code::origin_missing, written_.path.range,
                            "`" + job_.path + "` is in degrees, and the map has no origin")
                        .label("where on the map is this?")
                        .help("declare the latitude and longitude of (0 m, 0 m): `origin 47.3977 "
                              "deg, 8.5456 deg;`"));
    return false;
  }

  // ---- where to be and where not

  bool settle_roles() {
    std::vector<const Area*> open, inclusions;
    for (const Area* area : selected_) {
      (area->role == Role::keep_out  ? job_.exclusions
       : area->role == Role::keep_in ? inclusions
                                     : open)
          .push_back(area);
    }
    if (const ImportOption* const only = option(ImportWord::exclusions)) {
      const ImportOption* const how = option(ImportWord::inclusions);
      if (how == nullptr) return settle_exclusions(*only, open);
      return without_effect(*how, "`exclusions` takes the areas to keep out of alone",
                            "leave out `inclusions`, or `exclusions`");
    }
    if (!job_.exclusions.empty() && inclusions.empty()) {
      return ambiguous(written_.path.range,
                       "`" + job_.path + "` says where not to be, and not where to be",
                       "which zone is this?",
                       "write `import \"...\" exclusions` for the zone of these areas: `arena - "
                       "import \"...\" exclusions`");
    }
    if (!open.empty() && !inclusions.empty()) {
      return ambiguous(written_.path.range,
                       "`" + job_.path + "`, " + open[0]->where +
                           " is neither an area to stay in nor one to keep out of",
                       "others of the file are", "select areas by `feature \"name\"`");
    }
    for (const Area* area : open) job_.inclusions.push_back({area});
    return settle_groups(inclusions);
  }

  // `import "x" exclusions`: the areas to keep out of are the zone, with those that depend on a
  // permission, which nobody has at compile time.
  bool settle_exclusions(const ImportOption& only, const std::vector<const Area*>& open) {
    std::vector<const Area*> restricted = std::move(job_.exclusions);
    job_.exclusions.clear();
    for (const Area* area : open) {
      if (area->restriction.empty()) continue;
      restricted.push_back(area);
      const std::string name = area->name.empty() ? area->where : area->name;
      job_.remarks.push_back(name + ", " + area->restriction + ", counts as an exclusion");
    }
    if (restricted.empty()) {
      return without_effect(
          only, "`" + job_.path + "` has no exclusions",
          open.empty() ? "leave it out" : "leave it out: the zone is all of its areas");
    }
    for (const Area* area : restricted) job_.inclusions.push_back({area});
    return true;
  }

  // Areas of one group all hold; of the groups any.
  bool settle_groups(const std::vector<const Area*>& inclusions) {
    const ImportOption* const how = option(ImportWord::inclusions);
    if (how != nullptr && !known(how->names[0], "a combination of areas", {"all", "any"}))
      return false;
    const auto grouped = [](const Area* area) { return area->group.has_value(); };
    const bool says_it = std::all_of(inclusions.begin(), inclusions.end(), grouped);
    if (how != nullptr && says_it) {
      return without_effect(*how,
                            inclusions.empty() ? "`" + job_.path + "` has no inclusions"
                                               : "the groups of `" + job_.path + "` say it",
                            "leave it out");
    }
    if (how == nullptr && !says_it && inclusions.size() > 1) {
      return ambiguous(written_.path.range,
                       "`" + job_.path + "` has " + std::to_string(inclusions.size()) +
                           " inclusions, and autopilots differ in what that means",
                       "inside all of them, or any?",
                       "write `inclusions all` or `inclusions any` behind it");
    }
    std::map<int, std::vector<const Area*>> groups;
    int next = -1;
    const bool all = how != nullptr && how->names[0].text == "all";
    for (const Area* area : inclusions) {
      groups[says_it ? *area->group : (all ? 0 : next--)].push_back(area);
    }
    for (auto& [number, group] : groups) job_.inclusions.push_back(std::move(group));
    return true;
  }

  // ---- what a zone cannot have: heights and times

  bool settle_limits() {
    const Area *band = nullptr, *schedule = nullptr, *time = nullptr;
    for (const Area* area : selected_) {
      if (area->unread_height && option(ImportWord::flat) == nullptr) {
        return unread(*area->unread_height, ImportWord::flat);
      }
      if (area->unread_time && option(ImportWord::timeless) == nullptr) {
        return unread(*area->unread_time, ImportWord::timeless);
      }
      if (area->unread_height || std::ranges::any_of(area->parts, has_band)) band = area;
      if (!area->schedule.empty()) schedule = area;
      if (area->unread_time || !area->schedule.empty()) time = area;
    }
    return (job_.with_heights
                ? settle_heights()
                : settle_limit(ImportWord::flat, band, "applies between certain heights only",
                               "for all heights")) &&
           (option(ImportWord::scheduled) != nullptr
                ? settle_schedule(*option(ImportWord::scheduled), schedule)
                : settle_limit(ImportWord::timeless, time, "applies at certain times only",
                               "for all times"));
  }
  // A file that is written for another program: what its limits mean nobody can tell.
  bool unread(const geometry::import::Note& property, ImportWord word) {
    const std::string all = word == ImportWord::flat ? "all heights" : "all times";
    const std::string that_count = word == ImportWord::flat
                                       ? "heights that count are those of ED-269, ED-318 and "
                                         "extruded KML"
                                       : "times that count are those of ED-269 and ED-318";
    const bool instead = word == ImportWord::timeless && option(ImportWord::scheduled) != nullptr;
    return ambiguous(
        written_.path.range,
        "`" + job_.path + "`, " + property.where + " " + property.message + ", which " +
            (job_.format == Format::kml ? "KML" : "plain GeoJSON") + " does not have",
        "does it hold for " + all + "?",
        "write `" + std::string(syntax::spell(word)) + " \"why\"` " +
            (instead ? "in the place of `scheduled`" : "behind it") + " to take the area for " +
            all + ": safe of one to keep out of, and a promise of one to stay in; " + that_count);
  }
  // All selected areas apply at the same times, which are those of the zone.
  bool settle_schedule(const ImportOption& given, const Area* limited) {
    if (limited == nullptr) {
      return without_effect(given, "no schedule of `" + job_.path + "` limits when it applies",
                            "leave it out: the zone is always there");
    }
    if (const ImportOption* const timeless = option(ImportWord::timeless)) {
      return without_effect(*timeless, "`scheduled` takes the schedule as the file has it",
                            "leave out `timeless`, or `scheduled`");
    }
    for (const Area* area : selected_) {
      auto windows = openings_of(area->schedule);
      if (const auto* failure = std::get_if<Failure>(&windows)) return unusable(*failure);
      auto& openings = std::get<std::vector<Opening>>(windows);
      if (area == selected_.front())
        job_.openings = std::move(openings);
      else if (openings != job_.openings)
        return times_differ(*selected_.front(), *area);
    }
    job_.remarks.push_back("scheduled: there " + summary_of(job_.openings));
    return true;
  }
  bool times_differ(const Area& first, const Area& other) {
    return ambiguous(
        written_.path.range,
        "`" + job_.path + "`, " + first.where + " and " + other.where + " apply at different times",
        "at which times is the zone there?",
        "declare a zone of each by `feature \"name\"`, and say of places what holds of "
        "all of them: `not p inside a and not p inside b`");
  }
  // Every reference of the selected areas has its level, and no level is without one.
  bool settle_heights() {
    if (const ImportOption* const flat = option(ImportWord::flat)) {
      return without_effect(*flat, "`heights` says where the limits of height are",
                            "leave out `flat`, or `heights`");
    }
    std::set<AltitudeReference> used;
    for (const Area* area : selected_) {
      for (const Part& part : area->parts) {
        for (const auto& limit : {part.band.floor, part.band.ceiling}) {
          if (!limit) continue;
          used.insert(limit->reference);
          if (job_.levels.count(limit->reference) == 0) return no_level(*area, limit->reference);
        }
      }
    }
    for (const auto& [reference, given] : levels_) {
      if (used.count(reference) > 0) continue;
      return without_effect(
          *given,
          "no area of `" + job_.path + "` has limits of height from " + given->names[0].text,
          "leave it out");
    }
    for (const auto& [reference, level] : job_.levels) {
      job_.remarks.push_back("heights " + name_of(reference) +
                             " count from z = " + show(level, dims::length));
    }
    return true;
  }
  bool no_level(const Area& area, AltitudeReference reference) {
    const std::string name = name_of(reference);
    return ambiguous(written_.path.range,
                     "`" + job_.path + "`, " + area.where + " has limits of height from " + name +
                         ", and nothing says where that is",
                     "from which height of the map?",
                     "write `heights " + name +
                         " at 0 m` with the z coordinate of the map from "
                         "which they count");
  }
  bool settle_limit(ImportWord word, const Area* limited, const std::string& what,
                    const std::string& instead) {
    const ImportOption* const given = option(word);
    const std::string name(syntax::spell(word));
    if (limited == nullptr && given != nullptr) {
      return without_effect(
          *given,
          "no area of `" + job_.path + "` " +
              (word == ImportWord::flat ? "has limits of height" : "has a schedule"),
          "leave it out");
    }
    if (limited != nullptr && given == nullptr) {
      return ambiguous(written_.path.range, "`" + job_.path + "`, " + limited->where + " " + what,
                       "a zone has no such "
                       "limits",
                       "write `" + name + " \"why\"` behind it to take the area " + instead +
                           ": safe of one to keep out of, and a promise of one to stay in" +
                           (word == ImportWord::flat
                                ? "; or `heights agl at 0 m`, with the level from which its "
                                  "heights count"
                                : "; or `scheduled`, and the zone is there at these times"));
    }
    if (given != nullptr) job_.remarks.push_back(name + ": " + given->text->text);
    return true;
  }

  Context& context_;
  const syntax::ImportLit& written_;
  FrameId frame_;
  std::array<const ImportOption*, 9> options_{};
  std::map<AltitudeReference, const ImportOption*> levels_;
  const Areas* areas_ = nullptr;
  std::vector<const Area*> selected_;
  ImportJob job_{written_, {}, {}, {}, {}, false, false, {}, {}, {}, false, {}, {}};
};

}  // namespace

std::optional<ZoneImport> import_zone(Context& context, const syntax::ImportLit& written,
                                      FrameId frame) {
  return Importer(context, written, frame).run();
}

}  // namespace rtac::sema
