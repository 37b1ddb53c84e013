// KML: Placemarks with polygons; heights make a solid only where the format says so.
#include "tests/compiler/geometry/import/testing.h"

namespace rtac::geometry::import {
namespace {

std::string kml(const std::string& content) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Folder>" +
         content + "</Folder></Document></kml>";
}
std::string ring(const std::string& coordinates) {
  return "<LinearRing><coordinates>" + coordinates + "</coordinates></LinearRing>";
}
std::string polygon(const std::string& coordinates, const std::string& more = "") {
  return "<Polygon>" + more + "<outerBoundaryIs>" + ring(coordinates) +
         "</outerBoundaryIs></Polygon>";
}
std::string placemark(const std::string& geometry) {
  return "<Placemark id=\"p1\"><name> field </name>" + geometry + "</Placemark>";
}
std::string failure(const std::string& text, const Limits& limits = {}) {
  return failure_of(Format::kml, text, limits);
}

const std::string triangle = "8.5,47.1\n 8.6,47.1,0 8.6,47.2 8.5,47.1";
const std::string high = "8.5,47.1,120 8.6,47.1,120 8.6,47.2,120 8.5,47.1,120";

TEST(Kml, PlacemarkIsAnArea) {
  const Area area = only_area(Format::kml, kml(placemark(polygon(triangle))));
  EXPECT_EQ(area.name, "field");
  EXPECT_EQ(area.other_names, std::vector<std::string>{"p1"});
  const Ring& outer = polygon_of(area).outer;
  EXPECT_EQ(outer.positions.size(), 3U);
  EXPECT_EQ(outer.positions.at(1), (Position{8.6, 47.1}));
  EXPECT_TRUE(contains(outer.where, "line 2, column "));
  EXPECT_FALSE(area.parts[0].band.floor || area.parts[0].band.ceiling);
}

// Whoever turns a file of GeoJSON into KML keeps its limits so.
TEST(Kml, DataThatSoundLikeLimitsAreNoted) {
  const auto with = [](const std::string& data) {
    return only_area(Format::kml, kml(placemark("<ExtendedData>" + data + "</ExtendedData>" +
                                                polygon(triangle))));
  };
  const Area height = with("<Data name=\"ceiling\"><value>120</value></Data>");
  ASSERT_TRUE(height.unread_height);
  EXPECT_TRUE(contains(height.unread_height->where, "line 2, column "));
  EXPECT_TRUE(with("<SchemaData><SimpleData name=\"valid_until\">2024-05-01</SimpleData>"
                   "</SchemaData>")
                  .unread_time);
  EXPECT_TRUE(with("<faa:ceiling xmlns:faa=\"http://x.org\">400 ft</faa:ceiling>").unread_height);
  const Area plain = with("<Data name=\"owner\"><value>12</value></Data>");
  EXPECT_FALSE(plain.unread_height || plain.unread_time);
}

TEST(Kml, InnerBoundariesAreHoles) {
  const std::string hole = "<innerBoundaryIs>" + ring("1,1 2,1 2,2 1,1") + "</innerBoundaryIs>";
  const Area area = only_area(Format::kml, kml(placemark(polygon("0,0 9,0 9,9 0,0", hole + hole))));
  EXPECT_EQ(polygon_of(area).holes.size(), 2U);
}

TEST(Kml, PrefixesAreNoMatter) {
  EXPECT_EQ(failure("<k:kml "
                    "xmlns:k=\"http://www.opengis.net/kml/"
                    "2.2\"><k:Placemark><k:Polygon><k:outerBoundaryIs><k:LinearRing>"
                    "<k:coordinates>0,0 9,0 9,9 0,0</k:coordinates></k:LinearRing>"
                    "</k:outerBoundaryIs></k:Polygon></k:Placemark></k:kml>"),
            "");
}

// Of another vocabulary a name of KML says nothing.
TEST(Kml, ElementsOfOtherNamespacesAreUnknown) {
  EXPECT_TRUE(
      contains(failure(kml("<x:Placemark xmlns:x=\"y\"/>")), "`<x:Placemark>` is no element"));
  EXPECT_TRUE(contains(failure(kml("<gx:Placemark/>")), "`<gx:Placemark>` is no element"));
  EXPECT_TRUE(contains(failure(kml("<Placemark xmlns=\"y\"/>")), "`<Placemark>` is no element"));
  EXPECT_EQ(failure(kml("<Placemark xmlns=\"http://earth.google.com/kml/2.1\"/><kml:Folder/>")),
            "");
}

TEST(Kml, NamespacesOfAllVersionsAreRead) {
  for (const std::string uri :
       {"", "http://www.opengis.net/kml/2.2", "http://www.opengis.net/kml/2.3",
        "http://earth.google.com/kml/2.0", "http://earth.google.com/kml/2.1",
        "http://earth.google.com/kml/2.2"}) {
    EXPECT_EQ(failure("<kml xmlns=\"" + uri + "\">" + placemark(polygon(triangle)) + "</kml>"), "")
        << uri;
  }
}

// Of another vocabulary the whole file says nothing.
TEST(Kml, RootsOfOtherNamespacesAreRefused) {
  EXPECT_TRUE(contains(failure("<?xml version=\"1.0\"?>\n<kml xmlns=\"http://example.com\">" +
                               placemark(polygon(triangle)) + "</kml>"),
                       "line 2, column 2: the namespace of the outermost element, `<kml>`, is "
                       "`http://example.com` (write `http://www.opengis.net/kml/2.2` for it"));
  EXPECT_TRUE(contains(failure("<kml:kml xmlns:kml=\"urn:other\"><Placemark/></kml:kml>"),
                       "of the outermost element, `<kml:kml>`, is `urn:other`"));
  EXPECT_TRUE(contains(failure("<k:kml><Placemark/></k:kml>"),
                       "no namespace is declared for the prefix of the outermost element"));
}

// What an element declares holds within it, and for no prefix but its own.
TEST(Kml, NamespacesAreThoseDeclaredAroundAnElement) {
  const std::string head = "<a:kml xmlns:a=\"http://www.opengis.net/kml/2.2\" xmlns=\"urn:x\">";
  EXPECT_EQ(failure(head + "<a:Placemark/></a:kml>"), "");
  EXPECT_TRUE(contains(failure(head + "<Placemark/></a:kml>"),
                       "`<Placemark>` is no element of KML within `<a:kml>` (its namespace is "
                       "`urn:x`: write `http://www.opengis.net/kml/2.2` for it"));
  EXPECT_TRUE(contains(failure(kml("<k:Folder xmlns:k=\"http://www.opengis.net/kml/2.2\">"
                                   "<k:Placemark/></k:Folder><k:Placemark/>")),
                       "`<k:Placemark>` is no element of KML within `<Folder>`"));
  EXPECT_TRUE(contains(failure(kml("<Placemark xmlns=\"\"/>")), "`<Placemark>` is no element"));
}

// They are known by their namespace; without a declaration, by the prefix that programs write.
TEST(Kml, ExtensionsOfGoogleAreReadWithAnyPrefix) {
  const auto refusal = [](const std::string& declared) {
    return refusal_of(
        only_area(Format::kml, kml(placemark("<g:Track xmlns:g=\"" + declared + "\"/>"))));
  };
  EXPECT_TRUE(contains(refusal("http://www.google.com/kml/ext/2.2"), "a Track encloses nothing"));
  EXPECT_TRUE(contains(failure(kml(placemark("<gx:Track xmlns:gx=\"urn:x\"/>"))),
                       "`<gx:Track>` is no element of KML"));
}

// Two exports in one file: the zones of the second would be lost.
TEST(Kml, SecondRootsAreRefused) {
  const std::string one = "<kml>" + placemark(polygon(triangle)) + "</kml>\n";
  const std::string column = "<?xml version=\"1.0\"?>";
  EXPECT_TRUE(
      contains(failure(one + one), "line 3, column 2: a second outermost element, `<kml>`"));
  EXPECT_TRUE(contains(failure(one + column + one), "a second outermost element, `<kml>` (files"));
  EXPECT_TRUE(contains(failure(one + "<Placemark/>"), "second outermost element, `<Placemark>`"));
  EXPECT_EQ(failure("<!-- a -->" + one + "<!-- b -->\n<?stop?>\n"), "");
}

TEST(Kml, TextOutsideOfTheRootIsRefused) {
  const std::string one = "<kml>" + placemark(polygon(triangle)) + "</kml>";
  EXPECT_TRUE(
      contains(failure(one + "\n&lt;kml>"), "text outside of the outermost element: `<kml>`"));
  EXPECT_TRUE(contains(failure(one + " x"), "text outside of the outermost element: `x`"));
  EXPECT_TRUE(contains(failure("x" + one), "line 1, column 1: text outside of the outermost"));
  EXPECT_TRUE(contains(failure("<!-- a -->"), "this is no XML: it has no element"));
}

// Each of them may be a hole, or a zone of its own.
TEST(Kml, UnknownElementsAreToldByName) {
  const auto told = [](const std::string& content) { return failure(kml(content)); };
  const std::string hole = ring("1,1 2,1 2,2 1,1");
  const std::string in_polygon =
      placemark(polygon(triangle, "<innerboundaryIs>" + hole + "</innerboundaryIs>"));
  EXPECT_TRUE(contains(told(in_polygon), "line 2, column "));
  EXPECT_TRUE(contains(told(in_polygon),
                       "`<innerboundaryIs>` is no element of KML within `<Polygon>` (KML spells it "
                       "`innerBoundaryIs`)"));
  EXPECT_TRUE(
      contains(told(placemark(polygon(triangle, "<innerBoundary>" + hole + "</innerBoundary>"))),
               "`<innerBoundary>` is no element of KML within `<Polygon>` (an area or a hole "
               "may be lost with it; what is read there is `outerBoundaryIs`, "));
  EXPECT_TRUE(contains(told("<placemark>" + polygon(triangle) + "</placemark>"),
                       "KML spells it `Placemark`"));
  EXPECT_TRUE(contains(told("<Foo>" + placemark(polygon(triangle)) + "</Foo>"),
                       "`<Foo>` is no element of KML within `<Folder>`"));
  EXPECT_TRUE(contains(told("<Schema parent=\"Placemark\" name=\"S_zone\"/><S_zone>" +
                            polygon(triangle) + "</S_zone>"),
                       "`<S_zone>` is no element"));
  EXPECT_TRUE(contains(told(placemark("<MultiGeometry><polygon/></MultiGeometry>")),
                       "within `<MultiGeometry>` (KML spells it `Polygon`)"));
  EXPECT_TRUE(contains(told(placemark(polygon(triangle) + placemark(polygon(triangle)))),
                       "`<Placemark>` is no element of KML within `<Placemark>`"));
  EXPECT_TRUE(contains(told(placemark("<Polygon><outerBoundaryIs>" + ring(triangle) +
                                      "<linearRing/></outerBoundaryIs></Polygon>")),
                       "KML spells it `LinearRing`"));
  EXPECT_TRUE(contains(told(placemark("<Polygon><outerBoundaryIs><LinearRing><Coordinates/>"
                                      "</LinearRing></outerBoundaryIs></Polygon>")),
                       "KML spells it `coordinates`"));
  EXPECT_TRUE(contains(failure("<kml><Update/></kml>"), "within `<kml>`"));
}

TEST(Kml, TextBetweenElementsIsTold) {
  EXPECT_TRUE(contains(failure(kml("&lt;Placemark&gt;")), "text within `<Folder>`: `<Placemark>`"));
  EXPECT_TRUE(contains(failure(kml(placemark("<Polygon>" + triangle + "</Polygon>"))),
                       "text within `<Polygon>`: `8.5,47.1"));
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0 9,0 <b>1,1</b> 9,9 0,0")))),
                       "`<b>` within `<coordinates>`"));
}

