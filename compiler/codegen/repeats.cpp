#include "compiler/codegen/repeats.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>

#include "compiler/codegen/temporal.h"
#include "compiler/ir/operands.h"
#include "compiler/ir/printer.h"

namespace rtac::codegen {
namespace {

using namespace ir;

std::size_t at(ValueId id) {
  return static_cast<std::size_t>(id);
}

bool joins(const Op& op) {
  return std::holds_alternative<And>(op) || std::holds_alternative<Or>(op) ||
         std::holds_alternative<Minimum>(op) || std::holds_alternative<Maximum>(op) ||
         std::holds_alternative<Add>(op);
}
// What each tick looks at: it is there once, whoever asks for it. Legs take so much longer than a
// call that nothing is won by a loop.
bool is_looked_at(const Op& op) {
  if (std::holds_alternative<TrailClearance>(op) || std::holds_alternative<TrailInside>(op) ||
      std::holds_alternative<TrailDistance>(op) || std::holds_alternative<PathGiven>(op)) {
    return true;
  }
  return std::holds_alternative<Input>(op) || std::holds_alternative<InputTruth>(op) ||
         std::holds_alternative<InputIs>(op) || std::holds_alternative<InputSame>(op) ||
         std::holds_alternative<Open>(op) || std::holds_alternative<Age>(op);
}
bool is_fixed(const Op& op) {
  return std::holds_alternative<Const>(op) || std::holds_alternative<Between>(op) ||
         std::holds_alternative<ParamValue>(op) || std::holds_alternative<Truth>(op);
}
// Operations with blocks of their own speak of the robots of a decision, which a property of no
// robot does not.
std::optional<Op> copy_of(const Op& op) {
  return std::visit(
      [](const auto& node) -> std::optional<Op> {
        if constexpr (std::is_copy_constructible_v<std::decay_t<decltype(node)>>) return Op(node);
        return std::nullopt;
      },
      op);
}

// Where each repetition finds its arguments. Arguments that go together, such as the coordinates of
// one robot, stand side by side, so that a row names them once.
class Rows {
 public:
  Rows(const Block& block, std::vector<std::vector<ValueId>> arguments, Repeated& to)
      : block_(block), arguments_(std::move(arguments)), to_(to) {}

  void make() {
    to_.rows.assign(arguments_.size(), {});
    for (std::size_t i = 0; i < to_.arguments; ++i) group(i);
    to_.places.resize(to_.arguments);
    for (std::size_t column = 0; column < groups_.size(); ++column) place(column);
  }

 private:
  [[nodiscard]] bool is_quantity(std::size_t argument) const {
    return block_[arguments_.front()[argument]].unit.has_value();
  }
  // Does each value of one come with one of the other, and the other way round?
  [[nodiscard]] bool go_together(std::size_t a, std::size_t b) const {
    if (is_quantity(a) != is_quantity(b)) return false;
    std::map<ValueId, ValueId> there, back;
    return std::all_of(arguments_.begin(), arguments_.end(), [&](const auto& row) {
      return there.emplace(row[a], row[b]).first->second == row[b] &&
             back.emplace(row[b], row[a]).first->second == row[a];
    });
  }
  void group(std::size_t argument) {
    for (std::vector<std::size_t>& group : groups_) {
      if (!go_together(group.front(), argument)) continue;
      group.push_back(argument);
      return;
    }
    groups_.push_back({argument});
  }
  void place(std::size_t column) {
    const std::vector<std::size_t>& group = groups_[column];
    std::vector<ValueId>& pool = is_quantity(group.front()) ? to_.quantities : to_.conditions;
    for (std::size_t k = 0; k < group.size(); ++k) to_.places[group[k]] = {column, k};
    std::map<ValueId, std::size_t> known;
    for (std::size_t r = 0; r < arguments_.size(); ++r) {
      const auto [start, is_new] = known.emplace(arguments_[r][group.front()], pool.size());
      to_.rows[r].push_back(start->second);
      if (!is_new) continue;
      for (const std::size_t argument : group) pool.push_back(arguments_[r][argument]);
    }
  }

