#include "Refiner_refinement.h"

#include <CGAL/PN_subdivision_3.h>

namespace pn_demo {

std::unique_ptr<Refinement> make_pn_refinement(const Control_mesh& mesh, const Scheme& scheme,
                                               unsigned rounds)
{
  return std::visit(
    [&](const auto& s) -> std::unique_ptr<Refinement> {
      using S = std::decay_t<decltype(s)>;
      if constexpr (pn_subdivide::Transfers_curvature<S>::value)
        return nullptr;
      else
        return std::make_unique<Refiner_refinement<S, false>>(mesh, s, rounds);
    },
    scheme);
}

} // namespace pn_demo
