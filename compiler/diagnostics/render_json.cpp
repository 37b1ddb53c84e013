#include <nlohmann/json.hpp>

#include "compiler/diagnostics/render.h"

namespace rtac::diag {
namespace {

using Json = nlohmann::ordered_json;

Json place_json(FileId file, std::uint32_t offset, const SourceManager& sources) {
  const LineColumn place = sources.position(file, offset);
  return {{"line", place.line},
          {"column", place.column},
          {"offset", sources.offset_in_file(file, offset)}};
}

Json location_json(const std::optional<SourceRange>& range, const SourceManager& sources) {
  if (!range) return nullptr;
  return {{"file", sources.path(range->file)},
          {"begin", place_json(range->file, range->begin, sources)},
          {"end", place_json(range->file, range->end, sources)}};
}

Json diagnostic_json(const Diagnostic& diagnostic, const SourceManager& sources) {
  Json notes = Json::array();
  for (const Note& note : diagnostic.notes) {
    notes.push_back({{"message", note.text}, {"location", location_json(note.range, sources)}});
  }
  Json fixits = Json::array();
  for (const FixIt& fixit : diagnostic.fixits) {
    fixits.push_back(
        {{"location", location_json(fixit.range, sources)}, {"replacement", fixit.replacement}});
  }
  const CodeInfo& code = info(diagnostic.code);
  return {{"code", static_cast<int>(code.code)},
          {"name", code.name},
          {"severity", name(code.severity)},
          {"message", diagnostic.message},
          {"location", location_json(diagnostic.range, sources)},
          {"label", diagnostic.label},
          {"notes", std::move(notes)},
          {"help", diagnostic.help},
          {"fixits", std::move(fixits)}};
}

}  // namespace

std::string render_json(const Engine& engine, const SourceManager& sources) {
  Json result = Json::array();
  for (const Diagnostic& diagnostic : engine.all()) {
    result.push_back(diagnostic_json(diagnostic, sources));
  }
  // Source text that is not UTF-8 may be quoted in a message: replaced, never an exception.
  return result.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rtac::diag
