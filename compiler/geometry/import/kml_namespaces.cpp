#include "compiler/geometry/import/kml_namespaces.h"

#include <algorithm>
#include <array>

namespace rtac::geometry::import {
namespace {

// Each version has its own, and programs mix them.
bool is_kml_namespace(std::string_view uri) {
  constexpr std::array<std::string_view, 5> all{
      "http://www.opengis.net/kml/2.2", "http://www.opengis.net/kml/2.3",
      "http://earth.google.com/kml/2.0", "http://earth.google.com/kml/2.1",
      "http://earth.google.com/kml/2.2"};
  return std::find(all.begin(), all.end(), uri) != all.end();
}

}  // namespace

std::string_view prefix_of(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? std::string_view{} : name.substr(0, colon);
}

std::string_view local_name(std::string_view name) {
  return name.substr(name.find(':') + 1);  // npos + 1 is 0
}

void KmlNamespaces::declare(std::string_view attribute, std::string_view uri) {
  if (attribute != "xmlns" && prefix_of(attribute) != "xmlns") return;
  const std::string_view prefix = attribute == "xmlns" ? "" : local_name(attribute);
  std::vector<std::string_view>& uris = uris_[prefix];
  if (uri.empty() && uris.empty()) return;  // takes back what nobody has declared
  uris.push_back(uri);
  prefixes_.push_back(prefix);
}

void KmlNamespaces::keep(std::size_t count) {
  while (prefixes_.size() > count) {
    uris_.at(prefixes_.back()).pop_back();
    prefixes_.pop_back();
  }
}

std::optional<std::string_view> KmlNamespaces::uri_of(std::string_view element) const {
  const auto found = uris_.find(prefix_of(element));
  if (found == uris_.end() || found->second.empty()) return std::nullopt;
  return found->second.back();
}

KmlVocabulary KmlNamespaces::vocabulary_of(std::string_view element) const {
  if (const auto uri = uri_of(element)) {
    if (is_kml_namespace(*uri)) return KmlVocabulary::kml;
    return uri->starts_with("http://www.google.com/kml/ext/") ? KmlVocabulary::google
                                                              : KmlVocabulary::other;
  }
  const std::string_view prefix = prefix_of(element);
  if (prefix.empty() || prefix == "kml") return KmlVocabulary::kml;
  return prefix == "gx" ? KmlVocabulary::google : KmlVocabulary::other;
}

}  // namespace rtac::geometry::import
