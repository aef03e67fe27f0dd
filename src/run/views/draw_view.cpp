// SPDX-License-Identifier: Apache-2.0
#include "views/draw_view.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "accuracy/view_error.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "drawing/chain_lines.hpp"
#include "drawing/chains.hpp"
#include "drawing/clip_drawing.hpp"
#include "drawing/cut_faces.hpp"
#include "drawing/exact_lines.hpp"
#include "drawing/make_drawing.hpp"
#include "drawing/symmetry.hpp"
#include "edges/crossing_candidates.hpp"
#include "refine/refine_world.hpp"
#include "verify/ink_judge.hpp"
#include "verify/outline.hpp"
#include "verify/verify.hpp"
#include "views/breaks.hpp"
#include "views/details.hpp"
#include "views/time_for_lines.hpp"
#include "views/view_error.hpp"
#include "visibility/folds.hpp"
#include "visibility/height_field.hpp"
#include "visibility/in_sight.hpp"

namespace epura::pipeline {

namespace {

long long count_of(std::size_t n) { return static_cast<long long>(n); }

// Returns the result of `compute`, and the seconds that it took.
template <class Compute>
auto timed(std::optional<double>& seconds, const Compute& compute) {
  const auto start = std::chrono::steady_clock::now();
  auto result = compute();
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

std::string why_not_clipped(const view::ProjectedScene& view) {
  if (view.idle_planes.empty()) return "a parallel view has no near plane, and no window or depth is given";
  return "everything lies inside the view volume";
}

report::PlanStep clip_step(const world::World& world, const view::ProjectedScene& view, const ViewOptions& options) {
  const bool cuts = !view.triangle_planes.empty();
  const bool run = cuts || (!options.leave_out.clip && !view.idle_planes.empty());
  return {"clip",
          run,
          cuts  ? "part of the model lies outside the view volume"
          : run ? "requested by --plan"
                : why_not_clipped(view),
          count_of(world.triangles.size()),
          count_of(view.triangles.size()),
          {},
          run ? 0 : count_of(world.triangles.size())};
}

// Candidates for intersections, determined before the search.
struct Candidates {
  edges::CrossingCandidates crossing;
  report::PlanStep step;
  bool left_out = false;  ///< there is no time for the search
};

// Fraction of the time, for excluding bodies from the search for intersections.
constexpr double part_for_candidates = 0.25;
// Fraction of the time for lines; the rest is for drawing them. Hiding takes it whole only where it ends in it.
constexpr double part_for_hiding = 0.9;

std::string why_searched(const world::World& world, const ViewOptions& options, std::size_t candidates) {
  const std::string all = std::to_string(world.triangles.size());
  if (!options.edges.intersection) return "not wanted";
  if (candidates == 0) return "all bodies are convex, and their boxes stand apart";
  if (!options.leave_out.intersections) return "requested by --plan";
  if (candidates == world.triangles.size()) return "no convex body stands apart from all others";
  return std::to_string(candidates) + " of " + all +
         " triangles; the others are of convex bodies that stand apart, or copies";
}

report::PlanStep hidden_step(const ViewOptions& options, const visibility::HiddenSpans& hidden) {
  const bool run = options.keep_hidden() || !options.leave_out.hidden;
  return {"hidden",
          run,
          options.keep_hidden() ? "hidden lines are drawn"
          : run                 ? "requested by --plan"
                                : "only visible lines are drawn",
          count_of(hidden.spans.size()),
          run ? count_of(hidden.spans.size()) : 0,
          {},
          run ? 0 : count_of(hidden.spans.size())};
}

report::PlanStep section_step(const CutSection& section) {
  return {"section", true, "the view shows section " + section.surface.plane.name,
          count_of(section.cut.world.models.size()), count_of(section.cut.faces.size())};
}

view::Clipping clipping_of(const ViewOptions& options) {
  return options.leave_out.clip ? view::Clipping::where_needed : view::Clipping::everywhere;
}

drawing::NearLines near_lines(const ViewOptions& options) {
  return {options.join_within, [&options](int model, int body, EdgeKind kind, bool visible) {
            return sheet::line_strength(kind, visible, options.styles(model, body));
          }};
}

// Under --max-error, neither the tolerance nor the rise over a chord takes more than its part.
drawing::CurveReport curves_of(const ViewOptions& options, const world::World& world, drawing::ViewDrawing& drawing,
                               const Progress& progress) {
  drawing::CurveLimits limits{*options.arcs};
  if (options.max_error) {
    const double part = row_of(report::ErrorTerm::curves).share * *options.max_error;
    limits.tolerance = std::min(limits.tolerance, part / 4);
    limits.max_rise = 0.75 * part;
  }
  return drawing::draw_exactly(world, drawing, limits, progress);
}

report::InkCheck unjudged(const drawing::ViewDrawing& drawing, const std::string& what) {
  report::InkCheck check;
  for (const drawing::Chain& chain : drawing.chains)
    drawing::visit_lines(chain, [&](const Vec2& from, const Vec2& to) { check.length += glm::distance(from, to); });
  if (check.length > 0) check.unjudged.push_back({what, check.length});
  return check;
}

struct DrawnLines {
  drawing::ViewDrawing drawing;
  drawing::CurveReport curves;
};

/// One view on its way through the stages.
class ViewRun {
 public:
  ViewRun(const ViewInput& input, view::ProjectedScene view, const ViewTime& time, Stopwatch& watch)
      : input_(input),
        refined_(refine::refine_world(input.world, view.projection)),
        world_(refined_ ? *refined_ : input.world),
        options_(input.options),
        view_(refined_ ? view::project_scene(world_, view.projection, options_.limits, clipping_of(options_))
                       : std::move(view)),
        watch_(watch),
        budget_{time.run, time.lines, partial_} {
    if (input_.section != nullptr) plan_.push_back(section_step(*input_.section));
    plan_.push_back(clip_step(world_, view_, options_));
  }

  ViewResult run() {
    const view::PaperMap paper = view::make_paper_map(view_, input_.place.scale, input_.place.shift);
    find_edges();
    watch_.lap("edges");
    hide();
    plan_.push_back(hidden_step(options_, hidden_));
    for (report::PlanStep& step : plan_) step.view = options_.name;
    watch_.lap("visibility");
    DrawnLines lines = draw_lines(paper);
    if (!input_.traces.empty() && !options_.detail)
      lines.drawing.aids.traces = budget_.or_nothing([&](const Progress& progress) { return traces(paper, progress); });
    watch_.lap("drawing");
    std::optional<report::ViewError> error = judged(lines, paper);
    auto verification = budget_.or_nothing([&](const Progress& progress) { return verified(lines, error, progress); });
    if (options_.verify) watch_.lap("verify");
    for (const BrokenOutSection& one : input_.broken_out) break_out(lines, one, verification, error);
    if (options_.detail) show_detail(lines);
    const double unsymmetric = options_.breaks.any() ? break_view(lines) : 0;
    add_revolved(lines.drawing, options_.revolved);
    if (error) (*error)[report::ErrorTerm::curves] = lines.curves.deviation + lines.curves.bulge;
    auto features = budget_.or_nothing([&](const Progress& progress) {
      return options_.centre_lines
                 ? features::find_centred_features(input_.world, options_.edges.crease_angle, progress)
                 : features::CentredFeatures();
    });
    return {{std::move(view_), std::move(drawn_), std::move(hidden_), paper},
            std::move(lines.drawing),
            std::move(plan_),
            std::move(partial_),
            std::move(verification),
            input_.section != nullptr ? std::optional(input_.section->surface) : std::nullopt,
            lines.curves,
            std::move(features),
            std::move(error),
            unsymmetric};
  }

 private:
  Candidates find_candidates(bool may_leave_out, const Progress& progress) const;
  Candidates find_candidates_in_time() const;
  [[nodiscard]] SharedWorld shared_world() const {
    return {input_.world, refined_ ? &*refined_ : nullptr, view_, options_.edges};
  }
  void keep_intersections(const report::PlanStep& step);
  void find_edges();
  void hide();
  void find_clear_contours();
  void hide_folds();
  visibility::HiddenSpans hidden_in_time();
  bool leave_undecided(const std::string& stage, std::vector<int> edges);
  [[nodiscard]] drawing::DrawingOptions drawing_options(double least_crease) const;
  drawing::ViewDrawing drawn_on(const view::PaperMap& paper, const edges::FeatureEdges& edges, double least_crease,
                                const Progress& progress) const;
  DrawnLines draw_lines(const view::PaperMap& paper);
  template <class Change>
  void change(DrawnLines& lines, const Change& change_drawing);
  [[nodiscard]] std::optional<report::ViewError> judged(const DrawnLines& lines, const view::PaperMap& paper) const;
  void break_out(DrawnLines& lines, const BrokenOutSection& one, std::optional<report::Verification>& verification,
                 std::optional<report::ViewError>& error);
  ViewResult cut_view(const BrokenOutSection& one);
  void show_detail(DrawnLines& lines);
  double break_view(DrawnLines& lines);
  std::vector<std::array<Vec2, 2>> traces(const view::PaperMap& paper, const Progress& progress);
  std::optional<report::Verification> verified(const DrawnLines& lines, const std::optional<report::ViewError>& error,
                                               const Progress& progress) const;
  [[nodiscard]] verify::Tolerance tolerance_on(const view::PaperMap& paper) const {
    return {view_.extent * paper.scale, view_.contact.touching * paper.scale};
  }

  const ViewInput& input_;
  const std::optional<refine::RefinedWorld> refined_;  ///< nothing if there is nothing to refine
  const world::World& world_;                          ///< whose edges are drawn
  const ViewOptions& options_;
  view::ProjectedScene view_;
  edges::FeatureEdges drawn_{};
  visibility::HiddenSpans hidden_{};
  std::vector<report::PlanStep> plan_{};
  report::Partial partial_{};
  Stopwatch& watch_;
  Budget budget_;
};

Candidates ViewRun::find_candidates(bool may_leave_out, const Progress& progress) const {
  Candidates candidates{{}, {"intersections", false, "", count_of(world_.triangles.size()), 0}};
  if (options_.edges.intersection)
    candidates.crossing = !may_leave_out ? edges::all_triangles(world_) : timed(candidates.step.times.certificate, [&] {
      return edges::crossing_candidates(world_, view_.map.normalisation, view_.contact.in_space, progress);
    });
  candidates.step.run = !candidates.crossing.triangles.empty();
  if (options_.edges.intersection)
    candidates.step.skipped = count_of(world_.triangles.size() - candidates.crossing.triangles.size());
  candidates.step.why = why_searched(world_, options_, candidates.crossing.triangles.size());
  return candidates;
}

// If there is no time to determine which triangles may cross, all may. If hiding lines would need the time, none do.
Candidates ViewRun::find_candidates_in_time() const {
  budget_.lines.begin("finding separate bodies");
  const double for_lines = seconds_for_lines(input_.world, seconds_of_reading(watch_));
  if (options_.edges.intersection && budget_.lines.with_more_time(-for_lines).is_out_of_time())
    return {{}, {"intersections", false, "no time", count_of(input_.world.triangles.size()), 0}, true};
  try {
    return find_candidates(options_.leave_out.intersections, budget_.lines.with_part_of_the_time(part_for_candidates));
  } catch (const OutOfTime&) {
    Candidates candidates = find_candidates(false, budget_.lines);
    candidates.step.why = "no time to find out what may be skipped";
    return candidates;
  }
}

void ViewRun::keep_intersections(const report::PlanStep& step) {
  const std::vector<edges::FaceCrossing> contacts = std::exchange(drawn_.contacts, {});
  if (input_.known == nullptr || *input_.known || !options_.edges.intersection || drawn_.searched < 1) return;
  input_.known->emplace(known_intersections(shared_world(), drawn_, contacts, step));
}

// Finds no edges if there is not even time for those of the meshes.
void ViewRun::find_edges() {
  const bool are_known = input_.known != nullptr && *input_.known && options_.edges.intersection &&
                         has_same(**input_.known, shared_world());
  const KnownIntersections* known = are_known ? &**input_.known : nullptr;
  const bool is_whole = known != nullptr && known->whole && !refined_;
  Candidates candidates = is_whole ? Candidates{{}, known->step} : find_candidates_in_time();
  if (known != nullptr && !is_whole) candidates.crossing.known = settled_by(*known, shared_world());
  try {
    edges::EdgeOptions options = options_.edges;
    options.thread_depth = options_.min_thread / (input_.place.scale * view_.projection.scale);
    const auto find = [&](const auto& crossing) {
      return edges::find_feature_edges(world_, view_, options, crossing, budget_.lines);
    };
    drawn_ = is_whole ? find(*known->whole) : find(candidates.crossing);
    if (candidates.left_out) drawn_.searched = 0;
    keep_intersections(candidates.step);
    if (drawn_.searched < 1) partial_.add_stage("finding intersections");
    partial_.searched = drawn_.searched;
    partial_.too_many_crossings = drawn_.too_many_crossings;
  } catch (const OutOfTime& cut) {
    partial_.add_stage(cut.stage);
  }
  partial_.edges = count_of(drawn_.edges.size());
  candidates.step.items_out = count_of(drawn_.crossings.size());
  plan_.push_back(std::move(candidates.step));
}

// Leaves all but these edges undecided. Returns whether so few are left that they take negligible time.
bool ViewRun::leave_undecided(const std::string& stage, std::vector<int> edges) {
  hidden_.undecided = std::move(edges);
  partial_.add_stage(stage);
  partial_.undecided += count_of(hidden_.undecided.size());
  visibility::keep_decided(drawn_, hidden_);
  return drawn_.edges.size() <= few_lines;
}

visibility::HiddenSpans ViewRun::hidden_in_time() {
  int cuts = 0;
  // It is the faces that take the time, and fewer lines do not help there: a few in sight are tested against all faces,
  // and in the end so few that there is always something to show.
  const auto make = [&](const Progress& progress) {
    return cuts > 0 ? visibility::find_hidden_directly(world_, view_, drawn_, progress)
                    : visibility::find_hidden(world_, view_, drawn_, progress);
  };
  const auto leave_out = [&](const std::string& stage) {
    hidden_ = visibility::nothing_hidden(drawn_);
    if (cuts++ == 0)
      leave_undecided(stage, visibility::all_but_longest_in_sight(world_, view_, drawn_, few_lines, budget_.last()));
    else
      leave_undecided(stage, visibility::all_but_longest(view_, drawn_.edges, few_lines / 4));
    return cuts > 1;
  };
  try {
    return make_in_time(budget_.lines.with_part_of_the_time(part_for_hiding), budget_.last(), make, leave_out);
  } catch (const OutOfTime& cut) {
    partial_.add_stage(cut.stage);
    visibility::HiddenSpans nothing = visibility::nothing_hidden(drawn_);
    nothing.undecided = visibility::all_but_longest(view_, drawn_.edges, 0);
    return nothing;
  }
}

void ViewRun::hide() {
  report::PlanStep step{"visibility", false, "a wireframe is wanted", count_of(drawn_.edges.size()), 0};
  hidden_ = visibility::nothing_hidden(drawn_);
  const bool wanted = !options_.wireframe;
  const bool is_one_sheet = wanted && options_.leave_out.visibility && timed(step.times.certificate, [&] {
                              return visibility::is_height_field(world_, view_, drawn_);
                            });
  if (is_one_sheet) {
    step.why = "the page shows the surface as one sheet";
    step.skipped = step.items_in;
  } else if (wanted) {
    step.run = true;
    step.why = options_.leave_out.visibility ? "exact" : "requested by --plan";
    hidden_ = timed(step.times.stage, [&] {
      find_clear_contours();
      return hidden_in_time();
    });
  }
  if (!hidden_.undecided.empty()) partial_.add_stage("hiding lines");
  partial_.undecided += count_of(hidden_.undecided.size());
  visibility::keep_decided(drawn_, hidden_);
  if (step.run) hide_folds();
  step.items_out = count_of(hidden_.spans.size());
  plan_.push_back(std::move(step));
}

// Without time for it, facets decide.
void ViewRun::find_clear_contours() {
  try {
    visibility::find_clear_contours(world_, view_, drawn_, budget_.lines);
  } catch (const OutOfTime&) {
    drawn_.clear_contours.clear();
  }
}

// Without time for it, contours of facets that are turned over are drawn, too.
void ViewRun::hide_folds() {
  try {
    visibility::hide_folds(world_, view_, drawn_, hidden_, budget_.lines);
  } catch (const OutOfTime&) {
  }
}

drawing::DrawingOptions ViewRun::drawing_options(double least_crease) const {
  return {options_.name, options_.keep_hidden(), options_.leave_out.hidden, near_lines(options_), least_crease};
}

drawing::ViewDrawing ViewRun::drawn_on(const view::PaperMap& paper, const edges::FeatureEdges& edges,
                                       double least_crease, const Progress& progress) const {
  return drawing::make_drawing({world_, view_, edges, hidden_}, paper, drawing_options(least_crease), progress);
}

// Draws only the longest edges if there is no time for all.
DrawnLines ViewRun::draw_lines(const view::PaperMap& paper) {
  const auto make = [&](const Progress& progress) {
    DrawnLines lines;
    lines.drawing = drawn_on(paper, drawn_, options_.least_crease, progress);
    if (options_.arcs && !options_.detail && !options_.breaks.any() && input_.broken_out.empty())
      lines.curves = curves_of(options_, input_.world, lines.drawing, progress);
    return lines;
  };
  const auto leave_out = [&](const std::string& stage) {
    return leave_undecided(stage, visibility::all_but_longest(view_, drawn_.edges, fewer(drawn_.edges.size())));
  };
  DrawnLines lines = make_in_time(budget_.lines, budget_.last(), make, leave_out);
  double moved = 0;
  if (const CutSection* section = input_.section) {
    moved = section->cut.moved;
    lines.drawing.cuts.faces = drawing::cut_faces_on_paper(section->cut, section->surface.plane, world_, view_, paper);
    for (drawing::CutFace& face : lines.drawing.cuts.faces) face.model = input_.world.number_in_scene(face.model);
    lines.drawing.cuts.before =
        drawing::before_cuts_on_paper(input_.world, section->cut.uncut, section->surface, lines.drawing.world_to_page);
  }
  for (const BrokenOutSection& one : input_.broken_out) moved = std::max(moved, one.section.cut.moved);
  lines.drawing.distances.outlines_moved = view_.projection.central ? 0 : moved * input_.place.scale;
  lines.drawing.scale = input_.place.scale;
  return lines;
}

// After verification of the whole view, calls change_drawing(drawing, progress), with fewer lines if time is short.
template <class Change>
void ViewRun::change(DrawnLines& lines, const Change& change_drawing) {
  const auto make = [&](const Progress& progress) {
    DrawnLines changed{lines.drawing, {}};
    change_drawing(changed.drawing, progress);
    if (options_.arcs) changed.curves = curves_of(options_, input_.world, changed.drawing, progress);
    return changed;
  };
  const auto leave_out = [&](const std::string& stage) {
    partial_.add_stage(stage);
    partial_.undrawn +=
        static_cast<long long>(drawing::keep_longest_chains(lines.drawing, fewer(lines.drawing.chains.size())));
    return lines.drawing.chains.size() <= few_lines;
  };
  lines = make_in_time(budget_.run, budget_.last(), make, leave_out);
}

std::optional<report::ViewError> ViewRun::judged(const DrawnLines& lines, const view::PaperMap& paper) const {
  if (input_.heights == nullptr) return std::nullopt;
  const bool is_whole = input_.section == nullptr && !options_.exploded &&
                        input_.heights->of_triangle.size() == input_.world.triangles.size();
  const auto refined = is_whole && refined_ ? std::optional(world::facet_heights(*refined_)) : std::nullopt;
  return accuracy::error_of_view({world_, refined ? *refined : *input_.heights, is_whole, view_, drawn_, hidden_, paper,
                                  lines.drawing, drawing_options(options_.least_crease)},
                                 lines.curves, !options_.wireframe,
                                 budget_.run.with_part_of_the_time(part_for_judging));
}

// The view of the cut models, in the same place; without lines if there is no time for them.
ViewResult ViewRun::cut_view(const BrokenOutSection& one) {
  const world::World& world = one.section.cut.world;
  ViewOptions options = options_;
  options.detail.reset();
  options.breaks = {};
  options.revolved.clear();
  options.arcs.reset();
  options.centre_lines = false;
  for (std::vector<sheet::BodyStyle>& of_model : options.styles.of_model)
    for (sheet::BodyStyle& style : of_model) style.hidden = HiddenLines::none;
  try {
    return ViewRun({world, &one.section, options, input_.place, {}, {}, nullptr, input_.heights},
                   view::project_scene(world, view_.projection, options.limits, clipping_of(options)),
                   {budget_.run, budget_.lines}, watch_)
        .run();
  } catch (const OutOfTime& cut) {
    partial_.add_stage(cut.stage);
    return {};
  }
}

void ViewRun::break_out(DrawnLines& lines, const BrokenOutSection& one,
                        std::optional<report::Verification>& verification, std::optional<report::ViewError>& error) {
  const drawing::ClosedLine line = line_on_page(one.description, lines.drawing);
  const ViewResult cut = cut_view(one);
  plan_.insert(plan_.end(), cut.plan.begin(), cut.plan.end());
  partial_.add(cut.partial);
  if (cut.verification && (!verification || verification->errors() < cut.verification->errors()))
    verification = cut.verification;
  if (cut.error && error) error->take_larger(*cut.error);
  const std::vector<drawing::PaperTriangle> removed =
      removed_on_paper(input_.world, one, line, lines.drawing.world_to_page);
  change(lines, [&](drawing::ViewDrawing& drawing, const Progress& progress) {
    drawing::break_out(drawing, cut.drawing, line, removed, progress);
  });
}

void ViewRun::show_detail(DrawnLines& lines) {
  const drawing::Boundary boundary = boundary_on_page(*options_.detail, lines.drawing);
  change(lines, [&](drawing::ViewDrawing& drawing, const Progress& progress) {
    drawing::clip_drawing(drawing, {*options_.detail->name, *options_.detail->view, boundary}, progress);
  });
}

// Returns the length of lines that a half view is wrong about.
double ViewRun::break_view(DrawnLines& lines) {
  const drawing::Breaks breaks = drawing::mapped(options_.breaks, input_.place.scale, input_.place.shift, break_gap);
  constexpr double slack = 0.25;  // mm; about half a wide line
  double unsymmetric = 0;
  for (const int axis : {0, 1})
    if (const std::optional<double> mirror = breaks.mirror(axis))
      unsymmetric += budget_.or_nothing([&](const Progress& progress) {
        return drawing::length_without_mirror_image(lines.drawing, axis, *mirror, slack, progress);
      });
  change(lines, [&](drawing::ViewDrawing& drawing, const Progress& progress) {
    drawing::break_drawing(drawing, breaks, progress);
  });
  return unsymmetric;
}

// The visible parts of lines through space, which belong to no face.
std::vector<std::array<Vec2, 2>> ViewRun::traces(const view::PaperMap& paper, const Progress& progress) {
  edges::FeatureEdges lines;
  lines.crossings = {{{}, {-1, -1}, 0}};
  for (const world::Trace& trace : input_.traces) {
    const int from = view::add_point(view_, trace[0]), to = view::add_point(view_, trace[1]);
    if (const auto clipped = view::clip_edge(view_, from, to))
      lines.edges.push_back({clipped->vertex, clipped->t, EdgeKind::wire, 0, -1, 0});
  }
  const visibility::HiddenSpans hidden =
      options_.wireframe ? visibility::nothing_hidden(lines) : visibility::find_hidden(world_, view_, lines, progress);
  std::vector<std::array<Vec2, 2>> visible;
  for (std::size_t e = 0; e < lines.edges.size(); ++e)
    hidden.visit_parts(e, [&](double from, double to, bool is_visible) {
      if (is_visible)
        visible.push_back({drawing::position_on_paper(view_, paper, lines.edges[e], from),
                           drawing::position_on_paper(view_, paper, lines.edges[e], to)});
    });
  return visible;
}

// Contours that are drawn at their position on the surface are tested at their position on the mesh first, and creases
// also if the user leaves them out; then all ink where it is.
std::optional<report::Verification> ViewRun::verified(const DrawnLines& lines,
                                                      const std::optional<report::ViewError>& error,
                                                      const Progress& until) const {
  if (!options_.verify) return std::nullopt;
  Progress progress = until;
  progress.begin("verifying");
  const view::PaperMap paper = view::make_paper_map(view_, input_.place.scale, input_.place.shift);
  std::optional<edges::FeatureEdges> in_mesh;
  std::optional<drawing::ViewDrawing> mesh_lines;
  if (drawn_.moved > 0 || options_.least_crease > 0) {
    in_mesh = drawn_;
    in_mesh->moved = 0;
    for (edges::FeatureEdge& edge : in_mesh->edges) edge.shown = {-1, -1};
    mesh_lines = drawn_on(paper, *in_mesh, 0, progress);
  }
  const verify::VerifyInput input{world_,          view_.projection,
                                  options_.limits, in_mesh ? *in_mesh : drawn_,
                                  hidden_,         mesh_lines ? *mesh_lines : lines.drawing};
  const verify::Tolerance tolerance = tolerance_on(paper);
  report::Verification found = verify::verify(input, tolerance, *options_.verify, options_.keep_hidden(), progress);
  // A given window cuts lines off; otherwise it is the box of everything visible, and lines lie on its border.
  const double margin = view_.window_given ? 0 : 0.01 * view_.extent;
  const auto to_page = [&](const Vec2& corner) { return paper.origin + paper.scale * (corner - view_.middle); };
  const projection::Window window{to_page(view_.window.min - margin), to_page(view_.window.max + margin)};
  const verify::OutlineOptions how{options_.edges, *options_.verify, partial_.stages.empty(), window, progress};
  verify::OutlineFindings outline = verify::scan_outline(input, tolerance, how);
  found.outline = std::move(outline.check);
  if (!error) {
    found.ink = unjudged(lines.drawing, "lines, as their error is not known");
    return found;
  }
  const verify::VerifyInput as_drawn{world_, view_.projection, options_.limits, drawn_, hidden_, lines.drawing};
  // What is merely estimated is no error to be forgiven: the judge looks for contours and crossings where they are.
  const double off =
      error->total() - (*error)[report::ErrorTerm::contours] - (*error)[report::ErrorTerm::intersections];
  try {
    found.ink = verify::judge_ink(as_drawn, tolerance, {how, off, !(options_.least_crease > 0)}, outline.needs);
  } catch (const OutOfTime& cut) {
    budget_.partial.add_stage(cut.stage);
    found.ink = unjudged(lines.drawing, "lines, as time ran out");
  }
  return found;
}

}  // namespace

bool ViewOptions::keep_hidden() const {
  return styles.any([](const sheet::BodyStyle& style) { return style.hidden != HiddenLines::none; });
}

void Stopwatch::lap(const std::string& stage) {
  const auto now = std::chrono::steady_clock::now();
  laps_.emplace_back(stage, std::chrono::duration<double>(now - start_).count());
  start_ = now;
}

ViewResult draw_view(const ViewInput& input, view::ProjectedScene view, const ViewTime& time, Stopwatch& watch) {
  return ViewRun(input, std::move(view), time, watch).run();
}

}  // namespace epura::pipeline