// What Google Earth, QGIS and ArcGIS write besides areas.
TEST(Kml, WhatHasNoSayInAreasIsLeftOut) {
  const std::string feature =
      "<name>n</name><visibility>0</visibility><open>1</open><atom:author/><atom:link/>"
      "<address>a</address><xal:AddressDetails/><phoneNumber/><Snippet maxLines=\"0\"/><snippet/>"
      "<description>d <b>e</b></description><LookAt><gx:TimeSpan/></LookAt><Camera/>"
      "<styleUrl>#s</styleUrl><Style><PolyStyle/></Style><StyleMap/><Region/><Metadata/>"
      "<ExtendedData><SchemaData><SimpleData name=\"x\">1</SimpleData></SchemaData><y:z/>"
      "</ExtendedData><gx:balloonVisibility>1</gx:balloonVisibility>";
  const std::string shape =
      "<Polygon "
      "id=\"g\"><extrude>0</extrude><tessellate>1</tessellate><gx:drawOrder>1</gx:drawOrder>"
      "<altitudeMode>clampToGround</altitudeMode><outerBoundaryIs><LinearRing><extrude>0</extrude>"
      "<tessellate>1</tessellate><altitudeMode>clampToGround</altitudeMode><coordinates>" +
      triangle + "</coordinates></LinearRing></outerBoundaryIs></Polygon>";
  const Areas areas =
      areas_of(Format::kml,
               "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><NetworkLinkControl><expires/>"
               "</NetworkLinkControl><Document>" +
                   feature +
                   "<Schema name=\"t\"><SimpleField/></Schema><gx:CascadingStyle/><gx:Tour/>"
                   "<GroundOverlay/><Folder>" +
                   feature + "<Placemark id=\"p\">" + feature + shape +
                   "</Placemark><ScreenOverlay/></Folder></Document></kml>");
  ASSERT_EQ(areas.areas.size(), 1U);
  EXPECT_FALSE(areas.areas[0].refusal);
  EXPECT_EQ(areas.areas[0].parts.size(), 1U);
  ASSERT_EQ(areas.notes.size(), 1U);
  EXPECT_EQ(areas.notes[0].message, "overlays are pictures, and are left out");
}

