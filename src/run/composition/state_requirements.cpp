// SPDX-License-Identifier: Apache-2.0
#include "composition/state_requirements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "composition/annotations.hpp"
#include "composition/requirement_texts.hpp"
#include "composition/requirement_words.hpp"
#include "composition/stated_symbols.hpp"
#include "composition/wanted_views.hpp"
#include "features/tolerances.hpp"
#include "scene/choices.hpp"
#include "sizes/coordinates.hpp"
#include "sizes/equal_features.hpp"

namespace epura::pipeline {

namespace {

using importer::ModelRequirement;
using importer::RequirementKind;

constexpr const char* of_size = "it means the middle of its faces, whose dimension is not drawn";

// Views in which dimensions are true and everything is in its place; sections last, as for automatic dimensions.
std::vector<FaceView> views_for_requirements(const SheetToState& sheet) {
  std::vector<FaceView> views;
  for (const bool is_section : {false, true})
    for (std::size_t i = 0; i < sheet.seen.size(); ++i) {
      const scene::ViewDescription& view = sheet.views.descriptions[i];
      const ViewOptions& options = sheet.views.plans[i].options;
      const projection::Projection& seen = sheet.seen[i].projection;
      const bool is_moved = view.detail.given() || options.exploded || options.turned || options.breaks.any();
      if (view.section.given() != is_section || is_moved || !is_orthographic(seen) || !shows_an_axis(seen)) continue;
      views.emplace_back(*view.name, seen, sheet.worlds.seen_in(view));
    }
  return views;
}

bool gives_value(const ModelRequirement& one) {
  return std::isfinite(one.value) || one.bounds == importer::RequirementBounds::limits;
}

Vec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

bool is_target(const ModelRequirement& one) { return one.type == "datum target"; }

/// States the requirements of one file on a sheet.
class Statement {
 public:
  Statement(scene::SceneDescription& scene, FileRequirements& file, const RequirementSubject& subject, int sheet)
      : scene_(scene), file_(file), subject_(subject), sheet_(sheet), places_(subject) {
    for (std::size_t i = 0; i < file.all.size(); ++i) {
      const ModelRequirement& one = file.all[i];
      if (one.kind == RequirementKind::dimension && gives_value(one)) valued_[{one.type, one.faces}].push_back(i);
      if (one.kind == RequirementKind::dimension && !one.lines.empty()) lined_[one.faces].push_back(i);
      if (is_target(one)) targets_[one.datums.substr(0, one.datums.find_first_of("0123456789"))].push_back(i);
    }
    for (const scene::CalloutDescription& callout : scene.callouts)
      if (const auto* datum = std::get_if<scene::DatumFeature>(&callout.content)) letters_.insert(datum->letter);
  }

  void add_all() {
    for (const bool has_value : {true, false})
      for (std::size_t i = 0; i < file_.all.size(); ++i)
        if (file_.all[i].kind == RequirementKind::dimension && is_open(i) && gives_value(file_.all[i]) == has_value)
          add_dimension(i);
    unite_equal();
    for (scene::DimensionDescription& dimension : dimensions_) scene_.dimensions.push_back(std::move(dimension));
    for (std::size_t i = 0; i < file_.all.size(); ++i)
      if (file_.all[i].kind == RequirementKind::datum && !is_target(file_.all[i]) && is_open(i)) add_datum(i);
    for (std::vector<std::size_t>& stack : stacks_of(file_.all)) {
      std::erase_if(stack, [this](std::size_t i) { return !is_open(i); });
      if (!stack.empty()) add_frame(stack);
    }
    for (std::size_t i = 0; i < file_.all.size(); ++i)
      if (file_.all[i].kind >= RequirementKind::note && is_open(i)) add_words(i);
  }

 private:
  [[nodiscard]] bool is_open(std::size_t i) const { return file_.rows[i].is_missing() && !why_unknown(file_.all[i]); }
  [[nodiscard]] std::string where(std::size_t i) const {
    return "requirement " + file_.all[i].id + " of " + file_.rows[i].model;
  }

