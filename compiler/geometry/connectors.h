// The last stretch of a way home that begins where a moving recovery would not go by itself: from a
// place near the boundary straight to the centre of an admissible cell. Internal to this folder.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compiler/geometry/bake.h"

namespace rtac::geometry {

// A cell that a connector may lead to. `rest_mm`: length of the way from its centre on.
struct Landing {
  double x_mm, y_mm;
  double rest_mm;
};

class Connectors {
 public:
  // A body of less than `body_mm` of clearance is nowhere; a leg counts as sound when its clearance
  // stays at that of its start or at `clearance_mm`, less what the controller forgives: of 8 mm in
  // the plane, 7.
  Connectors(const std::vector<EdgeRow>& edges, std::int32_t clearance_mm, std::int32_t body_mm,
             double forgiven_mm = 7);

  // Upper bound, over every place of the square cell at (x, y) where a body can be, of the shortest
  // way over one of `landings`; negative when some place has no sound leg. The landings are sorted
  // from the smallest bound on. 0 when a body is nowhere in the cell. `reach_mm`: from centre to
  // centre.
  [[nodiscard]] double longest_mm(double x_mm, double y_mm, double size_mm,
                                  const std::vector<Landing>& landings, double reach_mm);

  // The same one by one. A square by its middle, and up to what clearance matters the one that its
  // middle has; of the cell at (x, y), whose edges are looked at from then on, or within it.
  struct Spot {
    double x_mm, y_mm, side_mm;
    double gap_mm;
    [[nodiscard]] double radius_mm() const;  // of the circle around it
  };
  [[nodiscard]] Spot look_around(double x_mm, double y_mm, double size_mm, double reach_mm);
  // Edges by their ends off the corner of that cell. Where they are the same, legs of up to
  // `reach_mm` are as sound from there: of edges along an axis, the parts far off are cut off.
  [[nodiscard]] std::vector<std::int32_t> edges_off_corner() const;
  // How many edges that took a look at.
  [[nodiscard]] std::int64_t looked_at() const { return looked_at_; }
  [[nodiscard]] std::array<Spot, 4> quarters(const Spot& spot) const;
  // No body can be there.
  [[nodiscard]] bool holds_nobody(const Spot& spot) const;
  // The leg to there, or to anywhere within `off_mm` of that, is sound from each of its places.
  [[nodiscard]] bool is_sound(const Spot& spot, const Landing& to, double off_mm = 0) const;
  // From how much of a spot the leg to there is sound: from no place of it, or it is not known from
  // all. The edge `by` refused it last, and is asked first; the one that refuses it now takes its
  // place. From a part of a spot it is mostly the same one. Of two that refuse it one may say from
  // none, and the other one not know.
  enum class Sight { from_all, unknown, from_none };
  static constexpr std::uint32_t nobody = UINT32_MAX;
  [[nodiscard]] Sight sight(const Spot& spot, const Landing& to, std::uint32_t& by) const;

 private:
  struct Leg;
  [[nodiscard]] Leg leg_from(const Spot& spot, const Landing& to, double off_mm) const;
  [[nodiscard]] Sight past(const EdgeRow& edge, const Leg& leg) const;
  [[nodiscard]] Sight asked(const Leg& leg, std::uint32_t& by) const;
  [[nodiscard]] double longest_in(const Spot& spot, int halvings,
                                  const std::vector<Landing>& landings) const;
  [[nodiscard]] std::size_t strip_of(double x_mm) const;
  [[nodiscard]] Spot spot_at(double x_mm, double y_mm, double side_mm) const;
  [[nodiscard]] bool contains(double x, double y) const;

  const std::vector<EdgeRow>& edges_;
  double clearance_mm_, body_mm_, forgiven_mm_;
  // Edges by the strips of x that they reach into, one beside the other.
  double west_ = 0, strip_mm_ = 1;
  std::vector<std::vector<std::uint32_t>> strips_;
  std::vector<std::uint32_t> near_;  // edges that matter for the cell
  double corner_x_mm_ = 0, corner_y_mm_ = 0, size_mm_ = 0;
  double limit_mm_ = 0;  // from its middle, of what matters of them
  std::int64_t looked_at_ = 0;
  mutable std::uint32_t refused_last_ = nobody;  // by `is_sound`, of which it changes no answer
};

}  // namespace rtac::geometry
