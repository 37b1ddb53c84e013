// Zones that are there at certain times (language rule 7.4), in runs, which have a time of day:
// UTC, in us since 1970-01-01T00:00Z.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rtac/sim/property.h"
#include "rtac/sim/random.h"
#include "rtac/types.h"

namespace rtac::simulate {

// When one zone is there: from the first moment of a span on, and before its last one.
struct Openings {
  struct Span {
    TimeUs from_us = 0, until_us = 0;
  };
  std::string zone;
  std::vector<Span> once, weekly;  // these since the Monday of a week
  TimeUs lead_us = 0;              // that a decision looks ahead at them
};

// By zone, whether it is there.
std::vector<bool> open_at(const std::vector<Openings>& calendar, TimeUs utc_us);
// When any of them comes or goes, later than one moment and up to another one; in order.
std::vector<TimeUs> changes_between(const std::vector<Openings>& calendar, TimeUs from_us,
                                    TimeUs until_us);

// A property without times, whose zones are there, or not, whatever is worse, where that changes
// between the two moments. No arithmetic but sums and differences is about them.
sim::Property at_its_worst(const sim::Property& property, const std::vector<Openings>& calendar,
                           TimeUs from_us, TimeUs until_us);

// What decisions look ahead at the most.
TimeUs longest_lead_us(const std::vector<Openings>& calendar);

// When a run begins, so that some zone comes or goes within it, later than decisions look ahead and
// before `span_us` more have passed.
TimeUs draw_begin(const std::vector<Openings>& calendar, TimeUs span_us, sim::Random& random);

// "2026-05-01T08:00:00Z", and back, also without seconds; nothing: it is no such moment between
// 1970 and 9999.
std::string utc_text(TimeUs utc_us);
std::optional<TimeUs> utc_of(const std::string& text);

}  // namespace rtac::simulate
