// SPDX-License-Identifier: Apache-2.0
#include "sizes/feature_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/hexagon_widths.hpp"
#include "sizes/hole_table.hpp"
#include "sizes/placed_balls.hpp"
#include "sizes/ring_dimensions.hpp"
#include "sizes/thread_notes.hpp"

namespace epura::sheet {

namespace {

using features::are_parallel;
using features::are_same;
using features::PartFeatures;

bool are_equal_cylinders(const features::CylinderFeature& a, const features::CylinderFeature& b) {
  return a.inwards == b.inwards && a.whole == b.whole && a.model == b.model && are_same(a.radius, b.radius) &&
         are_parallel(a.axis, b.axis) && name_in_note(a.thread) == name_in_note(b.thread);
}

bool are_equal_circles(const FeatureSize& a, const FeatureSize& b) {
  return a.model == b.model && are_same(a.value, b.value) && are_parallel(a.axis, b.axis);
}

// Whether one note can give both, which are of one kind. That of a fillet gives those of all axes.
bool are_equal_sizes(const FeatureSize& a, const FeatureSize& b, const PartFeatures& features,
                     const Notation& notation) {
  const auto both = [&](const auto& all, const auto& equal) {
    return equal(all[static_cast<std::size_t>(a.feature)], all[static_cast<std::size_t>(b.feature)]);
  };
  switch (a.kind) {
    case SizeKind::hole:
      return both(features.holes, [](const features::HoleFeature& one, const features::HoleFeature& other) {
        return are_equal(one, other);
      });
    case SizeKind::cylinder:
      return both(features.cylinders, are_equal_cylinders);
    case SizeKind::hexagon:
      return both(features.hexagons, [](const features::HexagonFeature& one, const features::HexagonFeature& other) {
        return are_equal(one, other);
      });
    case SizeKind::arc:
      return a.model == b.model && are_written_alike(a.value, b.value, notation);
    case SizeKind::pitch_circle:
    case SizeKind::cone_end:
    case SizeKind::slot:
    case SizeKind::side:
      return are_equal_circles(a, b);
    case SizeKind::ring:
      return are_equal_circles(a, b) &&
             both(features.rounds, [](const features::RoundFeature& one, const features::RoundFeature& other) {
               return are_same(one.radius, other.radius);
             });
  }
  return false;
}

std::string name_of_hole(const features::HoleFeature& hole, const Notation& notation) {
  const auto length = [&](double value) { return length_text(value, notation); };
  std::string name = "hole " + size_in_words(hole.thread, hole.diameter, notation);
  if (hole.depth) name += " ↧" + length(*hole.depth);
  if (hole.counterbore) name += " ⌴⌀" + length(hole.counterbore->diameter);
  if (hole.countersink) name += " ⌵⌀" + length(hole.countersink->diameter);
  return name;
}

std::vector<FeatureSize> list_holes(const PartFeatures& features, const Notation& notation) {
  std::vector<FeatureSize> sizes;
  for (const features::HoleFeature& hole : features.holes) {
    check(hole.called() > 0 && (!hole.depth || *hole.depth > 0), "a hole has a diameter, and a depth if it is known");
    sizes.push_back({SizeKind::hole, static_cast<int>(sizes.size()), hole.model, hole.begin_of_bore(), hole.axis,
                     hole.called() / 2, name_of_hole(hole, notation),
                     name_in_note(hole.thread) + recesses_of(hole, notation)});
  }
  return sizes;
}

std::vector<FeatureSize> list_cylinders(const PartFeatures& features, const Notation& notation) {
  std::vector<FeatureSize> sizes;
  for (const features::CylinderFeature& one : features.cylinders)
    sizes.push_back({SizeKind::cylinder, static_cast<int>(sizes.size()), one.model, one.from, one.axis, one.called(),
                     name_of(one, notation), name_in_note(one.thread)});
  return sizes;
}

// A cylinder that continues a cone has the size of its end.
std::vector<FeatureSize> list_cone_ends(const PartFeatures& features, const Notation& notation) {
  std::vector<FeatureSize> sizes;
  for (std::size_t i = 0; i < features.cones.size(); ++i)
    for (const int end : {0, 1}) {
      const features::ConeFeature& cone = features.cones[i];
      const features::CylinderFeature circle{cone.model, cone.ends[end],  cone.ends[end],
                                             cone.axis,  cone.radii[end], false};
      if (circle.radius > 0 && !features::has_coaxial_outline(features, circle))
        sizes.push_back({SizeKind::cone_end, static_cast<int>(i), cone.model, circle.from, cone.axis, circle.radius,
                         "end of a cone ⌀" + length_text(2 * circle.radius, notation), "<>"});
    }
  return sizes;
}

// Those that have nothing but a radius or width.
std::vector<FeatureSize> list_others(const PartFeatures& features, SizeKind kind, const Notation& notation) {
  std::vector<FeatureSize> sizes;
  const auto add = [&](int model, const Vec3& centre, const Vec3& axis, double value, const std::string& name) {
    check(value > 0, "a feature has a radius or width");
    sizes.push_back({kind, static_cast<int>(sizes.size()), model, centre, axis, value, name, "<>"});
  };
  const auto length = [&](double value) { return length_text(value, notation); };
  if (kind == SizeKind::pitch_circle)
    for (const features::PitchCircleFeature& one : features.pitch_circles)
      add(one.model, one.centre, one.axis, one.radius, "pitch circle ⌀" + length(2 * one.radius));
  if (kind == SizeKind::slot)
    for (const features::SlotFeature& one : features.slots)
      add(one.model, one.centres[1], one.axis, one.radius, "slot R" + length(one.radius));
  if (kind == SizeKind::ring)
    for (const int number : find_rings(features)) {
      const features::RoundFeature& one = features.rounds[static_cast<std::size_t>(number)];
      add(one.model, one.centre, one.axis, one.ring,
          "ring ⌀" + length(2 * one.ring) + " of a torus R" + length(one.radius));
      sizes.back().feature = number;
    }
  if (kind == SizeKind::arc)
    for (const features::ArcFeature& one : features.arcs)
      add(one.model, one.centre, one.axis, one.radius, "radius R" + length(one.radius));
  if (kind == SizeKind::hexagon)
    for (const features::HexagonFeature& one : features.hexagons)
      add(one.model, one.centre, one.axis, one.across_flats / 2,
          "hexagon " + length(one.across_flats) + " across flats");
  return sizes;
}

// Both widths of each; equal ones have one note for each of them.
std::vector<FeatureSize> list_sides(const std::vector<TurnedPrism>& prisms, const Notation& notation) {
  std::vector<FeatureSize> sizes;
  for (std::size_t i = 0; i < prisms.size(); ++i)
    for (const double width : prisms[i].widths)
      sizes.push_back({SizeKind::side, static_cast<int>(i), prisms[i].model, prisms[i].centre, prisms[i].axis,
                       width / 2,
                       std::string("width ") + length_text(width, notation) + " of a turned " +
                           (prisms[i].inwards ? "hole" : "boss"),
                       "<>"});
  return sizes;
}

std::vector<FeatureSize> list_sizes(const PartFeatures& features, SizeKind kind, const Notation& notation) {
  if (kind == SizeKind::hole) return list_holes(features, notation);
  if (kind == SizeKind::cylinder) return list_cylinders(features, notation);
  if (kind == SizeKind::cone_end) return list_cone_ends(features, notation);
  return list_others(features, kind, notation);
}

}  // namespace

bool agree(double a, double b) { return std::abs(a - b) <= size_agrees * std::max(std::abs(a), std::abs(b)); }

bool FeatureSize::is_equal(const WorldCircle& circle) const {
  return is_round() && are_parallel(axis, circle.axis) && agree(value, circle.radius);
}

bool FeatureSize::is_at(const WorldCircle& circle) const {
  return is_equal(circle) &&
         features::distance_from_line(centre, circle.centre, axis) <= size_agrees * 10 * circle.radius;
}

std::size_t FeatureTable::first(SizeKind kind) const {
  const auto is_before = [kind](const FeatureSize& one) { return one.kind < kind; };
  return static_cast<std::size_t>(std::partition_point(sizes.begin(), sizes.end(), is_before) - sizes.begin());
}

const FeatureSize& FeatureTable::size_of(SizeKind kind, std::size_t feature) const {
  check(kind != SizeKind::cone_end, "a cone has a size at each end");
  const std::size_t number = first(kind) + feature;
  check(number < sizes.size() && sizes[number].kind == kind, "a feature has a size");
  return sizes[number];
}

bool FeatureTable::is_turned(const Vec3& axis) const { return turned && are_parallel(axis, turned->axis); }

OwnDirections FeatureTable::own_directions(const Vec3& axis) const {
  return is_turned(axis) ? OwnDirections(turned->directions) : std::nullopt;
}

bool FeatureTable::share_angle(const TurnedPrism& a, const TurnedPrism& b) const {
  return turned && has_directions_of(*turned, a) && has_directions_of(*turned, b);
}

bool FeatureTable::is_radial(const features::HoleFeature& hole) const {
  return std::any_of(radial.begin(), radial.end(), [&](const RadialPattern& pattern) {
    return std::find(pattern.holes.begin(), pattern.holes.end(), &hole) != pattern.holes.end();
  });
}

std::string name_of(const features::CylinderFeature& cylinder, const Notation& notation) {
  return (cylinder.inwards ? "bore " : "cylinder ") + size_in_words(cylinder.thread, 2 * cylinder.radius, notation);
}

FeatureTable feature_table(const DimensionSubject& subject, const Notation& notation) {
  const PartFeatures& features = subject.features;
  const FlatEnds flat = find_flat_ends(subject);
  FeatureTable table{.flat_ends = flat,
                     .round_ends = find_round_ends(subject, flat),
                     .channels = find_channels(subject),
                     .balls = find_placed_balls(features, notation),
                     .hexagon_chamfers = find_hexagon_chamfers(subject),
                     .radial = find_radial_patterns(features)};
  // The drawing of an assembly gives the places of its parts alone.
  if (!features.of_assembly) {
    table.prisms = find_turned_prisms(features);
    table.turned = features::find_turned_part(features.inclined, features::points_of_faces(subject.world), flat);
  }
  for (const SizeKind kind : {SizeKind::hole, SizeKind::cylinder, SizeKind::pitch_circle, SizeKind::cone_end,
                              SizeKind::slot, SizeKind::arc, SizeKind::hexagon, SizeKind::ring}) {
    const auto begin = static_cast<int>(table.sizes.size());
    for (FeatureSize& size : list_sizes(features, kind, notation)) {
      size.equal_to = static_cast<int>(table.sizes.size());
      for (int i = begin; i < size.equal_to; ++i)
        if (const FeatureSize& other = table.sizes[static_cast<std::size_t>(i)];
            other.equal_to == i && are_equal_sizes(other, size, features, notation))
          size.equal_to = i;
      table.sizes.push_back(std::move(size));
    }
  }
  const auto first_side = static_cast<int>(table.sizes.size());
  for (FeatureSize& size : list_sides(table.prisms, notation)) {
    const auto side = static_cast<int>(table.sizes.size()) - first_side;
    const auto first = std::find_if(table.prisms.begin(), table.prisms.end(), [&](const TurnedPrism& one) {
      return are_equal(one, table.prisms[std::size_t(size.feature)]);
    });
    size.equal_to = first_side + 2 * static_cast<int>(first - table.prisms.begin()) + side % 2;
    table.sizes.push_back(std::move(size));
  }
  check(table.sizes.size() >= features.holes.size(), "each hole has a size");
  // One note describes holes about an axis.
  const auto number_of = [&](const features::HoleFeature* hole) { return hole - features.holes.data(); };
  for (const RadialPattern& pattern : table.radial)
    for (const features::HoleFeature* hole : pattern.holes)
      table.sizes[static_cast<std::size_t>(number_of(hole))].equal_to =
          table.sizes[static_cast<std::size_t>(number_of(pattern.holes.front()))].equal_to;
  return table;
}

}  // namespace epura::sheet
