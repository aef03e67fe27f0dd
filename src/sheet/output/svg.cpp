// SPDX-License-Identifier: Apache-2.0
// SVG in one pass over the sheet. A document may be embedded in another page: its names do not clash with those of the
// page, and its rules apply to no other elements.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "output/of_sheet.hpp"
#include "output/page_lines.hpp"
#include "output/svg_lettering.hpp"
#include "output/svg_path_text.hpp"
#include "output/svg_paths.hpp"
#include "output/svg_tree.hpp"
#include "output/write.hpp"
#include "output/xml_text.hpp"
#include "scene/line_roles.hpp"

namespace epura::output {

namespace {

/// Hash of the visible content of a sheet. Positions are rounded as they are written, to 0.0001 mm.
class SheetHash {
 public:
  explicit SheetHash(const sheet::Sheet& sheet) {
    add(Vec2(sheet.width, sheet.height));
    add(sheet.title);
    for (const sheet::Layer& layer : sheet.layers) add(layer);
  }

  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x9e3779b97f4a7c15;
    value_ ^= value_ >> 32;
  }
  void add(double millimetres) { add(static_cast<std::uint64_t>(parts_of(millimetres, 1e4))); }
  void add(const Vec2& p) {
    add(p.x);
    add(p.y);
  }
  void add(std::string_view text) {
    add(text.size());
    for (const char c : text) add(std::uint64_t{static_cast<unsigned char>(c)});
  }
  void add(const std::vector<Vec2>& points) {
    add(points.size());
    for (const Vec2& p : points) add(p);
  }
  void add(const sheet::Layer& layer) {
    add(layer.name);
    for (const sheet::Picture& picture : layer.pictures) add(std::string_view(*picture.png));
    for (const sheet::Stroke& stroke : layer.strokes) add(stroke.points);
    for (const sheet::Fill& fill : layer.fills)
      for (const std::vector<Vec2>& ring : fill.rings) add(ring);
    for (const sheet::Text& text : layer.texts) {
      add(text.text);
      add(text.at);
    }
  }

  std::uint64_t value_ = 0;
};

// Four characters, the second a digit: not a word, and short enough to precede the id of every line.
std::string prefix_of(const sheet::Sheet& sheet) {
  constexpr std::string_view characters = "0123456789abcdefghijklmnopqrstuvwxyz";
  std::uint64_t rest = SheetHash(sheet).value();
  std::string prefix;
  const auto add = [&](std::size_t from, std::size_t count) {
    prefix += characters[from + static_cast<std::size_t>(rest % count)];
    rest /= count;
  };
  add(10, 26);
  add(0, 10);
  add(0, 36);
  add(0, 36);
  return prefix;
}

/// Writes the layers, with unique ids.
class LayerWriter {
 public:
  LayerWriter(std::string& svg, const sheet::Sheet& sheet, const SvgDocument& document)
      : svg_(svg), document_(document), lettering_(lettering_of(sheet)) {
    if (document.in_html) ids_ = {"title", "desc"};
    for (const sheet::Layer& layer : sheet.layers)
      if (draws_edges(layer)) edges_ += layer.strokes.size();
  }

  void append(const std::vector<const sheet::Layer*>& layers, const Progress& progress);

 private:
  void begin_view(std::string_view view, std::span<const sheet::Layer* const> layers);
  void begin_group(std::string_view name, std::string_view label, std::string_view label_in_page);
  void append(const sheet::Layer& layer, std::string_view name_in_view, const Progress& progress);
  void append_lines(const sheet::Layer& layer, const Progress& progress);
  void append_look(const sheet::LineStyle& style);
  void append_origin(const sheet::Layer& layer);

