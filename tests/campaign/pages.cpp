#include "pages.h"

#include <algorithm>
#include <initializer_list>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace rtac::campaign {
namespace {

// The distributions of the standard library differ between machines; the engine does not.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : bits_(seed) {}
  int from(int least, int most) {
    return least + static_cast<int>(bits_() % static_cast<std::uint64_t>(most - least + 1));
  }
  bool one_in(int n) { return from(1, n) == 1; }
  const char* of(std::initializer_list<const char*> words) {
    return words.begin()[from(0, static_cast<int>(words.size()) - 1)];
  }
  int of(std::initializer_list<int> numbers) {
    return numbers.begin()[from(0, static_cast<int>(numbers.size()) - 1)];
  }
  std::string between(int least, int most, const char* unit) {
    return std::to_string(from(least, most)) + " " + unit;
  }
  std::string tenths(int least, int most, const char* unit) {
    return "0." + std::to_string(from(least, most)) + " " + unit;
  }
  template <typename T>
  void shuffle(std::vector<T>& all) {
    for (std::size_t n = all.size(); n > 1; --n) {
      std::swap(all[n - 1], all[static_cast<std::size_t>(from(0, static_cast<int>(n) - 1))]);
    }
  }

 private:
  std::mt19937_64 bits_;
};

std::string place(int x_cm, int y_cm) {
  return "(" + std::to_string(x_cm) + " cm, " + std::to_string(y_cm) + " cm)";
}

std::string rectangle(int x_cm, int y_cm, int to_x_cm, int to_y_cm) {
  return "rectangle " + place(x_cm, y_cm) + " to " + place(to_x_cm, to_y_cm);
}

std::string polygon(const std::vector<std::pair<int, int>>& outline_cm) {
  std::string text = "polygon [";
  for (const auto& [x, y] : outline_cm) {
    text += (text.back() == '[' ? "" : ", ") + place(x, y);
  }
  return text + "]";
}

class Page {
 public:
  explicit Page(std::uint64_t seed)
      : draw_(seed),
        size_cm_(draw_.of({600, 1000, 1600})),
        unicycle_(draw_.one_in(2)),
        robots_(draw_.of({1, 1, 1, 2, 3})),
        battery_(draw_.one_in(3)),
        agent_(draw_.one_in(5)),
        seed_(seed) {}

  std::string text() {
    std::string page = "spec page_" + std::to_string(seed_) + ";\n" + zones() + robot() + company();
    page += monitors();
    return page;
  }

 private:
  std::string zones() {
    const int s = size_cm_;
    std::string room;
    switch (draw_.from(0, 6)) {
      case 0:
        room = polygon({{0, 0}, {2 * s, 0}, {2 * s, s}, {s, s}, {s, 2 * s}, {0, 2 * s}});
        break;
      case 1:
        room = polygon({{0, 0}, {2 * s, draw_.from(0, s / 2)}, {draw_.from(0, s), 2 * s}});
        break;
      case 2:
        room = polygon({{0, 0}, {s, -draw_.from(s / 3, s)}, {2 * s, 0}, {s, draw_.from(s / 3, s)}});
        break;
      case 3:
        room = rectangle(0, 0, 2 * s, s) + " - circle " + place(s, s / 2) + " radius " +
               draw_.between(20, 80, "cm");
        break;
      case 4:
        room = rectangle(0, s / 2, 2 * s, s) + " | " + rectangle(s / 2, 0, s, 2 * s);
        break;
      default:
        room = rectangle(0, 0, draw_.from(s, 2 * s), s);
    }
    const int x = draw_.from(s / 4, s), y = draw_.from(s / 4, s);
    const std::string pond =
        draw_.one_in(2) ? rectangle(x, y, x + draw_.from(20, s / 4), y + draw_.from(20, s / 4))
                        : "circle " + place(x, y) + " radius " + draw_.between(20, s / 8, "cm");
    berth_cm_ = draw_.from(5, 60);
    return "zone room = " + room + ";\nzone pond = " + pond + ";\nzone dry = room - grow(pond, " +
           std::to_string(berth_cm_ + draw_.of({0, 1, 5, 20})) + " cm);\n";
  }

  std::string robot() {
    period_ms_ = draw_.of({20, 50, 100, 200});
    std::string text = "robot Bot {\n  body radius " + draw_.between(3, 30, "cm") + ";\n  motion ";
    if (unicycle_) {
      text += "unicycle { speed <= " + draw_.between(50, 150, "cm/s") +
              "; turn <= " + draw_.between(1, 3, "rad/s") +
              "; accel <= " + draw_.between(30, 200, "cm/s^2") +
              "; brake >= " + draw_.between(30, 200, "cm/s^2") +
              "; turn_accel <= " + draw_.between(2, 10, "rad/s^2") + "; }\n";
    } else {
      text += "point { speed <= " + draw_.between(50, 200, "cm/s") +
              "; accel <= " + draw_.between(50, 300, "cm/s^2") +
              "; brake >= " + draw_.between(80, 300, "cm/s^2") + ";" +
              (draw_.one_in(3) ? " disturbance <= " + draw_.between(1, 12, "cm/s^2") + ";" : "") +
              " }\n";
    }
    const std::string age = " max_age " + std::to_string(draw_.of({20, 50, 100})) + " ms;\n";
    text += "  sense position : point error " + draw_.between(0, 50, "mm") + age +
            "  sense velocity : vector error " + draw_.between(0, 50, "mm/s") + age;
    if (unicycle_) text += "  sense heading : angle error 1 deg" + age;
    if (battery_) text += "  sense battery : ratio error 1 % max_age 2 s;\n";
    if (robots_ > 1) text += "  hears other robots max_age 100 ms;\n";
    text += std::string("  output ") + (unicycle_ ? "drive : twist" : "push : acceleration") +
            ";\n  latency " + draw_.between(0, period_ms_ / 2, "ms") + ";\n";
    if (battery_) {
      text += "  energy { drive <= " + draw_.tenths(1, 9, "%/m") +
              "; idle <= 0.01 %/s; drain <= " + draw_.tenths(2, 5, "%/s") +
              "; charge >= 1 %/s at home; held <= " + std::to_string(draw_.of({60, 120, 400})) +
              " s; detour <= " + draw_.between(3, 20, "m") + "; }\n";
    }
    return text + "}\n";
  }

