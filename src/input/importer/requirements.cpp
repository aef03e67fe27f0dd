// SPDX-License-Identifier: Apache-2.0
#include "importer/requirements.hpp"

#include <algorithm>
#include <array>

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
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  }
  return requirements;
}

std::size_t count_of(const std::vector<ModelRequirement>& requirements, RequirementKind kind) {
  return static_cast<std::size_t>(std::count_if(requirements.begin(), requirements.end(),
                                                [&](const ModelRequirement& one) { return one.kind == kind; }));
}

std::string counted_requirements(const std::vector<ModelRequirement>& requirements) {
  constexpr std::array words{"dimension", "geometric tolerance", "datum"};
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
