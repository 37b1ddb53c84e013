// Which vocabulary the elements of a file of KML are of, by the namespaces that are declared around
// them. Internal to this folder.
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace rtac::geometry::import {

// `google`: its extensions of KML.
enum class KmlVocabulary { kml, google, other };

// `gx` of `gx:altitudeMode`; empty without one. The name without it: programs write `kml:Polygon`.
std::string_view prefix_of(std::string_view name);
std::string_view local_name(std::string_view name);

// The declarations of an element and of those around it; what they say must outlive it.
class KmlNamespaces {
 public:
  // `xmlns` and `xmlns:PREFIX`; other attributes declare nothing.
  void declare(std::string_view attribute, std::string_view uri);
  std::size_t count() const { return prefixes_.size(); }
  // At the end of an element: back to what had been declared before it.
  void keep(std::size_t count);

  // nullopt: none is declared for the prefix of the element.
  std::optional<std::string_view> uri_of(std::string_view element) const;
  // Without a declaration, by the prefix that programs write.
  KmlVocabulary vocabulary_of(std::string_view element) const;

 private:
  std::map<std::string_view, std::vector<std::string_view>> uris_;  // innermost last
  std::vector<std::string_view> prefixes_;                          // as they were declared
};

}  // namespace rtac::geometry::import
