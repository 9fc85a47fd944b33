// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SCHEME_OF_CALL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SCHEME_OF_CALL_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/Uncertain.h>

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {
struct CatmullClark_scheme;
struct Loop_scheme;
} // namespace CGAL::PN_subdivision_3

namespace CGAL::PN_subdivision_3::internal {

// What a call says by named parameters of the border, of the tangents of creases and of the estimate of normals, put around its
// scheme. The type tells whether it says something of the border. Of two adaptors that say something the outer one counts.
template <class Scheme, bool has_border, class HalfedgeVectorMap>
struct Scheme_of_call : Scheme_adaptor<Scheme>
{
  std::optional<Control_normal_estimate> normal_estimate() const
  {
    return estimate ? estimate : facts_of(this->scheme).normal_estimate;
  }

  Border border = Border::surface;
  std::optional<Control_normal_estimate> estimate;
  HalfedgeVectorMap tangents;
};

template <class Scheme, class = typename Scheme::Host>
Scheme_of_call<Scheme, true, Not_given> with_border(const Scheme& scheme, Border border)
{
  return {{scheme}, border, {}, {}};
}
template <class Scheme, class HalfedgeVectorMap, class = typename Scheme::Host>
Scheme_of_call<Scheme, false, HalfedgeVectorMap> with_crease_tangents(const Scheme& scheme,
                                                                      HalfedgeVectorMap tangents)
{
  return {{scheme}, {}, {}, tangents};
}
template <class Scheme, class = typename Scheme::Host>
Scheme_of_call<Scheme, false, Not_given> with_normal_estimate(const Scheme& scheme,
                                                              Control_normal_estimate estimate)
{
  return {{scheme}, {}, estimate, {}};
}

template <class Scheme>
struct Is_said_by_call : std::false_type
{};
template <class Scheme, bool has_border, class Map>
struct Is_said_by_call<Scheme_of_call<Scheme, has_border, Map>> : std::true_type
{};
template <class Scheme>
struct Is_with_crease_tangents : std::false_type
{};
template <class Scheme, bool has_border, class Map>
struct Is_with_crease_tangents<Scheme_of_call<Scheme, has_border, Map>>
  : std::bool_constant<is_there_v<Map>>
{};

// The border of a scheme and of the adaptors around it.
template <class Scheme>
struct Border_of
{
  static constexpr bool is_given = !std::is_null_pointer_v<Outermost<Is_with_border, Scheme>>;

  static Border get([[maybe_unused]] const Scheme& scheme)
  {
    if constexpr (is_given)
      return outermost<Is_with_border>(scheme)->border;
    else
      return Border::surface;
  }
};

// the map of a scheme and of the adaptors around it
template <class Scheme>
auto crease_tangents([[maybe_unused]] const Scheme& scheme)
{
  if constexpr (std::is_null_pointer_v<Outermost<Is_with_crease_tangents, Scheme>>)
    return Not_given();
  else
    return outermost<Is_with_crease_tangents>(scheme)->tangents;
}
template <class Scheme>
using Crease_tangent_map = decltype(crease_tangents(std::declval<const Scheme&>()));

template <class Scheme>
constexpr bool has_crease_tangents_v = is_there_v<Crease_tangent_map<Scheme>>;

template <class Scheme>
Control_normal_estimate normal_estimate(const Scheme& scheme)
{
  return facts_of(scheme).normal_estimate.value_or(Control_normal_estimate::coherent);
}

// whether a call says something of its scheme that is not yet put around it
template <class Scheme, class NamedParameters, class = void>
constexpr bool adapts_scheme_v = false;
template <class Scheme, class T, class Tag, class Base>
inline constexpr bool adapts_scheme_v<Scheme, Named_function_parameters<T, Tag, Base>,
                                      std::void_t<typename Scheme::Host>> =
  !is_given_v<scheme_is_adapted_t, Named_function_parameters<T, Tag, Base>> &&
  (is_given_v<border_t, Named_function_parameters<T, Tag, Base>> ||
   is_given_v<crease_tangent_map_t, Named_function_parameters<T, Tag, Base>> ||
   is_given_v<control_normal_estimate_t, Named_function_parameters<T, Tag, Base>>);

// f(scheme, np), with the scheme as the call says, and parameters that do not say it again
template <class Scheme, class NamedParameters, class Function>
decltype(auto) with_adapted_scheme(const Scheme& scheme, const NamedParameters& np,
                                   const Function& f)
{
  using Tangents = Parameter_type<crease_tangent_map_t, NamedParameters>;
  using Estimate = std::optional<Control_normal_estimate>;
  return f(
    Scheme_of_call<Scheme, is_given_v<border_t, NamedParameters>, Tangents>{
      {scheme},
      parameter_or<border_t>(np, Border::surface),
      parameter_or<control_normal_estimate_t>(np, Estimate()),
      parameter_or<crease_tangent_map_t>(np)},
    with_parameter<scheme_is_adapted_t>(true, np));
}

// The roundness of control vertices that a call is given: a number for each vertex, a number for all, or none. Without a number
// estimated normals bring their roundness, and given normals have the roundness 1.
template <class FT>
struct Given_roundness
{
  std::vector<FT> of_vertices;
  std::optional<FT> of_all;
  bool is_of_estimate = false; // the roundness counts only where the estimated normal does

