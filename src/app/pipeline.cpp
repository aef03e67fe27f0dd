#include "app/pipeline.hpp"

#include <algorithm>
#include <utility>

#include "drawing/cut_faces.hpp"
#include "study/verify/verify.hpp"

namespace epura {

namespace {

long long count_of(std::size_t n) { return static_cast<long long>(n); }

PlanStep clip_step(const World& world, const View& view) {
  const bool run = !view.triangle_planes.empty();
  return {"clip", run,
          run ? "part of the model lies outside the view volume" : "everything lies inside the view volume",
          count_of(world.triangles.size()), count_of(view.triangles.size())};
}

PlanStep intersection_step(const World& world, const EdgeWishes& wishes, const DrawnEdges& drawn) {
  return {"intersections", wishes.intersection, wishes.intersection ? "wanted" : "not wanted",
          count_of(world.triangles.size()), count_of(drawn.crossings.size())};
}

PlanStep visibility_step(const Method& method, const DrawnEdges& drawn, const HiddenSpans& hidden) {
  const bool run = method.way != Way::none;
  return {"visibility", run, run ? text_of(method) : "a wireframe is wanted", count_of(drawn.edges.size()),
          count_of(hidden.spans.size())};
}

MethodChoice choice_for(const ViewWish& wish, const View& view, const DrawnEdges& drawn, const PaperMap& paper) {
  if (!wish.max_error) return {wish.method, 0, {}};
  return choose_method(view, drawn, paper.scale, *wish.max_error);
}

PlanStep section_step(const CutSection& section) {
  return {"section", true, "the view shows section " + section.plane.name, count_of(section.cut.world.models.size()),
          count_of(section.cut.faces.size())};
}

std::optional<Partial> partial_of(const DrawnEdges& drawn, const HiddenSpans& hidden) {
  if (drawn.searched == 1 && hidden.undecided.empty()) return std::nullopt;
  return Partial{count_of(drawn.edges.size()), count_of(hidden.undecided.size()), drawn.searched};
}

}  // namespace

bool ViewWish::keep_hidden() const {
  return std::any_of(looks.begin(), looks.end(),
                     [](const ModelLook& look) { return look.hidden != HiddenLines::none; });
}

void Stopwatch::lap(const std::string& stage) {
  const auto now = std::chrono::steady_clock::now();
  laps_.emplace_back(stage, std::chrono::duration<double>(now - start_).count());
  start_ = now;
}

ViewResult draw_view(const World& world, const CutSection* section, View view, const ViewWish& wish,
                     const PlaceOnPage& place, std::vector<PlanStep>& plan, Stopwatch& watch, Progress progress) {
  if (section != nullptr) plan.push_back(section_step(*section));
  plan.push_back(clip_step(world, view));
  DrawnEdges drawn = find_drawn_edges(world, view, wish.edges, contact_in_space(world, view, wish.contact), progress);
  plan.push_back(intersection_step(world, wish.edges, drawn));
  watch.lap("edges");

  const Contact contact = contact_of(world, view, wish.contact);
  const PaperMap paper = make_paper_map(view, place.scale, place.shift);
  MethodChoice choice = choice_for(wish, view, drawn, paper);
  HiddenSpans hidden = find_hidden(world, view, drawn, contact, choice.method, paper.scale, progress);
  plan.push_back(visibility_step(choice.method, drawn, hidden));
  const std::optional<Partial> partial = partial_of(drawn, hidden);
  keep_decided(drawn, hidden);
  watch.lap("visibility");

  progress.begin("drawing");
  Drawing drawing = make_drawing(world, view, drawn, hidden, contact, paper, {wish.name, wish.keep_hidden()});
  const CurveReport curves = wish.arcs ? find_curves(drawing.chains, *wish.arcs) : CurveReport{};
  if (section != nullptr) drawing.cut_faces = cut_faces_on_paper(section->cut.faces, section->plane, view, paper);
  watch.lap("drawing");
  drawing.scale = place.scale;
  std::optional<Verification> verification;
  if (wish.verify) {
    progress.begin("verifying");
    const Tolerance tolerance{view.extent * paper.scale, contact.touching * paper.scale};
    verification = verify({world, view.projection, wish.limits, drawn, hidden, drawing}, tolerance, *wish.verify,
                          wish.keep_hidden());
    watch.lap("verify");
  }
  return {{std::move(view), std::move(drawn), contact, std::move(hidden), paper},
          std::move(drawing),
          partial,
          std::move(verification),
          section != nullptr ? std::optional(section->plane) : std::nullopt,
          curves,
          wish.centre_lines ? find_placed_circles(world, wish.edges.crease_angle) : std::vector<PlacedCircle>(),
          std::move(choice)};
}

}  // namespace epura
