// SPDX-License-Identifier: Apache-2.0
#include "step_pictures.hpp"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "measures.hpp"

namespace occt {

namespace {

using Line = std::vector<gp_Pnt>;

/// The statements of which pictures consist.
class PictureReader {
 public:
  PictureReader(std::string_view text, double unit) : unit_(unit) {
    visit_statements(text, [this](const Statement& statement) {
      if (has_record(statement, is_part)) parts_.emplace(statement.number, statement);
    });
  }

  [[nodiscard]] std::string name_of(EntityNumber annotation) const {
    const auto found = parts_.find(annotation);
    return found == parts_.end() ? "" : unquoted(argument_of(found->second.records.front(), 0));
  }

  [[nodiscard]] std::vector<Line> lines_of(EntityNumber annotation) const {
    std::vector<Line> lines;
    const auto find = [this](EntityNumber number) {
      const auto found = parts_.find(number);
      return found == parts_.end() ? nullptr : &found->second;
    };
    visit_parts(annotation, find, [&](EntityNumber, const Record& record) {
      if (record.keyword == "POLYLINE")
        lines.push_back(line_through(references_in(argument_of(record, 1))));
      else if (record.keyword == "TESSELLATED_CURVE_SET")
        add_strips(record, lines);
      else if (record.keyword.ends_with("TRIANGULATED_SURFACE_SET"))
        add_rims(record, lines);
      else
        return true;
      return false;
    });
    return lines;
  }

 private:
  static bool is_part(std::string_view keyword) {
    return keyword == "DRAUGHTING_CALLOUT" || keyword == "CARTESIAN_POINT" || keyword == "POLYLINE" ||
           keyword == "COORDINATES_LIST" || keyword.ends_with("TRIANGULATED_SURFACE_SET") ||
           keyword.starts_with("TESSELLATED_") || keyword.starts_with("GEOMETRIC_") ||
           keyword.find("ANNOTATION_") != std::string_view::npos;
  }

  [[nodiscard]] std::optional<gp_Pnt> point_of(std::string_view coordinates) const {
    const std::vector<std::string_view> all = arguments_of(coordinates);
    if (all.size() != 3) return std::nullopt;
    const gp_XYZ at = gp_XYZ(number_in(all[0]), number_in(all[1]), number_in(all[2])) * unit_;
    return std::isfinite(at.SquareModulus()) ? std::optional(gp_Pnt(at)) : std::nullopt;
  }

  [[nodiscard]] Line line_through(const std::vector<EntityNumber>& points) const {
    Line line;
    for (const EntityNumber number : points)
      if (const auto found = parts_.find(number); found != parts_.end())
        if (const Record* record = record_of(found->second, "CARTESIAN_POINT"))
          if (const auto point = point_of(argument_of(*record, 1))) line.push_back(*point);
    return line;
  }

  // The points of the list of coordinates of a set, as the file writes them.
  [[nodiscard]] std::vector<std::string_view> coordinates_of(const Record& set) const {
    const auto found = parts_.find(reference_in(argument_of(set, 1)));
    const Record* list = found == parts_.end() ? nullptr : record_of(found->second, "COORDINATES_LIST");
    return list == nullptr ? std::vector<std::string_view>() : arguments_of(last_argument_of(*list));
  }

  // Those with these numbers, from 1; of a set with numbers of its own, numbers of these.
  static std::vector<std::string_view> chosen(std::string_view numbers, const std::vector<std::string_view>& among) {
    std::vector<std::string_view> some;
    for (const std::string_view text : arguments_of(numbers))
      if (const double number = number_in(text); number >= 1 && number <= static_cast<double>(among.size()))
        some.push_back(among[static_cast<std::size_t>(number) - 1]);
    return some;
  }

  void add_line(const std::vector<std::string_view>& points, std::vector<Line>& lines) const {
    Line& line = lines.emplace_back();
    for (const std::string_view coordinates : points)
      if (const auto point = point_of(coordinates)) line.push_back(*point);
  }

  void add_strips(const Record& curves, std::vector<Line>& lines) const {
    const std::vector<std::string_view> coordinates = coordinates_of(curves);
    for (const std::string_view strip : arguments_of(argument_of(curves, 2)))
      add_line(chosen(strip, coordinates), lines);
  }

  // Letters and arrows are areas: sides that one triangle has alone are their outline.
  void add_rims(const Record& areas, std::vector<Line>& lines) const {
    std::vector<std::string_view> points = coordinates_of(areas);
    if (auto own = chosen(argument_of(areas, 4), points); !own.empty()) points = std::move(own);
    std::map<std::pair<std::string_view, std::string_view>, int> uses;
    const auto add = [&uses](std::string_view a, std::string_view b, std::string_view c) {
      if (a == b || b == c || c == a) return;
      for (const auto& side : {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)}) ++uses[side];
    };
    for (const std::string_view list : arguments_of(argument_of(areas, 5)))
      if (const auto strip = chosen(list, points); strip.size() > 2)
        for (std::size_t i = 2; i < strip.size(); ++i) add(strip[i - 2], strip[i - 1], strip[i]);
    for (const std::string_view list : arguments_of(argument_of(areas, 6)))
      if (const auto fan = chosen(list, points); fan.size() > 2)
        for (std::size_t i = 2; i < fan.size(); ++i) add(fan[0], fan[i - 1], fan[i]);
    for (const auto& [side, count] : uses)
      if (count == 1) add_line({side.first, side.second}, lines);
  }

  const double unit_;
  std::map<EntityNumber, Statement> parts_{};
};

}  // namespace

bool may_have_pictures(const Model& model) {
  return std::all_of(model.places.begin(), model.places.end(),
                     [](const Place& place) { return place.transform.Form() == gp_Identity; });
}

std::size_t add_pictures(Model& model, std::string_view text, const Pictures& pictures) {
  if (pictures.annotations.empty() || !may_have_pictures(model)) return 0;
  const PictureReader reader(text, pictures.length_unit);
  std::size_t count = 0;
  for (const EntityNumber annotation : pictures.annotations) {
    Part part{reader.name_of(annotation), {}, {}, {}};
    for (const Line& line : reader.lines_of(annotation))
      for (std::size_t i = 1; i < line.size(); ++i)
        if (line[i - 1].Distance(line[i]) > Precision::Confusion())
          part.wires.push_back(BRepBuilderAPI_MakeEdge(line[i - 1], line[i]));
    if (part.wires.empty()) continue;
    ++count;
    model.places.push_back({part.name, EPURA_NONE, static_cast<std::uint32_t>(model.parts.size()), gp_Trsf()});
    model.parts.push_back(std::move(part));
  }
  return count;
}

}  // namespace occt