  std::string& svg_;
  const SvgDocument& document_;
  std::optional<sheet::Lettering> lettering_;
  std::set<std::string> ids_{};
  std::size_t lines_ = 0, texts_ = 0;
  std::size_t edges_ = 0;       ///< number of lines in layers that draw edges
  std::size_t edge_bytes_ = 0;  ///< written of them
};

// The view of VIEW/ROLE; empty if there is none.
std::string_view view_of(const sheet::Layer& layer) {
  const std::size_t slash = layer.name.rfind('/');
  return std::string_view(layer.name).substr(0, slash == std::string::npos ? 0 : slash);
}

// VIEW/ROLE becomes a layer ROLE in a layer VIEW.
void LayerWriter::append(const std::vector<const sheet::Layer*>& layers, const Progress& progress) {
  std::string_view open;
  for (auto at = layers.begin(); at != layers.end(); ++at) {
    const sheet::Layer* layer = *at;
    const std::string_view view = view_of(*layer);
    if (view != open) {
      if (!open.empty()) svg_ += "</g>\n";
      if (!view.empty()) {
        begin_group(view, view, "data-view");
        const auto end = std::find_if(at, layers.end(), [&](const auto* one) { return view_of(*one) != view; });
        begin_view(view, {at, end});
      }
      open = view;
    }
    append(*layer, std::string_view(layer->name).substr(view.empty() ? 0 : view.size() + 1), progress);
  }
  if (!open.empty()) svg_ += "</g>\n";
}

// The rest of the tag of its group, and what it has beside its layers.
void LayerWriter::begin_view(std::string_view view, std::span<const sheet::Layer* const> layers) {
  if (document_.named != nullptr) append_view_name(svg_, *document_.named, std::string(view));
  svg_ += ">\n";
  if (document_.named != nullptr) append_tree(svg_, *document_.named, layers, document_.prefix, {lines_, texts_});
}

void LayerWriter::begin_group(std::string_view name, std::string_view label, std::string_view label_in_page) {
  if (document_.page != nullptr) return append_attribute(svg_ += "<g", label_in_page, label);
  std::string id = identifier(name);
  // Plain numbers are the ids of lines.
  if (id.find_first_not_of("0123456789") == std::string::npos) id += '-';
  while (!ids_.insert(id).second) id += '-';
  svg_.append("<g id=\"").append(document_.prefix).append(id) += '"';
  if (document_.in_html) return append_attribute(svg_, label_in_page, label);
  svg_ += " inkscape:groupmode=\"layer\"";
  append_attribute(svg_, "inkscape:label", label);
}

void LayerWriter::append(const sheet::Layer& layer, std::string_view name_in_view, const Progress& progress) {
  begin_group(layer.name, name_in_view, "data-layer");
  append_look(layer.style);
  if (!document_.plain) append_origin(layer);
  svg_ += ">\n";
  append_pictures(svg_, layer, document_);
  append_fills(svg_, layer, document_);
  append_lines(layer, progress);
  if (lettering_) append_texts(svg_, layer, document_, *lettering_, texts_);
  lines_ += layer.strokes.size();
  texts_ += layer.texts.size();
  svg_ += "</g>\n";
}

// In a page, lines of edges may use what everything else leaves of the bound on its size.
void LayerWriter::append_lines(const sheet::Layer& layer, const Progress& progress) {
  if (!draws_edges(layer)) return append_paths(svg_, layer, document_, lines_, progress);
  if (!document_.lines) return;
  const std::size_t before = svg_.size();
  SvgDocument document = document_;
  document.spare = (before - edge_bytes_) * 3 / 10 / edges_;
  append_paths(svg_, layer, document, lines_, progress);
  edge_bytes_ += svg_.size() - before;
}

// Differences from the document's style, as attributes: every program reads them, and a path's own dashes override
// them.
void LayerWriter::append_look(const sheet::LineStyle& style) {
  if (document_.page == nullptr) append_attribute(svg_, "class", document_.prefix + identifier(style.name));
  if (style.colour != Colour{}) svg_.append(" stroke=\"").append(hexadecimal(style.colour)) += '"';
  append_millimetres(svg_ += " stroke-width=\"", style.width);
  svg_ += '"';
  if (style.dashes.dash > 0) svg_.append(" stroke-dasharray=\"").append(dash_array(style.dashes)) += '"';
}

// Attributes shared by all lines of the layer are written once. Layers of lines that are not edges have none.
void LayerWriter::append_origin(const sheet::Layer& layer) {
  const auto is_edge = [](const sheet::Stroke& stroke) { return stroke.kind.has_value(); };
  if (std::none_of(layer.strokes.begin(), layer.strokes.end(), is_edge)) return;
  const scene::SheetLineRow* row = scene::find_line(layer.style.name);
  const bool is_hidden = row != nullptr && row->is_hidden;
  svg_ += is_hidden ? " data-visible=\"0\"" : " data-visible=\"1\"";
  if (const auto model = common_model(layer)) svg_.append(" data-model=\"").append(std::to_string(*model)) += '"';
}

// Puts the layers of a view next to each other: drawings are black, so the order of layers does not matter.
std::vector<const sheet::Layer*> by_view(const sheet::Sheet& sheet) {
  std::map<std::string_view, std::size_t> places;
  std::vector<const sheet::Layer*> layers;
  for (const sheet::Layer& layer : sheet.layers) {
    places.emplace(view_of(layer), places.size());
    layers.push_back(&layer);
  }
  const auto place = [&](const sheet::Layer* layer) { return places.at(view_of(*layer)); };
  std::stable_sort(layers.begin(), layers.end(),
                   [&](const sheet::Layer* a, const sheet::Layer* b) { return place(a) < place(b); });
  return layers;
}

/// A fact of the sheet and its Dublin Core element. Agents are people and companies.
struct Element {
  std::string_view fact, name;
  bool agent;
};
constexpr std::array<Element, 6> elements = {{{"author", "dc:creator", true},
                                              {"approver", "dc:contributor", true},
                                              {"owner", "dc:rights", true},
                                              {"number", "dc:identifier", false},
                                              {"date", "dc:date", false},
                                              {"language", "dc:language", false}}};

// All facts without a Dublin Core element.
std::string remarks(const sheet::Sheet& sheet) {
  std::string text = description_of(sheet);
  for (const auto& [fact, value] : sheet.facts) {
    bool told = value.empty();
    for (const Element& element : elements) told = told || fact == element.fact;
    if (!told) text += (text.empty() ? "" : "\n") + fact + ": " + value;
  }
  return text;
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : " ") + sentence;
  return text;
}

