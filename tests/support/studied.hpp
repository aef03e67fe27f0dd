// SPDX-License-Identifier: Apache-2.0
// Views for tests of `explain`, made without files and plugins.
#pragma once

#include "explain/subject.hpp"
#include "shapes.hpp"

namespace epura::test {

/// A view with the data to which an ExplainInput refers. The paper is the page in view units.
struct Studied {
  Result result;
  edges::EdgeOptions options;
  view::PaperMap paper;

  [[nodiscard]] explain::ExplainInput view() const {
    return {{result.world, result.view, result.drawn, result.hidden}, options, paper, result.drawing, true};
  }
};

inline Studied study(world::World world, const projection::Projection& projection,
                     const edges::EdgeOptions& options = {}, const view::ViewLimits& limits = {}) {
  Result result = draw(std::move(world), projection, options, limits);
  return {std::move(result), options, {1, Vec2(0)}};
}

}  // namespace epura::test
