// Spans -> ink on paper.
#pragma once

#include <string>

#include "drawing/drawing.hpp"
#include "view/paper_map.hpp"
#include "visibility/visibility.hpp"

namespace epura {

struct DrawingWishes {
  std::string name;    ///< of the view
  bool hidden = true;  ///< keep hidden lines
};

Drawing make_drawing(const World& world, const View& view, const DrawnEdges& drawn, const HiddenSpans& hidden,
                     const Contact& contact, const PaperMap& paper, const DrawingWishes& wishes);

}  // namespace epura
