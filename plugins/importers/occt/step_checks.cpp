// SPDX-License-Identifier: Apache-2.0
#include "step_checks.hpp"

#include <Interface_Check.hxx>
#include <NCollection_IndexedDataMap.hxx>
#include <Precision.hxx>
#include <STEPConstruct_ExternRefs.hxx>
#include <StepAP214_AppliedExternalIdentificationAssignment.hxx>
#include <StepBasic_Document.hxx>
#include <StepBasic_ExternalSource.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepData_SelectNamed.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <StepGeom_HArray1OfTrimmingSelect.hxx>
#include <StepGeom_Parabola.hxx>
#include <StepGeom_TrimmedCurve.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepShape_SolidModel.hxx>
#include <StepShape_TopologicalRepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "model.hpp"

namespace occt {

namespace {

using Text = Handle(TCollection_HAsciiString);

bool is(const Text& text, const std::string& name) { return !text.IsNull() && name == text->ToCString(); }

/// "#12=SOLID" or "#12".
std::string label_of(const Handle(StepData_StepModel) & model, const Handle(Standard_Transient) & entity) {
  const Text label = model->StringLabel(entity);
  return label.IsNull() ? "?" : label->ToCString();
}

/// Excludes annotations of parts: dimensions, texts, dates.
bool is_shape(const Handle(Standard_Transient) & entity) {
  return std::string_view(entity->DynamicType()->Name()).substr(0, 9) == "StepGeom_" ||
         entity->IsKind(STANDARD_TYPE(StepShape_TopologicalRepresentationItem)) ||
         entity->IsKind(STANDARD_TYPE(StepShape_SolidModel)) ||
         entity->IsKind(STANDARD_TYPE(StepRepr_NextAssemblyUsageOccurrence));
}

bool leaves_folder(const std::string& name) {
  return name.find_first_of("/\\:") != std::string::npos || name == "." || name == "..";
}

/// The file name that the source of an identification may contain.
std::string source_name(const StepAP214_AppliedExternalIdentificationAssignment& identification) {
  if (identification.Source().IsNull()) return {};
  const auto name = Handle(StepData_SelectNamed)::DownCast(identification.Source()->SourceId().Value());
  return name.IsNull() || name->Kind() != 6 ? std::string() : name->String();  // 6: a text
}

void forget(const Handle(StepData_StepModel) & model, const std::string& name) {
  const Text nothing = new TCollection_HAsciiString("");
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto entity = model->Value(i);
    const auto named = Handle(StepAP214_AppliedExternalIdentificationAssignment)::DownCast(entity);
    if (!named.IsNull() && is(named->AssignedId(), name)) named->SetAssignedId(nothing);
    if (!named.IsNull() && source_name(*named) == name) named->SetSource(new StepBasic_ExternalSource);
    const auto document = Handle(StepBasic_Document)::DownCast(entity);
    if (document.IsNull()) continue;
    if (is(document->Id(), name)) document->SetId(nothing);
    if (is(document->Name(), name)) document->SetName(nothing);
  }
}

/// The files that Open CASCADE would read, too.
std::vector<std::string> referred_files(STEPControl_Reader& reader) {
  std::vector<std::string> names;
  STEPConstruct_ExternRefs references(reader.WS());
  references.LoadExternRefs();
  for (int i = 1; i <= references.NbExternRefs(); ++i) {
    const char* name = references.FileName(i);
    if (name == nullptr || *name == '\0' || std::find(names.begin(), names.end(), name) != names.end()) continue;
    names.emplace_back(name);
  }
  return names;
}

/// The products that each product contains, in the order of the file.
using Contents = NCollection_IndexedDataMap<Handle(Standard_Transient), std::vector<int>>;

Contents contents_of(const Handle(StepData_StepModel) & model) {
  Contents contents;
  const auto number = [&contents](const Handle(Standard_Transient) & product) {
    const int index = contents.FindIndex(product);
    return index != 0 ? index : contents.Add(product, {});
  };
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto use = Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(model->Value(i));
    if (use.IsNull() || use->RelatingProductDefinition().IsNull() || use->RelatedProductDefinition().IsNull()) continue;
    const int assembly = number(use->RelatingProductDefinition());
    const int part = number(use->RelatedProductDefinition());
    contents.ChangeFromIndex(assembly).push_back(part);
  }
  return contents;
}

bool has_point(const Handle(StepGeom_HArray1OfTrimmingSelect) & trims) {
  return !trims.IsNull() && std::any_of(trims->begin(), trims->end(), [](const StepGeom_TrimmingSelect& trim) {
    return !trim.CartesianPoint().IsNull();
  });
}

// Open CASCADE says "Parameter n0.2 (vertex_geometry) : ...".
std::string in_words(std::string_view text, Fault kind) {
  const std::size_t open = text.find('('), close = text.find(')', std::min(open, text.size()));
  const std::string member =
      close == std::string_view::npos ? "a value" : "'" + std::string(text.substr(open + 1, close - open - 1)) + "'";
  return member +
         (kind == Fault::reference ? " refers to nothing, or to what it cannot be" : " is not what it must be");
}

}  // namespace

