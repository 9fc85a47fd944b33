// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SCHEME_ON_HOST_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SCHEME_ON_HOST_H

#include <CGAL/PN_subdivision_3/hosts/DQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// the function of a mask that writes a row; the hosts tell which
enum class Row_kind { vertex, edge, face, corner, border_vertex, border_edge };

// A mask behind a virtual call a row.
template <class FT>
class Erased_mask
{
public:
  using Index = Level_connectivity::Index;

  Erased_mask() = default;
  Erased_mask(const Erased_mask&) = delete;
  Erased_mask& operator=(const Erased_mask&) = delete;
  virtual ~Erased_mask() = default;

  virtual void write(Row_kind kind, Index i, Index ordinal, Stencil<FT>& row) const = 0;
  virtual void write(Row_kind kind, Index i, Index ordinal, Entry_row<FT>& row) const = 0;
  // 0 without parts of faces, see Slot_shares
  virtual FT face_part_of_vertex(Index h, Index valence) const = 0;
  virtual FT face_part_of_edge(Index h) const = 0;
  // the separated vertices, where the scheme transfers curvature
  virtual std::vector<Index> separated_vertices() const = 0;
};

// that of the points or the normals
template <class FT, bool is_of_normals, class Scheme>
auto made_mask(const Scheme& scheme, const Level_connectivity& level, unsigned round)
{
  if constexpr (is_of_normals)
    return scheme.template normal_mask<FT>(level, round);
  else
    return scheme.template mask<FT>(level, round);
}

template <class FT, bool is_of_normals, class Scheme>
class Erased_mask_of final : public Erased_mask<FT>
{
  using Host = typename Scheme::Host;
  using Mask = decltype(made_mask<FT, is_of_normals>(
    std::declval<const Scheme&>(), std::declval<const Level_connectivity&>(), 1u));

public:
  using typename Erased_mask<FT>::Index;

  Erased_mask_of(const Scheme& scheme, const Level_connectivity& level, unsigned round)
    : mask_(made_mask<FT, is_of_normals>(scheme, level, round))
  {}

  void write(Row_kind kind, Index i, Index ordinal, Stencil<FT>& row) const override
  {
    write_row(kind, i, ordinal, row);
  }
  void write(Row_kind kind, Index i, Index ordinal, Entry_row<FT>& row) const override
  {
    write_row(kind, i, ordinal, row);
  }
  FT face_part_of_vertex([[maybe_unused]] Index h, [[maybe_unused]] Index valence) const override
  {
    if constexpr (Has_face_parts<Mask>::value)
      return mask_.face_part_of_vertex(h, valence);
    else
      return FT(0);
  }
  FT face_part_of_edge([[maybe_unused]] Index h) const override
  {
    if constexpr (Has_face_parts<Mask>::value)
      return mask_.face_part_of_edge(h);
    else
      return FT(0);
  }
  std::vector<Index> separated_vertices() const override
  {
    if constexpr (Has_curvature_transfer<Scheme>::value && !is_of_normals)
      return mask_.separated_vertices();
    else
      return {};
  }

private:
  template <class Row>
  void write_row(Row_kind kind, Index i, [[maybe_unused]] Index ordinal, Row& row) const
  {
    if constexpr (std::is_same_v<Host, DQQ_host>)
      mask_.corner(i, row);
    else if (kind == Row_kind::vertex)
      mask_.vertex(i, row);
    else if constexpr (std::is_same_v<Host, Sqrt3_host>) {
      if (kind == Row_kind::face)
        mask_.face(i, row);
      else if (kind == Row_kind::border_vertex)
        mask_.border_vertex(i, row);
      else
        mask_.border_edge(i, ordinal, row);
    } else if constexpr (std::is_same_v<Host, PTQ_host>)
      mask_.edge(i, row);
    else if (kind == Row_kind::edge)
      mask_.edge(i, row);
    else
      mask_.face(i, row);
  }

  Mask mask_;
};

// the mask of a scheme that is chosen at run time, on any host
template <class FT>
class Any_mask
{
public:
  using Index = Level_connectivity::Index;

  explicit Any_mask(std::shared_ptr<const Erased_mask<FT>> mask)
    : mask_(std::move(mask))
  {}

  template <class Row>
  void vertex(Index v, Row& row) const
  {
    mask_->write(Row_kind::vertex, v, 0, row);
  }
  template <class Row>
  void edge(Index e, Row& row) const
  {
    mask_->write(Row_kind::edge, e, 0, row);
  }
  template <class Row>
  void face(Index f, Row& row) const
  {
    mask_->write(Row_kind::face, f, 0, row);
  }
  template <class Row>
  void corner(Index h, Row& row) const
  {
    mask_->write(Row_kind::corner, h, 0, row);
  }
  template <class Row>
  void border_vertex(Index h, Row& row) const
  {
    mask_->write(Row_kind::border_vertex, h, 0, row);
  }
  template <class Row>
  void border_edge(Index e, Index ordinal, Row& row) const
  {
    mask_->write(Row_kind::border_edge, e, ordinal, row);
  }
  FT face_part_of_vertex(Index h, Index valence) const
  {
    return mask_->face_part_of_vertex(h, valence);
  }
  FT face_part_of_edge(Index h) const { return mask_->face_part_of_edge(h); }
  std::vector<Index> separated_vertices() const { return mask_->separated_vertices(); }

private:
  std::shared_ptr<const Erased_mask<FT>> mask_;
};

