// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/surface_schemes.h"

#include "io/Error.h"
#include "surface/Surface.h"

#include <CGAL/PN_subdivision_3.h>

#include <type_traits>
#include <utility>
#include <variant>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

namespace pn_subdivide {
namespace {

namespace PN = CGAL::PN_subdivision_3;

constexpr double default_tension = 1. / 16;
constexpr double default_cap = 1. / 2;

struct Round_visitor
{
  template <class Round, class Number>
  void round_done(Round k, Number faces) const
  {
    if (report) report(static_cast<unsigned>(k), static_cast<std::size_t>(faces));
  }

  std::function<void(unsigned, std::size_t)> report;
};

// With one thread the result is the same, bit for bit.
using Tag = CGAL::Parallel_if_available_tag;

template <class Scheme>
Mesh_data refine_linearly(const Mesh_data& mesh, const Scheme& scheme, const Refinement& refinement)
{
  Surface surface = make_surface(mesh);
  PN::subdivide<Tag>(surface, PN::linear(scheme),
                     CGAL::parameters::number_of_iterations(refinement.levels)
                       .visitor(Round_visitor{refinement.round_done}));
  return to_mesh_data(surface);
}

template <class Scheme>
Mesh_data refine_with_normals(const Mesh_data& mesh, const Scheme& scheme,
                              const Refinement& refinement)
{
  Surface surface = make_surface(mesh);
  auto normals = surface.add_property_map<Surface::Vertex_index, Vector_3>("v:normal").first;
  for (const Surface::Vertex_index v : surface.vertices()) normals[v] = mesh.normals[v];
  PN::subdivide<Tag>(surface, scheme,
                     CGAL::parameters::number_of_iterations(refinement.levels)
                       .vertex_normal_map(normals)
                       .visitor(Round_visitor{refinement.round_done}));
  Mesh_data refined = to_mesh_data(surface);
  refined.normals.reserve(refined.points.size());
  for (const Surface::Vertex_index v : surface.vertices()) refined.normals.push_back(normals[v]);
  return refined;
}

// All schemes. A new scheme of the library is a new type here and a new line in parse_scheme().
using Scheme = std::variant<PN::CatmullClark_scheme, PN::Kobbelt_scheme, PN::Loop_scheme,
                            PN::Butterfly_scheme, PN::DooSabin_scheme, PN::Sqrt3_scheme,
                            PN::modified_CatmullClark_scheme, PN::modified_Loop_scheme>;

Scheme parse_scheme(const char* option, const std::string& name, const Scheme_choice& choice)
{
  const double tension = choice.tension.value_or(default_tension);
  const double cap = choice.cap.value_or(default_cap);
  const std::pair<const char*, Scheme> schemes[] = {
    {"catmull-clark", PN::CatmullClark_scheme()},
    {"kobbelt", PN::Kobbelt_scheme(tension)},
    {"loop", PN::Loop_scheme()},
    {"butterfly", PN::Butterfly_scheme()},
    {"doo-sabin", PN::DooSabin_scheme()},
    {"sqrt3", PN::Sqrt3_scheme()},
    {"modified-catmull-clark", PN::modified_CatmullClark_scheme(cap)},
    {"modified-loop", PN::modified_Loop_scheme(cap)},
  };
  std::string known;
  for (const auto& [scheme_name, scheme] : schemes) {
    if (name == scheme_name) return scheme;
    known += std::string(known.empty() ? "" : ", ") + scheme_name;
  }
  throw Usage_error(option + (" '" + name) + "': there is no such scheme, only " + known);
}

template <class S, class T>
constexpr bool have_same_host = std::is_same_v<typename S::Host, typename T::Host>;

Mesh_data refine(const Mesh_data& mesh, const Scheme& scheme, const Refinement& refinement)
{
  return std::visit(
    [&](const auto& s) {
      return mesh.has_normals() ? refine_with_normals(mesh, s, refinement)
                                : refine_linearly(mesh, s, refinement);
    },
    scheme);
}

Mesh_data refine(const Mesh_data& mesh, const Scheme& scheme, const Scheme& normal_scheme,
                 const Refinement& refinement)
{
  return std::visit(
    [&](const auto& s, const auto& t) -> Mesh_data {
      using S = std::decay_t<decltype(s)>;
      using T = std::decay_t<decltype(t)>;
      if constexpr (have_same_host<S, T> && !std::is_same_v<S, T>)
        return refine_with_normals(mesh, PN::with_normal_scheme(s, t), refinement);
      else
        return refine(mesh, scheme, refinement);
    },
    scheme, normal_scheme);
}

void require_same_host(const Scheme_choice& choice, const Scheme& scheme,
                       const Scheme& normal_scheme)
{
  const bool same = std::visit(
    [](const auto& s, const auto& t) {
      return have_same_host<std::decay_t<decltype(s)>, std::decay_t<decltype(t)>>;
    },
    scheme, normal_scheme);
  if (!same)
    throw Usage_error("--normal-scheme " + *choice.normal_scheme + " does not go with --scheme " +
                      choice.scheme + ": they split the faces differently");
}

bool is_modified(const std::string& scheme)
{
  return scheme == "modified-catmull-clark" || scheme == "modified-loop";
}

} // namespace

void require_surface_schemes(const Scheme_choice& choice)
{
  if (choice.tension && choice.scheme != "kobbelt" && choice.normal_scheme != "kobbelt")
    throw Usage_error("--tension belongs to the scheme kobbelt");
  if (choice.tension && !(*choice.tension > -0.5 && *choice.tension < 0.5))
    throw Usage_error("--tension must lie between -1/2 and 1/2");
  if (choice.cap && !is_modified(choice.scheme) &&
      !(choice.normal_scheme && is_modified(*choice.normal_scheme)))
    throw Usage_error("--cap belongs to the schemes modified-catmull-clark and modified-loop");
  if (choice.cap && !(*choice.cap > 0 && *choice.cap <= 1))
    throw Usage_error("--cap must be greater than 0 and at most 1");
  const Scheme scheme = parse_scheme("--scheme", choice.scheme, choice);
  if (choice.normal_scheme)
    require_same_host(choice, scheme,
                      parse_scheme("--normal-scheme", *choice.normal_scheme, choice));
}

void require_threads(unsigned threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  (void)threads;
#else
  if (threads > 1)
    throw Usage_error("--threads: this program was built without TBB and has one thread only");
#endif
}

Mesh_data refine_surface(const Mesh_data& mesh, const Scheme_choice& choice,
                         const Refinement& refinement)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, refinement.threads);
#endif
  const Scheme scheme = parse_scheme("--scheme", choice.scheme, choice);
  if (!choice.normal_scheme || !mesh.has_normals()) return refine(mesh, scheme, refinement);
  return refine(mesh, scheme, parse_scheme("--normal-scheme", *choice.normal_scheme, choice),
                refinement);
}

} // namespace pn_subdivide
