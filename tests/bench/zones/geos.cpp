// The best that GEOS has: its prepared geometries, by the interface for C, which is the stable one,
// and the locator of points and the index of edges behind them. Distances are asked of the
// boundary, as those from an area are 0 in it.
#define USE_UNSTABLE_GEOS_CPP_API
#include <geos/algorithm/locate/IndexedPointInAreaLocator.h>
#include <geos/geom/Geometry.h>
#include <geos/geom/Location.h>
#include <geos_c.h>

#include <cmath>
#include <memory>

#include "tests/bench/zones/contender.h"

namespace rtac::bench {
namespace {

class Library {
 public:
  Library() : handle_(GEOS_init_r()) {}
  ~Library() { GEOS_finish_r(handle_); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  operator GEOSContextHandle_t() const { return handle_; }

 private:
  GEOSContextHandle_t handle_;
};
const Library& library() {
  static const Library only;
  return only;
}

struct FreeGeometry {
  void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(library(), g); }
  void operator()(const GEOSPreparedGeometry* g) const { GEOSPreparedGeom_destroy_r(library(), g); }
};
using Geometry = std::unique_ptr<GEOSGeometry, FreeGeometry>;
using Prepared = std::unique_ptr<const GEOSPreparedGeometry, FreeGeometry>;

GEOSCoordSequence* sequence(const std::vector<GridPlace>& places, bool is_closed) {
  const std::size_t count = places.size() + (is_closed ? 1 : 0);
  GEOSCoordSequence* const to = GEOSCoordSeq_create_r(library(), static_cast<unsigned>(count), 2);
  for (std::size_t i = 0; i < count; ++i) {
    const GridPlace& p = places[i % places.size()];
    GEOSCoordSeq_setXY_r(library(), to, static_cast<unsigned>(i), p.x_mm, p.y_mm);
  }
  return to;
}
Geometry polygon(const Outline& outline) {
  std::vector<GEOSGeometry*> rings;
  for (const auto& ring : outline.rings) {
    rings.push_back(GEOSGeom_createLinearRing_r(library(), sequence(ring, true)));
  }
  return Geometry(GEOSGeom_createPolygon_r(library(), rings.front(), rings.data() + 1,
                                           static_cast<unsigned>(rings.size() - 1)));
}

// A geometry, prepared, and what it is asked about.
struct Scene {
  Geometry area, boundary;
  Prepared prepared;
  std::vector<Geometry> asked;
};
std::shared_ptr<Scene> scene_of(const Outline& outline, bool by_boundary) {
  const auto scene = std::make_shared<Scene>();
  scene->area = polygon(outline);
  scene->boundary = Geometry(GEOSBoundary_r(library(), scene->area.get()));
  scene->prepared =
      Prepared(GEOSPrepare_r(library(), by_boundary ? scene->boundary.get() : scene->area.get()));
  return scene;
}
void ask_about_places(Scene& scene, const std::vector<GridPlace>& places) {
  for (const GridPlace& p : places) {
    scene.asked.emplace_back(GEOSGeom_createPointFromXY_r(library(), p.x_mm, p.y_mm));
  }
}
void ask_about_legs(Scene& scene, const std::vector<GridPlace>& legs) {
  for (std::size_t i = 0; i + 1 < legs.size(); i += 2) {
    scene.asked.emplace_back(
        GEOSGeom_createLineString_r(library(), sequence({legs[i], legs[i + 1]}, false)));
  }
}

template <class Answer>
Contender contender(const char* name, const std::shared_ptr<Scene>& scene, const Answer& answer,
                    bool is_comparable = true) {
  return {name,
          [scene, answer](std::size_t first, std::size_t end) {
            double sum = 0;
            for (std::size_t i = first; i < end; ++i) {
              sum += answer(scene->prepared.get(), scene->asked[i].get());
            }
            return sum;
          },
          is_comparable};
}

Contender prepared_distance(const std::shared_ptr<Scene>& scene) {
  return contender("GEOS, prepared distance", scene,
                   [](const GEOSPreparedGeometry* g, const GEOSGeometry* of) {
                     double distance = 0;
                     GEOSPreparedDistance_r(library(), g, of, &distance);
                     return distance;
                   });
}
// Only whether it is within some metres, which can stop early.
Contender prepared_within(const std::shared_ptr<Scene>& scene) {
  return contender(
      "GEOS, whether within 5 m", scene,
      [](const GEOSPreparedGeometry* g, const GEOSGeometry* of) {
        return static_cast<double>(GEOSPreparedDistanceWithin_r(library(), g, of, 5'000));
      },
      false);
}

std::vector<Contender> inside(const Outline& outline, const std::vector<GridPlace>& places) {
  const auto scene = scene_of(outline, false);
  ask_about_places(*scene, places);
  std::vector<Contender> all{contender("GEOS, prepared intersects", scene,
                                       [](const GEOSPreparedGeometry* g, const GEOSGeometry* of) {
                                         return static_cast<double>(
                                             GEOSPreparedIntersects_r(library(), g, of));
                                       })};
#if GEOS_VERSION_MAJOR > 3 || GEOS_VERSION_MINOR >= 12
  const auto xy = std::make_shared<std::vector<GridPlace>>(places);
  all.push_back({"GEOS, prepared intersects XY", [scene, xy](std::size_t first, std::size_t end) {
                   int inside = 0;
                   for (std::size_t i = first; i < end; ++i) {
                     inside += GEOSPreparedIntersectsXY_r(library(), scene->prepared.get(),
                                                          (*xy)[i].x_mm, (*xy)[i].y_mm);
                   }
                   return static_cast<double>(inside);
                 }});
#endif
  using Locator = geos::algorithm::locate::IndexedPointInAreaLocator;
  const auto locator =
      std::make_shared<Locator>(*reinterpret_cast<const geos::geom::Geometry*>(scene->area.get()));
  const auto points = std::make_shared<std::vector<geos::geom::Coordinate>>();
  for (const GridPlace& p : places) points->emplace_back(p.x_mm, p.y_mm);
  all.push_back({"GEOS, indexed point-in-area locator",
                 [scene, locator, points](std::size_t first, std::size_t end) {
                   int inside = 0;
                   for (std::size_t i = first; i < end; ++i) {
                     inside += locator->locate(&(*points)[i]) != geos::geom::Location::EXTERIOR;
                   }
                   return static_cast<double>(inside);
                 }});
  return all;
}

}  // namespace

std::vector<Contender> geos_contenders(Question question, const Outline& outline,
                                       const std::vector<GridPlace>& places) {
  if (question == Question::inside) return inside(outline, places);
  const auto scene = scene_of(outline, true);
  question == Question::leg ? ask_about_legs(*scene, places) : ask_about_places(*scene, places);
  return {prepared_distance(scene), prepared_within(scene)};
}

}  // namespace rtac::bench
