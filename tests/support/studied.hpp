// SPDX-License-Identifier: Apache-2.0
// Views to ask questions of, made without files and plugins.
#pragma once

#include "explain/explain_input.hpp"
#include "shapes.hpp"

namespace epura::test {

/// A view together with what a ExplainInput refers to. The paper is the page in view units.
struct Studied {
  Result result;
  EdgeOptions wishes;
  Contact contact;
  PaperMap paper;

  [[nodiscard]] ExplainInput view() const {
    return {result.world, result.view, wishes, result.drawn, result.hidden, contact, paper, result.drawing, true};
  }
};

inline Studied study(World world, const Projection& projection, const EdgeOptions& wishes = {},
                     const ViewLimits& limits = {}) {
  Result result = draw(std::move(world), projection, wishes, limits);
  const Contact contact = contact_of(result.world, result.view, std::nullopt);
  return {std::move(result), wishes, contact, {1, Vec2(0)}};
}

}  // namespace epura::test