// All that is asked of a scheme but its host.
template <class FT>
struct Erased_scheme : Scheme_facts
{
  template <class Number>
  using Make_mask =
    std::function<std::shared_ptr<const Erased_mask<Number>>(const Level_connectivity&, unsigned)>;

  std::string name;
  std::function<double(const Level_connectivity&, unsigned)> dense_row_entries;
  std::function<void(const Level_connectivity&, const Element_names&)> check;
  // the masks in the number type of the points, and in those in which limits are found and interpolated
  struct Masks
  {
    template <class Number>
    const Make_mask<Number>& of() const
    {
      if constexpr (std::is_same_v<Number, FT>)
        return in_ft;
      else if constexpr (std::is_same_v<Number, double>)
        return in_double;
      else {
        static_assert(std::is_same_v<Number, long double>,
                      "PN_subdivision_3: an Any_scheme has weights of its own number type only");
        return in_long_double;
      }
    }

    Make_mask<FT> in_ft;
    Make_mask<double> in_double;
    Make_mask<long double> in_long_double;
  };
  Masks masks;
  Masks normal_masks; // empty unless the normals have masks of their own
};

template <class Number, bool is_of_normals, class Scheme>
auto mask_maker(const Scheme& scheme)
{
  return [scheme](const Level_connectivity& level,
                  unsigned round) -> std::shared_ptr<const Erased_mask<Number>> {
    return std::make_shared<Erased_mask_of<Number, is_of_normals, Scheme>>(scheme, level, round);
  };
}

template <class FT, bool is_of_normals, class Scheme>
typename Erased_scheme<FT>::Masks erased_masks(const Scheme& scheme)
{
  return {mask_maker<FT, is_of_normals>(scheme), mask_maker<double, is_of_normals>(scheme),
          mask_maker<long double, is_of_normals>(scheme)};
}

// without the masks
template <class FT, class Scheme>
Erased_scheme<FT> without_masks(const Scheme& scheme)
{
  Erased_scheme<FT> erased{facts_of(scheme), {}, {}, {}, {}, {}};
  if constexpr (Has_name<Scheme>::value) erased.name = scheme.name();
  erased.dense_row_entries = [scheme](const Level_connectivity& level, unsigned round) {
    return dense_row_entries(scheme, level, round);
  };
  erased.check = [scheme](const Level_connectivity& level, const Element_names& names) {
    check_scheme(scheme, level, names);
  };
  return erased;
}

template <class FT, class Scheme>
Erased_scheme<FT> erased_scheme(const Scheme& scheme)
{
  Erased_scheme<FT> erased = without_masks<FT>(scheme);
  erased.masks = erased_masks<FT, false>(scheme);
  if constexpr (Has_normal_mask<Scheme>::value)
    erased.normal_masks = erased_masks<FT, true>(scheme);
  return erased;
}

// A scheme that was chosen at run time, on the host that it has: a model of PNSubdivisionScheme_3. What its type
// says is what a scheme on this host may be; scheme_traits.h asks what it is.
template <class Host_, class FT>
class Scheme_on_host
{
  static constexpr bool may_be_creased =
    std::is_same_v<Host_, PQQ_host> || std::is_same_v<Host_, PTQ_host>;

public:
  using Host = Host_;
  using Number_type = FT;

  static constexpr unsigned ghost_rings = 1;
  static constexpr bool has_crease_rules = may_be_creased;
  static constexpr bool transfers_curvature = may_be_creased;
  static constexpr bool has_normal_mask = true;

  template <class Scheme>
  explicit Scheme_on_host(const Scheme& scheme)
    : erased_(std::make_shared<const Erased_scheme<FT>>(erased_scheme<FT>(scheme)))
  {}

  // this scheme for the points, another one for the normals
  Scheme_on_host with_normals_of(const Scheme_on_host& normals) const
  {
    Erased_scheme<FT> erased = without_masks<FT>(with_normal_scheme(*this, normals));
    erased.name = name();
    erased.masks = erased_->masks;
    erased.normal_masks = normals.erased_->masks;
    return Scheme_on_host(std::make_shared<const Erased_scheme<FT>>(std::move(erased)));
  }

  const Scheme_facts& facts() const { return *erased_; }
  const std::string& name() const { return erased_->name; }
  double dense_row_entries(const Level_connectivity& level, unsigned round) const
  {
    return erased_->dense_row_entries(level, round);
  }
  void check(const Level_connectivity& level, const Element_names& names) const
  {
    erased_->check(level, names);
  }

  template <class Number>
  Any_mask<Number> mask(const Level_connectivity& level, unsigned round) const
  {
    return Any_mask<Number>(erased_->masks.template of<Number>()(level, round));
  }
  // not to be asked if the normals have no mask of their own
  template <class Number>
  Any_mask<Number> normal_mask(const Level_connectivity& level, unsigned round) const
  {
    if (!facts().has_normal_mask) return Any_mask<Number>(nullptr);
    return Any_mask<Number>(erased_->normal_masks.template of<Number>()(level, round));
  }

private:
  explicit Scheme_on_host(std::shared_ptr<const Erased_scheme<FT>> erased)
    : erased_(std::move(erased))
  {}

  std::shared_ptr<const Erased_scheme<FT>> erased_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SCHEME_ON_HOST_H
