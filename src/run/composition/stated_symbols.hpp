// SPDX-License-Identifier: Apache-2.0
// Geometric tolerances and datums that model files require -> tolerance frames and datums as scenes have them.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "composition/stated_dimensions.hpp"

namespace epura::pipeline {

/// Chooses where frames and datums stand: in line with dimensions of the same faces that are straight, otherwise on
/// lines of their faces, or for frames on the faces, in the view that shows most of them.
class SymbolPlaces {
 public:
  explicit SymbolPlaces(const RequirementSubject& subject) : subject_(subject) {}

  /// A dimension of these faces that is straight.
  void add_dimension(const std::vector<int>& faces, const scene::DimensionDescription& dimension);

  /// What a view must show of the faces: anything of one, a line of one, for what holds all around, lines of all, or
  /// for straightness of round ones, their straight lines in true length (ISO 1101).
  enum class Ends { anything, line, lines_of_all, element };

  /// Returns whether there is a place. Sets the view, and the dimension or the end of the leader.
  bool place(scene::CalloutDescription& callout, const std::vector<int>& faces, Ends ends);

  /// The same at a point of an area on these faces, in a view that shows the area true.
  bool place_in_area(scene::CalloutDescription& callout, const std::vector<int>& faces, const Vec3& point) const;

  /// The same at an edge that consists of these lines, if possible in a view that shows a straight one as a point; for
  /// Ends::element, which needs the line, in another view.
  bool place_at_edge(scene::CalloutDescription& callout, const std::vector<std::array<double, 6>>& lines,
                     Ends ends) const;

 private:
  struct Attachment {
    std::string dimension, view;
    int ends = 2;  ///< left free
  };

  const RequirementSubject& subject_;
  std::map<std::vector<int>, Attachment> dimensions_{};
  std::map<std::string, std::vector<Vec3>> taken_{};  ///< ends of leaders, by view
};

/// The tolerances of `all` that one frame shows: those of the same faces or edge stand below each other, composite ones
/// below theirs; straightness alone, since it needs a view that shows its lines true. Numbers of requirements, in their
/// order.
std::vector<std::vector<std::size_t>> stacks_of(const std::vector<importer::ModelRequirement>& all);

/// Writes a stack; the numbers and sentences of those that have no frame are added to `refused`.
scene::ToleranceFrame frame_of(const std::vector<importer::ModelRequirement>& all, std::vector<std::size_t>& stack,
                               const RequirementSubject& subject,
                               std::vector<std::pair<std::size_t, std::string>>& refused);

}  // namespace epura::pipeline
