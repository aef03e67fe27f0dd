// SPDX-License-Identifier: Apache-2.0
// The library: from models to drawings, as `epura draw` makes them.
//
//   epura::Scene scene{.models = {{.file = "bracket.obj"}}, .views = {{.projection = "front"}}};
//   epura::write(epura::draw(scene), "bracket.pdf");
//
// find_package(epura COMPONENTS library) and link epura::library, or use pkg-config.
#pragma once

#include <array>
#include <epura/own_projection.hpp>
#include <epura/scene.hpp>
#include <epura/scene_value.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#define EPURA_PUBLIC __attribute__((visibility("default")))

namespace epura {

/// Any error that the caller can correct. The message contains place and reason. Places in a scene in memory are
/// written as its members: "views[1].parameters".
class EPURA_PUBLIC Failure : public std::runtime_error {
 public:
  /// Values are the exit codes of the program. `time`: `time_limit` left nothing to show; `stopped`: by Settings::stop.
  enum class Kind { input = 2, plugin = 3, output = 4, time = 5, broken = 70, stopped = 130 };

  Failure(Kind kind, std::string place, const std::string& message, std::string hint)
      : std::runtime_error(message), kind_(kind), place_(std::move(place)), hint_(std::move(hint)) {}

  [[nodiscard]] Kind kind() const noexcept { return kind_; }
  /// A file with line or byte, a member of the scene, or a plugin.
  [[nodiscard]] const std::string& place() const noexcept { return place_; }
  /// The remedy, if there is one.
  [[nodiscard]] const std::string& hint() const noexcept { return hint_; }

 private:
  Kind kind_;
  std::string place_, hint_;
};

/// Projection plugins whose processes stay from one drawing to the next: starting one takes ten times as long as a
/// small drawing. Each is read once. Copies share the processes, which end with the last copy. Thread-safe.
class EPURA_PUBLIC Plugins {
 public:
  class Content;
  Plugins();
  [[nodiscard]] Content& content() const noexcept { return *content_; }  ///< for the library itself

