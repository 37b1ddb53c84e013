// A zone that a trace says was received, in the layout that generated kernels take it in.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "compiler/interp/received.h"

namespace rtac::driver {

class HeldZone {
 public:
  struct Outline {
    const std::int32_t* edges;
    const std::uint32_t *cells, *lists;
    std::int32_t edge_count, cell_count, list_count;
    std::int32_t x, y, shift, column, row, columns, rows, depth, leaves;
  };
  struct Zone {
    std::uint64_t checksum;
    std::uint32_t version;
    Outline within, around;
  };
  // The one before goes.
  void hold(std::shared_ptr<const interp::ReceivedZone> received);
  // What it points to stays where it is until another one is held.
  [[nodiscard]] const Zone& zone() const { return zone_; }

 private:
  std::shared_ptr<const interp::ReceivedZone> received_;
  std::vector<std::int32_t> within_, around_;
  Zone zone_{};
};

}  // namespace rtac::driver
