// SPDX-License-Identifier: Apache-2.0
#include "sizes/coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/joined.hpp"
#include "base/text.hpp"
#include "features/assembly_features.hpp"
#include "features/tolerances.hpp"
#include "sizes/coordinates.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/face_coverage.hpp"
#include "sizes/feature_places.hpp"
#include "sizes/own_frame.hpp"
#include "sizes/place_chain.hpp"
#include "sizes/place_joins.hpp"
#include "sizes/sizes_on_sheet.hpp"
#include "sizes/slope_dimensions.hpp"
#include "sizes/turned_coverage.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

namespace {

struct Remedy {
  std::string sentence;  ///< goes on with ", "
  std::string view;      ///< as in --projection
};

bool is_seen_along(const Vec3& axis, std::span<const DimensionsInView> views) {
  return std::any_of(views.begin(), views.end(), [&](const DimensionsInView& view) {
    return is_orthographic(view.projection) && !view.turned_about && features::are_parallel(view.projection.n, axis);
  });
}

bool is_seen_beside(const Vec3& axis, bool inside, std::span<const DimensionsInView> views) {
  return std::any_of(views.begin(), views.end(), [&](const DimensionsInView& view) {
    if (inside && !view.shows_inside) return false;
    if (view.turned_about) return features::are_parallel(*view.turned_about, axis);
    return is_orthographic(view.projection) && std::abs(glm::dot(view.projection.n, axis)) <= features::parallel;
  });
}

std::string view_along(const Vec3& axis) {
  constexpr std::array views{"left", "front", "top"};
  if (const int along = world_axis(axis); along >= 0) return views[std::size_t(along)];
  const double largest = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
  check(largest > 0, "an axis has a direction");
  std::string name = "auxiliary:direction=";
  for (int i = 0; i < 3; ++i) {
    const double part = axis[i] / largest;
    name += (i > 0 ? "," : "") + format_rounded(std::abs(part) <= features::same_point ? 0 : part, 6);
  }
  return name;
}

/// What to say of a circle or arc around an axis along which no view looks.
Remedy remedy_along(const Vec3& axis) {
  const std::string view = view_along(axis);
  return {", which no view shows in its true form", view};
}

/// The same for a rounded edge around an axis, whose section may be seen in a view that is not there.
Remedy remedy_beside(const Vec3& axis, std::span<const DimensionsInView> views) {
  for (const int normal : {1, 0, 2})
    if (const Vec3 n = Mat3(1)[normal]; std::abs(glm::dot(n, axis)) <= features::parallel && !is_seen_along(n, views))
      return {", whose section no view shows", view_along(n)};
  return {};
}

constexpr double place_agrees = 2e-5;  // relative to the size of the models

using Sentences = std::vector<std::string>;

/// What is said of sizes that no dimension gives, and of what shows them.
struct Missing {
  bool with_views = true;  ///< whether a view helps
  Sentences sentences{};
  std::vector<std::string> views{};

  void add(const std::string& name, const Remedy& remedy) {
    const bool with_view = with_views && !remedy.view.empty();
    sentences.push_back(name + remedy.sentence + (with_view ? ": add the view " + remedy.view : ""));
    if (with_view) views.push_back(remedy.view);
  }
};

/// The dimensions, and what they have to give.
struct Dimensioned {
  std::span<const DimensionsInView> views;
  const DimensionSubject& subject;
  const Notation& notation;
  FeatureTable table;
  SizesOnSheet on_sheet;
  std::vector<bool> given;  ///< of each size in the table
  std::string transform;    ///< as of Coverage
};

/// Places along each axis that dimensions join to the ends of the models.
struct JoinedPlaces {
  std::array<std::vector<double>, 3> at{};
  double slack;
  Sentences open{}, repeated{};

