#include "compiler/syntax/forms.h"

#include <algorithm>
#include <cstddef>

namespace rtac::syntax {
namespace {

struct Construct {
  TokenKind first;
  std::string_view text;
};
// Parts of clauses with a form of their own.
constexpr Construct kConstructs[] = {
    {T::RECTANGLE, "rectangle (0 m, 0 m) to (5 m, 5 m)"},
    {T::BOX, "box (0 m, 0 m, 0 m) to (5 m, 5 m, 3 m)"},
    {T::CIRCLE, "circle (1 m, 1 m) radius 2 m"},
    {T::POLYGON, "polygon [(0 m, 0 m), (5 m, 0 m), (4 m, 5 m)]"},
    {T::PRISM, "prism (field) from 10 m to 50 m"},
    {T::FORALL, "forall q : Cart, q != r : distance(r, q) >= 8 cm"},
    {T::DURING, "during 2026-05-01T08:00Z .. 2026-05-01T18:00Z or monday, friday 07:30 .. 16:00"},
    {T::AROUND, "zone bubble = circle (0 m, 0 m) radius 3 m around carrier;"},
    {T::IF, "if open then 1 m/s else 2 m/s"},
    {T::LET, "let gap = p.x - q.x in abs(gap) >= 1 m"},
    {T::ONCE, "once[0 s, 2 s] open"},
    {T::HISTORICALLY, "historically[0 s, 2 s] closed"},
    {T::PREVIOUSLY, "previously open"},
    {T::SINCE, "moving since[0 s, 2 s] started"},
    {T::UNCHECKED, "assume gear == park unchecked \"bench test\";"},
    {T::WITHIN, "stopped within 2 s of alarm"},
    {T::EXISTS, "exists q : Cart, q != r : distance(r, q) >= 8 cm"},
};
constexpr std::string_view kMonitorOfSignals =
    "monitor calm { \"R1: it drives slowly\" always speed <= 1 m/s; }";
constexpr std::string_view kAggregate = "mean[0 s, 1 s](speed)";
constexpr std::string_view kZones = "zone free = shrink(room, 30 cm) - pillar;";
constexpr Construct kTemplates[] = {
    {T::RETREAT, "retreat within free speed 0.1 m/s"},
    {T::ROUTE, "route to dock within free speed 0.1 m/s"},
    {T::YIELD, "yield within free speed 0.1 m/s order id"},
    {T::KEEPS, "extern keeps inside free speed <= 0.1 m/s"},
    {T::LOITER, "loiter within free speed 0.1 m/s"},
    {T::LAND, "land to 0 m speed 0.5 m/s"},
    {T::SEQUENCE, "sequence brake_and_hold for 2 s then retreat within free speed 0.1 m/s"},
};

std::size_t clause_begin(const std::vector<Token>& tokens, std::size_t index) {
  while (index > 0 && !ends_clause(tokens[index - 1].kind)) --index;
  // the requirement text of a monitor ends without a `;`
  if (index + 1 < tokens.size() && tokens[index].kind == T::STRING) ++index;
  return index;
}

// The block that is open at `index`.
Block block_at(const std::vector<Token>& tokens, std::size_t index) {
  int depth = 0;
  for (std::size_t i = index; i-- > 0;) {
    if (tokens[i].kind == T::RIGHT_BRACE) ++depth;
    if (tokens[i].kind != T::LEFT_BRACE || depth-- > 0) continue;
    switch (tokens[clause_begin(tokens, i)].kind) {
      case T::ROBOT:
        return Block::robot;
      case T::MOTION:
        return Block::limits;
      case T::ENERGY:
        return Block::energy;
      case T::MONITOR:
        return Block::monitor;
      case T::DECISION:
        return Block::decision;
      case T::ENUM:
        return Block::values;
      default:
        return Block::items;
    }
  }
  return Block::items;
}

template <class Table>
std::string_view find_text(const Table& table, TokenKind first) {
  const auto* found = std::find_if(std::begin(table), std::end(table),
                                   [&](const Construct& each) { return each.first == first; });
  return found == std::end(table) ? std::string_view{} : found->text;
}

// The form of the operator whose `[a, b]` is open at `index`.
std::string_view window_form(const std::vector<Token>& tokens, std::size_t begin,
                             std::size_t index) {
  int depth = 0;
  for (std::size_t i = index; i-- > begin + 1;) {
    if (tokens[i].kind == T::RIGHT_BRACKET) ++depth;
    if (tokens[i].kind != T::LEFT_BRACKET || depth-- > 0) continue;
    const TokenKind owner = tokens[i - 1].kind;
    const bool is_past = owner == T::ONCE || owner == T::HISTORICALLY || owner == T::SINCE;
    if (is_past) return find_text(kConstructs, owner);
    return owner == T::IDENT && tokens[begin].kind != T::INPUT ? kAggregate : std::string_view{};
  }
  return {};
}

// `p since q[0 s, 1 s]`: the form of the operator in front of the name whose window ends behind
// `last`, where the window may belong.
std::string_view past_in_front(const std::vector<Token>& tokens, std::size_t begin,
                               std::size_t last) {
  std::size_t open = last;
  while (open > begin && tokens[open].kind != T::LEFT_BRACKET) --open;
  if (open < begin + 2) return {};
  const TokenKind word = tokens[open - 2].kind;
  const bool is_past = word == T::ONCE || word == T::HISTORICALLY || word == T::SINCE;
  return is_past ? find_text(kConstructs, word) : std::string_view{};
}

// The form of the construct that the error stands in the middle of, nearest first.
std::string_view construct_form(const std::vector<Token>& tokens, std::size_t begin,
                                const SyntaxError& error) {
  // an operand is complete: what it is part of may lack its next word, what starts it does not
  const bool in_controller = tokens[begin].kind == T::CONTROLLER;
  if (in_controller && error.expects(T::THEN)) return find_text(kTemplates, T::SEQUENCE);
  if (error.expects(T::THEN) || error.expects(T::ELSE)) return find_text(kConstructs, T::IF);
  // behind a zone that is complete
  if (tokens[begin].kind == T::ZONE && error.expects(T::AMPERSAND)) return kZones;
  if (error.expects(T::PLUS)) {
    if (error.expects(T::IN)) return find_text(kConstructs, T::LET);
    return window_form(tokens, begin, error.index);
  }
  const bool is_window = error.index > begin && tokens[error.index - 1].kind == T::RIGHT_BRACKET;
  if (is_window && error.expects(T::LEFT_PAREN)) return kAggregate;
  int closed = 0;  // what stands in brackets behind the place is complete
  for (std::size_t i = error.index; i-- > begin;) {
    const TokenKind kind = tokens[i].kind;
    if (kind == T::RIGHT_PAREN || kind == T::RIGHT_BRACKET) ++closed;
    if ((kind == T::LEFT_PAREN || kind == T::LEFT_BRACKET) && closed > 0) --closed;
    if (closed > 0) continue;
    // `within` is part of a template there, and of an expression elsewhere
    std::string_view text = in_controller && tokens[i].kind == T::WITHIN
                                ? std::string_view{}
                                : find_text(kConstructs, tokens[i].kind);
    if (text.empty() && in_controller) text = find_text(kTemplates, tokens[i].kind);
    if (!text.empty()) return text;
  }
  return {};
}

// Does the monitor around `index` name a robot: `monitor m for r : Kind {`?
bool speaks_of_robot(const std::vector<Token>& tokens, std::size_t index) {
  while (index > 0 && tokens[index].kind != T::MONITOR) --index;
  return index + 2 < tokens.size() && tokens[index + 2].kind == T::FOR;
}

// Is it a monitor of signals, as far as can be seen?
bool speaks_of_signals(const std::vector<Token>& tokens, std::size_t begin) {
  return std::none_of(tokens.begin() + static_cast<std::ptrdiff_t>(begin), tokens.end(),
                      [](const Token& token) {
                        return token.kind == T::FOR || token.kind == T::AHEAD ||
                               token.kind == T::RECOVER || token.kind == T::INSIDE;
                      });
}

std::string phrase(std::string_view what, std::string_view form) {
  return std::string{what} + " `" + std::string{form} + '`';
}

// Of a safe controller, by what is there of it.
std::string_view recovery_form(const std::vector<Token>& tokens, std::size_t begin,
                               std::size_t end) {
  const auto has = [&](TokenKind kind) {
    return std::any_of(tokens.begin() + static_cast<std::ptrdiff_t>(begin),
                       tokens.begin() + static_cast<std::ptrdiff_t>(end) + 1,
                       [&](const Token& token) { return token.kind == kind; });
  };
  if (!has(T::SAFE)) return "";
  if (has(T::EXTERN)) {
    return "controller bought : safe for Cart extern keeps inside room speed <= 1 m/s;";
  }
  if (has(T::SEQUENCE)) {
    return "controller calm : safe for Cart = sequence brake_and_hold for 2 s then retreat within "
           "room speed 0.4 m/s;";
  }
  return "controller back : safe for Cart = retreat within room speed 0.4 m/s;";
}

}  // namespace

const std::vector<Form>& all_forms() {
  static const std::vector<Form> forms{
      // the first form of a block stands for all of them when nothing tells which is meant
      {Block::items, T::ZONE, "zone room = rectangle (0 m, 0 m) to (5 m, 5 m);"},
      {Block::items, T::SPEC, "spec my_robot;"},
      {Block::items, T::IMPORT, "import \"robots.rta\";"},
      {Block::items, T::ROBOT, "robot Cart { body radius 0.2 m; }"},
      {Block::items, T::FLEET, "fleet r1, r2 : Cart;"},
      {Block::items, T::AGENT,
       "agent worker : radius 30 cm, speed <= 2 m/s error 10 cm max_age 200 ms;"},
      {Block::items, T::SITE, "site dock(r1) = (1 m, 1 m);"},
      {Block::items, T::CONTROLLER, "controller pilot : advanced for Cart extern;"},
      {Block::items, T::MONITOR,
       "monitor fence for r : Cart { \"R1: it stays inside\" always r inside room; recover "
       "turn_back; }"},
      {Block::items, T::DECISION,
       "decision drive for Cart { advanced pilot; period 100 ms; priority fence; }"},
      {Block::items, T::PERIOD, "period 10 ms;"},
      {Block::items, T::INPUT,
       "input speed : real [m/s] in 0 .. 3 m/s error 1 cm/s max_age 100 ms;"},
      {Block::items, T::PARAM, "param gap : real [m] in 0.1 m .. 0.5 m = 0.2 m;"},
      {Block::items, T::ENUM, "enum Gear { park, drive, reverse }"},
      {Block::items, T::FUN, "fun slow(v : real [m/s]) : bool = v <= 1 m/s;"},
      {Block::items, T::SCALE, "scale 0.5 m/s;"},
      {Block::items, T::GRID, "grid 0.1 mm, 1 mm/s;"},
      {Block::items, T::FRAME, "frame gps, base;"},
      {Block::items, T::ORIGIN, "origin 47.3977 deg, 8.5456 deg;"},
      {Block::items, T::CLOCK, "clock utc;"},
      {Block::items, T::ASSUME, "assume speed <= 3 m/s checked by no_run;"},
      {Block::robot, T::LATENCY, "latency 40 ms;"},
      {Block::robot, T::BODY, "body radius 0.2 m;"},
      {Block::robot, T::MOTION,
       "motion point { speed <= 1 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }"},
      {Block::robot, T::SENSE, "sense position : point error 2 cm max_age 200 ms;"},
      {Block::robot, T::HEARS, "hears other robots max_age 200 ms;"},
      {Block::robot, T::INPUT, "input plan : path[64] tracking <= 10 cm;"},
      {Block::robot, T::OUTPUT, "output drive : twist;"},
      {Block::robot, T::ENERGY, "energy { drive <= 0.4 %/m; charge >= 1 %/s at dock; }"},
      {Block::limits, T::IDENT, "speed <= 1 m/s;"},
      {Block::energy, T::IDENT, "drive <= 0.4 %/m;"},
      {Block::monitor, T::ALWAYS, "always r inside room;"},
      {Block::monitor, T::AHEAD, "ahead 200 ms, 2 waypoints;"},
      {Block::monitor, T::RECOVER, "recover turn_back;"},
      {Block::monitor, T::RETURN, "return when clearance(r, room) >= 5 cm for 1 s;"},
      {Block::monitor, T::MARGIN, "margin full;"},
      {Block::monitor, T::HOLD, "hold when violated \"a person carries it back\";"},
      {Block::decision, T::PRIORITY, "priority collision > fence;"},
      {Block::decision, T::COORDINATE, "coordinate collision > fence;"},
      {Block::decision, T::ADVANCED, "advanced pilot;"},
      {Block::decision, T::SAFE, "safe certified_planner;"},
      {Block::decision, T::ON, "on plan;"},
      {Block::decision, T::PERIOD, "period 100 ms;"},
      {Block::decision, T::JITTER, "jitter 5 ms;"},
      {Block::decision, T::ACKNOWLEDGE,
       "acknowledge give_way may break battery \"the reserve covers it\";"},
      {Block::values, T::IDENT, "park, drive, reverse"},
  };
  return forms;
}

std::string form_help(const std::vector<Token>& tokens, const SyntaxError& error) {
  const std::size_t begin = clause_begin(tokens, error.index);
  const Block block = block_at(tokens, begin);
  if (begin < error.index) {
    const std::string_view construct = construct_form(tokens, begin, error);
    if (construct == kAggregate) {
      const std::string_view past = past_in_front(tokens, begin, error.index - 1);
      if (!past.empty()) return phrase("the form is", past) + phrase(" or", construct);
    }
    if (!construct.empty()) return phrase("the form is", construct);
    const bool of_signals = block == Block::monitor && !speaks_of_robot(tokens, begin);
    if (of_signals && tokens[begin].kind == T::ALWAYS) {
      return phrase("the form is", "always speed <= 1 m/s;");
    }
    if (tokens[begin].kind == T::CONTROLLER) {
      if (const auto form = recovery_form(tokens, begin, error.index); !form.empty()) {
        return phrase("the form is", form);
      }
    }
    if (tokens[begin].kind == T::MONITOR && speaks_of_signals(tokens, begin)) {
      return phrase("the form is", kMonitorOfSignals);
    }
    for (const Form& form : all_forms()) {
      const bool fits = form.first == tokens[begin].kind || form.first == T::IDENT;
      if (form.block == block && fits) return phrase("the form is", form.text);
    }
  }
  const auto& forms = all_forms();
  const auto first = std::find_if(forms.begin(), forms.end(),
                                  [&](const Form& form) { return form.block == block; });
  if (block == Block::values) return phrase("the form is", first->text);
  if (block == Block::monitor && !speaks_of_robot(tokens, begin)) {
    return phrase("a clause looks like", "always speed <= 1 m/s;");
  }
  if (block == Block::items) {
    return phrase("an item looks like", "input open : bool;") + phrase(" or", first->text);
  }
  return phrase("a clause looks like", first->text);
}

}  // namespace rtac::syntax