  const Block& block_;
  const std::vector<std::vector<ValueId>> arguments_;  // by repetition
  Repeated& to_;
  std::vector<std::vector<std::size_t>> groups_;  // of arguments
};

// One part of a join: what it computes, and of which values.
struct Form {
  Repeated of;
  std::vector<ValueId> arguments;
  std::string text;  // equal for all that repeat each other
};

class Finder {
 public:
  Finder(const Module& module, const Block& block)
      : module_(module),
        block_(block),
        user_(block.values.size(), 0),
        uses_(block.values.size(), 0),
        written_(block.values.size(), false) {
    arguments_look_.inputs.push_back({});
    arguments_look_.inputs[0].components = {""};
    arguments_look_.params = module.watch->params;
    arguments_look_.regions = module.watch->regions;
    arguments_look_.solids = module.watch->solids;
    arguments_look_.schedules = module.watch->schedules;
    for (std::size_t i = 0; i < block.values.size(); ++i) count_uses(i);
    ++uses_[at(block.result)];
  }

  Repeats run() {
    for (std::size_t i = 0; i < block_.values.size(); ++i) {
      if (joins(block_.values[i].op) && !is_inner(ValueId(i))) join(ValueId(i));
    }
    for (std::size_t k = 0; k < found_.all.size(); ++k) {
      Rows(block_, std::move(arguments_[k]), found_.all[k]).make();
    }
    write(block_.result);
    return std::move(found_);
  }

 private:
  void count_uses(std::size_t i) {
    const Op& op = block_.values[i].op;
    bool has_operand = false, of_fixed = true;
    for_each_operand(op, [&](ValueId id) {
      ++uses_[at(id)];
      user_[at(id)] = i;
      has_operand = true;
      of_fixed = of_fixed && fixed_[at(id)];
    });
    fixed_.push_back(is_fixed(op) || (has_operand && of_fixed && !is_temporal(op)));
  }
  // Joined by nothing but a join of the same kind.
  [[nodiscard]] bool is_inner(ValueId id) const {
    return uses_[at(id)] == 1 && id != block_.result &&
           block_.values[user_[at(id)]].op.index() == block_[id].op.index();
  }
  void flatten(ValueId id, std::vector<ValueId>& parts) const {
    for_each_operand(block_[id].op, [&](ValueId operand) {
      const bool same = block_[operand].op.index() == block_[id].op.index();
      same&& is_inner(operand) ? flatten(operand, parts) : parts.push_back(operand);
    });
  }
  // Sums are added up in another order: none on the way exceeds the whole one when no part is
  // negative.
  [[nodiscard]] bool may_be_reordered(ValueId join, const std::vector<ValueId>& parts) const {
    return !std::holds_alternative<Add>(block_[join].op) ||
           std::all_of(parts.begin(), parts.end(),
                       [&](ValueId id) { return block_[id].range && block_[id].range->lo >= 0; });
  }

  void join(ValueId id) {
    std::vector<ValueId> parts;
    flatten(id, parts);
    if (parts.size() < fewest_repeats || !may_be_reordered(id, parts)) return;
    std::vector<Form> forms;
    for (const ValueId part : parts) forms.push_back(form_of(part));
    std::vector<Part> joined;
    bool repeats = false;
    for (std::size_t i = 0; i < parts.size();) {
      std::size_t end = i + 1;
      while (end < parts.size() && forms[end].text == forms[i].text) ++end;
      if (forms[i].text.empty() || end - i < fewest_repeats) {
        joined.push_back({parts[i], 0, 0, 0});
        ++i;
        continue;
      }
      joined.push_back(repeated(id, forms, i, end));
      repeats = true;
      i = end;
    }
    if (repeats) found_.joins.emplace(id, std::move(joined));
  }
  Part repeated(ValueId join, std::vector<Form>& forms, std::size_t begin, std::size_t end) {
    const std::string kind = std::to_string(block_[join].op.index()) + " of ";
    const auto [known, is_new] = by_text_.emplace(kind + forms[begin].text, found_.all.size());
    if (is_new) {
      found_.all.push_back(std::move(forms[begin].of));
      found_.all.back().join = join;
      arguments_.emplace_back();
    }
    std::vector<std::vector<ValueId>>& rows = arguments_[known->second];
    const Part part{{}, known->second, rows.size(), end - begin};
    for (std::size_t k = begin; k < end; ++k) rows.push_back(std::move(forms[k].arguments));
    return part;
  }

