// Small sample statistics for campaigns.
#pragma once

#include <cstdint>
#include <vector>

namespace rtac::sim {

double mean(const std::vector<double>& values);  // 0 for none
// Linear interpolation between order statistics; `share` in [0, 1]; 0 for no values.
double quantile(std::vector<double> values, double share);

struct Interval {
  double lo = 0, centre = 0, hi = 0;
};
struct BootstrapOptions {
  std::uint64_t seed = 1;
  int resamples = 10'000;
  double level = 0.95;
};
// Percentile bootstrap interval of mean(after[i] - before[i]): pairs are drawn, never single
// values. The lists have equal lengths (the excess of the longer one is ignored).
Interval paired_bootstrap(const std::vector<double>& before, const std::vector<double>& after,
                          const BootstrapOptions& options = {});

}  // namespace rtac::sim
