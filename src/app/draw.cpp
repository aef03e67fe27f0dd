#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/commands.hpp"
#include "app/pipeline.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "mesh/read.hpp"
#include "projection/catalogue.hpp"
#include "scene/transform.hpp"
#include "sheet/arrange.hpp"
#include "study/verify.hpp"

namespace epura {

namespace {

template <class Value>
Value choose(const std::string& option, const std::string& word,
             const std::vector<std::pair<std::string, Value>>& choices) {
  std::vector<std::string> names;
  for (const auto& [name, value] : choices) {
    if (name == word) return value;
    names.push_back(name);
  }
  throw Error(Trouble::input, option, "does not know '" + word + "'", did_you_mean(word, names));
}

struct Target {
  std::string path;
  Format format;
};

// Formats are settled before any work is done: a long run must not end in a typing error.
std::vector<Target> targets_of(const DrawOptions& options) {
  std::vector<Target> targets;
  for (const std::string& path : options.outputs) {
    std::string extension = path == "-" ? options.format : std::filesystem::path(path).extension().string();
    if (extension.starts_with(".")) extension.erase(0, 1);
    const auto format = format_of(extension);
    if (!format && path == "-")
      throw Error(Trouble::input, "--output -", "wants --format", did_you_mean(extension, format_names()));
    if (!format)
      throw Error(Trouble::input, path,
                  extension.empty() ? "has no extension to tell the format" : "has an unknown format",
                  did_you_mean(extension, format_names()));
    for (const Target& other : targets)
      if (other.path == path) throw Error(Trouble::input, path, "is named twice as output");
    targets.push_back({path, *format});
  }
  return targets;
}

EdgeWishes edge_wishes(const DrawOptions& options) {
  EdgeWishes wishes{false, false, false, false, false, options.crease_angle};
  for (const std::string_view part : split(options.edges, ',')) {
    const auto wish = choose<bool EdgeWishes::*>("--edges", std::string(part),
                                                 {{"contour", &EdgeWishes::contour},
                                                  {"crease", &EdgeWishes::crease},
                                                  {"boundary", &EdgeWishes::boundary},
                                                  {"intersection", &EdgeWishes::intersection},
                                                  {"smooth", &EdgeWishes::smooth}});
    wishes.*wish = true;
  }
  return wishes;
}

// The n-th transform belongs to the n-th model; a single one to all.
Mat4 place_of(const DrawOptions& options, std::size_t model) {
  const double unit = choose<double>("--unit", options.unit, {{"mm", 1}, {"in", 25.4}, {"m", 1000}});
  const bool y_up = choose<bool>("--up", options.up, {{"z", false}, {"y", true}});
  Mat4 place = parse_transform("scale:" + format_number(unit));
  if (y_up) place = y_up_to_z_up() * place;
  if (options.transforms.empty()) return place;
  if (options.transforms.size() != 1 && options.transforms.size() != options.models.size())
    throw Error(Trouble::input, "--transform", "is given neither once nor once for each model");
  return parse_transform(options.transforms[options.transforms.size() == 1 ? 0 : model]) * place;
}

void warn(const std::string& sentence) { std::fprintf(stderr, "epura: %s\n", sentence.c_str()); }

// Says what was repaired: a drawing of a damaged model must not look like one of a sound model.
void warn_about(const MeshReport& report) {
  const auto say = [&](int count, const std::string& what) {
    if (count > 0) warn(report.name + ": " + std::to_string(count) + " " + what);
  };
  say(report.dropped_degenerate, "faces with fewer than three distinct corners left out");
  say(report.dropped_duplicates, "faces that repeat an earlier face left out");
  say(report.dropped_non_finite, "faces with coordinates that are no finite numbers left out");
  say(report.non_manifold_edges, "edges have three or more faces; each is drawn");
  for (const std::string& note : report.notes) warn(report.name + ": " + note);
}

World read_world(const DrawOptions& options, Report& report) {
  std::vector<Mat4> places;
  for (std::size_t i = 0; i < options.models.size(); ++i) places.push_back(place_of(options, i));
  std::vector<Placed> placed;
  for (std::size_t i = 0; i < options.models.size(); ++i) {
    placed.push_back({std::make_shared<const Mesh>(read_mesh(options.models[i])), places[i]});
    report.meshes.push_back(placed.back().mesh->report);
    warn_about(report.meshes.back());
  }
  return make_world(std::move(placed));
}

ViewWish view_wish(const DrawOptions& options) {
  ViewWish wish;
  wish.limits = {options.near, options.far};
  wish.edges = edge_wishes(options);
  wish.contact = options.contact;
  wish.remove_hidden = choose<bool>("--visibility", options.visibility, {{"exact", true}, {"none", false}});
  wish.keep_hidden = parse_hidden_lines(options.hidden) != HiddenLines::none;
  wish.paper = parse_paper(options.sheet, options.portrait);
  wish.scale = parse_scale(options.scale);
  if (options.verify && !wish.remove_hidden)
    throw Error(Trouble::input, "--verify", "has nothing to test in a wireframe", "leave out --visibility none");
  if (options.verify) wish.verify = options.verify_samples;
  return wish;
}

void warn_about(const ViewResult& result) {
  if (result.drawing.segments.empty()) warn("nothing is drawn: no edge of the wanted kinds is visible");
  if (!result.placement.inside) warn("the drawing is larger than the sheet at this scale");
}

std::string encode(const Target& target, const Sheet& sheet, const ViewResult& result, const DrawOptions& options,
                   const Report& report) {
  switch (target.format) {
    case Format::svg:
      return to_svg(sheet, {options.plain, options.dpi});
    case Format::pdf:
      return to_pdf(sheet);
    case Format::ps:
      return to_ps(sheet);
    case Format::eps:
      return to_eps(sheet);
    case Format::png:
      return to_png(sheet, options.dpi);
    case Format::json:
      return to_json(sheet, result.placement.scale, {result.drawing}, report);
  }
  return {};
}

void write(const Target& target, const std::string& bytes) {
  if (target.path != "-") return write_file(target.path, bytes);
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0)
    throw Error(Trouble::output, "standard output", "cannot be written");
}

void print_timings(const Stopwatch& watch) {
  for (const auto& [stage, seconds] : watch.laps())
    std::fprintf(stderr, "%-12s %8s s\n", stage.c_str(), format_fixed(seconds, 4).c_str());
}

// On standard error, since a drawing may go to standard output. Returns the exit code.
int say(const Verification& found) {
  std::fputs(in_words(found).c_str(), stderr);
  return found.wrong > 0 ? 1 : 0;
}

}  // namespace

int draw(const DrawOptions& options) {
  Stopwatch watch;
  const ThreadLimit threads(options.threads);
  const std::vector<Target> targets = targets_of(options);
  const ViewWish wish = view_wish(options);
  const ProjectionRequest request = parse_request(options.projection);
  const ProjectionEntry entry = find_projection(request.name, plugin_folders(options.plugin_path));
  watch.lap("prepare");

  Report report;
  const World world = read_world(options, report);
  watch.lap("read");
  const Projection projection = make_projection(entry, request, world.box);
  const ViewResult result = draw_view(world, projection, wish, report.plan, watch);
  warn_about(result);
  const Sheet sheet =
      make_sheet(result.drawing, result.placement.paper, {parse_hidden_lines(options.hidden), options.title});
  watch.lap("sheet");
  if (options.timings) report.seconds = watch.laps();
  report.verification = result.verification;

  std::vector<std::string> files;
  for (const Target& target : targets) files.push_back(encode(target, sheet, result, options, report));
  for (std::size_t i = 0; i < targets.size(); ++i) write(targets[i], files[i]);
  watch.lap("write");
  if (options.timings) print_timings(watch);
  return report.verification ? say(*report.verification) : 0;
}

}  // namespace epura
