// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_PACKAGE_PARAMETERS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_PACKAGE_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <type_traits>

// The names of this package's named parameters. parameters.h documents them.
#define CGAL_PN_SUBDIVISION_3_OWN_PARAMETERS(ADD)                                                  \
  ADD(roundness)                                                                                   \
  ADD(vertex_roundness_map)                                                                        \
  ADD(min_facets)                                                                                  \
  ADD(surface_tolerance)                                                                           \
  ADD(sharp_angle)                                                                                 \
  ADD(control_normal_estimate)                                                                     \
  ADD(border)                                                                                      \
  ADD(crease_tangent_map)                                                                          \
  ADD(number_of_pieces)                                                                            \
  ADD(tolerance)                                                                                   \
  ADD(normal_tolerance)                                                                            \
  ADD(max_depth)                                                                                   \
  ADD(limit_point_map)                                                                             \
  ADD(limit_normal_map)                                                                            \
  ADD(limit_error_map)                                                                             \
  ADD(points)                                                                                      \
  ADD(surface_normals)                                                                             \
  ADD(curve_normals)                                                                               \
  ADD(curvatures)                                                                                  \
  ADD(rounds_done)                                                                                 \
  ADD(to_limit)                                                                                    \
  ADD(proven_bound)                                                                                \
  ADD(interpolation_mode)                                                                          \
  ADD(interpolation_normals)                                                                       \
  ADD(free_vertices)                                                                               \
  ADD(vertex_is_interpolated_map)                                                                  \
  ADD(max_steps)                                                                                   \
  ADD(prescribed_point_map)                                                                        \
  ADD(prescribed_normal_map)                                                                       \
  ADD(prescribed_curvature_map)                                                                    \
  ADD(rings)                                                                                       \
  ADD(curvature_tolerance)                                                                         \
  ADD(max_curvature_steps)                                                                         \
  ADD(tuned)                                                                                       \
  ADD(curvature_transfer)

namespace CGAL {
namespace PN_subdivision_3 {

struct Attribute_table;

namespace internal {

template <class... Items>
struct Attributes;

// the tag of a parameter of this package
template <class Name>
struct Package_parameter
{};

// with what the compiler says where a function does not read it, once for each kind of function
#define CGAL_PN_SUBDIVISION_3_TAG(X)                                                               \
  struct Name_of_##X                                                                               \
  {                                                                                                \
    template <bool is_read, class Call>                                                            \
    static constexpr bool check()                                                                  \
    {                                                                                              \
      static_assert(is_read, "PN_subdivision_3: this function does not read " #X                   \
                             " (parameters of several functions are marked by "                    \
                             "PN_subdivision_3::parameters::shared())");                           \
      return is_read;                                                                              \
    }                                                                                              \
  };                                                                                               \
  using X##_t = Package_parameter<Name_of_##X>;
CGAL_PN_SUBDIVISION_3_OWN_PARAMETERS(CGAL_PN_SUBDIVISION_3_TAG)
CGAL_PN_SUBDIVISION_3_TAG(attributes)
#undef CGAL_PN_SUBDIVISION_3_TAG

// marks of a pack: the user's, that no function need read it whole; and that a function has looked at it, see scheme_of_call.h
using is_shared_t = Package_parameter<struct Name_of_is_shared>;
using scheme_is_adapted_t = Package_parameter<struct Name_of_scheme_is_adapted>;

template <class Tag, class K, class T, class Own, class Base>
auto with_parameter_below(const K& value, const Named_function_parameters<T, Own, Base>& np);

} // namespace internal
} // namespace PN_subdivision_3

/// \cond SKIP_IN_MANUAL

// A pack whose outermost parameter is one of this package. Its members add this package's own parameters, and those of CGAL,
// which are put below: around them the members of this class would be inherited, and leave them out.
template <class T, class Name, class Base>
struct Named_function_parameters<T, PN_subdivision_3::internal::Package_parameter<Name>, Base>
  : internal_np::Named_params_impl<T, PN_subdivision_3::internal::Package_parameter<Name>, Base>
{
  using Own = PN_subdivision_3::internal::Package_parameter<Name>;
  using base = internal_np::Named_params_impl<T, Own, Base>;
  using self = Named_function_parameters<T, Own, Base>;
  using CGAL_Named_function_parameters_class = int;

  Named_function_parameters()
    : base(T())
  {}
  Named_function_parameters(const T& value)
    : base(value)
  {}
  Named_function_parameters(const T& value, const Base& others)
    : base(value, others)
  {}

#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  template <class K>                                                                               \
  auto Z(const K& k) const                                                                         \
  {                                                                                                \
    return PN_subdivision_3::internal::with_parameter_below<internal_np::X>(k, *this);             \
  }
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z)                             \
  template <class K>                                                                               \
  auto Z(const K& k) const                                                                         \
  {                                                                                                \
    return PN_subdivision_3::internal::with_parameter_below<internal_np::X>(std::cref(k), *this);  \
  }
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z)                              \
  template <class K>                                                                               \
  auto Z(K& k) const                                                                               \
  {                                                                                                \
    return PN_subdivision_3::internal::with_parameter_below<internal_np::X>(std::ref(k), *this);   \
  }
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_extra_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only

