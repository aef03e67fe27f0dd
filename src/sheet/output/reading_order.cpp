// SPDX-License-Identifier: Apache-2.0
#include "output/reading_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string_view>

#include "base/error.hpp"
#include "base/text.hpp"
#include "output/of_sheet.hpp"
#include "scene/choices.hpp"
#include "scene/line_roles.hpp"
#include "sheet/phrases.hpp"

namespace epura::output {

namespace {

// The view of VIEW/ROLE; "sheet" has the frame and the title block.
std::string view_or_sheet(const sheet::Layer& layer) {
  const std::size_t slash = layer.name.rfind('/');
  return slash == std::string::npos ? "sheet" : layer.name.substr(0, slash);
}

std::string say(std::string_view key, std::string_view language, const std::vector<std::string>& texts = {}) {
  return sheet::phrase(key, language, texts);
}

// `one` and `many` are the keys for one thing and for others.
std::string counted(std::size_t count, const char* one, const char* many, std::string_view language) {
  return say(count == 1 ? one : many, language, {std::to_string(count)});
}

std::string words_of(const sheet::DimensionObject& dimension, std::string_view language) {
  return words_of_dimension(dimension, language);
}

// Its text says it, in the language of the sheet.
std::string words_of(const sheet::LeaderObject& /*leader*/, std::string_view /*language*/) { return {}; }

std::string words_of(const sheet::ToleranceObject& tolerance, std::string_view language) {
  std::string text;
  for (const sheet::FrameRow& row : tolerance.rows) {
    std::string words = sheet::characteristic_in_words(scene::word_of(row.characteristic), language);
    for (const scene::FrameCell& cell : row.cells) {
      words += " |";
      for (const scene::FramePiece& piece : cell) words += " " + piece.text;
    }
    append_to_list(text, words);
  }
  return say("tolerance", language, {text});
}

std::string words_of(const sheet::TableObject& table, std::string_view language) {
  const bool has_title = table.rows.front().size() == 1;
  return say("table", language, {has_title ? " " + table.rows.front().front().text : ""}) + ", " +
         counted(table.rows.size() - (has_title ? 1 : 0), "row", "table rows", language);
}

bool has_other_ink(const sheet::Layer& layer) {
  return !layer.strokes.empty() || !layer.fills.empty() || !layer.pictures.empty();
}

class Order {
 public:
  explicit Order(const sheet::Sheet& sheet) : sheet_(sheet) {
    tags_.language = sheet::language_of_phrases(fact_of(sheet, "language"));
    section("sheet");
    for (const sheet::ViewFrame& view : sheet.views) section(view.name);
    for (const sheet::Layer& layer : sheet.layers) add(layer);
  }

  PdfTags take() {
    sort_by_reading();
    return std::move(tags_);
  }

 private:
  int add_element(PdfElement element) {
    tags_.elements.push_back(std::move(element));
    return static_cast<int>(tags_.elements.size()) - 1;
  }

  // With the first view, what the sheet shows is said.
  [[nodiscard]] std::string words_of_figure(const std::string& view) const {
    std::string words = words_of_view(sheet_, view);
    if (!sheet_.views.empty() && sheet_.views.front().name == view && !sheet_.summaries.empty())
      for (const std::string& sentence : sheet_.summaries.front().sentences) words += " " + sentence;
    return words;
  }

  // Of a view: what it shows comes before what is written beside it.
  struct Section {
    int itself, figure;
  };
  const Section& section(const std::string& view) {
    const auto found = sections_.find(view);
    if (found != sections_.end()) return found->second;
    const int itself = add_element({"Sect"});
    const int figure = view == "sheet" ? -1 : add_element({"Figure", words_of_figure(view), itself});
    return sections_.emplace(view, Section{itself, figure}).first->second;
  }

  void add(const sheet::Layer& layer) {
    const Section& own = section(view_or_sheet(layer));
    std::vector<PdfMark>& marks = tags_.marks.emplace_back();
    const bool is_logo = own.figure < 0 && !layer.pictures.empty();
    if (has_other_ink(layer))
      marks.push_back({is_logo ? add_element({"Figure", say("logo", tags_.language), own.itself}) : own.figure});
    std::vector<int> owners(layer.texts.size(), -1);
    const auto give = [&](const auto& objects, const char* type) {
      for (const auto& object : objects) {
        if (object.texts.begin == object.texts.end) continue;
        check(object.texts.end <= owners.size(), "what is one thing has texts of its layer");
        const int element = add_element({type, words_of(object, tags_.language), own.itself});
        std::fill(owners.begin() + static_cast<std::ptrdiff_t>(object.texts.begin),
                  owners.begin() + static_cast<std::ptrdiff_t>(object.texts.end), element);
      }
    };
    give(layer.dimensions, "Span");
    give(layer.leaders, "P");
    give(layer.tolerances, "Span");
    for (const sheet::TableObject& table : layer.tables) add_table(table, layer, own.itself, owners);
    for (std::size_t i = 0; i < owners.size(); ++i) {
      const bool is_blank = layer.texts[i].text.find_first_not_of(' ') == std::string::npos;
      if (owners[i] < 0 && !is_blank && layer.texts[i].role != "grid-reference")
        owners[i] = add_element({"P", "", own.itself});
      const bool goes_on = !marks.empty() && marks.back().end_texts == i && i > 0 && marks.back().element == owners[i];
      if (goes_on)
        marks.back().end_texts = i + 1;
      else
        marks.push_back({owners[i], i, i + 1});
    }
  }

