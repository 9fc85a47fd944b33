// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface_schemes.h"

#include "Error.h"
#include "Surface.h"

#include <CGAL/PN_subdivision_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

namespace pn_subdivide {
namespace {

namespace PN = CGAL::PN_subdivision_3;

struct Round_visitor
{
  template <class Round, class Number>
  void round_done(Round k, Number faces) const
  {
    if (report) report(static_cast<unsigned>(k), static_cast<std::size_t>(faces));
  }

  std::function<void(unsigned, std::size_t)> report;
};

template <class Concurrency_tag, class Scheme>
Mesh_data refine_with(const Mesh_data& mesh, const Scheme& scheme, const Refinement& refinement)
{
  Surface surface = make_surface(mesh);
  Round_visitor visitor{refinement.round_done};
  if (!mesh.has_normals()) {
    PN::subdivide<Concurrency_tag>(
        surface, PN::linear(scheme),
        CGAL::parameters::number_of_iterations(refinement.levels).visitor(visitor));
    return to_mesh_data(surface);
  }

  auto normals = surface.add_property_map<Surface::Vertex_index, Vector_3>("v:normal").first;
  for (const Surface::Vertex_index v : surface.vertices()) normals[v] = mesh.normals[v];
  PN::subdivide<Concurrency_tag>(surface, scheme,
                                 CGAL::parameters::number_of_iterations(refinement.levels)
                                     .vertex_normal_map(normals)
                                     .visitor(visitor));
  Mesh_data refined = to_mesh_data(surface);
  refined.normals.reserve(refined.points.size());
  for (const Surface::Vertex_index v : surface.vertices()) refined.normals.push_back(normals[v]);
  return refined;
}

template <class Scheme>
Mesh_data refine(const Mesh_data& mesh, const Scheme& scheme, const Refinement& refinement)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (refinement.threads > 1) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    refinement.threads);
    return refine_with<CGAL::Parallel_tag>(mesh, scheme, refinement);
  }
#endif
  return refine_with<CGAL::Sequential_tag>(mesh, scheme, refinement);
}

struct Surface_scheme
{
  const char* name;
  Mesh_data (*refine)(const Mesh_data&, const Refinement&);
};

// A new scheme of the library is a new line here.
const Surface_scheme schemes[] = {
    {"catmull-clark",
     [](const Mesh_data& mesh, const Refinement& r) {
       return refine(mesh, PN::CatmullClark_scheme(), r);
     }},
    {"loop",
     [](const Mesh_data& mesh, const Refinement& r) { return refine(mesh, PN::Loop_scheme(), r); }},
};

const char* const later_schemes[] = {
    "doo-sabin", "sqrt3", "butterfly", "kobbelt", "modified-catmull-clark", "modified-loop"};

const Surface_scheme& find_scheme(const std::string& name)
{
  for (const char* later : later_schemes)
    if (name == later) throw Usage_error("--scheme " + name + " is not available yet");
  std::string known;
  for (const Surface_scheme& scheme : schemes) {
    if (name == scheme.name) return scheme;
    known += std::string(known.empty() ? "" : ", ") + scheme.name;
  }
  throw Usage_error("--scheme '" + name + "': there is no such scheme, only " + known);
}

} // namespace

void require_surface_scheme(const std::string& name)
{
  find_scheme(name);
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

Mesh_data refine_surface(const Mesh_data& mesh, const std::string& scheme,
                         const Refinement& refinement)
{
  return find_scheme(scheme).refine(mesh, refinement);
}

} // namespace pn_subdivide
