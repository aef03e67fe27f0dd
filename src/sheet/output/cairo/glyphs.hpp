// SPDX-License-Identifier: Apache-2.0
// Lettering on Cairo surfaces.
#pragma once

#include <cairo.h>

#include <cstddef>
#include <functional>

#include "output/cairo/canvas.hpp"
#include "output/of_sheet.hpp"
#include "sheet/lettering.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

/// Draws the texts of a layer as text, which vector files keep as such, with the font embedded.
void write_texts(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer, const sheet::Lettering& lettering);

/// The same; `before` is called before each text, with its number, while nothing of another one is open.
void write_texts_one_by_one(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer,
                            const sheet::Lettering& lettering, const std::function<void(std::size_t)>& before);

/// Draws them as filled outlines: no font is needed to view them.
void fill_texts(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer, const sheet::Lettering& lettering);

/// Fills the areas of a layer.
void draw_fills(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer);

}  // namespace epura::output