  // ---- the form of a part
  // What it computes for itself alone: nothing else asks for it.
  [[nodiscard]] std::set<ValueId> own(ValueId part) const {
    std::set<ValueId> own;
    std::map<ValueId, std::size_t> asked;
    std::vector<ValueId> open;
    if (uses_[at(part)] == 1 && is_computed(part)) open.push_back(part);
    while (!open.empty()) {
      const ValueId id = open.back();
      open.pop_back();
      own.insert(id);
      for_each_operand(block_[id].op, [&](ValueId operand) {
        if (++asked[operand] == uses_[at(operand)] && is_computed(operand)) open.push_back(operand);
      });
    }
    return own;
  }
  [[nodiscard]] bool is_computed(ValueId id) const {
    const Op& op = block_[id].op;
    return !fixed_[at(id)] && !is_temporal(op) && !is_looked_at(op) && found_.joins.count(id) == 0;
  }
  // Its values, operands first, and its arguments, both in the order in which they are met.
  void collect(ValueId id, const std::set<ValueId>& own, std::vector<ValueId>& values,
               std::vector<ValueId>& arguments) const {
    const bool is_argument = own.count(id) == 0 && !fixed_[at(id)];
    std::vector<ValueId>& to = is_argument ? arguments : values;
    if (std::find(to.begin(), to.end(), id) != to.end()) return;
    if (!is_argument) {
      for_each_operand(block_[id].op,
                       [&](ValueId operand) { collect(operand, own, values, arguments); });
    }
    to.push_back(id);
  }
  // Without a text: nothing is computed, or it cannot be repeated.
  [[nodiscard]] Form form_of(ValueId part) const {
    const std::set<ValueId> own = this->own(part);
    Form form;
    if (own.empty()) return form;
    std::vector<ValueId> values;
    collect(part, own, values, form.arguments);
    Block& to = form.of.block;
    std::map<ValueId, ValueId> renamed;
    const auto add = [&](ValueId id, Op op) {
      const Value& from = block_[id];
      renamed[id] = ValueId(to.values.size());
      to.values.push_back({std::move(op), from.unit, from.range, from.source, from.text});
    };
    for (const ValueId id : form.arguments) {
      add(id, block_[id].unit ? Op(Input{0, 0}) : Op(InputTruth{0, 0}));  // it is there
    }
    for (const ValueId id : values) {
      std::optional<Op> op = copy_of(block_[id].op);
      if (!op) return form;
      for_each_operand(*op, [&](ValueId& operand) { operand = renamed.at(operand); });
      add(id, std::move(*op));
    }
    to.result = renamed.at(part);
    form.of.arguments = form.arguments.size();
    form.text = text_of(form.of);
    return form;
  }
  // What is written at one place and computed alike. Arguments may come from elsewhere.
  [[nodiscard]] std::string text_of(const Repeated& form) const {
    std::string text =
        std::to_string(form.arguments) + print(module_, &arguments_look_, form.block, "");
    for (std::size_t i = 0; i < form.block.values.size(); ++i) {
      const Value& v = form.block.values[i];
      text += v.range && v.range->declared ? '!' : '.';
      if (i < form.arguments) continue;
      text += std::to_string(v.source.begin) + "-" + std::to_string(v.source.end);
    }
    return text;
  }

  // ---- the order: what is repeated behind all that its repetitions start from
  void write(ValueId id) {
    if (written_[at(id)]) return;
    written_[at(id)] = true;
    const std::vector<Part>* const parts = found_.parts_of(id);
    if (parts == nullptr) {
      for_each_operand(block_[id].op, [&](ValueId operand) { write(operand); });
    } else {
      for (const Part& part : *parts) {
        if (part.rows == 0) {
          write(part.value);
          continue;
        }
        for (const ValueId argument : found_.all[part.of].quantities) write(argument);
        for (const ValueId argument : found_.all[part.of].conditions) write(argument);
      }
    }
    found_.order.push_back(id);
  }

  const Module& module_;
  const Block& block_;
  Watch arguments_look_;           // where arguments stand as inputs
  std::vector<std::size_t> user_;  // the last one
  std::vector<std::size_t> uses_;
  std::vector<bool> fixed_;  // constants and parameters, and what is computed of them alone
  std::vector<bool> written_;
  std::map<std::string, std::size_t> by_text_;
  std::vector<std::vector<std::vector<ValueId>>> arguments_;  // of all
  Repeats found_;
};

}  // namespace

Repeats find_repeats(const Module& module, const Block& property) {
  return Finder(module, property).run();
}

}  // namespace rtac::codegen
