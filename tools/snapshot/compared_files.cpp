// SPDX-License-Identifier: Apache-2.0
#include "snapshot/compared_files.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/describe.hpp"
#include "drawing/drawing.hpp"
#include "pipeline/draw_scene.hpp"
#include "pipeline/targets.hpp"
#include "sheet/standard_scale.hpp"

namespace epura {

namespace {

namespace fs = std::filesystem;

struct Drawn {
  compare::PictureFile pictures;  ///< one page for each sheet
  std::vector<pipeline::FinishedSheet> sheets;
  std::vector<report::RequirementRow> requirements;
};

scene::SceneDescription described(const std::string& file, const CompareOptions& options) {
  DrawOptions draw;
  draw.models = {file};
  draw.views = options.views;
  draw.run.allow_outside = options.allow_outside;
  return describe(draw);
}

/// `file` is the name of the file to which the drawing would be written.
Drawn draw_scene(const scene::SceneDescription& scene, const std::string& file, const CompareOptions& options,
                 const pipeline::Messages& messages) {
  pipeline::RunOptions run;
  run.plugin_path = options.plugin_path;
  run.allow_outside = options.allow_outside;
  run.keeps_drawings = true;
  pipeline::Stopwatch watch;
  pipeline::DrawnScene drawn = pipeline::draw_scene(scene, run, {messages, {}, watch});
  Drawn result{{}, std::move(drawn.sheets), drawn.report.requirements};
  const std::vector<pipeline::Target> target = pipeline::targets_of({file}, "");
  for (const pipeline::FileBytes& sheet : pipeline::encode_all(target, result.sheets, {}, drawn.report, {})) {
    compare::PictureFile read = compare::pictures_of(sheet.bytes, file);
    result.pictures.is_json = read.is_json;
    result.pictures.is_pdf = read.is_pdf;
    std::move(read.pages.begin(), read.pages.end(), std::back_inserter(result.pictures.pages));
  }
  return result;
}

pipeline::Messages warnings() {
  return {[](const std::string& sentence) { std::fprintf(stderr, "epura: %s\n", sentence.c_str()); },
          [](std::string_view) {}};
}

void set_scale(scene::SceneDescription& scene, double scale) {
  for (scene::SheetDescription& sheet : scene.sheets) sheet.scale = {scene::ScaleChoice{scale}, "--scale"};
}

// The shift from the page of the second view to that of the first one, if the views are otherwise equal.
Vec2 shift_between(const drawing::ViewDrawing& first, const drawing::ViewDrawing& second) {
  constexpr double rounding = 1e-12;
  const Mat4 one = first.world_to_page / first.world_to_page[3][3];
  const Mat4 other = second.world_to_page / second.world_to_page[3][3];
  for (int column = 0; column < 4; ++column)
    for (const int row : {0, 1, 3}) {
      const bool is_place = column == 3 && row < 3;
      if (!is_place && !(std::abs(one[column][row] - other[column][row]) <= rounding * glm::length(one[column])))
        return Vec2(0);
    }
  return Vec2(one[3] - other[3]);
}

void place_as(const Drawn& first, Drawn& second) {
  second.pictures.is_in_place = true;
  for (std::size_t page = 0; page < std::min(first.sheets.size(), second.sheets.size()); ++page) {
    const auto& views = first.sheets[page].drawings;
    const auto& others = second.sheets[page].drawings;
    compare::Picture& picture = second.pictures.pages[page];
    std::vector<Vec2> shifts(picture.views.size(), Vec2(0));
    for (std::size_t i = 0; i < std::min(views.size(), others.size()); ++i)
      if (views[i].name == others[i].name)
        shifts[static_cast<std::size_t>(compare::number_of_name(picture.views, others[i].name))] =
            shift_between(views[i], others[i]);
    for (compare::PicturePiece& piece : picture.pieces) {
      const Vec2& shift = shifts[static_cast<std::size_t>(piece.view)];
      piece.from += shift;
      piece.to += shift;
    }
  }
}

}  // namespace

std::array<compare::PictureFile, 2> pictures_to_compare(const CompareOptions& options) {
  const bool is_drawn = compare::is_drawing(options.before);
  if (is_drawn || compare::is_drawing(options.after)) {
    // A drawing made for comparison with a file has the content of a file in the same format.
    const fs::path like(is_drawn ? options.before : options.after);
    const auto read = [&](const std::string& file) {
      if (compare::is_drawing(file)) return compare::read_pictures(file);
      return draw_scene(described(file, options), "drawing" + like.extension().string(), options, warnings()).pictures;
    };
    return {read(options.before), read(options.after)};
  }
  scene::SceneDescription one = described(options.before, options), other = described(options.after, options);
  // Curved surfaces are divided into the same facets in both only if the scale is known before they are read.
  const char* const format = "drawing.json";
  const pipeline::Messages silent = pipeline::silent_messages();
  double scale = draw_scene(one, format, options, silent).sheets[0].scale;
  if (!one.sheets[0].scale.given()) scale = sheet::standard_scale_up_to(scale);
  set_scale(one, scale);
  set_scale(other, scale);
  Drawn before = draw_scene(one, format, options, warnings()), after = draw_scene(other, format, options, warnings());
  place_as(before, after);
  for (Drawn* const drawn : {&before, &after}) drawn->pictures.requirements = std::move(drawn->requirements);
  return {std::move(before.pictures), std::move(after.pictures)};
}

}  // namespace epura
