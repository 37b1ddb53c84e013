#include "rtac/status.h"

namespace rtac {

const char* status_text(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::full:
      return "no room left";
    case Status::io_error:
      return "file operation failed";
    case Status::bad_argument:
      return "arguments do not fit together";
    case Status::stopped:
      return "stopped by the platform";
  }
  return "unknown status";
}

}  // namespace rtac
