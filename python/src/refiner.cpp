// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Control.h"

#include <CGAL/PN_subdivision_3/Surface_refiner.h>

#include <stdexcept>
#include <variant>

namespace pn_python {
namespace {

class Refiner
{
  template <class S>
  using Of = PN::Surface_refiner<Mesh, S, Kernel, Tag>;
  static_assert(sizeof(Point_3) == 3 * sizeof(double) && sizeof(Vector_3) == sizeof(Point_3));

public:
  Refiner(const Control& c, unsigned levels)
    : threads_(c.threads)
  {
    run(threads_, [&] {
      if (c.is_estimated && !c.is_linear) // again, when points move
        refiner_.emplace<Of<Scheme>>(c.mesh, *c.scheme,
                                     PN::parameters::control_normal_estimate(c.estimate)
                                       .border(c.border)
                                       .edge_is_constrained_map(c.edge_sharpness)
                                       .vertex_is_constrained_map(c.vertex_sharpness)
                                       .number_of_iterations(levels));
      else
        with_parameters(c, [&](const auto& scheme, const auto& np, auto) {
          using S = std::decay_t<decltype(scheme)>;
          refiner_.emplace<Of<S>>(c.mesh, scheme, np.number_of_iterations(levels));
        });
    });
  }

  void set_points(const Integers& vertices, const Reals& points)
  {
    const auto set = [&](auto& r) {
      for (std::size_t i = 0; i < std::size_t(vertices.size()); ++i)
        r.set_point(Vertex(std::uint32_t(vertices.data()[i])), point_at(points.data(), i));
    };
    std::visit(set, refiner_);
  }
  void set_normals(const Integers& vertices, const Reals& normals)
  {
    auto* const r = std::get_if<Of<Scheme>>(&refiner_);
    if (r == nullptr)
      throw std::invalid_argument("PN_subdivision_3: a linear scheme has no control normals");
    for (std::size_t i = 0; i < std::size_t(vertices.size()); ++i)
      r->set_normal(Vertex(std::uint32_t(vertices.data()[i])), vector_at(normals.data(), i));
  }
  py::array_t<std::uint32_t> update()
  {
    std::vector<std::uint32_t> changed;
    run(threads_, [&] { changed = std::visit([](auto& r) { return r.update(); }, refiner_); });
    return to_array(changed);
  }

  // views of what the next update() changes
  static py::array points(const py::object& self)
  {
    return std::visit([&](auto& r) { return view(r.points(), self); },
                      self.cast<Refiner&>().refiner_);
  }
  static py::array normals(const py::object& self)
  {
    return std::visit([&](auto& r) { return view(r.normals(), self); },
                      self.cast<Refiner&>().refiner_);
  }
  py::tuple faces() const
  {
    const auto level = std::visit([](const auto& r) { return r.connectivity(); }, refiner_);
    std::vector<std::int64_t> offsets(1, 0), vertices;
    for (std::uint32_t f = 0; f < level.number_of_faces(); ++f) {
      std::uint32_t h = level.halfedge_of_face(f);
      do {
        vertices.push_back(level.target(h));
        h = level.next(h);
      } while (h != level.halfedge_of_face(f));
      offsets.push_back(std::int64_t(vertices.size()));
    }
    return py::make_tuple(to_array(offsets), to_array(vertices));
  }

private:
  template <class T>
  static py::array view(const std::vector<T>& rows, const py::object& owner)
  {
    py::array_t<double> result({py::ssize_t(rows.size()), py::ssize_t(3)},
                               reinterpret_cast<const double*>(rows.data()), owner);
    result.attr("setflags")(py::arg("write") = false);
    return std::move(result);
  }

  std::variant<Of<Scheme>, Of<PN::Linear_scheme<Scheme>>> refiner_;
  int threads_;
};

} // namespace

void add_refiner(py::module_& module)
{
  py::class_<Refiner>(module, "Refiner")
    .def(py::init<const Control&, unsigned>())
    .def("set_points", &Refiner::set_points)
    .def("set_normals", &Refiner::set_normals)
    .def("update", &Refiner::update)
    .def("points", &Refiner::points)
    .def("normals", &Refiner::normals)
    .def("faces", &Refiner::faces);
}

} // namespace pn_python
