// SPDX-License-Identifier: Apache-2.0
#include "composition/stated_symbols.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "composition/requirement_texts.hpp"

namespace epura::pipeline {

namespace {

using importer::ModelRequirement;
using importer::RequirementKind;

// Two leaders to one face do not end at one point: of its better marks, the one that is farthest from others.
const SeenMark& least_crowded(const std::vector<SeenMark>& marks, const std::vector<Vec3>& taken) {
  constexpr double enough = 0.3;  // of the best worth
  const SeenMark* best = &marks.front();
  if (taken.empty()) return *best;
  double farthest = -1;
  for (const SeenMark& mark : marks) {
    if (mark.on_line != marks.front().on_line || mark.worth < enough * marks.front().worth) continue;
    double nearest = HUGE_VAL;
    for (const Vec3& other : taken) nearest = std::min(nearest, glm::length(other - mark.point));
    if (nearest <= farthest) continue;
    farthest = nearest;
    best = &mark;
  }
  return *best;
}

bool is_better(const SeenMark& one, const SeenMark& other) {
  constexpr double clearly = 1.01;
  if (one.on_line != other.on_line) return one.on_line;
  return one.worth > clearly * other.worth;
}

}  // namespace

void SymbolPlaces::add_dimension(const std::vector<int>& faces, const scene::DimensionDescription& dimension) {
  dimensions_.emplace(faces, Attachment{*dimension.name, *dimension.view});
}

bool SymbolPlaces::place(scene::CalloutDescription& callout, const std::vector<int>& faces, Ends ends) {
  if (const auto of = dimensions_.find(faces); of != dimensions_.end() && of->second.ends > 0) {
    --of->second.ends;
    callout.dimension = {of->second.dimension, callout.where};
    callout.view = {of->second.view, callout.where};
    return true;
  }
  const FaceView* best = nullptr;
  std::vector<SeenMark> marks;
  for (const FaceView& view : subject_.views) {
    const surfaces::PartSurface& first = subject_.part.faces[static_cast<std::size_t>(faces.front())].surface;
    if (ends == Ends::element && surfaces::has_axis(first.kind) &&
        std::abs(glm::dot(first.axis, view.projection().n)) > max_tilt)
      continue;
    std::vector<SeenMark> here;
    bool has_all = true;
    for (const int face : faces) {
      std::vector<SeenMark> of_face =
          view.marks_on({subject_.model, face}, subject_.part.faces[static_cast<std::size_t>(face)]);
      has_all = has_all && !of_face.empty() && of_face.front().on_line;
      if (!of_face.empty() && (here.empty() || is_better(of_face.front(), here.front()))) here = std::move(of_face);
    }
    if (here.empty() || (ends == Ends::line && !here.front().on_line) || (ends == Ends::lines_of_all && !has_all))
      continue;
    if (best != nullptr && !is_better(here.front(), marks.front())) continue;
    best = &view;
    marks = std::move(here);
  }
  if (best == nullptr) return false;
  std::vector<Vec3>& taken = taken_[best->name()];
  const SeenMark& mark = least_crowded(marks, taken);
  if (std::find(taken.begin(), taken.end(), mark.point) == taken.end()) taken.push_back(mark.point);
  callout.view = {best->name(), callout.where};
  callout.to = {scene::LeaderTarget(scene::Anchor(mark.point)), callout.where};
  return true;
}

bool SymbolPlaces::place_in_area(scene::CalloutDescription& callout, const std::vector<int>& faces,
                                 const Vec3& point) const {
  double most = 0;
  for (const FaceView& view : subject_.views)
    for (const int face : faces) {
      const surfaces::PartFace& one = subject_.part.faces[static_cast<std::size_t>(face)];
      const bool is_plane = one.surface.kind == surfaces::SurfaceKind::plane;
      if (is_plane && std::abs(glm::dot(one.surface.axis, view.projection().n)) < 1 - max_tilt * max_tilt) continue;
      const std::vector<SeenMark> marks = view.marks_on({subject_.model, face}, one);
      if (marks.empty() || marks.front().worth <= most) continue;
      most = marks.front().worth;
      callout.view = {view.name(), callout.where};
    }
  if (most > 0) callout.to = {scene::LeaderTarget(scene::Anchor(point)), callout.where};
  return most > 0;
}

bool SymbolPlaces::place_at_edge(scene::CalloutDescription& callout, const std::vector<std::array<double, 6>>& lines,
                                 Ends ends) const {
  std::vector<Vec3> points;
  for (const std::array<double, 6>& line : lines) {
    const Vec3 from = subject_.placed({line[0], line[1], line[2]}), to = subject_.placed({line[3], line[4], line[5]});
    if (lines.size() == 1) points.push_back((from + to) / 2.0);
    points.insert(points.end(), {to, from});
  }
  const Vec3 edge = points[1] - points.back();
  const double length = lines.size() == 1 ? glm::length(edge) : 0;
  bool is_usual = false;
  for (const FaceView& view : subject_.views) {
    const double along = length > 0 ? std::abs(glm::dot(edge, view.projection().n)) / length : 0;
    const bool is_usual_here = (along >= 1 - max_tilt * max_tilt) != (ends == Ends::element);
    const bool is_better_view = !callout.view.given() || (!is_usual && is_usual_here);
    const auto seen =
        std::find_if(points.begin(), points.end(), [&view](const Vec3& point) { return view.shows(point); });
    if (!is_better_view || seen == points.end()) continue;
    is_usual = is_usual_here;
    callout.view = {view.name(), callout.where};
    callout.to = {scene::LeaderTarget(scene::Anchor(*seen)), callout.where};
  }
  return callout.view.given();
}

std::vector<std::vector<std::size_t>> stacks_of(const std::vector<ModelRequirement>& all) {
  std::vector<std::vector<std::size_t>> stacks;
  std::map<std::tuple<bool, std::vector<int>, std::vector<std::array<double, 6>>>, std::size_t> by_faces;
  std::map<std::string, std::size_t> by_id;
  const auto add = [&](std::size_t i, bool is_composite) {
    const ModelRequirement& one = all[i];
    std::size_t stack = stacks.size();
    if (is_composite) {
      if (const auto known = by_id.find(one.above); known != by_id.end()) stack = known->second;
    } else if (!one.faces.empty()) {
      stack = by_faces.emplace(std::tuple(one.type == "straightness", one.faces, one.lines), stack).first->second;
    }
    if (stack == stacks.size()) stacks.emplace_back();
    stacks[stack].push_back(i);
    by_id.emplace(one.id, stack);
  };
  for (const bool is_composite : {false, true})
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].kind == RequirementKind::tolerance && all[i].above.empty() != is_composite) add(i, is_composite);
  return stacks;
}

scene::ToleranceFrame frame_of(const std::vector<ModelRequirement>& all, std::vector<std::size_t>& stack,
                               const RequirementSubject& subject,
                               std::vector<std::pair<std::size_t, std::string>>& refused) {
  scene::ToleranceFrame whole;
  std::vector<std::size_t> written;
  for (const std::size_t i : stack) {
    scene::ToleranceFrame frame;
    if (std::string why = write_frame(frame, all[i], subject.manner); !why.empty()) {
      refused.emplace_back(i, std::move(why));
      continue;
    }
    written.push_back(i);
    if (written.size() == 1) {
      whole = std::move(frame);
      continue;
    }
    // Below the one to which the frames belong, words would stand on its lines.
    if (!frame.above.empty()) add_above(whole, frame.above);
    frame.above.clear();
    frame.is_composite = !all[i].above.empty();
    whole.letters.insert(whole.letters.end(), frame.letters.begin(), frame.letters.end());
    whole.also.push_back(std::move(frame));
  }
  stack = std::move(written);
  return whole;
}

}  // namespace epura::pipeline
