#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/pipeline.hpp"
#include "app/questions.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "mesh/read.hpp"
#include "projection/catalogue.hpp"
#include "scene/transform.hpp"
#include "sheet/arrange.hpp"
#include "study/verify/verify.hpp"

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

void warn(Console& console, const std::string& sentence) { console.print("epura: " + sentence + "\n"); }

// Says what was repaired: a drawing of a damaged model must not look like one of a sound model.
void warn_about(Console& console, const MeshReport& report) {
  const auto say = [&](int count, const std::string& one, const std::string& many) {
    if (count > 0) warn(console, report.name + ": " + std::to_string(count) + " " + (count == 1 ? one : many));
  };
  const auto say_left_out = [&](int faces, const std::string& what) {
    say(faces, "face left out: " + what, "faces left out: " + what);
  };
  say_left_out(report.dropped_degenerate, "fewer than three distinct corners");
  say_left_out(report.dropped_duplicates, "the corners of an earlier face");
  say_left_out(report.dropped_non_finite, "coordinates that are no finite numbers");
  say(report.non_manifold_edges, "edge has three or more faces and is drawn",
      "edges have three or more faces; each is drawn");
  for (const std::string& note : report.notes) warn(console, report.name + ": " + note);
}

World read_world(const DrawOptions& options, Report& report, Console& console, Progress progress) {
  std::vector<Mat4> places;
  for (std::size_t i = 0; i < options.models.size(); ++i) places.push_back(place_of(options, i));
  // A single model is read in one go: how far it is cannot be told.
  progress.begin("reading", places.size() > 1 ? places.size() : 0);
  std::vector<std::shared_ptr<Mesh>> meshes;
  std::vector<Placed> placed;
  for (std::size_t i = 0; i < options.models.size(); ++i) {
    meshes.push_back(std::make_shared<Mesh>(read_mesh(options.models[i])));
    placed.push_back({meshes.back(), places[i]});
    report.meshes.push_back(meshes.back()->report);
    warn_about(console, report.meshes.back());
    progress.advance(1);
  }
  World world = make_world(std::move(placed));
  // The world has its points and triangles; half-edges would be a fifth of all memory. (OpenMesh keeps the room of what
  // is assigned to.)
  for (const std::shared_ptr<Mesh>& mesh : meshes) {
    std::destroy_at(&mesh->surface);
    std::construct_at(&mesh->surface);
  }
  return world;
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

void warn_about(Console& console, const ViewResult& result) {
  if (result.drawing.segments.empty() && !result.partial)
    warn(console, "nothing is drawn: no edge of the wanted kinds is visible");
  if (!result.placement.inside) warn(console, "the drawing is larger than the sheet at this scale");
}

void warn_about(Console& console, const Partial& partial) {
  std::string sentence = "the drawing is partial: the time limit left out " + std::to_string(partial.undecided) +
                         " of " + std::to_string(partial.edges) + " edges";
  if (partial.searched < 1)
    sentence += " and " + format_fixed(100 * (1 - partial.searched), 1) + " % of the search for intersection lines";
  warn(console, sentence + "\n  hint: give a longer --time-limit, or ask for less with --edges");
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
      return to_json(sheet, result.placement.scale, {&result.drawing, 1}, report);
  }
  return {};
}

void write(const Target& target, const std::string& bytes, Progress progress) {
  if (target.path != "-") return write_file(target.path, bytes, progress);
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0)
    throw Error(Trouble::output, "standard output", "cannot be written");
}

void print_timings(Console& console, const Stopwatch& watch) {
  std::string text;
  for (const auto& [stage, seconds] : watch.laps()) {
    std::array<char, 64> line{};
    std::snprintf(line.data(), line.size(), "%-12s %8s s\n", stage.c_str(), format_fixed(seconds, 4).c_str());
    text += line.data();
  }
  console.print(text);
}

std::vector<std::string> encode_all(const std::vector<Target>& targets, const Sheet& sheet, const ViewResult& result,
                                    const DrawOptions& options, const Report& report, Progress progress) {
  progress.begin("writing", targets.size() > 1 ? targets.size() : 0);
  std::vector<std::string> files;
  for (const Target& target : targets) {
    files.push_back(encode(target, sheet, result, options, report));
    progress.advance(1);
  }
  return files;
}

bool shows_progress(const DrawOptions& options) {
  return choose<bool>("--progress", options.progress, {{"auto", is_terminal()}, {"always", true}, {"never", false}});
}

// Says what was found on the way, and returns the exit code. On standard error, since a drawing may go to standard
// output.
int conclude(Console& console, const ViewResult& result) {
  if (result.verification) console.print(in_words(*result.verification));
  if (result.partial) warn_about(console, *result.partial);
  if (result.verification && result.verification->wrong > 0) return 1;
  return result.partial ? partial_exit_code : 0;
}

}  // namespace

int draw(const DrawOptions& options) {
  Stopwatch watch;
  ProgressBoard board;
  Console console(board, shows_progress(options));
  const Progress progress(board, options.time_limit);
  const ThreadLimit threads(options.threads);
  const std::vector<Target> targets = targets_of(options);
  const Questions questions = parse_questions(options);
  const ViewWish wish = view_wish(options);
  const ProjectionRequest request = parse_request(options.projection);
  const ProjectionEntry entry = find_projection(request.name, plugin_folders(options.plugin_path));
  watch.lap("prepare");

  Report report;
  World world = read_world(options, report, console, progress);
  watch.lap("read");
  const Projection projection = make_projection(entry, request, world.box);
  ViewResult result = draw_view(world, projection, wish, report.plan, watch, progress);
  report.partial = result.partial;
  warn_about(console, result);
  const std::string answers = answer(questions, world, wish, result);
  // What follows takes its room.
  world = {};
  result.work = {};

  const SheetWish sheet_wish{parse_hidden_lines(options.hidden), options.title, result.partial.has_value()};
  const Sheet sheet = make_sheet(result.drawing, result.placement.paper, sheet_wish);
  result.drawing.chains = {};  // the sheet has them
  watch.lap("sheet");
  if (options.timings) report.seconds = watch.laps();
  report.verification = result.verification;

  const std::vector<std::string> files = encode_all(targets, sheet, result, options, report, progress);
  for (std::size_t i = 0; i < targets.size(); ++i) write(targets[i], files[i], progress);
  watch.lap("write");
  console.print("");  // the line of progress makes room
  std::fputs(answers.c_str(), stdout);
  if (options.timings) print_timings(console, watch);
  return conclude(console, result);
}

}  // namespace epura
