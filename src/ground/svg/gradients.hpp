// SPDX-License-Identifier: Apache-2.0
// Gradients of an SVG document, each as one colour.
#pragma once

#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "base/colour.hpp"

namespace epura::svg {

/// A colour and how much of it covers what is below, 0 to 1.
struct Paint {
  Colour colour;
  double alpha = 1;
};

/// What is seen of a paint on white paper.
Colour on_white(const Paint& paint);

/// "0.5" or "50%"; nothing for other texts and numbers outside of 0 to 1.
std::optional<double> alpha_of(std::string_view text);

using Gradients = std::map<std::string, Paint, std::less<>>;

/// The middle of each linear and radial gradient, halfway between its ends, by its id. Those without stops take over
/// the ones that they refer to. SVG 1.1, 13.2.
Gradients gradients_of(const pugi::xml_node& svg);

/// The id in "url(#id)"; empty for other texts.
std::string_view referenced_id(std::string_view paint);

}  // namespace epura::svg
