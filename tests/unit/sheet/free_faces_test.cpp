// SPDX-License-Identifier: Apache-2.0
// What the dimensions of a sheet leave free, whatever features the faces form.
#include "sheet/dimensions/free_faces.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "features/assembly_features.hpp"
#include "grooved_parts.hpp"
#include "mesh/read.hpp"
#include "sheet/dimensions/automatic.hpp"
#include "sloped_parts.hpp"
#include "turned_parts.hpp"

namespace epura::test::free_faces_test {
namespace {

world::World world_of(const std::string& obj) {
  world::World world = world::make_world({{std::make_shared<const mesh::Mesh>(mesh::read_mesh(obj, "part.obj"))}});
  for (world::Placed& placed : world.models)
    placed.part = std::make_shared<const surfaces::PartFaces>(surfaces::recognise_faces(*placed.mesh));
  return world;
}

std::vector<sheet::NamedProjection> three_views() {
  std::vector<sheet::NamedProjection> views{{"front", {}}, {"top", {}}, {"left", {}}};
  const std::array<std::array<Vec3, 2>, 3> axes{
      {{Vec3(1, 0, 0), Vec3(0, 0, 1)}, {Vec3(1, 0, 0), Vec3(0, 1, 0)}, {Vec3(0, -1, 0), Vec3(0, 0, 1)}}};
  for (std::size_t i = 0; i < 3; ++i) {
    projection::Projection& view = views[i].projection;
    view.u = axes[i][0];
    view.v = axes[i][1];
    view.n = view.projector = glm::cross(view.u, view.v);
  }
  return views;
}

/// A part, and its automatic dimensions in three views.
class Sheet {
 public:
  explicit Sheet(const std::string& obj) : world_(world_of(obj)), extents_(features::true_extents(world_)) {
    const std::vector<sheet::NamedProjection> views = three_views();
    const features::PartFeatures features = features::features_to_dimension(world_);
    scene::DimensionDescription wanted;
    wanted.type = {DimensionType::automatic, ""};
    const auto plan = sheet::automatic_dimensions(wanted, views, {world_, features, extents_}, {});
    for (const sheet::NamedProjection& view : views) {
      std::vector<scene::DimensionDescription> own;
      for (const scene::DimensionDescription& one : plan.dimensions)
        if (*one.view == view.name) own.push_back(one);
      for (const sheet::AnchoredDimension& one : sheet::find_anchors(world_, own)) texts.push_back(one.text);
      views_.push_back({view.name, view.projection, sheet::find_anchors(world_, own)});
    }
  }

  [[nodiscard]] sheet::FreeFaces free() const { return sheet::find_free_faces(views_, world_, extents_, {}); }

  /// Without one of its dimensions, counted over all views.
  [[nodiscard]] sheet::FreeFaces free_without(std::size_t number) const {
    std::vector<sheet::DimensionsInView> views = views_;
    for (sheet::DimensionsInView& view : views) {
      if (number < view.dimensions.size()) {
        view.dimensions.erase(view.dimensions.begin() + static_cast<std::ptrdiff_t>(number));
        break;
      }
      number -= view.dimensions.size();
    }
    return sheet::find_free_faces(views, world_, extents_, {});
  }

  /// With another text of one of them, and with a second one of the same if `doubled`.
  [[nodiscard]] sheet::FreeFaces with_text(std::size_t number, const std::string& text, bool doubled) const {
    std::vector<sheet::DimensionsInView> views = views_;
    for (sheet::DimensionsInView& view : views) {
      if (number < view.dimensions.size()) {
        if (doubled) view.dimensions.push_back(view.dimensions[number]);
        view.dimensions[number].text = text;
        break;
      }
      number -= view.dimensions.size();
    }
    return sheet::find_free_faces(views, world_, extents_, {});
  }

  std::vector<std::string> texts;

