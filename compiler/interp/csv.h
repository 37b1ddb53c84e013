// Records of comma-separated values, as they stream in (RFC 4180: quoted cells, doubled quotes,
// both kinds of line breaks). Empty lines are no records.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace rtac::interp {

struct CsvCell {
  std::string_view text;   // without quotes and outer blanks; valid until the next record
  std::size_t column;      // byte of the cell in its record, from 1
  std::size_t length = 0;  // with its quotes
};
struct CsvRecord {
  std::uint64_t line = 0;    // where it starts, from 1
  std::uint64_t offset = 0;  // in bytes, from 0
  std::string_view text{};   // as it stands there, without its line break; valid until the next one
  std::vector<CsvCell> cells;
};

class CsvReader {
 public:
  // A record is a line of a table; a larger one is no table.
  static constexpr std::size_t record_bytes_max = std::size_t{1} << 20;

  explicit CsvReader(std::istream& in) : in_(in) {}
  enum class Result { record, end, unclosed_quote, too_long, text_behind_quote, unreadable };
  // Of a fault: the record has its place and text, and one cell with the column.
  Result next(CsvRecord& record);

 private:
  // The next record without its line break; what follows starts at `next_`.
  Result find(std::string_view& record);
  bool refill();
  Result split(std::string_view text, CsvRecord& record);
  Result split_quoted(std::string_view text, CsvRecord& record);

  std::istream& in_;
  std::string buffer_, cells_;
  std::uint64_t dropped_ = 0;  // bytes in front of the buffer
  std::size_t begin_ = 0;      // of the next record in the buffer
  std::uint64_t line_ = 1;     // its line
  bool at_end_ = false, started_ = false;
};

}  // namespace rtac::interp
