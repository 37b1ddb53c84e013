// Rules about zones that change with time.
#pragma once

#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {

using diag::Code;

// A site with a fair on one day, and a school on some days of every week.
inline const std::string& fairground() {
  static const std::string text = R"(spec fairground;
clock utc;
period 1 s;
zone ground = rectangle (0 m, 0 m) to (90 m, 90 m);
zone fair = circle (20 m, 20 m) radius 9 m during 2026-05-01T08:00Z .. 2026-05-01T18:00Z;
zone school = rectangle (50 m, 50 m) to (60 m, 60 m)
  during monday, friday 07:30 .. 16:00 or sunday 22:00 .. 24:00;
zone lawn = ground - rectangle (1 m, 1 m) to (2 m, 2 m);
robot Rover {
  body radius 0.2 m;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 1 s;
  sense velocity : vector error 1 cm/s max_age 1 s;
  output push : acceleration;
  latency 40 ms;
}
fleet one, two : Rover;
input p : point in 0 .. 90 m;
frame base;
input crane : point in 0 .. 90 m error 5 cm;
input hand : point @ base in 0 .. 90 m;
input masts : point[2] in 0 .. 90 m;
input field : zone[8] max_age inf;
input other : zone[4] max_age inf;
fun far(a : point) : bool = distance(a, fair) >= 1 m;
zone bubble = circle (0 m, 0 m) radius 3 m around crane;
zone escort = rectangle (-1 m, -1 m) to (1 m, 1 m) around one during 08:00 .. 18:00;
monitor near { "R4: with the crane, away from the rover" always p inside bubble and not p inside escort and far(crane); }
monitor kept { "R6: in the field" always p inside field and distance(p, other) >= 1 m and age(field) <= 9 s; }
monitor used { "R5: uses all" always hand.x >= 0 m and masts[0].x >= 0 m and masts[1].x >= 0 m; }
controller pilot : advanced for Rover extern;
controller back : safe for Rover = retreat within ground speed 0.1 m/s;
monitor away { "R1: not at the fair" always not p inside fair and not one inside fair; }
monitor quiet { "R2: away from the school" always distance(p, school) >= 5 m and clearance(p, ground) >= 1 m; }
monitor fence for r : Rover { "R3: on the ground" always r inside ground; recover back; }
decision drive for Rover { advanced pilot; period 100 ms; priority fence; }
)";
  return text;
}

inline std::vector<Rule> rules_of_moments() {
  return {
      {"a_moment_is_in_utc",
       {{"2026-05-01T08:00Z", "2026-05-01T08:00"}},
       Code::moment_invalid,
       "2026-05-01T08:00",
       "is not written in UTC",
       "bring it to UTC"},
      {"a_moment_has_no_offset",
       {{"2026-05-01T08:00Z", "2026-05-01T08:00+02:00"}},
       Code::moment_invalid,
       "2026-05-01T08:00+02:00",
       "is not written in UTC",
       "end in `Z`"},
      {"there_is_no_thirtieth_of_february",
       {{"2026-05-01T08:00Z", "2026-02-30T08:00Z"}},
       Code::moment_invalid,
       "2026-02-30T08:00Z",
       "there is no day 2026-02-30",
       "01 to 28"},
      {"there_is_no_thirteenth_month",
       {{"2026-05-01T08:00Z", "2026-13-01T08:00Z"}},
       Code::moment_invalid,
       "2026-13-01T08:00Z",
       "there is no day 2026-13-01",
       "01 to 12"},
      {"there_is_no_twenty_fifth_hour",
       {{"2026-05-01T18:00Z", "2026-05-01T25:00Z"}},
       Code::moment_invalid,
       "2026-05-01T25:00Z",
       "there is no time of day",
       "00 to 23"},
      {"a_date_does_not_end_at_24",
       {{"2026-05-01T18:00Z", "2026-05-01T24:00Z"}},
       Code::moment_invalid,
       "2026-05-01T24:00Z",
       "there is no time of day",
       "`24:00`"},
      {"nothing_begins_at_24",
       {{"07:30 .. 16:00", "24:00 .. 16:00"}},
       Code::moment_invalid,
       "24:00",
       "there is no time of day",
       "may end at `24:00`"},
      {"the_clock_begins_in_1970",
       {{"2026-05-01T08:00Z", "1969-12-31T08:00Z"}},
       Code::moment_invalid,
       "1969-12-31T08:00Z",
       "before the clock begins",
       "1970-01-01T00:00Z"},
      {"moments_have_all_their_digits",
       {{"07:30", "7:30"}},
       Code::moment_invalid,
       "7:30",
       "is not a moment",
       "`07:30`"},
      {"both_ends_have_a_date_or_none",
       {{"2026-05-01T18:00Z", "18:00"}},
       Code::moment_invalid,
       "2026-05-01T08:00Z .. 18:00",
       "one end has a date, the other has none",
       "two dates"},
      {"a_date_has_its_day_of_the_week",
       {{"during 2026", "during friday 2026"}},
       Code::moment_invalid,
       "friday 2026-05-01T08:00Z .. 2026-05-01T18:00Z",
       "the day of the week of a date is known",
       "two dates"},
      {"days_of_the_week_have_names",
       {{"monday, friday", "monday, frday"}},
       Code::unknown_word,
       "frday",
       "frday",
       "`friday`"},
      {"a_window_ends_behind_its_begin",
       {{"2026-05-01T18:00Z", "2026-05-01T08:00Z"}},
       Code::opening_reversed,
       "2026-05-01T08:00Z .. 2026-05-01T08:00Z",
       "nothing is from",
       "swap"},
      {"a_window_over_midnight_is_two",
       {{"sunday 22:00 .. 24:00", "sunday 22:00 .. 06:00"}},
       Code::opening_reversed,
       "sunday 22:00 .. 06:00",
       "nothing is from 22:00 to 06:00",
       "`22:00 .. 24:00 or 00:00 .. 06:00`"},
  };
}