 private:
  world::World world_;
  std::array<features::Extent, 3> extents_;
  std::vector<sheet::DimensionsInView> views_;
};

std::string told(const sheet::FreeFaces& free) {
  std::string text;
  for (const auto& sentences : {free.sentences, free.undecided})
    for (const std::string& sentence : sentences) text += sentence + "\n";
  return text;
}

// A block of 60 x 40 x 10 whose upper edge is cut off from (50, 10) to (60, 4).
const char* const sloped_block =
    "v 0 0 0\nv 60 0 0\nv 60 0 4\nv 50 0 10\nv 0 0 10\nv 0 40 0\nv 60 40 0\nv 60 40 4\nv 50 40 10\nv 0 40 10\n"
    "f 1 2 3 4 5\nf 10 9 8 7 6\nf 1 6 7 2\nf 2 7 8 3\nf 3 8 9 4\nf 4 9 10 5\nf 5 10 6 1\n";

}  // namespace

TEST(FreeFaces, AreNoneIfAllAreHeld) {
  const Sheet sheet(sloped_block);
  ASSERT_EQ(sheet.texts.size(), 5U);
  EXPECT_TRUE(sheet.free().sentences.empty()) << sheet.free().sentences.front();
  EXPECT_EQ(sheet.free().count.given, 7);
  EXPECT_EQ(sheet.free().count.all, 7);
}

TEST(FreeFaces, AreToldForEachDimensionThatIsMissing) {
  const Sheet sheet(sloped_block);
  for (std::size_t i = 0; i < sheet.texts.size(); ++i) {
    const sheet::FreeFaces free = sheet.free_without(i);
    ASSERT_EQ(free.sentences.size(), 1U) << i;
    EXPECT_NE(free.sentences[0].find("; add a"), std::string::npos) << free.sentences[0];
    EXPECT_LT(free.count.given, free.count.all);
  }
}

TEST(FreeFaces, AreOfNoConcernToTextsThatAreUntrue) {
  const Sheet sheet(sloped_block);
  for (std::size_t i = 0; i < sheet.texts.size(); ++i) {
    const sheet::FreeFaces changed = sheet.with_text(i, "71", false);
    EXPECT_EQ(told(changed), "") << i;
    EXPECT_EQ(changed.untrue.size(), 1U) << i;
    EXPECT_TRUE(changed.contradictory.empty()) << i;
    const sheet::FreeFaces doubled = sheet.with_text(i, "71", true);
    EXPECT_EQ(doubled.untrue.size(), 1U) << i;
    ASSERT_EQ(doubled.contradictory.size(), 1U) << i;
    EXPECT_NE(doubled.contradictory[0].find("cannot all be true"), std::string::npos) << doubled.contradictory[0];
    const sheet::FreeFaces repeated = sheet.with_text(i, "<>", true);
    EXPECT_TRUE(repeated.contradictory.empty()) << i;
    EXPECT_TRUE(repeated.untrue.empty()) << i;
  }
  EXPECT_TRUE(sheet.with_text(0, "60 ±0.1", true).contradictory.empty());
  EXPECT_EQ(sheet.with_text(0, "60.5", true).contradictory.size(), 1U);
}

// Automatic dimensions define all families of parts with known sizes, one less does not. How a tube or a block as a
// whole lies in the world is no size of theirs.
TEST(FreeFaces, AreThoseOfPartsWithOneDimensionLess) {
  struct Family {
    std::vector<KnownPart> parts;
    std::size_t of_place = 0;
  };
  const std::vector<Family> families{{v_notches()},
                                     {planes_between_slopes()},
                                     {slopes_to_rounded_corners()},
                                     {rounded_trapezia()},
                                     {slopes_of_45_degrees()},
                                     {round_ends()},
                                     {tongues()},
                                     {links()},
                                     {tubes_with_radial_holes(), 1},
                                     {wedges_with_holes()},
                                     {wedges_with_pairs()},
                                     {uneven_pitch_circles()},
                                     {plates_with_conical_bosses()},
                                     {channels()},
                                     {plates_with_turned_holes()},
                                     {chamfered_hexagons()},
                                     {plates_with_dimples()},
                                     {blocks_with_grooves()},
                                     {bases_with_ribs()},
                                     {plates_with_pockets()},
                                     {bosses_over_bores()},
                                     {parted_round_tops()},
                                     {bosses_with_ring_grooves()},
                                     {blocks_with_open_slots()},
                                     {bases_with_lugs()},
                                     {shafts_with_open_keyways()},
                                     {plates_with_ring_grooves()},
                                     {turned_blocks(), 1}};
  std::size_t parts = 0;
  for (const Family& family : families)
    for (std::size_t i = 0; i < family.parts.size(); i += 4, ++parts) {
      const Sheet sheet(family.parts[i].obj);
      const std::string_view name = family.parts[i].name;
      EXPECT_EQ(told(sheet.free()), "") << name;
      EXPECT_EQ(sheet.free().count.given, sheet.free().count.all) << name;
      std::size_t of_place = 0;
      for (std::size_t k = 0; k < sheet.texts.size(); ++k) {
        const sheet::FreeFaces less = sheet.free_without(k);
        // An auxiliary dimension holds nothing.
        if (sheet.texts[k].starts_with("(")) {
          EXPECT_EQ(told(less), "") << name << " without " << sheet.texts[k];
        } else if (less.count.given == less.count.all) {
          ++of_place;
        } else {
          EXPECT_FALSE(less.sentences.empty()) << name << " without " << k << ": " << told(less);
          EXPECT_TRUE(less.undecided.empty()) << name << " without " << k << ": " << told(less);
        }
      }
      EXPECT_EQ(of_place, family.of_place) << name;
    }
  EXPECT_GE(parts, 90U);
}

}  // namespace epura::test::free_faces_test
