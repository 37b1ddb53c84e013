// From blocks of IR to C functions, and the library functions that they use.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "compiler/codegen/code.h"
#include "compiler/codegen/names.h"
#include "compiler/ir/module.h"

namespace rtac::codegen {

class BlockPrinter {
 public:
  // `view`: type of the parameter of the functions; `uses` collects library functions.
  BlockPrinter(const ir::Module& module, const ir::Decision& decision, const Names& names,
               std::string view, std::set<std::string>& uses)
      : module_(module), decision_(decision), names_(names), view_(std::move(view)), uses_(uses) {}

  // static margin NAME(const VIEW *v); `units`: with the unit of the atom that decides.
  void function(const std::string& name, const std::string& comment, const ir::Block& block,
                Code& out, bool units = false);
  // The same of one quantifier alone.
  void quantifier(const std::string& name, const ir::Op& op, Code& out);
  // The expression of one value; quantifiers have none.
  std::string call(const ir::Value& value, const ir::Block& block);

 private:
  void loop(const ir::Op& op, const std::string& target, const std::string& body, Code& out);
  void others(const std::string& name, const ir::Block& block, Code& out);
  void say(const ir::Value& value, const ir::Block& block, Code& out);
  void body(const std::string& name, const ir::Block& block, Code& out);
  std::string value(const ir::Value& value, const ir::Block& block);
  // A limit, with what parameters add to it.
  static std::string limit(std::int64_t fixed, const std::optional<ir::ValueId>& more);
  [[nodiscard]] std::string unit_number(const ir::Unit& unit) const;
  std::string use(const std::string& function, const std::string& arguments);

  const ir::Module& module_;
  const ir::Decision& decision_;
  const Names& names_;
  const std::string view_;
  std::set<std::string>& uses_;
  bool units_ = false;
};

// The facts of a decision, as indices; and how many there are.
std::vector<std::string> fact_symbols(const ir::Decision& decision, const Names& names);
std::string fact_count_symbol(const ir::Decision& decision, const Names& names);

// Names of the constant tables.
std::string zone_symbol(const ir::ZoneTable& zone, const Names& names);
// Where the robot itself is with respect to a zone, in the view of a tick.
std::string place_symbol(const ir::ZoneTable& zone, const Names& names);
std::string cells_symbol(const ir::SiteTable& site, const Names& names);

}  // namespace rtac::codegen
