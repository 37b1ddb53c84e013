#include "compiler/support/source.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>

namespace rtac {
namespace {

std::vector<std::uint32_t> find_line_starts(std::string_view text) {
  std::vector<std::uint32_t> starts{0};
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') starts.push_back(static_cast<std::uint32_t>(i + 1));
  }
  return starts;
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

std::optional<std::string> read_file(const std::string& path, std::string& why) {
  errno = 0;
  const std::unique_ptr<std::FILE, CloseFile> file{std::fopen(path.c_str(), "rb")};
  if (!file) {
    why = std::strerror(errno);
    return std::nullopt;
  }
  std::string text;
  std::vector<char> block(std::size_t{1} << 16);
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
    text.append(block.data(), count);
    if (text.size() > SourceManager::file_bytes_max) {
      why = "the file is larger than 64 MiB";
      return std::nullopt;
    }
  }
  if (std::ferror(file.get())) {
    why = std::strerror(errno);  // a directory opens, but does not read
    return std::nullopt;
  }
  return text;
}

FileId SourceManager::add(std::string path, std::string text) {
  return add_part(std::move(path), std::move(text), 1, 0);
}

FileId SourceManager::add_part(std::string path, std::string text, std::uint32_t line,
                               std::uint64_t offset) {
  auto line_starts = find_line_starts(text);
  files_.push_back({std::move(path), std::move(text), std::move(line_starts), line, offset});
  return FileId{static_cast<std::uint32_t>(files_.size() - 1)};
}

std::optional<FileId> SourceManager::load(const std::string& path, std::string& why) {
  std::optional<std::string> text = read_file(path, why);
  if (!text) return std::nullopt;
  return add(path, std::move(*text));
}

const SourceManager::File& SourceManager::get(FileId file) const {
  return files_.at(static_cast<std::uint32_t>(file));
}

const std::string& SourceManager::path(FileId file) const {
  return get(file).path;
}

std::string_view SourceManager::text(FileId file) const {
  return get(file).text;
}

std::string_view SourceManager::text(const SourceRange& range) const {
  const std::string_view all = text(range.file);
  const std::size_t begin = std::min<std::size_t>(range.begin, all.size());
  const std::size_t end = std::clamp<std::size_t>(range.end, begin, all.size());
  return all.substr(begin, end - begin);
}

LineColumn SourceManager::position(FileId file, std::uint32_t offset) const {
  const File& entry = get(file);
  offset = std::min(offset, static_cast<std::uint32_t>(entry.text.size()));
  const auto& starts = entry.line_starts;
  const auto next = std::upper_bound(starts.begin(), starts.end(), offset);
  const auto lines = static_cast<std::uint32_t>(next - starts.begin() - 1);
  return {entry.first_line + lines, offset - *(next - 1) + 1};
}

std::uint64_t SourceManager::offset_in_file(FileId file, std::uint32_t offset) const {
  return get(file).first_offset + offset;
}

std::string_view SourceManager::line_text(FileId file, std::uint32_t line) const {
  const File& entry = get(file);
  if (line < entry.first_line || line - entry.first_line >= entry.line_starts.size()) return {};
  const std::uint32_t start = entry.line_starts[line - entry.first_line];
  std::string_view rest = std::string_view{entry.text}.substr(start);
  rest = rest.substr(0, rest.find('\n'));
  if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
  return rest;
}

}  // namespace rtac
