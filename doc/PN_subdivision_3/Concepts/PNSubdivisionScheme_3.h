// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

/*!
\ingroup PkgPNSubdivision3Concepts
\cgalConcept

A subdivision scheme: a host, which says how the connectivity is refined, and a mask, which gives
the weights of the new vertices. Parameters such as a tension are members of the scheme.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::PN_subdivision_3::CatmullClark_scheme}
\cgalHasModels{CGAL::PN_subdivision_3::Loop_scheme}
\cgalHasModels{CGAL::PN_subdivision_3::DooSabin_scheme}
\cgalHasModels{CGAL::PN_subdivision_3::Sqrt3_scheme}
\cgalHasModels{CGAL::PN_subdivision_3::Butterfly_scheme}
\cgalHasModels{CGAL::PN_subdivision_3::Kobbelt_scheme}
\cgalHasModels{CGAL::PN_subdivision_3::Midpoint_scheme}
\cgalHasModels{CGAL::PN_subdivision_3::Bilinear_scheme}
\cgalHasModels{CGAL::PN_subdivision_3::CatmullClark_scheme::Grid}
\cgalHasModels{CGAL::PN_subdivision_3::CatmullClark_scheme::Tuned}
\cgalHasModels{CGAL::PN_subdivision_3::Loop_scheme::Tuned}
\cgalHasModels{CGAL::PN_subdivision_3::CatmullClark_scheme::Transfer}
\cgalHasModels{CGAL::PN_subdivision_3::Loop_scheme::Transfer}
\cgalHasModels{CGAL::PN_subdivision_3::Any_scheme}
\cgalHasModels{CGAL::PN_subdivision_3::Linear_scheme}
\cgalHasModels{CGAL::PN_subdivision_3::Scheme_with_normals}
\cgalHasModelsEnd

\sa `CGAL::PN_subdivision_3::subdivide()`
*/
class PNSubdivisionScheme_3
{
public:
  /// a model of `PNSubdivisionHost_3`.
  using Host = unspecified_type;

  /// returns a model of `PNSubdivisionMask_3` for `level`, in the number type `FT`.
  /// Rounds are counted from 1 in one call of a subdivision function.
  template <class FT>
  unspecified_type mask(const CGAL::PN_subdivision_3::Level_connectivity& level,
                        unsigned round) const;

  /// optional: returns about how many entries all rows have that grow with a valence or a degree, in a
  /// round of a call with the control mesh `level`, see
  /// `CGAL::PN_subdivision_3::estimated_row_entries()`.
  static double dense_row_entries(const CGAL::PN_subdivision_3::Level_connectivity& level,
                                  unsigned round);

  /// optional: how many rings of faces around its own a piece of a mesh needs for
  /// `CGAL::PN_subdivision_3::Surface_pieces`: with so many rings that are right on a level, a round gives so many
  /// that are right. It is at least as many as the rows reach; whatever else a mask looks at counts, too.
  static constexpr unsigned ghost_rings;

  /// optional: what has to be regular around a vertex for the scheme to do there the same in every round, so that
  /// limits are known. Without it, limits are found for masks as large as those of the package.
  static constexpr CGAL::PN_subdivision_3::Limit_neighborhood limit_neighborhood;

  /// optional: the first round from which on the rules are the same in all. Without it, the first.
  unsigned first_round() const;

  /// optional: `true` if the rules of the mask for border edges and border vertices, rows of two and three
  /// entries along the border, may serve along creases. The host is then `PQQ_host` or `PTQ_host`. If the
  /// mask has `face_part_of_edge()` and `face_part_of_vertex()` as `CatmullClark_mask`, they say how rows
  /// are shared out to the faces where a crease ends.
  static constexpr bool has_crease_rules;

  /// optional: throws `std::invalid_argument` if the scheme has no rule for the control mesh. It is
  /// called once, after the check of the host. `names.vertex_name(v)`, `names.halfedge_name(h)` and
  /// `names.face_name(f)` return strings for the message.
  template <class Element_names>
  void check(const CGAL::PN_subdivision_3::Level_connectivity& level,
             const Element_names& names) const;
};
