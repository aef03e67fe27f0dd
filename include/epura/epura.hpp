// SPDX-License-Identifier: Apache-2.0
// The library: from models to drawings, as `epura draw` makes them.
//
//   epura::Scene scene{.models = {{.file = "bracket.obj"}}, .views = {{.projection = "front"}}};
//   epura::write(epura::draw(scene), "bracket.pdf");
//
// find_package(epura COMPONENTS library) and link epura::library, or use pkg-config.
#pragma once

#include <array>
#include <epura/scene.hpp>
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

/// All trouble that the caller can mend. The message names the place and the reason. Places in a scene in memory are
/// written as its members: "views[1].parameters".
class EPURA_PUBLIC Failure : public std::runtime_error {
 public:
  /// The exit code that the program has for it. `time`: `time_limit` left nothing to show; `stopped`: it was asked to.
  enum class Kind { input = 2, plugin = 3, output = 4, time = 5, stopped = 130 };

  Failure(Kind kind, std::string place, const std::string& message, std::string hint)
      : std::runtime_error(message), kind_(kind), place_(std::move(place)), hint_(std::move(hint)) {}

  [[nodiscard]] Kind kind() const noexcept { return kind_; }
  /// A file with its line or byte, a member of the scene, or a plugin.
  [[nodiscard]] const std::string& place() const noexcept { return place_; }
  /// The remedy, where there is one.
  [[nodiscard]] const std::string& hint() const noexcept { return hint_; }

 private:
  Kind kind_;
  std::string place_, hint_;
};

/// How a scene is drawn.
struct Settings {
  std::optional<double> contact{};     ///< length below which faces touch and hide nothing; found by default
  bool wireframe = false;              ///< no hidden-line removal
  std::optional<double> arcs{};        ///< draw arcs of circles and ellipses, through corners within so many mm
  bool centre_lines = false;           ///< draw centre lines and axes of circles of the models
  std::optional<int> verify{};         ///< test the drawing at so many points at random, and its outline
  std::optional<double> time_limit{};  ///< seconds: what there is no time for is left out
  int threads = 0;                     ///< 0: all cores. Where several calls run at once, the lowest number counts
  std::vector<std::filesystem::path> plugin_path{};  ///< more folders with projection plugins
  /// Told when a stage begins, and then as it goes on: its name, and the part that is done, 0 to 1 (0 where that is not
  /// known). Called from any thread, never twice at once.
  std::function<void(const std::string& stage, double done)> progress{};
  std::stop_token stop{};  ///< asked for, the call ends soon by Failure{stopped}
};

/// A straight piece of ink. Lengths on paper are millimetres, y up, from the lower left corner of the sheet.
struct Line {
  std::array<double, 2> from, to;
  EdgeKind kind;
  bool visible;
  int model;                ///< of Scene::models
  std::array<int, 2> edge;  ///< numbers of the vertices in the model; {-1, -1} for an intersection or a cut
  std::array<double, 2> t;  ///< parameters along that edge in space, `from` at t[0]; equal ones: a link to other ink
};

/// A part of the lines that is an arc (Settings::arcs): centre + cos(a) u + sin(a) v, where a runs from `from` to `to`,
/// in radians. Of a circle u and v have one length; of an ellipse they are its half axes.
struct Arc {
  std::array<double, 2> centre, u, v;
  double from, to;
  EdgeKind kind;
  bool visible;
};

struct DrawnView {
  std::string name, projection;
  int sheet;     ///< on which it stands, from 1
  double scale;  ///< mm of paper per unit of the world, in the plane of projection
  /// Rows: page = (row0/row3, row1/row3) in mm, of a world point as a column vector; row2/row3 grows towards the
  /// viewer.
  std::array<double, 16> world_to_page;
  std::vector<Line> lines;
  std::vector<Arc> arcs;
};

/// Strokes of the pen, as they are written: dashes are fitted by the writers.
struct SheetLayer {
  std::string name;                                         ///< "front/visible"
  double width;                                             ///< mm
  std::vector<std::vector<std::array<double, 2>>> strokes;  ///< a closed one ends where it begins
};

/// What a scene became: sheets of paper with views on them. Cheap to copy: copies share what they hold, which never
/// changes.
class EPURA_PUBLIC Drawing {
 public:
  class Content;
  explicit Drawing(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

  [[nodiscard]] int sheets() const noexcept;
  [[nodiscard]] const std::vector<DrawnView>& views() const noexcept;
  /// What is on a sheet, in the order of painting. `sheet` counts from 1.
  [[nodiscard]] std::vector<SheetLayer> layers(int sheet = 1) const;
  /// Sentences: what was repaired in models, what is not as was wished.
  [[nodiscard]] const std::vector<std::string>& warnings() const noexcept;
  /// The stages that `time_limit` cut; none: the drawing is complete.
  [[nodiscard]] const std::vector<std::string>& cut_stages() const noexcept;
  /// Whether `verify` found a fault; the JSON tells which.
  [[nodiscard]] bool is_wrong() const noexcept;
  [[nodiscard]] const Content& content() const noexcept { return *content_; }  ///< for the library itself

 private:
  std::shared_ptr<const Content> content_;
};

/// Draws. Reads the models that are files, writes nothing, prints nothing, touches no signal. Several threads may draw
/// at once. Plugins are found beside the library, and as the program finds them; they run in processes of their own,
/// which end with the call. Throws Failure, and std::bad_alloc.
[[nodiscard]] EPURA_PUBLIC Drawing draw(const Scene& scene, const Settings& settings = {});

/// Draws a scene file, toml (docs/formats.md), or a model in an isometric view.
[[nodiscard]] EPURA_PUBLIC Drawing draw_file(const std::filesystem::path& file, const Settings& settings = {});

struct SvgOptions {
  bool plain = false;  ///< leave the origin of lines out
  int decimals = 4;    ///< of coordinates in millimetres, 1 to 5
  SvgText text = SvgText::outlines;
  std::string id_prefix{};  ///< of ids and classes; empty: made from the drawing, so that two on one page do not clash
};

// The bytes of files. The same drawing gives the same bytes, always. `sheet` counts from 1. Throw Failure.
[[nodiscard]] EPURA_PUBLIC std::string to_svg(const Drawing& drawing, int sheet = 1, const SvgOptions& options = {});
[[nodiscard]] EPURA_PUBLIC std::string to_png(const Drawing& drawing, int sheet = 1, double dpi = 300);
[[nodiscard]] EPURA_PUBLIC std::string to_eps(const Drawing& drawing, int sheet = 1);
[[nodiscard]] EPURA_PUBLIC std::string to_dxf(const Drawing& drawing, int sheet = 1);
[[nodiscard]] EPURA_PUBLIC std::string to_json(const Drawing& drawing, int sheet = 1);
[[nodiscard]] EPURA_PUBLIC std::string to_pdf(const Drawing& drawing);  ///< all sheets
[[nodiscard]] EPURA_PUBLIC std::string to_ps(const Drawing& drawing);   ///< all sheets

/// Writes the format that the extension names; several sheets become x-1.svg, x-2.svg where the format has one page.
/// Returns the files. Throws Failure; what was there under the name of an output then stays.
EPURA_PUBLIC std::vector<std::filesystem::path> write(const Drawing& drawing, const std::filesystem::path& file);

/// "0.1.0"
EPURA_PUBLIC const char* version() noexcept;

}  // namespace epura
