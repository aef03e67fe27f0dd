// SPDX-License-Identifier: Apache-2.0
// PDF -> pictures: the lines, areas and texts of the layers.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/colour.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "compare/pdf_operations.hpp"
#include "compare/pdf_texts.hpp"
#include "compare/picture_maker.hpp"
#include "compare/read_pictures.hpp"
#include "output/pdf/library.hpp"
#include "scene/line_roles.hpp"
#include "svg/affine_map.hpp"
#include "svg/flatten.hpp"
#include "svg/style.hpp"

namespace epura::compare {

namespace {

constexpr double millimetres_per_point = 25.4 / 72;
constexpr std::size_t max_states = 100;  // maximum number of saved graphics states

struct PenState {
  svg::AffineMap map{};
  double width = 1;
  bool dashed = false;
  Colour of_lines{}, of_areas{};
};

struct SubPath {
  std::vector<Vec2> points;  // mm
  bool closed = false;
};

// The phase is a number, too.
bool sets_dashes(const PdfOperation& operation) { return operation.name == "d" && operation.numbers.size() > 1; }

// Shades of grey, or red, green and blue; in capitals those of lines. ISO 32000-1, 8.6.8.
bool set_colour(const PdfOperation& operation, PenState& pen) {
  const std::string_view name = operation.name;
  const bool of_lines = name == "G" || name == "RG";
  if (!of_lines && name != "g" && name != "rg") return false;
  const std::size_t parts = name.size() == 1 ? 1 : 3;
  if (operation.numbers.size() != parts) return false;
  const auto part = [&](std::size_t i) {
    const double share = operation.numbers[parts == 1 ? 0 : i];
    return share > 0 ? static_cast<int>(std::lround(255 * std::min(share, 1.0))) : 0;
  };
  (of_lines ? pen.of_lines : pen.of_areas) = {part(0), part(1), part(2)};
  return true;
}

bool has_dashes(std::string_view content) {
  bool found = false;
  for_each_operation(content, [&](const PdfOperation& operation) { found = found || sets_dashes(operation); });
  return found;
}

class PdfReader {
 public:
  PdfReader(output::PdfContent page, const std::string& where, svg::PieceRoom& room)
      : page_(std::move(page)), where_(where), room_(room), picture_(where), texts_(page_.fonts, room) {
    picture_.set_size(Vec2(page_.width, page_.height) * millimetres_per_point);
  }

  Picture read() {
    PenState pen;
    pen.map = {{millimetres_per_point, 0}, {0, millimetres_per_point}, {0, 0}};
    std::string layer;
    run(page_.page, pen, [&](const PdfOperation& operation, const PenState& now) {
      if (operation.name == "BDC" && operation.words.size() == 2) layer = name_of_layer(operation.words[1]);
      if (operation.name == "Do" && operation.words.size() == 1) read_form(operation.words[0], layer, now);
    });
    return picture_.finish();
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(ErrorKind::input, where_, what, "epura compares only PDF files that it wrote itself");
  }

  [[nodiscard]] std::string name_of_layer(const std::string& property) const {
    const auto found = page_.layers.find(property);
    if (found == page_.layers.end()) refuse("refers to a missing layer");
    return found->second;
  }

  // Layers are named VIEW/ROLE, followed by a number if an earlier page has the same name.
  void read_form(const std::string& name, const std::string& layer, const PenState& pen) {
    const auto form = page_.forms.extract(name);
    if (!form) refuse("draws a missing layer, or a layer twice");
    const std::size_t slash = layer.rfind('/');
    view_ = picture_.view(slash == std::string::npos ? "" : layer.substr(0, slash));
    role_ = layer.substr(slash == std::string::npos ? 0 : slash + 1);
    role_ = role_.substr(0, role_.find(' '));
    const scene::SheetLineRow* row = scene::find_line(role_);
    hidden_ = row != nullptr && row->is_hidden;
    broken_ = row != nullptr && row->dashes.is_broken() && has_dashes(form.mapped());
    run(form.mapped(), pen, [&](const PdfOperation& operation, const PenState& now) {
      if (operation.name == "Do") refuse("has pictures in its layers");
      paint(operation.name, now);
      texts_.take(operation, now.map);
    });
    for (const PictureText& text : texts_.finish(view_)) picture_.add(text);
  }

