// SPDX-License-Identifier: Apache-2.0
// The parts of a scene in C++ have all that scene files have, and mean the same.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <epura/epura.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace epura::test::scene_options_test {
namespace {

const std::string bracket = EPURA_TEST_SAMPLES "/models/bracket.obj";

Settings settings() { return {.plugin_path = {EPURA_TEST_PLUGINS}, .allow_outside = true}; }

using Keys = std::set<std::string>;

/// The keys of the options of a part in C++.
template <class Part>
Keys keys_of() {
  Keys keys;
  const Part part{};
  each_option(part, [&keys](const char* key, const char*, const auto&) { keys.insert(key); });
  return keys;
}

/// The keys by section of scene files, as C++ has them.
std::map<std::string, Keys> keys_in_cpp() {
  std::map<std::string, Keys> keys;
  const Scene scene;
  each_option(scene, [&keys](const char* section, const char*, const auto& parts) {
    using Parts = std::decay_t<decltype(parts)>;
    if constexpr (!std::is_same_v<Parts, TitleBlock>) keys[section] = keys_of<typename Parts::value_type>();
  });
  return keys;
}

/// The text between the first two backticks from a position on, which is moved behind them; empty if there are none.
std::string quoted(const std::string& line, std::size_t& at) {
  const std::size_t begin = line.find('`', at), end = line.find('`', begin + 1);
  if (begin == std::string::npos || end == std::string::npos) return {};
  at = end + 1;
  return line.substr(begin + 1, end - begin - 1);
}

// docs/scenes.md has a row for each option, which another test compares with the tables.
TEST(SceneOptions, AllOfSceneFilesAreInCpp) {
  const std::map<std::string, Keys> known = keys_in_cpp();
  std::ifstream page(EPURA_TEST_SAMPLES "/../docs/scenes.md");
  int rows = 0;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| `[")) continue;
    const std::size_t second = line.find('|', 1);
    std::size_t at = 0;
    std::vector<std::string> sections;
    for (std::string one = quoted(line, at); at < second; one = quoted(line, at)) sections.push_back(one);
    at = second;
    const std::string key = quoted(line, at);
    for (std::string section : sections) {
      std::erase_if(section, [](char c) { return c == '[' || c == ']'; });
      if (section == "title_block") continue;  // whatever fields it has: a list of names and texts
      ++rows;
      ASSERT_TRUE(known.contains(section)) << section;
      EXPECT_TRUE(known.at(section).contains(key)) << section << "." << key;
    }
  }
  EXPECT_GT(rows, 130);
}

const double nan = std::nan("");

// Values that no option of their type can have. There are none of true and false.
bool spoil(std::optional<bool>&) { return false; }
bool spoil(std::string& text) { return !(text = "a\tb").empty(); }
bool spoil(std::optional<double>& number) { return (number = nan).has_value(); }
bool spoil(std::optional<int>& number) { return (number = -1).has_value(); }
bool spoil(std::optional<EdgeKinds>& kinds) {
  return (kinds = EdgeKinds{false, false, false, false, false, false, false}).has_value();
}
bool spoil(std::optional<Transform>& transform) { return (transform = "turn:z").has_value(); }
bool spoil(std::optional<Scale>& scale) { return (scale = nan).has_value(); }
bool spoil(std::optional<PaperSize>& size) { return (size = std::array{nan, 1.0}).has_value(); }
bool spoil(std::optional<DimensionAnchor>& anchor) { return (anchor = std::array{-1, 0}).has_value(); }
bool spoil(std::optional<LeaderTarget>& target) { return (target = std::array{nan, 0.0}).has_value(); }
bool spoil(std::vector<Break>& breaks) { return !(breaks = {{.axis = 3}}).empty(); }
bool spoil(std::vector<std::string>& texts) { return !(texts = {"a\tb"}).empty(); }
bool spoil(std::vector<std::vector<std::string>>& rows) { return !(rows = {{"a\tb"}}).empty(); }
bool spoil(std::vector<std::array<double, 3>>& points) { return !(points = {{nan, 0, 0}}).empty(); }
bool spoil(std::vector<DimensionAnchor>& anchors) { return !(anchors = {std::array{-1, 0}}).empty(); }
bool spoil(std::vector<ToleranceFrame>& frames) { return !(frames = {{}}).empty(); }
bool spoil(TitleBlock& fields) { return !(fields = {{"title", "a\tb"}}).empty(); }
template <std::size_t count>
bool spoil(std::optional<std::array<double, count>>& numbers) {
  return (numbers = std::array<double, count>{nan}).has_value();
}
template <class Enum>
requires std::is_enum_v<Enum>
bool spoil(std::optional<Enum>& choice) { return (choice = static_cast<Enum>(99)).has_value(); }

std::string place_of_failure(const Scene& scene) {
  try {
    static_cast<void>(draw(scene, settings()));
  } catch (const Failure& failure) {
    return failure.place();
  }
  return "no failure";
}

/// A scene with parts of all kinds that have what they require.
Scene all_kinds() {
  return {.models = {{.file = bracket}},
          .styles = {{.match = "*"}},
          .views = {{.projection = "front"}},
          .sections = {{.name = "A"}},
          .details = {{.name = "X", .centre = {{0, 0, 0}}, .radius = 1}},
          .broken_outs = {{.point = {{0, 0, 0}}, .radius = 1}},
          .revolved = {{.point = {{0, 0, 0}}, .normal = {{0, 0, 1}}}},
          .explosions = {{.factor = 1}},
          .dimensions = {{.type = DimensionType::overall}},
          .threads = {{.thread = "M6", .at = std::array{0, 0}}},
          .notes = {{.text = {"text"}}},
          .tolerance_frames = {{.characteristic = Characteristic::flatness, .zone = "0.1"}},
          .datums = {{.letter = "A"}},
          .surface_textures = {{.text = {"Ra 3.2"}}},
          .requirements = {{.type = "diameter", .feature = "hole 1"}},
          .accepted = {{.feature = "face 1", .reason = "as cast"}},
          .tables = {{.rows = {{"text"}}}},
          .revisions = {{.revision = "A", .text = "text"}},
          .parts_list = PartsList{},
          .all_sheets = SheetOptions{},
          .sheets = {{}}};
}

template <class Part>
Part& first(std::vector<Part>& parts) {
  return parts.front();
}
template <class Part>
Part& first(std::optional<Part>& part) {
  return *part;
}

// Spoils one option after the other, and expects that the error names its member.
TEST(SceneOptions, AreReadAtTheirPlace) {
  const Scene usual = all_kinds();
  int spoiled = 0;
  each_option(usual, [&](const char* section, const char* list, const auto& usual_parts) {
    using Parts = std::decay_t<decltype(usual_parts)>;
    if constexpr (!std::is_same_v<Parts, TitleBlock>) {
      constexpr bool is_list = std::is_same_v<Parts, std::vector<typename Parts::value_type>>;
      const std::size_t count = keys_of<typename Parts::value_type>().size();
      for (std::size_t chosen = 0; chosen < count; ++chosen) {
        Scene scene = usual;
        std::string place;
        each_option(scene, [&](const std::string& other, const char*, auto& parts) {
          if constexpr (std::is_same_v<std::decay_t<decltype(parts)>, Parts>) {
            if (other != section) return;
            std::size_t number = 0;
            each_option(first(parts), [&](const char*, const char* member, auto& value) {
              if (number++ == chosen && spoil(value)) place = std::string(list) + (is_list ? "[0]." : ".") + member;
            });
          }
        });
        if (place.empty()) continue;
        ++spoiled;
        const std::string found = place_of_failure(scene);
        EXPECT_TRUE(found.starts_with(place)) << found << " instead of " << place;
      }
    }
  });
  EXPECT_GT(spoiled, 120);
}

/// Something that scenes have, as it is written in both ways.
struct Case {
  std::string name;
  void (*add)(Scene&);
  std::string words;
};

/// A scene with two views of a bracket.
Scene two_views() {
  return {.models = {{.file = bracket, .name = "bracket"}},
          .views = {{.projection = "front", .name = "f"}, {.projection = "top", .name = "t"}},
          .sheets = {{.size = "A3", .frame = FrameKind::full}}};
}

const std::string two_views_in_words = "[[model]]\nfile = '" + bracket +
                                       "'\nname = 'bracket'\n[[view]]\nprojection = 'front'\nname = 'f'\n"
                                       "[[view]]\nprojection = 'top'\nname = 't'\n"
                                       "[[sheet]]\nsize = 'A3'\nframe = 'full'\n";

const std::vector<Case> symbols{
    {"note",
     [](Scene& scene) {
       scene.notes = {{.text = {"DEBURR", "ALL EDGES"}},
                      {.text = {"here"}, .to = std::array{0, 3}, .end = LeaderEnd::dot, .view = "t"},
                      {.text = {"there"}, .to = std::array{215.0, 184.0}, .at = {{300, 220}}}};
     },
     "[[note]]\ntext = ['DEBURR', 'ALL EDGES']\n[[note]]\ntext = 'here'\nto = [0, 3]\nend = 'dot'\nview = 't'\n"
     "[[note]]\ntext = 'there'\nto = {page = [215, 184]}\nat = [300, 220]\n"},
    {"tolerance frame and datum",
     [](Scene& scene) {
       scene.datums = {{.letter = "A", .to = std::array{0, 0}}};
       scene.tolerance_frames = {{.characteristic = Characteristic::position,
                                  .zone = "Ø0.1 M",
                                  .datums = "A",
                                  .text = "4×",
                                  .also = {{.characteristic = Characteristic::flatness, .zone = "0.05"}},
                                  .to = std::array{0.0, 0.0, 0.0}}};
     },
     "[[tolerance_frame]]\ncharacteristic = 'position'\nzone = 'Ø0.1 M'\ndatums = ['A']\ntext = '4×'\n"
     "also = [{characteristic = 'flatness', zone = '0.05'}]\nto = {point = [0, 0, 0]}\n"
     "[[datum]]\nletter = 'A'\nto = [0, 0]\n"},
    {"surface texture",
     [](Scene& scene) {
       scene.surface_textures = {
           {.text = {"Ra 3.2"}, .removal = MaterialRemoval::required, .process = "ground", .to = std::array{0, 0}},
           {.text = {"Ra 6.3"}}};
     },
     "[[surface_texture]]\ntext = 'Ra 3.2'\nremoval = 'required'\nprocess = 'ground'\nto = [0, 0]\n"
     "[[surface_texture]]\ntext = 'Ra 6.3'\n"},
};

const std::vector<Case> further{
    {"table",
     [](Scene& scene) {
       scene.tables = {{.title = "Holes",
                        .header = {"no", "size"},
                        .rows = {{"1", "6.6"}, {"2", ""}},
                        .corner = SheetCorner::top_left}};
     },
     "[[table]]\ntitle = 'Holes'\nheader = ['no', 'size']\nrows = [[1, 6.6], ['2', '']]\ncorner = 'top-left'\n"},
    {"revision",
     [](Scene& scene) {
       scene.revisions = {{.revision = "B", .text = "Hole moved", .date = "2026-11-28", .author = "E. P."}};
     },
     "[[revision]]\nrevision = 'B'\ntext = 'Hole moved'\ndate = 2026-11-28\nauthor = 'E. P.'\n"},
    {"parts list, material and density",
     [](Scene& scene) {
       scene.models[0].density = 2700;
       scene.styles = {{.match = "nothing*", .material = "steel", .density = 7850}};
       scene.parts_list = PartsList{.view = "f"};
     },
     "[[style]]\nmatch = 'nothing*'\nmaterial = 'steel'\ndensity = 7850\n[parts_list]\nview = 'f'\n"},
    {"broken-out section",
     [](Scene& scene) {
       scene.broken_outs = {{.view = "f", .point = {{20, 10, 5}}, .radius = 15}};
     },
     "[[broken_out]]\nview = 'f'\npoint = [20, 10, 5]\nradius = 15\n"},
    {"arrow view",
     [](Scene& scene) {
       scene.views.push_back({.name = "side", .from = {{1, 0, 0}}, .of = "f", .label = "C"});
     },
     "[[view]]\nname = 'side'\nfrom = [1, 0, 0]\nof = 'f'\nlabel = 'C'\n"},
    {"centre of gravity and decimals",
     [](Scene& scene) {
       scene.views[1].centre_of_gravity = true;
       scene.dimensions = {{.type = DimensionType::overall}};
       scene.sheets[0].decimals = 0;
     },
     "[[dimension]]\ntype = 'overall'\n"},
    {"fields of all sheets",
     [](Scene& scene) {
       scene.title_block = {{"title", "Bracket"}, {"machine", "M-7"}};
       scene.all_sheets = SheetOptions{.decimal_sign = DecimalSign::comma};
     },
     "[title_block]\ntitle = 'Bracket'\nfree = {machine = 'M-7'}\n[all_sheets]\ndecimal_sign = ','\n"},
};

/// Draws a scene file with the words.
std::string drawn_from(const std::string& words) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("epura-options-" + std::to_string(::getpid()) + ".toml");
  std::ofstream(file) << words;
  const std::string svg = to_svg(draw_file(file, settings()));
  std::filesystem::remove(file);
  return svg;
}

// Options of what `two_views_in_words` begins with stand in its own sections.
std::string with_options(const Case& one) {
  std::string words = two_views_in_words + one.words;
  const auto insert = [&words](const std::string& after, const std::string& text) {
    words.insert(words.find(after) + after.size(), text);
  };
  if (one.name.starts_with("parts list")) insert("name = 'bracket'\n", "density = 2700\n");
  if (one.name.starts_with("centre of gravity")) {
    insert("name = 't'\n", "centre_of_gravity = true\n");
    insert("frame = 'full'\n", "decimals = 0\n");
  }
  return words;
}

TEST(SceneOptions, DrawWhatSceneFilesDraw) {
  const std::string plain = to_svg(draw(two_views(), settings()));
  EXPECT_EQ(plain == drawn_from(two_views_in_words), true);
  for (const std::vector<Case>& cases : {symbols, further})
    for (const Case& one : cases) {
      SCOPED_TRACE(one.name);
      Scene scene = two_views();
      one.add(scene);
      const std::string drawn = to_svg(draw(scene, settings()));
      EXPECT_EQ(drawn == drawn_from(with_options(one)), true);
      EXPECT_EQ(drawn == plain, false);
    }
}

std::set<std::string> layers_of(const Drawing& drawing) {
  std::set<std::string> names;
  for (const SheetLayer& layer : drawing.layers())
    if (!layer.strokes.empty()) names.insert(layer.name);
  return names;
}

// A flange has a bore and a pitch circle of holes.
TEST(SceneOptions, CentreLinesAreOfAView) {
  Scene scene{
      .models = {{.file = EPURA_TEST_SAMPLES "/models/flange.obj"}},
      .views = {{.projection = "front", .name = "f"}, {.projection = "top", .name = "t", .centre_lines = true}}};
  const std::set<std::string> of_one = layers_of(draw(scene, settings()));
  EXPECT_FALSE(of_one.contains("f/centre"));
  EXPECT_TRUE(of_one.contains("t/centre"));
  scene.views[1].centre_lines = false;
  Settings how = settings();
  how.centre_lines = true;
  const std::set<std::string> of_other = layers_of(draw(scene, how));
  EXPECT_TRUE(of_other.contains("f/centre"));
  EXPECT_FALSE(of_other.contains("t/centre"));
}

}  // namespace
}  // namespace epura::test::scene_options_test
