// SPDX-License-Identifier: Apache-2.0
#include "sizes/planning.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "features/tolerances.hpp"

namespace epura::sheet {

Planning::Planning(const scene::DimensionDescription& of, std::span<const NamedProjection> projections,
                   const DimensionSubject& parts, const Notation& written)
    : wanted(of),
      views(of, projections),
      subject(parts),
      notation(written),
      box(features::box_of_faces(parts.world)),
      table(feature_table(parts, written)),
      datums(chosen_datums(of, parts)) {}

scene::DimensionDescription Planning::dimension(DimensionType type, const NamedProjection& view,
                                                const std::string& text) const {
  scene::DimensionDescription dimension;
  dimension.where = wanted.where;
  dimension.view = {view.name, wanted.where};
  dimension.type = {type, wanted.where};
  if (text != "<>") dimension.text = {text, wanted.where};
  return dimension;
}

scene::DimensionDescription Planning::dimension(DimensionType type, const NamedProjection& view,
                                                const std::string& text, scene::FeatureCircle circle) const {
  scene::DimensionDescription of_circle = dimension(type, view, text);
  of_circle.circle = std::move(circle);
  return of_circle;
}

void Omitted::append(Omitted other) {
  for (const auto& [view, count] : other.too_many) too_many[view] += count;
  for (const auto& [name, count] : other.askew) askew[name] += count;
}

void Planned::append(Planned other) {
  omitted.append(std::move(other.omitted));
  std::move(other.dimensions.begin(), other.dimensions.end(), std::back_inserter(dimensions));
  std::move(other.places.begin(), other.places.end(), std::back_inserter(places));
  std::move(other.tables.begin(), other.tables.end(), std::back_inserter(tables));
}

bool is_overall(const DimensionSubject& subject, const features::CylinderFeature& cylinder) {
  return std::any_of(subject.extents.begin(), subject.extents.end(), [&](const features::Extent& extent) {
    return extent.form == features::ExtentForm::diameter && features::are_same(extent.size(), 2 * cylinder.radius) &&
           features::are_parallel(extent.axis, cylinder.axis) &&
           features::distance_from_line(cylinder.from, extent.centre, extent.axis) <=
               features::same_size * cylinder.radius;
  });
}

}  // namespace epura::sheet
