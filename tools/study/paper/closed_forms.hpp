// SPDX-License-Identifier: Apache-2.0
// Bodies whose drawings are known in closed form: their meshes at any fineness, and the lines of the bodies themselves.
// Nothing here is shared with the stages that draw.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "mesh/soup.hpp"

namespace epura::study {

/// Where a viewer is: all projectors pass through `eye`, or have the direction `towards`.
struct Viewer {
  bool central = false;
  Vec3 eye{0}, towards{0, 0, 1};

  [[nodiscard]] Vec3 from(const Vec3& point) const { return central ? eye - point : towards; }
};

/// A body of revolution, or a sombrero, which is a sheet. Its own frame has the axis along z.
struct RoundBody {
  enum class Kind { sphere, frustum, torus, sombrero } kind;
  double radius;       ///< of the sphere, of the lower end of the frustum, of the circle along which the tube runs, of
                       ///< the rim of the sombrero
  double top = 0;      ///< radius of the upper end of the frustum
  double height = 0;   ///< of the frustum, from z = 0; of the sombrero, z = height sin(s) / s, with s = 4 pi r / radius
  double tube = 0;     ///< radius of the tube of the torus
  Vec3 origin{0};      ///< of its frame in the world
  bool lying = false;  ///< its axis is the x axis of the world: (x, y, z) of the frame are (y, z, x) of the world

  [[nodiscard]] Vec3 to_world(const Vec3& local) const;
  [[nodiscard]] Vec3 to_frame(const Vec3& world) const;
  [[nodiscard]] Vec3 direction_to_frame(const Vec3& world) const;
};

/// A line of a body in space, for parameters from 0 to 1.
using SpaceCurve = std::function<Vec3(double)>;

struct ClosedForm {
  std::string name;
  std::string projection;  ///< as on the command line
  std::vector<RoundBody> bodies;
  std::vector<SpaceCurve> crossings{};  ///< lines in which the bodies cross
  int coarsest = 12;                    ///< fineness from which the facets of bodies that cross do so, too
  bool has_cusps = false;  ///< contours end where they point at the viewer: those of facets end up to a facet away

  [[nodiscard]] bool is_central() const { return projection.starts_with("look-at"); }
};

/// All scenes, in the order of the report.
std::vector<ClosedForm> closed_forms();

/// The mesh of a body with `fineness` facets around its axis, or around the tube of a torus, and as many in the other
/// direction as keep them about square.
mesh::Soup mesh_of(const RoundBody& body, int fineness);

/// The bodies as text, turned by a matrix, for programs that draw surfaces: a row for each, "sphere RADIUS FRAME",
/// "frustum RADIUS TOP HEIGHT FRAME", "torus RADIUS TUBE FRAME", "sombrero RADIUS HEIGHT FRAME", where a frame is its
/// origin, its z axis and its x axis, nine numbers.
std::string describe_bodies(const ClosedForm& form, const Mat3& turn);

/// Contours and rims of all bodies, and their crossings.
std::vector<SpaceCurve> lines_of(const ClosedForm& form, const Viewer& viewer);

/// Whether some body is in front of a point, or around it, by more than rounding; a sheet is in front where projectors
/// pass through it.
bool is_hidden(const ClosedForm& form, const Viewer& viewer, const Vec3& point);

/// The visible parts of the lines as polylines in space, with `points` on each whole line; their ends are bisected.
std::vector<std::vector<Vec3>> visible_lines(const ClosedForm& form, const Viewer& viewer, int points);

}  // namespace epura::study
