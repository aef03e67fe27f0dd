// SPDX-License-Identifier: Apache-2.0
#include "view/viewing_model.hpp"

#include <algorithm>
#include <cmath>

namespace epura::view {

namespace {

// A front plane is in front of the viewer by at least this fraction of the distance to the back plane.
constexpr double min_front = 1e-3;

// The drawn part of the plane, in its own coordinates.
projection::Window window_of(const ProjectedScene& view) {
  const double unit = view.projection.scale * view.map.normalisation;
  projection::Window window{(view.window.min + view.map.image) / unit, (view.window.max + view.map.image) / unit};
  for (int i = 0; i < 2; ++i) {
    if (window.max[i] > window.min[i]) continue;
    window.min[i] -= 0.5 / view.projection.scale;
    window.max[i] += 0.5 / view.projection.scale;
  }
  return window;
}

// The depths of the scene along the view plane normal, from the view reference point.
void set_depths(const projection::Projection& p, const Box& scene, projection::ViewVolume& volume) {
  volume.front = -HUGE_VAL;
  volume.back = HUGE_VAL;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at((corner & 1) != 0 ? scene.max.x : scene.min.x, (corner & 2) != 0 ? scene.max.y : scene.min.y,
                  (corner & 4) != 0 ? scene.max.z : scene.min.z);
    const double depth = glm::dot(at - p.point, p.n);
    volume.front = std::max(volume.front, depth);
    volume.back = std::min(volume.back, depth);
  }
  volume.front = std::min(volume.front, p.front);
  volume.back = std::max(volume.back, p.back);
  if (p.central) {
    const double eye = volume.prp.z;
    if (!(volume.back < eye)) volume.back = eye - 1;
    volume.front = std::min(volume.front, eye - min_front * (eye - volume.back));
  }
  if (!(volume.front > volume.back)) volume.back = volume.front - 1;
}

projection::ViewVolume volume_of(const ProjectedScene& view, const Box& scene) {
  const projection::Projection& p = view.projection;
  projection::ViewVolume volume{window_of(view), 0, 0, 0, Vec3(0)};
  const Vec3 to = p.central ? p.projector - p.point : p.projector;
  volume.prp = Vec3(glm::dot(to, p.u), glm::dot(to, p.v), glm::dot(to, p.n));
  // The direction of projection runs from the middle of the window to the projection reference point (3.41).
  if (!p.central) volume.prp += Vec3((volume.window.min + volume.window.max) / 2.0, 0);
  set_depths(p, scene, volume);
  return volume;
}

}  // namespace

PaperMap viewport_map(const ProjectedScene& view, double scale) {
  const PaperMap paper = make_paper_map(view, scale, Vec2(0));
  const double unit = view.projection.scale * view.map.normalisation;
  const Vec2 lower_left = window_of(view).min * unit - view.map.image;
  return {paper.scale, paper.scale * (view.middle - lower_left)};
}

ViewingModel viewing_model(const ProjectedScene& view, const Box& scene, double scale, const Vec2& corner) {
  const projection::Projection& p = view.projection;
  ViewingModel model{p.point, p.n, p.v, volume_of(view, scene), {}, plane_matrix(p), {}, Mat4(1)};
  const projection::ViewVolume& volume = model.volume;
  const Vec2 size = (volume.window.max - volume.window.min) * p.scale * scale;
  model.viewport = {corner, corner + size};
  model.steps.push_back({"VOM", "3.36", "world -> view reference coordinates",
                         projection::view_orientation(model.vrp, model.vpn, model.vup)});
  if (p.central) {
    model.steps.push_back({"N_per", "3.58", "view reference -> normalised coordinates", projection::n_per(volume)});
    model.steps.push_back(
        {"M_per", "3.60", "onto the view plane in normalised coordinates", projection::m_per_npc(volume)});
  } else {
    model.steps.push_back({"N_par", "3.48", "view reference -> normalised coordinates", projection::n_par(volume)});
  }
  model.steps.push_back({"M_wv", "3.63", "window in normalised coordinates -> viewport, mm",
                         projection::window_to_viewport(projection::npc_window(volume, p.central), model.viewport)});
  for (const ViewingStep& step : model.steps) model.product = step.matrix * model.product;
  return model;
}

}  // namespace epura::view
