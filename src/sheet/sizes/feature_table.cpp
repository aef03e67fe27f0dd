// SPDX-License-Identifier: Apache-2.0
#include "sizes/feature_table.hpp"

#include <algorithm>
#include <array>
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

/// What sizes are listed of.
struct Listed {
  const PartFeatures& features;
  const std::vector<TurnedPrism>& prisms;
  const Notation& notation;

  [[nodiscard]] std::string length(double value) const { return length_text(value, notation); }
};

std::string name_of_hole(const features::HoleFeature& hole, const Notation& notation) {
  const auto length = [&](double value) { return length_text(value, notation); };
  std::string name = "hole " + size_in_words(hole.thread, hole.diameter, notation);
  if (hole.depth) name += " ↧" + length(*hole.depth);
  if (hole.counterbore) name += " ⌴⌀" + length(hole.counterbore->diameter);
  if (hole.countersink) name += " ⌵⌀" + length(hole.countersink->diameter);
  return name;
}

using Sizes = std::vector<FeatureSize>;

Sizes list_holes(const Listed& of) {
  Sizes sizes;
  for (const features::HoleFeature& hole : of.features.holes) {
    check(hole.called() > 0 && (!hole.depth || *hole.depth > 0), "a hole has a diameter, and a depth if it is known");
    const int number = static_cast<int>(sizes.size());
    FeatureSize& size = sizes.emplace_back(FeatureSize{SizeKind::hole, number, hole.model, hole.begin_of_bore(),
                                                       hole.axis, hole.called() / 2, name_of_hole(hole, of.notation),
                                                       name_in_note(hole.thread) + recesses_of(hole, of.notation)});
    size.owner = {features::OwnerKind::hole, number};
    size.other_radii.push_back(hole.diameter / 2);
    for (const auto& recess : {hole.counterbore, hole.countersink})
      if (recess) size.other_radii.push_back(recess->diameter / 2);
    size.label_at = hole.mouth;
    size.needs_text = hole.depth || hole.counterbore || hole.countersink;
  }
  return sizes;
}

Sizes list_cylinders(const Listed& of) {
  Sizes sizes;
  for (const features::CylinderFeature& one : of.features.cylinders)
    sizes.push_back({SizeKind::cylinder, static_cast<int>(sizes.size()), one.model, one.from, one.axis, one.called(),
                     name_of(one, of.notation), name_in_note(one.thread)});
  return sizes;
}

// A cylinder that continues a cone has the size of its end.
Sizes list_cone_ends(const Listed& of) {
  Sizes sizes;
  for (std::size_t i = 0; i < of.features.cones.size(); ++i)
    for (const int end : {0, 1}) {
      const features::ConeFeature& cone = of.features.cones[i];
      const features::CylinderFeature circle{cone.model, cone.ends[end],  cone.ends[end],
                                             cone.axis,  cone.radii[end], false};
      if (circle.radius > 0 && !features::has_coaxial_outline(of.features, circle))
        sizes.push_back({SizeKind::cone_end, static_cast<int>(i), cone.model, circle.from, cone.axis, circle.radius,
                         "end of a cone ⌀" + of.length(2 * circle.radius), "<>", end});
    }
  return sizes;
}

Sizes list_pitch_circles(const Listed& of) {
  Sizes sizes;
  for (const features::PitchCircleFeature& one : of.features.pitch_circles)
    sizes.push_back({SizeKind::pitch_circle, static_cast<int>(sizes.size()), one.model, one.centre, one.axis,
                     one.radius, "pitch circle ⌀" + of.length(2 * one.radius), "<>"});
  return sizes;
}

Sizes list_slots(const Listed& of) {
  Sizes sizes;
  for (const features::SlotFeature& one : of.features.slots) {
    const int number = static_cast<int>(sizes.size());
    sizes.push_back({SizeKind::slot, number, one.model, one.centres[1], one.axis, one.radius,
                     "slot R" + of.length(one.radius), "<>"});
    sizes.back().owner = {features::OwnerKind::slot, number};
  }
  return sizes;
}

Sizes list_arcs(const Listed& of) {
  Sizes sizes;
  for (const features::ArcFeature& one : of.features.arcs)
    sizes.push_back({SizeKind::arc, static_cast<int>(sizes.size()), one.model, one.centre, one.axis, one.radius,
                     "radius R" + of.length(one.radius), "<>"});
  return sizes;
}

Sizes list_hexagons(const Listed& of) {
  Sizes sizes;
  for (const features::HexagonFeature& one : of.features.hexagons) {
    const int number = static_cast<int>(sizes.size());
    sizes.push_back({SizeKind::hexagon, number, one.model, one.centre, one.axis, one.across_flats / 2,
                     "hexagon " + of.length(one.across_flats) + " across flats", "<>"});
    sizes.back().owner = {features::OwnerKind::hexagon, number};
  }
  return sizes;
}

Sizes list_rings(const Listed& of) {
  Sizes sizes;
  for (const int number : find_rings(of.features)) {
    const features::RoundFeature& one = of.features.rounds[static_cast<std::size_t>(number)];
    sizes.push_back({SizeKind::ring, number, one.model, one.centre, one.axis, one.ring,
                     "ring ⌀" + of.length(2 * one.ring) + " of a torus R" + of.length(one.radius), "<>"});
  }
  return sizes;
}

// Both widths of each.
Sizes list_sides(const Listed& of) {
  Sizes sizes;
  for (std::size_t i = 0; i < of.prisms.size(); ++i)
    for (const int side : {0, 1}) {
      const TurnedPrism& prism = of.prisms[i];
      const double width = prism.widths[static_cast<std::size_t>(side)];
      sizes.push_back({SizeKind::side, static_cast<int>(i), prism.model, prism.centre, prism.axis, width / 2,
                       "width " + of.length(width) + " of a turned " + (prism.inwards ? "hole" : "boss"), "<>", side});
    }
  return sizes;
}

