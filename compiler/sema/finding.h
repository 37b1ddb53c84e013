// One diagnostic under construction: reads at the place of use like the message it becomes.
#pragma once

#include <string>
#include <utility>

#include "compiler/diagnostics/engine.h"

namespace rtac::sema {

class Finding {
 public:
  Finding(diag::Code code, const SourceRange& range, std::string message) {
    diagnostic_.code = code;
    diagnostic_.range = range;
    diagnostic_.message = std::move(message);
  }
  Finding& label(std::string text) {
    diagnostic_.label = std::move(text);
    return *this;
  }
  Finding& note(const SourceRange& range, std::string text) {
    diagnostic_.notes.push_back({range, std::move(text)});
    return *this;
  }
  Finding& help(std::string text) {
    diagnostic_.help = std::move(text);
    return *this;
  }
  Finding& replace(const SourceRange& range, std::string text) {
    diagnostic_.fixits.push_back({range, std::move(text)});
    return *this;
  }
  // Behind the last byte of `range`.
  Finding& insert_after(const SourceRange& range, std::string text) {
    return replace({range.file, range.end, range.end}, std::move(text));
  }
  [[nodiscard]] const diag::Diagnostic& diagnostic() const { return diagnostic_; }

 private:
  diag::Diagnostic diagnostic_;
};

}  // namespace rtac::sema
