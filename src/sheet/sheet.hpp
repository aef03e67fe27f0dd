// A sheet of paper with strokes on it: everything that a writer needs, nothing left to compute.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/vec.hpp"

namespace epura {

/// How a layer's lines look. ISO 128-2; lengths in millimetres of paper.
struct LineStyle {
  std::string name;  ///< class in SVG, such as "visible"
  double width;
  double dash = 0;  ///< 0: continuous
  double gap = 0;
};

/// One polyline in one go of the pen.
struct Stroke {
  std::vector<Vec2> points;  ///< y up, origin at the lower left corner of the sheet
  bool closed = false;
  double dash = 0;  ///< fitted to this stroke, so that it ends on dashes; 0: continuous
  double gap = 0;
  std::string kind;   ///< "contour", ...; several with spaces where a chain changes
  std::string edges;  ///< the model edges it draws: "model:v0-v1 ...", empty when it draws none
};

struct Layer {
  std::string name;  ///< "isometric/visible"
  LineStyle style;
  std::vector<Stroke> strokes;
};

struct Sheet {
  double width = 0, height = 0;  ///< mm
  std::string title;             ///< for the metadata of the file
  std::vector<Layer> layers;     ///< painted in order
};

}  // namespace epura
