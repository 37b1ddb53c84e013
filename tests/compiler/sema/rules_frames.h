// Rules about frames, space, poses and twists; and about the grid.
#pragma once

#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {

using diag::Code;

// An arm whose base stands somewhere in the map, beside a drone.
inline const std::string& arm() {
  static const std::string text = R"(spec arm;
period 10 ms;
frame base, gps;
grid 0.1 mm, 1 cm/s;
enum Gear { park, drive }
input at : pose of base @ map in -9 .. 9 m, -180 .. 180 deg error 1 cm, 1 deg;
input move : twist in -1 .. 1 m/s, -2 .. 2 rad/s;
input hand : point @ base in -2 .. 2 m;
input goal, rest : point in -9 .. 9 m;
input wind : vector [m/s] @ gps in -9 .. 9 m/s;
input drone, home : point3 in -9 .. 9 m;
input busy : bool;
input gear : Gear;
fun apart(a : point, b : point) : bool = distance(a, b) >= 1 m;
zone  yard @ gps = rectangle (0 m, 0 m) to (5 m, 5 m);
zone  lawn @ gps = yard - circle (2 m, 2 m) radius 1 m;

monitor near { "R1: the hand is near its goal" always distance(transform(at, hand), goal) <= 1 m; }
monitor slow { "R2: it moves slowly" always move.linear <= 0.5 m/s and abs(move.angular) <= 1 rad/s; }
monitor calm { "R3: little wind" always norm(rotate(wind, at.heading)) <= 5 m/s; }
monitor high { "R4: the drone is high up" always drone.z >= 1 m and distance(drone, home) <= 5 m; }
monitor kept { "R5: goal and rest are apart" always apart(goal, rest) and gear == (if busy then drive else park); }
)";
  return text;
}