TEST(Kml, UpdatesOfOtherFilesAreRefused) {
  EXPECT_TRUE(contains(failure("<kml><NetworkLinkControl><Update/></NetworkLinkControl>" +
                               placemark(polygon(triangle)) + "</kml>"),
                       "an Update changes the features of another file"));
}

TEST(Kml, CommentsDoNotCutCoordinates) {
  const Area area = only_area(
      Format::kml, kml(placemark(polygon("0,0 9,0 <!-- corner --> 9,9 <![CDATA[0,9 ]]>0,0"))));
  EXPECT_EQ(polygon_of(area).outer.positions.size(), 4U);
}

TEST(Kml, MultiGeometryHasSeveralParts) {
  EXPECT_EQ(only_area(Format::kml,
                      kml(placemark("<MultiGeometry>" + polygon(triangle) + "<MultiGeometry>" +
                                    polygon(triangle) + "</MultiGeometry></MultiGeometry>")))
                .parts.size(),
            2U);
}

TEST(Kml, ExtrudedPolygonReachesFromTheGroundToItsHeight) {
  const auto band = [](const std::string& mode) {
    return only_area(Format::kml, kml(placemark(polygon(high, "<extrude>1</extrude><altitudeMode>" +
                                                                  mode + "</altitudeMode>"))))
        .parts.at(0)
        .band;
  };
  const Band above_ground = band("relativeToGround");
  EXPECT_EQ(above_ground.ceiling->value_m, 120);
  EXPECT_EQ(above_ground.ceiling->reference, AltitudeReference::ground);
  EXPECT_EQ(above_ground.floor->value_m, 0);
  EXPECT_EQ(above_ground.floor->reference, AltitudeReference::ground);
  EXPECT_EQ(band("absolute").ceiling->reference, AltitudeReference::mean_sea_level);
  EXPECT_FALSE(band("clampToGround").ceiling);
}

