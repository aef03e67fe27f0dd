// SPDX-License-Identifier: Apache-2.0
#include "explain/reason.hpp"

#include "base/text.hpp"
#include "edges/dihedral.hpp"
#include "edges/feature_edges.hpp"

namespace epura::explain {

namespace {

const mesh::Mesh& mesh_of(const ExplainInput& drawn_view, const Subject& subject) {
  return *drawn_view.world.models[subject.model].mesh;
}

std::optional<EdgeKind> kind_under(const ExplainInput& drawn_view, const Subject& subject,
                                   const edges::EdgeOptions& options) {
  return edges::feature_edges(drawn_view.world, drawn_view.view, subject.model, options)[subject.mesh_edge];
}

std::string words_of(const surfaces::PartSurface& surface) {
  using surfaces::SurfaceKind;
  const std::string radius = " of radius " + format_value(surface.radius);
  switch (surface.kind) {
    case SurfaceKind::plane:
      return "a plane";
    case SurfaceKind::cylinder:
      return "a cylinder" + radius;
    case SurfaceKind::cone:
      return "a cone";
    case SurfaceKind::sphere:
      return "a sphere" + radius;
    case SurfaceKind::torus:
      return "a torus" + radius;
    case SurfaceKind::free_form:
      break;
  }
  return "a free form";
}

// For a mesh edge whose part is known.
std::string border_of(const ExplainInput& drawn_view, const Subject& subject, const surfaces::PartFaces& part) {
  const std::string faces = names_of(faces_at(drawn_view, subject));
  const mesh::Mesh& mesh = mesh_of(drawn_view, subject);
  const surfaces::PartBorder* border = part.border_at(subject.mesh_edge);
  const auto surface = [&](int face) { return words_of(part.faces[static_cast<std::size_t>(face)].surface); };
  if (border == nullptr)
    return faces + " are on " +
           surface(part.face_of_triangle[mesh.triangles_of(mesh.edges[subject.mesh_edge]).front()]) +
           ", and it lies inside this face of the part";
  if (border->faces[0] == border->faces[1]) return faces + " form a fold inside " + surface(border->faces[0]);
  return faces + " are on " + surface(border->faces[0]) + " and " + surface(border->faces[1]) + " that meet at " +
         format_rounded(border->angle, 3) + " degrees; a crease is where faces of the part meet at more than " +
         format_value(drawn_view.options.part_angle);
}

std::string fold_of(const ExplainInput& drawn_view, const Subject& subject, bool crease) {
  const world::Placed& placed = drawn_view.world.models[subject.model];
  if (placed.part != nullptr && placed.mesh->uncut == nullptr &&
      mesh_of(drawn_view, subject).edges[subject.mesh_edge].count == 2)
    return border_of(drawn_view, subject, *placed.part);
  const std::string faces = names_of(faces_at(drawn_view, subject));
  const auto angle = angle_at(drawn_view, subject);
  if (!angle) return faces + " meet here";
  const double min = drawn_view.options.crease_angle;
  const std::string text = faces + " turn by " + format_value(*angle) + " degrees";
  if (*angle < min && *angle >= drawn_view.options.weak_angle)
    return text + (crease ? " and continue a crease" : " and continue no crease") + "; a crease turns by " +
           format_value(min) + " or more, or by " + format_value(drawn_view.options.weak_angle) +
           " where it continues one";
  if (crease != (*angle >= min)) return text + ", but not if slivers are ignored";
  return text + "; a crease turns by " + format_value(min) + " or more";
}

std::string reason_for(const ExplainInput& drawn_view, const Subject& subject, EdgeKind kind) {
  if (kind == EdgeKind::wire) return "the file has a line here that bounds no face";
  if (kind == EdgeKind::thread) return "the roots of a screw thread are here (ISO 6410-1)";
  if (kind == EdgeKind::thread_end) return "the useful length of a screw thread ends here (ISO 6410-1)";
  const std::string faces = names_of(faces_at(drawn_view, subject));
  switch (kind) {
    case EdgeKind::contour:
      return faces + " on one side of it in the drawing, or one of them seen edge-on";
    case EdgeKind::boundary:
      return "no face continues " + faces;
    case EdgeKind::intersection:
      return faces + " cross, their planes at " + format_value(angle_at(drawn_view, subject).value_or(0)) + " degrees";
    case EdgeKind::section:
      return "the cutting plane meets " + faces;
    default:
      return fold_of(drawn_view, subject, kind == EdgeKind::crease);
  }
}

std::string reason_not_drawn(const ExplainInput& drawn_view, const Subject& subject) {
  if (const auto kind = kind_under(drawn_view, subject, drawn_view.options))
    return "a " + std::string(edges::name_of(*kind)) + ", but outside the drawn region";
  edges::EdgeOptions all = drawn_view.options;
  all.contour = all.boundary = all.crease = all.intersection = all.wire = all.smooth = true;
  const auto kind = kind_under(drawn_view, subject, all);
  if (kind && edges::is_within_surface(*kind)) return reason_for(drawn_view, subject, *kind);
  if (kind)
    return std::string(edges::name_of(*kind)) + " edges are not selected; " + reason_for(drawn_view, subject, *kind);
  if (mesh_of(drawn_view, subject).edges[subject.mesh_edge].diagonal)
    return "a diagonal of " + names_of(faces_at(drawn_view, subject));
  return "the long side of a sliver; its short sides are judged instead";
}

}  // namespace

std::string format_value(double number) { return format_rounded(number, 6); }

std::string format_value(const Vec2& p) { return "(" + format_value(p.x) + ", " + format_value(p.y) + ")"; }

std::string format_value(const Vec3& p) {
  return "(" + format_value(p.x) + ", " + format_value(p.y) + ", " + format_value(p.z) + ")";
}

std::optional<double> angle_at(const ExplainInput& drawn_view, const Subject& subject) {
  if (subject.mesh_edge < 0) return drawn_view.drawn.crossings[drawn_view.drawn.edges[subject.drawn].crossing].angle;
  const mesh::Mesh& mesh = mesh_of(drawn_view, subject);
  const mesh::MeshEdge& edge = mesh.edges[subject.mesh_edge];
  if (edge.count != 2) return std::nullopt;
  const auto both = mesh.triangles_of(edge);
  const int first = drawn_view.world.first_vertex[subject.model];
  return edges::fold_angle({drawn_view.world, subject.model, drawn_view.view.map.normalisation},
                           {first + edge.vertex[0], first + edge.vertex[1]}, both[0], both[1]);
}

std::string reason_of(const ExplainInput& drawn_view, const Subject& subject) {
  if (subject.drawn < 0) return "not drawn: " + reason_not_drawn(drawn_view, subject);
  const EdgeKind kind = drawn_view.drawn.edges[subject.drawn].kind;
  return "drawn as " + std::string(edges::name_of(kind)) + ": " + reason_for(drawn_view, subject, kind);
}

}  // namespace epura::explain
