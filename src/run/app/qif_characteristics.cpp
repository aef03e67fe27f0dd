// SPDX-License-Identifier: Apache-2.0
#include "app/qif_characteristics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/text.hpp"
#include "base/utf8.hpp"
#include "composition/requirement_words.hpp"

namespace epura::qif {

namespace {

using importer::ModelRequirement;
using importer::RequirementBounds;
using importer::RequirementKind;

constexpr const char* other_kind = "UserDefinedAttribute";

bool has(std::string_view text, std::string_view word) { return text.find(word) != std::string_view::npos; }

bool is_modified(const ModelRequirement& one, std::string_view word) {
  const std::vector<std::string> words = pipeline::items_of(one.modifiers, ", ");
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_exact(const ModelRequirement& one) { return is_modified(one, "theoretical") || is_modified(one, "basic"); }
bool is_auxiliary(const ModelRequirement& one) {
  return is_modified(one, "auxiliary") || is_modified(one, "reference");
}

// What a geometric tolerance holds behind its value.
enum class Content { plain, straightness, orientation, position, location_zone, location, profile, runout };

struct ToleranceKind {
  std::string_view type;
  const char* kind;
  Content content;
};

// The profile of a line needs the plane of the line, which files do not state.
constexpr std::array tolerance_kinds{ToleranceKind{"flatness", "Flatness", Content::plain},
                                     ToleranceKind{"straightness", "Straightness", Content::straightness},
                                     ToleranceKind{"roundness", "Circularity", Content::plain},
                                     ToleranceKind{"cylindricity", "Cylindricity", Content::plain},
                                     ToleranceKind{"angularity", "Angularity", Content::orientation},
                                     ToleranceKind{"perpendicularity", "Perpendicularity", Content::orientation},
                                     ToleranceKind{"parallelism", "Parallelism", Content::orientation},
                                     ToleranceKind{"position", "Position", Content::position},
                                     ToleranceKind{"coaxiality", "Coaxiality", Content::location_zone},
                                     ToleranceKind{"concentricity", "Concentricity", Content::location_zone},
                                     ToleranceKind{"symmetry", "Symmetry", Content::location},
                                     ToleranceKind{"surface profile", "SurfaceProfile", Content::profile},
                                     ToleranceKind{"circular runout", "CircularRunout", Content::runout},
                                     ToleranceKind{"total runout", "TotalRunout", Content::runout}};

const ToleranceKind* tolerance_kind(const ModelRequirement& one) {
  const auto row = std::find_if(tolerance_kinds.begin(), tolerance_kinds.end(),
                                [&](const ToleranceKind& known) { return known.type == one.type; });
  return row == tolerance_kinds.end() || !std::isfinite(one.value) || one.value < 0 ? nullptr : &*row;
}

std::string dimension_kind(const ModelRequirement& one, const CharacteristicLinks& links) {
  const bool is_between = links.nominal_features.size() == 2;
  if (one.is_angle != 0) return is_between ? "AngleBetween" : "Angle";
  const std::string round = has(one.type, "spher") ? "Spherical" : "";
  if (has(one.type, "diameter")) return round + "Diameter";
  if (has(one.type, "radius")) return round + "Radius";
  if (has(one.type, "thickness")) return "Thickness";
  if (has(one.type, "curve")) return "CurveLength";
  if (is_modified(one, "square")) return "Square";
  return is_between ? "DistanceBetween" : "Length";
}

// In the unit of the document; with the decimals that the file states in it.
void add_value(pugi::xml_node node, const char* name, double value, const ModelRequirement& one, const Units& units) {
  const double unit = one.is_angle != 0 ? 1 : units.length;
  constexpr int digits = 15;
  add_text(node, name, format_rounded(value / unit, digits));
  const std::string_view element = name;
  if (one.decimals >= 0 && one.unit == unit && (element == "TargetValue" || element == "ToleranceValue"))
    node.last_child().append_attribute("decimalPlaces") = one.decimals;
}

void add_marks(pugi::xml_node node, const ModelRequirement& one) {
  constexpr std::array<std::array<const char*, 2>, 9> marks{{{"free state condition", "FreeState"},
                                                             {"free state", "FreeState"},
                                                             {"statistical", "StatisticalCharacteristic"},
                                                             {"statistical tolerance", "StatisticalCharacteristic"},
                                                             {"common zone", "CommonZone"},
                                                             {"common tolerance", "CommonTolerance"},
                                                             {"envelope requirement", "EnvelopeRequirement"},
                                                             {"independency", "Independency"},
                                                             {"continuous feature", "UnitedOrContinuousFeature"}}};
  for (const auto& [word, element] : marks)
    if (is_modified(one, word) && !node.child(element)) add_text(node, element, "true");
}

void add_frame(pugi::xml_node node, const CharacteristicLinks& links) {
  if (links.datum_frame > 0) add_text(node, "DatumReferenceFrameId", std::to_string(links.datum_frame));
}

bool is_round(const ModelRequirement& one) { return has(one.zone, "cylind") || one.zone == "within a circle"; }

void add_zone(pugi::xml_node node, const ModelRequirement& one, const char* flat) {
  pugi::xml_node zone = node.append_child("ZoneShape");
  const bool has_spheres = one.type == "position" || one.type == "concentricity";
  const bool is_sphere = has_spheres && has(one.zone, "spher");
  zone.append_child(is_sphere ? "SphericalZone" : is_round(one) ? "DiametricalZone" : flat);
}

// "unequally disposed 0.2 mm"
void add_length_of(pugi::xml_node node, const ModelRequirement& one, std::string_view word, const char* element,
                   const Units& units) {
  for (const std::string& item : pipeline::items_of(one.modifiers, ", "))
    if (const auto length = pipeline::length_in(item, word)) add_value(node, element, *length, one, units);
}

void add_extent(pugi::xml_node node, const ModelRequirement& one) {
  const char* extent = is_modified(one, "all over") ? "ALL_OVER" : is_modified(one, "all around") ? "ALL_AROUND" : "";
  if (*extent != '\0') add_text(node.append_child("Extent"), "ExtentEnum", extent);
}

void add_tolerance(pugi::xml_node node, const ModelRequirement& one, const CharacteristicLinks& links,
                   const Units& units) {
  const Content content = tolerance_kind(one)->content;
  add_value(node, "ToleranceValue", one.value, one, units);
  if (content == Content::profile) {
    add_length_of(node, one, "unequally disposed ", "OuterDisposition", units);
    add_frame(node, links);
    return add_extent(node, one);
  }
  const bool is_of_form = content == Content::plain || content == Content::straightness;
  if (!is_of_form) add_frame(node, links);
  const bool has_material = content == Content::orientation || content == Content::position;
  const std::string material = material_of(one.modifiers);
  const bool may_have_it = content == Content::straightness || one.type == "flatness";
  if (has_material || (may_have_it && material != "NONE")) add_text(node, "MaterialCondition", material);
  if (content == Content::orientation) {
    add_zone(node, one, "PlanarZone");
    if (is_modified(one, "tangent plane")) add_text(node, "TangentPlane", "true");
  } else if (content == Content::straightness || content == Content::position || content == Content::location_zone) {
    add_zone(node, one, "NonDiametricalZone");
  }
  if (has_material) add_length_of(node, one, "maximum ", "MaximumToleranceValue", units);
}

// "H7": the letters of the zone, and its grade.
bool add_fit(pugi::xml_node node, const std::string& fit) {
  const std::size_t grade = fit.find_first_of("0123456789");
  if (grade == 0 || grade == std::string::npos) return false;
  pugi::xml_node specification = node.append_child("LimitsAndFitsSpecification");
  specification.append_attribute("zoneVariance") = 'A' <= fit.front() && fit.front() <= 'Z' ? "HOLE" : "SHAFT";
  add_text(specification, "FormVariance", fit.substr(0, grade));
  add_text(specification, "Grade", fit.substr(grade));
  return true;
}

void add_dimension(pugi::xml_node node, const ModelRequirement& one, const CharacteristicLinks& links,
                   const Units& units) {
  const bool is_loose = is_exact(one) || is_auxiliary(one);
  if (is_loose) add_text(node, "DimensionType", is_exact(one) ? "BASIC_OR_TED" : "REFERENCE_OR_AUXILIARY");
  const bool is_least = is_modified(one, "minimum"), is_most = is_modified(one, "maximum");
  if (!is_loose && one.bounds != RequirementBounds::none) {
    pugi::xml_node tolerance = node.append_child("Tolerance");
    if (std::isfinite(one.upper)) add_value(tolerance, "MaxValue", one.upper, one, units);
    if (std::isfinite(one.lower)) add_value(tolerance, "MinValue", one.lower, one, units);
    add_text(tolerance, "DefinedAsLimit", one.bounds == RequirementBounds::limits ? "true" : "false");
  } else if (!is_loose && std::isfinite(one.value) && (is_least || is_most)) {
    pugi::xml_node tolerance = node.append_child("Tolerance");
    add_value(tolerance, is_most ? "MaxValue" : "MinValue", one.value, one, units);
    add_text(tolerance, "DefinedAsLimit", "true");
  } else if (is_loose || dimension_kind(one, links) != "Diameter" || !add_fit(node, one.fit)) {
    add_text(node, "NonTolerance", "MEASURED");
  }
  if (dimension_kind(one, links) == "Radius" && is_modified(one, "controlled radius"))
    add_text(node, "ControlledRadius", "true");
}

}  // namespace

std::string material_of(std::string_view modifiers) {
  const char* reciprocity = has(modifiers, "reciprocity requirement") ? "_RPR" : "";
  if (has(modifiers, "maximum material")) return std::string("MAXIMUM") + reciprocity;
  if (has(modifiers, "least material")) return std::string("LEAST") + reciprocity;
  return has(modifiers, "regardless of feature size") ? "REGARDLESS" : "NONE";
}

void add_text(pugi::xml_node node, const char* name, const std::string& text) {
  node.append_child(name).text().set(valid_utf8(text).c_str());
}

void add_number(pugi::xml_node node, const char* name, double value) { add_text(node, name, format_number(value)); }

void add_ids(pugi::xml_node node, const char* name, const std::vector<int>& ids) {
  if (ids.empty()) return;
  pugi::xml_node list = node.append_child(name);
  list.append_attribute("n") = static_cast<unsigned>(ids.size());
  for (const int id : ids) add_text(list, "Id", std::to_string(id));
}

std::string kind_of(const ModelRequirement& one, const CharacteristicLinks& links) {
  if (one.kind == RequirementKind::dimension) return dimension_kind(one, links);
  const ToleranceKind* kind = tolerance_kind(one);
  return kind == nullptr ? other_kind : kind->kind;
}

void add_definition(pugi::xml_node definition, const ModelRequirement& one, const CharacteristicLinks& links,
                    const std::string& words, const Units& units) {
  add_marks(definition, one);
  if (one.kind == RequirementKind::dimension)
    add_dimension(definition, one, links, units);
  else if (tolerance_kind(one) != nullptr)
    add_tolerance(definition, one, links, units);
  else
    add_text(definition, "WhatToMeasure", words);
}

void add_nominal(pugi::xml_node nominal, const ModelRequirement& one, const CharacteristicLinks& links,
                 const Units& units) {
  const std::string kind = kind_of(one, links);
  const bool is_between = kind.ends_with("Between");
  if (!is_between) add_ids(nominal, "FeatureNominalIds", links.nominal_features);
  if (one.kind != RequirementKind::dimension) return;
  if (std::isfinite(one.value)) add_value(nominal, "TargetValue", one.value, one, units);
  if (!is_between) return;
  pugi::xml_node pairs = nominal.append_child("FeatureNominalPairs");
  pairs.append_attribute("n") = 1;
  pugi::xml_node pair = pairs.append_child("FeaturePair");
  add_text(pair, "FirstFeature", std::to_string(links.nominal_features[0]));
  add_text(pair, "SecondFeature", std::to_string(links.nominal_features[1]));
  add_text(nominal, "AnalysisMode", "THREEDIMENSIONAL");
}

}  // namespace epura::qif
