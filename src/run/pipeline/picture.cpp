// SPDX-License-Identifier: Apache-2.0
#include "pipeline/picture.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "annotations/construction_layer.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "construction/picture_plane.hpp"
#include "drawing/drawing.hpp"
#include "pipeline/complete_scene.hpp"
#include "pipeline/read_models.hpp"

namespace epura::pipeline {

namespace {

using construction::SetUpPart;
using projection::Quantity;

constexpr std::size_t max_rays = 6;
constexpr int digits = 5;

/// How the lines of a part are drawn.
struct PartLook {
  SetUpPart part;
  const char* name;
  LineRole line;
  HiddenLines hidden;
};

constexpr std::array looks{
    PartLook{SetUpPart::image, "image", LineRole::wide, HiddenLines::none},
    PartLook{SetUpPart::plane, "view plane", LineRole::narrow, HiddenLines::dashed},
    PartLook{SetUpPart::rays, "rays", LineRole::narrow, HiddenLines::none},
    PartLook{SetUpPart::volume, "view volume", LineRole::neighbour, HiddenLines::none},
    PartLook{SetUpPart::normalised, "normalised volume", LineRole::neighbour, HiddenLines::none}};

const PartLook& look_of(SetUpPart part) {
  return *std::find_if(looks.begin(), looks.end(), [part](const PartLook& look) { return look.part == part; });
}

std::string list_of(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) append_to_list(text, format_rounded(value, digits));
  return text;
}

std::string list_of(const Vec3& p) { return list_of({p.x, p.y, p.z}); }

std::string parameters_of(const Picture& picture, const std::optional<Quantity>& quantity) {
  if (!quantity) return "";
  std::string text;
  for (const std::string& name : picture.influence[static_cast<std::size_t>(*quantity)]) append_to_list(text, name);
  return text;
}

// What a quantity is, and its value.
std::string meaning_of(const Picture& picture, Quantity quantity, bool is_maximum) {
  const projection::Projection& p = picture.projection;
  const projection::ViewVolume& volume = picture.viewing.volume;
  switch (quantity) {
    case Quantity::point:
      return "view reference point: " + list_of(p.point) +
             (picture.set_up.plane == 0 ? "" : "; drawn with the plane at n = " + list_of({picture.set_up.plane}));
    case Quantity::normal:
      return "view plane normal VPN: " + list_of(p.n);
    case Quantity::up:
      return "upwards, from VUP: " + list_of(p.v);
    case Quantity::projector:
      return (p.central ? "centre of projection: " : "direction of the projectors: ") + list_of(p.projector);
    case Quantity::window: {
      const Vec2& corner = is_maximum ? volume.window.max : volume.window.min;
      return "corner of the window: " + list_of({corner.x, corner.y}) +
             (p.scale == 1 ? "" : "; drawn at " + list_of({p.scale}) + " : 1");
    }
    case Quantity::front:
      return "front plane: n = " + list_of({volume.front});
    case Quantity::back:
      return "back plane: n = " + list_of({volume.back});
    case Quantity::scale:
      break;
  }
  return "";
}

// With the names of the parameters that set it; the legend has all of them.
scene::ConstructionItem label_of(const Picture& picture, construction::SetUpPoint named) {
  constexpr std::size_t longest = 30, most = 5;
  scene::NamedPoint& point = named.point;
  const std::string parameters = parameters_of(picture, named.quantity);
  if (named.quantity) point.meaning = meaning_of(picture, *named.quantity, point.symbol.starts_with("umax"));
  if (!parameters.empty()) point.meaning += " (" + parameters + ")";
  if (point.symbol == "u") point.meaning = "to the right: " + list_of(picture.projection.u);
  if (point.symbol == "PP") point.meaning = "principal point: foot of the perpendicular from PRP";
  if (point.symbol.starts_with("N_"))
    point.meaning = "normalised volume (r, s, t), to which " + point.symbol + " maps the view volume" +
                    (picture.set_up.has_window ? "" : "; the window is too large to be drawn");
  const auto names = static_cast<std::size_t>(std::count(parameters.begin(), parameters.end(), ',')) + 1;
  std::string note = parameters.size() <= longest && names <= most ? parameters : "";
  if (named.quantity == Quantity::projector && picture.set_up.far)
    note = sheet::distance_text(*picture.set_up.far) + (note.empty() ? "" : ", " + note);
  if (!note.empty()) point.symbol += ": " + note;
  scene::ConstructionItem item{scene::ConstructionKind::label, point.symbol};
  item.label = std::move(point);
  return item;
}

scene::ConstructionChoice labels_of(const Picture& picture) {
  scene::ConstructionChoice labels;
  for (const construction::SetUpPoint& point : picture.set_up.points) labels.push_back(label_of(picture, point));
  labels.push_back({scene::ConstructionKind::legend, "legend"});
  return labels;
}

scene::ModelDescription model_of(const construction::SetUpLines& lines) {
  const PartLook& look = look_of(lines.part);
  auto soup = std::make_shared<mesh::Soup>();
  soup->format = "memory";
  for (const auto& segment : lines.segments) {
    const int first = static_cast<int>(soup->points.size());
    for (const Vec3& end : segment) soup->points.push_back({end.x, end.y, end.z});
    soup->add_wire(std::array{first, first + 1});
  }
  scene::ModelDescription model;
  model.soup = std::move(soup);
  model.name = {look.name, "picture"};
  model.line = {look.line, "picture"};
  model.hidden = {look.hidden, "picture"};
  return model;
}

// The drawing of the model alone.
scene::SceneDescription own_scene(const PictureRequest& request) {
  scene::SceneDescription scene;
  scene.models = {request.model};
  scene::ViewDescription& view = scene.views.emplace_back();
  view.projection = request.projection;
  view.hidden = {HiddenLines::none, "picture"};
  complete_scene(scene);
  complete_sheets(scene);
  return scene;
}

// Its visible lines, in coordinates of the plane.
std::vector<std::array<Vec2, 2>> image_of(const drawing::ViewDrawing& drawing) {
  const auto plane = construction::picture_plane(drawing.projection, drawing.world_to_page, drawing.scale);
  const projection::Projection& p = drawing.projection;
  const Vec3 from_point = plane.foot - p.point;
  const Vec2 foot(glm::dot(from_point, p.u), glm::dot(from_point, p.v));
  const auto in_plane = [&](const Vec2& page) { return foot + (page - plane.origin) / plane.scale; };
  std::vector<std::array<Vec2, 2>> image;
  for (const drawing::Segment& segment : drawing.segments)
    if (segment.visible && segment.from != segment.to) image.push_back({in_plane(segment.from), in_plane(segment.to)});
  return image;
}

std::vector<Vec3> points_of(const world::World& world, const PictureRequest& request, const Picture& picture) {
  std::vector<Vec3> points;
  if (request.vertices.given()) {
    const int count = world.first_vertex.back();
    for (const int vertex : *request.vertices) {
      if (vertex >= count)
        throw Error(ErrorKind::input, request.vertices.where,
                    *request.model.file + " has no vertex " + std::to_string(vertex),
                    "numbers run from 0 to " + std::to_string(count - 1));
      points.push_back(world.points[static_cast<std::size_t>(vertex)]);
    }
    return points;
  }
  for (const auto& triangle : world.triangles)
    for (const int vertex : triangle) points.push_back(world.points[static_cast<std::size_t>(vertex)]);
  for (const auto& wire : world.wires)
    for (const int vertex : wire) points.push_back(world.points[static_cast<std::size_t>(vertex)]);
  return construction::outline_points(picture.projection, picture.viewing.volume, points, max_rays);
}

// The direction in which a picture is seen, if a projection for it is given.
std::optional<Vec3> direction_of(const PictureRequest& request, const Box& box,
                                 const std::vector<projection::ProjectionEntry>& own,
                                 const std::vector<std::filesystem::path>& folders) {
  if (!request.from.given()) return std::nullopt;
  const auto direction = [&](const scene::ProjectionRequest& from) {
    const projection::ProjectionEntry entry = projection::find_projection(from.name, folders, own);
    const projection::Projection p = projection::make_projection(entry, from, box);
    if (p.central)
      throw Error(ErrorKind::input, request.from.where, "'" + from.text() + "' is not parallel",
                  "show the picture by a parallel projection, such as trimetric");
    return p.projector;
  };
  return direction(*request.from);
}

}  // namespace