  // Tracks the graphics state and the path, and reports every operation to `tell`. ISO 32000-1, 8.4 and 8.5.
  template <class Tell>
  void run(std::string_view content, PenState pen, const Tell& tell) {
    std::vector<PenState> stack;
    for_each_operation(content, [&](const PdfOperation& operation) {
      const std::string_view name = operation.name;
      const std::vector<double>& n = operation.numbers;
      if (name == "q") {
        if (stack.size() == max_states) refuse("saves more than " + std::to_string(max_states) + " graphics states");
        stack.push_back(pen);
      } else if (name == "Q" && !stack.empty()) {
        pen = stack.back();
        stack.pop_back();
      } else if (name == "cm" && n.size() == 6) {
        pen.map = pen.map.after({{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}});
      } else if (name == "w" && n.size() == 1) {
        pen.width = n[0];
      } else if (name == "d") {
        pen.dashed = sets_dashes(operation);
      } else if (!set_colour(operation, pen)) {
        extend_path(operation, pen.map);
      }
      tell(operation, pen);
    });
  }

  void extend_path(const PdfOperation& operation, const svg::AffineMap& map) {
    const std::vector<double>& n = operation.numbers;
    const auto point = [&](std::size_t i) { return map({n[i], n[i + 1]}); };
    const std::string_view name = operation.name;
    if (name == "m" && n.size() == 2) {
      room_.take(1);
      path_.push_back({{point(0)}});
    } else if (name == "re" && n.size() == 4) {
      room_.take(4);
      const Vec2 at(n[0], n[1]), x(n[2], 0), y(0, n[3]);
      path_.push_back({{map(at), map(at + x), map(at + x + y), map(at + y)}, true});
    } else if (path_.empty()) {
      return;
    } else if (name == "l" && n.size() == 2) {
      room_.take(1);
      path_.back().points.push_back(point(0));
    } else if (name == "c" && n.size() == 6) {
      svg::append_cubic(path_.back().points, {path_.back().points.back(), point(0), point(2), point(4)}, room_);
    } else if (name == "h") {
      path_.back().closed = true;
    }
  }

  void paint(std::string_view name, const PenState& pen) {
    if (name == "S" || name == "s") {
      const bool dashed = broken_ || pen.dashed;
      add_path({role_, !hidden_, false, pen.width * pen.map.scale(), dashed ? some_dashes : std::vector<double>(),
                svg::colour_of(hexadecimal(pen.of_lines))});
    }
    if (name == "f" || name == "f*")
      add_path({role_ + " area", true, true, 0, {}, svg::colour_of(hexadecimal(pen.of_areas))});
    if (name == "S" || name == "s" || name == "f" || name == "f*" || name == "n") path_.clear();
    if (name == "B" || name == "B*" || name == "b" || name == "b*" || name == "sh" || name == "BI")
      refuse("uses unsupported painting operators");
  }

  void add_path(const PictureLook& look) {
    const int number = picture_.look(look);
    for (const SubPath& line : path_)
      for (std::size_t i = 0; i + (line.closed || look.filled ? 0 : 1) < line.points.size(); ++i)
        picture_.add({line.points[i], line.points[(i + 1) % line.points.size()], number, view_, -1});
  }

  output::PdfContent page_;
  const std::string& where_;
  svg::PieceRoom& room_;
  PictureMaker picture_;
  PdfTexts texts_;
  std::vector<SubPath> path_{};
  int view_ = 0;
  std::string role_{};
  bool hidden_ = false;
  bool broken_ = false;  // whether the layer has dashed lines: those without dashes are short
};

}  // namespace

std::vector<Picture> pictures_of_pdf(const std::string& bytes, const std::string& where) {
  std::vector<Picture> pictures;
  svg::PieceRoom room(2 * bytes.size(), where);  // they are packed
  for (output::PdfContent& page : output::pdf_library().read_contents(bytes, where))
    pictures.push_back(PdfReader(std::move(page), where, room).read());
  return pictures;
}

}  // namespace epura::compare
