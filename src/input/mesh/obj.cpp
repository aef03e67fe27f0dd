// SPDX-License-Identifier: Apache-2.0
// Reads Wavefront OBJ: v, f, l, p, o and g; other lines describe no surfaces, wires or points.
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "mesh/obj_part.hpp"
#include "mesh/read.hpp"
#include "mesh/text_cursor.hpp"

namespace epura::mesh {

namespace {

constexpr std::size_t part_bytes = 1 << 18;

// Cuts after line ends; a line that is continued by a backslash is not divided.
std::vector<std::string_view> cut_in_parts(std::string_view text) {
  std::vector<std::string_view> parts;
  while (text.size() > part_bytes) {
    const auto goes_on = [&](std::size_t end) { return text[end - (text[end - 1] == '\r' ? 2 : 1)] == '\\'; };
    std::size_t end = text.find('\n', part_bytes);
    while (end != std::string_view::npos && goes_on(end)) end = text.find('\n', end + 1);
    if (end == std::string_view::npos) break;
    parts.push_back(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

/// Nothing for a part with an error, whose line number is not known yet.
std::vector<std::optional<ObjPart>> read_parts(const std::vector<std::string_view>& texts, const Progress& progress) {
  std::vector<std::optional<ObjPart>> parts(texts.size());
  parallel_for(texts.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      try {
        parts[i] = read_obj_part(texts[i], "", 1);
      } catch (const Error&) {
      }
      progress.advance(texts[i].size());
    }
  });
  return parts;
}

struct ObjBodies {
  std::vector<std::string> names;
  std::vector<int> of_face;
};

/// Assigns faces to the name given last. A repeated name denotes the same body; a name without faces denotes none.
ObjBodies bodies_by(const std::vector<ObjNaming>& namings, std::size_t faces) {
  ObjBodies bodies;
  std::unordered_map<std::string_view, int> numbers;
  const auto give = [&](std::string_view name, std::size_t end) {
    if (end == bodies.of_face.size()) return;
    if (name.empty()) name = "default";
    const auto [entry, fresh] = numbers.try_emplace(name, static_cast<int>(bodies.names.size()));
    if (fresh) bodies.names.emplace_back(name);
    bodies.of_face.resize(end, entry->second);
  };
  std::string_view name;
  for (const ObjNaming& next : namings) give(std::exchange(name, next.name), next.first_face);
  give(name, faces);
  return bodies;
}

/// Joins the elements of one kind from all parts.
class ObjElementJoiner {
 public:
  ObjElementJoiner(std::string_view name, const char* what) : name_(name), what_(what) {}

  void reserve(std::size_t corners, std::size_t elements) {
    corners_.reserve(corners);
    ends_.reserve(elements);
  }

  /// `vertices` precede the part, which begins in line `first_line`.
  void add(ObjElements elements, long long vertices, std::size_t first_line) {
    for (const ObjRelativeCorner& corner : elements.relative) {
      const long long before = vertices + static_cast<long long>(corner.vertices_before);
      if (before + corner.number < 0) fail_out_of_range(corner.number, before, first_line + corner.line);
      elements.corners[corner.corner] = static_cast<int>(before + corner.number);
    }
    if (elements.largest > largest_) {
      largest_ = elements.largest;
      largest_line_ = first_line + elements.largest_line;
    }
    const std::size_t corners = corners_.size();
    for (const int end : elements.ends) ends_.push_back(static_cast<int>(corners + static_cast<std::size_t>(end)));
    corners_.insert(corners_.end(), elements.corners.begin(), elements.corners.end());
  }

  void expect_vertices(long long count) const {
    if (largest_ >= count) fail_out_of_range(largest_ + 1, count, largest_line_);
  }

  [[nodiscard]] std::vector<int>& corners() { return corners_; }
  [[nodiscard]] std::vector<int>& ends() { return ends_; }

 private:
  [[noreturn]] void fail_out_of_range(long long number, long long count, std::size_t line) const {
    TextCursor("", name_, line)
        .fail(std::string(what_) + " refers to vertex " + std::to_string(number) + ", but there are " +
              std::to_string(count) + (number < 0 ? " before it" : ""));
  }

  std::string_view name_;
  const char* what_;
  std::vector<int> corners_, ends_;
  long long largest_ = -1;        // largest vertex number of an element
  std::size_t largest_line_ = 0;  // line where it occurs first
};

/// Joins the parts of a file in order.
class ObjJoiner {
 public:
  /// Reserves memory for all of `parts`.
  ObjJoiner(std::string_view name, const std::vector<std::optional<ObjPart>>& parts)
      : faces_(name, obj_face), wires_(name, obj_wire), marks_(name, obj_point) {
    std::size_t points = 0, corners = 0, faces = 0;
    for (const std::optional<ObjPart>& part : parts) {
      if (!part) continue;
      points += part->points.size();
      corners += part->faces.corners.size();
      faces += part->faces.ends.size();
    }
    soup_.points.reserve(points);
    faces_.reserve(corners, faces);
  }

  void add(ObjPart part) {
    add_names(objects_, part.objects);
    add_names(groups_, part.groups);
    join(ignored_, part.ignored, lines_);
    faces_.add(std::move(part.faces), count(), line());
    wires_.add(std::move(part.wires), count(), line());
    marks_.add(std::move(part.marks), count(), line());
    soup_.points.insert(soup_.points.end(), part.points.begin(), part.points.end());
    lines_ += part.lines;
  }

  /// Returns the number of the line after the parts added so far.
  [[nodiscard]] std::size_t line() const { return 1 + lines_; }

  Soup finish() {
    faces_.expect_vertices(count());
    wires_.expect_vertices(count());
    marks_.expect_vertices(count());
    soup_.corners = std::move(faces_.corners());
    soup_.face_ends = std::move(faces_.ends());
    take_wires();
    soup_.marked_points = std::move(marks_.corners());
    take_bodies();
    note_ignored();
    soup_.format = "obj";
    soup_.printed = true;
    return std::move(soup_);
  }

 private:
  [[nodiscard]] long long count() const { return static_cast<long long>(soup_.points.size()); }

  void take_wires() {
    int begin = 0;
    for (const int end : wires_.ends()) {
      soup_.add_wire(std::span(wires_.corners().data() + begin, static_cast<std::size_t>(end - begin)));
      begin = end;
    }
  }

  void add_names(std::vector<ObjNaming>& all, const std::vector<ObjNaming>& of_part) {
    for (const ObjNaming& naming : of_part) all.push_back({faces_.ends().size() + naming.first_face, naming.name});
  }

  void take_bodies() {
    const std::size_t faces = soup_.face_ends.size();
    ObjBodies bodies = bodies_by(objects_, faces);
    if (bodies.names.size() < 2 && (objects_.empty() || !groups_.empty())) {
      ObjBodies groups = bodies_by(groups_, faces);
      if (groups.names.size() > 1 || objects_.empty()) bodies = std::move(groups);
    }
    if (objects_.empty() && groups_.empty()) return;
    if (bodies.names.size() > 1) soup_.face_body = std::move(bodies.of_face);
    soup_.body_names = std::move(bodies.names);
  }

  void note_ignored() {
    if (ignored_.lines == 0) return;
    std::string list;
    for (const std::string& keyword : ignored_.keywords) append_to_list(list, keyword);
    soup_.notes.push_back("ignored " + std::to_string(ignored_.lines) + " unsupported lines (" + list +
                          "), the first is line " + std::to_string(1 + ignored_.first_line));
  }

  Soup soup_;
  ObjElementJoiner faces_, wires_, marks_;
  std::vector<ObjNaming> objects_, groups_;
  ObjIgnored ignored_;
  std::size_t lines_ = 0;  // of the parts added so far
};

}  // namespace

Soup read_obj(std::string_view bytes, std::string_view name, const Progress& progress) {
  const std::vector<std::string_view> texts = cut_in_parts(bytes);
  std::vector<std::optional<ObjPart>> parts = read_parts(texts, progress);
  ObjJoiner joiner(name, parts);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    progress.expect_time();
    // A part with an error is read again from its beginning, to find the line number.
    if (!parts[i]) parts[i] = read_obj_part(texts[i], name, joiner.line());
    joiner.add(std::move(*parts[i]));
    parts[i].reset();
  }
  return joiner.finish();
}

}  // namespace epura::mesh