TEST(Kml, SheetsInTheAirRefuseToBeUsed) {
  const auto refusal = [](const std::string& coordinates, const std::string& more) {
    return refusal_of(only_area(Format::kml, kml(placemark(polygon(coordinates, more)))));
  };
  const std::string absolute = "<altitudeMode>absolute</altitudeMode>";
  EXPECT_TRUE(contains(refusal(high, absolute), "a sheet at a height of 120 m"));
  EXPECT_TRUE(contains(refusal("0,0,1 9,0,2 9,9,1 0,0,1", "<extrude>1</extrude>" + absolute),
                       "heights from 1 to 2 m"));
  EXPECT_TRUE(contains(refusal(high, "<gx:altitudeMode>relativeToSeaFloor</gx:altitudeMode>"),
                       "the altitude mode is `relativeToSeaFloor`"));
}

// Which of the two counts is a guess.
TEST(Kml, ContradictoryAltitudesRefuseToBeUsed) {
  const std::string ground = "<altitudeMode>clampToGround</altitudeMode>";
  const std::string absolute = "<altitudeMode>absolute</altitudeMode>";
  const auto refusal = [](const std::string& shape) {
    return refusal_of(only_area(Format::kml, kml(placemark(shape))));
  };
  EXPECT_TRUE(contains(refusal(polygon(high, ground + absolute)),
                       "a second `<altitudeMode>` of the polygon"));
  EXPECT_TRUE(contains(refusal(polygon(triangle, ground + "<gx:altitudeMode>clampToSeaFloor"
                                                          "</gx:altitudeMode>")),
                       "a second `<gx:altitudeMode>`"));
  EXPECT_TRUE(
      contains(refusal(polygon(high, absolute + "<extrude>1</extrude><extrude>0</extrude>")),
               "a second `<extrude>`"));
  const std::string in_ring = "<Polygon><outerBoundaryIs><LinearRing>" + absolute +
                              "<coordinates>" + high +
                              "</coordinates></LinearRing></outerBoundaryIs></Polygon>";
  EXPECT_TRUE(contains(refusal(in_ring),
                       "the altitude mode of the ring is `absolute`, that of the "
                       "polygon `clampToGround`"));
}

