// A fence is uploaded while the monitors run: another thread makes its tables, this one takes them
// between two ticks. An invalid fence is refused, and the one before stays.
#include <cstdio>
#include <string>
#include <thread>
#include <utility>

#include "rtac/geometry/zone_maker.h"
#include "uploaded_fence.h"

namespace {

using Monitors = uploaded_fence::Monitors;
constexpr std::size_t edges_most = Monitors::fence_edges_most;
static_assert(edges_most == Monitors::closed_edges_most);

// A fence in metres as well-known text, or a plan as QGroundControl saves it.
rtac::MadeZone zone_of(const std::string& text) {
  if (text.front() != '{') return rtac::make_zone_of_wkt(text, edges_most);
  rtac::ZoneFile plan;
  plan.format = rtac::ZoneFormat::qgc_plan;
  plan.origin_latitude_deg = Monitors::origin_latitude_deg;
  plan.origin_longitude_deg = Monitors::origin_longitude_deg;
  return rtac::make_zone_of_file(text, plan, edges_most);
}

// What the thread that listens to the operator does.
void upload(const std::string& text, rtac::TimeUs received_us, rtac::ZoneSlot& slot) {
  rtac::MadeZone made = zone_of(text);
  if (const auto* why = std::get_if<rtac::ZoneRefusal>(&made)) {
    std::printf("refused: %s %s; %s\n", why->where.c_str(), why->message.c_str(),
                why->help.c_str());
    return;
  }
  slot.publish(std::move(std::get<std::unique_ptr<rtac::HeldZone>>(made)), received_us);
}

struct Upload {
  int tick;
  const char* text;
};
constexpr Upload uploads[] = {
    {5, "POLYGON ((0 0, 100 0, 100 60, 0 60, 0 0))"},
    {40, "POLYGON ((0 0, 50 50, 50 0, 0 50, 0 0))"},  // crosses itself
    {60, "POLYGON ((0 0, 70 0, 70 60, 0 60, 0 0))"},
    {80, R"({"fileType": "Plan", "version": 1, "geoFence": {"version": 2, "circles": [],
           "polygons": [{"inclusion": true, "version": 1, "polygon":
             [[47.3977, 8.5456], [47.3977, 8.5470], [47.3983, 8.5470], [47.3983, 8.5456]]}]}})"},
};

}  // namespace

int main() {
  rtac::ZoneSlot fences, closures;
  upload("POLYGON ((20 40, 30 40, 30 50, 20 50, 20 40))", 0, closures);
  Monitors monitors;
  rtac::Verdict before = rtac::Verdict::is_true;
  for (int tick = 0; tick < 100; ++tick) {
    const rtac::TimeUs now_us = tick * rtac::TimeUs{100'000};
    for (const Upload& each : uploads) {
      // A robot would not wait for it; this run is the same each time.
      if (each.tick == tick) std::thread([&] { upload(each.text, now_us, fences); }).join();
    }
    fences.offer([&](const rtac::ZoneTable& table, rtac::TimeUs stamp_us) {
      return monitors.fence(table, stamp_us);
    });
    closures.offer([&](const rtac::ZoneTable& table, rtac::TimeUs stamp_us) {
      return monitors.closed(table, stamp_us);
    });
    const double x = 10 + 0.8 * tick;  // eastwards, at 8 m/s
    monitors.p({rtac::Length(x), rtac::Length(30)}, now_us);
    const rtac::Finding& stays = monitors.step(now_us)[Monitors::stays_index];
    if (stays.verdict == before) continue;
    before = stays.verdict;
    const char* const words[] = {"false", "unknown", "true"};
    std::printf("%.1f s, x = %.1f m: %s%s\n", static_cast<double>(now_us) / 1e6, x,
                words[static_cast<int>(stays.verdict)],
                *stays.input != '\0' ? (std::string(", no ") + stays.input).c_str() : "");
  }
  return 0;
}
