// What monitors ask of a place beside being clear of boundaries, once more: charge for a way that
// begins there, heights, and agents who are farther away than anybody knows of.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

struct Spot {
  geometry::Point at;
  std::optional<Rational> z{};    // none: at a height that suits
  std::set<std::string> zones{};  // in which it is said to lie
};

// What a claim says of where it is.
Spot spot_of(const Claim& claim);

// The large side of a comparison less the small one, as far as it speaks of others.
struct OfOthers {
  std::map<sema::AgentId, Rational> agents;  // each times its number, as all of these
  Rational robots = 0;
  bool counts_more = false, counts_less = false;
  Rational rest = 0;  // the least, whatever its parameters become
};
// nullopt: it speaks of something else, too.
std::optional<OfOthers> of_others(const sema::Expr& large, const sema::Expr& small,
                                  const sema::Spec& spec);
// Whether a comparison that has to be true, or false, asks for one agent to be far, and no more.
bool far_agent(const sema::Spec& spec, const sema::Expr& comparison, bool value);
// Whether nothing is known of agents who are as far away as that, but that one is absent.
bool is_out_of_sight(const sema::Spec& spec, const sema::Decision& decision, sema::AgentId agent,
                     const Rational& least);
// Whether a part of the property asks for such a distance.
bool asks_out_of_sight(const sema::Spec& spec, const sema::Decision& decision,
                       const sema::Expr& property);

class AtPlace {
 public:
  AtPlace(const sema::Spec& spec, const sema::Decision& decision, Claims& claims)
      : spec_(spec), decision_(decision), claims_(claims) {}

  // Whether an expression asks for charge, or for a height.
  static bool asks(const sema::Expr& e, bool heights);
  // Whether a full battery lets a robot at rest be given back by what a monitor says, as far ahead
  // as it looks, and by its return condition.
  bool gives_back(const sema::Monitor& m, const Spot& spot);
  bool lets_go(const sema::Monitor& m, const Spot& spot);
  // Whether what it says is seen there, heights included.
  bool is_seen(const sema::Monitor& m, const Spot& spot);
  // Where a way may lead that some monitor asks charge for, and anywhere else.
  [[nodiscard]] std::vector<Spot> sites() const;

 private:
  // How a monitor looks at a place.
  struct Look {
    Rational within = 0, takes = 0, errs = 0, rest = 0;
    std::optional<sema::SiteId> home{};
    bool heights = false;
  };
  // The ways of a route from the cells of its zone.
  struct Ways;
  [[nodiscard]] Look ahead_of(const sema::Monitor& m);
  [[nodiscard]] Look seen_now() const;
  bool holds(const sema::Expr& e, bool value, const Look& look, const Spot& spot);
  bool holds(const sema::Logic& v, bool value, const Look& look, const Spot& spot);
  bool is(const sema::Expr& e, bool value, const Look& look, const Spot& spot);
  bool is(const sema::Compare& v, bool value, const Look& look, const Spot& spot);
  bool compares(const sema::Compare& v, bool value, const Look& look, const Spot& spot);
  bool lies_in(sema::ZoneId zone, const Spot& spot);
  bool is_enough(const std::optional<sema::SiteId>& site, const Rational& reserve, const Look& look,
                 const Spot& spot);
  // At least what the way takes from within `within` of there. nullopt: there is none.
  std::optional<Rational> price(sema::SiteId site, const geometry::Point& at,
                                const Rational& within);
  std::optional<Rational> price(const sema::Controller& c, const geometry::Point& at,
                                const Rational& within);
  std::shared_ptr<const Ways> ways_of(const sema::Controller& c);

  const sema::Spec& spec_;
  const sema::Decision& decision_;
  Claims& claims_;
  std::map<const sema::Controller*, std::shared_ptr<const Ways>> ways_;
};

}  // namespace rtac::recheck
