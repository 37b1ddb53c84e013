// The steps of reading GeoJSON, of which ED-318 is a dialect with more members. Internal to this
// folder.
#pragma once

#include <initializer_list>
#include <string_view>

#include "compiler/geometry/import/json_reader.h"

namespace rtac::geometry::import {

class GeoJsonReader {
 public:
  GeoJsonReader(Findings& findings, const Limits& limits)
      : findings_(findings), json_(findings, limits) {}
  GeoJsonReader(const GeoJsonReader&) = delete;
  GeoJsonReader& operator=(const GeoJsonReader&) = delete;
  virtual ~GeoJsonReader() = default;

  bool read_root(Json root);
  Areas take_areas();

 protected:
  // What the feature says about its area besides the geometry.
  virtual bool read_properties(Json feature, Area& area);
  // The band of a geometry that is no collection.
  virtual bool read_layer(Json geometry, Band& band);
  virtual bool read_point(Json point, const Band& band, Area& area);
  // Of the object that holds the features.
  virtual bool read_metadata(Json collection);
  bool check_object(Json object, std::initializer_list<std::string_view> known);

  Findings& findings_;
  JsonReader json_;
  Areas areas_;

 private:
  bool read_collection(Json collection);
  bool read_feature(Json feature);
  bool read_geometry(Json geometry, Area& area);
  bool read_shape(Json geometry, std::string_view type, Area& area);
  bool read_geometries(Json collection, Area& area);
  bool add_polygon(Json rings, const Band& band, Area& area);
  bool check_crs(Json object);
  // Members that GeoJSON has in objects of another kind: what is in them would be lost.
  bool check_strangers(Json object, std::string_view kind,
                       std::initializer_list<std::string_view> strangers);
  bool check_id(Json feature);
  void note_limits(Json properties, Area& area);
};

}  // namespace rtac::geometry::import
