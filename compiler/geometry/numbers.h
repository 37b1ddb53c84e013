// Internal to this folder.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

namespace rtac::geometry {

// Numbers from 0 on, the same for the same key.
class Numbers {
 public:
  int of(std::vector<std::int32_t> key) {
    return known_.try_emplace(std::move(key), static_cast<int>(known_.size())).first->second;
  }

 private:
  std::map<std::vector<std::int32_t>, int> known_;
};

}  // namespace rtac::geometry
