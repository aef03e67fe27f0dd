// SPDX-License-Identifier: Apache-2.0
#include "model_file.hpp"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>

namespace epura_occt {

namespace {

constexpr int most_places = 3;

ModelFile new_document() {
  ModelFile file;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", file.document);
  file.shapes = XCAFDoc_DocumentTool::ShapeTool(file.document->Main());
  return file;
}

void use_millimetres() { Interface_Static::SetCVal("xstep.cascade.unit", "MM"); }

void note_unit(ModelFile& file, std::string unit) {
  std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::tolower(c); });
  if (!unit.empty() && unit != "mm" && unit.find("milli") == std::string::npos)
    file.notes.push_back("the unit of the file is " + unit + ": converted to mm");
}

std::string end_of(const std::string& path, std::streamoff bytes) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  file.seekg(std::max<std::streamoff>(size - bytes, 0));
  std::string text(static_cast<std::size_t>(std::min(size, bytes)), 0);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  return text;
}

std::string start_of(const std::string& path, std::streamsize bytes) {
  std::ifstream file(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(bytes), 0);
  file.read(text.data(), bytes);
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

// What failed on the way from the file's entities to shapes, and the first places.
std::vector<std::string> faults_of(const Handle(XSControl_WorkSession) & session) {
  std::vector<std::string> faults;
  int count = 0;
  std::string first;
  Interface_CheckIterator checks = session->TransferReader()->LastCheckList();
  for (checks.Start(); checks.More(); checks.Next()) {
    if (!checks.Value()->HasFailed() || count++ >= most_places) continue;
    first += (first.empty() ? "#" : ", #") + std::to_string(checks.Number()) + " (" + checks.Value()->CFail(1) + ")";
  }
  if (count > 0)
    faults.push_back(std::to_string(count) + (count == 1 ? " entity" : " entities") + " could not be read: " + first);
  return faults;
}

void expect_read(IFSelect_ReturnStatus status, const std::string& format) {
  if (status == IFSelect_RetDone) return;
  throw std::runtime_error(status == IFSelect_RetVoid
                               ? "holds nothing"
                               : "cannot be read as " + format + ": it is damaged or something else");
}

void expect_shapes(const ModelFile& file) {
  TDF_LabelSequence roots;
  file.shapes->GetFreeShapes(roots);
  if (roots.IsEmpty()) throw std::runtime_error("holds no shapes");
}

}  // namespace

ModelFile read_step(const std::string& path, Watch& watch) {
  if (start_of(path, 4096).find("ISO-10303-21") == std::string::npos)
    throw std::runtime_error("is not a STEP file: it does not begin with ISO-10303-21");
  if (end_of(path, 4096).find("END-ISO-10303-21") == std::string::npos)
    throw std::runtime_error("is cut short: it does not end with END-ISO-10303-21");
  use_millimetres();
  ModelFile file = new_document();
  STEPCAFControl_Reader reader;
  reader.SetNameMode(Standard_True);
  reader.SetColorMode(Standard_False);
  reader.SetLayerMode(Standard_False);
  reader.SetPropsMode(Standard_False);
  expect_read(reader.ReadFile(path.c_str()), "STEP");
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
  if (!lengths.IsEmpty()) note_unit(file, lengths.First().ToCString());
  reader.Transfer(file.document, watch.begin(0.2, 0.5));
  watch.expect_wanted();
  for (const std::string& fault : faults_of(reader.Reader().WS())) file.notes.push_back(fault);
  expect_shapes(file);
  return file;
}

ModelFile read_iges(const std::string& path, Watch& watch) {
  use_millimetres();
  ModelFile file = new_document();
  IGESCAFControl_Reader reader;
  reader.SetNameMode(Standard_True);
  reader.SetColorMode(Standard_False);
  reader.SetLayerMode(Standard_False);
  expect_read(reader.ReadFile(path.c_str()), "IGES");
  const Handle(TCollection_HAsciiString) unit = reader.IGESModel()->GlobalSection().UnitName();
  if (!unit.IsNull()) note_unit(file, unit->ToCString());
  reader.Transfer(file.document, watch.begin(0.2, 0.5));
  watch.expect_wanted();
  for (const std::string& fault : faults_of(reader.WS())) file.notes.push_back(fault);
  expect_shapes(file);
  return file;
}

ModelFile read_brep(const std::string& path, Watch& watch) {
  ModelFile file = new_document();
  TopoDS_Shape shape;
  BRep_Builder builder;
  if (!BRepTools::Read(shape, path.c_str(), builder, watch.begin(0.2, 0.5)) || shape.IsNull())
    throw std::runtime_error("cannot be read as BREP: it is damaged or something else");
  watch.expect_wanted();
  file.shapes->AddShape(shape, Standard_False);
  return file;
}

}  // namespace epura_occt
