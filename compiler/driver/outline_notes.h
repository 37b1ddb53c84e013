// What of the outlines of a zone is not taken as it is written, and makes no difference: the author
// may still want to know, since it often tells of a slip.
#pragma once

#include <string>
#include <vector>

#include "compiler/sema/spec.h"

namespace rtac::driver {

struct OutlineNote {
  std::string text;   // "2 vertices lie on a line with their neighbours and are left out"
  std::string first;  // "vertex 3 of hole 1", or of a file; may be empty
};

std::vector<OutlineNote> outline_notes(const sema::ZonePolygon& polygon);
std::vector<OutlineNote> outline_notes(const sema::ZoneImport& import);
// Of all outlines of the zone itself; zones that it names have their own.
std::vector<OutlineNote> outline_notes(const sema::ZoneExpr& expr);

}  // namespace rtac::driver
