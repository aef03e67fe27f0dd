// SPDX-License-Identifier: Apache-2.0
// Drawings pasted into an HTML page, as a browser shows them: the rules of the page change no drawing, and a drawing
// changes nothing else of the page.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "output/write.hpp"
#include "rasters.hpp"
#include "support.hpp"

namespace epura::pasted_test {
namespace {

constexpr int width = 800, height = 460, drawings_end = 300;  // pixels; below stands what the page has itself

// The names and elements of our drawings, as frameworks and pages use them for something else.
constexpr const char* hostile_rules = R"(
@layer base,utilities;@layer base{*,::before{margin:0;padding:0;border:0 solid}svg{display:block}}
@layer utilities{.hidden{display:none}.invisible,.visible{visibility:hidden}}
*,::before,::after{box-sizing:border-box;border-width:0;border-style:solid;border-color:#e5e7eb}
html{line-height:1.5;tab-size:4;font-family:ui-sans-serif,system-ui,sans-serif}
body{letter-spacing:.2em;word-spacing:1em;text-transform:uppercase;font-weight:700;font-style:italic;direction:rtl;
  text-anchor:end;fill-rule:evenodd;font-kerning:normal}
.hidden{display:none!important}.invisible,.visible{visibility:hidden!important}.collapse:not(.show){display:none}
.border{border:1px solid!important}.frame,.grid,.section,.tangent{display:grid;opacity:0}.text{color:red;fill:red}
.filled,.lettering,.text-title{display:none}.narrow{stroke:lime}
[class*="hidden"],[class$="visible"],[class*="lettering"]{display:none;opacity:.5}
svg{fill:currentColor;stroke:orange;stroke-width:3;stroke-dasharray:1 2;stroke-linecap:butt;stroke-opacity:.4;
  fill-opacity:.3;fill-rule:evenodd;stroke-linejoin:bevel}
svg *{visibility:hidden}
g{opacity:.2;stroke:lime;fill:lime;transform:rotate(5deg)}
path{fill:red;stroke:blue;stroke-width:4;stroke-dasharray:1 5;stroke-dashoffset:3;transform:translate(3px,3px);
  animation:dash 5s linear infinite;filter:blur(2px)}
text{font-size:30px;fill:red;stroke:red;letter-spacing:9px;text-anchor:end;transform:none}
.card svg path,.card svg g,.card text{display:none;stroke:pink}
@keyframes dash{to{stroke-dashoffset:1000}}
)";

// What a page has itself, under names and elements of our drawings.
constexpr const char* own_elements = R"(
<p class="hidden">not to be seen</p><p class="visible">visible</p><p class="section border text">section</p>
<svg width="200" height="60" viewBox="0 0 200 60"><g class="visible"><path d="M5 5h60v40z"/><text x="80" y="30">text</text>
<path class="hidden" d="M90 10h90v40z"/></g></svg>
)";

// Areas, texts at an angle, and lines of all sorts.
sheet::Sheet drawn_sheet(int strokes) {
  sheet::Sheet sheet = random_sheet(100, 75, strokes);
  sheet::Layer& layer = sheet.layers[1];
  layer.fills = {{{{{60, 10}, {80, 10}, {80, 30}, {60, 30}}, {{65, 15}, {75, 15}, {70, 25}}}}};
  layer.texts = {{"Gauge 8", {10, 40}, 5, 30, sheet::Align::left, "title"},
                 {"Ring", {50, 60}, 7, 0, sheet::Align::middle, "label"}};
  return sheet;
}

class Pasted : public Rasters {
 protected:
  // The first one as outlines, the second one as text.
  static std::string first() { return element(drawn_sheet(6), SvgText::outlines); }
  static std::string second() { return element(drawn_sheet(8), SvgText::text); }
  static std::string element(const sheet::Sheet& sheet, SvgText text) {
    output::VectorOptions options;
    options.text = text;
    options.is_inline = true;
    return output::to_svg(sheet, options);
  }

  [[nodiscard]] GreyPicture page(const std::string& rules, const std::string& left, const std::string& right,
                                 const std::string& own) const {
    const auto box = [](int x, int y, const std::string& content) {
      return "<div class=\"card\" style=\"position:absolute;overflow:hidden;left:" + std::to_string(x) +
             "px;top:" + std::to_string(y) + "px;width:100mm;height:75mm\">" + content + "</div>\n";
    };
    write("page.html",
          "<!DOCTYPE html><html><head><meta charset=\"utf-8\"><title>page</title><style>\n"
          "body{margin:0}svg{display:block}\n" +
              rules + "</style></head><body>\n" + box(0, 0, left) + box(width / 2, 0, right) +
              box(0, drawings_end, own) + "</body></html>\n");
    return in_browser("page.html", width, height);
  }
};

// Pixels of the rows `from` to `to` that are not the same.
long differing(const GreyPicture& a, const GreyPicture& b, int from, int to) {
  if (a.width != b.width || a.height != b.height) return -1;
  long count = 0;
  for (int i = from * a.width; i < to * a.width; ++i) count += a.grey.at(std::size_t(i)) != b.grey.at(std::size_t(i));
  return count;
}

// Strokes of some fonts are so thin that they are nowhere black.
long ink(const GreyPicture& picture) {
  return std::count_if(picture.grey.begin(), picture.grey.end(), [](int shade) { return shade < 192; });
}

TEST_F(Pasted, DrawingsKeepTheirLookUnderTheRulesOfAPage) {
  const GreyPicture alone = page("", first(), second(), "");
  ASSERT_GT(ink(alone), 3000);
  EXPECT_EQ(differing(page(hostile_rules, first(), second(), ""), alone, 0, drawings_end), 0);
  EXPECT_EQ(ink(page("", first(), "", "")) + ink(page("", "", second(), "")), ink(alone));

  // With names as pages have them, and without rules of its own, a drawing is lost there.
  std::string bare = first();
  const std::string prefix = bare.substr(9, 4) + "-";  // <svg id="xxxx"
  for (std::size_t at = 0; (at = bare.find(prefix, at)) != std::string::npos;) bare.erase(at, prefix.size());
  const std::string end_of_style = "</style>";
  const std::size_t style = bare.find("<style>");
  bare.erase(style, bare.find(end_of_style) + end_of_style.size() - style);
  EXPECT_EQ(differing(page("", bare, second(), ""), alone, 0, drawings_end), 0);
  EXPECT_GT(differing(page(hostile_rules, bare, second(), ""), alone, 0, drawings_end), 1000);
}

TEST_F(Pasted, PagesKeepTheirLookBesideDrawings) {
  for (const char* rules :
       {"", ".hidden{display:none}path{fill:none;stroke:#000}text{font-size:25px}.text{color:#555}"}) {
    const GreyPicture without = page(rules, "", "", own_elements);
    ASSERT_GT(ink(without), 300);
    EXPECT_EQ(differing(page(rules, first(), second(), own_elements), without, drawings_end, height), 0);
  }
}

}  // namespace
}  // namespace epura::pasted_test
