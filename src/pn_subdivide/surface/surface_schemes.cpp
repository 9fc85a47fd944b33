// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/surface_schemes.h"

#include "io/Error.h"

#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Grid_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/shipped_schemes.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace pn_subdivide {

namespace PN = CGAL::PN_subdivision_3;

namespace {

constexpr const char* grid_name = PN::CatmullClark_scheme::Grid::name();

// What the command asks of CatmullClark_scheme::Grid. What would average its rows as those of others is refused.
struct Grid_facts
{
  using Host = PN::CatmullClark_scheme::Grid::Host;
  static constexpr const char* name() { return grid_name; }

  template <class FT>
  PN::CatmullClark_mask<FT> mask(const PN::Level_connectivity&, unsigned) const
  {
    throw Usage_error(std::string("--scheme ") + grid_name + " has no rules for this");
  }
};

std::vector<std::string> all_names()
{
  std::vector<std::string> names;
  PN::for_each_shipped_scheme([&names](const auto& scheme) { names.push_back(scheme.name()); });
  names.push_back(grid_name);
  return names;
}

template <class S>
constexpr bool has_first_round_v = std::is_constructible_v<S, double, unsigned, PN::Tuned_valences>;

PN::Tuned_valences tuned_valences(const Scheme_choice& choice)
{
  const std::string word = choice.tuned_valences.value_or("all");
  if (word != "all" && word != "diverging")
    throw Usage_error("--tuned-valences '" + word + "': it takes all or diverging");
  return word == "all" ? PN::Tuned_valences::all : PN::Tuned_valences::diverging;
}

template <class S>
S with_parameter(const Scheme_choice& choice)
{
  const auto given = choice.parameters.find(S::parameter_name());
  const double value = given == choice.parameters.end() ? S::default_parameter() : given->second;
  try {
    if constexpr (has_first_round_v<S>) {
      if (choice.first_round == 0u) throw Usage_error("--first-round must be at least 1");
      return S(value, choice.first_round.value_or(1), tuned_valences(choice));
    } else
      return S(value);
  } catch (const std::invalid_argument& e) {
    throw Usage_error(std::string("--") + S::parameter_name() + ": " + message_of(e));
  }
}

void require_that_they_go_together(const Scheme_choice& choice, const Scheme& scheme,
                                   const Scheme& normal_scheme)
{
  if (choice.scheme == *choice.normal_scheme) return;
  for (const Scheme* const s : {&scheme, &normal_scheme})
    if (s->transfers_curvature() || is_grid_scheme(s->name()))
      throw Usage_error("--normal-scheme: " + s->name() +
                        " refines points and normals together and goes with no other scheme");
  if (!scheme.has_host_of(normal_scheme))
    throw Usage_error("--normal-scheme " + *choice.normal_scheme + " does not go with --scheme " +
                      choice.scheme + ": they split the faces differently");
}

std::vector<std::string> modified_schemes()
{
  std::vector<std::string> names;
  PN::for_each_shipped_scheme([&names](const auto& scheme) {
    if constexpr (has_first_round_v<std::decay_t<decltype(scheme)>>) names.push_back(scheme.name());
  });
  return names;
}

void require_use_of_policy(const Scheme_choice& choice)
{
  if (!choice.first_round && !choice.tuned_valences) return;
  for (const std::string& name : modified_schemes())
    if (choice.scheme == name || choice.normal_scheme == name) return;
  throw Usage_error(std::string(choice.first_round ? "--first-round" : "--tuned-valences") +
                    " belongs to the schemes " + enumeration(modified_schemes(), "and"));
}

void require_use_of_parameters(const Scheme_choice& choice)
{
  require_use_of_policy(choice);
  for (const Scheme_parameter& p : scheme_parameters()) {
    const auto takes_it = [&p](const std::string& scheme) {
      return std::find(p.schemes.begin(), p.schemes.end(), scheme) != p.schemes.end();
    };
    if (choice.parameters.count(p.name) == 0 || takes_it(choice.scheme) ||
        takes_it(choice.normal_scheme.value_or("")))
      continue;
    throw Usage_error("--" + p.name + " belongs to the " +
                      (p.schemes.size() == 1 ? "scheme " : "schemes ") +
                      enumeration(p.schemes, "and"));
  }
}

} // namespace

