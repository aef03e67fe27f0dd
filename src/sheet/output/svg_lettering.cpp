// SPDX-License-Identifier: Apache-2.0
#include "output/svg_lettering.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "base/utf8.hpp"
#include "output/of_sheet.hpp"
#include "output/svg_path_text.hpp"
#include "output/svg_tree.hpp"
#include "output/xml_text.hpp"

namespace epura::output {

namespace {

// About 60 kB: libxml2 and programs based on it refuse attributes of 10 MB.
constexpr std::size_t letters_of_path = 100, outlines_of_path = 200;

constexpr int decimals = 4;  // of a millimetre

void append_area(std::string& svg, const sheet::Fill& fill, double height) {
  svg += "<path d=\"";
  SvgPathText path(svg, decimals);
  for (const std::vector<Vec2>& ring : fill.rings) {
    const auto on_page = [&](const Vec2& p) { return Vec2(p.x, height - p.y); };
    if (ring.empty()) continue;
    path.move(on_page(ring.front()));
    for (std::size_t i = 1; i < ring.size(); ++i) path.line(on_page(ring[i]));
    path.close();
  }
  path.end();
  svg += "\"/>\n";
}

// Straight pieces become lines, except the last one, which Z draws.
void append_outline(SvgPathText& path, const sheet::GlyphOutline& outline, const auto& on_page) {
  Vec2 at = outline.curves.back().end;
  path.move(on_page(at));
  for (const sheet::GlyphOutline::Curve& curve : outline.curves) {
    const bool straight = glm::distance(curve.control, (at + curve.end) / 2.0) < 1e-9;
    at = curve.end;
    if (!straight) {
      path.curve(on_page(curve.control), on_page(at));
    } else if (&curve != &outline.curves.back()) {
      path.line(on_page(at));
    }
  }
  path.close();
}

// Outlines in millimetres of the sheet.
void append_outlines(std::string& svg, const sheet::Text& text, double height, const sheet::Lettering& lettering) {
  const double angle = text.angle * std::numbers::pi / 180;
  const Vec2 along(std::cos(angle), std::sin(angle));
  Vec2 start = start_of(text, lettering);
  const auto on_page = [&](const Vec2& p) {
    const Vec2 at = start + p.x * along + p.y * Vec2(-along.y, along.x);
    return Vec2(at.x, height - at.y);
  };
  if (!lettering.covers(text.text)) {
    const std::vector<sheet::GlyphOutline> outlines = lettering.outlines(text.text, text.height);
    for (std::size_t begin = 0; begin < outlines.size(); begin += outlines_of_path) {
      svg += "<path d=\"";
      SvgPathText path(svg, decimals);
      for (std::size_t i = begin; i < std::min(begin + outlines_of_path, outlines.size()); ++i)
        append_outline(path, outlines[i], on_page);
      path.end();
      svg += "\"/>";
    }
    return;
  }
  const std::vector<char32_t> letters = characters(sheet::written(text.text));
  for (std::size_t begin = 0; begin < letters.size(); begin += letters_of_path) {
    std::string part;
    for (std::size_t i = begin; i < std::min(begin + letters_of_path, letters.size()); ++i) part += utf8(letters[i]);
    svg += "<path d=\"";
    SvgPathText path(svg, decimals);
    for (const sheet::GlyphOutline& outline : lettering.outlines(part, text.height))
      append_outline(path, outline, on_page);
    path.end();
    svg += "\"/>";
    start += along * lettering.width(part, text.height);
  }
}

// `colour` is that of the areas in the layer.
void begin_group(std::string& svg, const SvgDocument& document, std::string_view name, const Colour& colour) {
  svg.append("<g class=\"").append(document.prefix).append(name).append("\" fill=\"").append(hexadecimal(colour));
  svg += "\" stroke=\"none\"";
}

// Prefixed, because line styles may have the same names.
void append_role(std::string& svg, const SvgDocument& document, const sheet::Text& text, std::size_t number) {
  if (document.named != nullptr) append_attribute(svg, "id", text_id(document.prefix, number));
  if (!text.role.empty()) append_attribute(svg, "class", document.prefix + "text-" + identifier(text.role));
}

void append_outlined(std::string& svg, const sheet::Text& text, const SvgDocument& document,
                     const sheet::Lettering& lettering, std::size_t number) {
  svg += "<g";
  append_role(svg, document, text, number);
  // Elsewhere, the words are for programs; in a page, a name without a role would be an error.
  const bool is_read = document.named == nullptr || text.role != "grid-reference";
  if (!is_read) append_attribute(svg, "aria-hidden", "true");
  if (is_read && (document.in_html || document.named != nullptr)) append_attribute(svg, "role", "img");
  append_attribute(svg, "aria-label", text.text);
  svg += '>';
  append_outlines(svg, text, document.height, lettering);
  svg += "</g>\n";
}

void append_written(std::string& svg, const sheet::Text& text, const SvgDocument& document,
                    const sheet::Lettering& lettering, std::size_t number) {
  constexpr std::string_view anchors[] = {"start", "middle", "end"};
  const double y = document.height - text.at.y;
  svg += "<text";
  append_role(svg, document, text, number);
  append_millimetres(svg += " x=\"", text.at.x);
  append_millimetres(svg += "\" y=\"", y);
  append_millimetres(svg += "\" font-size=\"", text.height * lettering.em());
  svg += '"';
  if (text.align != sheet::Align::left) append_attribute(svg, "text-anchor", anchors[static_cast<int>(text.align)]);
  if (text.angle != 0) {
    append_millimetres(svg += " transform=\"rotate(", -text.angle);
    append_millimetres(svg += ' ', text.at.x);
    append_millimetres(svg += ' ', y);
    svg += ")\"";
  }
  append_escaped(svg += '>', sheet::written(text.text));
  svg += "</text>\n";
}

std::string families(std::string family) {
  std::erase_if(family, [](char c) { return c == '\'' || c == '\\'; });
  return (family.empty() ? "osifont,'ISOCPEUR'" : "'" + family + "',osifont") + ",sans-serif";
}

}  // namespace

std::string identifier(std::string_view name) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_";
  std::string id(name);
  for (char& c : id)
    if (letters.find(c) == std::string_view::npos) c = '-';
  return id;
}

