#include "app/pipeline.hpp"

#include <algorithm>
#include <utility>

#include "drawing/cut_faces.hpp"
#include "edges/suspects.hpp"
#include "study/verify/outline.hpp"
#include "study/verify/verify.hpp"
#include "visibility/one_sheet.hpp"

namespace epura {

namespace {

long long count_of(std::size_t n) { return static_cast<long long>(n); }

// What `compute` gives, and the seconds that it took.
template <class Compute>
auto timed(std::optional<double>& seconds, const Compute& compute) {
  const auto start = std::chrono::steady_clock::now();
  auto result = compute();
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

std::string why_not_clipped(const View& view) {
  if (view.idle_planes.empty()) return "a parallel view has no near plane, and no window or depth is given";
  return "everything lies inside the view volume";
}

PlanStep clip_step(const World& world, const View& view, const ViewWish& wish) {
  const bool cuts = !view.triangle_planes.empty();
  const bool run = cuts || (!wish.leave_out.clip && !view.idle_planes.empty());
  return {"clip",
          run,
          cuts  ? "part of the model lies outside the view volume"
          : run ? "--plan wants it"
                : why_not_clipped(view),
          count_of(world.triangles.size()),
          count_of(view.triangles.size()),
          {},
          run ? 0 : count_of(world.triangles.size())};
}

// What is known of intersections before they are searched.
struct Suspects {
  std::vector<int> triangles;
  PlanStep step;
};

std::string why_searched(const World& world, const ViewWish& wish, std::size_t suspects) {
  const std::string all = std::to_string(world.triangles.size());
  if (!wish.edges.intersection) return "not wanted";
  if (suspects == 0) return "all bodies are convex, and their boxes stand apart";
  if (!wish.leave_out.intersections) return "--plan wants it";
  if (suspects == world.triangles.size()) return "no convex body stands apart from all others";
  return std::to_string(suspects) + " of " + all +
         " triangles; the others are of convex bodies that stand apart, or copies";
}

Suspects find_suspects(const World& world, const View& view, const ViewWish& wish, double contact) {
  Suspects suspects{{}, {"intersections", false, "", count_of(world.triangles.size()), 0}};
  if (wish.edges.intersection)
    suspects.triangles =
        !wish.leave_out.intersections ? all_triangles(world) : timed(suspects.step.times.certificate, [&] {
          return crossing_suspects(world, view.map.shrink, contact);
        });
  suspects.step.run = !suspects.triangles.empty();
  if (wish.edges.intersection) suspects.step.spared = count_of(world.triangles.size() - suspects.triangles.size());
  suspects.step.why = why_searched(world, wish, suspects.triangles.size());
  return suspects;
}

DrawnEdges find_edges(const World& world, View& view, const ViewWish& wish, std::vector<PlanStep>& plan,
                      Progress progress) {
  const double contact = contact_in_space(world, view, wish.contact);
  Suspects suspects = find_suspects(world, view, wish, contact);
  DrawnEdges drawn = find_drawn_edges(world, view, wish.edges, contact, suspects.triangles, progress);
  suspects.step.items_out = count_of(drawn.crossings.size());
  plan.push_back(std::move(suspects.step));
  return drawn;
}

HiddenSpans hide(const World& world, const View& view, const DrawnEdges& drawn, const Contact& contact,
                 const ViewWish& wish, const Method& method, double scale, std::vector<PlanStep>& plan,
                 Progress progress) {
  PlanStep step{"visibility", false, "a wireframe is wanted", count_of(drawn.edges.size()), 0};
  HiddenSpans hidden = nothing_hidden(drawn);
  const bool wanted = method.way != Way::none;
  const bool one_sheet = wanted && wish.leave_out.visibility &&
                         timed(step.times.certificate, [&] { return is_one_sheet(world, view, drawn); });
  if (one_sheet) {
    step.why = "the page shows the surface as one sheet";
    step.spared = step.items_in;
  }
  if (wanted && !one_sheet) {
    step.run = true;
    step.why = wish.leave_out.visibility ? text_of(method) : "--plan wants it";
    hidden = timed(step.times.stage, [&] { return find_hidden(world, view, drawn, contact, method, scale, progress); });
  }
  step.items_out = count_of(hidden.spans.size());
  plan.push_back(std::move(step));
  return hidden;
}

PlanStep hidden_step(const ViewWish& wish, const HiddenSpans& hidden) {
  const bool run = wish.keep_hidden() || !wish.leave_out.hidden;
  return {"hidden",
          run,
          wish.keep_hidden() ? "hidden lines are drawn"
          : run              ? "--plan wants it"
                             : "only visible lines are drawn",
          count_of(hidden.spans.size()),
          run ? count_of(hidden.spans.size()) : 0,
          {},
          run ? 0 : count_of(hidden.spans.size())};
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

std::optional<Verification> verify_view(const World& world, const View& view, const ViewWish& wish,
                                        const DrawnEdges& drawn, const HiddenSpans& hidden, const Contact& contact,
                                        const Drawing& drawing, const PaperMap& paper, bool complete) {
  if (!wish.verify) return std::nullopt;
  const Tolerance tolerance{view.extent * paper.scale, contact.touching * paper.scale};
  const Claim claim{world, view.projection, wish.limits, drawn, hidden, drawing};
  Verification found = verify(claim, tolerance, *wish.verify, wish.keep_hidden());
  // A window that is given cuts lines off; otherwise it is the box of what is seen, and lines lie on its border.
  const double margin = view.window_given ? 0 : 0.01 * view.extent;
  const auto place = [&](const Vec2& corner) { return paper.origin + paper.scale * (corner - view.middle); };
  const Window window{place(view.window.least - margin), place(view.window.most + margin)};
  found.outline = verify_outline(claim, tolerance, {wish.edges, *wish.verify, complete, window});
  return found;
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
  const auto first_step = static_cast<std::ptrdiff_t>(plan.size());
  if (section != nullptr) plan.push_back(section_step(*section));
  plan.push_back(clip_step(world, view, wish));
  DrawnEdges drawn = find_edges(world, view, wish, plan, progress);
  watch.lap("edges");

  const Contact contact = contact_of(world, view, wish.contact);
  const PaperMap paper = make_paper_map(view, place.scale, place.shift);
  MethodChoice choice = choice_for(wish, view, drawn, paper);
  HiddenSpans hidden = hide(world, view, drawn, contact, wish, choice.method, paper.scale, plan, progress);
  plan.push_back(hidden_step(wish, hidden));
  std::for_each(plan.begin() + first_step, plan.end(), [&](PlanStep& step) { step.view = wish.name; });
  const std::optional<Partial> partial = partial_of(drawn, hidden);
  keep_decided(drawn, hidden);
  watch.lap("visibility");

  progress.begin("drawing");
  Drawing drawing =
      make_drawing(world, view, drawn, hidden, contact, paper, {wish.name, wish.keep_hidden(), wish.leave_out.hidden});
  const CurveReport curves = wish.arcs ? find_curves(drawing.chains, *wish.arcs) : CurveReport{};
  if (section != nullptr) drawing.cut_faces = cut_faces_on_paper(section->cut.faces, section->plane, view, paper);
  watch.lap("drawing");
  drawing.scale = place.scale;
  if (wish.verify) progress.begin("verifying");
  auto verification = verify_view(world, view, wish, drawn, hidden, contact, drawing, paper, !partial);
  if (wish.verify) watch.lap("verify");
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
