// SPDX-License-Identifier: Apache-2.0
#include "importer/document.hpp"

#include <epura/importer_abi.h>

#include <algorithm>
#include <cmath>

#include "foreign/parameters.hpp"

namespace epura::importer {

namespace {

using foreign::Packer;
using foreign::Unpacker;

bool are_within(const std::vector<int>& numbers, int least, std::size_t count) {
  return std::all_of(numbers.begin(), numbers.end(), [&](int n) { return n >= least && n < static_cast<int>(count); });
}

bool are_ends(const std::vector<int>& ends, std::size_t count) {
  return std::is_sorted(ends.begin(), ends.end()) && (ends.empty() ? 0 : ends.back()) == static_cast<int>(count) &&
         (ends.empty() || ends.front() >= 0);
}

bool is_colour(int colour) { return no_colour <= colour && colour <= 0xffffff; }

bool is_kind(const surfaces::PartSurface& face) {
  return static_cast<std::size_t>(face.kind) < surfaces::surface_kind_names.size();
}

bool is_sound(const Shape& shape) {
  std::vector<int> edge_ends;
  for (const surfaces::DeclaredEdge& edge : shape.edges) edge_ends.push_back(edge.end);
  return std::isfinite(shape.step) && shape.step >= 0 && are_within(shape.corners, 0, shape.points.size()) &&
         are_ends(shape.polygon_ends, shape.corners.size()) &&
         shape.face_of_polygon.size() == shape.polygon_ends.size() &&
         shape.body_of_polygon.size() == shape.polygon_ends.size() &&
         shape.body_colours.size() == shape.body_names.size() && is_colour(shape.colour) &&
         std::all_of(shape.body_colours.begin(), shape.body_colours.end(), is_colour) &&
         std::all_of(shape.faces.begin(), shape.faces.end(), is_kind) &&
         are_within(shape.face_of_polygon, -1, shape.faces.size()) &&
         are_within(shape.body_of_polygon, -1, shape.body_names.size()) &&
         are_within(shape.edge_vertices, 0, shape.points.size()) && are_ends(edge_ends, shape.edge_vertices.size()) &&
         are_within(shape.wire_vertices, 0, shape.points.size()) &&
         are_within(shape.marked_points, 0, shape.points.size()) &&
         are_ends(shape.wire_ends, shape.wire_vertices.size());
}

bool is_sound_requirement(const Requirement& requirement, const std::vector<Shape>& shapes) {
  return requirement.kind <= RequirementKind::surface_texture && requirement.bounds <= RequirementBounds::limits &&
         -1 <= requirement.decimals && requirement.decimals <= max_decimals && has_sound_places(requirement) &&
         std::all_of(requirement.faces.begin(), requirement.faces.end(), [&](const std::array<int, 2>& face) {
           return 0 <= face[0] && face[0] < static_cast<int>(shapes.size()) && 0 <= face[1] &&
                  face[1] < static_cast<int>(shapes[static_cast<std::size_t>(face[0])].faces.size());
         });
}

// One function for both packing and unpacking, so that the two always agree.

template <class Pack, class Value>
void pack_shape(Pack& pack, Value& shape) {
  pack(shape.name), pack(shape.step), pack(shape.points), pack(shape.corners), pack(shape.polygon_ends),
      pack(shape.face_of_polygon);
  pack(shape.body_of_polygon), pack(shape.body_names), pack(shape.body_colours), pack(shape.colour), pack(shape.faces);
  pack(shape.edges), pack(shape.edge_vertices), pack(shape.wire_vertices), pack(shape.wire_ends),
      pack(shape.marked_points);
}

template <class Pack, class Value>
void pack_node(Pack& pack, Value& node) {
  pack(node.parent), pack(node.shape), pack(node.name), pack(node.transform), pack(node.colour);
}

template <class Pack, class Value>
void pack_requirement(Pack& pack, Value& requirement) {
  pack(requirement.kind), pack(requirement.bounds), pack(requirement.is_angle), pack(requirement.decimals);
  pack(requirement.value), pack(requirement.lower), pack(requirement.upper), pack(requirement.unit);
  for (auto* text :
       {&requirement.id, &requirement.type, &requirement.name, &requirement.fit, &requirement.modifiers,
        &requirement.zone, &requirement.datums, &requirement.above, &requirement.missing, &requirement.text})
    pack(*text);
  pack(requirement.faces), pack(requirement.lines), pack(requirement.area);
}

template <class Pack, class Value>
void pack_rest(Pack& pack, Value& document) {
  pack(document.unit), pack(document.is_y_up), pack(document.is_single_precision), pack(document.is_printed);
  pack(document.notes);
}

}  // namespace

bool has_sound_places(const StatedRequirement& requirement) {
  const auto are_finite = [](const auto& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double v) { return std::isfinite(v); });
  };
  return (requirement.area.empty() || requirement.area.size() == 3) &&
         std::all_of(requirement.area.begin(), requirement.area.end(), are_finite) &&
         std::all_of(requirement.lines.begin(), requirement.lines.end(), are_finite);
}

void expect_sound(const Document& document) {
  foreign::require(std::all_of(document.shapes.begin(), document.shapes.end(), is_sound), "corrupts its process");
  for (std::size_t i = 0; i < document.nodes.size(); ++i) {
    const Node& node = document.nodes[i];
    foreign::require(node.parent >= -1 && node.parent < static_cast<int>(i) && is_colour(node.colour),
                     "corrupts its process");
    foreign::require(node.shape >= -1 && node.shape < static_cast<int>(document.shapes.size()),
                     "hands over a node with a shape that it does not hand over");
  }
  foreign::require(std::all_of(document.requirements.begin(), document.requirements.end(),
                               [&](const Requirement& one) { return is_sound_requirement(one, document.shapes); }),
                   "corrupts its process");
}

void pack_document(Packer& pack, const Document& document) {
  pack_rest(pack, document);
  pack(document.shapes.size());
  for (const Shape& shape : document.shapes) pack_shape(pack, shape);
  pack(document.nodes.size());
  for (const Node& node : document.nodes) pack_node(pack, node);
  pack(document.requirements.size());
  for (const Requirement& requirement : document.requirements) pack_requirement(pack, requirement);
}

Document unpack_document(Unpacker& unpack) {
  Document document;
  pack_rest(unpack, document);
  document.shapes.resize(unpack.count(1));
  for (Shape& shape : document.shapes) pack_shape(unpack, shape);
  document.nodes.resize(unpack.count(1));
  for (Node& node : document.nodes) pack_node(unpack, node);
  document.requirements.resize(unpack.count(1));
  for (Requirement& requirement : document.requirements) pack_requirement(unpack, requirement);
  return document;
}

}  // namespace epura::importer