  void set_drawn(std::size_t i, const std::string& view) {
    file_.rows[i].view = view;
    file_.rows[i].sheet = sheet_;
    file_.rows[i].why.clear();
  }

  // By what draws another one.
  void draw_with(std::size_t other, std::size_t i) {
    set_drawn(i, file_.rows[other].view);
    if (const auto drawn = drawn_by_.find(other); drawn != drawn_by_.end())
      dimensions_[drawn->second].requirement += " " + key_of(file_, i);
    if (const auto noted = noted_by_.find(other); noted != noted_by_.end())
      scene_.callouts[noted->second].requirement += " " + key_of(file_, i);
  }

  // A dimension without a value says nothing more than another of the same faces.
  [[nodiscard]] bool is_said(std::size_t i) {
    const ModelRequirement& one = file_.all[i];
    if (gives_value(one)) return false;
    const std::vector<std::size_t>& others = valued_[{one.type, one.faces}];
    const auto other =
        std::find_if(others.begin(), others.end(), [this](std::size_t k) { return file_.rows[k].is_drawn(); });
    if (other == others.end()) return false;
    draw_with(*other, i);
    file_.rows[i].why = "no value is given: it is that of " + file_.all[*other].id;
    return true;
  }

  // One that says the same of the same faces is drawn with the other one, or not for its reason.
  bool is_twin(std::size_t i) {
    const ModelRequirement& one = file_.all[i];
    const auto [first, is_new] = stated_.try_emplace({requirement_sentence(one), one.faces, one.lines}, i);
    if (is_new) return false;
    if (file_.rows[first->second].is_drawn()) draw_with(first->second, i);
    file_.rows[i].why = file_.rows[first->second].why;
    return true;
  }

  void add_dimension(std::size_t i) {
    if (is_said(i) || is_twin(i)) return;
    StatedDimension stated = state_dimension(file_.all[i], subject_, where(i));
    file_.rows[i].why = stated.why;
    if (!stated.why.empty()) return;
    if (!stated.beside.lines.empty()) {
      noted_by_[i] = scene_.callouts.size();
      add_callout(i, std::move(stated.beside));
    } else {
      set_drawn(i, *stated.dimension.view);
      stated.dimension.requirement = key_of(file_, i);
      if (stated.is_straight) places_.add_dimension(file_.all[i].faces, stated.dimension);
      drawn_by_[i] = dimensions_.size();
      dimensions_.push_back(std::move(stated.dimension));
    }
    if (file_.rows[i].is_drawn() && !gives_value(file_.all[i]))
      file_.rows[i].why = "no value is given: it has that of the model";
  }

  // Those of equal circles in one view become one, "2× ⌀8"; ids of all are those of the first.
  void unite_equal() {
    const auto said_by = [](const scene::DimensionDescription& one) {
      const scene::StatedValue stated = one.stated.value_or(scene::StatedValue{NAN, -1});
      return std::tuple(*one.view, one.type.value, one.text.value, one.tolerance.value, one.limits.value,
                        one.stated ? format_number(stated.value) : std::string(), stated.decimals);
    };
    std::vector<scene::DimensionDescription> united;
    std::vector<std::size_t> counts;
    std::map<decltype(said_by(united.front())), std::vector<std::size_t>> alike;
    for (scene::DimensionDescription& one : dimensions_) {
      if (!one.circle) {
        united.push_back(std::move(one));
        counts.push_back(1);
        continue;
      }
      std::vector<std::size_t>& others = alike[said_by(one)];
      const auto same = std::find_if(others.begin(), others.end(), [&](std::size_t i) {
        const scene::FeatureCircle& circle = *united[i].circle;
        return features::are_parallel(circle.axis, one.circle->axis) &&
               features::are_same(circle.radius, one.circle->radius);
      });
      if (same == others.end()) {
        others.push_back(united.size());
        united.push_back(std::move(one));
        counts.push_back(1);
        continue;
      }
      ++counts[*same];
      united[*same].requirement += " " + one.requirement;
    }
    for (std::size_t i = 0; i < united.size(); ++i)
      if (counts[i] > 1) {
        std::string& text = united[i].text.value.value();
        const auto each = static_cast<std::size_t>(sheet::repeats_of(text));
        if (each > 1) text.erase(0, sheet::times(each).size());
        text = sheet::times(each * counts[i]) + text;
      }
    dimensions_ = std::move(united);
  }

