// SPDX-License-Identifier: Apache-2.0
#include "views/broken_outs.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/text.hpp"
#include "drawing/boundary.hpp"
#include "drawing/cut_faces.hpp"
#include "drawing/drawing.hpp"
#include "drawing/freehand.hpp"
#include "edges/crossing_candidates.hpp"
#include "scene/details.hpp"

namespace epura::pipeline {

std::vector<BrokenOutSection> cut_broken_outs(const world::World& world, const scene::SceneDescription& scene,
                                              const scene::ViewDescription& view,
                                              const projection::Projection& projection, const Messages& messages) {
  std::string name = *view.name;
  if (view.detail.given()) name = *scene::find_detail(scene, *view.detail)->view;
  std::vector<BrokenOutSection> sections;
  for (const scene::BrokenOutDescription& one : scene.broken_outs) {
    if (*one.view != name) continue;
    if (projection.central)
      throw Error(ErrorKind::input, one.view.where,
                  "view '" + name + "' is a perspective, which has no broken-out section", "break out a parallel view");
    scene::SectionDescription plane;
    plane.name = {"'" + name + "' (broken out)", one.point.where};
    plane.point = *one.point;
    plane.normal = projection.n;
    sections.push_back({one, cut_section(world, cut::make_cutting_surface(plane), messages)});
  }
  return sections;
}

namespace {

const std::string& where_line_is(const scene::BrokenOutDescription& description) {
  return description.radius.given() ? description.radius.where : description.outline.where;
}

}  // namespace

drawing::ClosedLine line_on_page(const scene::BrokenOutDescription& description, const drawing::ViewDrawing& drawing) {
  std::vector<Vec2> points;
  if (description.radius.given())
    points = drawing::points_on_circle(drawing::position_on_page(drawing, *description.point),
                                       drawing.scale * *description.radius);
  else
    for (const Vec3& p : *description.outline) points.push_back(drawing::position_on_page(drawing, p));
  const std::string& where = where_line_is(description);
  constexpr double least = 0.5;  // mm²; a line around less is a dot
  if (!(std::abs(drawing::twice_area(points)) > 2 * least))
    throw Error(ErrorKind::input, where, "the broken-out section has no area in view '" + *description.view + "'",
                "give points around the area to be cut, or a larger radius or scale");
  drawing::ClosedLine line(drawing::freehand_around(points));
  for (const drawing::BrokenOut& other : drawing.cuts.broken_out)
    if (overlap(line, drawing::ClosedLine(other.ring)))
      throw Error(ErrorKind::input, where,
                  "the broken-out section overlaps another one in view '" + *description.view + "'",
                  "separate them, or cut the view by a [[section]] with a path");
  return line;
}

std::vector<drawing::PaperTriangle> removed_on_paper(const world::World& world, const BrokenOutSection& one,
                                                     const drawing::ClosedLine& line, const Mat4& world_to_page) {
  std::vector<drawing::PaperTriangle> removed =
      drawing::before_cuts_on_paper(world, {edges::all_triangles(world).triangles}, one.section.surface, world_to_page);
  if (std::none_of(removed.begin(), removed.end(), [&](const drawing::PaperTriangle& triangle) {
        return !line.area({{triangle.begin(), triangle.end()}}).empty();
      })) {
    const auto range = [&](int axis) {
      return format_rounded(world.box.min[axis], 6) + " to " + format_rounded(world.box.max[axis], 6);
    };
    throw Error(ErrorKind::input, where_line_is(one.description),
                "the broken-out section removes nothing inside its line in view '" + *one.description.view + "'",
                "move its point behind what is to be removed, or its line around it: the models reach from " +
                    range(0) + " along x, " + range(1) + " along y and " + range(2) + " along z");
  }
  return removed;
}

}  // namespace epura::pipeline
