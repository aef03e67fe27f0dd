// SPDX-License-Identifier: Apache-2.0
#include "importer/requirements.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/error.hpp"

namespace epura::importer {

namespace {

// What became of each face of the file: neighbours on one surface are one face of the part. -1: it has no triangles.
std::vector<int> faces_on_mesh(const Assembled& assembled, const mesh::Mesh& mesh, const surfaces::PartFaces& part) {
  std::vector<int> face_of_declared(assembled.part.faces.size(), -1);
  for (std::size_t t = 0; t < part.face_of_triangle.size(); ++t) {
    const auto polygon = static_cast<std::size_t>(mesh.polygon[t]);
    face_of_declared[static_cast<std::size_t>(assembled.part.face_of_polygon[polygon])] = part.face_of_triangle[t];
  }
  return face_of_declared;
}

std::array<double, 3> moved(const Vec4& v, const Mat4& to_file) {
  const Vec4 at = to_file * v;
  return {at.x, at.y, at.z};
}

// From the coordinates of a shape to those of the file, where the shape stands first.
void move_places(StatedRequirement& requirement, const Mat4& to_file) {
  for (std::array<double, 6>& line : requirement.lines) {
    const auto from = moved({line[0], line[1], line[2], 1}, to_file),
               to = moved({line[3], line[4], line[5], 1}, to_file);
    line = {from[0], from[1], from[2], to[0], to[1], to[2]};
  }
  double w = 1;  // the first is a point, the others are directions
  for (std::array<double, 3>& v : requirement.area) v = moved({v[0], v[1], v[2], std::exchange(w, 0)}, to_file);
}

}  // namespace

std::vector<ModelRequirement> requirements_of(const Document& document, const Assembled& assembled,
                                              const mesh::Mesh& mesh, const surfaces::PartFaces* part) {
  constexpr std::size_t max_required = 100'000'000;  // faces, wherever they stand
  std::size_t required = 0;
  std::vector<ModelRequirement> requirements;
  std::vector<int> on_mesh;
  if (part != nullptr && !document.requirements.empty()) on_mesh = faces_on_mesh(assembled, mesh, *part);
  for (std::size_t i = 0; i < document.requirements.size(); ++i) {
    ModelRequirement& requirement = requirements.emplace_back(ModelRequirement{document.requirements[i]});
    if (on_mesh.empty()) continue;
    std::vector<int>& faces = requirement.faces;
    for (const auto& [shape, face] : document.requirements[i].faces) {
      const std::vector<int>& first_faces = assembled.first_faces[static_cast<std::size_t>(shape)];
      if ((required += first_faces.size()) > max_required)
        throw Error(ErrorKind::input, "", "requires something of more faces than a file can", "leave requirements out");
      for (const int first : first_faces)
        if (const int on_part = on_mesh[static_cast<std::size_t>(first + face)]; on_part >= 0) faces.push_back(on_part);
    }
    if (const auto& own = document.requirements[i].faces; !own.empty()) {
      const std::vector<Mat4>& places = assembled.places[static_cast<std::size_t>(own.front()[0])];
      if (!places.empty()) move_places(requirement, places.front());
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  }
  return requirements;
}

bool is_measured(RequirementKind kind) { return kind != RequirementKind::datum && kind != RequirementKind::note; }

std::size_t count_of(const std::vector<ModelRequirement>& requirements, RequirementKind kind) {
  return static_cast<std::size_t>(std::count_if(requirements.begin(), requirements.end(),
                                                [&](const ModelRequirement& one) { return one.kind == kind; }));
}

std::string counted_requirements(const std::vector<ModelRequirement>& requirements) {
  constexpr std::array words{"dimension", "geometric tolerance", "datum", "note", "surface texture"};
  std::vector<std::string> counts;
  for (std::size_t kind = 0; kind < words.size(); ++kind) {
    const std::size_t count = count_of(requirements, static_cast<RequirementKind>(kind));
    if (count > 0) counts.push_back(std::to_string(count) + " " + words[kind] + (count == 1 ? "" : "s"));
  }
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i)
    text += (i == 0 ? "" : i + 1 < counts.size() ? ", " : " and ") + counts[i];
  return text;
}

}  // namespace epura::importer