  // Texts belong to the cell in which they stand. The first one that is in a row of several cells is of the header.
  void add_table(const sheet::TableObject& object, const sheet::Layer& layer, int parent, std::vector<int>& owners) {
    const int table = add_element({"Table", words_of(object, tags_.language), parent});
    const auto row_of = [&](const sheet::Text& text) {
      const double row = std::floor((object.corner.y - text.at.y) / object.row_height);
      return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(object.rows.size()) - 1));
    };
    std::size_t header = object.rows.size();
    for (std::size_t i = object.texts.begin; i < object.texts.end && header == object.rows.size(); ++i)
      if (const std::size_t row = row_of(layer.texts[i]); object.rows[row].size() > 1) header = row;
    std::vector<std::vector<int>> places;
    for (std::size_t row = 0; row < object.rows.size(); ++row) {
      const int line = add_element({"TR", "", table});
      std::vector<int>& cells = places.emplace_back();
      for (std::size_t i = 0; i < object.rows[row].size(); ++i)
        cells.push_back(add_element({row == header ? "TH" : "TD", "", line}));
      if (cells.size() == 1) tags_.elements.back().columns = static_cast<int>(object.widths.size());
    }
    for (std::size_t i = object.texts.begin; i < object.texts.end; ++i) {
      const std::vector<int>& cells = places[row_of(layer.texts[i])];
      double right = object.corner.x;
      std::size_t cell = 0;
      while (cell + 1 < cells.size() && layer.texts[i].at.x > (right += object.widths[cell])) ++cell;
      check(cell < cells.size(), "a row of a table has a cell for each of its texts");
      owners[i] = cells[cell];
    }
  }

  // Sections stand in the order of their first elements, and all that is in them follows.
  void sort_by_reading() {
    std::vector<std::vector<int>> children(tags_.elements.size());
    std::vector<int> order, next(tags_.elements.size());
    std::vector<int> open;
    for (int i = static_cast<int>(tags_.elements.size()) - 1; i >= 0; --i) {
      const int parent = tags_.elements[static_cast<std::size_t>(i)].parent;
      (parent < 0 ? open : children[static_cast<std::size_t>(parent)]).push_back(i);
    }
    while (!open.empty()) {
      const int element = open.back();
      open.pop_back();
      next[static_cast<std::size_t>(element)] = static_cast<int>(order.size());
      order.push_back(element);
      const std::vector<int>& inner = children[static_cast<std::size_t>(element)];
      open.insert(open.end(), inner.begin(), inner.end());
    }
    check(order.size() == tags_.elements.size(), "every element is read once");
    std::vector<PdfElement> sorted;
    for (const int element : order) sorted.push_back(tags_.elements[static_cast<std::size_t>(element)]);
    for (PdfElement& element : sorted)
      if (element.parent >= 0) element.parent = next[static_cast<std::size_t>(element.parent)];
    for (std::vector<PdfMark>& layer : tags_.marks)
      for (PdfMark& mark : layer)
        if (mark.element >= 0) mark.element = next[static_cast<std::size_t>(mark.element)];
    tags_.elements = std::move(sorted);
  }

  const sheet::Sheet& sheet_;
  PdfTags tags_{};
  std::map<std::string, Section> sections_{};
};

}  // namespace

std::string words_of_dimension(const sheet::DimensionObject& dimension, std::string_view language) {
  constexpr std::array kinds{"length", "angle", "diameter", "radius", "coordinate"};
  return say(kinds[static_cast<std::size_t>(dimension.shape)], language, {dimension.text});
}

std::string words_of_view(const sheet::Sheet& sheet, const std::string& view) {
  std::array<std::size_t, 2> lines{};  // visible, hidden
  for (const sheet::Layer& layer : sheet.layers) {
    if (view_or_sheet(layer) != view) continue;
    const scene::SheetLineRow* row = scene::find_line(layer.style.name);
    for (const sheet::Stroke& stroke : layer.strokes)
      if (stroke.kind) ++lines[row != nullptr && row->is_hidden ? 1 : 0];
  }
  const std::string_view language = sheet::language_of_phrases(fact_of(sheet, "language"));
  std::string text = say("view", language, {view});
  for (const sheet::ViewFrame& frame : sheet.views) {
    if (frame.name != view) continue;
    const std::string projection = sheet::projection_in_words(frame.projection, language);
    if (!projection.empty() && projection != view) text += " (" + projection + ")";
    if (!frame.scale.empty()) text += say("scale", language, {frame.scale});
  }
  return text + ": " + counted(lines[0], "visible line", "visible lines", language) + ", " +
         counted(lines[1], "hidden line", "hidden lines", language) + ".";
}

PdfTags reading_order(const sheet::Sheet& sheet) { return Order(sheet).take(); }

}  // namespace epura::output
