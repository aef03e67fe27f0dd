// SPDX-License-Identifier: Apache-2.0
// How bodies are drawn.
#pragma once

#include "base/colour.hpp"
#include "scene/choices.hpp"
#include "scene/located.hpp"

namespace epura::scene {

/// The colour of lines.
struct ColourChoice {
  bool of_file = false;  ///< that of the body in its file; if there is none, black
  Colour colour{};       ///< otherwise
};

/// How bodies with certain names are drawn, whatever their models and views say. Of several styles that match a body,
/// the last one that has a value counts.
struct StyleDescription {
  LocatedText match;  ///< names of bodies or models: * stands for any text, ? for one character, [ab] for a or b
  Located<LineRole> line;
  Located<HiddenLines> hidden;
  Located<ColourChoice> colour;
  Located<bool> cut;            ///< by sections; true by default
  Located<HatchPattern> hatch;  ///< general by default
  Located<double> hatch_angle;  ///< degrees counterclockwise; chosen by default
  Located<double> hatch_pitch;  ///< mm on paper; chosen by default
  Located<bool> drawn;          ///< true by default
  LocatedText material;         ///< for the parts list
  Located<double> density;      ///< kg/m³, for masses; by default that of the model
};

}  // namespace epura::scene