  // Who is there besides, docks, and who may drive.
  std::string company() {
    static const char* const names[] = {"a", "b", "c"};
    const int edge = size_cm_ / 6;
    const std::pair<int, int> docks[] = {
        {size_cm_ * 2 / 3, edge + size_cm_ / 3}, {size_cm_ / 2, edge}, {size_cm_ * 3 / 4, edge}};
    std::string text = "fleet ", sites;
    for (int k = 0; k < robots_; ++k) {
      text += std::string(k == 0 ? "" : ", ") + names[k];
      if (!battery_) continue;
      sites += std::string("site home(") + names[k] +
               ") = " + place(docks[k].first, docks[k].second) + ";\n";
    }
    text += " : Bot;\n" + sites;
    if (agent_) text += "agent walker : radius 30 cm, speed <= 1 m/s error 5 cm max_age 100 ms;\n";
    speed_ = draw_.between(20, 45, "cm/s");
    const auto within = [&](const char* zone) {
      return std::string(draw_.of({"retreat", "retreat", "loiter",
                                   "sequence brake_and_hold for 1 s then retreat"})) +
             " within " + zone + " speed " + speed_ + ";\n";
    };
    text += "controller ac : advanced for Bot extern;\ncontroller back : safe for Bot = " +
            within("room") + "controller off : safe for Bot = " + within("dry") +
            "controller stay : safe for Bot = brake_and_hold;\n";
    if (robots_ > 1) {
      text += "controller way : safe for Bot = yield within room speed " + speed_ + " order id;\n";
    }
    if (battery_) {
      text += "controller charge : safe for Bot = route to home within " +
              std::string(draw_.of({"room", "dry"})) + " speed " + speed_ + ";\n";
    }
    return text;
  }

  void monitor(const char* name, const std::string& property, const std::string& recovery,
               bool may_hold = false) {
    const std::string ahead =
        draw_.one_in(2) ? "" : "ahead " + std::to_string(period_ms_ * draw_.from(1, 3)) + " ms; ";
    monitors_ += std::string("monitor ") + name + " for r : Bot { \"" + name + "\" always " +
                 property + "; " + ahead + "recover " + recovery + ";" +
                 (may_hold ? " hold when violated \"somebody comes\";" : "") + " }\n";
    order_.push_back(name);
  }

  std::string monitors() {
    const bool has_pond = draw_.one_in(2);
    if (has_pond) {
      monitor("pond_off", "distance(r, pond) >= " + std::to_string(berth_cm_) + " cm", "off");
    }
    if (!has_pond || !draw_.one_in(3)) {
      monitor("fence",
              draw_.one_in(3) ? "clearance(r, room) >= " + draw_.between(2, 20, "cm")
                              : std::string("r inside room"),
              has_pond ? draw_.of({"off", "off", "back"}) : "back");
    }
    if (robots_ > 1) {
      monitor("apart", "forall q : Bot, q != r : distance(r, q) >= " + draw_.between(5, 40, "cm"),
              draw_.of({"way", "stay"}), true);
    }
    if (agent_) monitor("walker_off", "distance(r, walker) >= 20 cm", "stay");
    if (battery_) {
      monitor("fuel", "r.battery >= energy_to(home(r)) + " + draw_.between(2, 12, "%"), "charge");
    }
    draw_.shuffle(order_);
    std::string order;
    for (const std::string& name : order_) order += (order.empty() ? "" : " > ") + name;
    return monitors_ + "decision guard for Bot { advanced ac; period " +
           std::to_string(period_ms_) + " ms; " +
           (order_.size() > 1 && draw_.one_in(5) ? "coordinate " : "priority ") + order + "; " +
           (agent_ ? "acknowledge stay may break walker_off \"people see it\"; " : "") + "}\n";
  }

  Draw draw_;
  int size_cm_;
  bool unicycle_;
  int robots_;
  bool battery_, agent_;
  std::uint64_t seed_;
  int berth_cm_ = 0, period_ms_ = 0;
  std::string speed_, monitors_;
  std::vector<std::string> order_;
};

}  // namespace

std::string random_page(std::uint64_t seed) {
  return Page(seed).text();
}

}  // namespace rtac::campaign
