// A place that is clear enough of the boundaries of several zones at once.
#pragma once

#include <optional>
#include <vector>

#include "compiler/analysis/outline.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {

// Whether a place is as clear of each zone as is asked: exactly, but where doubles tell that it is
// not. Zones have to outlive it.
class IsClear {
 public:
  IsClear(const Subject& s, const std::vector<Need>& all);
  bool operator()(const geometry::Point& p) const;

 private:
  struct Zone {
    const geometry::Region& region;
    analysis::outline::Outline outline;
    std::int64_t clearance_mm;
  };
  std::vector<Zone> zones_;
};

// In the plane: of the cells of the narrowest zone or its widest one, or else, to a millimetre, of
// all that is left of the zones. `all` is not empty.
std::optional<geometry::Point> common_place(const Subject& s, const std::vector<Need>& all);

// Where a robot fits into all of them, whether control is given back there or not.
std::optional<geometry::Point> any_place(const Subject& s, std::vector<Need> all);

}  // namespace rtac::verify
