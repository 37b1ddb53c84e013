#include "compiler/interp/csv.h"

#include <algorithm>

namespace rtac::interp {
namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 16;
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// Its place is that of the text without the blanks around it.
CsvCell plain_cell(std::string_view record, std::size_t begin, std::size_t end) {
  const std::string_view text = trimmed(record.substr(begin, end - begin));
  if (text.empty()) return {text, begin + 1};
  return {text, static_cast<std::size_t>(text.data() - record.data()) + 1, text.size()};
}

// The line break that ends the record, outside quotes; npos: not in this text.
std::size_t end_of_record(std::string_view text, bool& in_quotes) {
  const std::size_t line_break = text.find('\n');
  in_quotes = false;
  if (text.substr(0, line_break).find('"') == std::string_view::npos) return line_break;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') in_quotes = !in_quotes;
    if (text[i] == '\n' && !in_quotes) return i;
  }
  return std::string_view::npos;
}

// Appends what stands between quotes; the result is the place of the closing one, or the end.
std::size_t take_quoted(std::string_view text, std::size_t at, std::string& to) {
  for (; at < text.size(); ++at) {
    if (text[at] == '"') {
      if (at + 1 == text.size() || text[at + 1] != '"') return at;
      ++at;
    }
    to += text[at];
  }
  return at;
}

}  // namespace

bool CsvReader::refill() {
  buffer_.erase(0, begin_);
  dropped_ += begin_;
  begin_ = 0;
  const std::size_t before = buffer_.size();
  buffer_.resize(before + block_bytes);
  in_.read(buffer_.data() + before, static_cast<std::streamsize>(block_bytes));
  buffer_.resize(before + static_cast<std::size_t>(in_.gcount()));
  at_end_ = in_.gcount() == 0;
  return !at_end_;
}

CsvReader::Result CsvReader::find(std::string_view& record) {
  for (;;) {
    const std::string_view text = std::string_view(buffer_).substr(begin_);
    bool in_quotes = false;
    const std::size_t end = end_of_record(text, in_quotes);
    if (end != std::string_view::npos) {
      record = text.substr(0, end);
      begin_ += end + 1;
      return record.size() > record_bytes_max ? Result::too_long : Result::record;
    }
    if (text.size() > record_bytes_max) {
      record = text.substr(0, record_bytes_max);
      return Result::too_long;
    }
    if (at_end_ || !refill()) {
      record = std::string_view(buffer_).substr(begin_);
      if (in_.bad()) return Result::unreadable;
      if (in_quotes) return Result::unclosed_quote;
      begin_ = buffer_.size();
      return record.empty() ? Result::end : Result::record;
    }
  }
}

CsvReader::Result CsvReader::next(CsvRecord& record) {
  std::string_view text;
  std::size_t skipped = 0;
  do {
    record.cells.clear();
    record.line = line_;
    record.offset = dropped_ + begin_;
    const Result result = find(text);
    record.text = text;
    if (result != Result::record) {
      record.cells.push_back({{}, 1});
      return result;
    }
    line_ += 1 + static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
    const bool marked = !started_ && text.substr(0, byte_order_mark.size()) == byte_order_mark;
    skipped = marked ? byte_order_mark.size() : 0;
    started_ = true;
    text.remove_prefix(skipped);
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  } while (text.empty());
  const bool plain = text.find('"') == std::string_view::npos;
  const Result result = plain ? split(text, record) : split_quoted(text, record);
  for (CsvCell& cell : record.cells) cell.column += skipped;
  return result;
}

CsvReader::Result CsvReader::split(std::string_view text, CsvRecord& record) {
  std::size_t begin = 0;
  for (;;) {
    const std::size_t comma = text.find(',', begin);
    record.cells.push_back(plain_cell(text, begin, std::min(comma, text.size())));
    if (comma == std::string_view::npos) return Result::record;
    begin = comma + 1;
  }
}

// The texts of quoted cells are kept in `cells_`: a doubled quote is one quote.
CsvReader::Result CsvReader::split_quoted(std::string_view text, CsvRecord& record) {
  const auto skip_blanks = [&](std::size_t at) {
    return std::min(text.find_first_not_of(" \t", at), text.size());
  };
  cells_.clear();
  cells_.reserve(text.size());  // the views into it stay
  for (std::size_t at = 0;; ++at) {
    const std::size_t begin = at;
    at = skip_blanks(at);
    if (at < text.size() && text[at] == '"') {
      const std::size_t kept = cells_.size();
      const std::size_t end = take_quoted(text, at + 1, cells_);
      if (end == text.size()) {
        record.cells = {{{}, at + 1}};
        return Result::unclosed_quote;
      }
      record.cells.push_back({std::string_view(cells_).substr(kept), at + 1, end + 1 - at});
      at = skip_blanks(end + 1);
      if (at < text.size() && text[at] != ',') {
        record.cells = {{{}, at + 1}};
        return Result::text_behind_quote;
      }
    } else {
      at = std::min(text.find(',', at), text.size());
      record.cells.push_back(plain_cell(text, begin, at));
    }
    if (at == text.size()) return Result::record;
  }
}

}  // namespace rtac::interp
