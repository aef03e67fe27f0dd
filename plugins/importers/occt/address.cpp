// SPDX-License-Identifier: Apache-2.0
// Every shape points to what it shares with its copies, an object of one of eight classes, which begins with the
// address of the table of virtual functions of its class: that of this process's library, or it is no shape that can be
// read here.
#include "address.hpp"

#include <dlfcn.h>
#include <sys/uio.h>
#include <unistd.h>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TFace.hxx>
#include <BRep_TVertex.hxx>
#include <Standard_Version.hxx>
#include <TopoDS_TCompSolid.hxx>
#include <TopoDS_TCompound.hxx>
#include <TopoDS_TShell.hxx>
#include <TopoDS_TSolid.hxx>
#include <TopoDS_TWire.hxx>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace occt {

namespace {

using Word = std::uintptr_t;

/// The words there, copied by the system, which fails where there is no memory.
template <std::size_t count>
std::array<Word, count> words_at(Word address) {
  std::array<Word, count> words{};
  iovec to{words.data(), sizeof words}, from{reinterpret_cast<void*>(address), sizeof words};
  if (address % alignof(Word) != 0 || process_vm_readv(getpid(), &to, 1, &from, 1, 0) != ssize_t(sizeof words))
    throw std::runtime_error("there is no shape at this address");
  return words;
}

template <class Kind>
Word functions_of() {
  const Handle(Kind) object = new Kind;
  Word functions = 0;
  std::memcpy(&functions, static_cast<const void*>(object.get()), sizeof functions);
  return functions;
}

bool are_of_a_shape(Word functions) {
  const std::array known{functions_of<TopoDS_TCompound>(), functions_of<TopoDS_TCompSolid>(),
                         functions_of<TopoDS_TSolid>(),    functions_of<TopoDS_TShell>(),
                         functions_of<BRep_TFace>(),       functions_of<TopoDS_TWire>(),
                         functions_of<BRep_TEdge>(),       functions_of<BRep_TVertex>()};
  return std::find(known.begin(), known.end(), functions) != known.end();
}

/// The name of the file of the library that holds an address; "" if none does.
std::string library_of(Word address) {
  Dl_info found{};
  if (dladdr(reinterpret_cast<const void*>(address), &found) == 0 || found.dli_fname == nullptr) return {};
  return std::filesystem::path(found.dli_fname).filename().string();
}

[[noreturn]] void refuse(Word functions) {
  const std::string library = library_of(functions);
  if (library.find("TKBRep") == std::string::npos || library == library_of(functions_of<BRep_TFace>()))
    throw std::runtime_error("there is no shape at this address");
  throw std::runtime_error("the shape is one of " + library + ", and only those of the library of Open CASCADE " +
                           OCC_VERSION_COMPLETE + " on this machine can be taken by address: hand over its BREP text");
}

}  // namespace

TopoDS_Shape shape_at(const void* address) {
  if (address == nullptr) throw std::runtime_error("the address is null");
  const Word shared = words_at<1>(reinterpret_cast<Word>(address))[0];
  if (shared == 0) throw std::runtime_error("the shape at this address is empty");
  if (const Word functions = words_at<1>(shared)[0]; !are_of_a_shape(functions)) refuse(functions);
  words_at<(sizeof(TopoDS_Shape) + sizeof(Word) - 1) / sizeof(Word)>(reinterpret_cast<Word>(address));
  return BRepBuilderAPI_Copy(*static_cast<const TopoDS_Shape*>(address), false, false).Shape();
}

}  // namespace occt
