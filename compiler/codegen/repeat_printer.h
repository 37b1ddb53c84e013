// What a property repeats, as C: a table of rows, a function of what is said once, and a loop.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "compiler/codegen/code.h"
#include "compiler/codegen/repeats.h"
#include "compiler/codegen/watch.h"

namespace rtac::codegen {

class RepeatPrinter {
 public:
  // How a value of the property is written: as one that can be pointed at.
  using Operand = std::function<std::string(ir::ValueId)>;
  // Prints the values of what is repeated behind its arguments, named as values are, and returns
  // the last one; false: it does not look at the view.
  using Body = std::function<bool(const Repeated&, Code&)>;

  // `monitor`: leads the names of the tables, which both tellings share; `function`: those of the
  // functions. `uses` collects library functions.
  RepeatPrinter(const WatchKernel& kernel, const ir::Block& property, const Repeats& repeats,
                std::string monitor, std::string function, std::set<std::string>& uses)
      : kernel_(kernel),
        property_(property),
        repeats_(repeats),
        monitor_(std::move(monitor)),
        function_(std::move(function)),
        uses_(uses) {}

  void print(const Body& body, Code& out);
  [[nodiscard]] const Repeats& repeats() const { return repeats_; }

  // In the function of the property: declares what the rows of these parts mean, once.
  void declare(const std::vector<Part>& parts, const Operand& operand, Code& out);
  // What a value joins.
  std::string joined(const ir::Op& join, const std::vector<Part>& parts, const Operand& operand);

 private:
  [[nodiscard]] std::string name(const char* what, std::size_t index) const;
  [[nodiscard]] std::string type(bool is_quantity) const;
  [[nodiscard]] std::string table(std::size_t index) const;
  [[nodiscard]] std::string row_type(std::size_t index) const;
  [[nodiscard]] std::vector<std::string> parameters(std::size_t index) const;
  [[nodiscard]] std::string passed(std::size_t index, const std::string& suffix) const;
  [[nodiscard]] std::string start(const char* what, std::size_t index,
                                  const std::vector<std::string>& more) const;
  void rows(std::size_t index, Code& out) const;
  void each(std::size_t index, const Body& body, Code& out);
  void all(std::size_t index, Code& out);
  void pool(const std::string& name, bool is_quantity, const std::vector<ir::ValueId>& values,
            const Operand& operand, Code& out) const;
  std::string two(const ir::Op& join, const std::string& a, const std::string& b);

  const WatchKernel& kernel_;
  const ir::Block& property_;
  const Repeats& repeats_;
  const std::string monitor_, function_;
  std::set<std::string>& uses_;
  std::vector<bool> looks_;  // by what is repeated: whether it asks for the view
  std::set<std::size_t> declared_;
};

// The values of a property that are written one by one, operands first; `repeats`: or null.
std::vector<ir::ValueId> written_values(const ir::Block& property, const RepeatPrinter* repeats);

}  // namespace rtac::codegen