  [[nodiscard]] bool has(int axis, double place) const {
    const std::vector<double>& along = at[static_cast<std::size_t>(axis)];
    return std::any_of(along.begin(), along.end(), [&](double one) { return std::abs(one - place) <= slack; });
  }
};

std::vector<PlaceJoin> all_joins(const Dimensioned& sheet) {
  std::vector<PlaceJoin> joins;
  for (const DimensionsInView& view : sheet.views)
    for (const AnchoredDimension& dimension : view.dimensions)
      joins = joined(std::move(joins), joins_of(dimension, view, sheet.subject, sheet.table, sheet.notation));
  return joined(std::move(joins), joins_of_round_ends(sheet.on_sheet.radii, sheet.subject, sheet.table));
}

JoinedPlaces join_places(const Dimensioned& sheet) {
  const DimensionSubject& subject = sheet.subject;
  JoinedPlaces found{.slack = place_agrees * glm::length(subject.world.box.size())};
  const std::vector<FeaturePlace> places = places_of_features(subject, sheet.table, sheet.notation);
  std::vector<PlaceChain> chains;
  for (int axis = 0; axis < 3; ++axis)
    chains.emplace_back(axis, subject.extents[std::size_t(axis)], places, found.slack);
  // The sizes of a turned part along the axes of the world follow.
  for (int axis = 0; axis < 3; ++axis)
    if (const features::Extent& extent = subject.extents[std::size_t(axis)]; sheet.table.turns(axis))
      chains[std::size_t(axis)].join({axis, extent.from, extent.to, 0});
  for (const PlaceJoin& join : all_joins(sheet)) {
    check(join.axis >= 0 && join.axis < 3, "places are joined along an axis of the world");
    if (!chains[std::size_t(join.axis)].join(join) && !join.name.empty()) found.repeated.push_back(join.name);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    found.at[axis] = chains[axis].joined();
    found.open = joined(std::move(found.open), chains[axis].open(sheet.notation));
  }
  return found;
}

// Towards the side of the models on which it is: from there, nothing larger hides it.
Vec3 outward_axis(const FeatureSize& size, const Box& box) {
  return glm::dot(size.centre - box.centre(), size.axis) < 0 ? -size.axis : size.axis;
}

// Diameters can be given in views beside their axis, too.
Remedy remedy_for_size(const FeatureSize& size, const Dimensioned& sheet) {
  const ShownBy by = size.of_kind().shown_by;
  if (by == ShownBy::none) return {};
  const Vec3 axis = outward_axis(size, sheet.subject.world.box);
  if (is_seen_along(axis, sheet.views)) return {};
  const bool is_seen = by != ShownBy::along && is_seen_beside(axis, by == ShownBy::along_or_inside, sheet.views);
  return is_seen ? Remedy{} : remedy_along(axis);
}

Missing missing_sizes(const Dimensioned& sheet) {
  Missing missing{.with_views = sheet.transform.empty()};
  for (std::size_t i = 0; i < sheet.given.size(); ++i)
    if (const FeatureSize& size = sheet.table.sizes[i]; !sheet.given[i])
      missing.add(size.name, remedy_for_size(size, sheet));
  return missing;
}

Sentences repeated_sizes(const Dimensioned& sheet) {
  Sentences repeated;
  std::map<int, int> most;  // of each list of equal ones
  for (std::size_t i = 0; i < sheet.table.sizes.size(); ++i) {
    const FeatureSize& size = sheet.table.sizes[i];
    const auto [of_list, is_first] = most.try_emplace(size.equal_to, 0);
    if (is_first) of_list->second = max_dimensions(size, sheet.table);
    check(sheet.on_sheet.dimensions[i] >= 0 && of_list->second > 0, "a size is of one place or more");
    if (sheet.on_sheet.dimensions[i] > of_list->second) repeated.push_back(size.name);
  }
  return repeated;
}

// Whether an overall dimension is the diameter of a ball of this size.
bool is_overall_sphere(const surfaces::PartSurface& sphere, const DimensionSubject& subject) {
  return std::any_of(subject.extents.begin(), subject.extents.end(), [&](const features::Extent& extent) {
    return extent.form == features::ExtentForm::sphere && agree(extent.size(), 2 * sphere.radius);
  });
}

bool has_doubly_curved(const surfaces::PartFace& face, const Dimensioned& sheet) {
  const bool sphere = face.surface.kind == surfaces::SurfaceKind::sphere;
  const double radius = sphere ? face.surface.radius : face.surface.minor;
  check(radius > 0, "a sphere or torus has a radius");
  const auto is_it = [&](double r) {
    return agree(r, radius) || are_written_alike(r, radius, sheet.notation) ||
           std::abs(r - radius) <= features::radius_doubt(face);
  };
  const std::vector<double>& radii = sheet.on_sheet.radii;
  return std::any_of(radii.begin(), radii.end(), is_it) || (sphere && is_overall_sphere(face.surface, sheet.subject));
}

// Parts of a fillet around a corner belong to it: a dimension of its radius gives theirs.
Missing missing_doubly_curved(const world::PlacedPart& part, const Dimensioned& sheet) {
  const auto length = [&](double value) { return length_text(value, sheet.notation); };
  Missing missing{.with_views = sheet.transform.empty()};
  std::vector<surfaces::PartSurface> seen;
  for (std::size_t number = 0; number < part.faces.size(); ++number) {
    if (number < sheet.on_sheet.held.size() && sheet.on_sheet.held[number] != 0) continue;
    const surfaces::PartFace& face = part.faces[number];
    const surfaces::PartSurface& surface = face.surface;
    const bool sphere = surface.kind == surfaces::SurfaceKind::sphere;
    if (!sphere && surface.kind != surfaces::SurfaceKind::torus) continue;
    const auto same = [&](const surfaces::PartSurface& other) { return surfaces::are_one(other, surface); };
    if (has_doubly_curved(face, sheet) || std::any_of(seen.begin(), seen.end(), same)) continue;
    seen.push_back(surface);
    if (sphere)
      missing.add("sphere SR" + length(surface.radius), {});
    else
      missing.add("torus R" + length(surface.minor) + " around ⌀" + length(2 * surface.radius),
                  remedy_beside(surface.axis, sheet.views));
  }
  return missing;
}

// Spheres and tori, and models whose faces are others than those of their files.
Missing missing_in_models(const Dimensioned& sheet) {
  Missing missing;
  const world::World& world = sheet.subject.world;
  for (std::size_t model = 0; model < world.models.size(); ++model) {
    if (world.models[model].part == nullptr) continue;
    const auto part = world::place_part(world.models[model]);
    if (!part) {
      missing.add("model " + std::to_string(model) + ": it is scaled unequally, so only overall sizes are checked", {});
      continue;
    }
    const Missing of_model = missing_doubly_curved(*part, sheet);
    missing.sentences = joined(std::move(missing.sentences), of_model.sentences);
    missing.views = joined(std::move(missing.views), of_model.views);
  }
  return missing;
}

// Of a slope or a prism, by a dimension of its own, by "2×" at one that is equal to it, or by one that `shares` it.
template <class Feature>
bool has_angle_in(std::span<const DimensionsInView> views, const Feature& feature, const std::vector<Feature>& all,
                  const std::function<bool(const Feature& other)>& shares = {}) {
  return any_dimension(views, [&](const AnchoredDimension& one) {
    return std::any_of(all.begin(), all.end(), [&](const Feature& other) {
      const bool is_of_both =
          &other == &feature || (repeats_of(one.text) > 1 && are_equal(other, feature)) || (shares && shares(other));
      return is_of_both && is_angle_of(one, other);
    });
  });
}

bool has_angle_of_prism(const Dimensioned& sheet, const TurnedPrism& prism) {
  return has_angle_in<TurnedPrism>(sheet.views, prism, sheet.table.prisms,
                                   [&](const TurnedPrism& other) { return sheet.table.share_angle(other, prism); });
}

// Of each slope: by its angle, or by the places of its ends.
std::vector<bool> slopes_given(const Dimensioned& sheet, const JoinedPlaces& places) {
  const std::vector<features::BevelFeature>& bevels = sheet.subject.features.bevels;
  std::vector<bool> given;
  for (const features::BevelFeature& bevel : bevels) {
    bool is_known = !has_angle(bevel, sheet.subject) || has_angle_in(sheet.views, bevel, bevels);
    for (int axis = 0; axis < 3 && !has_angle(bevel, sheet.subject); ++axis)
      for (const Vec3& end : bevel.ends) is_known = is_known && (axis == bevel.along || places.has(axis, end[axis]));
    given.push_back(is_known);
  }
  return given;
}

Sentences missing_angles(const Dimensioned& sheet) {
  const std::vector<features::BevelFeature>& bevels = sheet.subject.features.bevels;
  Sentences missing;
  for (const features::BevelFeature& bevel : bevels)
    if (has_angle(bevel, sheet.subject) && !has_angle_in(sheet.views, bevel, bevels))
      missing.push_back("slope of " + format_rounded(bevel.area, 4) + " mm²: angle");
  for (const TurnedPrism& prism : sheet.table.prisms)
    if (!has_angle_of_prism(sheet, prism))
      missing.push_back(std::string("turned ") + (prism.inwards ? "hole" : "boss") + ": angle");
  return missing;
}

// Positions of holes are asked for along the axes of the world across theirs; those of a turned part, by cover_turned.
bool is_placed(const features::HoleFeature& hole, const FeatureTable& table, const JoinedPlaces& places) {
  if (table.is_turned(hole.axis)) return true;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(hole.axis[axis]) <= features::parallel && !places.has(axis, hole.mouth[axis])) return false;
  return true;
}