inline std::vector<Rule> rules_of_carriers() {
  return {
      {"zones_that_move_are_not_combined",
       {{"zone lawn = ground - ", "zone lawn = bubble - "}},
       Code::zone_not_fixed,
       "bubble",
       "the zone `bubble` moves with `crane`",
       "`p inside base and not p inside bubble`"},
      {"robots_do_not_look_ahead_at_zones_that_move",
       {{"r inside ground", "r inside escort"}},
       Code::zone_not_fixed,
       "escort",
       "the zone `escort` moves with `one`",
       "`forall q : Kind, q != r : distance(r, q) >= c` from other robots"},
      {"a_zone_moves_with_a_point",
       {{"around crane", "around masts"}},
       Code::wrong_argument,
       "masts",
       "a zone moves with a point or a robot, this is an array",
       "input of type `point`"},
      {"a_zone_moves_with_something_that_there_is",
       {{"around crane", "around crnae"}},
       Code::unknown_name,
       "crnae",
       "crnae",
       "`crane`"},
      {"a_zone_does_not_move_with_a_zone",
       {{"around crane", "around ground"}},
       Code::wrong_sort,
       "ground",
       "`ground` is a zone",
       ""},
      {"one_robot_has_no_number",
       {{"around one", "around one[1]"}},
       Code::wrong_sort,
       "1",
       "`one` is one robot, not a fleet",
       "write `one`"},
      {"a_zone_is_in_the_frame_of_what_it_moves_with",
       {{"around crane", "around hand"}},
       Code::frames_differ,
       "hand",
       "the zone is in the frame `map`",
       ""},
      {"functions_have_no_zones_that_move",
       {{"distance(a, fair) >= 1 m", "distance(a, bubble) >= 1 m"}},
       Code::function_not_pure,
       "distance(a, bubble)",
       "uses the input `crane`",
       "its arguments alone"},
  };
}