  bool is_any() const { return of_all || !of_vertices.empty(); }
  // puts it into the values of the vertices, which come first, and of their extra slots; `extra` has the vertices of these slots
  template <class Value, class Index = std::size_t>
  void put(std::size_t vertices, std::vector<Value>& values,
           const std::vector<bool>* is_normal_given = nullptr,
           const std::vector<Index>& extra = {}) const
  {
    for (std::size_t s = 0; s < vertices + extra.size(); ++s) {
      const std::size_t v = s < vertices ? s : std::size_t(extra[s - vertices]);
      if (is_of_estimate && is_normal_given != nullptr && !(*is_normal_given)[v])
        continue;
      else if (of_all)
        values[s].roundness = *of_all;
      else if (!of_vertices.empty())
        values[s].roundness = of_vertices[v];
    }
  }
};

// a program that is linked to the library CGAL::PN_subdivision_3_double has this macro
#ifdef CGAL_PN_SUBDIVISION_3_DOUBLE
constexpr bool is_linked_to_library = true;
#else
constexpr bool is_linked_to_library = false;
#endif

// A scheme with a roundness, which is put around the user's scheme as the outermost adaptor. The roundness varies in calls that
// estimate normals, that are given a map, or in which sharp edges end. Sources that are linked to a library and sources that
// are not have types of their own, as scheme_of_rounds() differs: a program may have both.
template <class Scheme, class FT, bool creases_may_end = true,
          bool is_linked = is_linked_to_library>
struct With_roundness : Scheme_adaptor<Scheme>
{
  const Given_roundness<FT>* given = nullptr; // none is given
  bool varies = true;

  // the roundness of all values, if they have the same
  std::optional<FT> of_all() const
  {
    if (varies) return std::nullopt;
    return given == nullptr ? FT(1) : given->of_all.value_or(FT(1));
  }
};

template <class Scheme>
struct Is_with_roundness : std::false_type
{};
template <class Scheme, class FT, bool creases_may_end, bool is_linked>
struct Is_with_roundness<With_roundness<Scheme, FT, creases_may_end, is_linked>> : std::true_type
{};

// Whether sharpness may be used up. With maps of bool it is not, and the code that blends wedges is not compiled then.
template <class Scheme>
constexpr bool creases_may_end_v = true;
template <class Scheme, class FT, bool creases_may_end, bool is_linked>
inline constexpr bool creases_may_end_v<With_roundness<Scheme, FT, creases_may_end, is_linked>> =
  creases_may_end;

template <class T, class... Others>
constexpr bool is_one_of_v = (std::is_same_v<T, Others> || ...);

// What rounds and limits ask of a scheme. What a call says of the border, the tangents of creases and the estimate of normals is
// known when the mesh has been read, and such calls share what follows. Libraries have Catmull-Clark and Loop as an Any_scheme.
template <bool is_linked = is_linked_to_library, class Scheme, class FT = double>
decltype(auto) scheme_of_rounds(const Scheme& scheme, FT = FT())
{
  if constexpr (Is_said_by_call<Scheme>::value)
    return scheme_of_rounds<is_linked>(scheme.scheme, FT());
  else if constexpr (is_linked && std::is_same_v<FT, double> &&
                     is_one_of_v<Scheme, CatmullClark_scheme, Loop_scheme>)
    return Scheme_on_host<typename Scheme::Host, FT>(scheme);
  else
    return (scheme);
}
template <class Scheme, class FT, bool creases_may_end, bool is_linked>
auto scheme_of_rounds(const With_roundness<Scheme, FT, creases_may_end, is_linked>& scheme)
{
  using Round_scheme = std::decay_t<decltype(scheme_of_rounds<is_linked>(scheme.scheme, FT()))>;
  if constexpr (Is_linear<Round_scheme>::value)
    return scheme_of_rounds<is_linked>(scheme.scheme, FT());
  else
    return With_roundness<Round_scheme, FT, creases_may_end, is_linked>{
      {scheme_of_rounds<is_linked>(scheme.scheme, FT())}, scheme.given, scheme.varies};
}
template <class Scheme>
using Scheme_of_rounds = std::decay_t<decltype(scheme_of_rounds(std::declval<const Scheme&>()))>;

// puts the given roundness into the values of the vertices, which come first, and of their extra slots
template <class Scheme, class Value, class Index = std::size_t>
void put_given_roundness([[maybe_unused]] const Scheme& scheme,
                         [[maybe_unused]] std::size_t vertices,
                         [[maybe_unused]] std::vector<Value>& values,
                         [[maybe_unused]] const std::vector<bool>* is_normal_given = nullptr,
                         [[maybe_unused]] const std::vector<Index>& extra = {})
{
  if constexpr (!std::is_null_pointer_v<Outermost<Is_with_roundness, Scheme>> &&
                has_normal_v<Value>) {
    const auto* with_roundness = outermost<Is_with_roundness>(scheme);
    if (const auto of_all = with_roundness->of_all())
      for (Value& value : values) value.roundness = *of_all;
    else if (with_roundness->given != nullptr)
      with_roundness->given->put(vertices, values, is_normal_given, extra);
  }
}

// The roundness of a crease average, whose entry j has the roundness of(j). Equal numbers are not summed, since the weights
// come in another order here than the order in which they sum to 1.
template <class Entry, std::size_t n, class Roundness_of>
auto averaged_roundness(const std::array<Entry, n>& entries, const Roundness_of& of)
{
  const auto first = of(0);
  std::decay_t<decltype(first)> sum =
    entries[0].weight * first; // a number, not the expression of one
  bool are_equal = true;
  for (std::size_t j = 1; j < n; ++j) {
    sum += entries[j].weight * of(j);
    are_equal = are_equal && CGAL::certainly(of(j) == first);
  }
  return are_equal ? first : sum;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SCHEME_OF_CALL_H
