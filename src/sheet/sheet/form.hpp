// SPDX-License-Identifier: Apache-2.0
// Frames and title blocks that somebody drew as SVG, with texts that are fields; and logos.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/description.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"
#include "sheet/title_block.hpp"
#include "svg/artwork.hpp"

namespace epura::sheet {

/// A frame with a title block. Positions are millimetres on the sheet, whose size it gives.
struct Form {
  std::string where;  ///< name of its file
  svg::Artwork art;
  Rectangle drawing_area;                  ///< element "drawing-area"; else the margins of ISO 5457
  std::optional<Rectangle> title_block{};  ///< element "title-block"; else around the fields
  std::optional<Rectangle> symbol{};       ///< element "projection-symbol": where that is drawn
  std::optional<Rectangle> logo{};         ///< element "logo"
};

/// Throws Error{input}, with the line, for files that cannot be drawn, or whose only fields are misspelt.
std::shared_ptr<const Form> read_form(const scene::LocatedText& file);

/// What stands in the fields is fitted into the room up to the next lines of the form. Texts that are no fields stay.
struct DrawnForm {
  std::vector<Layer> layers;
  std::vector<std::string> warnings;
};
DrawnForm draw_form(const Form& form, const TitleBlock& block, const Lettering& lettering);

/// A picture for the title block: lines, or pixels.
struct Logo {
  std::string name;  ///< of its file
  svg::Artwork art{};
  std::shared_ptr<const std::string> png{};  ///< instead; bytes of the file
  Vec2 size{0, 0};                           ///< mm, or pixels
};

/// From a file .svg or .png. Throws Error{input} for others.
std::shared_ptr<const Logo> read_logo(const scene::LocatedText& file);

/// As large as fits into a box, in its middle.
std::vector<Layer> draw_logo(const Logo& logo, const Rectangle& box);

}  // namespace epura::sheet