bool has_size(const Dimensioned& sheet, std::size_t number) {
  const FeatureSize& size = sheet.table.sizes[number];
  return sheet.given[number] || (size.label_at && is_labelled(*size.label_at, sheet.on_sheet));
}

std::vector<SizedCircle> sized_circles(const Dimensioned& sheet) {
  std::vector<SizedCircle> circles;
  for (std::size_t i = 0; i < sheet.table.sizes.size(); ++i) {
    const FeatureSize& size = sheet.table.sizes[i];
    if (!size.is_round()) continue;
    const bool is_given = has_size(sheet, i);
    circles.push_back({size.centre, size.axis, size.value, is_given});
    for (const double radius : size.other_radii) circles.push_back({size.centre, size.axis, radius, is_given});
  }
  return circles;
}

// By owner of faces.
GivenOwners given_owners(const Dimensioned& sheet) {
  GivenOwners given;
  for (std::size_t i = 0; i < sheet.table.sizes.size(); ++i)
    if (const features::FaceOwner& owner = sheet.table.sizes[i].owner; owner.kind != features::OwnerKind::none)
      given[{owner.kind, owner.number}] = has_size(sheet, i);
  return given;
}

std::vector<KnownPrism> known_prisms(const Dimensioned& sheet) {
  std::vector<KnownPrism> prisms;
  for (std::size_t i = 0; i < sheet.table.prisms.size(); ++i) {
    const TurnedPrism& prism = sheet.table.prisms[i];
    const std::array<std::size_t, 2> sides = sheet.table.sides_of(i);
    prisms.push_back({prism, sheet.given[sides[0]] && sheet.given[sides[1]] && has_angle_of_prism(sheet, prism)});
  }
  return prisms;
}

