#include "compiler/codegen/repeat_printer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "compiler/codegen/watch_values.h"

namespace rtac::codegen {
namespace {

using namespace ir;

// How a telling joins two parts; verdicts are bits.
struct Word {
  const char* margins;
  const char* verdicts;
};
Word word_of(const Op& join) {
  if (std::holds_alternative<And>(join)) return {"both", " & "};
  if (std::holds_alternative<Or>(join)) return {"either", " | "};
  if (std::holds_alternative<Minimum>(join)) return {"smaller_of", "bounds_least"};
  if (std::holds_alternative<Maximum>(join)) return {"greater_of", "bounds_greatest"};
  return {"sum_of", "bounds_sum"};
}

}  // namespace

std::string RepeatPrinter::name(const char* what, std::size_t index) const {
  return function_ + "_" + what + "_" + std::to_string(index);
}
std::string RepeatPrinter::type(bool is_quantity) const {
  if (kernel_.is_full()) return is_quantity ? "span" : "margin";
  return is_quantity ? "bounds" : "int32_t";
}
std::string RepeatPrinter::two(const Op& join, const std::string& a, const std::string& b) {
  const Word word = word_of(join);
  const bool is_bits = !kernel_.is_full() && *word.verdicts == ' ';
  if (is_bits) return a + word.verdicts + b;
  const char* const function = kernel_.is_full() ? word.margins : word.verdicts;
  uses_.insert(function);
  return std::string(function) + "(" + a + ", " + b + ")";
}

void RepeatPrinter::print(const Body& body, Code& out) {
  for (std::size_t k = 0; k < repeats_.all.size(); ++k) {
    if (kernel_.is_full()) rows(k, out);
    each(k, body, out);
    all(k, out);
  }
}

// Both tellings look the rows up in one table.
std::string RepeatPrinter::table(std::size_t index) const {
  return monitor_ + "_rows_" + std::to_string(index);
}
std::string RepeatPrinter::row_type(std::size_t index) const {
  const Repeated& r = repeats_.all[index];
  constexpr std::size_t short_max = std::numeric_limits<std::uint16_t>::max();
  const bool is_short = std::max(r.quantities.size(), r.conditions.size()) <= short_max;
  return is_short ? "const uint16_t" : "const uint32_t";
}
void RepeatPrinter::rows(std::size_t index, Code& out) const {
  const Repeated& r = repeats_.all[index];
  std::string text = "static " + row_type(index) + " " + table(index) + "[] = {";
  for (const std::vector<std::size_t>& row : r.rows) {
    for (const std::size_t start : row) text += std::to_string(start) + ", ";
  }
  text.resize(text.size() - 2);
  out.comment("Where each repetition finds what it is about.");
  wrapped(out, text + "};");
  out.blank();
}

// What leads to the arguments: as parameters, and as they are passed on.
std::vector<std::string> RepeatPrinter::parameters(std::size_t index) const {
  const Repeated& r = repeats_.all[index];
  std::vector<std::string> all;
  if (looks_[index]) all.push_back("const " + kernel_.functions + "_view *v");
  if (!r.quantities.empty()) all.push_back("const " + type(true) + " *const *of");
  if (!r.conditions.empty()) all.push_back("const " + type(false) + " *const *is");
  return all;
}
std::string RepeatPrinter::passed(std::size_t index, const std::string& suffix) const {
  const Repeated& r = repeats_.all[index];
  std::string text = looks_[index] ? "v, " : "";
  if (!r.quantities.empty()) text += "of" + suffix + ", ";
  if (!r.conditions.empty()) text += "is" + suffix + ", ";
  return text;
}
std::string RepeatPrinter::start(const char* what, std::size_t index,
                                 const std::vector<std::string>& more) const {
  const Repeated& r = repeats_.all[index];
  std::vector<std::string> all = parameters(index);
  all.insert(all.end(), more.begin(), more.end());
  const std::string result = type(r.block[r.block.result].unit.has_value());
  return signature("static " + result + " " + name(what, index), all);
}

void RepeatPrinter::each(std::size_t index, const Body& body, Code& out) {
  const Repeated& r = repeats_.all[index];
  Code lines;
  for (std::size_t i = 0; i < r.arguments; ++i) {
    const bool is_quantity = r.block.values[i].unit.has_value();
    const Repeated::Place& place = r.places[i];
    const std::string behind = place.offset > 0 ? " + " + std::to_string(place.offset) : "";
    lines.line("const " + type(is_quantity) + " " + value_name(ValueId(i)) + " = *" +
               (is_quantity ? "of" : "is") + "[row[" + std::to_string(place.column) + "]" + behind +
               "];");
  }
  looks_.push_back(body(r, lines));
  out.block(start("each", index, {row_type(index) + " *row"}),
            [&](Code& to) { to.append(std::move(lines)); });
  out.blank();
}

void RepeatPrinter::all(std::size_t index, Code& out) {
  const Repeated& r = repeats_.all[index];
  const std::size_t columns = r.rows.front().size();
  const std::string next = columns > 1 ? "rows + k * " + std::to_string(columns) : "rows + k";
  const std::string each = name("each", index) + "(" + passed(index, "");
  out.block(start("all", index, {row_type(index) + " *rows", "int32_t count"}), [&](Code& to) {
    const std::string result = type(r.block[r.block.result].unit.has_value());
    wrapped(to, result + " joined = " + each + "rows);");
    to.line("int32_t k;");
    to.block("for (k = 1; k < count; ++k)", [&](Code& loop) {
      const std::string more = each + next + ")";
      wrapped(loop, "joined = " + two(property_[r.join].op, "joined", more) + ";");
    });
    to.line("return joined;");
  });
  out.blank();
}

void RepeatPrinter::pool(const std::string& name, bool is_quantity,
                         const std::vector<ValueId>& values, const Operand& operand,
                         Code& out) const {
  if (values.empty()) return;
  std::string text = "const " + type(is_quantity) + " *const " + name + "[] = {";
  for (const ValueId id : values) text += "&" + operand(id) + ", ";
  text.resize(text.size() - 2);
  wrapped(out, text + "};");
}
void RepeatPrinter::declare(const std::vector<Part>& parts, const Operand& operand, Code& out) {
  for (const Part& part : parts) {
    if (part.rows == 0 || !declared_.insert(part.of).second) continue;
    const std::string suffix = "_" + std::to_string(part.of);
    pool("of" + suffix, true, repeats_.all[part.of].quantities, operand, out);
    pool("is" + suffix, false, repeats_.all[part.of].conditions, operand, out);
  }
}
std::string RepeatPrinter::joined(const Op& join, const std::vector<Part>& parts,
                                  const Operand& operand) {
  std::string text;
  for (const Part& part : parts) {
    std::string next;
    if (part.rows == 0) {
      next = operand(part.value);
    } else {
      const std::size_t skipped = part.first * repeats_.all[part.of].rows.front().size();
      next = name("all", part.of) + "(" + passed(part.of, "_" + std::to_string(part.of)) +
             table(part.of) + (skipped > 0 ? " + " + std::to_string(skipped) : "") + ", " +
             std::to_string(part.rows) + ")";
    }
    text = text.empty() ? next : two(join, text, next);
  }
  return text;
}

std::vector<ValueId> written_values(const Block& property, const RepeatPrinter* repeats) {
  if (repeats != nullptr && !repeats->repeats().joins.empty()) return repeats->repeats().order;
  std::vector<ValueId> all;
  for (std::size_t i = 0; i < property.values.size(); ++i) all.push_back(ValueId(i));
  return all;
}

}  // namespace rtac::codegen
