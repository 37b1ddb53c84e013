// Source texts and positions in them. Every later phase refers to text only by SourceRange.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rtac {

enum class FileId : std::uint32_t {};

// Half-open range of bytes [begin, end) of one file.
struct SourceRange {
  FileId file{};
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  friend bool operator==(const SourceRange&, const SourceRange&) = default;
};

// 1-based; the column counts bytes.
struct LineColumn {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};

// The whole file; nullopt: it cannot be opened or read, or is larger than
// SourceManager::file_bytes_max. `why` receives the reason.
std::optional<std::string> read_file(const std::string& path, std::string& why);

class SourceManager {
 public:
  // Offsets are 32 bit, and a specification is a page: anything larger is a mistake in the path.
  static constexpr std::size_t file_bytes_max = std::size_t{64} << 20;
  // `path` is kept as it is shown to the user (as given on the command line or resolved by an
  // import relative to its importer).
  FileId add(std::string path, std::string text);
  // Lines of a file that is not kept as a whole: the text starts `line` (1-based), `offset` bytes
  // into the file.
  FileId add_part(std::string path, std::string text, std::uint32_t line, std::uint64_t offset);
  // nullopt: the file cannot be opened or read; `why` receives the system's reason.
  std::optional<FileId> load(const std::string& path, std::string& why);

  [[nodiscard]] const std::string& path(FileId file) const;
  [[nodiscard]] std::string_view text(FileId file) const;
  [[nodiscard]] std::string_view text(const SourceRange& range) const;
  [[nodiscard]] LineColumn position(FileId file, std::uint32_t offset) const;
  // Bytes from the start of the file, of which `offset` is one in the text that is kept.
  [[nodiscard]] std::uint64_t offset_in_file(FileId file, std::uint32_t offset) const;
  // The line without its line break; `line` is 1-based.
  [[nodiscard]] std::string_view line_text(FileId file, std::uint32_t line) const;
  [[nodiscard]] std::size_t file_count() const { return files_.size(); }

 private:
  struct File {
    std::string path;
    std::string text;
    std::vector<std::uint32_t> line_starts;
    std::uint32_t first_line = 1;
    std::uint64_t first_offset = 0;
  };
  [[nodiscard]] const File& get(FileId file) const;
  std::vector<File> files_;
};

}  // namespace rtac