std::string title_of(const sheet::Sheet& sheet) { return sheet.title.empty() ? "Drawing" : sheet.title; }

// What the sheet shows: in its language, to which `described` refers, then in others.
void append_descriptions(std::string& svg, const sheet::Sheet& sheet, const std::string& described) {
  std::string id = described;
  for (const sheet::Summary& summary : sheet.summaries) {
    svg += "<desc";
    if (!id.empty()) append_attribute(svg, "id", id);
    append_attribute(svg, "lang", summary.language);
    append_escaped(svg += '>', joined(summary.sentences));
    svg += "</desc>\n";
    id.clear();
  }
}

// Of the root, for screen readers.
void append_roles(std::string& svg, const sheet::Sheet& sheet, const std::string& id) {
  svg += " role=\"graphics-document document\"";
  append_attribute(svg, "lang", language_of_names(sheet));
  svg += " aria-labelledby=\"" + id + "-title\"";
  if (!sheet.summaries.empty()) svg += " aria-describedby=\"" + id + "-desc\"";
}

// Title, description and metadata, as Inkscape shows them under Document Properties: RDF with Dublin Core elements, in
// the form used by Creative Commons.
void append_metadata(std::string& svg, const sheet::Sheet& sheet, const std::vector<Attachment>& attachments,
                     const std::string& named) {
  const auto add = [&svg](std::string_view name, const std::string& text) {
    if (!text.empty()) append_element(svg, name, text);
  };
  if (named.empty()) {
    append_element(svg, "title", sheet.title);
    add("desc", description_of(sheet));
  } else {
    append_escaped(svg += "<title id=\"" + named + "-title\">", title_of(sheet));
    svg += "</title>\n";
    append_descriptions(svg, sheet, named + "-desc");
  }
  svg +=
      "<metadata>\n<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
      "xmlns:cc=\"http://creativecommons.org/ns#\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n"
      "<cc:Work rdf:about=\"\">\n<dc:format>image/svg+xml</dc:format>\n";
  add("dc:title", sheet.title);
  for (const Element& element : elements) {
    const std::string value = fact_of(sheet, element.fact);
    if (value.empty() || !element.agent) {
      add(element.name, value);
      continue;
    }
    svg.append("<").append(element.name).append("><cc:Agent>");
    append_element(svg, "dc:title", value);
    svg.append("</cc:Agent></").append(element.name).append(">\n");
  }
  add("dc:description", remarks(sheet));
  svg += "</cc:Work>\n</rdf:RDF>\n";
  append_attachments(svg, attachments);
  svg += "</metadata>\n";
}

