// The decision log of one robot as a CSV file. Opening allocates; writing does not.
#pragma once

#include <array>
#include <cstdio>

#include "rtac/decision_text.h"
#include "rtac/status.h"

namespace rtac {

class CsvLog {
 public:
  CsvLog() = default;
  ~CsvLog();
  CsvLog(const CsvLog&) = delete;
  CsvLog& operator=(const CsvLog&) = delete;

  // Creates or replaces the file; the header is written with the first record.
  Status open(const char* path);
  // The first failure is kept: every later call returns it too.
  Status write(const DecisionRecord& record);
  Status close();

 private:
  Status put(const char* text, std::size_t length);

  std::FILE* file_ = nullptr;
  bool header_written_ = false;
  Status failed_ = Status::ok;
  std::array<char, 65536> file_buffer_{};
  std::array<char, csv_row_bytes_max> row_{};
};

}  // namespace rtac
