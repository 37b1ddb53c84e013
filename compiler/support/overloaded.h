// One function object of several, a case each, for std::visit.
#pragma once

namespace rtac {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace rtac