Picture make_picture(const PictureRequest& request, const RunOptions& options, const Progress& progress) {
  const scene::SceneDescription own = own_scene(request);
  RunOptions run = options;
  run.keeps_drawings = true;
  run.verify = run.explain = run.lint = run.line_facts = false;
  run.why.clear();
  run.dump.reset();
  const Messages silent = silent_messages();
  Stopwatch watch;
  const DrawnScene drawn = draw_scene(own, run, {silent, progress, watch});
  const drawing::ViewDrawing& drawing = drawn.sheets.front().drawings.front();
  std::vector<mesh::MeshReport> reports;
  const world::World world = read_models(own, reading_of(own, run), reports, silent, progress).world;
  const auto folders = projection::plugin_folders(options.plugin_path);
  Picture picture{{}, drawing.projection, {}, {}, {}};
  picture.entry = projection::find_projection(request.projection->name, folders, options.projections);
  picture.viewing = view::viewing_model(view::project_scene(world, picture.projection, {}), world.box, 1);
  picture.influence = projection::influence_of(picture.entry, *request.projection, world.box);
  const std::vector<std::array<Vec2, 2>> image = image_of(drawing);
  const std::vector<Vec3> points = points_of(world, request, picture);
  picture.set_up =
      construction::set_up({picture.projection, picture.viewing, world.box, image, points, request.keeps_plane,
                            direction_of(request, world.box, options.projections, folders)});
  return picture;
}

scene::SceneDescription scene_of(const Picture& picture, const PictureRequest& request) {
  scene::SceneDescription scene;
  scene.models = {request.model, request.model};
  scene::ModelDescription& normalised = scene.models.back();
  normalised.drawn = {!picture.set_up.is_flat, "picture"};
  normalised.transform = {picture.set_up.normalised, "picture"};
  normalised.surfaces = {Surfaces::mesh, "picture"};
  for (const construction::SetUpLines& lines : picture.set_up.lines) scene.models.push_back(model_of(lines));
  scene::ViewDescription& view = scene.views.emplace_back();
  const Vec3& from = picture.set_up.seen_from;
  const auto usual = [&] {
    const std::string direction = format_number(from.x) + "," + format_number(from.y) + "," + format_number(from.z);
    return scene::ProjectionRequest{"auxiliary", {{"direction", direction}}};
  };
  view.projection = request.from.given() ? request.from : scene::Located<scene::ProjectionRequest>{usual(), "picture"};
  view.name = {"picture", "picture"};
  view.hidden = {HiddenLines::none, "picture"};
  view.construction = {labels_of(picture), "picture"};
  view.label = {request.projection->text(), "picture"};
  scene.sheets.emplace_back().fit = {SheetFit::construction, "picture"};
  return scene;
}

}  // namespace epura::pipeline
