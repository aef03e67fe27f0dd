// SPDX-License-Identifier: Apache-2.0
// Error on paper against run time for parts, over the fineness of their tessellations:
//   part_errors [--only TEXT] [--view PROJECTION] [--finest N] [--runs N] [--rival NAME=COMMAND]... -o FILE...
//   [FILE|FOLDER...]
//
// The true lines are those that Open CASCADE's exact hidden-line removal finds on the surfaces. Where it errs, so does
// this comparison: therefore the error is that of 99 % of the length of lines.
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "part_geometry.hpp"
#include "say.hpp"
#include "study/paper/convergence.hpp"
#include "study/paper/report.hpp"

namespace {

using namespace epura;
using namespace epura::bench;

constexpr double share = 0.99;
constexpr double curve_fineness = 1e6;

struct Options {
  std::string only{}, view = "isometric";
  int finest = 384, runs = 3;
  std::vector<study::Rival> rivals{};
  std::vector<std::string> outputs{}, paths{};
};

mesh::Soup soup_of(const Polygons& polygons) {
  mesh::Soup soup;
  soup.points = polygons.points;
  soup.single_precision = polygons.single_precision;
  for (const std::vector<int>& face : polygons.faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.end_face();
  }
  return soup;
}

// Facets of a circle with the diagonal as its diameter are this part of it away from the arc, at most.
double fineness_of(int around) { return 2 / (1 - std::cos(std::numbers::pi / around)); }

/// A part and its lines, which take long to find.
class KnownPart {
 public:
  explicit KnownPart(const Part& part) : name_(part.name), shape_(part.make()) { mark_tangent_edges(shape_); }

  mesh::Soup mesh(int around) const { return soup_of(tessellate(shape_, fineness_of(around))); }

  const study::TrueLines& lines(const Vec3& viewer) {
    if (!lines_) {
      const double start = now();
      const ExactView view = exact_view(shape_, viewer, curve_fineness);
      std::fprintf(stderr, "%s: exact lines in %s s, %d curves lost\n", name_.c_str(),
                   format_fixed(now() - start, 3).c_str(), view.lost);
      lines_ = study::TrueLines{in_space(view, view.visible), in_space(view, view.smooth_visible)};
    }
    return *lines_;
  }

 private:
  static std::vector<std::vector<Vec3>> in_space(const ExactView& view, const std::vector<PlaneLine>& lines) {
    std::vector<std::vector<Vec3>> placed;
    for (const auto& [from, to] : lines)
      placed.push_back({from.x * view.right + from.y * view.up, to.x * view.right + to.y * view.up});
    return placed;
  }

  std::string name_;
  TopoDS_Shape shape_;
  std::optional<study::TrueLines> lines_{};
};

study::PaperScene scene_of(const Part& part, const std::string& projection) {
  const auto known = std::make_shared<KnownPart>(part);
  study::PaperScene scene{part.name + ", " + projection, projection, {}, {}};
  scene.meshes = [known](int around) { return std::vector{known->mesh(around)}; };
  scene.lines = [known](const projection::Projection& view, int /*points*/) { return known->lines(view.n); };
  scene.share = share;
  return scene;
}

[[noreturn]] void refuse(const std::string& reason) {
  throw Error(ErrorKind::input, "part_errors", reason,
              "usage: part_errors [--only TEXT] [--view PROJECTION] [--finest N] [--runs N] [--rival NAME=COMMAND]... "
              "-o FILE... [FILE|FOLDER...]");
}

Options options_of(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (!word.starts_with("-")) {
      options.paths.push_back(word);
      continue;
    }
    if (++i == words.size()) refuse(word + " needs a value");
    const auto number = [&] { return static_cast<int>(std::clamp(parse_number(words[i]).value_or(1), 1.0, 1e5)); };
    if (word == "--only")
      options.only = words[i];
    else if (word == "--view")
      options.view = words[i];
    else if (word == "--finest")
      options.finest = number();
    else if (word == "--runs")
      options.runs = number();
    else if (word == "--rival")
      options.rivals.push_back(study::parse_rival(words[i]));
    else if (word == "-o")
      options.outputs.push_back(words[i]);
    else
      refuse(word + " is not known");
  }
  if (options.outputs.empty()) refuse("-o is missing");
  return options;
}

std::vector<Part> wanted_parts(const Options& options) {
  std::vector<Part> parts = made_parts();
  if (!options.paths.empty()) parts.clear();
  for (const std::string& path : options.paths) {
    const std::vector<Part> found = parts_in(path);
    parts.insert(parts.end(), found.begin(), found.end());
  }
  std::erase_if(parts, [&](const Part& part) { return part.name.find(options.only) == std::string::npos; });
  if (parts.empty()) refuse("there are no such parts");
  return parts;
}

void measure(const Options& options) {
  const auto targets = study::report_targets(options.outputs);
  std::vector<int> finenesses;
  for (int around = 12; around <= options.finest; around *= 2) finenesses.push_back(around);
  study::PaperStudy laboratory;
  laboratory.rivals = options.rivals;
  std::vector<study::PaperScene> scenes;
  for (const Part& part : wanted_parts(options)) scenes.push_back(scene_of(part, options.view));
  const auto measured = study::measure_paper(scenes, finenesses, options.runs, laboratory, {});
  study::write_report(study::report_of(measured), targets, {}, {});
}

}  // namespace

int main(int argc, char** argv) {
  try {
    measure(options_of({argv + 1, argv + argc}));
    return 0;
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(error.kind());
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "part_errors: %s\n", failure.GetMessageString());
    return static_cast<int>(ErrorKind::input);
  }
}