  // The targets of a datum have its letter, and numbers behind it.
  [[nodiscard]] std::vector<std::size_t> targets_of(const std::string& letter) const {
    const auto found = targets_.find(letter);
    std::vector<std::size_t> targets;
    if (found != targets_.end())
      std::copy_if(found->second.begin(), found->second.end(), std::back_inserter(targets),
                   [this](std::size_t i) { return file_.rows[i].is_missing(); });
    return targets;
  }

  // Targets are one letter at the feature of their datum.
  void add_datum(std::size_t i) {
    const ModelRequirement& one = file_.all[i];
    std::string& why = file_.rows[i].why;
    const std::vector<std::size_t> targets = targets_of(one.datums);
    for (const std::size_t target : targets) file_.rows[target].why = "its datum " + one.datums + " is not drawn";
    if (one.faces.empty()) return;
    if (letters_.count(one.datums) != 0) {
      why = "the sheets have a datum " + one.datums + " already";
      return;
    }
    scene::CalloutDescription callout;
    callout.where = where(i);
    callout.requirement = key_of(file_, i);
    callout.content = scene::DatumFeature{one.datums};
    const bool is_placed = places_.place(callout, one.faces, SymbolPlaces::Ends::line);
    if (is_placed && !callout.dimension.given() && face_places(one.faces, subject_.part).size() > 1) {
      why = of_size;
      return;
    }
    if (!is_placed) {
      why = line_not_seen;
      return;
    }
    set_drawn(i, *callout.view);
    letters_.insert(one.datums);
    for (const std::size_t target : targets) {
      if (add_target(target)) continue;
      callout.requirement += " " + key_of(file_, target);
      set_drawn(target, *callout.view);
      file_.rows[target].why = "as the letter of its datum: its place and size are not drawn";
    }
    scene_.callouts.push_back(std::move(callout));
  }

  // Whether dimensions between its corners say how long and how wide the area of a target is.
  [[nodiscard]] bool has_dimensions(const ModelRequirement& target) const {
    const Vec3 middle = vector_of(target.area[0]), length = vector_of(target.area[1]),
               width = vector_of(target.area[2]);
    const auto is_corner = [&](const Vec3& point) {
      const Vec3 off = point - middle;
      const auto is_end = [&](const Vec3& half) {
        return features::are_same(std::abs(glm::dot(off, half)), glm::dot(half, half));
      };
      return is_end(length) && is_end(width);
    };
    const auto is_side = [&](const std::array<double, 6>& line) {
      return is_corner({line[0], line[1], line[2]}) && is_corner({line[3], line[4], line[5]});
    };
    std::vector<double> said;
    if (const auto lined = lined_.find(target.faces); lined != lined_.end())
      for (const std::size_t i : lined->second)
        if (std::ranges::all_of(file_.all[i].lines, is_side)) said.push_back(file_.all[i].value);
    const auto take = [&said](const Vec3& half) {
      if (half == Vec3(0)) return true;
      const auto found = std::find_if(said.begin(), said.end(),
                                      [&](double value) { return features::are_same(value, 2 * glm::length(half)); });
      if (found == said.end()) return false;
      said.erase(found);
      return true;
    };
    return take(length) && take(width);
  }