// The rules of a page for all paths, and the properties that its elements inherit, must not change a drawing embedded
// in it: its elements are reset to their attributes, and inherited properties are set. An id takes precedence over all
// rules of the page for elements and classes. A stand-alone document has no page around it and is spared the time that
// this takes; and only browsers need it.
void append_style(std::string& svg, const std::string& id, bool has_text) {
  svg += "<style>#" + id +
         "{fill:none;fill-opacity:1;fill-rule:nonzero;stroke:#000;stroke-opacity:1;stroke-linecap:round;"
         "stroke-linejoin:round;stroke-dasharray:none;stroke-dashoffset:0;paint-order:normal;marker:none}\n";
  if (has_text)
    svg += "#" + id + " ." + id +
           "-lettering{font-style:normal;font-variant:normal;font-weight:normal;font-stretch:normal;font-kerning:none;"
           "letter-spacing:normal;word-spacing:normal;text-transform:none;text-anchor:start;direction:ltr}\n";
  svg += "#" + id + ":where(:not(:root)) *{all:revert-layer}</style>\n";
}

// The beginning of a document of its own: with its size, names for Inkscape, and metadata. `named`: its id, if it has
// names for screen readers.
void begin_file(std::string& svg, const sheet::Sheet& sheet, const std::vector<Attachment>& attachments,
                const std::string& named) {
  std::string width, height;
  append_millimetres(width, sheet.width);
  append_millimetres(height, sheet.height);
  if (!named.empty()) append_roles(svg, sheet, named);
  svg +=
      " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
      "xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\" fill=\"none\" stroke=\"#000\" "
      "stroke-linecap=\"round\" stroke-linejoin=\"round\" width=\"";
  svg += width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height + "\">\n";
  svg += "<sodipodi:namedview inkscape:document-units=\"mm\"/>\n";
  // Browsers print it on a sheet of its size, without margins that would scale it.
  svg += "<style>@page{size:" + width + "mm " + height + "mm;margin:0}</style>\n";
  append_metadata(svg, sheet, attachments, named);
}

// The beginning of an element of a page, with its name and description for screen readers.
void begin_inline(std::string& svg, const sheet::Sheet& sheet, const std::string& id, bool is_tree) {
  std::string width, height;
  append_millimetres(width, sheet.width);
  append_millimetres(height, sheet.height);
  if (is_tree)
    append_roles(svg, sheet, id);
  else
    svg += " role=\"img\" aria-labelledby=\"" + id + "-title\" aria-describedby=\"" + id + "-desc\"";
  svg +=
      " fill=\"none\" stroke=\"#000\" stroke-linecap=\"round\" stroke-linejoin=\"round\" width=\"100%\" viewBox=\"0 0 ";
  svg += width + " " + height + "\">\n<title id=\"" + id + "-title\">";
  append_escaped(svg, title_of(sheet));
  svg += "</title>\n";
  if (is_tree) return append_descriptions(svg, sheet, id + "-desc");
  append_escaped(svg += "<desc id=\"" + id + "-desc\">", description_of(sheet));
  svg += "</desc>\n";
}

