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

std::string take_input(const DecisionInterface::Input& input, const std::string& stamp,
                       const std::string& valid,
                       const std::function<std::string(std::size_t, std::size_t)>& end) {
  constexpr std::size_t bits = 32;  // of a word of `between`
  const std::string sample = "  in.facts." + input.sample + ".";
  const auto between = [&](std::size_t word) {
    return sample + "between" + (input.between_words > 1 ? "[" + std::to_string(word) + "]" : "");
  };
  std::string out =
      sample + "stamp_us = " + stamp + ";\n" + sample + "valid = (int32_t)" + valid + ";\n";
  for (std::size_t w = 0; w < input.between_words; ++w) out += between(w) + " = 0;\n";
  for (std::size_t k = 0; k < input.members.size(); ++k) {
    out += "  in.facts." + input.members[k] + " = " + end(k, 0) + ";\n" + between(k / bits) +
           " |= (uint32_t)(" + end(k, 1) + " > " + end(k, 0) + ") << " + std::to_string(k % bits) +
           ";\n";
  }
  return out;
}

}  // namespace rtac::driver
