// SPDX-License-Identifier: Apache-2.0
#include "mesh/read.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "mesh/build.hpp"
#include "mesh/bytes.hpp"
#include "mesh/text_cursor.hpp"

namespace epura::mesh {

namespace {

constexpr std::array<Format, 4> own_formats{{{"obj", "Wavefront OBJ: polygons, with groups as bodies", read_obj},
                                             {"stl", "STL, text and binary: triangles", read_stl},
                                             {"ply", "PLY, text and binary: polygons", read_ply},
                                             {"off", "OFF: polygons", read_off}}};

const Format* format_with_mark(std::string_view bytes) {
  const std::string_view first = TextCursor(bytes, "").word_of_any_line();
  if (first == "ply" && bytes.starts_with("ply")) return format_named("ply");
  if (!off_keyword(first).empty()) return format_named("off");
  return stl_kind(bytes) == StlKind::neither ? nullptr : format_named("stl");
}

// OBJ has no mark, but its files are text and usually begin with one of these words.
bool may_be_obj(std::string_view bytes) {
  constexpr std::size_t beginning = 512;
  if (bytes.substr(0, beginning).find('\0') != std::string_view::npos) return false;
  constexpr std::array<std::string_view, 10> words{"v", "vt", "vn", "o", "g", "f", "l", "s", "mtllib", "usemtl"};
  return std::find(words.begin(), words.end(), TextCursor(bytes, "").word_of_any_line()) != words.end();
}

/// The mark of a packed file, and the program that unpacks it.
struct Packing {
  std::string_view mark, program;
};
constexpr std::array<Packing, 5> packings{{{"\x1f\x8b", "gunzip"},
                                           {"PK\3\4", "unzip"},
                                           {"\xfd"
                                            "7zXZ",
                                            "unxz"},
                                           {"BZh", "bunzip2"},
                                           {"\x28\xb5\x2f\xfd", "unzstd"}}};

void refuse_packed(std::string_view bytes, const std::string& name) {
  for (const Packing& packing : packings)
    if (bytes.starts_with(packing.mark))
      throw Error(ErrorKind::input, name, "is packed", "unpack it first: " + std::string(packing.program) + " " + name);
}

const Format& format_of(std::string_view bytes, std::string_view extension, const std::string& name,
                        const std::string& others) {
  if (const Format* format = format_with_mark(bytes)) return *format;
  const Format* const named = format_named(extension);
  if ((named != nullptr || extension.empty()) && may_be_obj(bytes)) return *format_named("obj");
  if (named != nullptr) return *named;
  refuse_packed(bytes, name);
  std::string known;
  for (const Format& format : own_formats) known += (known.empty() ? "." : ", .") + std::string(format.name);
  throw Error(ErrorKind::input, name,
              extension.empty() ? "has no extension, so its format is unknown"
                                : "'." + std::string(extension) + "' is not a supported model format",
              "supported: " + known + (others.empty() ? "" : ", " + others));
}

Soup read_soup(std::string bytes, const std::string& name, const std::string& others, const Progress& progress) {
  if (bytes.empty()) throw Error(ErrorKind::input, name, "is empty");
  if (stl_kind(bytes) != StlKind::binary) bytes = without_byte_order_mark(std::move(bytes));

  const std::string dotted = to_lower(std::filesystem::path(name).extension().string());
  const std::string extension = dotted.empty() ? dotted : dotted.substr(1);
  const Format& format = format_of(bytes, extension, name, others);
  Soup soup = format.read(bytes, name, progress);
  if (format_named(extension) != nullptr && extension != soup.format)
    soup.notes.push_back("the file is named ." + extension + ", but holds " + soup.format);
  return soup;
}

[[noreturn]] void fail_with_nothing_to_draw(const MeshReport& report) {
  std::string reasons;
  const auto add = [&](int count, const std::string& reason) {
    if (count > 0) append_to_list(reasons, std::to_string(count) + " " + reason);
  };
  add(report.dropped_non_finite, "with coordinates that are not finite");
  add(report.dropped_degenerate, "with fewer than three distinct corners");
  throw Error(ErrorKind::input, report.name,
              reasons.empty() ? "holds no faces" : "none of its faces can be drawn: " + reasons,
              reasons.empty() && report.vertices > 0 ? "points at one place have no size" : "");
}

}  // namespace

std::span<const Format> formats() { return own_formats; }

const Format* format_named(std::string_view name) {
  const auto found =
      std::find_if(own_formats.begin(), own_formats.end(), [&](const Format& format) { return format.name == name; });
  return found == own_formats.end() ? nullptr : &*found;
}

const Format* format_in(std::string_view bytes) {
  if (const Format* format = format_with_mark(bytes)) return format;
  return may_be_obj(bytes) ? format_named("obj") : nullptr;
}

Mesh make_mesh(Soup soup, const std::string& name, const Progress& progress, std::optional<double> step) {
  // Half-edges, at most twice as many as corners, are numbered with int.
  if (soup.corners.size() > INT_MAX / 6 || soup.wires.size() > INT_MAX / 6 || soup.points.size() > INT_MAX)
    throw Error(ErrorKind::input, name, "has too many corners", "split the model");
  Mesh mesh = build_mesh(std::move(soup), name, progress, step);
  if (mesh.report.triangles == 0 && mesh.report.wires == 0) fail_with_nothing_to_draw(mesh.report);
  return mesh;
}

Mesh read_mesh(const std::filesystem::path& path, const Progress& progress, const std::string& others) {
  return read_mesh(read_file(path, progress), path.string(), progress, others);
}

Mesh read_mesh(std::string bytes, const std::string& name, const Progress& progress, const std::string& others) {
  const std::size_t size = bytes.size();
  Mesh mesh = make_mesh(read_soup(std::move(bytes), name, others, progress), name, progress);
  progress.advance(size);
  return mesh;
}

}  // namespace epura::mesh