TEST(Kml, HeightsOfNoneAboveGroundAreNoSheet) {
  EXPECT_FALSE(
      only_area(Format::kml,
                kml(placemark(polygon(triangle, "<altitudeMode>relativeToGround</altitudeMode>"))))
          .refusal);
}

TEST(Kml, ExtrudingBelowTheGroundIsUpsideDown) {
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0,-5 9,0,-5 9,9,-5 0,0,-5",
                                                     "<extrude>1</extrude><altitudeMode>"
                                                     "relativeToGround</altitudeMode>")))),
                       "upside down: from 0 m up to -5 m"));
}

TEST(Kml, WhatEnclosesNothingRefusesToBeUsed) {
  const auto refusal = [](const std::string& content) {
    return refusal_of(only_area(Format::kml, kml(content)));
  };
  EXPECT_TRUE(contains(refusal(placemark("<Point/>")), "a Point encloses nothing"));
  EXPECT_TRUE(contains(refusal(placemark(ring(triangle))), "<outerBoundaryIs>"));
  EXPECT_TRUE(contains(refusal(placemark("")), "has no Polygon"));
  EXPECT_TRUE(
      contains(refusal(placemark("<TimeSpan/>" + polygon(triangle))), "a TimeSpan tells when"));
  const std::string timed = "<Folder>" + placemark(polygon(triangle)) + "<TimeStamp/></Folder>";
  EXPECT_TRUE(contains(refusal(timed), "a TimeStamp tells when"));
  EXPECT_TRUE(contains(refusal("<Document><TimeSpan/><Folder>" + placemark(polygon(triangle)) +
                               "</Folder></Document>"),
                       "a TimeSpan tells when"));
  EXPECT_TRUE(contains(refusal("<NetworkLink><name>n</name></NetworkLink>"), "is not followed"));
}

