// SPDX-License-Identifier: Apache-2.0
// What a screen reader finds in an accessible SVG file: a view with its features, lines, dimensions and their texts.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "base/text.hpp"
#include "output/write.hpp"
#include "support.hpp"
#include "svg_reader.hpp"

namespace epura::svg_tree_test {
namespace {

// A view with three lines, of which two are those of a hole, and one of these has no ink; and two dimensions, one of
// the hole, with two texts.
sheet::Sheet small_sheet() {
  sheet::Sheet sheet{200, 100, "A <plate>", {}};
  sheet.views = {{"front", "front", "1:2", {10, 10}, {90, 60}}};
  sheet.facts = {{"language", "fr"}};
  sheet.summaries = {{"fr", {"La feuille montre une pièce.", "Deux."}}, {"en", {"The sheet shows a part."}}};
  sheet.features = {{"front", "trou, diamètre 8"}};
  sheet.line_facts = {{.length = 12.5}};
  const auto line = [](const Vec2& from, const Vec2& to, int feature, int facts) {
    sheet::Stroke stroke{{from, to}};
    stroke.kind = EdgeKind::crease;
    stroke.feature = feature;
    stroke.facts = facts;
    return stroke;
  };
  sheet::Layer visible{"front/visible", {"visible", 0.5}, {}};
  visible.strokes = {line({10, 10}, {50, 10}, -1, -1), line({10, 50}, {50, 50}, 0, 0), line({1, 1}, {1, 1}, 0, -1)};
  visible.strokes.back().points.pop_back();
  sheet::Layer hidden{"front/hidden", {"hidden", 0.25}, {line({10, 30}, {50, 30}, 0, -1)}};
  sheet::Layer sizes{"front/dimensions", {"dimension", 0.25}, {}};
  for (const char* words : {"40", "⌀8", "H7"}) sizes.texts.push_back({words, {30, 6}, 3.5});
  sheet::DimensionObject length{sheet::DimensionShape::linear, {}}, diameter{sheet::DimensionShape::diameter, {}};
  length.text = "40", length.texts = {0, 1};
  diameter.text = "⌀8 H7", diameter.texts = {1, 3}, diameter.feature = 0;
  sizes.dimensions = {length, diameter};
  sheet.layers = {visible, hidden, sizes};
  return sheet;
}

class Tree {
 public:
  explicit Tree(const output::VectorOptions& options) : document_(parse_svg(output::to_svg(small_sheet(), options))) {
    collect(document_.child("svg"));
  }

  [[nodiscard]] pugi::xml_node root() const { return document_.child("svg"); }
  [[nodiscard]] pugi::xml_node at(const std::string& id) const { return by_id_.at(id); }

  /// "name(inner inner)": what has a name, as `aria-owns` and the document have it.
  [[nodiscard]] std::string told(const pugi::xml_node& node) const {
    std::string inner;
    const auto add = [&](const pugi::xml_node& one) {
      if (const std::string text = told(one); !text.empty()) inner += (inner.empty() ? "" : "; ") + text;
    };
    for (const pugi::xml_node child : node.children())
      if (!owner_.contains(child.attribute("id").value())) add(child);
    for (const std::string_view id : split(node.attribute("aria-owns").value(), ' '))
      if (!id.empty()) add(by_id_.at(std::string(id)));
    const std::string name = node.attribute("aria-label").value();
    return name.empty() ? inner : inner.empty() ? name : name + " (" + inner + ")";
  }

 private:
  void collect(const pugi::xml_node& node) {
    if (const std::string id = node.attribute("id").value(); !id.empty()) by_id_[id] = node;
    for (const std::string_view id : split(node.attribute("aria-owns").value(), ' ')) {
      if (id.empty()) continue;
      EXPECT_TRUE(owner_.emplace(std::string(id), node).second) << id << " is in two places";
    }
    for (const pugi::xml_node child : node.children()) collect(child);
  }

  pugi::xml_document document_;
  std::map<std::string, pugi::xml_node> by_id_{}, owner_{};
};

output::VectorOptions accessible() {
  output::VectorOptions options;
  options.svg = output::SvgKind::accessible;
  options.id_prefix = "p";
  return options;
}

TEST(SvgTree, HasViewsFeaturesLinesAndDimensions) {
  const std::string expected =
      "Vue front (vue de face), échelle 1:2: 3 lignes visibles, 1 ligne cachée. "
      "(trou, diamètre 8 (ligne visible 12.5; ligne cachée; diamètre ⌀8 H7 (⌀8; H7)); longueur 40 (40); ligne visible)";
  for (const bool is_inline : {false, true}) {
    output::VectorOptions options = accessible();
    options.is_inline = is_inline;
    const Tree tree(options);
    EXPECT_EQ(tree.told(tree.root()), expected);
  }
}

TEST(SvgTree, HasANameAndADescriptionInSeveralLanguages) {
  const Tree tree(accessible());
  EXPECT_STREQ(tree.root().attribute("role").value(), "graphics-document document");
  EXPECT_STREQ(tree.root().attribute("lang").value(), "fr");
  EXPECT_STREQ(tree.at(tree.root().attribute("aria-labelledby").value()).text().get(), "A <plate>");
  const pugi::xml_node own = tree.at(tree.root().attribute("aria-describedby").value());
  EXPECT_STREQ(own.text().get(), "La feuille montre une pièce. Deux.");
  EXPECT_STREQ(own.attribute("lang").value(), "fr");
  EXPECT_STREQ(own.next_sibling().text().get(), "The sheet shows a part.");
  EXPECT_STREQ(own.next_sibling().attribute("lang").value(), "en");
}

TEST(SvgTree, IsNotInUsualFiles) {
  output::VectorOptions options;
  options.id_prefix = "p";
  const std::string svg = output::to_svg(small_sheet(), options);
  for (const char* word : {"graphics-", "aria-owns", "role=", "lang="}) EXPECT_EQ(svg.find(word), svg.npos) << word;
}

}  // namespace
}  // namespace epura::svg_tree_test
