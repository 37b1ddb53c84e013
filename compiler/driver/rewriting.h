// A mend, as it is written into a specification, and taken out again.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "compiler/sema/spec.h"
#include "compiler/verify/obligation.h"

namespace rtac::driver {

// "`recover back;` in `quiet`", of a specification that it is not written into; "": it cannot be.
std::string text_of(const sema::Spec& spec, const verify::Mend& mend);

// What is written in a specification is something else for as long as this is there.
class Rewriting {
 public:
  Rewriting(sema::Spec& spec, const verify::Mend& mend);
  Rewriting(const Rewriting&) = delete;
  Rewriting& operator=(const Rewriting&) = delete;
  ~Rewriting() {
    if (undo_) undo_();
  }
  // false: it cannot be written there, and nothing has changed.
  explicit operator bool() const { return undo_ != nullptr; }

 private:
  std::function<void()> undo_;
};

}  // namespace rtac::driver