void expect_no_cycle(const Handle(StepData_StepModel) & model) {
  const Contents contents = contents_of(model);
  enum class State { unseen, open, done };
  std::vector<State> states(static_cast<std::size_t>(contents.Extent()) + 1, State::unseen);
  struct Step {
    int product;
    std::size_t next;
  };
  for (int root = 1; root <= contents.Extent(); ++root) {
    std::vector<Step> path;
    if (states[root] == State::unseen) path.push_back({root, 0});
    while (!path.empty()) {
      const int product = path.back().product;
      states[product] = State::open;
      const std::vector<int>& parts = contents(product);
      if (path.back().next == parts.size()) {
        states[product] = State::done;
        path.pop_back();
        continue;
      }
      const int part = parts[path.back().next++];
      if (states[part] == State::open)
        throw std::runtime_error("the assembly " + label_of(model, contents.FindKey(part)) + " contains itself");
      if (states[part] == State::unseen) path.push_back({part, 0});
    }
  }
}

void expect_rigid_places(const Handle(StepData_StepModel) & model) {
  const auto axis = [](bool is_given, const Handle(StepGeom_Direction) & direction, const gp_XYZ& usual) {
    if (!is_given || direction.IsNull() || direction->NbDirectionRatios() != 3) return usual;
    return gp_XYZ(direction->DirectionRatiosValue(1), direction->DirectionRatiosValue(2),
                  direction->DirectionRatiosValue(3));
  };
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto item = Handle(StepRepr_MappedItem)::DownCast(model->Value(i));
    if (item.IsNull() || item->MappingSource().IsNull()) continue;
    const Handle(StepRepr_Representation) placed = item->MappingSource()->MappedRepresentation();
    const auto by = Handle(StepGeom_CartesianTransformationOperator3d)::DownCast(item->MappingTarget());
    if (placed.IsNull() || !placed->IsKind(STANDARD_TYPE(StepShape_ShapeRepresentation))) continue;
    if (item->MappingTarget().IsNull())
      throw std::runtime_error(
          "the mapped item " + label_of(model, item) +
          " is placed by an entity that Open CASCADE does not read, such as an operator of several "
          "types: export the shape as it is, without such a place");
    if (by.IsNull()) continue;
    const bool is_mirrored = axis(by->HasAxis1(), by->Axis1(), {1, 0, 0})
                                 .Crossed(axis(by->HasAxis2(), by->Axis2(), {0, 1, 0}))
                                 .Dot(axis(by->HasAxis3(), by->Axis3(), {0, 0, 1})) < 0;
    const bool is_scaled = by->HasScale() && std::abs(by->Scale() - 1) > Precision::Confusion();
    if (is_mirrored || is_scaled)
      throw std::runtime_error("the mapped item " + label_of(model, item) + (is_scaled ? " scales" : " mirrors") +
                               " the shape that it places, which Open CASCADE does not: export the shape as it is, "
                               "without such a place");
  }
}

std::string trim_parabolas_by_points(const Handle(StepData_StepModel) & model) {
  std::size_t count = 0;
  std::string first;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto curve = Handle(StepGeom_TrimmedCurve)::DownCast(model->Value(i));
    if (curve.IsNull() || curve->BasisCurve().IsNull()) continue;
    if (!curve->BasisCurve()->IsKind(STANDARD_TYPE(StepGeom_Parabola))) continue;
    if (has_point(curve->Trim1()) && has_point(curve->Trim2()))
      curve->SetMasterRepresentation(StepGeom_tpCartesian);
    else if (count++ == 0)
      first = label_of(model, curve);
  }
  if (count == 0) return {};
  return counted(count, "parabola") + " trimmed by parameters, first " + first +
         ": may end elsewhere, since programs do not agree what these mean; trim by points";
}

std::string faults_of(const Handle(StepData_StepModel) & model, Fault kind) {
  std::size_t count = 0;
  std::string first;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Interface_Check)& check = model->Check(i, true);
    if (check.IsNull() || !check->HasFailed() || !is_shape(model->Value(i))) continue;
    bool is_reference = false;
    for (int fail = 1; fail <= check->NbFails(); ++fail)
      is_reference = is_reference || std::string_view(check->CFail(fail)).find("Entity") != std::string_view::npos;
    if (is_reference != (kind == Fault::reference)) continue;
    if (count++ == 0) first = label_of(model, model->Value(i)) + ": " + in_words(check->CFail(1), kind);
  }
  if (count == 0) return {};
  return std::to_string(count) + (count == 1 ? " entity is wrong: " : " entities are wrong, first ") + first;
}

std::vector<std::string> without_foreign_files(STEPControl_Reader& reader, const std::string& path) {
  std::vector<std::string> notes;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  constexpr int max_names = 4;  // number of names that one reference may have in different entities
  for (int round = 0; round <= max_names; ++round) {
    bool is_clean = true;
    for (const std::string& name : referred_files(reader)) {
      if (!leaves_folder(name) && std::filesystem::exists(folder / name)) continue;
      is_clean = false;
      notes.push_back("the file refers to '" + name + "', which is " +
                      (leaves_folder(name) ? "outside its folder: not read" : "not in its folder"));
      forget(reader.StepModel(), name);
    }
    if (is_clean) return notes;
  }
  throw std::runtime_error("refers to other files in a way that cannot be undone: " + notes.back());
}

}  // namespace occt