std::string scheme_names()
{
  return enumeration(all_names(), "or");
}

std::string modified_scheme_names()
{
  return enumeration(modified_schemes(), "and");
}

std::vector<Scheme_parameter> scheme_parameters()
{
  std::vector<Scheme_parameter> parameters;
  PN::for_each_shipped_scheme([&parameters](const auto& scheme) {
    using S = std::decay_t<decltype(scheme)>;
    if constexpr (PN::has_parameter_v<S>) {
      const std::string name = S::parameter_name();
      auto p = std::find_if(parameters.begin(), parameters.end(),
                            [&name](const Scheme_parameter& q) { return q.name == name; });
      if (p == parameters.end())
        p = parameters.insert(p, Scheme_parameter{name, {}, S::default_parameter()});
      p->schemes.push_back(S::name());
    }
  });
  return parameters;
}

Scheme make_scheme(const std::string& option, const std::string& name, const Scheme_choice& choice)
{
  if (name == grid_name) return Scheme(Grid_facts());
  std::optional<Scheme> found;
  PN::for_each_shipped_scheme([&](const auto& scheme) {
    using S = std::decay_t<decltype(scheme)>;
    if (name != S::name()) return;
    if constexpr (PN::has_parameter_v<S>)
      found.emplace(with_parameter<S>(choice));
    else
      found.emplace(scheme);
  });
  if (!found)
    throw Usage_error(option + (" '" + name) + "': there is no such scheme, only " +
                      enumeration(all_names(), "and") + did_you_mean(name, all_names()));
  return *found;
}

Scheme scheme_of(const Scheme_choice& choice)
{
  return make_scheme("--scheme", choice.scheme, choice);
}

Scheme scheme_with_normals(const Scheme_choice& choice)
{
  const Scheme scheme = scheme_of(choice);
  if (!choice.normal_scheme || *choice.normal_scheme == choice.scheme) return scheme;
  return PN::internal::with_host<Scheme>(
    PN::with_normal_scheme(scheme, make_scheme("--normal-scheme", *choice.normal_scheme, choice)),
    [](const auto& both) { return Scheme(both); });
}

void require_surface_schemes(const Scheme_choice& choice)
{
  require_use_of_parameters(choice);
  if (choice.normal_scheme) make_scheme("--normal-scheme", *choice.normal_scheme, choice);
  if (choice.scheme.empty()) return;
  const Scheme scheme = scheme_of(choice);
  if (choice.normal_scheme)
    require_that_they_go_together(choice, scheme,
                                  make_scheme("--normal-scheme", *choice.normal_scheme, choice));
}

bool is_grid_scheme(const std::string& scheme)
{
  return scheme == grid_name;
}

bool needs_triangles(const std::string& scheme)
{
  return make_scheme("--scheme", scheme, {}).needs_triangles();
}

bool keeps_edges(const std::string& scheme)
{
  return make_scheme("--scheme", scheme, {}).splits_edges();
}

std::string creasing_scheme_names()
{
  std::vector<std::string> names;
  for (const std::string& name : all_names())
    if (make_scheme("--scheme", name, {}).has_crease_rules()) names.push_back(name);
  return enumeration(names, "and");
}

std::string scheme_without_creases(const Scheme_choice& choice)
{
  for (const std::string& name : {choice.scheme, choice.normal_scheme.value_or("")})
    if (!name.empty() && !make_scheme("--scheme", name, {}).has_crease_rules()) return name;
  return {};
}

} // namespace pn_subdivide
