// SPDX-License-Identifier: Apache-2.0
// Ways to decide what is hidden behind one interface, each with the parameter that trades error for time.
#pragma once

#include <string>
#include <string_view>

#include "visibility/visibility.hpp"

namespace epura::study {

enum class Algorithm {
  exact,        ///< signs of whole numbers on the page grid (visibility.hpp)
  floats,       ///< the same with page coordinates and depth rounded to 32-bit floats
  sampled,      ///< points along the edges looked up among the triangles, changes between them bisected
  item_buffer,  ///< triangles rasterised with depth, edges walked from pixel to pixel
  none          ///< nothing is hidden
};

struct Method {
  Algorithm algorithm = Algorithm::exact;
  double bits = 30;      ///< exact: log2 of the grid's cells across the window, a whole number
  double density = 4;    ///< sampled: points per mm of paper
  double halvings = 48;  ///< sampled: bisections of a change, a whole number; 0: in the middle between two points
  double dpi = 600;      ///< item buffer: pixels per inch of paper

  bool operator==(const Method&) const = default;
};

/// NAME[:key=value]..., such as "exact", "exact:bits=24", "float", "sampled:density=4:halvings=20",
/// "item-buffer:dpi=600" or "none". Throws Error{input} that names `where`.
Method parse_method(std::string_view text, const std::string& where);

/// "sampled", and "density=4": parameters that only experiments set are left out where they stand as usual.
std::string name_of(Algorithm algorithm);
std::string parameters_of(const Method& method);
/// Both, as parse_method reads them.
std::string text_of(const Method& method);

/// Decides by any method. `mm` of paper are a view unit long.
visibility::HiddenSpans find_hidden(const scene::World& world, const view::ProjectedScene& view,
                                    const edges::FeatureEdges& drawn, const Method& method, double mm);

}  // namespace epura::study