void append_document(std::string& svg, const sheet::Sheet& sheet, const VectorOptions& options,
                     const Progress& progress) {
  const std::string id = options.id_prefix.empty() ? prefix_of(sheet) : options.id_prefix;
  const std::vector<const sheet::Layer*> layers = by_view(sheet);
  // Untouched memory costs nothing, but moving a long text does.
  std::size_t max = 0;
  for (const sheet::Layer* layer : layers) max += max_bytes(*layer);
  svg.reserve(svg.size() + max);
  const bool is_tree = options.svg == SvgKind::accessible && !options.plain;
  svg += "<svg id=\"" + id + "\" xmlns=\"http://www.w3.org/2000/svg\"";
  if (options.is_inline)
    begin_inline(svg, sheet, id, is_tree);
  else
    begin_file(svg, sheet, options.attachments, is_tree ? id : "");
  const auto has_texts = [](const sheet::Layer* layer) { return !layer->texts.empty(); };
  append_style(svg, id, options.text == SvgText::text && std::any_of(layers.begin(), layers.end(), has_texts));
  const SvgDocument document{sheet.height,  options.decimals.value_or(usual_decimals),
                             options.plain, options.text,
                             id + "-",      options.is_inline,
                             nullptr,       is_tree ? &sheet : nullptr};
  LayerWriter(svg, sheet, document).append(layers, progress);
  svg += "</svg>\n";
}

// A page has one drawing on its sheet of paper. Its background is part of it, so that the dark page can show it, too.
void append_for_page(std::string& svg, const sheet::Sheet& sheet, const VectorOptions& options, bool lines,
                     const Progress& progress) {
  std::string width, height;
  append_millimetres(width, sheet.width);
  append_millimetres(height, sheet.height);
  svg += "<svg class=\"drawing\" xmlns=\"http://www.w3.org/2000/svg\" role=\"group\"";
  append_attribute(svg, "aria-label", sheet.title.empty() ? "drawing" : sheet.title);
  const std::string language = fact_of(sheet, "language");
  if (!language.empty()) append_attribute(svg, "lang", language);
  svg += " fill=\"none\" stroke=\"#000\" stroke-linecap=\"round\" stroke-linejoin=\"round\" viewBox=\"0 0 " + width +
         " " + height + "\">\n<rect class=\"paper\" width=\"" + width + "\" height=\"" + height + "\"/>\n";
  const SvgDocument document{
      sheet.height, options.decimals.value_or(usual_decimals), options.plain, options.text, "", true, &sheet, nullptr,
      lines};
  LayerWriter(svg, sheet, document).append(by_view(sheet), progress);
  svg += "</svg>\n";
}

}  // namespace

std::string svg_of_page(const sheet::Sheet& sheet, const VectorOptions& options, bool lines, const Progress& progress) {
  std::string svg;
  append_for_page(svg, sheet, options, lines, progress);
  return svg;
}

std::string to_svg(const sheet::Sheet& sheet, const VectorOptions& options, const Progress& progress) {
  std::string svg = options.is_inline ? "" : "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  append_document(svg, sheet, options, progress);
  return svg;
}

std::string checked_id_prefix(std::string prefix, const std::string& where) {
  constexpr std::string_view characters = "0123456789-_ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  constexpr std::size_t first_letter = 12, longest = 64;
  if (prefix.empty() || prefix.size() > longest || characters.find(prefix[0]) < first_letter ||
      prefix.find_first_not_of(characters) != std::string::npos)
    throw Error(ErrorKind::input, where, "'" + prefix + "' cannot begin an id",
                "use a letter, then letters, digits, '-' and '_', at most 64 in all");
  return prefix;
}

}  // namespace epura::output
