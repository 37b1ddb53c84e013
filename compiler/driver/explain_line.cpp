#include "compiler/driver/explain_line.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <ostream>
#include <system_error>

#include "compiler/driver/driver.h"
#include "compiler/driver/files.h"
#include "compiler/driver/sim.h"
#include "compiler/ir/source_text.h"

namespace rtac::driver {
namespace {

struct Lines {
  std::uint32_t first, last;
  [[nodiscard]] bool has(std::uint32_t line) const { return first <= line && line <= last; }
};
Lines lines_of(const Compilation& c, const SourceRange& range) {
  const std::uint32_t last = range.end > range.begin ? range.end - 1 : range.begin;
  return {c.sources.position(range.file, range.begin).line,
          c.sources.position(range.file, last).line};
}

std::uint32_t line_count(const Compilation& c, FileId file) {
  const auto text = c.sources.text(file);
  const auto breaks = static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n'));
  return breaks + (text.empty() || text.back() != '\n' ? 1 : 0);
}

// The number of a line, as many digits as it may have; 0: there is no such line.
std::uint32_t line_of(const std::string& digits, std::uint32_t lines) {
  std::uint32_t line = 0;
  const char* const end = digits.data() + digits.size();
  const bool fits = std::from_chars(digits.data(), end, line).ec == std::errc();
  return fits && line <= lines ? line : 0;
}

int refuse(Compilation& c, std::string message, std::string help) {
  c.diagnostics.report(
      {diag::Code::usage, std::nullopt, std::move(message), "", {}, std::move(help), {}});
  return exit_usage;
}

// The nearest lines before and behind that something is known of.
std::string nearest(const std::vector<Lines>& known, std::uint32_t line) {
  std::optional<std::uint32_t> above, below;
  for (const Lines& lines : known) {
    if (lines.last < line) above = std::max(above.value_or(lines.last), lines.last);
    if (lines.first > line) below = std::min(below.value_or(lines.first), lines.first);
  }
  if (above && below) {
    return "lines " + std::to_string(*above) + " and " + std::to_string(*below) +
           " are the nearest that have something";
  }
  if (!above && !below) return "no line of it has something";
  return "line " + std::to_string(above ? *above : *below) + " is the nearest that has something";
}

// The file that the line is of; none: the specification has no such part, which is reported.
std::optional<FileId> file_of(const Options& options, Compilation& c) {
  if (options.part.empty()) return FileId{};  // the one that was named is read first
  std::string others;
  for (std::uint32_t i = 0; i < c.sources.file_count(); ++i) {
    const std::string& path = c.sources.path(FileId{i});
    if (same_file(path, options.part)) return FileId{i};
    if (i > 0) others += (others.empty() ? "`" : ", `") + path + "`";
  }
  const std::string main = "`" + c.sources.path(FileId{}) + "`";
  refuse(c, "`" + options.part + "` is no part of " + main,
         others.empty() ? main + " imports nothing" : "it imports " + others);
  return std::nullopt;
}

}  // namespace

int explain_line(const Options& options, Compilation& c, std::ostream& out) {
  const std::optional<FileId> part = file_of(options, c);
  if (!part) return exit_usage;
  const FileId file = *part;
  const std::string& path = c.sources.path(file);
  const std::uint32_t lines = line_count(c, file);
  const std::uint32_t line = line_of(options.line, lines);
  if (line == 0) {
    return refuse(c, "there is no line " + options.line + " in `" + path + "`",
                  "its lines are 1 to " + std::to_string(lines));
  }
  const std::string place = path + ":" + std::to_string(line);
  std::vector<Remark> all = robot_remarks(c);
  for (std::vector<Remark> more : {declared_remarks(c), watch_remarks(c), import_remarks(c)}) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  }
  std::erase_if(all, [&](const Remark& remark) { return remark.source.file != file; });
  std::vector<Lines> known;
  known.reserve(all.size());
  for (const Remark& remark : all) known.push_back(lines_of(c, remark.source));
  if (std::none_of(known.begin(), known.end(), [&](const Lines& l) { return l.has(line); })) {
    return refuse(c, "nothing is derived for `" + place + "`", nearest(known, line));
  }
  out << place << ": " << ir::one_line(c.sources.line_text(file, line)) << "\n";
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!known[i].has(line)) continue;
    out << "\n" << all[i].text << "\n";
    for (const std::string& detail : all[i].details) out << "  " << detail << "\n";
  }
  if (!options.simulated.empty()) return simulate_shares(options.simulated, options, c, out);
  return exit_clean;
}

}  // namespace rtac::driver