 private:
  std::shared_ptr<Content> content_;
};

/// Settings of a drawing.
struct Settings {
  std::optional<double> contact{};  ///< distance below which faces touch and do not hide; automatic by default
  bool wireframe = false;           ///< no hidden-line removal
  std::optional<double>
      max_error{};               ///< largest distance on paper of lines from those of the part, mm (docs/accuracy.md)
  bool error_note = false;       ///< state on the sheets how far lines may be from those of the part
  std::optional<double> arcs{};  ///< recognise arcs of circles and ellipses within this tolerance in mm
  bool centre_lines = false;     ///< add centre lines and axes of circular features
  std::optional<int> verify{};   ///< test the drawing at this number of random points, and its outline
  std::optional<double> time_limit{};                ///< seconds; draws the longest edges first
  int threads = 0;                                   ///< 0: all cores. For concurrent calls, the lowest number applies
  std::vector<std::filesystem::path> plugin_path{};  ///< additional folders with projection plugins
  std::optional<Plugins> plugins{};                  ///< for many drawings; otherwise, processes end with the call
  std::vector<OwnProjection> projections{};          ///< of this program, which views use by their names
  bool allow_outside = false;  ///< scene files and models may name files that do not lie below their folders
  /// Called when a stage begins and as it proceeds, with its name and the completed fraction, 0 to 1 (0 if unknown).
  /// May be called from any thread, but never concurrently.
  std::function<void(const std::string& stage, double done)> progress{};
  std::stop_token stop{};  ///< on request, the call soon throws Failure{stopped}
};

/// A straight segment of ink. Lengths on paper are in millimetres, y up, from the lower left corner of the sheet.
struct Line {
  std::array<double, 2> from, to;
  EdgeKind kind;
  bool visible;
  int model;                ///< index in Scene::models
  int body;                 ///< number of its body in the model; -1 if bodies have no names
  std::array<int, 2> edge;  ///< vertex numbers in the model; {-1, -1} for an intersection or a cut
  std::array<double, 2> t;  ///< parameters along that edge in space, `from` at t[0]; equal: a link to other ink
};

/// An arc in place of lines (Settings::arcs): centre + cos(a) u + sin(a) v for a between `from` and `to`, in radians.
/// For a circle, u and v have the same length; for an ellipse, they are its semi-axes.
struct Arc {
  std::array<double, 2> centre, u, v;
  double from, to;
  EdgeKind kind;
  bool visible;
};

/// A cause of error (docs/accuracy.md), and how far it may move lines on paper.
struct ErrorTerm {
  std::string term;  ///< "surface", "merging" ...
  double mm;
  std::string by;  ///< "bound", "measured" or "estimated"
};

/// How far the lines of a view may be from those of the part, on paper, before they are written to a file.
struct ErrorBudget {
  double total = 0;              ///< mm; the sum of the terms
  std::vector<ErrorTerm> terms;  ///< the largest first
};

struct DrawnView {
  std::string name, projection;
  int sheet;     ///< number of its sheet, from 1
  double scale;  ///< mm on paper per unit of the world, in the plane of projection
  /// Row order, for a world point as a column vector: position on the sheet = (row0/row3, row1/row3) in mm; row2/row3
  /// grows towards the viewer.
  std::array<double, 16> world_to_page;
  std::vector<Line> lines;
  std::vector<Arc> arcs;
  ErrorBudget error;
};

/// Pen strokes as they are written; the writers fit the dashes.
struct SheetLayer {
  std::string name;                                         ///< "front/visible"
  double width;                                             ///< mm
  std::vector<std::vector<std::array<double, 2>>> strokes;  ///< closed strokes end at their first point
};

/// The result: sheets with views. Cheap to copy: copies share their content, which is immutable.
class EPURA_PUBLIC Drawing {
 public:
  class Content;
  explicit Drawing(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

  [[nodiscard]] int sheets() const noexcept;
  [[nodiscard]] const std::vector<DrawnView>& views() const noexcept;
  /// The layers of a sheet in painting order. `sheet` counts from 1.
  [[nodiscard]] std::vector<SheetLayer> layers(int sheet = 1) const;
  /// One sentence each: repairs of models, and requests that could not be met.
  [[nodiscard]] const std::vector<std::string>& warnings() const noexcept;
  /// The stages that `time_limit` cut short; empty if the drawing is complete.
  [[nodiscard]] const std::vector<std::string>& cut_stages() const noexcept;
  /// Whether `verify` found an error; the JSON has the details.
  [[nodiscard]] bool is_wrong() const noexcept;
  [[nodiscard]] const Content& content() const noexcept { return *content_; }  ///< for the library itself

 private:
  std::shared_ptr<const Content> content_;
};

/// Draws a scene. Reads model files; does not write files, print, or handle signals. Thread-safe. Plugins are searched
/// next to the library and in the folders that the program searches; they run in separate processes. Throws Failure and
/// std::bad_alloc.
[[nodiscard]] EPURA_PUBLIC Drawing draw(const Scene& scene, const Settings& settings = {});

/// Draws a scene that is given in the words of scene files; relative paths start at the current folder.
[[nodiscard]] EPURA_PUBLIC Drawing draw(const SceneValue& scene, const std::vector<ModelSource>& sources,
                                        const Settings& settings = {});

/// Draws a scene file (TOML, docs/scenes.md), or a model in an isometric view.
[[nodiscard]] EPURA_PUBLIC Drawing draw_file(const std::filesystem::path& file, const Settings& settings = {});

struct SvgOptions {
  bool plain = false;  ///< omit ids and the origin of lines
  int decimals = 4;    ///< of coordinates in millimetres, 1 to 5
  SvgText text = SvgText::outlines;
  std::string id_prefix{};  ///< prefix of ids and classes; empty: derived from the drawing
};

// Encoded files. The same drawing always gives the same bytes. `sheet` counts from 1; `blocks` makes each view a block.
// Throw Failure.
[[nodiscard]] EPURA_PUBLIC std::string to_svg(const Drawing& drawing, int sheet = 1, const SvgOptions& options = {});
[[nodiscard]] EPURA_PUBLIC std::string to_png(const Drawing& drawing, int sheet = 1, double dpi = 300);
[[nodiscard]] EPURA_PUBLIC std::string to_eps(const Drawing& drawing, int sheet = 1);
[[nodiscard]] EPURA_PUBLIC std::string to_dxf(const Drawing& drawing, int sheet = 1, bool blocks = false);
[[nodiscard]] EPURA_PUBLIC std::string to_json(const Drawing& drawing, int sheet = 1);
[[nodiscard]] EPURA_PUBLIC std::string to_pdf(const Drawing& drawing);  ///< all sheets
[[nodiscard]] EPURA_PUBLIC std::string to_ps(const Drawing& drawing);   ///< all sheets

/// Writes a file in the format of its extension; several sheets become x-1.svg, x-2.svg if the format has no pages.
/// Returns the paths of the files. Throws Failure; an existing file is then kept.
EPURA_PUBLIC std::vector<std::filesystem::path> write(const Drawing& drawing, const std::filesystem::path& file);

/// A drawing made by epura, as the bytes of a file: .svg, .pdf or .json.
struct DrawingFile {
  std::string name;  ///< its extension says what the bytes are
  std::string bytes;
};

/// The visible differences between two drawings.
struct Comparison {
  bool is_same = true;
  std::string words;  ///< one line for each difference, and a last line with their number
  std::string json;   ///< the same for programs (docs/reports.md)
  std::string page;   ///< HTML that shows the differences, if there are some
};

/// Compares two drawings as `epura compare` does: lines within `tolerance` mm of each other count as equal. Throws
/// Failure for files that epura did not write.
[[nodiscard]] EPURA_PUBLIC Comparison compare_drawings(const DrawingFile& before, const DrawingFile& after,
                                                       double tolerance = 0.001);

/// "0.2.0"
EPURA_PUBLIC const char* version() noexcept;

}  // namespace epura