  // The area of a target, with its symbol, in a view that shows it true. Returns whether there is one.
  bool add_target(std::size_t i) {
    const ModelRequirement& one = file_.all[i];
    if (one.area.size() != 3 || one.faces.empty()) return false;
    const auto half = [&](std::size_t k) {
      return subject_.placed(vector_of(one.area[0]) + vector_of(one.area[k])) - subject_.placed(vector_of(one.area[0]));
    };
    scene::DatumTarget target = target_of(one, !has_dimensions(one), subject_.manner);
    target.middle = subject_.placed(vector_of(one.area[0]));
    target.half_length = half(1);
    target.half_width = half(2);
    scene::CalloutDescription callout;
    callout.where = where(i);
    callout.requirement = key_of(file_, i);
    if (!places_.place_in_area(callout, one.faces, target.middle)) return false;
    callout.content = std::move(target);
    set_drawn(i, *callout.view);
    scene_.callouts.push_back(std::move(callout));
    return true;
  }

  bool place_words(scene::CalloutDescription& callout, const ModelRequirement& one, const std::vector<int>& faces) {
    return one.lines.empty() ? places_.place(callout, faces, SymbolPlaces::Ends::anything)
                             : places_.place_at_edge(callout, one.lines, SymbolPlaces::Ends::anything);
  }

  // Notes and surface textures.
  void add_words(std::size_t i) {
    const ModelRequirement& one = file_.all[i];
    if (one.kind == RequirementKind::surface_texture)
      add_callout(i, texture_of(one));
    else
      add_callout(i, one.faces.empty() ? scene::NoteText{{one.text}} : note_of(one));
  }

  // Of the whole part beside the title block, otherwise at a leader to its edge or faces. The symbol of a surface
  // stands at each of its places.
  template <class Content>
  void add_callout(std::size_t i, Content content) {
    const ModelRequirement& one = file_.all[i];
    scene::CalloutDescription callout;
    callout.where = where(i);
    callout.requirement = key_of(file_, i);
    callout.content = std::move(content);
    const bool is_each = one.kind == RequirementKind::surface_texture && one.lines.empty();
    std::vector<std::vector<int>> places;
    if (is_each)
      places = face_places(one.faces, subject_.part);
    else if (!one.faces.empty())
      places.push_back(one.faces);
    std::vector<scene::CalloutDescription> placed;
    for (const std::vector<int>& faces : places) {
      placed.push_back(callout);
      if (place_words(placed.back(), one, faces)) continue;
      file_.rows[i].why = not_seen;
      return;
    }
    if (placed.empty()) placed.push_back(callout), placed.front().sheet = {sheet_, callout.where};
    set_drawn(i, placed.front().view.value_or(""));
    std::ranges::move(placed, std::back_inserter(scene_.callouts));
  }

  // Whether tolerances of two planes mean the plane in the middle.
  [[nodiscard]] bool is_of_size(const std::vector<std::size_t>& stack) const {
    const int face = file_.all[stack.front()].faces.front();
    return subject_.part.faces[static_cast<std::size_t>(face)].surface.kind == surfaces::SurfaceKind::plane &&
           std::any_of(stack.begin(), stack.end(), [this](std::size_t i) {
             return file_.all[i].type == "position" || file_.all[i].type == "symmetry";
           });
  }

  // Returns why it has no place.
  std::string place_frame(scene::CalloutDescription& callout, const std::vector<std::size_t>& stack) {
    const auto& [faces, lines] = std::tie(file_.all[stack.front()].faces, file_.all[stack.front()].lines);
    auto& frame = std::get<scene::ToleranceFrame>(callout.content);
    using Ends = SymbolPlaces::Ends;
    const bool is_straightness =
        std::any_of(stack.begin(), stack.end(), [this](std::size_t i) { return file_.all[i].type == "straightness"; });
    const Ends ends = frame.all_around ? Ends::lines_of_all : is_straightness ? Ends::element : Ends::anything;
    if (!lines.empty()) return places_.place_at_edge(callout, lines, ends) ? "" : not_seen;
    if (!places_.place(callout, faces, ends)) return not_seen;
    const std::size_t count = face_places(faces, subject_.part).size();
    if (callout.dimension.given() || count == 1) return "";
    if (is_of_size(stack)) return of_size;
    if (!frame.all_around && !is_all_over(file_.all[stack.front()])) frame.above = sheet::times(count) + frame.above;
    while (frame.above.ends_with(' ')) frame.above.pop_back();
    return "";
  }

