// From the areas of a file to the polygons and circles of a zone. Internal to imports.cpp.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/geometry/import/areas.h"
#include "compiler/geometry/place/placer.h"
#include "compiler/sema/context.h"

namespace rtac::sema {

struct ImportJob {
  const syntax::ImportLit& written;
  std::string path;  // from here, for messages
  geometry::import::Format format{};
  geometry::Reading reading;
  std::optional<geometry::Origin> origin;
  bool axes_written = false;
  bool latitude_first = false;  // in the file, as its format or the author has it
  std::vector<std::vector<const geometry::import::Area*>> inclusions;
  std::vector<const geometry::import::Area*> exclusions;
  std::vector<std::string> remarks;
  // Heights count: from here, in m, by their reference.
  bool with_heights = false;
  std::map<geometry::import::AltitudeReference, Rational> levels{};
  std::vector<Opening> openings{};  // when all areas apply
};

// `axes latitude longitude`, or the other way round.
std::string axes_text(bool latitude_first);

// nullopt: some position has no place, which is reported.
std::optional<ZoneImport> place_areas(Context& context, const ImportJob& job);

}  // namespace rtac::sema
