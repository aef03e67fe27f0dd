// SPDX-License-Identifier: Apache-2.0
// Shapes of Open CASCADE that a program holds in memory, by their addresses.
#include <dlfcn.h>
#include <epura/importer_abi.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Standard_Version.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <array>
#include <cstdint>

#include "support.hpp"

namespace epura::test::address_test {
namespace {

using HandOver = const char* (*)(const void*, const epura_source*, const epura_sink*);

HandOver hand_over() {
  const std::string file = std::string(EPURA_TEST_IMPORTERS) + "/opencascade.so";
  return reinterpret_cast<HandOver>(dlsym(dlopen(file.c_str(), RTLD_NOW), "epura_opencascade_shape_v1"));
}

struct Counts {
  int faces = 0, edges = 0;
};

// What the importer tells of the shape at an address, or why it refuses.
std::string told(const void* address, Counts& counts) {
  const std::array<double, 3> values{0, 20, 0};
  const epura_source source{sizeof source, 1, nullptr, values.data(), 0.01, 0, 0, 0};
  epura_sink sink{};
  sink.size = sizeof sink;
  sink.host = &counts;
  sink.unit = [](void*, double) { return 0; };
  sink.up = [](void*, char) { return 0; };
  sink.shape = sink.body = sink.note = [](void*, const char*) { return 0; };
  sink.points = [](void*, std::uint64_t, const double*) { return 0; };
  sink.face = [](void* host, const epura_face*) { return ++static_cast<Counts*>(host)->faces, 0; };
  sink.polygons = [](void*, std::uint64_t, const std::uint64_t*, const std::uint32_t*) { return 0; };
  sink.edge = [](void* host, const epura_edge*) { return ++static_cast<Counts*>(host)->edges, 0; };
  sink.node = [](void*, const epura_node*) { return 0; };
  sink.progress = [](void*, double) { return 0; };
  sink.rounding = [](void*, std::uint32_t) { return 0; };
  sink.colour = [](void*, double, double, double) { return 0; };
  sink.step = [](void*, double) { return 0; };
  sink.requirement = [](void*, const epura_requirement*) { return 0; };
  sink.saved_view = [](void*, const epura_saved_view*) { return 0; };
  const char* wrong = hand_over()(address, &source, &sink);
  return wrong == nullptr ? std::string() : wrong;
}

std::string refusal_of_address(const void* address) {
  Counts counts;
  const std::string reason = told(address, counts);
  EXPECT_EQ(counts.faces + counts.edges, 0);
  return reason;
}

TEST(ShapeAtAddress, HasItsFacesAndEdgesAndStaysAsItIs) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  Counts counts;
  EXPECT_EQ(told(&box, counts), "");
  EXPECT_EQ(counts.faces, 6);
  EXPECT_EQ(counts.edges, 12);
  EXPECT_FALSE(BRepTools::Triangulation(box, 1)) << "facets are those of a copy";
  TopoDS_Compound all;
  BRep_Builder().MakeCompound(all);
  BRep_Builder().Add(all, box);
  BRep_Builder().Add(all, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(9, 0, 0), gp_Dir(0, 0, 1)), 1, 2).Shape());
  Counts more;
  EXPECT_EQ(told(&all, more), "");
  EXPECT_EQ(more.faces, 9);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(box, TopAbs_FACE, faces);
  Counts one;
  EXPECT_EQ(told(&faces(1), one), "");
  EXPECT_EQ(one.faces, 1);
}

TEST(ShapeAtAddress, IsRefusedIfItIsNone) {
  EXPECT_EQ(refusal_of_address(nullptr), "the address is null");
  const TopoDS_Shape empty;
  EXPECT_EQ(refusal_of_address(&empty), "the shape at this address is empty");
  const std::string nothing = "there is no shape at this address";
  for (const std::uintptr_t number : {std::uintptr_t{1}, std::uintptr_t{64}, ~std::uintptr_t{7}, ~std::uintptr_t{0}})
    EXPECT_EQ(refusal_of_address(reinterpret_cast<const void*>(number)), nothing) << number;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  EXPECT_EQ(refusal_of_address(reinterpret_cast<const char*>(&box) + 4), nothing);
  EXPECT_EQ(refusal_of_address(box.TShape().get()), nothing) << "what shapes share is no shape";
  const std::array<std::uint64_t, 3> numbers{16, 16, 16};
  EXPECT_EQ(refusal_of_address(numbers.data()), nothing);
}

TEST(ShapeAtAddress, OfAnotherLibraryIsRefusedByName) {
  const void* shape = dlsym(dlopen(EPURA_TEST_FOREIGN_SHAPE, RTLD_NOW), "foreign_shape");
  ASSERT_NE(shape, nullptr);
  EXPECT_EQ(
      refusal_of_address(shape),
      "the shape is one of libTKBRep-other.so, and only those of the library of Open CASCADE " OCC_VERSION_COMPLETE
      " on this machine can be taken by address: hand over its BREP text");
}

}  // namespace
}  // namespace epura::test::address_test
