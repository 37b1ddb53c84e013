#include "passage.h"

namespace rtac::safe {

void recede_from_held(const Observation& observation, RouteQuery& query) {
  for (int j = 0; j < observation.robots; ++j) {
    const Announcement& other = observation.others[static_cast<std::size_t>(j)];
    if (j == observation.self || !is_held(other, observation.now_us)) continue;
    (void)query.recede_from.push(other.position.value);  // never more than robots
  }
}

void Manoeuvre::make_passage(const Observation& observation, Gate gate, int asker) {
  const Announcement& other = observation.others[static_cast<std::size_t>(asker)];
  Aside aside(setting_);
  aside.keep_from_way(other.position.value, other.plan);
  stay();
  if (aside.good_enough(observation.position.value)) return;  // already out of the way
  RouteQuery away = query(observation, false);
  recede_from_held(observation, away);
  if (route_.to_place(away, aside, way_)) return;
  // At the pass gap around everybody who holds, the separation test lets it go in any direction.
  if (gate != Gate::away_only && route_.to_place(query(observation, true), aside, way_)) return;
  stay();
}

}  // namespace rtac::safe
