// SPDX-License-Identifier: Apache-2.0
#include "sizes/sizes_on_sheet.hpp"

#include <algorithm>
#include <cstddef>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/cone_angles.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/place_joins.hpp"

namespace epura::sheet {

namespace {

using Numbers = std::vector<std::size_t>;

// The sizes that a diameter or radius gives.
Numbers sizes_of_circle(const AnchoredDimension& dimension, const FeatureTable& table) {
  check(!dimension.circles.empty(), "a diameter or radius is that of a circle");
  const bool many = repeats_of(dimension.text) > 1;
  const WorldCircle& circle = dimension.circles.front();
  std::vector<int> lists;
  for (const FeatureSize& size : table.sizes)
    if (size.is_at(circle) && !(dimension.text.empty() && size.needs_text)) lists.push_back(size.equal_to);
  if (lists.empty() && dimension.type == DimensionType::radius)
    for (const FeatureSize& size : table.sizes)
      if (size.is_anywhere() && size.is_equal(circle)) lists.push_back(size.equal_to);
  Numbers numbers;
  for (std::size_t i = 0; i < table.sizes.size(); ++i) {
    const FeatureSize& size = table.sizes[i];
    const bool listed = std::find(lists.begin(), lists.end(), size.equal_to) != lists.end();
    if (listed && (size.is_anywhere() || many || size.is_at(circle))) numbers.push_back(i);
  }
  return numbers;
}

// The rounded ends of the cones whose angle a dimension is.
Numbers sizes_of_angle(const AnchoredDimension& dimension, const DimensionSubject& subject, const FeatureTable& table) {
  Numbers numbers;
  for (const features::ConeFeature& cone : subject.features.cones) {
    if (!has_angle(cone, glm::length(subject.world.box.size())) || !is_angle_of(dimension, cone)) continue;
    const int end = rounded_end(cone);
    for (std::size_t i = 0; i < table.sizes.size(); ++i)
      if (table.sizes[i].is_at({cone.ends[end], cone.axis, cone.radii[end], {}, true})) numbers.push_back(i);
  }
  return numbers;
}

// The widths of turned prisms that an aligned length gives; "2×" those of all equal ones.
Numbers sizes_of_sides(const AnchoredDimension& dimension, const FeatureTable& table) {
  Numbers numbers;
  for (std::size_t i = 0; i < table.prisms.size(); ++i)
    for (std::size_t j = 0; j < table.prisms.size(); ++j)
      for (const std::size_t side : {0, 1}) {
        const std::size_t one = table.sides_of(i)[side], other = table.sides_of(j)[side];
        const bool is_equal = table.sizes[one].equal_to == table.sizes[other].equal_to;
        if ((i == j || (repeats_of(dimension.text) > 1 && is_equal)) && is_width_of(dimension, table.prisms[j], side))
          numbers.push_back(one);
      }
  return numbers;
}

Numbers sizes_of(const AnchoredDimension& dimension, const DimensionsInView& view, const DimensionSubject& subject,
                 const FeatureTable& table) {
  if (dimension.type == DimensionType::diameter || dimension.type == DimensionType::radius)
    return sizes_of_circle(dimension, table);
  if (dimension.type == DimensionType::angular)
    return is_auxiliary(dimension) ? Numbers{} : sizes_of_angle(dimension, subject, table);
  Numbers numbers = hexagons_of(dimension, view, subject);
  for (std::size_t& number : numbers)
    number = table.number_of({features::OwnerKind::hexagon, static_cast<int>(number)});
  if (is_auxiliary(dimension)) return numbers;
  for (const std::size_t side : sizes_of_sides(dimension, table)) numbers.push_back(side);
  return numbers;
}

// Whether an overall dimension is this diameter.
bool is_size_of_models(const FeatureSize& size, const DimensionSubject& subject) {
  return std::any_of(subject.extents.begin(), subject.extents.end(), [&](const features::Extent& extent) {
    return extent.form == features::ExtentForm::diameter && size.is_round() && agree(extent.size(), 2 * size.value) &&
           features::are_parallel(extent.axis, size.axis) &&
           features::distance_from_line(size.centre, extent.centre, size.axis) <= size_agrees * 10 * size.value;
  });
}

// Whether a size is that of a pitch circle whose holes are in a table.
bool is_in_table(const FeatureSize& size, const SizesOnSheet& on_sheet, const features::PartFeatures& features) {
  return std::any_of(features.holes.begin(), features.holes.end(), [&](const features::HoleFeature& hole) {
    if (hole.pitch_circle < 0) return false;
    const features::PitchCircleFeature& circle = features.pitch_circles[std::size_t(hole.pitch_circle)];
    return is_labelled(hole.mouth, on_sheet) && size.is_at({circle.centre, circle.axis, circle.radius, {}, true});
  });
}

// Whether a size is the radius of a fillet that the dimension of another one gives. Radii of short arcs are not
// accurate: the number that is written counts.
bool is_radius_of_other(const FeatureSize& size, const SizesOnSheet& on_sheet, const Notation& notation) {
  return size.of_kind().is_as_written && std::any_of(on_sheet.radii.begin(), on_sheet.radii.end(), [&](double radius) {
           return length_text(radius, notation) == length_text(size.value, notation);
         });
}

}  // namespace

SizesOnSheet sizes_on_sheet(std::span<const DimensionsInView> views, const DimensionSubject& subject,
                            const FeatureTable& table) {
  SizesOnSheet on_sheet{std::vector<int>(table.sizes.size(), 0), {}, {}};
  std::vector<std::pair<Numbers, std::size_t>> notes;  // of several features, and for how many
  for (const DimensionsInView& view : views)
    for (const AnchoredDimension& dimension : view.dimensions) {
      Numbers numbers = sizes_of(dimension, view, subject, table);
      const auto count = static_cast<std::size_t>(repeats_of(dimension.text));
      if (count > 1 && count < numbers.size() && !table.sizes[numbers.front()].is_anywhere())
        notes.emplace_back(std::move(numbers), count);
      else
        for (const std::size_t number : numbers) ++on_sheet.dimensions[number];
      if (dimension.type == DimensionType::radius) on_sheet.radii.push_back(dimension.circles.front().radius);
      if (dimension.is_label) on_sheet.labels.push_back(dimension.circles.front());
    }
  // They are for those that have none of their own.
  for (auto& [numbers, count] : notes) {
    std::stable_partition(numbers.begin(), numbers.end(),
                          [&](std::size_t number) { return on_sheet.dimensions[number] == 0; });
    Numbers places;  // two cones may share an end
    for (const std::size_t number : numbers) {
      const FeatureSize& size = table.sizes[number];
      const bool is_known =
          std::ranges::any_of(places, [&](std::size_t place) { return size.is_at(table.sizes[place].circle()); });
      if (!is_known && places.size() == count) continue;
      if (!is_known) places.push_back(number);
      ++on_sheet.dimensions[number];
    }
  }
  check(on_sheet.dimensions.size() == table.sizes.size(), "dimensions of each size are counted");
  return on_sheet;
}

bool is_labelled(const Vec3& mouth, const SizesOnSheet& on_sheet) {
  return std::any_of(on_sheet.labels.begin(), on_sheet.labels.end(), [&](const WorldCircle& label) {
    return glm::distance(label.centre, mouth) <= size_agrees * label.radius;
  });
}

std::vector<bool> given_sizes(const SizesOnSheet& on_sheet, const DimensionSubject& subject, const FeatureTable& table,
                              const Notation& notation) {
  std::vector<bool> given;
  for (std::size_t i = 0; i < table.sizes.size(); ++i) {
    const FeatureSize& size = table.sizes[i];
    given.push_back(on_sheet.dimensions[i] > 0 || is_size_of_models(size, subject) ||
                    is_in_table(size, on_sheet, subject.features) || is_radius_of_other(size, on_sheet, notation));
  }
  return given;
}

int max_dimensions(const FeatureSize& size, const FeatureTable& table) {
  if (!size.is_round()) return 1;
  std::vector<int> lists{size.equal_to};
  for (const FeatureSize& one : table.sizes) {
    if (one.equal_to != size.equal_to) continue;
    for (const FeatureSize& other : table.sizes)
      if (other.is_at(one.circle()) && std::find(lists.begin(), lists.end(), other.equal_to) == lists.end())
        lists.push_back(other.equal_to);
  }
  return static_cast<int>(lists.size());
}

}  // namespace epura::sheet
