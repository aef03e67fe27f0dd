// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/planning.hpp"

#include <algorithm>

#include "design/tolerances.hpp"

namespace epura::sheet {

namespace {

// Aligned sections count where no other view does.
std::vector<const NamedProjection*> in_order(const ViewChoice& views) {
  std::vector<const NamedProjection*> all = views.all();
  all.insert(all.end(), views.aligned().begin(), views.aligned().end());
  return all;
}

}  // namespace

Planning::Planning(const scene::DimensionDescription& of, std::span<const NamedProjection> projections,
                   const DimensionSubject& parts, const Notation& written)
    : wanted(of),
      views(of, projections),
      subject(parts),
      notation(written),
      box(design::box_of_faces(parts.world)),
      stations(parts, in_order(views)) {}

scene::DimensionDescription& Planning::add(DimensionType type, const NamedProjection& view, const std::string& text) {
  scene::DimensionDescription& dimension = dimensions.emplace_back();
  dimension.where = wanted.where;
  dimension.view = {view.name, wanted.where};
  dimension.type = {type, wanted.where};
  if (text != "<>") dimension.text = {text, wanted.where};
  return dimension;
}

bool are_coaxial(const Vec3& point, const Vec3& axis, const Vec3& other, double size) {
  return glm::length(glm::cross(other - point, axis)) <= design::same_size * size;
}

bool is_overall(const DimensionSubject& subject, const design::DesignCylinder& cylinder) {
  return std::any_of(subject.extents.begin(), subject.extents.end(), [&](const design::Extent& extent) {
    return extent.form == design::ExtentForm::diameter && design::are_same(extent.size(), 2 * cylinder.radius) &&
           design::are_parallel(extent.axis, cylinder.axis) &&
           are_coaxial(extent.centre, extent.axis, cylinder.from, cylinder.radius);
  });
}

}  // namespace epura::sheet
