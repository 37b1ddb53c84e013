#include "rtac/sim/statistics.h"

#include <algorithm>

#include "rtac/sim/math.h"
#include "rtac/sim/random.h"

namespace rtac::sim {

double mean(const std::vector<double>& values) {
  if (values.empty()) return 0;
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double place = clamp(share, 0, 1) * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  const double part = place - static_cast<double>(below);
  return values[below] + part * (values[above] - values[below]);
}

Interval paired_bootstrap(const std::vector<double>& before, const std::vector<double>& after,
                          const BootstrapOptions& options) {
  const std::size_t count = std::min(before.size(), after.size());
  if (count == 0 || options.resamples < 1) return {};
  std::vector<double> differences(count);
  for (std::size_t i = 0; i < count; ++i) differences[i] = after[i] - before[i];
  Random random(options.seed);
  std::vector<double> means(static_cast<std::size_t>(options.resamples));
  for (double& resampled : means) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      sum += differences[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(count)))];
    }
    resampled = sum / static_cast<double>(count);
  }
  const double tail = 0.5 * (1 - options.level);
  return {quantile(means, tail), mean(differences), quantile(means, 1 - tail)};
}

}  // namespace rtac::sim
