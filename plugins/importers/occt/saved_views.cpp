// SPDX-License-Identifier: Apache-2.0
#include "saved_views.hpp"

#include <StepData_StepModel.hxx>
#include <StepGeom_Plane.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_CameraModelD3.hxx>
#include <StepVisual_CameraModelD3MultiClipping.hxx>
#include <StepVisual_CameraModelD3MultiClippingInterectionSelect.hxx>
#include <StepVisual_HArray1OfCameraModelD3MultiClippingInterectionSelect.hxx>
#include <StepVisual_ViewVolume.hxx>
#include <TCollection_HAsciiString.hxx>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "measures.hpp"
#include "placements.hpp"

namespace occt {

namespace {

// The view plane is in front of the viewer: programs let the axis look at the model, or at the viewer.
std::optional<SavedView> view_of(const StepVisual_CameraModelD3& camera, double unit) {
  const auto axes = axes_of(camera.ViewReferenceSystem());
  const Handle(StepVisual_ViewVolume) volume = camera.PerspectiveOfVolume();
  if (!axes || volume.IsNull()) return std::nullopt;
  const bool looks_along_axis = volume->ViewPlaneDistance() >= 0;
  const gp_Dir towards = looks_along_axis ? axes->Direction().Reversed() : axes->Direction();
  const gp_XYZ place = triple(volume->ProjectionPoint()).value_or(gp_XYZ(0, 0, 0));
  const gp_XYZ eye = axes->Location().XYZ() + place.X() * axes->XDirection().XYZ() +
                     place.Y() * axes->YDirection().XYZ() + place.Z() * axes->Direction().XYZ();
  const Handle(TCollection_HAsciiString) name = camera.Name();
  return SavedView{volume->ProjectionType() == StepVisual_copCentral, name.IsNull() ? "" : name->ToCString(),
                   gp_Pnt(eye * unit), towards, axes->YDirection()};
}

void add_planes(StepVisual_CameraModelD3MultiClipping& camera, double unit, SavedView& view) {
  const auto list = camera.ShapeClipping();
  for (int i = 1; !list.IsNull() && i <= list->Length(); ++i) {
    const Handle(StepGeom_Plane) plane = list->Value(i).Plane();
    const auto axes = plane.IsNull() ? std::nullopt : axes_of(plane->Position());
    if (!axes) continue;
    const gp_XYZ at = axes->Location().XYZ() * unit;
    const gp_Dir& normal = axes->Direction();
    view.planes.push_back({at.X(), at.Y(), at.Z(), normal.X(), normal.Y(), normal.Z()});
  }
}

void name_apart(SavedView& view, const std::vector<SavedView>& others) {
  const std::string name = view.name.empty() ? "view" : view.name;
  const auto is_taken = [&] {
    return std::any_of(others.begin(), others.end(), [&](const SavedView& other) { return other.name == view.name; });
  };
  for (std::size_t number = others.size() + 1; view.name.empty() || is_taken(); ++number)
    view.name = name + " " + std::to_string(number);
}

}  // namespace

std::vector<SavedView> saved_views_of(const STEPControl_Reader& reader, std::string_view text,
                                      std::vector<std::string>& notes) {
  const Handle(StepData_StepModel) model = reader.StepModel();
  std::optional<double> unit;
  std::vector<SavedView> views;
  std::size_t lost = 0;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto camera = Handle(StepVisual_CameraModelD3)::DownCast(model->Value(i));
    if (camera.IsNull()) continue;
    if (!unit) unit = length_unit_in(StepGraph(text));
    std::optional<SavedView> view = view_of(*camera, *unit);
    if (!view) {
      ++lost;
      continue;
    }
    if (const auto clipping = Handle(StepVisual_CameraModelD3MultiClipping)::DownCast(camera); !clipping.IsNull())
      add_planes(*clipping, *unit, *view);
    name_apart(*view, views);
    views.push_back(std::move(*view));
  }
  if (lost > 0) notes.push_back(counted(lost, "saved view") + " without a camera that can be placed: not read");
  return views;
}

}  // namespace occt
