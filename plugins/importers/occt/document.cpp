// SPDX-License-Identifier: Apache-2.0
// The tree of products in an XCAF document, Open CASCADE's model of assemblies.
#include <Quantity_Color.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <array>
#include <string_view>

#include "tree.hpp"

namespace occt {

namespace {

gp_Trsf location_of(const TDF_Label& label) { return XCAFDoc_ShapeTool::GetLocation(label).Transformation(); }

std::optional<Colour> colour_of(const TDF_Label& label) {
  const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(label);
  Quantity_Color found;
  if (!colours->GetColor(label, XCAFDoc_ColorSurf, found) && !colours->GetColor(label, XCAFDoc_ColorGen, found))
    return std::nullopt;
  Colour colour{};
  found.Values(colour[0], colour[1], colour[2], Quantity_TOC_sRGB);
  for (double& part : colour) part = std::clamp(part, 0.0, 1.0);
  return colour;
}

/// Whether nothing below the label has a name.
bool is_nameless(const TDF_Label& label) {
  TDF_LabelSequence components;
  XCAFDoc_ShapeTool::GetComponents(label, components);
  for (const TDF_Label& component : components) {
    TDF_Label referred;
    if (!XCAFDoc_ShapeTool::GetReferredShape(component, referred)) continue;
    if (!name_of(component).empty() || !name_of(referred).empty() || !is_nameless(referred)) return false;
  }
  return true;
}

/// An assembly in an assembly whose components have no names of their own is one part to people: an electronic
/// component of solids that are all called SOLID. So is the whole file if it holds one component alone.
bool is_one_part(const TDF_Label& label, bool is_root) {
  TDF_LabelSequence components;
  XCAFDoc_ShapeTool::GetComponents(label, components);
  return !name_of(label).empty() && (!is_root || components.Length() == 1) && is_nameless(label);
}

void add(const TDF_Label& label, Place place, TreeBuilder& tree, const Company& company = {}) {
  const std::string product = name_of(label);
  if (place.name.empty()) place.name = product;
  if (!XCAFDoc_ShapeTool::IsAssembly(label) || is_one_part(label, place.parent == EPURA_NONE)) {
    tree.add(XCAFDoc_ShapeTool::GetShape(label), product, std::move(place), company);
    return;
  }
  if (!place.colour) place.colour = colour_of(label);
  const std::uint32_t assembly = tree.add_assembly(std::move(place));
  const Company own = company_in(XCAFDoc_ShapeTool::GetShape(label));
  TDF_LabelSequence components;
  XCAFDoc_ShapeTool::GetComponents(label, components);
  for (const TDF_Label& component : components) {
    TDF_Label referred;
    if (!XCAFDoc_ShapeTool::GetReferredShape(component, referred)) continue;
    add(referred, {name_of(component), assembly, EPURA_NONE, location_of(component), colour_of(component)}, tree,
        tree.is_product(XCAFDoc_ShapeTool::GetShape(referred)) ? Company{} : own);
  }
}

bool is_digit(char c) { return '0' <= c && c <= '9'; }

}  // namespace

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  // The constructor writes UTF-8 if it gets no replacement for characters beyond ASCII.
  return meaningful(TCollection_AsciiString(name->Get()).ToCString());
}

std::string meaningful(const std::string& name) {
  const auto first = name.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  const std::string trimmed = name.substr(first, name.find_last_not_of(" \t") + 1 - first);
  const std::string_view view = trimmed;
  constexpr std::array<std::string_view, 12> made_up{"SOLID", "COMPOUND", "SHELL", "FACE",    "COMPSOLID", "WIRE",
                                                     "EDGE",  "ASSEMBLY", "NONE",  "UNNAMED", "none",      "NULL"};
  if (std::find(made_up.begin(), made_up.end(), view) != made_up.end()) return {};
  // Labels of XCAF, and Open CASCADE's names for products without a name.
  for (const std::string_view start : {std::string_view("=>["), std::string_view("Open CASCADE STEP translator")})
    if (view.substr(0, start.size()) == start) return {};
  std::string_view number = view;
  if (number.substr(0, 4) == "NAUO") number.remove_prefix(4);
  if (std::all_of(number.begin(), number.end(), is_digit)) return {};
  return trimmed;
}

void add_document(const Handle(TDocStd_Document) & document, TreeBuilder& tree) {
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  TDF_LabelSequence roots;
  shapes->GetFreeShapes(roots);
  for (const TDF_Label& root : roots) {
    TDF_Label referred;
    if (XCAFDoc_ShapeTool::GetReferredShape(root, referred)) {
      add(referred, {name_of(root), EPURA_NONE, EPURA_NONE, location_of(root), colour_of(root)}, tree);
    } else {
      add(root, {{}, EPURA_NONE, EPURA_NONE, gp_Trsf()}, tree);
    }
  }
}

Colours colours_of(const Handle(TDocStd_Document) & document) {
  Colours colours;
  const auto keep = [&](const TDF_Label& label) {
    const std::optional<Colour> colour = colour_of(label);
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    if (colour && !shape.IsNull()) colours.Bind(shape.Located(TopLoc_Location()), *colour);
  };
  TDF_LabelSequence products;
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetShapes(products);
  for (const TDF_Label& product : products) {
    keep(product);
    TDF_LabelSequence parts;
    XCAFDoc_ShapeTool::GetSubShapes(product, parts);
    for (const TDF_Label& part : parts) keep(part);
  }
  return colours;
}

}  // namespace occt
