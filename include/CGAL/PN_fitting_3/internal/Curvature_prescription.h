// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_CURVATURE_PRESCRIPTION_H
#define CGAL_PN_FITTING_3_INTERNAL_CURVATURE_PRESCRIPTION_H

#include <CGAL/PN_fitting_3/internal/Limit_functionals.h>
#include <CGAL/PN_fitting_3/internal/Prescription.h>
#include <CGAL/PN_fitting_3/internal/Ring_limit_functionals.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_geometry.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Control points and control normals for prescribed curvatures, besides points and normals. In the frame
// of the limit control normal N at the limit point, where the points of the ring are at u and their
// normals have the slopes g, a quadratic form D is added to the surface by
//   g += D u / r,  z += u.D u / 2,
// where r is the share that slopes have in the second form, 1 but at irregular vertices of another roundness. It keeps
// what is refined linearly, hence the limit and its tangent plane, to third order; these are then
// restored as by Prescription. That is repeated: what remains of the curvature is of higher order.
template <int dimension>
class Curvature_prescription
{
public:
  using Index = Level_connectivity::Index;
  using Functionals = Surface_limits::Functionals;
  using Names = Function_ref<std::string(Index)>;

  // Where no point or normal is prescribed but a curvature, they stay.
  // \throws std::invalid_argument where curvature cannot be prescribed
  Curvature_prescription(const Level_connectivity& level, const Interpolation_data<dimension>& data,
                         Surface_limits& source, std::vector<Prescribed_vertex> prescribed,
                         const std::vector<Prescribed_form>& forms, unsigned rings, Names names)
    : data_(data)
    , source_(source)
    , targets_(targets(forms))
    , prescription_(level, data, source, with_targets(std::move(prescribed), names), rings)
  {
    set_forms(forms, names);
  }

  // tolerance: of curvatures, absolute
  Interpolation_result<3> operator()(double tolerance, unsigned max_steps)
  {
    Interpolation_result<3> result;
    result.points = data_.points;
    result.normals = data_.normals;
    result.report.tolerance = data_.tolerance;
    const double missed = prescription_.meet(result.points, result.normals, result.report);
    // points and normals shall stay as good as they can be made
    most_missed_ = 4 * (std::max)(missed, 1.);
    double residual = evaluate(result.points, result.normals);
    for (unsigned k = 0; k < max_steps && !(residual <= tolerance); ++k) {
      if (!step(result, residual)) break;
      ++result.report.curvature_steps;
    }
    result.report.curvature_residual = residual;
    return result;
  }

private:
  using Vector = Eigen_vector<3>;
  using Tensor = Eigen::Matrix3d;

  static constexpr double least_cosine = 0.5; // of the control normals of a ring with N
  static constexpr double accuracy = 1e-7;    // of second forms, relative
  static constexpr double least_share_of_slopes = 0.1;

  struct Target
  {
    Index vertex = 0;
    std::vector<Index> ring;
    Vector normal = Vector::Zero(); // of the surface
    Tensor form = Tensor::Zero();
  };

  static std::vector<Target> targets(const std::vector<Prescribed_form>& forms)
  {
    std::vector<Target> all(forms.size());
    for (std::size_t i = 0; i < forms.size(); ++i) all[i].vertex = forms[i].vertex;
    return all;
  }

  [[noreturn]] static void refuse(const std::string& name, const std::string& reason)
  {
    throw std::invalid_argument("PN_subdivision_3: a curvature is prescribed at " + name + ", " +
                                reason);
  }

  std::vector<Functionals> functionals(const Vectors<3>& points, const Vectors<3>& normals,
                                       const Limit_precision& precision)
  {
    std::vector<Index> vertices;
    for (const Target& t : targets_) vertices.push_back(t.vertex);
    return source_(to_values<3>(points, normals, data_), vertices, precision);
  }

