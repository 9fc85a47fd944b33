#include "Creased_refinement.h"

namespace pn_demo {

std::unique_ptr<Refinement> make_pn_refinement_with_creases(const Control_mesh& mesh,
                                                            const Scheme& scheme, unsigned rounds)
{
  return std::visit(
    [&](const auto& s) -> std::unique_ptr<Refinement> {
      if constexpr (pn_subdivide::can_crease<std::decay_t<decltype(s)>>) {
        const auto chosen = s;
        using S = std::decay_t<decltype(chosen)>;
        return std::make_unique<Creased_refinement<S, false>>(mesh, chosen, rounds);
      } else
        return nullptr;
    },
    scheme);
}

} // namespace pn_demo
