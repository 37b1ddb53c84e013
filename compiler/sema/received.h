// Zones that are received while the monitors run, as robots are held against them.
#pragma once

#include <optional>
#include <variant>

#include "compiler/sema/spec.h"

namespace rtac::sema {

// The zone, the input that it is received by, and whether a robot has to stay outside.
struct ReceivedBy {
  ZoneId zone;
  InputId input;
  bool outside = false;
};
// none: what it is is known before.
inline std::optional<ReceivedBy> received_by(const Spec& spec, ZoneId zone) {
  const auto* complement = std::get_if<ZoneComplement>(&spec[zone].value->node);
  const ZoneId of = complement != nullptr ? complement->zone : zone;
  const auto* received = std::get_if<ZoneReceived>(&spec[of].value->node);
  if (received == nullptr) return std::nullopt;
  return ReceivedBy{of, received->input, complement != nullptr};
}

}  // namespace rtac::sema