void append_fills(std::string& svg, const sheet::Layer& layer, const SvgDocument& document) {
  if (layer.fills.empty()) return;
  begin_group(svg, document, "filled", layer.style.colour);
  svg += " fill-rule=\"evenodd\">\n";
  for (const sheet::Fill& fill : layer.fills) append_area(svg, fill, document.height);
  svg += "</g>\n";
}

void append_pictures(std::string& svg, const sheet::Layer& layer, const SvgDocument& document) {
  for (const sheet::Picture& picture : layer.pictures) {
    const auto add = [&svg](const char* name, double value) {
      append_millimetres(svg.append(" ").append(name) += "=\"", value);
      svg += '"';
    };
    svg += "<image preserveAspectRatio=\"none\"";
    add("x", picture.min.x);
    add("y", document.height - picture.max.y);
    add("width", picture.max.x - picture.min.x);
    add("height", picture.max.y - picture.min.y);
    svg.append(" xmlns:xlink=\"http://www.w3.org/1999/xlink\" xlink:href=\"data:image/png;base64,")
        .append(base64(*picture.png))
        .append("\"/>\n");
  }
}

void append_texts(std::string& svg, const sheet::Layer& layer, const SvgDocument& document,
                  const sheet::Lettering& lettering, std::size_t first_text) {
  if (layer.texts.empty()) return;
  begin_group(svg, document, "lettering", layer.style.colour);
  const bool as_text = document.text == SvgText::text;
  if (as_text) {
    append_attribute(svg, "font-family", families(lettering.family()));
    svg += " xml:space=\"preserve\"";
  }
  svg += ">\n";
  for (const sheet::Text& text : layer.texts) {
    if (as_text) {
      append_written(svg, text, document, lettering, first_text++);
    } else {
      append_outlined(svg, text, document, lettering, first_text++);
    }
  }
  svg += "</g>\n";
}

}  // namespace epura::output
