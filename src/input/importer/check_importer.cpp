// SPDX-License-Identifier: Apache-2.0
#include "importer/check_importer.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/temporary_folder.hpp"
#include "base/text.hpp"
#include "importer/assemble.hpp"
#include "mesh/read.hpp"

namespace epura::importer {

namespace {

namespace fs = std::filesystem;

class Checker {
 public:
  Checker(const ImporterEntry& importer, double seconds, const foreign::TellResult& tell)
      : importer_(importer),
        seconds_(seconds),
        tell_(tell),
        values_(foreign::flattened(foreign::default_values(importer.table.parameters))) {}

  std::vector<foreign::CheckResult> check(const std::vector<fs::path>& models) {
    const std::string name = "file." + (importer_.table.extensions.empty() ? "x" : importer_.table.extensions.front());
    expect("marks", "files of other formats are not taken for its own", [&] {
      for (const std::string_view other : others())
        if (importer_.recognises(other)) return std::string("takes '" + first_word(other) + "' for its own");
      return std::string();
    });
    expect("refuses", "files that hold nothing are refused with a sentence", [&] {
      for (const std::string_view other : others())
        if (const auto fault = fault_of_garbage(written(name, other))) return *fault;
      return std::string();
    });
    for (const fs::path& model : models)
      if (is_own(model)) check_model(model, name);
    return std::move(results_);
  }

 private:
  [[nodiscard]] fs::path written(const std::string& name, std::string_view bytes) const {
    write_file(scratch_ / name, bytes);
    return scratch_ / name;
  }

  static std::array<std::string_view, 4> others() {
    return {std::string_view(), std::string_view("\xff\xd8\xff\xe0\0\x10JFIF\0\1\1", 14),
            std::string_view("The quick brown fox jumps over the lazy dog.\n"),
            std::string_view("\0\0\0\0\0\0\0\0", 8)};
  }
  static std::string first_word(std::string_view bytes) {
    return bytes.empty() ? "an empty file" : printable_start(bytes);
  }
  static std::string printable_start(std::string_view bytes) {
    std::string text;
    for (const char c : bytes.substr(0, 12)) text += c >= ' ' && c <= '~' ? c : '.';
    return text;
  }

  // A library may have importers for several formats.
  bool is_own(const fs::path& model) {
    const auto& extensions = importer_.table.extensions;
    const std::string dotted = to_lower(model.extension().string());
    return !dotted.empty() && std::find(extensions.begin(), extensions.end(), dotted.substr(1)) != extensions.end();
  }

  void check_model(const fs::path& model, const std::string& name) {
    std::optional<ImportedFile> first;
    const std::string called = model.filename().string();
    expect("reads", called + " becomes a mesh", [&] {
      first = read(model);
      Assembled assembled = assemble(*first, importer_.table.name);
      mesh::make_mesh(std::move(assembled.soup), model.string(), {}, assembled.step);
      return std::string();
    });
    if (!first) return;
    expect("repeats", called + " is the same when it is read again", [&] {
      return are_same(*first, read(model)) ? std::string() : std::string("is another one the second time");
    });
    const std::string bytes = read_file(model);
    expect("survives", called + " cut short or damaged is read or refused", [&] {
      for (const std::size_t part : {1, 2, 3, 7}) {
        fault_of_garbage(written(name, std::string_view(bytes).substr(0, bytes.size() * part / 8)));
        std::string damaged = bytes;
        for (std::size_t i = damaged.size() * part / 8; i < damaged.size(); i += 997)
          damaged[i] = char(damaged[i] ^ 0x15);
        fault_of_garbage(written(name, damaged));
      }
      return std::string();
    });
  }

  // A correct importer answers with Error{input}.
  std::optional<std::string> fault_of_garbage(const fs::path& file) {
    try {
      const ImportedFile document = read(file);
      const bool is_empty = std::all_of(document.shapes.begin(), document.shapes.end(), [](const Shape& shape) {
        return shape.polygon_ends.empty() && shape.wire_ends.empty() && shape.marked_points.empty();
      });
      return is_empty ? std::nullopt
                      : std::optional<std::string>("makes faces, wires or points of a file that holds none");
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::input) throw;
      return std::nullopt;
    }
  }