inline std::vector<Rule> rules_of_frames() {
  std::vector<Rule> rules{
      {"frames_are_not_mixed_in_a_distance",
       {{"transform(at, hand), goal", "hand, goal"}},
       Code::frames_differ,
       "distance(hand, goal)",
       "mixes the frames `base` and `map`",
       "`transform(at, ...)` with `input at : pose of map @ base ...`"},
      {"frames_are_not_mixed_in_a_difference",
       {{"rotate(wind, at.heading)", "wind - (goal - rest)"}},
       Code::frames_differ,
       "-",
       "`-` mixes the frames `gps` and `map`",
       "transform"},
      {"frames_are_not_mixed_in_a_choice",
       {{"transform(at, hand), goal", "goal, if busy then rest else hand"}},
       Code::frames_differ,
       "if busy then rest else hand",
       "`if` mixes the frames `map` and `base`",
       "transform"},
      {"a_function_takes_points_of_its_frame",
       {{"apart(goal, rest)", "apart(goal, hand)"}},
       Code::frames_differ,
       "hand",
       "`apart` takes `b` in `map`, this is in `base`",
       "`transform(at, ...)` with `input at : pose of base ...`"},
      {"a_pose_moves_what_is_in_the_frame_that_it_places",
       {{"transform(at, hand)", "transform(at, rest)"}},
       Code::frames_differ,
       "rest",
       "this pose places `base`, and this is in `map`",
       "transform"},
      {"a_zone_is_made_of_zones_of_its_frame",
       {{"zone  lawn @ gps", "zone  lawn"}},
       Code::frames_differ,
       "yard",
       "the zone `yard` is in the frame `gps`, `map` is due",
       "declare one in `map`"},
      {"an_unknown_frame_suggests_the_nearest",
       {{"point @ base", "point @ bsae"}},
       Code::unknown_frame,
       "bsae",
       "there is no frame `bsae`",
       "did you mean `base`?",
       true},
      {"the_map_is_not_declared",
       {{"frame base", "frame map, base"}},
       Code::duplicate_name,
       "map",
       "the frame `map` always exists",
       "leave it out"},
      {"a_frame_is_no_value",
       {{"move.linear <= 0.5 m/s", "gps <= 0.5 m/s"}},
       Code::quantity_expected,
       "gps",
       "a quantity is due, this is a frame",
       "write"},
      {"a_quantity_has_no_frame",
       {{"busy : bool", "busy : bool @ base"}},
       Code::clause_without_effect,
       "base",
       "the type `bool` has no coordinates in a frame",
       "leave it out"},
      {"a_point_places_no_frame",
       {{"point @ base", "point of gps @ base"}},
       Code::clause_without_effect,
       "gps",
       "the type `point` has no frame that it places",
       "leave it out"},
      {"a_pose_says_what_it_places",
       {{"pose of base @ map", "pose"}},
       Code::clause_missing,
       "pose",
       "the pose has no frame that it places",
       "pose of base"},
      {"a_pose_places_another_frame",
       {{"pose of base @ map", "pose of base @ base"}},
       Code::clause_without_effect,
       "base",
       "this pose places `base` in itself",
       "`pose of base @ map`"},
      {"a_pose_has_two_errors",
       {{"error 1 cm, 1 deg", "error 1 cm"}},
       Code::wrong_argument_count,
       "1 cm",
       "`error` of `at` has 1 entry, a pose of `base` takes 2",
       "write both"},
      {"a_point_has_one_range",
       {{"point @ base in -2 .. 2 m", "point @ base in -2 .. 2 m, -2 .. 2 m"}},
       Code::wrong_argument_count,
       "2 m",
       "`in` of `hand` has 2 entries, a point takes 1",
       "leave the others out"},
      {"the_plane_and_space_are_not_mixed",
       {{"distance(drone, home)", "distance(drone, goal)"}},
       Code::spaces_differ,
       "distance(drone, goal)",
       "`distance` mixes the plane and space",
       "`p.xy`"},
      {"turns_are_of_the_plane",
       {{"rotate(wind, at.heading)", "rotate(drone - home, at.heading)"}},
       Code::spaces_differ,
       "drone - home",
       "`rotate` turns in the plane only",
       "compute the turn outside"},
      {"a_turn_is_by_an_angle",
       {{"rotate(wind, at.heading)", "rotate(wind, 1.5)"}},
       Code::unit_missing,
       "1.5",
       "`1.5` has no unit where an angle (rad) is due",
       "write `1.5 deg` or `1.5 rad`, whichever is meant"},
      {"what_is_no_pose_moves_nothing",
       {{"transform(at, hand)", "transform(hand, goal)"}},
       Code::wrong_argument,
       "hand",
       "`transform` takes a pose, this is a point",
       "pose of base"},
      {"poses_in_space_do_not_exist",
       {{"drone, home : point3", "drone, home : pose3"}},
       Code::unknown_type,
       "pose3",
       "there is no type `pose3`",
       "compute the `point3` or `vector3` outside"},
      {"a_pose_has_a_position_and_a_heading",
       {{"at.heading", "at.angle"}},
       Code::member_unknown,
       "angle",
       "a pose of `base` has no component `angle`",
       "`position` and `heading`"},
      {"values_of_two_enumerations_are_not_chosen_between",
       {{"if busy then drive else park", "if busy then drive else 2"}},
       Code::wrong_operand,
       "if busy then drive else 2",
       "`if` chooses between a value of `Gear` and a number",
       "values of one enumeration"},
      {"arrays_of_arrays_do_not_exist",
       {{"drone, home : point3", "drone, home : point3[2][3]"}},
       Code::limit_exceeded,
       "3",
       "arrays of arrays do not exist",
       "one array with all the elements"},
      {"a_dimension_has_one_grid",
       {{"1 cm/s;", "1 cm/s, 1 mm;"}},
       Code::duplicate_clause,
       "1 mm",
       "a grid for a length (m) stands twice",
       "keep one"},
      {"margins_are_full_once",
       {{"monitor calm {", "monitor calm { margin full; margin full;"}},
       Code::duplicate_clause,
       "margin full;",
       "`margin full` stands twice",
       "keep one"},
  };
  for (Rule& rule : rules) rule.base = arm;
  return rules;
}

}  // namespace rtac::sema::test
