#include "app/pipeline.hpp"

#include <algorithm>

#include "study/verify.hpp"
#include "view/paper_map.hpp"
#include "visibility/visibility.hpp"

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

PlanStep visibility_step(bool run, const DrawnEdges& drawn, const HiddenSpans& hidden) {
  return {"visibility", run, run ? "exact" : "a wireframe is wanted", count_of(drawn.edges.size()),
          count_of(hidden.spans.size())};
}

}  // namespace

void Stopwatch::lap(const std::string& stage) {
  const auto now = std::chrono::steady_clock::now();
  laps_.emplace_back(stage, std::chrono::duration<double>(now - start_).count());
  start_ = now;
}

ViewResult draw_view(const World& world, const Projection& projection, const ViewWish& wish,
                     std::vector<PlanStep>& plan, Stopwatch& watch) {
  View view = make_view(world, projection, wish.limits);
  plan.push_back(clip_step(world, view));
  watch.lap("view");

  const DrawnEdges drawn = find_drawn_edges(world, view, wish.edges, contact_in_space(world, view, wish.contact));
  plan.push_back(intersection_step(world, wish.edges, drawn));
  watch.lap("edges");

  const Contact contact = contact_of(world, view, wish.contact);
  const HiddenSpans hidden = wish.remove_hidden ? find_hidden(world, view, drawn, contact) : nothing_hidden(drawn);
  plan.push_back(visibility_step(wish.remove_hidden, drawn, hidden));
  watch.lap("visibility");

  const Window box = drawn_box(view);
  const Placement placement = place_ink(box.least, box.most, wish.scale, wish.paper);
  const PaperMap paper = make_paper_map(view, placement.scale, placement.shift);
  Drawing drawing = make_drawing(world, view, drawn, hidden, contact, paper, {projection.name, wish.keep_hidden});
  watch.lap("drawing");
  if (!wish.verify) return {std::move(drawing), placement, {}};
  const Tolerance tolerance{view.extent * paper.scale, contact.touching * paper.scale};
  Verification found =
      verify({world, projection, wish.limits, drawn, hidden, drawing}, tolerance, *wish.verify, wish.keep_hidden);
  watch.lap("verify");
  return {std::move(drawing), placement, std::move(found)};
}

}  // namespace epura
