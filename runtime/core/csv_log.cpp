#include "rtac/csv_log.h"

namespace rtac {

CsvLog::~CsvLog() {
  // A destructor cannot report; whoever needs to know calls close().
  (void)close();
}

Status CsvLog::open(const char* path) {
  if (file_ != nullptr) return Status::bad_argument;
  header_written_ = false;
  failed_ = Status::ok;
  file_ = std::fopen(path, "wb");
  if (file_ == nullptr) {
    failed_ = Status::io_error;
  } else if (std::setvbuf(file_, file_buffer_.data(), _IOFBF, file_buffer_.size()) != 0) {
    failed_ = Status::io_error;
  }
  return failed_;
}

Status CsvLog::put(const char* text, std::size_t length) {
  if (std::fwrite(text, 1, length, file_) != length) failed_ = Status::io_error;
  return failed_;
}

Status CsvLog::write(const DecisionRecord& record) {
  if (failed_ != Status::ok) return failed_;
  if (file_ == nullptr || record.info == nullptr) return Status::bad_argument;
  if (!header_written_) {
    const std::size_t length = csv_header(*record.info, row_.data(), row_.size());
    if (length >= row_.size()) return failed_ = Status::full;
    header_written_ = true;
    if (const Status status = put(row_.data(), length); status != Status::ok) return status;
  }
  const std::size_t length = csv_row(record, row_.data(), row_.size());
  if (length >= row_.size()) return failed_ = Status::full;
  return put(row_.data(), length);
}

Status CsvLog::close() {
  if (file_ == nullptr) return failed_;
  if (std::fclose(file_) != 0 && failed_ == Status::ok) failed_ = Status::io_error;
  file_ = nullptr;
  return failed_;
}

}  // namespace rtac
