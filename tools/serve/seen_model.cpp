// SPDX-License-Identifier: Apache-2.0
#include "serve/seen_model.hpp"

#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/confinement.hpp"
#include "app/describe.hpp"
#include "app/viewing_steps.hpp"
#include "base/utf8.hpp"
#include "edges/dihedral.hpp"
#include "edges/feature_edges.hpp"
#include "edges/find_edges.hpp"
#include "foreign/messages.hpp"
#include "foreign/sandbox.hpp"
#include "output/json_text.hpp"
#include "pipeline/place_view.hpp"
#include "projection/catalogue.hpp"
#include "view/projected_scene.hpp"
#include "world/world.hpp"

namespace epura {

namespace {

template <class Item>
void append(std::string& bytes, const std::vector<Item>& items) {
  bytes.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item));
}

/// Returns three whole numbers of 32 bits and a zero: how many vertices there are, edges that every view has, and other
/// edges, which a view has as contours; then the vertices, three doubles each; then the edges that every view has, two
/// vertices each; then the others, with the third corners of their two triangles. Numbers are those of this machine,
/// where the page is shown.
std::string wireframe_bytes(const world::World& world, const view::ProjectedScene& any_view,
                            const edges::EdgeOptions& edges) {
  edges::EdgeOptions of_every_view = edges;
  of_every_view.contour = false;
  std::vector<std::array<std::int32_t, 2>> lines;
  std::vector<std::array<std::int32_t, 4>> folds;
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    const auto kinds = edges::feature_edges(world, any_view, model, of_every_view);
    const mesh::Mesh& mesh = *world.models[model].mesh;
    const edges::EdgeSurroundings around{world, model, 1};
    for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
      const mesh::MeshEdge& edge = mesh.edges[i];
      const std::array<int, 2> ends{world.first_vertex[model] + edge.vertex[0],
                                    world.first_vertex[model] + edge.vertex[1]};
      if (kinds[i]) {
        lines.push_back({ends[0], ends[1]});
      } else if (edges.contour && edge.count == 2) {
        const auto triangles = mesh.triangles_of(edge);
        folds.push_back({ends[0], ends[1], around.apex(ends, triangles[0]), around.apex(ends, triangles[1])});
      }
    }
  }
  std::vector<std::uint32_t> counts;
  for (const std::size_t count : {world.points.size(), lines.size(), folds.size(), std::size_t{0}})
    counts.push_back(static_cast<std::uint32_t>(count));
  std::vector<std::array<double, 3>> points;
  for (const Vec3& p : world.points) points.push_back({p.x, p.y, p.z});
  std::string bytes;
  append(bytes, counts);
  append(bytes, points);
  append(bytes, lines);
  append(bytes, folds);
  return bytes;
}

using output::json_list;
using output::json_number;
using output::json_string;
using output::json_vector;

constexpr std::size_t max_of_message = std::numeric_limits<std::size_t>::max() / 2;
constexpr std::size_t max_request = 16384;

std::vector<char> bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

std::string text_of(foreign::Unpacker& message) {
  std::vector<char> bytes;
  message(bytes);
  return {bytes.begin(), bytes.end()};
}

std::string json_of(const projection::Parameter& parameter) {
  constexpr std::array<const char*, 3> types{"number", "vector", "choice"};
  return "{\"name\": " + json_string(parameter.name) + ", \"type\": \"" +
         types[static_cast<std::size_t>(parameter.type)] + "\", \"unit\": " + json_string(parameter.unit) +
         ", \"help\": " + json_string(parameter.help) + ", \"choices\": " + json_list(parameter.choices, json_string) +
         ", \"initial\": " + json_list(parameter.initial, json_number) + ", \"min\": " + json_number(parameter.min) +
         ", \"max\": " + json_number(parameter.max) + "}";
}

std::string json_of(const projection::ProjectionEntry& entry) {
  return "{\"name\": " + json_string(entry.name) + ", \"family\": " + json_string(entry.family) +
         ", \"summary\": " + json_string(entry.summary) + ", \"reference\": " + json_string(entry.reference) +
         ", \"parameters\": " + json_list(entry.parameters, [](const projection::Parameter& p) { return json_of(p); }) +
         "}";
}

class SeenModel {
 public:
  explicit SeenModel(const DrawOptions& options) : options_(options) {
    projection::Catalogue catalogue = projection::load_catalogue(projection::plugin_folders(options.run.plugin_path));
    options_.run.projections = std::move(catalogue.entries);
    const auto say = [](const std::string& sentence) {
      std::fprintf(stderr, "epura: %s\n", printable(sentence).c_str());
    };
    for (const projection::BadPlugin& bad : catalogue.bad) say(bad.path.string() + ": " + bad.reason);
    world_ = pipeline::read_world(describe(options_), options_.run, {say, [](std::string_view) {}}, {});
  }

  [[nodiscard]] std::string view(const std::string& projection) const {
    DrawOptions options = options_;
    options.projections = {{scene::parse_request(projection), "--projection"}};
    return json_of_view(pipeline::place_view(world_, describe(options), options.run));
  }