FaceCoverage cover_all_faces(const Dimensioned& sheet, const JoinedPlaces& places) {
  GivenSizes given{[&places](int axis, double at) { return places.has(axis, at); },
                   [&sheet](const surfaces::PartFace& face) { return has_doubly_curved(face, sheet); }};
  given.circles = sized_circles(sheet);
  given.held = sheet.on_sheet.held;
  given.owners = given_owners(sheet);
  check(given.owners.size() >= sheet.subject.features.holes.size(), "each hole has a size");
  given.bevels = slopes_given(sheet, places);
  given.prisms = known_prisms(sheet);
  given.hexagon_chamfers = sheet.table.hexagon_chamfers;
  given.radii = sheet.on_sheet.radii;
  for (const SizedCircle& circle : given.circles)
    if (circle.is_given) given.radii.push_back(circle.radius);
  // Diameters of what is no feature: the ends of a conical bore.
  for (const DimensionsInView& view : sheet.views)
    for (const AnchoredDimension& dimension : view.dimensions)
      if (dimension.type == DimensionType::diameter && !is_auxiliary(dimension))
        for (const WorldCircle& circle : dimension.circles)
          given.circles.push_back({circle.centre, circle.axis, circle.radius, true});
  return cover_faces(sheet.subject, sheet.table.round_ends, given, sheet.notation);
}

