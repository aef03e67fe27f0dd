// SPDX-License-Identifier: Apache-2.0
// What a file requires of its part, on the faces of the model.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "importer/assemble.hpp"
#include "mesh/mesh.hpp"
#include "surfaces/recognise.hpp"

namespace epura::importer {

enum class RequirementKind { dimension, tolerance, datum };
/// Indexed by RequirementKind.
inline constexpr std::array<std::string_view, 3> requirement_kind_names{"dimension", "tolerance", "datum"};

enum class RequirementBounds { none, deviations, limits };
/// Indexed by RequirementBounds.
inline constexpr std::array<std::string_view, 3> requirement_bounds_names{"none", "deviations", "limits"};

/// A dimension, a geometric tolerance or a datum, as the file states it. Lengths are in millimetres, angles in degrees;
/// NaN: the file does not say. For the texts see epura_requirement; empty: the file does not say.
struct ModelRequirement {
  RequirementKind kind = RequirementKind::dimension;
  RequirementBounds bounds = RequirementBounds::none;
  bool is_angle = false;
  double value = 0, lower = 0, upper = 0;
  double unit = 0;    ///< of the file, in millimetres or degrees; 0: not known
  int decimals = -1;  ///< of the value in that unit; -1: the file does not say
  std::string id{}, type{}, name{}, fit{}, modifiers{}, zone{}, datums{}, above{};
  std::string missing{};     ///< what of it could not be read
  std::vector<int> faces{};  ///< of the model's part, in ascending order
};

/// `part` are the faces that the assembled part became on the mesh; null if the file has none.
std::vector<ModelRequirement> requirements_of(const Document& document, const Assembled& assembled,
                                              const mesh::Mesh& mesh, const surfaces::PartFaces* part);

/// "12 dimensions, 6 geometric tolerances and 3 datums"; empty if there are none.
std::string counted_requirements(const std::vector<ModelRequirement>& requirements);

/// How many there are of this kind.
std::size_t count_of(const std::vector<ModelRequirement>& requirements, RequirementKind kind);

}  // namespace epura::importer
