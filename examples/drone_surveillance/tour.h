// One tour of the surveillance study: a drone visits random places of a room with four walls that
// its planner does not know.
#pragma once

#include <cstdint>
#include <string>

namespace surveillance {

inline constexpr int destinations = 30;

enum class Variant { sound_2, sound_1, paper_1, paper_2 };
inline constexpr Variant variants[] = {Variant::sound_2, Variant::sound_1, Variant::paper_1,
                                       Variant::paper_2};
const char* name_of(Variant variant);

struct TourOptions {
  std::uint64_t seed = 1;
  Variant variant = Variant::sound_2;
  bool protect = true;     // false: the same tour without the decision module
  bool adversary = false;  // the advanced controller pushes at the nearest wall, all the time
  double seconds = 600;    // longest duration; an adversary never finishes
  std::string out;         // directory for the log and the picture; empty: none
};

struct TourResult {
  int reached = 0, skipped = 0;
  int reachable = 0;          // destinations with room enough to give control back there
  int reached_reachable = 0;  // of these
  int switches = 0;           // from the advanced to the safe controller
  double advanced_share = 0;  // of the time
  double duration_s = 0;
  double clearance_m = 0;  // smallest distance of the centre from a wall, true state
  bool violated = false;   // closer than 20 cm
  bool finished = false;   // all destinations were reached or skipped, and files written
};

TourResult fly(const TourOptions& options);

}  // namespace surveillance