  [[nodiscard]] ReadyModel ready() const {
    const scene::SceneDescription scene = describe(options_);
    const pipeline::PlacedView first = pipeline::place_view(world_, scene, options_.run);
    const scene::ProjectionRequest request = *scene.views.front().projection;
    const auto assignment = [](const auto& one) { return json_list(std::vector{one.first, one.second}, json_string); };
    return {"{\"box\": [" + json_vector(world_.box.min) + ", " + json_vector(world_.box.max) +
                "],\n\"start\": {\"name\": " + json_string(first.seen.projection.name) +
                ", \"values\": " + json_list(request.assignments, assignment) + "},\n\"view\": " + json_of_view(first) +
                ",\"projections\": " +
                json_list(
                    options_.run.projections, [](const auto& entry) { return json_of(entry); }, ",\n") +
                "}",
            wireframe_bytes(world_, first.seen, first.edges)};
  }

 private:
  // With the viewport where the drawing has the view on its sheet.
  [[nodiscard]] std::string json_of_view(const pipeline::PlacedView& placed) const {
    const double scale = placed.place.scale;
    const Vec2 corner = view::make_paper_map(placed.seen, scale, placed.place.shift).origin -
                        view::viewport_map(placed.seen, scale).origin;
    return viewing_json(placed.seen.projection, view::viewing_model(placed.seen, world_.box, scale, corner),
                        ",\n \"paper\": " + json_list(std::vector{placed.paper.x, placed.paper.y}, json_number));
  }

  DrawOptions options_;
  world::World world_;
};

// What this process inherits of the server's: its sockets.
void close_all_but(int socket) {
  ::close_range(STDERR_FILENO + 1, static_cast<unsigned>(socket) - 1, 0);
  ::close_range(static_cast<unsigned>(socket) + 1, std::numeric_limits<unsigned>::max(), 0);
}

foreign::Packer answer_to(const SeenModel& model, const std::string& projection) {
  foreign::Packer message;
  try {
    const std::string json = model.view(projection);
    message(true);
    message(bytes_of(json));
  } catch (const Error& error) {
    message(false);
    message(bytes_of(error_json(error.what(), error.hint())));
  }
  return message;
}

foreign::Packer refusal(ErrorKind kind, std::string_view reason, std::string_view hint) {
  foreign::Packer message;
  message(false);
  message(kind);
  message(bytes_of(reason));
  message(bytes_of(hint));
  return message;
}

void show_model(int socket, const DrawOptions& options) {
  if (options.run.sandbox != pipeline::Sandbox::off)
    foreign::enter_sandbox(permissions_for({options.models, {}}, options.run, options.sheet));
  const SeenModel model(options);
  const ReadyModel ready = model.ready();
  foreign::Packer message;
  message(true);
  message(bytes_of(ready.page_data));
  message(bytes_of(ready.wireframe));
  if (!foreign::send_message(socket, message)) return;
  for (foreign::Incoming incoming; incoming.receive(socket, {}, max_request) == foreign::Received::all;)
    if (!foreign::send_message(socket, answer_to(model, incoming.take()))) return;
}

void run_model(int socket, const DrawOptions& options) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  close_all_but(socket);
  try {
    show_model(socket, options);
  } catch (const Error& error) {
    foreign::send_message(socket, refusal(error.kind(), error.what(), error.hint()));
  } catch (const std::bad_alloc&) {
    foreign::send_message(socket, refusal(ErrorKind::input, "not enough memory for this model", ""));
  }
}

// Reading may take long, and Ctrl-C ends it.
std::string first_message(foreign::ChildProcess& process, const std::string& model) {
  constexpr std::chrono::hours any_time(1);
  try {
    std::optional<std::string> message;
    while (!message) message = process.receive(foreign::Clock::now() + any_time, max_of_message);
    return *std::move(message);
  } catch (const Error& error) {
    throw Error(error.kind(), model, std::string("the process that reads it ") + error.what());
  }
}

}  // namespace

ReadyModel start_model(foreign::ChildProcess& process, const ServeOptions& options) {
  process.fork([&](int socket) { run_model(socket, options.draw); });
  const std::string message = first_message(process, options.draw.models.front());
  foreign::Unpacker unpack(message);
  bool is_good = false;
  unpack(is_good);
  if (is_good) {
    std::string page_data = text_of(unpack);
    return {std::move(page_data), text_of(unpack)};
  }
  ErrorKind kind{};
  unpack(kind);
  const std::string reason = text_of(unpack), hint = text_of(unpack);
  throw Error(kind, "", reason, hint);
}

void ask_for_view(foreign::ChildProcess& process, const std::string& projection) {
  foreign::Packer message;
  for (const char c : projection) message(c);
  process.send(message);
}

std::optional<ViewAnswer> take_view(foreign::ChildProcess& process) {
  const std::optional<std::string> message = process.receive(foreign::Clock::now(), max_of_message);
  if (!message) return std::nullopt;
  foreign::Unpacker unpack(*message);
  ViewAnswer answer{};
  unpack(answer.is_good);
  answer.json = text_of(unpack);
  return answer;
}

std::string error_json(std::string_view reason, std::string_view hint) {
  return "{\"error\": " + json_string(reason) + ", \"hint\": " + json_string(hint) + "}";
}

}  // namespace epura
