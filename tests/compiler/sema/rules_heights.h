// Rules about zones with height.
#pragma once

#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {

using diag::Code;

// A corridor in the air, a hangar, and a zone that moves with another aircraft.
inline const std::string& airspace() {
  static const std::string text = R"(spec airspace;
period 1 s;
zone field = rectangle (0 m, 0 m) to (90 m, 90 m);
zone corridor = prism (field) from 10 m to 50 m;
zone hangar = rectangle (1 m, 1 m, -2 m) to (9 m, 9 m, 12 m);
zone air = corridor - hangar;
zone deep = prism (shrink(field, 1 m)) from -9 m to -5 m;
zone bubble = rectangle (-1 m, -1 m, -1 m) to (1 m, 1 m, 1 m) around other;
robot Rover {
  body radius 0.2 m;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 1 s;
  sense velocity : vector error 1 cm/s max_age 1 s;
  output push : acceleration;
  latency 40 ms;
}
fleet one : Rover;
input at, other : point3 in -90 .. 90 m;
input spot : point in -90 .. 90 m;
monitor kept { "R1: in free air" always at inside air or at inside deep; }
monitor away { "R2: away from the other" always distance(at, bubble) >= 1 m; }
monitor flat { "R3: in the field" always spot inside field and one inside field; }
monitor clear { "R4: clear of the complement" always clearance(at, complement(air)) <= 0 m; }
controller pilot : advanced for Rover extern;
controller back : safe for Rover = retreat within field speed 0.1 m/s;
monitor kept_in for r : Rover { "R5: in the field" always r inside field; recover back; }
decision drive for Rover { advanced pilot; period 50 ms; priority kept_in; }
)";
  return text;
}

inline std::vector<Rule> rules_of_heights() {
  return {
      {"a_prism_is_not_upside_down",
       {{"from 10 m to 50 m", "from 50 m to 10 m"}},
       Code::band_inverted,
       "prism (field) from 50 m to 10 m",
       "upside down: its floor is at 50 m, its ceiling at 10 m",
       "`from 10 m to 50 m`",
       false,
       airspace},
      {"a_prism_has_height",
       {{"from -9 m to -5 m", "from -9 m to -9 m"}},
       Code::band_inverted,
       "prism (shrink(field, 1 m)) from -9 m to -9 m",
       "no height",
       "two different heights",
       false,
       airspace},
      {"a_height_is_a_length",
       {{"from 10 m to 50 m", "from 10 s to 50 m"}},
       Code::wrong_dimension,
       "10 s",
       "a length (m) is due, this is a time",
       "in m",
       false,
       airspace},
      {"a_prism_stands_on_a_zone_of_the_plane",
       {{"prism (field)", "prism (hangar)"}},
       Code::spaces_differ,
       "hangar",
       "`hangar` has height, the base of a prism has none",
       "a zone of the plane",
       false,
       airspace},
      {"a_box_has_a_volume",
       {{"(9 m, 9 m, 12 m)", "(9 m, 9 m, -2 m)"}},
       Code::rectangle_degenerate,
       "rectangle (1 m, 1 m, -2 m) to (9 m, 9 m, -2 m)",
       "both corners have z = -2 m",
       "all three",
       false,
       airspace},
      {"corners_of_a_box_have_three_coordinates",
       {{"(9 m, 9 m, 12 m)", "(9 m, 9 m)"}},
       Code::point_expected,
       "(9 m, 9 m)",
       "a corner of a box is a point of space",
       "(1 m, 2 m, 3 m)",
       false,
       airspace},
      {"a_box_of_the_plane_is_one_mistake",
       {{"field = rectangle (0 m, 0 m)", "field = box (0 m, 0 m)"}},
       Code::point_expected,
       "box (0 m, 0 m) to (90 m, 90 m)",
       "a box has corners in space",
       "`rectangle`",
       true,
       airspace},
      {"zones_of_plane_and_space_are_not_joined",
       {{"corridor - hangar", "corridor - field"}},
       Code::spaces_differ,
       "-",
       "with height is joined to one of the plane",
       "`prism (field) from 0 m to 50 m`",
       false,
       airspace},
      {"a_point_of_space_is_in_no_zone_of_the_plane",
       {{"at inside air", "at inside field"}},
       Code::spaces_differ,
       "field",
       "a point of space is held against a zone of the plane",
       "`.xy`",
       false,
       airspace},
      {"a_point_of_the_plane_is_in_no_zone_with_height",
       {{"spot inside field", "spot inside air"}},
       Code::spaces_differ,
       "air",
       "held against a zone with height",
       "`point3`",
       false,
       airspace},
      {"a_robot_by_name_is_in_no_zone_with_height",
       {{"one inside field", "one inside air"}},
       Code::spaces_differ,
       "air",
       "held against a zone with height",
       "robots move in the plane",
       false,
       airspace},
      {"a_robot_is_in_no_zone_with_height",
       {{"r inside field", "r inside air"}},
       Code::spaces_differ,
       "air",
       "`air` has height, a robot has none",
       "a zone of the plane",
       false,
       airspace},
      {"a_robot_is_in_no_prism",
       {{"r inside field", "r inside prism (field) from 0 m to 1 m"}},
       Code::spaces_differ,
       "prism (field) from 0 m to 1 m",
       "the zone has height, a robot has none",
       "a zone of the plane",
       false,
       airspace},
      {"no_recovery_stays_in_a_zone_with_height",
       {{"retreat within field", "retreat within air"}},
       Code::spaces_differ,
       "air",
       "`air` has height",
       "a zone of the plane",
       false,
       airspace},
      {"a_zone_with_height_moves_with_a_point_of_space",
       {{"around other", "around spot"}},
       Code::wrong_argument,
       "spot",
       "moves with a point of space",
       "`point3`",
       false,
       airspace},
      {"a_zone_with_height_moves_with_no_robot",
       {{"around other", "around one"}},
       Code::spaces_differ,
       "one",
       "moves in the plane",
       "`point3`",
       false,
       airspace},
  };
}

}  // namespace rtac::sema::test
