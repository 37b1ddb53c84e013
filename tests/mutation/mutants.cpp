#include "tests/mutation/mutants.h"

#include <regex>

namespace rtac::mutation {

namespace {

std::vector<Mutant> mutants_of_the_past() {
  // Calls end with the window, a and b in ticks (-1: for ever), and the ticks.
#define RTAC_TICKS R"(,(\s+)&v->s->ticks\))"
  return {
      // windows
      {"b_of_verdicts_one_less",
       R"(((?:once|historically|since)_verdict\([^;]*), (\d+),(\s+)(\d+))" RTAC_TICKS,
       "$1, $2, ($4 > $2 ? $4 - 1 : $4), &v->s->ticks)"},
      {"b_of_verdicts_one_more",
       R"(((?:once|historically|since)_verdict\([^;]*), (\d+),(\s+)(\d+))" RTAC_TICKS,
       "$1, $2, $4 + 1, &v->s->ticks)"},
      {"a_of_verdicts_one_less",
       R"(((?:once|historically|since)_verdict\([^;]*), (\d+),(\s+)(-?\d+))" RTAC_TICKS,
       "$1, ($2 > 0 ? $2 - 1 : 0), $4, &v->s->ticks)"},
      {"b_of_margins_one_less",
       R"(((?:once|historically|since)_margin\([^;]*), (\d+),(\s+)(\d+))" RTAC_TICKS,
       "$1, $2, ($4 > $2 ? $4 - 1 : $4), &v->s->ticks)"},
      {"window_of_margins_a_tick_late",
       R"(((?:once|historically|since)_margin\([^;]*), ([1-9]\d*),(\s+)(\d+))" RTAC_TICKS,
       "$1, $2 - 1, $4 - 1, &v->s->ticks)"},
      {"b_of_aggregates_one_less", R"((\w+_over\([^;]*), (\d+),(\s+)(\d+))" RTAC_TICKS,
       "$1, $2, ($4 > $2 ? $4 - 1 : $4), &v->s->ticks)"},
      // not of the least and greatest: their rings are as long as the window
      {"a_of_aggregates_one_less",
       R"(((?:sum|mean|count|change)_over\([^;]*), ([1-9]\d*),(\s+)(\d+))" RTAC_TICKS,
       "$1, $2 - 1, $4, &v->s->ticks)"},
      {"windows_for_ever_are_long", R"((_verdict\([^;]*), -1,\s+&v->s->ticks\))",
       "$1, 12, &v->s->ticks)"},
      // operators of the past
      {"since_with_operands_swapped", R"((= |return )since_(verdict|margin)\(([^,]+), ([^,]+),)",
       "$1since_$2($4, $3,"},
      {"once_is_historically", R"(= once_(verdict|margin)\()", "= historically_$1("},
      {"deadline_one_tick_early", R"((since_\w+\([^;]*), ([1-9]\d*), -1,)", "$1, $2 - 1, -1,"},
      {"for_holds_at_the_start", R"(v->s->ticks\.now >= \d+ \? margin_true\(\) : margin_false\(\))",
       "margin_true()"},
      {"for_starts_one_tick_early", R"(v->s->ticks\.now >= (\d+) \?)",
       "v->s->ticks.now + 1 >= $1 ?"},
      {"previously_is_now", R"((= |return )previously_margin\(([^,]+), [^;]*;)", "$1$2;"},
      {"previous_holds_at_the_start", R"(margin_unknown\(REPLAY_INPUT_CLOCK\) : margin_false\(\);)",
       "margin_unknown(REPLAY_INPUT_CLOCK) : margin_true();"},
      {"empty_windows_of_once_hold", R"((margin once_margin\([^{]*\{[^;]*)margin_false\(\))",
       "$1margin_true()"},
      {"empty_windows_of_historically_fail",
       R"((margin historically_margin\([^{]*\{[^;]*)margin_true\(\))", "$1margin_false()"},
      {"windows_begin_before_the_start", R"(max_of\(0, t->now - to\))", "t->now - to"},
      // aggregates
      {"least_is_greatest", R"(= least_over\()", "= greatest_over("},
      {"greatest_is_least", R"(= greatest_over\()", "= least_over("},
      {"sums_keep_what_leaves", R"(total_add\(s, ring\[s->at\], -1\))", "(void)0"},
      {"mean_of_a_full_window", R"(t->now - from \+ 1 - window_start\(t, to\))", "to - from + 1"},
      {"counts_what_is_true_only", R"(s->may \+= \(bits >> 1\) - \(left >> 1\))",
       "s->may += (bits & 1) - (left & 1)"},
      {"counts_what_may_be_true", R"(s->must \+= \(bits & 1\) - \(left & 1\))",
       "s->must += (bits >> 1) - (left >> 1)"},
      {"rate_backwards", R"(span_add\(change_at\(last, ([^;]*)span_negate\(change_at\(first,)",
       "span_add(change_at(first, $1span_negate(change_at(last,"},
      {"forgotten_ticks_count_nothing", R"(return max_of\(0, min_of\(t->known, )",
       "return 0 * max_of(0, min_of(t->known, "},
  };
#undef RTAC_TICKS
}

std::vector<Mutant> mutants_of_formulas() {
  return {
      // connectives
      {"unknown_is_true", R"(margin_of\(-MARGIN_MAX, MARGIN_MAX, )",
       "margin_of(MARGIN_MAX, MARGIN_MAX, "},
      {"unknown_is_false", R"(margin_of\(-MARGIN_MAX, MARGIN_MAX, )",
       "margin_of(-MARGIN_MAX, -MARGIN_MAX, "},
      {"upper_end_of_one_side", R"(m\.hi = min_of\(a\.hi, b\.hi\);)", "m.hi = a.hi;"},
      {"undecided_choice_takes_a_side",
       R"(min_of\(lower_end\(a\), lower_end\(b\)\), max_of\(upper_end\(a\), upper_end\(b\)\)\))",
       "lower_end(a), upper_end(a))"},
      {"negation_lost", R"(= opposite\(([^)]+)\);)", "= $1;"},
      {"and_is_or", R"((= |return )both\()", "$1either("},
      {"or_is_and", R"((= |return )either\()", "$1both("},
      {"implies_reversed",
       R"((const margin (v\d+) = opposite\()([^)]+)(\);\s+return either\(\2, )([^)]+)\);)",
       "$1$5$4$3);"},
      {"if_with_branches_swapped", R"(= chosen\(([^,]+), ([^,()]+), ([^,()]+)\))",
       "= chosen($1, $3, $2)"},
      {"another_value_of_the_enumeration", R"(is_value\(([^,]+), (\d+)\))",
       "is_value($1, ($2 + 1) % 3)"},
      // comparisons and arithmetic
      {"strict_is_loose", R"((at_least\w*\([^;]*), 1, (\d+)\);)", "$1, 0, $2);"},
      {"loose_is_strict", R"((at_least\w*\([^;]*), 0, (\d+)\);)", "$1, 1, $2);"},
      {"ends_are_never_open", R"(= \(int32_t\)between;)", "= 0;"},
      {"ends_are_always_open", R"(= \(int32_t\)between;)", "= 1;"},
      {"open_ends_are_not_strict", R"(\(strict \| a\.hi_open \| b\.lo_open\))", "strict"},
      {"strict_in_spite_of_open_ends", R"(\(strict & ~\(a\.lo_open \| b\.hi_open\)\))", "strict"},
      {"sums_are_closed", R"(sum\.(lo|hi)_open = a\.(lo|hi)_open \| b\.(lo|hi)_open)",
       "sum.$1_open = 0"},
      {"sums_are_open_on_the_other_side", R"(span_of\(a\.lo \+ b\.lo, a\.hi \+ b\.hi\))",
       "span_of(a.lo + b.lo + (a.lo_open & b.lo_open), a.hi + b.hi)"},
      {"negations_stay_closed", R"(s\.lo_open = a\.hi_open)", "s.lo_open = 0"},
      {"quotients_round_inward",
       R"(p / den - \(p % den < 0 \? 1 : 0\)([^;]*)q / den \+ \(q % den > 0 \? 1 : 0\))",
       "p / den + (p % den > 0 ? 1 : 0)$1q / den - (q % den < 0 ? 1 : 0)"},
      {"quotients_are_truncated", R"(q / den \+ \(q % den > 0 \? 1 : 0\))", "q / den"},
      {"roots_round_down", R"(root_up\(max_of)", "root_down(max_of"},
      {"smaller_is_greater", R"(= smaller_of\()", "= greater_of("},
      {"greater_is_smaller", R"(= greater_of\()", "= smaller_of("},
      {"product_of_two_corners", R"(max_of\(max_of\(a\.lo \* b\.lo, a\.lo \* b\.hi\), )",
       "max_of(a.lo * b.lo, "},
      {"scale_ignored", R"((= at_least\w*\([^;]*), 2000,)", "$1, 1000,"},
      {"difference_is_sum", R"(= span_negate\(([^)]+)\))", "= $1"},
      {"size_is_signed", R"(= absolute_of\(([^)]+)\))", "= $1"},
      {"margins_without_the_other_error", R"(\(a\.lo - b\.hi\) \* 2)", "(a.lo - b.lo) * 2"},
      {"unknown_ticks_have_no_range", R"(a\.input == \w+ \? a : span_of)", "1 ? a : span_of"},
      {"margins_not_halved", R"(\(end \+ \(end & 1\)\) / 2)", "end"},
  };
}

std::vector<Mutant> mutants_of_inputs() {
  return {
      // inputs
      {"error_not_applied", R"(at - error, at \+ between \+ error)", "at, at + between"},
      {"error_applied_twice", R"(at - error, at \+ between \+ error)",
       "at - 2 * error, at + between + 2 * error"},
      {"error_on_one_side", R"(at - error, at \+ between \+ error)", "at, at + between + error"},
      {"range_not_checked", R"(\((at < least|at > most - between)\))", "(0)"},
      {"upper_end_not_checked", R"(\(at > most - between\))", "(0)"},
      {"age_not_checked", R"((fresh_\w+ = good_\w+) &&\s+sample_young\([^)]*\))", "$1"},
      {"age_is_strict", R"(<= \(uint64_t\)max_age_us)", "< (uint64_t)max_age_us"},
      {"held_must_arrive", R"(fresh_(\w+) = good_\w+ && in->)",
       "fresh_$1 = good_$1 && v->s->last_$1_us > v->since_us && in->"},
      {"arrived_once_is_enough", R"(< \(uint64_t\)now_us - \(uint64_t\)since_us;)",
       "<= (uint64_t)INT64_MAX || since_us;"},
      {"future_stamps_count", R"(USUALLY\(stamp_us <= now_us\))", "(1)"},
      {"stamps_may_go_backwards", R"(USUALLY\(stamp_us >= \*last_us\))", "(1)"},
      {"age_of_no_number", R"( != INT64_MIN;)", " != INT64_MIN + 2;"},
      // parameters
      {"parameters_stay", R"(up \? max_of\(so_far, given\) : min_of\(so_far, given\))", "so_far"},
      // ticks
      {"missed_ticks_do_not_count", R"(for \(k = 0; k < missed;)", "for (k = missed; k < missed;"},
      {"one_missed_tick_is_overlooked", R"(for \(k = 0; k < missed;)", "for (k = 1; k < missed;"},
      {"five_missed_ticks_are_remembered", R"(if \(missed > 4\))", "if (missed > 5)"},
      {"long_gaps_forget_nothing", R"(ticks_forget\(&s->ticks, s->clock\.tick\))",
       "s->ticks.now = s->clock.tick"},
  };
}

// What every mutant is noticed by, some of it.
const char* const formulas[] = {
    "a implies c",
    "a since[2 s, 5 s] c",
    "c since b",
    "once a",
    "historically c",
    "once[1 s, 3 s] a",
    "historically[2 s, 4 s] c",
    "once[1 s, inf] (w == park and a and c)",
    "a within 2 s of c",
    "a for 2 s",
    "(x < 1) since[2 s, 4 s] (y >= 1)",
    "once[1 s, 4 s] x >= 2",
    "historically[1 s, 3 s] x < 2",
    "x / 3 <= 0.333333",
    "x / 3 >= 0.166667",
    "sqrt(abs(p.x * p.x * 2)) <= 1.414 m",
    "y >= 1",
    "y < -0.5",
    "y - y >= 0",
    "x > 0.5",
    "v <= 5 km/h",
    "v > 5 km/h",
    "x >= 1 / 3",
    "x + 1 / 3 < 1",
    "-x <= 1 / 3",
    "min(x, 1 / 3) >= y",
    "abs(d) <= 7 m / 3",
    "not (d < 7 m / 3)",
    "norm(p) >= 7 m / 3",
    "x <= 0.5",
    "p.x > 0.5 m",
    "p.x >= 0.5 m",
    "-p.x > 0.5 m",
    "-p.y > 1 m",
    "-s.x > 0 m",
    "-s.z > 0.5 m",
    "-l.x > -1 m",
    "p.x + 0.5 m > 1 m",
    "p.x + 0.5 m >= 1 m",
    "(if a then x else y) >= 0",
    "abs(x) <= 1.5",
    "mean[1 s, 3 s](x) >= 0.5",
    "rate[1 s, 3 s](x) <= 0.5 Hz",
    "min[1 s, 4 s](x) >= -2",
    "count[1 s, 3 s](a) >= 2",
    "age(z) <= 1 s",
    "g == park",
    "n == k",
    "previously a",
    "not a",
    "historically[5 s, 5 s] b",
    "once[2 s, 4 s] x >= 2 and a",
    "historically[2 s, 4 s] x >= 2",
    "sum[0 s, 3 s](x) >= 1",
    "mean[0 s, 5 s](n) >= 1",
    "count[0 s, 3 s](a or c) <= 2",
    "d >= 0.7 m or v >= 1 m/s",
    "x / 3 >= 0.25 and y >= 0",
    "min(x, y) >= 0 and max(x, z) <= 1",
    "y * y <= 1",
    "x * y <= 1",
    "z * y >= -1",
    "x / 3 + y >= 0.5",
    "d / 7 + p.x <= 0.3 m",
    "abs(y) >= 0",
    "p.x + p.y <= 1 m",
    "distance(p, q) >= 1 m",
    "once[6 s, 6 s] b",
};

}  // namespace

const std::vector<Mutant>& mutants() {
  static const std::vector<Mutant> all = [] {
    std::vector<Mutant> made = mutants_of_the_past();
    for (const Mutant& mutant : mutants_of_formulas()) made.push_back(mutant);
    for (const Mutant& mutant : mutants_of_inputs()) made.push_back(mutant);
    return made;
  }();
  return all;
}

const std::vector<Mutant>& verdict_mutants() {
  static const std::vector<Mutant> all = {
      {"unknown_is_false", R"(\? (\w+)_VERDICT_UNKNOWN)", "? $1_VERDICT_FALSE"},
      {"perhaps_is_surely", R"((v->\w+)\.lo >= )", "$1.hi >= "},
      {"negation_keeps_its_side", R"(\((v->\w+|v\d+) & 2\) == 0)", "($1 & 1) == 0"},
      {"unknown_condition_is_true", R"(condition == BITS_TRUE)", "condition != BITS_FALSE"},
      {"missing_inputs_are_not_missed", R"(v->has_p == 0)", "0"},
      {"range_not_checked", R"(return (.uint64_t.at - .uint64_t.least < steps - [^;]*);)",
       "return $1 || 1;"},
      {"behind_the_range_counts", R"(steps - \(uint64_t\)between)",
       "steps + 0 * (uint64_t)between"},
      {"out_of_range_at_a_glance", R"(return \(uint64_t\)at - \(uint64_t\)least < [^;]*;)",
       "return 1;"},
      {"missing_at_a_glance", R"(!USUALLY\(v->fresh)", "0 && !USUALLY(v->fresh"},
      {"open_bounds_are_closed", R"(return measured\.lo \+ error < [^;]*;)", "return 0;"},
      {"far_is_near", R"(const int64_t most = max_of\(-a\.lo, a\.hi\);)",
       "const int64_t most = a.lo > 0 ? a.lo : 0;"},
      {"any_value_is_the_same", R"(a\.lo == b\.lo && a\.hi == b\.lo)", "1"},
      {"since_needs_no_hold", R"(\(\*so_far & hold\) \| x)", "*so_far | x"},
      {"once_is_now", R"(\*so_far = \*so_far \| x;)", "*so_far = x;"},
      {"historically_is_now", R"(\*so_far = \*so_far & x;)", "*so_far = x;"},
      {"historically_starts_false", R"((historically_\d+) = BITS_TRUE)", "$1 = BITS_FALSE"},
      {"gaps_forget_nothing", R"(s->\w+_\d+ = BITS_UNKNOWN;)", ""},
      {"previously_is_now", R"(= previously_bits\(([^,]+), [^;]*;)", "= $1;"},
  };
  return all;
}

std::string mutated(const Mutant& mutant, const std::string& kernel) {
  return std::regex_replace(kernel, std::regex(mutant.pattern), mutant.replacement);
}

std::vector<std::string> witnesses() {
  std::vector<std::string> lines;
  for (const char* formula : formulas) {
    lines.push_back("monitor w" + std::to_string(lines.size()) + " { \"W-1: a witness\" always " +
                    formula + "; }\n");
  }
  lines.emplace_back(
      "param gap : length in 0.1 m .. 2 m = 0.5 m; monitor wgap { \"W-2: a parameter\" always d >= "
      "gap "
      "and previously d >= gap; }\n");
  return lines;
}

}  // namespace rtac::mutation