  void add_frame(std::vector<std::size_t>& stack) {
    std::vector<std::pair<std::size_t, std::string>> refused;
    scene::CalloutDescription callout;
    callout.where = where(stack.front());
    callout.content = frame_of(file_.all, stack, subject_, refused);
    for (auto& [number, why] : refused) file_.rows[number].why = std::move(why);
    if (stack.empty()) return;
    const ModelRequirement& first = file_.all[stack.front()];
    if (first.faces.empty() && !is_of_all(first)) return;
    if (first.faces.empty()) callout.sheet = {sheet_, callout.where};
    const std::string why = first.faces.empty() ? "" : place_frame(callout, stack);
    for (const std::size_t i : stack) {
      callout.requirement += (callout.requirement.empty() ? "" : " ") + key_of(file_, i);
      if (why.empty())
        set_drawn(i, callout.view.value_or(""));
      else
        file_.rows[i].why = why;
    }
    if (why.empty()) scene_.callouts.push_back(std::move(callout));
  }

  scene::SceneDescription& scene_;
  FileRequirements& file_;
  const RequirementSubject& subject_;
  int sheet_;
  SymbolPlaces places_;
  std::vector<scene::DimensionDescription> dimensions_{};
  std::map<std::size_t, std::size_t> drawn_by_{};  ///< number of the dimension, before equal ones are one
  std::map<std::size_t, std::size_t> noted_by_{};  ///< of dimensions that are notes, number of the callout
  /// Number of the first dimension of these words, faces and lines.
  std::map<std::tuple<std::string, std::vector<int>, std::vector<std::array<double, 6>>>, std::size_t> stated_{};
  /// Numbers of dimensions that have a value, by type and faces; of those between lines, by faces; and of targets, by
  /// the letter of their datum.
  std::map<std::pair<std::string, std::vector<int>>, std::vector<std::size_t>> valued_{};
  std::map<std::vector<int>, std::vector<std::size_t>> lined_{};
  std::map<std::string, std::vector<std::size_t>> targets_{};
  std::set<std::string> letters_{};  ///< of the datums on the sheets
};

bool is_unseen(const report::RequirementRow& row) {
  return row.is_missing() && (row.why == not_seen || row.why == line_not_seen);
}

// Normals and axes of the faces of what no view shows, each once.
std::vector<Vec3> directions_of_unseen(const FileRequirements& file, const world::PlacedPart& part) {
  std::set<int> faces;
  for (std::size_t i = 0; i < file.rows.size(); ++i)
    if (is_unseen(file.rows[i])) faces.insert(file.all[i].faces.begin(), file.all[i].faces.end());
  std::vector<Vec3> directions;
  for (const int face : faces)
    if (const surfaces::PartSurface& surface = part.faces[static_cast<std::size_t>(face)].surface;
        surface.kind == surfaces::SurfaceKind::plane || surfaces::has_axis(surface.kind))
      directions.push_back(surface.axis);
  return directions;
}

// For what no view of the sheet shows: the views that would, which are returned.
std::vector<std::string> propose_views(const scene::SceneDescription& scene, FileRequirements& file,
                                       const RequirementSubject& subject) {
  if (std::none_of(file.rows.begin(), file.rows.end(), is_unseen)) return {};
  std::vector<ShowingView> showing;
  for (const TrialView& trial : views_to_try(directions_of_unseen(file, subject.part))) {
    const FaceView view(trial.projection, trial.seen, subject.world);
    scene::SceneDescription other = scene;
    FileRequirements seen = file;
    const std::span<const FaceView> alone(&view, 1);
    Statement(other, seen, {subject.world, subject.model, subject.part, subject.triangles, alone, subject.manner}, 1)
        .add_all();
    std::vector<std::size_t>& rows = showing.emplace_back(ShowingView{trial.projection, {}}).shows;
    for (std::size_t i = 0; i < file.rows.size(); ++i)
      if (is_unseen(file.rows[i]) && seen.rows[i].is_drawn()) rows.push_back(i);
  }
  std::vector<std::string> views;
  for (const ShowingView& one : few_views(std::move(showing))) {
    views.push_back(one.projection);
    for (const std::size_t i : one.shows) {
      std::string& why = file.rows[i].why;
      why = why.substr(0, why.find(':')) + ": add the view '" + one.projection + "'";
    }
  }
  return views;
}

}  // namespace

void choose_notation(scene::SceneDescription& scene, const std::vector<FileRequirements>& files) {
  bool any = false, all = true;
  std::vector<std::string> standards;
  for (const FileRequirements& file : files) {
    const bool is_wanted = std::ranges::any_of(file.rows, [](const report::RequirementRow& row) { return row.wanted; });
    if (is_wanted && !file.standard.empty() && std::ranges::find(standards, file.standard) == standards.end())
      standards.push_back(file.standard);
    for (std::size_t i = 0; i < file.all.size(); ++i) {
      const ModelRequirement& one = file.all[i];
      const bool is_texture = one.kind == RequirementKind::surface_texture;
      if (!file.rows[i].wanted || one.is_angle || is_texture || !std::isfinite(one.value)) continue;
      any = true;
      all = all && written_unit(one) != 1;
    }
  }
  std::string standard;
  for (const std::string& one : standards) append_to_list(standard, one);
  for (scene::SheetDescription& sheet : scene.sheets) {
    if (any && all && !sheet.dimension_unit.given()) sheet.dimension_unit = {Unit::in, "the unit of requirements"};
    if (!standard.empty() && sheet.field("standard").empty())
      sheet.title_block.emplace_back("standard", scene::LocatedText{standard, "the standard of requirements"});
  }
}

std::vector<std::string> state_requirements(scene::SceneDescription& scene, std::vector<FileRequirements>& files,
                                            const SheetToState& sheet) {
  const auto is_open = [](const FileRequirements& file) {
    return std::any_of(file.rows.begin(), file.rows.end(), [](const auto& row) { return row.is_missing(); });
  };
  std::vector<std::string> views_to_add;
  if (std::none_of(files.begin(), files.end(), is_open)) return views_to_add;
  const std::vector<FaceView> views = views_for_requirements(sheet);
  const world::World& world = sheet.worlds.main();
  const scene::SheetDescription& description = scene.sheets[static_cast<std::size_t>(sheet.views.sheet)];
  const Manner manner{description.dimension_unit.value_or(Unit::mm), follows_asme(description)};
  for (FileRequirements& file : files) {
    const world::Placed& placed = world.models[static_cast<std::size_t>(file.model)];
    // What a file without faces says is about the whole part.
    std::optional<world::PlacedPart> part;
    if (file.part == nullptr)
      part = world::PlacedPart{};
    else if (placed.part == file.part)
      part = world::place_part(placed);
    if (part) {
      const TrianglesByFace triangles = triangles_by_face(world, static_cast<std::size_t>(file.model));
      const RequirementSubject subject{world, file.model, *part, triangles, views, manner};
      Statement(scene, file, subject, sheet.views.sheet + 1).add_all();
      std::ranges::move(propose_views(scene, file, subject), std::back_inserter(views_to_add));
      continue;
    }
    for (report::RequirementRow& row : file.rows)
      if (row.is_missing()) row.why = "the faces of the file are not those that are drawn";
  }
  return views_to_add;
}

}  // namespace epura::pipeline
