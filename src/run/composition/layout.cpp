// SPDX-License-Identifier: Apache-2.0
#include "composition/layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "annotations/balloons.hpp"
#include "annotations/construction_layer.hpp"
#include "annotations/cutting_plane_line.hpp"
#include "annotations/detail_marks.hpp"
#include "annotations/limit_lines.hpp"
#include "annotations/sight_arrows.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "composition/construction_layers.hpp"
#include "sheet/arrangement.hpp"
#include "sheet/installed_fonts.hpp"
#include "sheet/line_styles.hpp"
#include "sheet/list_table.hpp"
#include "sheet/notation.hpp"
#include "sheet/standard_scale.hpp"
#include "sizes/overall.hpp"
#include "view/paper_map.hpp"
#include "views/arrow_views.hpp"
#include "views/breaks.hpp"
#include "views/choose.hpp"
#include "views/constructions.hpp"
#include "views/details.hpp"

namespace epura::pipeline {

namespace {

constexpr double usual_text_height = 3.5;

// A title alone goes into the metadata of files.
FrameKind frame_of(const scene::SheetDescription& sheet, std::size_t views, bool has_list) {
  if (sheet.form.given()) return FrameKind::full;
  const bool has_fields = std::any_of(sheet.title_block.begin(), sheet.title_block.end(),
                                      [](const auto& field) { return field.first != "title"; });
  const FrameKind usual = has_fields || sheet.logo.given() || views > 1 || has_list ? FrameKind::full : FrameKind::none;
  const FrameKind frame = sheet.frame.value_or(FrameKind::automatic);
  return frame == FrameKind::automatic ? usual : frame;
}

// The position in the plane of a view of a point common to all views, the middle of the world.
Vec2 common_point(const world::World& world, const view::ProjectedScene& view) {
  const Mat4 to_plane = view::world_to_page(view, view::make_paper_map(view, 1, {0, 0}));
  const Vec4 p = to_plane * Vec4(world.box.centre(), 1);
  return Vec2(p) / p.w;
}

// Dimensions are outside the marks of sections and details. What is higher than any sheet has no place.
sheet::Room room_around(const Annotations& annotations, const projection::Projection& projection,
                        const sheet::LineWidths& widths, double highest) {
  sheet::Room room = sheet::dimension_room(annotations.dimensions, projection, usual_text_height);
  Vec2 marks(0, 0);
  for (const cut::CuttingSurface& section : annotations.planes)
    marks = glm::max(marks, sheet::cutting_plane_room(projection, section, widths));
  for (const ViewArrow& arrow : annotations.arrows)
    marks = glm::max(marks, glm::abs(arrow.sight) * sheet::sight_arrow_room(widths));
  if (annotations.balloons) marks = glm::max(marks, Vec2(sheet::balloon_room(usual_text_height)));
  if (!annotations.details.empty()) marks = glm::max(marks, Vec2(sheet::detail_room));
  room.before += marks;
  room.after += marks;
  // Dimensions are rather below their view, so there is room above it.
  double callouts = 0;
  for (const ViewCallout& callout : annotations.callouts) {
    const double height = sheet::callout_room(height_of(callout.description, usual_text_height));
    if (!callout.description.at.given() && height <= highest) callouts = std::max(callouts, height);
  }
  room.after.y += callouts;
  return room;
}

struct Views {
  std::vector<sheet::ViewToPlace> to_place;
  std::vector<Vec2> origins;  ///< origins of their boxes, as they are moved together
  std::vector<Vec2> gaps;     ///< lengths of the gaps in interrupted views, mm
};

// The box of all ink, with the boundaries of details that the view marks and revolved sections.
projection::Window whole_box(const ViewOptions& options, const Annotations& annotations,
                             const view::ProjectedScene& view, const world::World& world) {
  projection::Window whole = box_to_place(options, view, world);
  for (const scene::DetailDescription& detail : annotations.details) {
    if (view.projection.central) continue;
    const sheet::Rectangle box = boundary_box(detail, view);
    whole = {glm::min(whole.min, box.min), glm::max(whole.max, box.max)};
  }
  const Mat4 to_plane = view::world_to_page(view, view::make_paper_map(view, 1, {0, 0}));
  for (const RevolvedSection& section : options.revolved)
    for (const std::vector<Vec2>& ring : turned_face(section, view.projection, to_plane).rings)
      for (const Vec2& p : ring) whole = {glm::min(whole.min, p), glm::max(whole.max, p)};
  return whole;
}

struct LayoutOptions {
  scene::ScaleChoice scale;
  bool portrait;
  FrameKind frame;
  std::optional<sheet::TitleBlock> title_block;
  ProjectionAngle angle;
  sheet::LineWidths widths{};
  double highest = HUGE_VAL;  ///< side of the largest paper, mm
  std::optional<sheet::PartsList> list{};
  std::optional<sheet::RevisionList> revisions{};
  SheetFit fit = SheetFit::model;
  std::shared_ptr<const sheet::Form> form{};
  std::shared_ptr<const sheet::Logo> logo{};
  std::vector<scene::RoleStyle> styles{};
};

// The box and the room of a view with its constructions. Points that are much farther than the view is large are not on
// the sheet.
void make_room_for_constructions(sheet::ViewToPlace& view, projection::Window& box, const construction::Figure& figure,
                                 SheetFit fit) {
  constexpr double farthest = 10;  // sizes of the view
  constexpr Vec2 symbols{14, 8};   // mm
  view.before += Vec2(sheet::construction_room(figure), legend_room(figure));
  if (fit != SheetFit::construction) return;
  const sheet::Rectangle ink{box.min, box.max};
  const sheet::Rectangle whole = sheet::box_of(figure, ink, farthest * glm::length(ink.size()));
  box = {whole.min, whole.max};
  view.before += symbols;
  view.after += symbols;
}

// Between plan and elevation for the ground line, beside them for its ends.
void make_room_for_ground_line(sheet::ViewToPlace& view, bool is_elevation) {
  constexpr double ends = 6, symbols = 9;  // mm
  view.before.x += ends;
  view.after.x += ends;
  view.before.y += is_elevation ? symbols : symbols / 2;
  view.after.y += is_elevation ? symbols / 2 : symbols;
}

Views views_to_place(const world::World& world, const SheetOfViews& sheet, std::span<const view::ProjectedScene> views,
                     const std::vector<Annotations>& annotations, const LayoutOptions& layout) {
  Views result;
  for (std::size_t i = 0; i < views.size(); ++i) {
    // A single view need not be aligned with others.
    const Vec2 origin = views.size() > 1 ? common_point(world, views[i]) : Vec2(0, 0);
    const ViewOptions& options = sheet.plans[i].options;
    const drawing::Breaks& breaks = options.breaks;
    projection::Window box = whole_box(options, annotations[i], views[i], world);
    const Vec2 moved = breaks.moved(origin);
    sheet::ViewToPlace view{sheet::view_place(views[i].projection), {}};
    const sheet::Room room = room_around(annotations[i], views[i].projection, layout.widths, layout.highest);
    view.before = sheet.layout.room_share * room.before;
    view.after = sheet.layout.room_share * room.after;
    const bool in_epura = sheet.epura && (i == sheet.epura->elevation || i == sheet.epura->plan);
    if (in_epura) {
      make_room_for_ground_line(view, i == sheet.epura->elevation);
      const projection::Window whole = epura_boxes(world, sheet, views)[i == sheet.epura->elevation ? 0 : 1];
      box = {glm::min(box.min, whole.min), glm::max(box.max, whole.max)};
    } else if (sheet.descriptions[i].construction.given() && !options.detail)
      make_room_for_constructions(view, box, figure_in_plane(world, sheet.descriptions[i], views[i]), layout.fit);
    view.box = {breaks.moved(box.min) - moved, breaks.moved(box.max) - moved};
    const scene::ViewDescription& description = sheet.descriptions[i];
    view.labelled =
        description.label.given() || description.detail.given() || (description.section.given() && views.size() > 1);
    view.scale = description.scale.value_or({}).fixed;
    view.at = description.at.value;
    const drawing::Breaks on_paper = drawing::mapped(breaks, 1, Vec2(0), break_gap);
    const Vec2 gaps(on_paper.gaps(0), on_paper.gaps(1));
    const Vec2 limits(breaks.any() ? sheet::limit_room(layout.widths) : 0);
    view.before = glm::max(view.before, limits) + gaps / 2.0;
    view.after = glm::max(view.after, limits) + gaps / 2.0;
    if (const auto parent = parent_of(sheet, i)) {
      const double side = layout.angle == ProjectionAngle::first ? 1 : -1;
      view.beside = {{*parent, side * sight_on_page(views[*parent].projection, views[i].projection.n)}};
      view.after.y = std::max(view.after.y, sheet::label_room);
    }
    result.to_place.push_back(view);
    result.origins.push_back(moved);
    result.gaps.push_back(gaps);
  }
  return result;
}

// mm between the frame and ink. Centring marks extend 10 mm into the drawing area.
double clearance_of(FrameKind frame) {
  if (frame == FrameKind::none) return 0;
  return frame == FrameKind::full ? 12 : 5;
}

sheet::Arrangement arranged_on(const scene::PaperChoice& size, const LayoutOptions& options,
                               std::span<const sheet::ViewToPlace> views) {
  sheet::Paper paper = sheet::make_paper(size, options.portrait);
  if (options.form) paper.area = options.form->drawing_area;
  sheet::DrawingRoom room{options.frame == FrameKind::none ? paper : sheet::with_frame_margins(paper)};
  room.clearance = clearance_of(options.frame);
  if (options.title_block) room.title_block = sheet::title_block_box(*options.title_block, room.paper);
  if (options.list) room.title_block = sheet::with_list(room.title_block, options.list->items.size(), room.paper);
  if (options.revisions)
    room.title_block = sheet::with_list(room.title_block, options.revisions->rows.size(), room.paper);
  return sheet::arrange(views, options.scale, options.angle, room);
}

constexpr int largest = largest_size_rank;

// The sizes from which "auto" chooses, from 0, the smallest, to `largest`.
scene::PaperChoice size_of_rank(const scene::SheetDescription& sheet, int rank) {
  if (sheet.size.value_or({}).kind == scene::PaperChoice::Kind::automatic_ansi)
    return {scene::PaperChoice::Kind::ansi, rank, {0, 0}};
  return {scene::PaperChoice::Kind::iso, largest - rank, {0, 0}};
}

// The larger scale of both orientations, unless one is given; landscape if it is the same.
sheet::Arrangement in_best_orientation(const scene::PaperChoice& size, LayoutOptions options,
                                       std::span<const sheet::ViewToPlace> views, bool is_given) {
  sheet::Arrangement best = arranged_on(size, options, views);
  if (is_given) return best;
  options.portrait = !options.portrait;
  sheet::Arrangement other = arranged_on(size, options, views);
  const bool is_better = other.inside && (!best.inside || other.scale > best.scale * (1 + 1e-9));
  return is_better ? other : best;
}

/// Views on paper whose size was given or chosen.
struct OnPaper {
  sheet::Arrangement arrangement;
  scene::PaperChoice size;
  std::optional<int> next_size{};  ///< as in SheetPlan
};

// Sheet and scale together: larger sheets are for parts that would be drawn too small on the smaller ones.
OnPaper arranged_with_scale(const scene::SheetDescription& sheet, const LayoutOptions& options,
                            std::span<const sheet::ViewToPlace> views, int least) {
  constexpr std::array<double, largest> min_scales{1, 0.5, 0.2, 0.1};
  for (int rank = least; rank < largest; ++rank) {
    const scene::PaperChoice size = size_of_rank(sheet, rank);
    sheet::Arrangement arrangement = in_best_orientation(size, options, views, sheet.orientation.given());
    if (arrangement.inside && arrangement.scale >= min_scales[static_cast<std::size_t>(rank)] * (1 - 1e-9))
      return {std::move(arrangement), size, rank + 1};
  }
  const scene::PaperChoice size = size_of_rank(sheet, largest);
  return {in_best_orientation(size, options, views, sheet.orientation.given()), size};
}

// "auto": the smallest paper, from the `least` size on, on which the views fit at a given scale.
OnPaper arranged(const scene::SheetDescription& sheet, const LayoutOptions& options,
                 std::span<const sheet::ViewToPlace> views, int least) {
  if (is_sized_by_scale(sheet) && options.scale.standard) return arranged_with_scale(sheet, options, views, least);
  const scene::PaperChoice usual = usual_size(sheet, views.size());
  if (!is_sized_by_scale(sheet) || !options.scale.fixed) return {arranged_on(usual, options, views), usual};
  for (int rank = least; rank < largest; ++rank) {
    const scene::PaperChoice size = size_of_rank(sheet, rank);
    sheet::Arrangement arrangement = arranged_on(size, options, views);
    if (arrangement.inside) return {std::move(arrangement), size, rank + 1};
  }
  const scene::PaperChoice size = size_of_rank(sheet, largest);
  return {arranged_on(size, options, views), size};
}

// Scale and paper size are filled in once they are known.
sheet::TitleBlock title_block_of(const scene::SceneDescription& scene, int sheet) {
  sheet::TitleBlock block;
  for (const auto& [name, text] : scene.sheets[static_cast<std::size_t>(sheet)].title_block)
    block.fields.emplace_back(name, *text);
  block.sheet = sheet + 1;
  block.sheets = static_cast<int>(scene.sheets.size());
  return block;
}

std::vector<scene::RevisionDescription> revisions_of(const scene::SceneDescription& scene, int sheet) {
  std::vector<scene::RevisionDescription> revisions = scene.revisions;
  std::erase_if(revisions, [sheet](const auto& revision) { return revision.sheet.value_or(1) != sheet + 1; });
  return revisions;
}

// Throws Error{input} for lists on paper that is cut to the drawing.
void expect_paper_for_lists(const scene::SceneDescription& scene, const LayoutOptions& options,
                            const scene::PaperChoice& size) {
  if (size.kind != scene::PaperChoice::Kind::none || !(options.list || options.revisions)) return;
  throw Error(ErrorKind::input, options.list ? scene.parts_list->where : options.revisions->rows[0].revision.where,
              std::string(options.list ? "a parts list" : "a list of revisions") +
                  " needs a sheet, and the paper is cut to the drawing",
              "choose a size, such as --sheet A3");
}

// Throws Error{input} for lists that are higher than their sheet.
void expect_room_for_lists(const SheetPlan& plan, const scene::SceneDescription& scene) {
  const sheet::SheetFurniture& furniture = plan.furniture;
  const sheet::BlockBoxes boxes = sheet::block_boxes(furniture);
  const double highest = sheet::drawing_area(furniture.paper).max.y;
  const auto expect = [highest](const std::optional<sheet::Rectangle>& box, const std::string& what,
                                const std::string& where, const std::string& hint) {
    if (!box || box->max.y <= highest) return;
    throw Error(ErrorKind::input, where,
                what + " is " + format_rounded(box->size().y, 4) + " mm high, and the sheet has room for " +
                    format_rounded(std::max(highest - box->min.y, 0.0), 4) + " mm",
                "use a larger sheet, such as --sheet A1" + hint);
  };
  if (furniture.parts_list)
    expect(boxes.parts_list, "the parts list of " + std::to_string(furniture.parts_list->items.size()) + " items",
           scene.parts_list->where, ", or omit bodies by a [[style]] with drawn = false");
  if (furniture.revisions)
    expect(boxes.revisions, "the list of " + std::to_string(furniture.revisions->rows.size()) + " revisions",
           furniture.revisions->rows[0].revision.where, ", or omit old ones");
}

// Throws Error{input} for a logo without a place.
void read_files(LayoutOptions& options, const scene::SheetDescription& sheet) {
  if (sheet.form.given()) {
    options.form = read_at_place(sheet.form, sheet::read_form);
    options.title_block->place = options.form->title_block;
  }
  if (sheet.style.given()) options.styles = read_at_place(sheet.style, scene::read_role_styles);
  if (!sheet.logo.given()) return;
  if (!options.title_block)
    throw Error(ErrorKind::input, sheet.logo.where, "the logo is in the title block, and there is none",
                "use --frame full");
  if (options.form && !options.form->logo)
    throw Error(ErrorKind::input, sheet.logo.where, "the template " + *sheet.form + " has no place for a logo",
                "give a rectangle the id or label 'logo'");
  options.logo = read_at_place(sheet.logo, sheet::read_logo);
  options.title_block->has_logo = true;
}

LayoutOptions options_of(const scene::SceneDescription& scene, const SheetOfViews& on_sheet) {
  const int number = on_sheet.sheet;
  const std::size_t views = on_sheet.plans.size();
  const scene::SheetDescription& sheet = scene.sheets[static_cast<std::size_t>(number)];
  LayoutOptions options{};
  if (!on_sheet.items.empty())
    options.list = {on_sheet.items, sheet.field("language"), sheet.decimal_sign.value_or(DecimalSign::point)};
  if (auto revisions = revisions_of(scene, number); !revisions.empty())
    options.revisions = {std::move(revisions), sheet.field("language")};
  options.frame = frame_of(sheet, views, options.list || options.revisions);
  options.portrait = sheet.orientation.value_or(Orientation::landscape) == Orientation::portrait;
  options.angle = sheet.angle.value_or(ProjectionAngle::first);
  options.fit = sheet.fit.value_or(SheetFit::model);
  const bool is_standard = options.frame == FrameKind::full || is_sized_by_scale(sheet);
  options.scale = sheet.scale.value_or({.fixed = std::nullopt, .standard = is_standard});
  if (on_sheet.layout.kept_scale && !options.scale.fixed) options.scale = {.fixed = on_sheet.layout.kept_scale};
  if (options.frame == FrameKind::full) options.title_block = title_block_of(scene, number);
  read_files(options, sheet);
  return options;
}

}  // namespace

std::vector<LayoutRequest> better_layouts(const scene::SheetDescription& sheet, const SheetPlan& usual) {
  const bool is_sized = is_sized_by_scale(sheet);
  std::vector<LayoutRequest> layouts;
  if (is_sized) layouts.push_back({0, std::nullopt, smaller_rooms.front()});
  if (usual.chosen)
    layouts.push_back(
        {is_sized ? usual.size_rank() : 0, sheet::next_standard_scale(usual.scale), smaller_rooms.front()});
  return layouts;
}

std::vector<LayoutRequest> roomier_layouts(const scene::SheetDescription& sheet, const SheetPlan& usual) {
  constexpr double smallest = 0.1;  // of the usual scale, at which texts would be far larger than what they mean
  const bool is_given = sheet.scale.value_or({}).fixed.has_value();
  std::vector<LayoutRequest> layouts;
  if (is_sized_by_scale(sheet)) {
    for (int rank = usual.size_rank() + 1; rank <= largest_size_rank; ++rank) {
      layouts.push_back({rank});
      if (!is_given) layouts.push_back({rank, usual.scale});
    }
  } else if (usual.chosen) {
    for (const double share : smaller_rooms) layouts.push_back({0, sheet::next_standard_scale(usual.scale), share});
    for (double scale = usual.scale; scale > smallest * usual.scale;) {
      scale = sheet::standard_scale_up_to(scale * 0.99);
      layouts.push_back({0, scale});
    }
  }
  return layouts;
}

bool is_better(const SheetPlan& one, const SheetPlan& other) {
  constexpr double rounding = 1e-9;
  if (one.size_rank() != other.size_rank()) return one.size_rank() < other.size_rank();
  return one.scale > other.scale * (1 + rounding);
}

bool is_sized_by_scale(const scene::SheetDescription& sheet) {
  const scene::PaperChoice::Kind kind = sheet.size.value_or({}).kind;
  return kind == scene::PaperChoice::Kind::automatic || kind == scene::PaperChoice::Kind::automatic_ansi;
}

scene::PaperChoice usual_size(const scene::SheetDescription& sheet, std::size_t views) {
  if (sheet.size.given() && !is_sized_by_scale(sheet)) return *sheet.size;
  return size_of_rank(sheet, views > 1 ? 1 : 0);
}

scene::PaperChoice largest_size(const scene::SheetDescription& sheet, std::size_t views) {
  return is_sized_by_scale(sheet) ? size_of_rank(sheet, largest) : usual_size(sheet, views);
}

double dimension_text_height(const sheet::Paper& paper, std::size_t views) {
  constexpr double a4 = 210 * 297;
  return views > 1 && paper.width * paper.height <= a4 ? 2.5 : usual_text_height;
}

SheetPlan plan_sheet(const world::World& world, const scene::SceneDescription& scene, const SheetOfViews& sheet,
                     std::span<const view::ProjectedScene> views, const std::vector<Annotations>& annotations) {
  LayoutOptions options = options_of(scene, sheet);
  const scene::SheetDescription& description = scene.sheets[static_cast<std::size_t>(sheet.sheet)];
  const scene::PaperChoice usual = usual_size(description, views.size());
  expect_paper_for_lists(scene, options, usual);
  options.widths = sheet::line_widths(sheet::make_paper(usual, false), options.styles);
  const sheet::Paper most = sheet::make_paper(largest_size(description, views.size()), false);
  if (most.width > 0) options.highest = std::max(most.width, most.height);
  const Views placing = views_to_place(world, sheet, views, annotations, options);
  const auto [arrangement, size, next_size] = arranged(description, options, placing.to_place, sheet.layout.min_size);
  if (options.title_block) {
    options.title_block->scale = sheet::with_decimal_sign(sheet::ratio_text(arrangement.scale),
                                                          description.decimal_sign.value_or(DecimalSign::point));
    options.title_block->size = sheet::size_name(size);
    if (views.size() > 1) options.title_block->angle = options.angle;
  }
  SheetPlan plan{{arrangement.paper, options.frame, std::move(options.title_block)},
                 {},
                 arrangement.scale,
                 options.scale.standard || (sheet.layout.room_share < 1 && !description.scale.value_or({}).fixed),
                 arrangement.inside,
                 arrangement.on_paper,
                 arrangement.fitting,
                 next_size,
                 arrangement.crowded};
  plan.furniture.parts_list = std::move(options.list);
  plan.furniture.revisions = std::move(options.revisions);
  plan.furniture.form = std::move(options.form);
  plan.furniture.logo = std::move(options.logo);
  plan.furniture.styles = std::move(options.styles);
  expect_room_for_lists(plan, scene);
  if (description.font.given()) plan.furniture.font = sheet::find_font(*description.font, description.font.where);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const sheet::ViewSpot& spot = arrangement.views[i];
    plan.places.push_back({spot.scale, spot.shift - spot.scale * placing.origins[i] - placing.gaps[i] / 2.0});
  }
  return plan;
}

void set_least_threads(SheetOfViews& views, const SheetPlan& plan) {
  // Between the lines of crests and roots, mm; also at least two wide lines. ISO 6410-1.
  constexpr double least = 0.7;
  const double wide = sheet::line_widths(plan.furniture.paper).wide;
  for (PlannedView& view : views.plans) view.options.min_thread = std::max(least, 2 * wide);
}

}  // namespace epura::pipeline
