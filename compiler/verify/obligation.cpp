#include "compiler/verify/obligation.h"

#include <algorithm>
#include <array>

namespace rtac::verify {

const char* name(Kind kind) {
  switch (kind) {
    case Kind::p1a:
      return "P1a";
    case Kind::p1b:
      return "P1b";
    case Kind::p2a:
      return "P2a";
    case Kind::p2b:
      return "P2b";
    case Kind::p3:
      return "P3";
    case Kind::keeps:
      return "C";
    case Kind::satisfiable:
      return "satisfiable";
    case Kind::not_vacuous:
      return "not vacuous";
    case Kind::joint_return:
      return "joint return";
    case Kind::switching:
      return "switching";
    case Kind::initial:
      return "initial";
  }
  return "";
}

const char* name(Status status) {
  switch (status) {
    case Status::proved:
      return "proved";
    case Status::refuted:
      return "refuted";
    case Status::unknown:
      return "unknown";
    case Status::acknowledged:
      return "acknowledged";
  }
  return "";
}

std::string by_diagnostic(diag::Code code) {
  return "diagnostic " + std::to_string(static_cast<int>(code));
}

Status worst(const Report& report) {
  constexpr std::array order = {Status::refuted, Status::unknown, Status::acknowledged};
  for (const Status status : order) {
    for (const Decision& d : report.decisions) {
      const auto has = [&](const Obligation& o) { return o.status == status; };
      if (std::any_of(d.obligations.begin(), d.obligations.end(), has)) return status;
    }
  }
  return Status::proved;
}

}  // namespace rtac::verify
