// SPDX-License-Identifier: Apache-2.0
// The content of a file as an importer returns it: shapes, and a tree with their positions.
#pragma once

#include <epura/importer_abi.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/spline.hpp"
#include "foreign/packing.hpp"
#include "mesh/soup.hpp"
#include "surfaces/declared_part.hpp"
#include "surfaces/part_surface.hpp"

namespace epura::importer {

/// Colours are 0xrrggbb.
inline constexpr int no_colour = -1;

// What comes from another process has no bool and no enumeration that is not checked: any bytes may come.

/// The curve of an edge or of a wire.
struct EdgeSpline {
  bool is_wire;
  int number;  ///< of the edge or of the wire in its shape
  Spline spline;
  std::vector<double> parameters;  ///< of the points of the edge
};

struct Shape {
  std::string name{};
  double step = 0;  ///< distance between neighbouring values of coordinates; 0: not told
  mesh::Points points{};
  std::vector<int> corners{};          ///< indices of points, of all polygons one after the other
  std::vector<int> polygon_ends{};     ///< end of each polygon in `corners`
  std::vector<int> face_of_polygon{};  ///< -1: none
  std::vector<int> body_of_polygon{};  ///< -1: none
  std::vector<std::string> body_names{};
  std::vector<int> body_colours{};  ///< by body
  int colour = no_colour;           ///< of bodies without one
  std::vector<surfaces::PartSurface> faces{};
  std::vector<surfaces::DeclaredEdge> edges{};
  std::vector<int> edge_vertices{};
  std::vector<int> wire_vertices{};   ///< indices of points, of all wires one after the other
  std::vector<int> wire_ends{};       ///< end of each wire in `wire_vertices`
  std::vector<int> marked_points{};   ///< indices of points that are drawn as such
  std::vector<EdgeSpline> splines{};  ///< for hidden lines in memory: other processes are not asked for them
};

struct Node {
  int parent, shape;  ///< -1: none
  std::string name;
  std::array<double, 12> transform;  ///< rows of the 3x4 matrix to the coordinates of its parent
  int colour = no_colour;            ///< of everything below it
};

/// More decimals than a double has digits.
inline constexpr int max_decimals = 16;

enum class RequirementKind : std::uint32_t {
  dimension = EPURA_DIMENSION,
  tolerance = EPURA_TOLERANCE,
  datum = EPURA_DATUM,
  note = EPURA_NOTE,
  surface_texture = EPURA_SURFACE_TEXTURE
};
/// Indexed by RequirementKind.
inline constexpr std::array<std::string_view, 5> requirement_kind_names{"dimension", "tolerance", "datum", "note",
                                                                        "surface texture"};

enum class RequirementBounds : std::uint32_t {
  none = EPURA_NO_BOUNDS,
  deviations = EPURA_DEVIATIONS,
  limits = EPURA_LIMITS
};
/// Indexed by RequirementBounds.
inline constexpr std::array<std::string_view, 3> requirement_bounds_names{"none", "deviations", "limits"};

/// A dimension, a geometric tolerance, a datum, a note or a surface texture, as the file states it. Lengths are in
/// millimetres, angles in degrees; NaN: the file does not say. For the texts see epura_requirement; empty: the file
/// does not say.
struct StatedRequirement {
  RequirementKind kind;
  RequirementBounds bounds;
  int is_angle;
  int decimals;  ///< of the value in the unit of the file; -1: the file does not say
  double value, lower, upper;
  double unit;  ///< of the file, in millimetres or degrees; 0: not known
  std::string id{}, type{}, name{}, fit{}, modifiers{}, zone{}, datums{}, above{};
  std::string missing{};                       ///< what of it could not be read
  std::string text{};                          ///< of a note or a surface texture
  std::vector<std::array<double, 6>> lines{};  ///< see epura_requirement
  std::vector<std::array<double, 3>> area{};   ///< three or none; likewise
};

struct Requirement : StatedRequirement {
  std::vector<std::array<int, 2>> faces{};  ///< shape, and face of it
};

struct Document {
  double unit = 0;  ///< millimetres; 0: the file does not state it
  int is_y_up = 0;  ///< instead of z
  int is_single_precision = 0;
  int is_printed = 0;  ///< coordinates were stored as text, all with the same number of digits or decimals
  std::vector<Shape> shapes{};
  std::vector<Node> nodes{};
  std::vector<std::string> notes{};
  std::vector<Requirement> requirements{};
};

/// Whether its lines and area are finite, and the area has all that it needs.
bool has_sound_places(const StatedRequirement& requirement);

/// Throws Error{plugin} for indices out of range: the process that sent them may be corrupted.
void expect_sound(const Document& document);

void pack_document(foreign::Packer& pack, const Document& document);
Document unpack_document(foreign::Unpacker& unpack);

}  // namespace epura::importer
