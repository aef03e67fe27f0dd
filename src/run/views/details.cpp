// SPDX-License-Identifier: Apache-2.0
#include "views/details.hpp"

#include <algorithm>
#include <string>

#include "annotations/detail_marks.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "drawing/drawing.hpp"
#include "scene/details.hpp"
#include "view/paper_map.hpp"

namespace epura::pipeline {

namespace {

std::string bracketed(const Vec3& p) {
  return "[" + format_rounded(p.x, 6) + ", " + format_rounded(p.y, 6) + ", " + format_rounded(p.z, 6) + "]";
}

[[noreturn]] void refuse_outside(const scene::DetailDescription& detail, const Box& box) {
  throw Error(ErrorKind::input, detail.centre.where,
              "detail '" + *detail.name + "' around " + bracketed(*detail.centre) + " is outside the view '" +
                  *detail.view + "'",
              "what it shows extends from " + bracketed(box.min) + " to " + bracketed(box.max));
}

}  // namespace

drawing::Boundary boundary_on_page(const scene::DetailDescription& detail, const drawing::ViewDrawing& drawing) {
  return {drawing::position_on_page(drawing, *detail.centre), drawing.scale * scene::half_size(detail),
          detail.radius.given()};
}

sheet::Rectangle boundary_box(const scene::DetailDescription& detail, const view::ProjectedScene& view) {
  const Vec4 centre = view::world_to_page(view, view::make_paper_map(view, 1, Vec2(0))) * Vec4(*detail.centre, 1);
  return sheet::box_of({Vec2(centre) / centre.w, scene::half_size(detail), detail.radius.given()});
}

projection::Window box_to_place(const ViewOptions& options, const view::ProjectedScene& view,
                                const world::World& world) {
  const projection::Window drawn = view::drawn_box(view);
  if (!options.detail) return drawn;
  const scene::DetailDescription& detail = *options.detail;
  if (view.projection.central)
    throw Error(ErrorKind::input, detail.view.where,
                "view '" + *detail.view + "' is a perspective, which has no scale at which a detail could be larger",
                "take the detail from a parallel view");
  const sheet::Rectangle box = boundary_box(detail, view);
  if (!box.overlaps({drawn.min, drawn.max})) refuse_outside(detail, world.box);
  return {box.min, box.max};
}

}  // namespace epura::pipeline
