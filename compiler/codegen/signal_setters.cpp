#include "compiler/codegen/signal_setters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "compiler/sema/dimension.h"

namespace rtac::codegen {

using namespace ir;

namespace {

std::string number_type(const Channel& c) {
  const sema::Dimension& d = c.unit.dimension;
  if (d == sema::dims::length) return "rtac::Length";
  if (d == sema::dims::speed) return "rtac::Speed";
  if (d == sema::dims::angle) return "rtac::Angle";
  if (d == sema::dims::ratio) return "rtac::Charge";
  return "double";
}
std::string grid(const Unit& unit) {
  return real(Rational(unit.step.get_den())) + ", " + unit.step.get_num().get_str();
}

// The shortest number that is read as the same.
std::string shortest(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

bool in_space(const Watch& watch) {
  return std::any_of(watch.inputs.begin(), watch.inputs.end(), [](const Channel& c) {
    const std::string& last = c.components.back();
    return !last.empty() && last.back() == 'z';
  });
}
std::string between_of(const Channel& c, std::uint32_t component) {
  if (between_words(c) == 1) return ".between";
  return ".between[" + num(std::int64_t(component / between_bits)) + "]";
}
// The type of the runtime that has these components; null: there is none.
const char* record_type(const Channel& c) {
  const bool length = c.unit.dimension == sema::dims::length;
  const bool speed = c.unit.dimension == sema::dims::speed;
  if (c.components == std::vector<std::string>{"x", "y"} && (length || speed)) {
    return length ? "rtac::Position" : "rtac::Velocity";
  }
  if (c.components == std::vector<std::string>{"x", "y", "heading"}) return "rtac::Pose";
  if (c.components == std::vector<std::string>{"linear", "angular"}) return "rtac::BodyVelocity";
  return nullptr;
}

}  // namespace

SignalSetters::SignalSetters(const Watch& watch, const Names& names, Places places,
                             std::set<std::string> taken)
    : watch_(watch),
      names_(names),
      members_(watch_names(watch)),
      places_(std::move(places)),
      taken_(std::move(taken)) {
  for (std::size_t c = 0; c < watch_.inputs.size(); ++c) setters_.push_back(setter(c));
  for (const Param& p : watch_.params) params_.push_back(method(p.name));
  bool receives = false;
  for (std::size_t c = 0; c < watch_.inputs.size(); ++c) {
    if (watch_.inputs[c].kind != ChannelKind::zone) continue;
    setters_[c].edges_most = method(signal_word(watch_.inputs[c].name) + "_edges_most");
    receives = true;
  }
  if (!receives || !watch_.origin) return;
  latitude_ = method("origin_latitude_deg");
  longitude_ = method("origin_longitude_deg");
}

std::string SignalSetters::method(const std::string& name) {
  std::string id = legal(name);
  while (!taken_.insert(id).second) id += "_";
  return id;
}

SignalSetters::Setter SignalSetters::setter(std::size_t channel) {
  const Channel& c = watch_.inputs[channel];
  Setter s;
  s.name = method(signal_word(c.name));
  if (c.kind == ChannelKind::zone) return s;
  if (c.kind == ChannelKind::path) {
    s.type = "const rtac::Path&";
    return s;
  }
  std::string scalar = "double", read;
  if (c.kind == ChannelKind::truth) scalar = "bool";
  if (c.kind == ChannelKind::choice) scalar = names_(c.choice);
  if (c.kind == ChannelKind::number && c.components.size() == 1) {
    scalar = number_type(c);
    if (scalar != "double") read = ".si()";
  }
  if (c.components.size() == 1) {
    s.type = scalar;
    s.values = {"value" + read};
    return s;
  }
  if (const char* type = record_type(c)) {
    s.type = type;
    for (const std::string& part : c.components) s.values.push_back("value." + part + ".si()");
    return s;
  }
  s.type = "const std::array<" + scalar + ", " + num(std::int64_t(c.components.size())) + ">&";
  for (std::size_t k = 0; k < c.components.size(); ++k) {
    s.values.push_back("value[" + num(std::int64_t(k)) + "]");
  }
  return s;
}

// What those who make the tables of a received zone have to know.
void SignalSetters::declare_constants(Code& body) const {
  if (!latitude_.empty()) {
    body.comment(
        "Where (0 m, 0 m) is on the globe, WGS 84: for zones that are received in degrees.");
    for (const auto& [name, degrees] : {std::pair(latitude_, watch_.origin->latitude_deg),
                                        std::pair(longitude_, watch_.origin->longitude_deg)}) {
      body.line("static constexpr double " + name + " = " + shortest(degrees) + ";");
    }
  }
  for (std::size_t c = 0; c < setters_.size(); ++c) {
    if (setters_[c].edges_most.empty()) continue;
    body.line("static constexpr std::size_t " + setters_[c].edges_most + " = " +
              num(std::int64_t{watch_.inputs[c].edges_most}) + ";");
  }
}

void SignalSetters::declare(Code& body) const {
  declare_constants(body);
  if (!watch_.inputs.empty()) {
    body.comment(
        "Inputs, in SI units, with the time at which they were measured (us). An array "
        "has the elements of the input in order, of points x before y" +
        std::string(in_space(watch_) ? " and z." : "."));
  }
  for (std::size_t c = 0; c < watch_.inputs.size(); ++c) {
    const Channel& channel = watch_.inputs[c];
    if (channel.kind == ChannelKind::zone) {
      body.comment("A zone that was received, of at most " + num(std::int64_t{channel.edges_most}) +
                   " edges a side. False: it is none that can be checked here, and the one before "
                   "stays. Its "
                   "tables stay as they are until another zone was taken.");
      body.line("[[nodiscard]] bool " + setters_[c].name +
                "(const rtac::ZoneTable& table, rtac::TimeUs stamp_us);");
      continue;
    }
    if (channel.kind == ChannelKind::path) {
      body.comment(
          "Way-points in m, each counted to the nearest mm, and the next of them; the path "
          "is unknown with more than " +
          num(std::int64_t{channel.places_most}) + ".");
    }
    const std::string unit = sema::unit_of(channel.unit.dimension);
    if (setters_[c].type.find("double") != std::string::npos && !unit.empty()) {
      body.comment(unit == "%" ? "a ratio of 1 is 100 %" : unit);
    }
    body.line(places_.type + "& " + setters_[c].name + "(" + setters_[c].type +
              " value, rtac::TimeUs stamp_us);");
  }
  for (std::size_t k = 0; k < watch_.params.size(); ++k) {
    const Param& p = watch_.params[k];
    const char* const moves = p.tightens > 0   ? "what is less than before is ignored"
                              : p.tightens < 0 ? "what is more than before is ignored"
                                               : "nothing depends on it";
    body.comment("Parameter, in " + sema::describe(p.unit.dimension) + ", SI: " + moves + ".");
    body.line(places_.type + "& " + params_[k] + "(double si);");
  }
}

void SignalSetters::define_input(std::size_t index, Code& out) const {
  const Channel& c = watch_.inputs[index];
  const Setter& s = setters_[index];
  if (c.kind == ChannelKind::zone) {
    const WatchSignal& signal = members_.signal(std::uint32_t(index), 0);
    out.block("bool " + places_.type + "::" + s.name +
                  "(const rtac::ZoneTable& table, rtac::TimeUs stamp_us)",
              [&](Code& body) {
                body.line("return rtac::bridge::put_zone(" + places_.in + signal.name + ", " +
                          places_.in + signal.zone + ", table, " + num(std::int64_t{c.edges_most}) +
                          ", stamp_us);");
              });
    out.blank();
    return;
  }
  out.block(
      places_.type + "& " + places_.type + "::" + s.name + "(" + s.type +
          " value, rtac::TimeUs stamp_us)",
      [&](Code& body) {
        const std::string sample = places_.in + members_.samples[index];
        if (c.kind == ChannelKind::path) {
          body.line("rtac::bridge::put(" + sample + ", value, " + num(std::int64_t{c.places_most}) +
                    ");");
          body.line(sample + ".stamp_us = stamp_us;");
          body.line("return *this;");
          return;
        }
        body.line("rtac::bridge::start_sample(" + sample + ", stamp_us);");
        for (std::uint32_t k = 0; k < c.components.size(); ++k) {
          const std::string to = places_.in + members_.signal(std::uint32_t(index), k).name;
          if (c.kind != ChannelKind::number) {
            body.line(to + " = static_cast<std::int64_t>(" + s.values[k] + ");");
            continue;
          }
          const std::string put = "rtac::bridge::put_number(" + to + ", " + s.values[k] + ", " +
                                  grid(c.grid(k).unit) + ")";
          body.line(
              sample + between_of(c, k) + " |= " + put +
              (k % between_bits > 0 ? " << " + num(std::int64_t(k % between_bits)) + "U;" : ";"));
        }
        body.line("return *this;");
      });
  out.blank();
}
void SignalSetters::define_param(std::size_t k, Code& out) const {
  const Param& p = watch_.params[k];
  out.block(places_.type + "& " + places_.type + "::" + params_[k] + "(double si)",
            [&](Code& body) {
              body.line("rtac::bridge::tighten(" + places_.in + members_.params[k] + ", si, " +
                        grid(p.unit) + ", " + num(p.range.lo) + ", " + num(p.range.hi) + ", " +
                        (p.tightens > 0 ? "true" : "false") + ");");
              body.line("return *this;");
            });
  out.blank();
}

void SignalSetters::define(Code& out) const {
  for (std::size_t c = 0; c < watch_.inputs.size(); ++c) define_input(c, out);
  for (std::size_t k = 0; k < watch_.params.size(); ++k) define_param(k, out);
}

void SignalSetters::first_values(Code& body) const {
  for (std::size_t k = 0; k < watch_.params.size(); ++k) {
    body.line(places_.in + members_.params[k] + " = " + num(watch_.params[k].value) + ";");
  }
}

void SignalSetters::keep_params(Code& body, const std::function<void()>& reset) const {
  std::vector<std::string> moving;
  for (std::size_t k = 0; k < watch_.params.size(); ++k) {
    if (watch_.params[k].tightens != 0) moving.push_back(members_.params[k]);
  }
  for (const std::string& p : moving) {
    body.line("const std::int64_t " + p + "_before = " + places_.state + "tightest_" + p + ";");
  }
  reset();
  for (const std::string& p : moving) {
    body.line(places_.state + "tightest_" + p + " = " + p + "_before;");
  }
}

void print_choices(const Module& module, const Names& names, Code& out) {
  std::set<std::string> printed;
  const auto print = [&](const Watch& watch) {
    for (const Channel& c : watch.inputs) {
      if (c.kind != ChannelKind::choice || !printed.insert(c.choice).second) continue;
      out.block(
          "enum class " + names(c.choice) + " : std::int64_t",
          [&](Code& body) {
            for (std::size_t k = 0; k < c.values.size(); ++k) {
              body.line(legal(c.values[k]) + (k + 1 < c.values.size() ? "," : ""));
            }
          },
          "};");
      out.blank();
    }
  };
  for (const Decision& d : module.decisions) print(d.facts);
  if (module.watch) print(*module.watch);
}

}  // namespace rtac::codegen
