// SPDX-License-Identifier: Apache-2.0
#include "pipeline/draw_view.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "drawing/cut_faces.hpp"
#include "edges/suspects.hpp"
#include "verify/outline.hpp"
#include "verify/verify.hpp"
#include "visibility/height_field.hpp"

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

std::string why_not_clipped(const ProjectedScene& view) {
  if (view.idle_planes.empty()) return "a parallel view has no near plane, and no window or depth is given";
  return "everything lies inside the view volume";
}

PlanStep clip_step(const World& world, const ProjectedScene& view, const ViewOptions& wish) {
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

// For what may be spared of the search for crossings.
constexpr double part_for_suspects = 0.25;
// Of the time for lines; the rest is for drawing them.
constexpr double part_for_hiding = 0.7;
// No span longer than this part of the drawing is shown wrongly (docs/numerics.md).
constexpr double guaranteed_part = 1e-6;

std::string why_searched(const World& world, const ViewOptions& wish, std::size_t suspects) {
  const std::string all = std::to_string(world.triangles.size());
  if (!wish.edges.intersection) return "not wanted";
  if (suspects == 0) return "all bodies are convex, and their boxes stand apart";
  if (!wish.leave_out.intersections) return "--plan wants it";
  if (suspects == world.triangles.size()) return "no convex body stands apart from all others";
  return std::to_string(suspects) + " of " + all +
         " triangles; the others are of convex bodies that stand apart, or copies";
}

Suspects find_suspects(const World& world, const ProjectedScene& view, const ViewOptions& wish, double contact,
                       const Progress& progress) {
  Suspects suspects{{}, {"intersections", false, "", count_of(world.triangles.size()), 0}};
  if (wish.edges.intersection)
    suspects.triangles =
        !wish.leave_out.intersections ? all_triangles(world) : timed(suspects.step.times.certificate, [&] {
          return crossing_suspects(world, view.map.scale_exponent, contact, progress);
        });
  suspects.step.run = !suspects.triangles.empty();
  if (wish.edges.intersection) suspects.step.skipped = count_of(world.triangles.size() - suspects.triangles.size());
  suspects.step.why = why_searched(world, wish, suspects.triangles.size());
  return suspects;
}

// Without time to find out which triangles may cross, all may.
Suspects find_suspects_in_time(const World& world, const ProjectedScene& view, const ViewOptions& wish, double contact,
                               const Progress& progress) {
  progress.begin("finding bodies that cross nothing");
  try {
    return find_suspects(world, view, wish, contact, progress.with_part_of_the_time(part_for_suspects));
  } catch (const OutOfTime&) {
    ViewOptions all = wish;
    all.leave_out.intersections = false;
    Suspects suspects = find_suspects(world, view, all, contact, progress);
    suspects.step.why = "there was no time to find what may be left out";
    return suspects;
  }
}

// None where there is not even time for those of the meshes.
FeatureEdges find_edges(const World& world, ProjectedScene& view, const ViewOptions& wish, std::vector<PlanStep>& plan,
                        const Budget& budget) {
  const double contact = contact_in_space(world, view, wish.contact);
  Suspects suspects = find_suspects_in_time(world, view, wish, contact, budget.lines);
  FeatureEdges drawn;
  try {
    drawn = find_feature_edges(world, view, wish.edges, contact, suspects.triangles, budget.lines);
    if (drawn.searched < 1) budget.partial.add_stage("finding intersections");
    budget.partial.searched = drawn.searched;
  } catch (const OutOfTime& cut) {
    budget.partial.add_stage(cut.stage);
  }
  budget.partial.edges = count_of(drawn.edges.size());
  suspects.step.items_out = count_of(drawn.crossings.size());
  plan.push_back(std::move(suspects.step));
  return drawn;
}

// All but the longest edges are left undecided. Says whether so few are left that they take no time.
bool keep_longest(const ProjectedScene& view, FeatureEdges& drawn, HiddenSpans& hidden, const std::string& stage,
                  Partial& partial) {
  hidden.undecided = all_but_longest(view, drawn.edges, fewer(drawn.edges.size()));
  partial.add_stage(stage);
  partial.undecided += count_of(hidden.undecided.size());
  keep_decided(drawn, hidden);
  return drawn.edges.size() <= few_lines;
}

HiddenSpans hide(const World& world, const ProjectedScene& view, FeatureEdges& drawn, const Contact& contact,
                 const ViewOptions& wish, std::vector<PlanStep>& plan, const Budget& budget) {
  PlanStep step{"visibility", false, "a wireframe is wanted", count_of(drawn.edges.size()), 0};
  HiddenSpans hidden = nothing_hidden(drawn);
  const bool wanted = !wish.wireframe;
  const bool one_sheet = wanted && wish.leave_out.visibility &&
                         timed(step.times.certificate, [&] { return is_height_field(world, view, drawn); });
  if (one_sheet) {
    step.why = "the page shows the surface as one sheet";
    step.skipped = step.items_in;
  }
  if (wanted && !one_sheet) {
    step.run = true;
    step.why = wish.leave_out.visibility ? "exact" : "--plan wants it";
    int cuts = 0;
    // After two tries in vain it is faces that take the time, and ever fewer lines do not help.
    const auto is_direct = [&] { return cuts == 2; };
    const auto make = [&](const Progress& progress) {
      return is_direct() ? find_hidden_directly(world, view, drawn, contact, progress)
                         : find_hidden(world, view, drawn, contact, progress);
    };
    const auto leave_out = [&](const std::string& stage) {
      if (is_direct()) throw OutOfTime{stage};
      ++cuts;
      hidden = nothing_hidden(drawn);
      keep_longest(view, drawn, hidden, stage, budget.partial);
      return false;
    };
    try {
      hidden = timed(step.times.stage, [&] {
        return make_in_time(budget.lines.with_part_of_the_time(part_for_hiding), budget.last(), make, leave_out);
      });
    } catch (const OutOfTime& cut) {
      budget.partial.add_stage(cut.stage);
      hidden = nothing_hidden(drawn);
      hidden.undecided = all_but_longest(view, drawn.edges, 0);
    }
  }
  if (!hidden.undecided.empty()) budget.partial.add_stage("hiding lines");
  budget.partial.undecided += count_of(hidden.undecided.size());
  keep_decided(drawn, hidden);
  step.items_out = count_of(hidden.spans.size());
  plan.push_back(std::move(step));
  return hidden;
}

PlanStep hidden_step(const ViewOptions& wish, const HiddenSpans& hidden) {
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

// What is guaranteed, in mm, where so much is allowed.
std::optional<double> error_within(const std::optional<double>& allowed, const ProjectedScene& view,
                                   const PaperMap& paper) {
  if (!allowed) return std::nullopt;
  const double guaranteed = guaranteed_part * view.extent * paper.scale;
  if (guaranteed <= *allowed) return guaranteed;
  throw Error(
      ErrorKind::input, "--max-error", "is " + format_number(*allowed) + " mm, and less is not guaranteed",
      "the exact method guarantees " + format_rounded(guaranteed, 3) + " mm, a millionth of the drawing, in this view");
}

PlanStep section_step(const CutSection& section) {
  return {"section", true, "the view shows section " + section.plane.name, count_of(section.cut.world.models.size()),
          count_of(section.cut.faces.size())};
}

struct ViewInWork {
  const World& world;
  const ProjectedScene& view;
  const ViewOptions& wish;
  FeatureEdges& drawn;
  HiddenSpans& hidden;
  const Contact& contact;
  const PaperMap& paper;
};

std::optional<Verification> verify_view(const ViewInWork& work, const ViewDrawing& drawing, bool complete,
                                        const Progress& progress) {
  const auto& [world, view, wish, drawn, hidden, contact, paper] = work;
  if (!wish.verify) return std::nullopt;
  progress.begin("verifying");
  const Tolerance tolerance{view.extent * paper.scale, contact.touching * paper.scale};
  const VerifyInput claim{world, view.projection, wish.limits, drawn, hidden, drawing};
  Verification found = verify(claim, tolerance, *wish.verify, wish.keep_hidden(), progress);
  // A window that is given cuts lines off; otherwise it is the box of what is seen, and lines lie on its border.
  const double margin = view.window_given ? 0 : 0.01 * view.extent;
  const auto place = [&on_paper = paper, &seen = view](const Vec2& corner) {
    return on_paper.origin + on_paper.scale * (corner - seen.middle);
  };
  const Window window{place(view.window.min - margin), place(view.window.max + margin)};
  found.outline = verify_outline(claim, tolerance, {wish.edges, *wish.verify, complete, window, progress});
  return found;
}

struct DrawnLines {
  ViewDrawing drawing;
  CurveReport curves;
};

// Where there is no time for all lines, of the longest edges.
DrawnLines draw_lines(const ViewInWork& work, const Budget& budget) {
  const ViewOptions& wish = work.wish;
  const auto make = [&](const Progress& progress) {
    DrawnLines lines;
    lines.drawing = make_drawing(work.world, work.view, work.drawn, work.hidden, work.contact, work.paper,
                                 {wish.name, wish.keep_hidden(), wish.leave_out.hidden}, progress);
    if (wish.arcs) lines.curves = find_curves(lines.drawing.chains, *wish.arcs, progress);
    return lines;
  };
  const auto leave_out = [&](const std::string& stage) {
    return keep_longest(work.view, work.drawn, work.hidden, stage, budget.partial);
  };
  return make_in_time(budget.lines, budget.last(), make, leave_out);
}

}  // namespace

bool ViewOptions::keep_hidden() const {
  return std::any_of(looks.begin(), looks.end(),
                     [](const ModelStyle& look) { return look.hidden != HiddenLines::none; });
}

void Stopwatch::lap(const std::string& stage) {
  const auto now = std::chrono::steady_clock::now();
  laps_.emplace_back(stage, std::chrono::duration<double>(now - start_).count());
  start_ = now;
}

ViewResult draw_view(const World& world, const CutSection* section, ProjectedScene view, const ViewOptions& wish,
                     const PlaceOnPage& place, std::vector<PlanStep>& plan, Stopwatch& watch, const ViewTime& time) {
  Partial partial;
  const Budget budget{time.run, time.lines, partial};
  const auto first_step = static_cast<std::ptrdiff_t>(plan.size());
  if (section != nullptr) plan.push_back(section_step(*section));
  plan.push_back(clip_step(world, view, wish));
  FeatureEdges drawn = find_edges(world, view, wish, plan, budget);
  watch.lap("edges");

  const Contact contact = contact_of(world, view, wish.contact);
  const PaperMap paper = make_paper_map(view, place.scale, place.shift);
  const std::optional<double> max_error = error_within(wish.max_error, view, paper);
  HiddenSpans hidden = hide(world, view, drawn, contact, wish, plan, budget);
  plan.push_back(hidden_step(wish, hidden));
  std::for_each(plan.begin() + first_step, plan.end(), [&](PlanStep& step) { step.view = wish.name; });
  watch.lap("visibility");

  const ViewInWork work{world, view, wish, drawn, hidden, contact, paper};
  DrawnLines lines = draw_lines(work, budget);
  ViewDrawing& drawing = lines.drawing;
  if (section != nullptr) drawing.cut_faces = cut_faces_on_paper(section->cut.faces, section->plane, view, paper);
  watch.lap("drawing");
  drawing.scale = place.scale;
  auto verification = budget.or_nothing(
      [&](const Progress& progress) { return verify_view(work, drawing, partial.stages.empty(), progress); });
  if (wish.verify) watch.lap("verify");
  auto circles = budget.or_nothing([&](const Progress& progress) {
    return wish.centre_lines ? find_placed_circles(world, wish.edges.crease_angle, progress)
                             : std::vector<PlacedCircle>();
  });
  return {{std::move(view), std::move(drawn), contact, std::move(hidden), paper},
          std::move(drawing),
          std::move(partial),
          std::move(verification),
          section != nullptr ? std::optional(section->plane) : std::nullopt,
          lines.curves,
          std::move(circles),
          max_error};
}

}  // namespace epura
