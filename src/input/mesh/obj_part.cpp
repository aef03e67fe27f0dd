// SPDX-License-Identifier: Apache-2.0
#include "mesh/obj_part.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/text_cursor.hpp"

namespace epura::mesh {

namespace {

void add_keyword(ObjIgnored& ignored, const std::string& keyword) {
  constexpr std::size_t max_named = 5;
  std::vector<std::string>& named = ignored.keywords;
  if (named.size() < max_named && std::find(named.begin(), named.end(), keyword) == named.end())
    named.push_back(keyword);
}

class ObjPartReader {
 public:
  ObjPartReader(std::string_view text, std::string_view name, std::size_t first_line)
      : text_(text, name, first_line), first_line_(first_line) {}

  ObjPart read() {
    do statement(text_.word());
    while (text_.next_line());
    part_.lines = line();
    return std::move(part_);
  }

 private:
  [[nodiscard]] std::size_t line() const { return text_.line() - first_line_; }

  void statement(std::string_view word) {
    if (word.empty()) return;
    if (word == "v") return vertex();
    if (word == "f" || word == "fo") return element(part_.faces, obj_face);
    if (word == "l") return element(part_.wires, obj_wire);
    if (word == "p") return element(part_.marks, obj_point);
    if (word == "o") return part_.objects.push_back({part_.faces.ends.size(), text_.rest_of_line()});
    if (word == "g") return part_.groups.push_back({part_.faces.ends.size(), text_.rest_of_line()});
    static constexpr std::array<std::string_view, 6> silent{"vn", "vt", "vp", "s", "usemtl", "mtllib"};
    if (std::find(silent.begin(), silent.end(), word) == silent.end())
      join(part_.ignored, {{quoted(word)}, 1, line()}, 0);
  }

  void vertex() { part_.points.push_back(text_.point()); }

  void element(ObjElements& elements, const char* what) {
    while (true) {
      long long number = 0;
      if (text_.take(number)) {
        corner(number, elements, what);
        continue;
      }
      const std::string_view word = text_.word();
      if (word.empty()) break;
      // "7", "7/1", "7//3", "7/1/3": only the vertex is used.
      corner(text_.integer(word.substr(0, word.find('/')), "the number of the vertex"), elements, what);
    }
    elements.ends.push_back(static_cast<int>(elements.corners.size()));
  }

  // The vertex may be defined later.
  void corner(long long number, ObjElements& elements, const char* what) {
    if (number == 0) text_.fail(std::string(what) + " refers to vertex 0", "vertices are numbered from 1");
    if (number < 0) {
      elements.relative.push_back({elements.corners.size(), part_.points.size(), number, line()});
      elements.corners.push_back(0);  // until the parts are joined
      return;
    }
    if (number - 1 > elements.largest) {
      elements.largest = number - 1;
      elements.largest_line = line();
    }
    elements.corners.push_back(static_cast<int>(number - 1));
  }

  TextCursor text_;
  std::size_t first_line_;
  ObjPart part_;
};

}  // namespace

ObjPart read_obj_part(std::string_view text, std::string_view name, std::size_t first_line) {
  return ObjPartReader(text, name, first_line).read();
}

void join(ObjIgnored& ignored, const ObjIgnored& later, std::size_t lines_before) {
  if (ignored.lines == 0) ignored.first_line = lines_before + later.first_line;
  ignored.lines += later.lines;
  for (const std::string& keyword : later.keywords) add_keyword(ignored, keyword);
}

}  // namespace epura::mesh