TEST(Kml, PositionsAreToldWithTheirText) {
  EXPECT_TRUE(
      contains(failure(kml(placemark(polygon("0,0 9, 0 9,9 0,0")))), "position 2: is `9,`"));
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0 9,0,1,2 9,9 0,0")))), "is `9,0,1,2`"));
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0 9,nan 9,9 0,0")))), "is `9,nan`"));
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0 9 9,9 0,0")))), "is `9`"));
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0 9,1e400 9,9 0,0")))), "is `9,1e400`"));
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0 9,0 9,9")))), "the ring is open"));
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0 9,95 9,9 0,0")))), "off the globe"));
}

TEST(Kml, WhatIsMissingOrTwiceIsTold) {
  EXPECT_TRUE(contains(failure(kml(placemark("<Polygon/>"))), "without <outerBoundaryIs>"));
  EXPECT_TRUE(contains(failure(kml(placemark("<Polygon><outerBoundaryIs/></Polygon>"))),
                       "without a LinearRing"));
  EXPECT_TRUE(
      contains(failure(kml(placemark(polygon(
                   triangle, "<outerBoundaryIs>" + ring(triangle) + "</outerBoundaryIs>")))),
               "a second outline"));
  EXPECT_TRUE(contains(failure(kml(placemark(
                           "<Polygon><outerBoundaryIs><LinearRing/></outerBoundaryIs></Polygon>"))),
                       "without <coordinates>"));
  EXPECT_TRUE(contains(failure(kml(placemark("<Polygon><outerBoundaryIs><LinearRing><coordinates>" +
                                             triangle + "</coordinates><coordinates>" + triangle +
                                             "</coordinates></LinearRing></outerBoundaryIs>"
                                             "</Polygon>"))),
                       "a second `<coordinates>`"));
  EXPECT_TRUE(contains(failure(kml(placemark("<name>pond</name>"))), "a second `<name>`"));
  EXPECT_TRUE(contains(failure(kml("<Placemark><name/><name>pond</name></Placemark>")),
                       "a second `<name>`"));
  EXPECT_TRUE(contains(
      refusal_of(only_area(Format::kml, kml(placemark(polygon(triangle) + polygon(triangle))))),
      "a second geometry of one Placemark, `<Polygon>`"));
  EXPECT_TRUE(contains(failure("<gpx/>"), "the outermost element is `gpx`"));
  EXPECT_TRUE(contains(failure(kml("")), "has no areas"));
}

// A document type could define entities that grow without end.
TEST(Kml, DocumentTypesAreRefused) {
  EXPECT_TRUE(
      contains(failure("<!DOCTYPE kml [<!ENTITY a \"aaaa\">]>" + kml("")), "document type"));
}

TEST(Kml, FaultsOfXmlHaveLineAndColumn) {
  const std::string whole = kml(placemark(polygon(triangle)));
  EXPECT_TRUE(contains(failure(whole.substr(0, whole.size() - 3)), "this is no XML"));
  EXPECT_TRUE(contains(failure("<kml>\n<a></b></kml>"), "line 2, column "));
}

TEST(Kml, LimitsEndInAFailure) {
  std::string deep = "<kml>";
  for (int i = 0; i < 1000; ++i) deep += "<Folder>";
  for (int i = 0; i < 1000; ++i) deep += "</Folder>";
  EXPECT_TRUE(contains(failure(deep + "</kml>"), "nested too deeply"));
  EXPECT_TRUE(contains(failure(kml(""), {.values_max = 3}), "more than 3 elements"));
  EXPECT_TRUE(
      contains(failure(kml(placemark(polygon(triangle))), {.positions_max = 3}), "more than 3"));
}

}  // namespace
}  // namespace rtac::geometry::import
