#include "compiler/driver/glue_readers.h"

namespace rtac::driver {

std::string glue_readers(const std::string& prefix, bool in_space) {
  return "static void rtac_point(" + prefix +
         "_point *to, const int64_t *from) {\n"
         "  to->x_lo = from[0];\n  to->x_hi = from[1];\n"
         "  to->y_lo = from[2];\n  to->y_hi = from[3];\n"
         "  to->stamp_us = from[4];\n  to->valid = (int32_t)from[5];\n" +
         (in_space ? "  to->z_lo = from[6];\n  to->z_hi = from[7];\n}\n" : "}\n") +
         "static void rtac_scalar(" + prefix +
         "_scalar *to, const int64_t *from) {\n"
         "  to->lo = from[0];\n  to->hi = from[1];\n"
         "  to->stamp_us = from[2];\n  to->valid = (int32_t)from[3];\n}\n";
}

}  // namespace rtac::driver
