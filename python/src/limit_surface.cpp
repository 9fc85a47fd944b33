// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Control.h"

#include <CGAL/PN_limit_surface_3/Limit_surface.h>
#include <CGAL/PN_limit_surface_3/Limit_surface_queries.h>

#include <limits>
#include <memory>
#include <mutex>

namespace pn_python {
namespace {

using Surface = PN::Limit_surface<Mesh, Kernel>;
using Queries = PN::Limit_surface_queries<Mesh, Kernel>;

using Triple = std::array<double, 3>;

// a row of NumPy
struct Hit
{
  std::int64_t face;
  std::array<double, 2> uv;
  Triple point, normal;
  double distance, error;
};

template <class Point_or_vector>
Triple to_triple(const Point_or_vector& p)
{
  return {p.x(), p.y(), p.z()};
}

class Limit_surface
{
public:
  Limit_surface(const Control& c, double tolerance, double normal_tolerance)
  {
    const auto tolerances = PN::parameters::tolerance(tolerance).normal_tolerance(normal_tolerance);
    run(c.threads, [&] {
      with_parameters(c, [&](const auto& scheme, const auto& np, auto) {
        surface_ = std::make_unique<Surface>(c.mesh, scheme, PN::parameters::join(tolerances, np));
      });
    });
  }

  // of each place point, normal, derivatives by u, v, uu, uv, vv, their order, errors of point and normal
  py::array_t<double> evaluate(const Integers& faces, const Reals& uv) const
  {
    std::vector<Surface::Location> places;
    for (std::size_t i = 0; i < std::size_t(faces.size()); ++i)
      places.push_back(
        {Mesh::Face_index(std::uint32_t(faces.data()[i])), uv.data()[2 * i], uv.data()[2 * i + 1]});
    std::vector<double> rows;
    run(1, [&] {
      for (const auto& p : surface_->evaluate(places)) {
        for (const Vector_3& x :
             {p.point - CGAL::ORIGIN, p.normal, p.du, p.dv, p.duu, p.duv, p.dvv})
          rows.insert(rows.end(), x.cartesian_begin(), x.cartesian_end());
        rows.insert(rows.end(), {double(p.derivatives), p.error, p.normal_error});
      }
    });
    return to_array(rows);
  }
  py::array_t<Hit> closest(const Reals& points)
  {
    return hits(std::size_t(points.shape(0)), [&](std::size_t i) {
      return std::optional<Queries::Hit>(queries_->closest_point(point_at(points.data(), i)));
    });
  }
  py::array_t<Hit> intersect(const Reals& sources, const Reals& directions)
  {
    return hits(std::size_t(sources.shape(0)), [&](std::size_t i) {
      return queries_->first_intersection(point_at(sources.data(), i),
                                          vector_at(directions.data(), i));
    });
  }

private:
  template <class Function>
  py::array_t<Hit> hits(std::size_t number, const Function& find)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Triple none{nan, nan, nan};
    std::vector<Hit> found(number, {-1, {nan, nan}, none, none, nan, nan});
    run(1, [&] {
      std::call_once(is_made_, [&] { queries_ = std::make_unique<Queries>(*surface_); });
      for (std::size_t i = 0; i < number; ++i)
        if (const std::optional<Queries::Hit> h = find(i))
          found[i] = {std::int64_t(h->location.face),
                      {h->location.u, h->location.v},
                      to_triple(h->point),
                      to_triple(h->normal),
                      h->distance,
                      h->error};
    });
    return to_array(found);
  }

  std::unique_ptr<Surface> surface_;
  std::unique_ptr<Queries> queries_;
  std::once_flag is_made_;
};

} // namespace

void add_limit_surface(py::module_& module)
{
  PYBIND11_NUMPY_DTYPE(Hit, face, uv, point, normal, distance, error);
  py::class_<Limit_surface>(module, "Limit_surface")
    .def(py::init<const Control&, double, double>())
    .def("evaluate", &Limit_surface::evaluate)
    .def("closest", &Limit_surface::closest)
    .def("intersect", &Limit_surface::intersect);
}

} // namespace pn_python
