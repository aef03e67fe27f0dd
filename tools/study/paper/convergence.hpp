// SPDX-License-Identifier: Apache-2.0
// Error on paper of the whole way from a mesh to its drawing, against known lines, over the fineness of the mesh.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "projection/projection.hpp"
#include "report/error_budget.hpp"
#include "scene/description.hpp"
#include "study/paper/closed_forms.hpp"
#include "study/paper/rival.hpp"

namespace epura::study {

/// Visible lines in space.
struct TrueLines {
  std::vector<std::vector<Vec3>> drawn;
  std::vector<std::vector<Vec3>> optional{};  ///< a drawing may have them: edges between faces that continue each other
};

/// Bodies with known surfaces in one view.
struct PaperScene {
  std::string name;
  std::string projection;  ///< as on the command line
  /// The meshes, with about `around` facets around a circle as large as the bodies.
  std::function<std::vector<mesh::Soup>(int around)> meshes;
  /// As polylines, each whole line with this number of points.
  std::function<TrueLines(const projection::Projection&, int points)> lines;
  /// Files instead of meshes, if there are any.
  std::vector<scene::ModelDescription> files{};
  /// The surfaces, turned by a matrix, for rivals that draw them; may be empty.
  std::function<std::string(const Mat3& turn)> describe{};
  int coarsest = 12;       ///< fineness from which facets are crossed as their surfaces are
  bool has_cusps = false;  ///< contours end where they point at the viewer: those of facets end up to a facet away
  double share = 1;        ///< errors are those of this share of the length of lines

  [[nodiscard]] bool is_central() const { return projection.starts_with("look-at"); }
};

PaperScene scene_of(const ClosedForm& form);

/// The distances between drawn and true visible lines, mm on paper.
struct PaperError {
  double drawn = 0;            ///< farthest point of a drawn line from the true ones, or of a share of their length
  double truth = 0;            ///< the same of true lines from the drawn ones
  double missed = 0;           ///< length of true lines that are farther from drawn ones than the budget
  double phantom = 0;          ///< length of drawn lines that are farther from true ones than the budget
  report::ViewError budget{};  ///< as the drawing reports it

  [[nodiscard]] double ink() const { return std::max(drawn, truth); }
};

struct PaperRun {
  int around;
  int triangles = 0;
  PaperError error;
  std::vector<double> seconds{};  ///< from the mesh in memory to the lines on paper
  Mat4 world_to_page{1};          ///< of the view; its rows have mm on paper
  projection::Projection projection{};
  bool on_front = false;  ///< no other run of the scene is both faster and better
};

/// A scene with one way to draw it.
struct PaperSeries {
  std::string scene;
  std::string way;  ///< one of paper_ways, or the name of a rival
  std::vector<PaperRun> runs{};
  double share = 1;  ///< of the scene
  /// The order of convergence: the slope of the error over the length of facets, over the finer half of the runs.
  [[nodiscard]] double order() const;
};

/// Ways to draw a scene: with its surfaces recognised, or its triangles as they are; or recognised with arcs instead
/// of their chords (`--arcs`).
enum class PaperWay { recognised, triangles, arcs };
inline constexpr std::array paper_ways{"surfaces recognised", "triangles alone", "recognised with arcs"};

/// How scenes are drawn and compared.
struct PaperStudy {
  std::vector<std::filesystem::path> plugin_path;
  int points = 4096;  ///< on each true line
  std::vector<Rival> rivals{};
};

/// Draws a scene once. With `max_error`, as --max-error does; throws Error if that refuses.
PaperRun draw_on_paper(const PaperScene& scene, int around, PaperWay way, const PaperStudy& study,
                       std::optional<double> max_error = {});

/// The same, compared with the lines of another body.
PaperRun compare_on_paper(const PaperScene& scene, const PaperScene& truth_of, int around, PaperWay way,
                          const PaperStudy& study, std::optional<double> max_error = {});

/// Draws each scene in all ways and, in parallel views, by all rivals that can, at each fineness from its coarsest on:
/// `runs` times, in turns, so that other load on the machine affects all alike. The first of the runs is compared with
/// the truth.
std::vector<PaperSeries> measure_paper(const std::vector<PaperScene>& scenes, const std::vector<int>& finenesses,
                                       int runs, const PaperStudy& study, const Progress& progress);

}  // namespace epura::study