// Holes with a size and a place.
report::SizeCount count_holes(const Dimensioned& sheet, const JoinedPlaces& places,
                              const std::vector<bool>& are_turned_known) {
  const std::vector<features::HoleFeature>& holes = sheet.subject.features.holes;
  const GivenOwners given = given_owners(sheet);
  check(are_turned_known.size() == holes.size(), "each hole has a place or none");
  int placed = 0;
  for (std::size_t i = 0; i < holes.size(); ++i)
    if (given.at({features::OwnerKind::hole, static_cast<int>(i)}) && are_turned_known[i] &&
        is_placed(holes[i], sheet.table, places))
      ++placed;
  return {"holes", placed, static_cast<int>(holes.size())};
}

// Where the parts of an assembly are, along each axis.
report::SizeCount count_places(const Dimensioned& sheet, const JoinedPlaces& places) {
  const features::PartFeatures& features = sheet.subject.features;
  const auto placed =
      std::count_if(features.levels.begin(), features.levels.end(),
                    [&](const features::LevelFeature& level) { return places.has(level.axis, level.at); });
  const std::size_t all = std::accumulate(features.unplaced.begin(), features.unplaced.end(), features.levels.size());
  check(placed <= static_cast<std::ptrdiff_t>(all), "each place is given once");
  return {"places of parts", static_cast<int>(placed), static_cast<int>(all)};
}

// Equal ones once, with their number.
Sentences merged(const Sentences& sentences) {
  std::vector<std::pair<std::string, int>> counted;
  for (const std::string& sentence : sentences) {
    const auto same = std::find_if(counted.begin(), counted.end(), [&](const auto& c) { return c.first == sentence; });
    if (same == counted.end())
      counted.emplace_back(sentence, 1);
    else
      ++same->second;
  }
  Sentences once;
  for (const auto& [sentence, count] : counted)
    once.push_back((count > 1 ? std::to_string(count) + "× " : "") + sentence);
  return once;
}

// Each once, in the order of the first ones.
std::vector<std::string> distinct(const std::vector<std::string>& names) {
  std::vector<std::string> once;
  for (const std::string& name : names)
    if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
  return once;
}

}  // namespace

Coverage find_coverage(std::span<const DimensionsInView> views, const DimensionSubject& subject,
                       const Notation& notation, std::span<const char> held) {
  Dimensioned sheet{views, subject, notation, feature_table(subject, notation), {}, {}, {}};
  if (const auto turn = turn_to_own_frame(subject.world)) sheet.transform = words_of_turn(*turn);
  sheet.on_sheet = sizes_on_sheet(views, subject, sheet.table);
  check(held.empty() || subject.world.models.size() == 1, "faces are held of a single model");
  sheet.on_sheet.held = held;
  sheet.given = given_sizes(sheet.on_sheet, subject, sheet.table, notation);
  check(sheet.given.size() == sheet.table.sizes.size(), "each size is given or missing");
  const JoinedPlaces places = join_places(sheet);
  const Missing sizes = missing_sizes(sheet), of_models = missing_in_models(sheet);
  const TurnedCoverage turned = cover_turned(views, subject, sheet.table, sheet.on_sheet, notation);
  FaceCoverage faces = cover_all_faces(sheet, places);
  Sentences missing = places.open;
  for (const Sentences& more :
       {sizes.sentences, of_models.sentences, turned.missing, missing_angles(sheet), faces.unaccounted})
    missing = joined(std::move(missing), more);
  Coverage coverage{
      std::move(faces.counts), merged(missing), merged(joined(places.repeated, repeated_sizes(sheet))), {}};
  if (!features::has_too_many_parts(subject.features))
    coverage.views_to_add = distinct(joined(sizes.views, of_models.views));
  if (!coverage.undimensioned.empty()) coverage.transform_to_add = sheet.transform;
  if (subject.features.of_assembly) coverage.counts.push_back(count_places(sheet, places));
  if (!subject.features.holes.empty()) coverage.counts.push_back(count_holes(sheet, places, turned.holes));
  return coverage;
}

}  // namespace epura::sheet
