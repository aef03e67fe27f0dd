// SPDX-License-Identifier: Apache-2.0
// The content of a file after Open CASCADE has read it: parts, each once, and the tree of their positions.
#pragma once

#include <epura/importer_abi.h>

#include <NCollection_DataMap.hxx>
#include <NCollection_Map.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <cstdint>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace occt {

/// sRGB, each part from 0 to 1.
using Colour = std::array<double, 3>;

/// A solid, a shell, or a compound of faces that belong to neither.
struct Body {
  TopoDS_Shape shape;
  std::string name;  ///< its own name in the file; may be empty
  std::optional<Colour> colour{};
};

struct Part {
  std::string name;
  std::vector<Body> bodies;
  std::vector<TopoDS_Edge> wires;  ///< edges that bound no face, each with a curve in space
  std::vector<gp_Pnt> points;      ///< vertices of no edge
  std::optional<Colour> colour{};  ///< of bodies without one
};

struct Place {
  std::string name;
  std::uint32_t parent;            ///< an earlier position, or EPURA_NONE
  std::uint32_t part;              ///< or EPURA_NONE
  gp_Trsf transform;               ///< to the parent
  std::optional<Colour> colour{};  ///< instead of those of everything below
};

/// What the file requires of the part: a dimension, a tolerance, a datum, a surface texture or a note. See
/// epura_requirement.
struct Requirement {
  std::uint32_t kind = EPURA_DIMENSION;
  std::string id{}, type{}, name{};
  double value = std::numeric_limits<double>::quiet_NaN(), lower = value, upper = value;  ///< mm or degrees
  std::uint32_t bounds = EPURA_NO_BOUNDS;
  bool is_angle = false;
  double unit = 0;  ///< of the file, mm or degrees
  int decimals = -1;
  std::string fit{}, modifiers{}, zone{}, datums{}, above{}, missing{};
  std::vector<unsigned long long> items{};  ///< numbers of the faces, edges and points of the file that it belongs to
  double length_unit = 1;                   ///< of the points among them, mm
  double target_length = 0, target_width = 0;  ///< of a datum target, mm
  std::vector<TopoDS_Shape> faces{};           ///< that they are or stand for
  std::string text{};                          ///< of a note or a surface texture
  std::vector<std::array<double, 6>> lines{};  ///< in the coordinates of the first face
  std::vector<gp_XYZ> area{};                  ///< likewise: three or none
};

/// A camera that the file has stored. See epura_saved_view.
struct SavedView {
  bool is_central;
  std::string name;
  gp_Pnt eye;
  gp_Dir towards, up;
  std::vector<std::array<double, 6>> planes{};  ///< a point and a normal of each
};

/// Lengths in millimetres.
struct Model {
  std::vector<Part> parts;
  std::vector<Place> places;
  std::vector<std::string> notes;  ///< sentences about repairs and omissions
  std::vector<Requirement> requirements{};
  std::vector<SavedView> saved_views{};
  std::string standard{};  ///< of dimensions and tolerances; empty: the file names none
};

/// Names and colours of shapes, without their locations.
using Names = NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher>;
using Colours = NCollection_DataMap<TopoDS_Shape, Colour, TopTools_ShapeMapHasher>;

/// Shapes of products, without their locations. XCAF makes a component of each representation of a product, too.
using Products = NCollection_Map<TopoDS_Shape, TopTools_ShapeMapHasher>;

/// Whether surfaces, lines and points beside the bodies of a part are drawn.
enum class Construction { omit, draw };

/// What is drawn beside the bodies of a file.
struct Beside {
  Construction construction = Construction::omit;
  bool annotations = false;  ///< lines of those whose meaning is not read
};

/// What a file says of its shapes.
struct Attributes {
  Names names;
  Colours colours;
  Products products{};
};

/// "1 edge", "12 edges".
inline std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

}  // namespace occt
