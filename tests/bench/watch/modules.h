// The generated monitors over one window, each behind the same members: state, inputs, entries.
#pragma once

#include "once_1000000_kernel.h"
#include "once_1000_kernel.h"
#include "once_10_kernel.h"
#include "since_1000000_kernel.h"
#include "since_1000_kernel.h"
#include "since_10_kernel.h"

namespace rtac::bench {

template <class StateOf, class VerdictsStateOf, class InOf, class OutOf, auto init_of, auto step_of,
          auto verdicts_init_of, auto verdicts_of>
struct Module {
  using State = StateOf;
  using VerdictsState = VerdictsStateOf;
  using In = InOf;
  using Out = OutOf;
  static constexpr auto init = init_of;
  static constexpr auto step = step_of;
  static constexpr auto verdicts_init = verdicts_init_of;
  static constexpr auto verdicts = verdicts_of;
};

#define RTAC_BENCH_MODULE(name)                                                     \
  Module<name##_monitors_state, name##_monitors_verdicts_state, name##_monitors_in, \
         name##_monitors_out, name##_monitors_init, name##_monitors_step,           \
         name##_monitors_verdicts_init, name##_monitors_verdicts>
using OnceShort = RTAC_BENCH_MODULE(once_10);
using OnceMiddle = RTAC_BENCH_MODULE(once_1000);
using OnceLong = RTAC_BENCH_MODULE(once_1000000);
using SinceShort = RTAC_BENCH_MODULE(since_10);
using SinceMiddle = RTAC_BENCH_MODULE(since_1000);
using SinceLong = RTAC_BENCH_MODULE(since_1000000);
#undef RTAC_BENCH_MODULE

// `once` has one condition, `since` two.
template <class In>
concept HasCalm = requires(In in) {
  in.calm;
};

}  // namespace rtac::bench
