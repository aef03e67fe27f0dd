// SPDX-License-Identifier: Apache-2.0
#include "pipeline/within_error.hpp"

#include <optional>

#include "mesh/read.hpp"
#include "pipeline/read_models.hpp"

namespace epura::pipeline {

Facets facets_of(const std::vector<mesh::MeshReport>& meshes) {
  Facets facets{};
  for (const mesh::MeshReport& mesh : meshes) {
    facets.triangles += static_cast<double>(mesh.triangles);
    facets.is_imported = facets.is_imported || (!mesh.format.empty() && mesh::format_named(mesh.format) == nullptr);
  }
  return facets;
}

DrawnScene draw_within_error(double max_error, double certain, const Messages& messages, const DrawWithFacets& draw) {
  constexpr double finer = 4;  // each time
  expect_certain(max_error, certain);
  std::optional<TooFar> last, best;
  for (double facets = usual_facets;;) {
    HeldMessages held;
    try {
      DrawnScene drawn = draw(facets, held.messages());
      held.tell(messages);
      return drawn;
    } catch (const TooFar& attempt) {
      if (!best || attempt.least < best->least) best = attempt;
      const double factor = attempt.beyond_facets > max_error ? 1 : finer_by(attempt, last, finer);
      if (factor == 1) {
        held.tell(messages);
        refuse(max_error, *best);
      }
      facets /= factor;
      last = attempt;
    } catch (const Error&) {
      held.tell(messages);
      if (best) refuse(max_error, *best);  // too much for the importer
      throw;
    } catch (...) {
      held.tell(messages);
      throw;
    }
  }
}

}  // namespace epura::pipeline