bool are_equal_circles(const FeatureSize& a, const FeatureSize& b, const Listed&) {
  return a.model == b.model && are_same(a.value, b.value) && are_parallel(a.axis, b.axis);
}

// The note of a fillet gives those of all axes.
bool are_equal_arcs(const FeatureSize& a, const FeatureSize& b, const Listed& of) {
  return a.model == b.model && are_written_alike(a.value, b.value, of.notation);
}

bool are_equal_rings(const FeatureSize& a, const FeatureSize& b, const Listed& of) {
  const auto tube = [&](const FeatureSize& one) {
    return of.features.rounds[static_cast<std::size_t>(one.feature)].radius;
  };
  return are_equal_circles(a, b, of) && are_same(tube(a), tube(b));
}

// Equal ones have one note for each of their widths.
bool are_equal_sides(const FeatureSize& a, const FeatureSize& b, const Listed& of) {
  const auto prism = [&](const FeatureSize& one) -> const TurnedPrism& {
    return of.prisms[static_cast<std::size_t>(one.feature)];
  };
  return a.part == b.part && are_equal(prism(a), prism(b));
}

// Of the features that two sizes have.
template <auto features_of, auto are_equal_features>
bool have_equal(const FeatureSize& a, const FeatureSize& b, const Listed& of) {
  const auto& all = of.features.*features_of;
  return are_equal_features(all[static_cast<std::size_t>(a.feature)], all[static_cast<std::size_t>(b.feature)]);
}

bool are_equal_holes(const features::HoleFeature& a, const features::HoleFeature& b) { return are_equal(a, b); }
bool are_equal_hexagons(const features::HexagonFeature& a, const features::HexagonFeature& b) {
  return are_equal(a, b);
}

/// A kind of sizes: how they are listed, and whether one note can give two of them.
struct KindRow {
  KindOfSize of;
  Sizes (*list)(const Listed& of);
  bool (*are_equal)(const FeatureSize& a, const FeatureSize& b, const Listed& of);
};

// In the order of SizeKind.
constexpr std::array<KindRow, 9> kinds{{
    {{SizeKind::hole, ShownBy::along_or_inside}, list_holes, have_equal<&PartFeatures::holes, are_equal_holes>},
    {{SizeKind::cylinder, ShownBy::along_or_across},
     list_cylinders,
     have_equal<&PartFeatures::cylinders, are_equal_cylinders>},
    {{SizeKind::pitch_circle, ShownBy::along}, list_pitch_circles, are_equal_circles},
    {{SizeKind::cone_end, ShownBy::along_or_across}, list_cone_ends, are_equal_circles},
    {{.kind = SizeKind::slot, .shown_by = ShownBy::along, .is_anywhere = true}, list_slots, are_equal_circles},
    {{.kind = SizeKind::arc, .shown_by = ShownBy::along, .is_anywhere = true, .is_as_written = true},
     list_arcs,
     are_equal_arcs},
    {{.kind = SizeKind::hexagon, .shown_by = ShownBy::none, .is_round = false},
     list_hexagons,
     have_equal<&PartFeatures::hexagons, are_equal_hexagons>},
    {{SizeKind::ring, ShownBy::along_or_across}, list_rings, are_equal_rings},
    {{.kind = SizeKind::side, .shown_by = ShownBy::along, .is_round = false}, list_sides, are_equal_sides},
}};

}  // namespace

bool agree(double a, double b) { return std::abs(a - b) <= size_agrees * std::max(std::abs(a), std::abs(b)); }

const KindOfSize& FeatureSize::of_kind() const {
  const KindOfSize& own = kinds[static_cast<std::size_t>(kind)].of;
  check(own.kind == kind, "kinds of sizes are in their order");
  return own;
}

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
  const std::size_t number = first(kind) + feature;
  check(number < sizes.size() && sizes[number].kind == kind && sizes[number].feature == static_cast<int>(feature),
        "a feature of this kind has one size");
  return sizes[number];
}

std::span<const FeatureSize> FeatureTable::of_kind(SizeKind kind) const {
  const auto begin = sizes.begin() + static_cast<std::ptrdiff_t>(first(kind));
  return {begin, std::find_if(begin, sizes.end(), [kind](const FeatureSize& one) { return one.kind != kind; })};
}

std::size_t FeatureTable::number_of(const features::FaceOwner& owner) const {
  const auto found = std::find_if(sizes.begin(), sizes.end(), [&owner](const FeatureSize& one) {
    return one.owner.kind == owner.kind && one.owner.number == owner.number;
  });
  check(found != sizes.end(), "an owner of faces has a size");
  return static_cast<std::size_t>(found - sizes.begin());
}

std::array<std::size_t, 2> FeatureTable::sides_of(std::size_t prism) const {
  const std::size_t number = first(SizeKind::side) + 2 * prism;
  check(number + 1 < sizes.size(), "a prism has two widths");
  return {number, number + 1};
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
  const Listed listed{features, table.prisms, notation};
  for (const KindRow& kind : kinds) {
    const auto begin = static_cast<int>(table.sizes.size());
    for (FeatureSize& size : kind.list(listed)) {
      size.equal_to = static_cast<int>(table.sizes.size());
      for (int i = begin; i < size.equal_to; ++i)
        if (const FeatureSize& other = table.sizes[static_cast<std::size_t>(i)];
            other.equal_to == i && kind.are_equal(other, size, listed))
          size.equal_to = i;
      table.sizes.push_back(std::move(size));
    }
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