  // Checks where the curvatures are, and adds their points and normals to what is prescribed.
  std::vector<Prescribed_vertex> with_targets(std::vector<Prescribed_vertex> prescribed,
                                              Names names)
  {
    Limit_precision precision = second_form_precision();
    precision.tangents = 1e-13;
    const auto found = functionals(data_.points, data_.normals, precision);
    std::map<Index, Index> center; // of the vertices of rings
    std::map<Index, std::size_t> place;
    for (std::size_t i = 0; i < prescribed.size(); ++i) place[prescribed[i].vertex] = i;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      const Functionals& f = found[i];
      Target& t = targets_[i];
      check(f, names(t.vertex));
      for (const auto& e : f.entries) {
        t.ring.push_back(e.vertex);
        const auto other = center.emplace(e.vertex, t.vertex);
        if (!other.second)
          refuse(names(t.vertex), "but its faces share " + names(e.vertex) + " with those at " +
                                    names(other.first->second) +
                                    ", where one is prescribed, too: subdivide the mesh first");
      }
      if (place.count(t.vertex) == 0) {
        place[t.vertex] = prescribed.size();
        prescribed.push_back({t.vertex, std::nullopt, std::nullopt});
      }
      Prescribed_vertex& p = prescribed[place[t.vertex]];
      if (!p.point) p.point = f.limit_point;
      if (!p.normal) p.normal = f.surface_normal(data_.points, f.control_normal);
      t.normal = *p.normal;
    }
    return prescribed;
  }

  void check(const Functionals& f, const std::string& name) const
  {
    if (f.rounds != 0)
      refuse(
        name,
        "whose neighbors are irregular, too, whose faces are not all of the kind that the scheme "
        "makes, or where the first round of its rules is yet to come: subdivide the mesh first");
    if (!f.has_second_form)
      refuse(name, "where the surface has none that the scheme tells of: take an interior vertex "
                   "with a control normal, and a modified scheme if it is irregular");
    if (!(f.share_of_slopes >= least_share_of_slopes))
      refuse(name, "where the roundness is below 0.1, so that control normals hardly bend the "
                   "surface: give it more");
    for (const auto& e : f.entries)
      if (!(data_.normals[e.vertex].dot(f.control_normal) >= least_cosine))
        refuse(name, "about which control normals are zero or more than 60 degrees apart from "
                     "their limit: subdivide the mesh first");
  }

  void set_forms(const std::vector<Prescribed_form>& forms, Names names)
  {
    for (std::size_t i = 0; i < forms.size(); ++i) {
      const Prescribed_form& f = forms[i];
      Target& t = targets_[i];
      const Tensor plane = Tensor::Identity() - t.normal * t.normal.transpose();
      t.form = -f.across * plane;
      if (f.along == f.across) continue;
      const double length = f.direction.stableNorm();
      Vector d = Vector::Zero();
      if (length > 0) d = plane * (f.direction / length);
      if (!(d.norm() > 1e-6))
        refuse(names(f.vertex),
               "but its direction is zero or that of the surface's normal: give one "
               "in the tangent plane");
      d.normalize();
      t.form -= (f.along - f.across) * d * d.transpose();
    }
  }

  Limit_precision second_form_precision() const
  {
    Limit_precision p = data_.precision();
    p.second_forms = accuracy;
    p.max_depth = (std::max)(p.max_depth, 100u);
    return p;
  }

  // the largest difference of a curvature from what is prescribed, over all directions
  double evaluate(const Vectors<3>& points, const Vectors<3>& normals)
  {
    Limit_precision precision = second_form_precision();
    precision.with_blocks = false;
    functionals_ = functionals(points, normals, precision);
    double largest = 0;
    for (std::size_t i = 0; i < targets_.size(); ++i)
      largest =
        (std::max)(largest, functionals_[i].has_second_form
                              ? finite_or_infinite(spectral_norm(difference(targets_[i], i)))
                              : finite_or_infinite(HUGE_VAL));
    return largest;
  }
  Tensor difference(const Target& t, std::size_t i) const
  {
    return t.form - functionals_[i].second_form;
  }
  // the norm of a symmetric map of a plane: it has two eigenvalues, whose sum and sum of squares are known
  static double spectral_norm(const Tensor& m)
  {
    const double mean = m.trace() / 2;
    return std::abs(mean) + std::sqrt((std::max)(m.squaredNorm() / 2 - mean * mean, 0.));
  }

  // Whether a step, or a part of it, is one for the better; takes it.
  bool step(Interpolation_result<3>& result, double& residual)
  {
    const std::vector<Functionals> now = functionals_;
    for (const double part : {1., 0.5, 0.25}) {
      functionals_ = now;
      Interpolation_result<3> next = result;
      for (std::size_t i = 0; i < targets_.size(); ++i)
        if (!add_form(part, targets_[i], i, next)) return false;
      const double missed = prescription_.meet(next.points, next.normals, next.report);
      result.report.steps = next.report.steps;
      const double next_residual = evaluate(next.points, next.normals);
      if (!(missed <= most_missed_) || !(next_residual < residual)) continue;
      residual = next_residual;
      result = std::move(next);
      return true;
    }
    functionals_ = now;
    return false;
  }

  // adds to a ring the form by which it lacks curvature; whether the control normals allow that
  bool add_form(double part, const Target& t, std::size_t i, Interpolation_result<3>& r) const
  {
    const Vector n = functionals_[i].control_normal, o = functionals_[i].limit_point;
    const Vector e1 = n.unitOrthogonal(), e2 = n.cross(e1);
    const double cosine = t.normal.dot(n);
    if (!(cosine > 0.1)) return false;
    Eigen::Matrix<double, 2, 3> plane, tangents;
    plane << e1.transpose(), e2.transpose();
    // the surface has the slope a in the frame
    const Eigen::Vector2d a = plane * t.normal / -cosine;
    tangents = plane + a * n.transpose();
    const Eigen::Matrix2d d =
      part * std::sqrt(1 + a.squaredNorm()) * tangents * difference(t, i) * tangents.transpose();
    for (const Index v : t.ring) {
      const Eigen::Vector2d u = plane * (r.points[v] - o);
      const double c = r.normals[v].dot(n);
      if (!(c >= least_cosine / 2)) return false;
      r.points[v] += u.dot(d * u) / 2 * n;
      r.normals[v] =
        (r.normals[v] / c - plane.transpose() * (d * u) / functionals_[i].share_of_slopes)
          .normalized();
    }
    return true;
  }

  const Interpolation_data<3>& data_;
  Surface_limits& source_;
  std::vector<Target> targets_;
  Prescription<dimension> prescription_;
  std::vector<Functionals> functionals_; // at the last points and normals
  double most_missed_ = 0;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_CURVATURE_PRESCRIPTION_H
