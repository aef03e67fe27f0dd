// SPDX-License-Identifier: Apache-2.0
#include "model.hpp"

#include <Common/NMR_ErrorConst.h>
#include <Model/COM/NMR_DLLInterfaces.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace epura::plugin::threemf {

namespace {

/// Owns an object of lib3mf.
class Handle {
 public:
  Handle() = default;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (handle_ != nullptr) NMR::lib3mf_release(handle_);
  }
  [[nodiscard]] NMR::PLib3MFBase* get() const { return handle_; }
  /// For functions that return a handle.
  NMR::PLib3MFBase** out() { return &handle_; }

 private:
  NMR::PLib3MFBase* handle_ = nullptr;
};

void expect(int result, const char* what) {
  if (result != LIB3MF_OK) throw std::runtime_error(std::string("holds ") + what + " that cannot be read");
}

// lib3mf keeps 32 bits. The shortest number that rounds to them is the one in the file, as long as that has at most six
// digits.
double as_written(float value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double number = value;
  std::from_chars(text.data(), end, number);
  return number;
}

Transform transform_of(const NMR::MODELTRANSFORM& matrix) {
  Transform transform{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      transform[4 * row + column] = as_written(matrix.m_fFields[row][column]);
  if (!std::all_of(transform.begin(), transform.end(), [](double v) { return std::isfinite(v); }))
    throw std::runtime_error("holds a transform that is not finite");
  return transform;
}

/// Calls a function that fills a buffer with a text and its terminator.
template <class Fill>
std::string text_by(const Fill& fill) {
  std::uint32_t count = 0;
  if (fill(nullptr, 0, &count) != LIB3MF_OK || count == 0) return {};
  std::string text(count + 1, 0);
  if (fill(text.data(), static_cast<std::uint32_t>(text.size()), &count) != LIB3MF_OK) return {};
  text.resize(std::strlen(text.c_str()));
  return text;
}

std::string name_of(NMR::PLib3MFBase* object) {
  const std::string name = text_by([&](char* buffer, std::uint32_t size, std::uint32_t* count) {
    return NMR::lib3mf_object_getnameutf8(object, buffer, size, count);
  });
  if (!name.empty()) return name;
  return text_by([&](char* buffer, std::uint32_t size, std::uint32_t* count) {
    return NMR::lib3mf_object_getpartnumberutf8(object, buffer, size, count);
  });
}

double millimetres_of(NMR::PLib3MFBase* model) {
  std::uint32_t unit = 0;
  expect(NMR::lib3mf_model_getunit(model, &unit), "a unit");
  switch (unit) {
    case NMR::MODELUNIT_MICROMETER:
      return 0.001;
    case NMR::MODELUNIT_MILLIMETER:
      return 1;
    case NMR::MODELUNIT_CENTIMETER:
      return 10;
    case NMR::MODELUNIT_INCH:
      return 25.4;
    case NMR::MODELUNIT_FOOT:
      return 304.8;
    case NMR::MODELUNIT_METER:
      return 1000;
    default:
      throw std::runtime_error("is in an unknown unit");
  }
}

void read_mesh(NMR::PLib3MFBase* mesh, Object& object) {
  std::uint32_t points = 0, triangles = 0, beams = 0, slices = 0;
  expect(NMR::lib3mf_meshobject_getvertexcount(mesh, &points), "points");
  expect(NMR::lib3mf_meshobject_gettrianglecount(mesh, &triangles), "triangles");
  std::vector<NMR::MODELMESHVERTEX> vertices(points);
  std::vector<NMR::MODELMESHTRIANGLE> corners(triangles);
  if (points > 0) expect(NMR::lib3mf_meshobject_getvertices(mesh, vertices.data(), points, nullptr), "points");
  if (triangles > 0)
    expect(NMR::lib3mf_meshobject_gettriangleindices(mesh, corners.data(), triangles, nullptr), "triangles");
  for (const NMR::MODELMESHVERTEX& v : vertices) {
    const auto& p = v.m_fPosition;
    object.points.push_back({as_written(p[0]), as_written(p[1]), as_written(p[2])});
    for (const double coordinate : object.points.back())
      if (!std::isfinite(coordinate)) throw std::runtime_error("holds a point that is not finite");
  }
  for (const NMR::MODELMESHTRIANGLE& t : corners) {
    object.triangles.push_back({t.m_nIndices[0], t.m_nIndices[1], t.m_nIndices[2]});
    for (const std::uint32_t corner : object.triangles.back())
      if (corner >= points) throw std::runtime_error("holds a triangle with a corner that is no point");
  }
  if (NMR::lib3mf_meshobject_getbeamcount(mesh, &beams) == LIB3MF_OK) object.beams = beams;
  if (NMR::lib3mf_meshobject_getslicestackid(mesh, &slices) == LIB3MF_OK) object.has_slices = slices != 0;
}

// That of the object as a whole; those of single triangles are not read.
std::optional<std::array<double, 3>> colour_of(NMR::PLib3MFBase* source, NMR::PLib3MFBase* object) {
  Handle property, materials;
  NMR::eModelPropertyType type{};
  if (NMR::lib3mf_object_createdefaultpropertyhandler(object, property.out()) != LIB3MF_OK ||
      NMR::lib3mf_defaultpropertyhandler_getpropertytype(property.get(), &type) != LIB3MF_OK)
    return std::nullopt;
  NMR::MODELMESHCOLOR_SRGB found{};
  if (type == NMR::MODELPROPERTYTYPE_COLOR) {
    if (NMR::lib3mf_defaultpropertyhandler_getcolor(property.get(), 0, &found) != LIB3MF_OK) return std::nullopt;
  } else if (type == NMR::MODELPROPERTYTYPE_BASEMATERIALS) {
    std::uint32_t group = 0, index = 0;
    if (NMR::lib3mf_defaultpropertyhandler_getbasematerial(property.get(), &group, &index) != LIB3MF_OK ||
        NMR::lib3mf_model_getbasematerialbyid(source, group, materials.out()) != LIB3MF_OK ||
        NMR::lib3mf_basematerial_getdisplaycolor(materials.get(), index, &found.m_Red, &found.m_Green, &found.m_Blue,
                                                 &found.m_Alpha) != LIB3MF_OK)
      return std::nullopt;
  } else {
    return std::nullopt;
  }
  return std::array<double, 3>{found.m_Red / 255.0, found.m_Green / 255.0, found.m_Blue / 255.0};
}

void read_components(NMR::PLib3MFBase* components, Object& object) {
  std::uint32_t count = 0;
  expect(NMR::lib3mf_componentsobject_getcomponentcount(components, &count), "components");
  for (std::uint32_t i = 0; i < count; ++i) {
    Handle component;
    std::uint32_t id = 0;
    NMR::MODELTRANSFORM matrix{};
    expect(NMR::lib3mf_componentsobject_getcomponent(components, i, component.out()), "a component");
    expect(NMR::lib3mf_component_getobjectresourceid(component.get(), &id), "a component");
    expect(NMR::lib3mf_component_gettransform(component.get(), &matrix), "a transform");
    object.components.push_back({id, transform_of(matrix)});
  }
}

void read_objects(NMR::PLib3MFBase* source, Model& model) {
  Handle objects;
  expect(NMR::lib3mf_model_getobjects(source, objects.out()), "objects");
  int has_next = 0;
  while (NMR::lib3mf_resourceiterator_movenext(objects.get(), &has_next) == LIB3MF_OK && has_next != 0) {
    Handle found;
    std::uint32_t id = 0;
    int is_mesh = 0;
    expect(NMR::lib3mf_resourceiterator_getcurrent(objects.get(), found.out()), "an object");
    expect(NMR::lib3mf_resource_getresourceid(found.get(), &id), "an object");
    expect(NMR::lib3mf_object_ismeshobject(found.get(), &is_mesh), "an object");
    Object& object = model.objects[id];
    object.name = name_of(found.get());
    object.colour = colour_of(source, found.get());
    if (is_mesh != 0)
      read_mesh(found.get(), object);
    else
      read_components(found.get(), object);
  }
}

void read_items(NMR::PLib3MFBase* source, Model& model) {
  Handle items;
  expect(NMR::lib3mf_model_getbuilditems(source, items.out()), "items");
  int has_next = 0;
  while (NMR::lib3mf_builditemiterator_movenext(items.get(), &has_next) == LIB3MF_OK && has_next != 0) {
    Handle item;
    std::uint32_t id = 0;
    NMR::MODELTRANSFORM matrix{};
    expect(NMR::lib3mf_builditemiterator_getcurrent(items.get(), item.out()), "an item");
    expect(NMR::lib3mf_builditem_getobjectresourceid(item.get(), &id), "an item");
    expect(NMR::lib3mf_builditem_getobjecttransform(item.get(), &matrix), "a transform");
    model.items.push_back(
        {id, transform_of(matrix), text_by([&](char* buffer, std::uint32_t size, std::uint32_t* count) {
           return NMR::lib3mf_builditem_getpartnumberutf8(item.get(), buffer, size, count);
         })});
  }
}

// Missing or repeated identities of the production extension do not change anything that is drawn.
bool is_of_identities(std::uint32_t code) {
  return code == NMR_ERROR_MISSINGUUID || code == NMR_ERROR_UUID_NOT_UNIQUE || code == NMR_ERROR_DUPLICATEUUID ||
         code == NMR_ERROR_ILLFORMATUUID;
}

std::vector<std::string> warnings_of(NMR::PLib3MFBase* reader) {
  std::uint32_t count = 0;
  std::vector<std::string> warnings;
  if (NMR::lib3mf_reader_getwarningcount(reader, &count) != LIB3MF_OK) return warnings;
  constexpr std::uint32_t most = 1000;
  for (std::uint32_t i = 0; i < std::min(count, most); ++i) {
    std::uint32_t code = 0;
    const std::string text = text_by([&](char* buffer, std::uint32_t size, std::uint32_t* written) {
      return NMR::lib3mf_reader_getwarningutf8(reader, i, &code, buffer, size, written);
    });
    if (is_of_identities(code) || text.empty()) continue;
    if (std::find(warnings.begin(), warnings.end(), text) == warnings.end()) warnings.push_back(text);
  }
  return warnings;
}

std::string sentence_of(std::uint32_t code, const char* text) {
  switch (code) {
    case NMR_ERROR_COULDNOTCREATEOPCPART:
      return "a part of the package that it refers to is missing";
    case NMR_ERROR_COULDNOTFINDCOMPONENTOBJECT:
      return "a component is of an object that does not stand before it";
    case NMR_ERROR_COULDNOTFINDBUILDITEMOBJECT:
      return "an object that is to be built is missing";
    case NMR_ERROR_INVALIDMODELNODEINDEX:
      return "a triangle has a corner that is no vertex";
    case NMR_ERROR_INVALIDMODELCOORDINATES:
      return "a vertex has a coordinate that is no number, or is too large";
    default:
      return text == nullptr || *text == 0 ? "error " + std::to_string(code) + " of lib3mf" : text;
  }
}

[[noreturn]] void throw_error_of(NMR::PLib3MFBase* reader) {
  std::uint32_t code = 0;
  const char* text = nullptr;
  NMR::lib3mf_getlasterror(reader, &code, &text);
  const std::string sentence = "is not a valid 3MF file: " + sentence_of(code, text);
  // The last warning is about the entry that caused the error.
  const std::vector<std::string> warnings = warnings_of(reader);
  throw std::runtime_error(warnings.empty() ? sentence : sentence + " (" + warnings.back() + ")");
}

bool tell(int percent, NMR::ProgressIdentifier, void* goes_on) noexcept {
  try {
    return percent < 0 || (*static_cast<const std::function<bool(double)>*>(goes_on))(percent / 100.0);
  } catch (...) {
    return false;
  }
}

}  // namespace

Model read_model(const std::string& package, const std::function<bool(double)>& goes_on) {
  Handle source, reader;
  expect(NMR::lib3mf_createmodel(source.out()), "a model");
  expect(NMR::lib3mf_model_queryreader(source.get(), MODELREADERCLASS_3MF, reader.out()), "a model");
  std::function<bool(double)> told = goes_on;
  expect(NMR::lib3mf_reader_setprogresscallback(reader.get(), tell, &told), "a model");
  // The bytes are only read.
  auto* bytes = reinterpret_cast<unsigned char*>(const_cast<char*>(package.data()));
  if (NMR::lib3mf_reader_readfrombuffer(reader.get(), bytes, package.size()) != LIB3MF_OK) throw_error_of(reader.get());
  Model model;
  model.millimetres = millimetres_of(source.get());
  read_objects(source.get(), model);
  read_items(source.get(), model);
  model.warnings = warnings_of(reader.get());
  return model;
}

}  // namespace epura::plugin::threemf