  ImportedFile read(const fs::path& file) {
    ProgressBoard board;
    const Progress progress(board, seconds_);
    return importer_.read(
        {.path = file,
         .name = file.string(),
         .values = values_,
         .relative_tolerance = 1e-4,
         .is_confined = 1,
         .bounds = bounds_for(fs::file_size(file)),
         .readable = readable_for(file, false)},
        [](double) {}, progress);
  }

  static bool are_same(const ImportedFile& a, const ImportedFile& b) {
    const auto same_shape = [](const Shape& one, const Shape& two) {
      return one.name == two.name && one.points == two.points && one.corners == two.corners &&
             one.polygon_ends == two.polygon_ends && one.face_of_polygon == two.face_of_polygon &&
             one.body_of_polygon == two.body_of_polygon && one.body_names == two.body_names &&
             one.body_colours == two.body_colours && one.colour == two.colour &&
             one.edge_vertices == two.edge_vertices && one.wire_vertices == two.wire_vertices &&
             one.wire_ends == two.wire_ends && one.marked_points == two.marked_points;
    };
    const auto same_node = [](const Node& one, const Node& two) {
      return one.parent == two.parent && one.shape == two.shape && one.name == two.name &&
             one.transform == two.transform && one.colour == two.colour;
    };
    const auto same_requirement = [](const Requirement& one, const Requirement& two) {
      const auto same_number = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
      return one.kind == two.kind && one.bounds == two.bounds && one.is_angle == two.is_angle &&
             one.decimals == two.decimals && same_number(one.value, two.value) && same_number(one.lower, two.lower) &&
             same_number(one.upper, two.upper) && same_number(one.unit, two.unit) && one.id == two.id &&
             one.type == two.type && one.name == two.name && one.fit == two.fit && one.modifiers == two.modifiers &&
             one.zone == two.zone && one.datums == two.datums && one.above == two.above && one.missing == two.missing &&
             one.faces == two.faces && one.text == two.text && one.lines == two.lines && one.area == two.area;
    };
    const auto same_view = [](const SavedView& one, const SavedView& two) {
      return one.is_central == two.is_central && one.name == two.name && one.eye == two.eye &&
             one.towards == two.towards && one.up == two.up && one.planes == two.planes;
    };
    return a.unit == b.unit && a.is_y_up == b.is_y_up && std::ranges::equal(a.shapes, b.shapes, same_shape) &&
           std::ranges::equal(a.nodes, b.nodes, same_node) &&
           std::ranges::equal(a.requirements, b.requirements, same_requirement) &&
           std::ranges::equal(a.saved_views, b.saved_views, same_view) && a.standard == b.standard;
  }

  template <class Check>
  void expect(const std::string& name, const std::string& what, const Check& check) {
    foreign::CheckResult result{name, what, foreign::Verdict::passed, {}};
    try {
      result.fault = check();
    } catch (const OutOfTime&) {
      result.fault = "takes more than " + format_number(seconds_) + " s";
    } catch (const Error& error) {
      result.fault = error.what();
    }
    if (!result.fault.empty()) result.verdict = foreign::Verdict::failed;
    if (tell_) tell_(result);
    results_.push_back(std::move(result));
  }

  const ImporterEntry& importer_;
  const double seconds_;
  const foreign::TellResult& tell_;
  std::vector<double> values_;
  TemporaryFolder scratch_;
  std::vector<foreign::CheckResult> results_;
};

}  // namespace

std::vector<foreign::CheckResult> check_importer(const ImporterEntry& importer, const std::vector<fs::path>& models,
                                                 double seconds, const foreign::TellResult& tell) {
  return Checker(importer, seconds, tell).check(models);
}

}  // namespace epura::importer
