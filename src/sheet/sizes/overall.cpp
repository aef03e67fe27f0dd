// SPDX-License-Identifier: Apache-2.0
#include "sizes/overall.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "sheet/marks.hpp"
#include "sizes/anchors.hpp"

namespace epura::sheet {

namespace {

struct PageDirection {
  DimensionDirection direction;
  Vec3 along;
  std::array<Vec3, 4> seen_from;  // clearest first
};

const std::array<PageDirection, 3> page_directions{
    {{DimensionDirection::width, {1, 0, 0}, {{{0, -1, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0, -1}}}},
     {DimensionDirection::height, {0, 0, 1}, {{{0, -1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}}},
     {DimensionDirection::depth, {0, 1, 0}, {{{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, -1}}}}}};

constexpr double along_axes = 1e-6;

bool looks_from(const projection::Projection& projection, const Vec3& viewer) {
  return !projection.central && glm::length(projection.n - viewer) < along_axes &&
         glm::length(glm::normalize(projection.projector) - viewer) < along_axes;
}

// A section may leave out what reaches farthest. An aligned one keeps lengths along the axes of its turns, and
// diameters around one.
bool keeps_size(const NamedProjection& view, const PageDirection& direction, const features::Extent& extent) {
  for (const std::vector<Vec3>& at_end : extent.at_ends)
    if (!view.aligned() && !at_end.empty() &&
        std::ranges::none_of(at_end, [&](const Vec3& point) { return keeps(view, point); }))
      return false;
  return keeps_positions(view, axis_of(direction.direction)) ||
         (extent.form == features::ExtentForm::diameter && shows_in_place(view, extent.centre, extent.axis));
}

const NamedProjection* clearest(std::span<const NamedProjection> views, const PageDirection& direction,
                                const std::string& name, const features::Extent& extent) {
  for (const bool aligned : {false, true})
    for (const Vec3& viewer : direction.seen_from)
      for (const NamedProjection& view : views)
        if ((name.empty() || view.name == name) && view.aligned() == aligned && looks_from(view.projection, viewer) &&
            keeps_size(view, direction, extent))
          return &view;
  return nullptr;
}

// How many dimension lines there may be on each side of the ink.
struct Lines {
  int below = 0, right = 0;          // overall dimensions, whose side is known
  int horizontal = 0, vertical = 0;  // others, which may be on either side
  double farthest = 0;               // offset
};

// Parallel lines of an arrangement have a row each; the texts of a common origin are as long as two rows are high.
int rows_of(const scene::DimensionDescription& dimension) {
  if (!dimension.arrangement.given()) return 1;
  const int most = 3;  // more leave no room for the view
  if (*dimension.arrangement == DimensionArrangement::baseline)
    return std::min(static_cast<int>(dimension.anchors.size()) - 1, most);
  return *dimension.arrangement == DimensionArrangement::ordinate ? 2 : 1;
}

Lines dividing_lines_of(std::span<const scene::DimensionDescription> dimensions,
                        const projection::Projection& projection) {
  Lines lines;
  for (const scene::DimensionDescription& dimension : dimensions) {
    const std::optional<DimensionDirection>& direction = dimension.direction.value;
    const auto along = std::find_if(page_directions.begin(), page_directions.end(),
                                    [&direction](const PageDirection& d) { return d.direction == direction; });
    // A leader needs no row of its own beside the ink.
    const bool is_leader =
        dimension.circle && std::abs(glm::dot(dimension.circle->axis, projection.n)) > 1 - along_axes;
    if (is_leader) continue;
    if (dimension.offset.given()) {
      lines.farthest = std::max(lines.farthest, std::abs(*dimension.offset));
    } else if (along != page_directions.end()) {
      const bool upright = std::abs(glm::dot(along->along, projection.v)) > 0.5;
      ++(upright ? lines.right : lines.below);
    } else {
      const int rows = rows_of(dimension);
      lines.horizontal += direction == DimensionDirection::vertical ? 0 : rows;
      lines.vertical += direction == DimensionDirection::horizontal ? 0 : rows;
    }
  }
  return lines;
}

}  // namespace

std::vector<scene::DimensionDescription> overall_dimensions(const scene::DimensionDescription& overall,
                                                            std::span<const NamedProjection> views,
                                                            const std::array<features::Extent, 3>& extents) {
  std::vector<scene::DimensionDescription> dimensions;
  const auto stands_already = [&](const PageDirection& direction) {
    return std::any_of(dimensions.begin(), dimensions.end(), [&](const scene::DimensionDescription& other) {
      return extents[axis_of(direction.direction)].is_same_as(extents[axis_of(*other.direction)]);
    });
  };
  // A diameter stands in a view whose outline has it.
  std::array<const PageDirection*, 3> order{};
  std::transform(page_directions.begin(), page_directions.end(), order.begin(),
                 [](const PageDirection& one) { return &one; });
  std::stable_partition(order.begin(), order.end(), [&](const PageDirection* direction) {
    return !extents[axis_of(direction->direction)].interrupted;
  });
  for (const PageDirection* ordered : order) {
    const PageDirection& direction = *ordered;
    if (!(extents[axis_of(direction.direction)].size() > 0)) continue;  // a flat model has no thickness
    const NamedProjection* view =
        clearest(views, direction, overall.view.value_or(""), extents[axis_of(direction.direction)]);
    if (view == nullptr || stands_already(direction)) continue;
    scene::DimensionDescription& dimension = dimensions.emplace_back(overall);
    dimension.view = {view->name, overall.where};
    dimension.direction = {direction.direction, overall.where};
  }
  if (dimensions.empty())
    throw Error(ErrorKind::input, overall.where, "no view shows the size of the models in true length",
                "add a view such as front, top or left");
  check(dimensions.size() <= page_directions.size(), "a direction has one overall size");
  return dimensions;
}

Room dimension_room(std::span<const scene::DimensionDescription> dimensions, const projection::Projection& projection,
                    double text_height) {
  const Lines lines = dividing_lines_of(dimensions, projection);
  const auto room = [&](int needed_lines) {
    constexpr int max_lines = 4;  // more leave too little of a sheet for the views; short dimensions share lines
    const int count = std::min(needed_lines, max_lines);
    const double stepped = count > 0 ? first_dimension + (count - 1) * dimension_step(text_height) : 0;
    const double needed = std::max(stepped, lines.farthest);
    return needed > 0 ? needed + text_height : 0;
  };
  const int both_rows = (lines.horizontal + 1) / 2, both_columns = (lines.vertical + 1) / 2;
  // A height is dimensioned on the side closer to its ends.
  const double beside = room(lines.right + both_columns);
  return {{beside, room(lines.below + both_rows)}, {beside, room(both_rows)}};
}

}  // namespace epura::sheet