inline std::vector<Rule> rules_of_received() {
  return {
      {"zones_that_are_received_are_not_combined",
       {{"zone lawn = ground - ", "zone lawn = field - "}},
       Code::zone_not_fixed,
       "field",
       "the zone `field` is received while the monitors run",
       "`p inside base and not p inside field`"},
      {"zones_that_are_received_do_not_grow",
       {{"p inside field", "p inside grow(field, 1 m)"}},
       Code::zone_not_fixed,
       "field",
       "is received while the monitors run",
       "by its name"},
      {"zones_that_are_received_have_no_complement",
       {{"p inside field", "p inside complement(field)"}},
       Code::zone_not_fixed,
       "field",
       "is received while the monitors run",
       "by its name"},
      {"robots_in_space_do_not_look_ahead_at_zones_that_are_received",
       {{"position : point", "position : point3"},
        {"velocity : vector", "velocity : vector3"},
        {"around one during", "around crane during"},
        {"not one inside fair", "not crane inside fair"},
        {"r inside ground", "r inside field"}},
       Code::zone_not_fixed,
       "field",
       "is received while the monitors run",
       "monitors without a robot"},
      {"monitors_of_robots_do_not_ask_how_old_such_a_zone_is",
       {{"r inside ground", "r inside ground and age(field) <= 1 s"}},
       Code::zone_not_fixed,
       "field",
       "is received while the monitors run",
       "without `for`"},
      {"recoveries_do_not_stay_in_zones_that_are_received",
       {{"retreat within ground", "retreat within field"}},
       Code::zone_not_fixed,
       "field",
       "is received while the monitors run",
       "monitors without a robot"},
      {"a_zone_that_is_received_has_a_size",
       {{"zone[8]", "zone"}},
       Code::clause_missing,
       "zone",
       "the zone has no most edges",
       "`zone[64]`"},
      {"a_zone_that_is_received_has_three_edges",
       {{"zone[8]", "zone[2]"}},
       Code::quantity_out_of_range,
       "2",
       "the most edges of a zone",
       "3"},
      {"a_zone_that_is_received_has_no_error",
       {{"zone[8]", "zone[8] error 1 m"}},
       Code::clause_without_effect,
       "1 m",
       "an error has no effect on `field`, which is a zone",
       "leave it out"},
      {"a_zone_that_is_received_is_no_quantity",
       {{"p inside field", "field >= 1 m"}},
       Code::quantity_expected,
       "field",
       "a zone",
       ""},
      {"functions_take_no_zones",
       {{"fun far(a : point)", "fun far(a : zone[8])"}},
       Code::wrong_argument,
       "zone[8]",
       "only an input is of type `zone`",
       "`p inside fence`"},
      {"functions_have_no_zones_that_are_received",
       {{"distance(a, fair) >= 1 m", "distance(a, field) >= 1 m"}},
       Code::function_not_pure,
       "field",
       "uses the input `field`",
       "its arguments alone"},
      {"a_zone_that_is_received_is_in_its_frame",
       {{"zone[8]", "zone[8] @ base"}},
       Code::frames_differ,
       "field",
       "the zone `field` is in the frame `base`",
       ""},
  };
}

inline std::vector<Rule> rules_of_openings() {
  std::vector<Rule> rules = {
      {"windows_need_a_clock",
       {{"clock utc;\n", ""}},
       Code::clock_missing,
       "2026-05-01T08:00Z .. 2026-05-01T18:00Z",
       "windows of time need a clock in UTC",
       "`clock utc;`",
       true},
      {"there_is_one_clock",
       {{"clock utc;", "clock utc;\nclock utc;"}},
       Code::duplicate_clause,
       "clock utc;",
       "`clock` stands twice",
       "keep one"},
      {"there_is_no_other_clock",
       {{"clock utc;", "clock local;"}},
       Code::unknown_word,
       "local",
       "there is no clock `local`",
       "`clock utc;`"},
      {"zones_are_not_made_of_those_that_change",
       {{"zone lawn = ground - ", "zone lawn = fair - "}},
       Code::zone_not_fixed,
       "fair",
       "the zone `fair` is there at certain times only",
       "`p inside base and not p inside fair`"},
      {"zones_that_change_do_not_grow",
       {{"p inside fair", "p inside grow(fair, 1 m)"}},
       Code::zone_not_fixed,
       "fair",
       "at certain times only",
       "by its name"},
      {"recoveries_stay_in_zones_that_stay",
       {{"retreat within ground", "retreat within fair"}},
       Code::zone_not_fixed,
       "fair",
       "at certain times only",
       "monitors without a robot"},
      {"an_endless_distance_is_compared",
       {{"distance(p, school) >= 5 m", "min[0 s, 3 s](distance(p, school)) >= 5 m"}},
       Code::zone_not_fixed,
       "distance(p, school)",
       "the distance from `school` is endless",
       "`historically`"},
      {"the_least_of_an_endless_distance_is_not_compared",
       {{"distance(p, school) >= 5 m", "min(distance(p, school), 9 m) >= 5 m"}},
       Code::zone_not_fixed,
       "distance(p, school)",
       "endless",
       "`distance(p, school) >= 5 m`"},
      {"two_endless_distances_are_not_compared",
       {{"distance(p, school) >= 5 m", "distance(p, school) >= distance(p, fair)"}},
       Code::zone_not_fixed,
       "distance(p, school)",
       "endless",
       "compare it where it stands"},
  };
  for (Rule& rule : rules_of_moments()) rules.push_back(std::move(rule));
  for (Rule& rule : rules_of_carriers()) rules.push_back(std::move(rule));
  for (Rule& rule : rules_of_received()) rules.push_back(std::move(rule));
  for (Rule& rule : rules) rule.base = fairground;
  return rules;
}

}  // namespace rtac::sema::test
