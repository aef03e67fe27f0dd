// SPDX-License-Identifier: Apache-2.0
// Drawing files -> pictures.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "compare/picture.hpp"
#include "report/report.hpp"

namespace epura::compare {

struct PictureFile {
  bool is_json = false;  ///< views without their sheet: no frame, no hatching, no lines of dimensions
  bool is_pdf = false;   ///< texts are divided where their letters are apart, and dash patterns are unknown
  std::vector<Picture> pages{};
  bool is_in_place = false;  ///< what has not changed in space stands where it stands in the other file
  std::vector<report::RequirementRow> requirements{};  ///< of models that were drawn to be compared
};

/// Whether a file is a readable drawing, by its extension.
bool is_drawing(const std::filesystem::path& path);

/// Throws Error{input} for other files.
void expect_drawing(const std::filesystem::path& path);

/// Reads drawing JSON, SVG or PDF written by epura, by extension. Throws Error{input} for everything else.
PictureFile read_pictures(const std::filesystem::path& path);

/// The same for the bytes of a file with that name, which ends in .json, .svg or .pdf.
PictureFile pictures_of(const std::string& bytes, const std::filesystem::path& path);

/// Drawing JSON, schema 1. `where` names it in errors. Visible lines count as wide, hidden ones as dashed and narrow;
/// edges between smooth faces as narrow. Texts are those of its annotations, as high as those of most dimensions.
Picture picture_of_json(std::string_view bytes, const std::string& where);

/// What models require, and where the drawing shows it, of drawing JSON, schema 1. Throws Error{input}.
std::vector<report::RequirementRow> requirements_of_json(std::string_view bytes, const std::string& where);

/// SVG with a user unit of one millimetre. Dashes are those of the line style: how they are fitted to a line does not
/// matter.
Picture picture_of_svg(std::string_view bytes, const std::string& where);

/// The pages of a PDF file. In layers of hidden lines, centre lines and neighbouring parts, all lines
/// count as broken: short ones have no dashes.
std::vector<Picture> pictures_of_pdf(const std::string& bytes, const std::string& where);

}  // namespace epura::compare