#define CGAL_PN_SUBDIVISION_3_MEMBER(X)                                                            \
  template <class K>                                                                               \
  auto X(const K& k) const                                                                         \
  {                                                                                                \
    return Named_function_parameters<K, PN_subdivision_3::internal::X##_t, self>(k, *this);        \
  }
  CGAL_PN_SUBDIVISION_3_OWN_PARAMETERS(CGAL_PN_SUBDIVISION_3_MEMBER)
#undef CGAL_PN_SUBDIVISION_3_MEMBER

  // as parameters::attributes(): a table that changes is not copied
  auto attributes(PN_subdivision_3::Attribute_table& table) const
  {
    return with_attributes(std::ref(table));
  }
  auto attributes(const PN_subdivision_3::Attribute_table& table) const
  {
    return with_attributes(std::cref(table));
  }
  template <class... Items>
  auto attributes(const PN_subdivision_3::internal::Attributes<Items...>& items) const
  {
    return with_attributes(items);
  }
  template <class... Items>
  auto attributes(const Items&... items) const
  {
    return with_attributes(PN_subdivision_3::internal::Attributes<Items...>{{items...}});
  }

private:
  template <class K>
  Named_function_parameters<K, PN_subdivision_3::internal::attributes_t, self>
  with_attributes(const K& k) const
  {
    return {k, *this};
  }
};

/// \endcond

namespace PN_subdivision_3 {
namespace internal {

// the outermost value of a pack, which is a reference wrapper of the pack's own where it cannot be copied
template <class T, class Tag, class Base>
const T& value_of(const Named_function_parameters<T, Tag, Base>& np)
{
  if constexpr (std::is_copy_constructible_v<T>)
    return np.v;
  else
    return np.v.get();
}

// a pack of one parameter
template <class Tag, class T>
Named_function_parameters<T, Tag> with_parameter(const T& value)
{
  return Named_function_parameters<T, Tag>(value);
}

template <class Tag>
constexpr bool is_own_v = false;
template <class Name>
inline constexpr bool is_own_v<Package_parameter<Name>> = true;

// The pack `np` with one parameter more, which is what counts if it is there already. This package's own ones stay outside.
template <class Tag, class K, class T, class Outermost, class Base>
auto with_parameter(const K& value, const Named_function_parameters<T, Outermost, Base>& np)
{
  if constexpr (is_own_v<Outermost> && !is_own_v<Tag>)
    return with_parameter_below<Tag>(value, np);
  else
    return Named_function_parameters<K, Tag, Named_function_parameters<T, Outermost, Base>>(value,
                                                                                            np);
}

template <class Tag, class K, class T, class Own, class Base>
auto with_parameter_below(const K& value, const Named_function_parameters<T, Own, Base>& np)
{
  if constexpr (std::is_same_v<Base, internal_np::No_property>)
    return with_parameter<Own>(value_of(np), with_parameter<Tag>(value));
  else
    return with_parameter<Own>(value_of(np),
                               with_parameter<Tag>(value, static_cast<const Base&>(np)));
}

// stands for what a call does not give: a parameter, a map, a number, attributes
struct Not_given
{};
template <class T>
constexpr bool is_there_v = !std::is_same_v<T, Not_given>;

// the value of a parameter, or what stands for it
template <class Tag, class NamedParameters, class Default = Not_given>
auto parameter_or(const NamedParameters& np, const Default& value = Default())
{
  return parameters::choose_parameter(parameters::get_parameter(np, Tag()), value);
}

// the type of a parameter, or of what stands for it
template <class Tag, class NamedParameters, class Default = Not_given>
using Parameter_type =
  std::decay_t<typename internal_np::Lookup_named_param_def<Tag, NamedParameters, Default>::type>;

template <class Tag, class NamedParameters>
constexpr bool is_given_v = is_there_v<Parameter_type<Tag, NamedParameters>>;

template <class T>
constexpr bool are_named_parameters_v = false;
template <class T, class Tag, class Base>
inline constexpr bool are_named_parameters_v<Named_function_parameters<T, Tag, Base>> = true;

template <class... Tags>
struct Read_parameters : Tags...
{};

template <class Read, class NamedParameters>
constexpr bool are_read_v = true;
template <class Read, class T, class Tag, class Base>
inline constexpr bool are_read_v<Read, Named_function_parameters<T, Tag, Base>> =
  are_read_v<Read, Base>;
template <class Read, class T, class Name, class Base>
inline constexpr bool
  are_read_v<Read, Named_function_parameters<T, Package_parameter<Name>, Base>> =
    Name::template check<std::is_base_of_v<Package_parameter<Name>, Read>, Read>() &&
    are_read_v<Read, Base>;
template <class Read, class T, class Base>
inline constexpr bool are_read_v<Read, Named_function_parameters<T, scheme_is_adapted_t, Base>> =
  true;

// refuses, at compile time, parameters of this package that a function does not read
template <class NamedParameters, class... Tags>
constexpr bool check_are_read()
{
  if constexpr (!are_named_parameters_v<NamedParameters>)
    return true;
  else if constexpr (is_given_v<is_shared_t, NamedParameters>)
    return true;
  else
    return are_read_v<Read_parameters<Tags...>, NamedParameters>;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_PACKAGE_PARAMETERS_H
