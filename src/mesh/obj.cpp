// Wavefront OBJ: v, f, o and g; the rest says nothing about surfaces.
#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>

#include "mesh/read.hpp"
#include "mesh/text_cursor.hpp"

namespace epura {

namespace {

// Faces by the name last given. A name that comes again means the same group.
class Groups {
 public:
  void begin(std::string_view name) {
    name_ = name.empty() ? "default" : name;
    current_ = -1;
  }
  void add_face() {
    // Numbered by the first face and not by the statement, so that names without faces do not count.
    if (current_ < 0) {
      const auto [entry, fresh] = numbers_.try_emplace(name_, static_cast<int>(names.size()));
      if (fresh) names.push_back(name_);
      current_ = entry->second;
    }
    of_face.push_back(current_);
  }

  std::vector<std::string> names;
  std::vector<int> of_face;

 private:
  std::string name_ = "default";
  int current_ = -1;
  std::unordered_map<std::string, int> numbers_;
};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, std::string_view name) : text_(bytes, name), name_(name) {}

  Soup read() {
    soup_.format = "obj";
    soup_.printed = true;
    do statement(text_.word());
    while (text_.next_line());
    if (largest_ >= static_cast<long long>(soup_.points.size())) fail_out_of_range(largest_ + 1, largest_line_);
    take_bodies();
    note_ignored();
    return std::move(soup_);
  }

 private:
  void statement(std::string_view word) {
    if (word.empty()) return;
    if (word == "v") return vertex();
    if (word == "f" || word == "fo") return face();
    if (word == "o") return objects_.begin(text_.rest_of_line());
    if (word == "g") return groups_.begin(text_.rest_of_line());
    static constexpr std::array<std::string_view, 6> silent{"vn", "vt", "vp", "s", "usemtl", "mtllib"};
    if (std::find(silent.begin(), silent.end(), word) == silent.end()) ignore(word);
  }

  void vertex() {
    std::array<double, 3> point;
    for (double& x : point) x = text_.number(text_.word());
    soup_.points.push_back(point);
  }

  void face() {
    for (std::string_view word = text_.word(); !word.empty(); word = text_.word()) corner(word);
    soup_.end_face();
    objects_.add_face();
    groups_.add_face();
  }

  // "7", "7/1", "7//3", "7/1/3": only the vertex matters. Negative numbers count back from the last vertex.
  void corner(std::string_view word) {
    const long long number = text_.integer(word.substr(0, word.find('/')));
    const auto count = static_cast<long long>(soup_.points.size());
    if (number == 0) text_.fail("a face refers to vertex 0", "vertices are numbered from 1");
    const long long index = number > 0 ? number - 1 : count + number;
    if (index < 0) fail_out_of_range(number, text_.line());
    if (index >= count && index > largest_) {  // legal if the vertex comes later
      largest_ = index;
      largest_line_ = text_.line();
    }
    soup_.corners.push_back(static_cast<int>(index));
  }

  [[noreturn]] void fail_out_of_range(long long number, std::size_t line) const {
    TextCursor("", name_, line)
        .fail("a face refers to vertex " + std::to_string(number) + ", but there are " +
              std::to_string(soup_.points.size()) + (number < 0 ? " before it" : ""));
  }

  void take_bodies() {
    Groups& chosen = objects_.names.size() > 1 ? objects_ : groups_;
    if (chosen.names.size() < 2) return;
    soup_.face_body = std::move(chosen.of_face);
    soup_.body_names = std::move(chosen.names);
  }

  void ignore(std::string_view word) {
    const std::string keyword = quoted(word);
    if (ignored_lines_++ == 0) ignored_line_ = text_.line();
    const bool known = std::find(ignored_.begin(), ignored_.end(), keyword) != ignored_.end();
    if (!known && ignored_.size() < 5) ignored_.push_back(keyword);
  }

  void note_ignored() {
    if (ignored_lines_ == 0) return;
    std::string list;
    for (const std::string& keyword : ignored_) list += (list.empty() ? "" : ", ") + keyword;
    soup_.notes.push_back("ignored " + std::to_string(ignored_lines_) + " lines of other kinds (" + list +
                          "), the first of them line " + std::to_string(ignored_line_));
  }

  TextCursor text_;
  std::string_view name_;
  Soup soup_;
  Groups objects_, groups_;
  long long largest_ = -1;        // the largest vertex that was not yet there when a face named it
  std::size_t largest_line_ = 0;  // and where that was
  std::vector<std::string> ignored_;
  std::size_t ignored_lines_ = 0, ignored_line_ = 0;
};

}  // namespace

Soup read_obj(std::string_view bytes, std::string_view name) { return ObjReader(bytes, name).read(); }

}  // namespace epura
