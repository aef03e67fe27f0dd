// SPDX-License-Identifier: Apache-2.0
// The sizes that features have, each with its place, its text and the first one that is equal to it: what automatic
// dimensions, tables of holes and `epura lint` have in common.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "features/face_owners.hpp"
#include "features/limits.hpp"
#include "sheet/notation.hpp"
#include "sizes/anchors.hpp"
#include "sizes/automatic.hpp"
#include "sizes/hexagon_chamfers.hpp"
#include "sizes/hole_directions.hpp"
#include "sizes/round_ends.hpp"
#include "sizes/turned_prisms.hpp"

namespace epura::sheet {

inline constexpr double size_agrees = 2e-4;  // relative

/// Whether two sizes are the same on a drawing.
bool agree(double a, double b);

enum class SizeKind : unsigned char { hole, cylinder, pitch_circle, cone_end, slot, arc, hexagon, ring, side };

/// Which views can give a size: of a chamfered hole, even one beside it that shows its inside; none: its own rules.
enum class ShownBy : unsigned char { along, along_or_across, along_or_inside, none };

/// What is the same of all sizes of a kind.
struct KindOfSize {
  SizeKind kind;
  ShownBy shown_by;
  bool is_anywhere = false;    ///< the note of any equal one gives it, as of fillets
  bool is_round = true;        ///< a radius; of others half of a width
  bool is_as_written = false;  ///< it is given where its number is: radii of short arcs are not accurate
};

struct FeatureSize {
  SizeKind kind;
  int feature;  ///< its number among those of this kind; of a cone_end, of its cone; of a ring, of
                ///< its torus; of a side, of its prism
  int model;
  Vec3 centre, axis;  ///< the axis is a unit vector
  double value;       ///< radius; of a hexagon, half across flats; of a side, half of the width across
  std::string name;   ///< "hole ⌀8 ↧12"
  std::string text;   ///< of a note, without the number of equal ones: "<> ↧12", where "<>" stands for the diameter
  int part = 0;       ///< which of several sizes of a feature: the end of a cone, the width of a prism
  int equal_to = -1;  ///< number of the first size that the same note can give
  features::FaceOwner owner{};        ///< of the faces that it gives, with its place; none for others
  std::vector<double> other_radii{};  ///< that the same note gives, about the same axis
  std::optional<Vec3> label_at{};     ///< where a table may label it
  bool needs_text = false;            ///< whether a note has to say more than its diameter

  [[nodiscard]] const KindOfSize& of_kind() const;
  [[nodiscard]] bool is_anywhere() const { return of_kind().is_anywhere; }
  [[nodiscard]] bool is_round() const { return of_kind().is_round; }
  /// Whether it is that of a circle of this size and direction, or also of this place.
  [[nodiscard]] bool is_equal(const WorldCircle& circle) const;
  [[nodiscard]] bool is_at(const WorldCircle& circle) const;
  [[nodiscard]] WorldCircle circle() const { return {centre, axis, value, {}, true}; }
};

struct FeatureTable {
  std::vector<FeatureSize> sizes{};  ///< by kind and feature; of a prism, two
  FlatEnds flat_ends{};
  std::vector<RoundEnd> round_ends{};
  std::vector<RoundEnd> channels{};
  std::vector<int> balls{};  ///< numbers of spheres, as of find_placed_balls
  std::vector<TurnedPrism> prisms{};
  std::optional<features::TurnedPart> turned{};
  std::vector<HexagonChamfer> hexagon_chamfers{};
  std::vector<RadialPattern> radial{};

  /// The number of the first size of a kind; those of holes, cylinders, pitch circles, slots, arcs, hexagons are in
  /// the order of the features.
  [[nodiscard]] std::size_t first(SizeKind kind) const;
  [[nodiscard]] const FeatureSize& size_of(SizeKind kind, std::size_t feature) const;
  /// That of the size of an owner of faces, which has one.
  [[nodiscard]] std::size_t number_of(const features::FaceOwner& owner) const;
  /// All of a kind.
  [[nodiscard]] std::span<const FeatureSize> of_kind(SizeKind kind) const;
  /// The numbers of both widths of a prism.
  [[nodiscard]] std::array<std::size_t, 2> sides_of(std::size_t prism) const;
  /// Whether features about an axis have their places in the own axes of a turned part; and these.
  [[nodiscard]] bool is_turned(const Vec3& axis) const;
  [[nodiscard]] OwnDirections own_directions(const Vec3& axis) const;
  /// Whether a turned part has its own axes instead of one of the world.
  [[nodiscard]] bool turns(int world) const { return turned && std::abs(turned->axis[world]) <= features::parallel; }
  /// Whether one angle is that of two prisms: in a turned part, of all along its axes.
  [[nodiscard]] bool share_angle(const TurnedPrism& a, const TurnedPrism& b) const;
  /// Whether a hole is in a radial pattern.
  [[nodiscard]] bool is_radial(const features::HoleFeature& hole) const;
};

/// "bore ⌀12"
std::string name_of(const features::CylinderFeature& cylinder, const Notation& notation);

/// Of all features. It refers to them.
FeatureTable feature_table(const DimensionSubject& subject, const Notation& notation);

/// Features that one note can describe, in the order of their first members; `features` are all of the kind.
template <class Feature>
std::vector<std::vector<const Feature*>> equal_features(const FeatureTable& table, SizeKind kind,
                                                        const std::vector<Feature>& features) {
  std::vector<std::vector<const Feature*>> groups;
  std::vector<std::pair<int, std::size_t>> numbers;  // of the first size, and of its group
  for (std::size_t i = 0; i < features.size(); ++i) {
    const int first = table.size_of(kind, i).equal_to;
    std::size_t group = groups.size();
    for (const auto& [size, number] : numbers)
      if (size == first) group = number;
    if (group == groups.size()) {
      groups.emplace_back();
      numbers.emplace_back(first, group);
    }
    groups[group].push_back(&features[i]);
  }
  return groups;
}

}  // namespace epura::sheet
