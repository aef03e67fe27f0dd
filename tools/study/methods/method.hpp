// SPDX-License-Identifier: Apache-2.0
// Hidden-line methods behind a common interface, each with the parameter that trades accuracy for time.
#pragma once

#include <string>
#include <string_view>

#include "visibility/visibility.hpp"

namespace epura::study {

enum class Algorithm {
  exact,        ///< signs of integers on the page grid (visibility.hpp)
  floats,       ///< the same with page coordinates and depth rounded to 32-bit floats
  sampled,      ///< points along the edges tested against the triangles, with changes between them bisected
  item_buffer,  ///< triangles rasterised with depth, edges walked from pixel to pixel
  none          ///< nothing is hidden
};

struct Method {
  Algorithm algorithm = Algorithm::exact;
  double bits = 30;      ///< exact: log2 of the number of grid cells across the window, an integer
  double density = 4;    ///< sampled: points per mm of paper
  double halvings = 48;  ///< sampled: bisections of a change, an integer; 0: midway between two points
  double dpi = 600;      ///< item buffer: pixels per inch of paper

  bool operator==(const Method&) const = default;
};

/// NAME[:key=value]..., such as "exact", "exact:bits=24", "float", "sampled:density=4:halvings=20",
/// "item-buffer:dpi=600" or "none". Throws Error{input} that names `where`.
Method parse_method(std::string_view text, const std::string& where);

/// "sampled", and "density=4": parameters used only in experiments are omitted if they have their usual values.
std::string name_of(Algorithm algorithm);
std::string parameters_of(const Method& method);
/// Both, in the form that parse_method reads.
std::string text_of(const Method& method);

/// Computes hidden spans by any method. A view unit is `mm` mm long on paper.
visibility::HiddenSpans find_hidden(const world::World& world, const view::ProjectedScene& view,
                                    const edges::FeatureEdges& drawn, const Method& method, double mm);

}  // namespace epura::study
