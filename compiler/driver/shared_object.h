// Generated C code that runs in this process: compiled by the system's C compiler into a shared
// object.
#pragma once

#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "compiler/driver/files.h"

namespace rtac::driver {

class SharedObject {
 public:
  explicit SharedObject(const std::string& path);
  SharedObject(SharedObject&& other) noexcept;
  SharedObject& operator=(SharedObject&&) = delete;
  ~SharedObject();
  explicit operator bool() const { return handle_ != nullptr; }
  template <class T>
  T* data(const char* name) const {
    return static_cast<T*>(symbol(name));
  }
  template <class F>
  F function(const char* name) const {
    void* const found = symbol(name);
    F result{};
    static_assert(sizeof result == sizeof found);  // POSIX: dlsym serves functions too
    std::memcpy(&result, &found, sizeof result);
    return result;
  }

 private:
  [[nodiscard]] void* symbol(const char* name) const;
  void* handle_;
};

struct BuiltObject {
  std::optional<SharedObject> object;
  std::string problem;  // why there is none
};
// Compiles `glue`, a C file that includes `files` by name, into `folder`/kernel.so; what went
// wrong, empty when all is well.
std::string compile_object(const std::vector<OutputFile>& files, const std::string& glue,
                           const std::string& folder);

// `files` are there while `glue`, a C file that includes them by name, is compiled; nothing stays.
BuiltObject build_object(const std::vector<OutputFile>& files, const std::string& glue);

}  // namespace rtac::driver
