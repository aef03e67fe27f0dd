// SPDX-License-Identifier: Apache-2.0
// Reads Geomview's Object File Format: [ST][C][N]OFF, counts, one vertex per line, one face per line.
// Format: http://www.geomview.org/docs/html/OFF.html
#include "base/text.hpp"
#include "mesh/bytes.hpp"
#include "mesh/read.hpp"
#include "mesh/text_cursor.hpp"

namespace epura::mesh {

namespace {

struct Counts {
  long long vertices;
  long long faces;
};

// The keyword may be missing; letters before "OFF" state what a vertex line contains after the coordinates.
void read_keyword(TextCursor& text) {
  const TextCursor before = text;
  const std::string_view word = text.word_of_any_line(), keyword = off_keyword(word);
  if (keyword.empty()) {
    if (word.empty() || !parse_integer(word)) text.fail("does not begin with 'OFF'");
    text = before;
    return;
  }
  if (keyword.find_first_of("4n") != std::string_view::npos)
    text.fail(quoted(keyword) + " has vertices that are not three-dimensional");
  text.put_back(word.size() - keyword.size());
  const TextCursor behind = text;
  if (text.word() == "BINARY") text.fail("binary OFF is not supported", "save it as text OFF or as PLY");
  text = behind;
}

Counts read_counts(TextCursor& text) {
  Counts counts{};
  for (long long* count : {&counts.vertices, &counts.faces}) {
    const std::string what = count == &counts.vertices ? "vertices" : "faces";
    *count = text.integer(text.word_of_any_line(), "the number of " + what);
    // A vertex takes at least six bytes and a face two; this check prevents a wrong count from exhausting the memory.
    const long long min_bytes = count == &counts.vertices ? 6 : 2;
    const auto max = static_cast<long long>(text.bytes_left() / min_bytes) + 1;
    if (*count < 0 || *count > max)
      text.fail("the file is too short for the " + std::to_string(*count) + " " + what + " that its header announces");
  }
  // The number of edges, which is not needed, follows here, alone on the next line, or not at all.
  if (!text.word().empty()) return counts;
  const TextCursor before = text;
  text.word_of_any_line();
  if (!text.word().empty()) text = before;
  return counts;
}

std::string_view expect_word(TextCursor& text, const char* what, long long done, long long count) {
  const std::string_view word = text.word_of_any_line();
  if (word.empty())
    text.fail(std::string("the file ends at ") + what + " " + std::to_string(done + 1) + " of " +
              std::to_string(count));
  return word;
}

void read_vertices(TextCursor& text, Soup& soup, long long count, Pace& pace) {
  soup.points.resize(static_cast<std::size_t>(count));
  for (long long v = 0; v < count; ++v) {
    auto& point = soup.points[static_cast<std::size_t>(v)];
    const auto next = [&] {
      double number = 0;
      return text.take(number) ? number : text.number(expect_word(text, "vertex", v, count));
    };
    point[0] = next();
    const TextCursor first_line = text;
    for (const std::size_t axis : {1, 2}) point[axis] = next();
    // A vertex may continue on the next line; but if that line holds more numbers, they belong to the next vertex.
    if (text.line() != first_line.line() && !text.word().empty())
      first_line.fail("a coordinate of the vertex is missing");
    text.next_line();
    pace.left(text.bytes_left());
  }
}

void read_faces(TextCursor& text, Soup& soup, long long count, Pace& pace) {
  soup.corners.reserve(static_cast<std::size_t>(3 * count));
  soup.face_ends.reserve(static_cast<std::size_t>(count));
  for (long long f = 0; f < count; ++f) {
    const auto next = [&] {
      long long number = 0;
      return text.take(number) ? number : text.integer(expect_word(text, "face", f, count));
    };
    const long long corners = next();
    if (corners < 0 || corners > static_cast<long long>(text.bytes_left()))
      text.fail("a face cannot have " + std::to_string(corners) + " corners");
    for (long long k = 0; k < corners; ++k) {
      const long long index = next();
      if (index < 0 || index >= static_cast<long long>(soup.points.size()))
        text.fail("a face refers to vertex " + std::to_string(index) + ", but there are " +
                      std::to_string(soup.points.size()),
                  "vertices are numbered from 0");
      soup.corners.push_back(static_cast<int>(index));
    }
    // Faces with two corners are lines, those with one are points.
    if (corners == 2) {
      soup.add_wire(std::vector<int>(soup.corners.end() - 2, soup.corners.end()));
      soup.corners.resize(soup.corners.size() - 2);
      ++soup.wire_faces;
    }
    if (corners == 1) {
      soup.marked_points.push_back(soup.corners.back());
      soup.corners.pop_back();
      ++soup.wire_faces;
    }
    soup.end_face();
    text.next_line();
    pace.left(text.bytes_left());
  }
}

}  // namespace

std::string_view off_keyword(std::string_view word) {
  const std::string_view keyword = word.substr(0, word.find_first_of("0123456789", word.find("OFF")));
  const bool known = keyword.size() <= 8 && keyword.ends_with("OFF") &&
                     keyword.find_first_not_of("STCN4nOF") == std::string_view::npos;
  return known ? keyword : std::string_view();
}

Soup read_off(std::string_view bytes, std::string_view name, const Progress& progress) {
  Soup soup;
  soup.format = "off";
  soup.printed = true;
  TextCursor text(bytes, name);
  read_keyword(text);
  const Counts counts = read_counts(text);
  Pace pace(progress, text.bytes_left());
  read_vertices(text, soup, counts.vertices, pace);
  read_faces(text, soup, counts.faces, pace);
  return soup;
}

}  // namespace epura::mesh
