// SPDX-License-Identifier: Apache-2.0
// Memory of the program epura-importer: where there is none, the process ends, which is told. The libraries of
// importers may go on instead: Open CASCADE leaves out the face for which it had no memory, and some of its algorithms
// say nothing.
#include "importer/memory.hpp"

#include <dlfcn.h>
#include <malloc.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

#include "foreign/child_process.hpp"

#ifndef EPURA_FOREIGN_MEMORY
namespace {

// Those of the C library, or of one that is loaded before it. A function-local static with a guard would be too much
// here: the first caller is the loader. Threads that look for one at the same time find the same.
template <class Function>
Function* next(std::atomic<void*>& known, const char* name) {
  void* function = known.load(std::memory_order_relaxed);
  if (function == nullptr) {
    function = ::dlsym(RTLD_NEXT, name);
    known.store(function, std::memory_order_relaxed);
  }
  return reinterpret_cast<Function*>(function);
}

using OfSize = void*(std::size_t);
using OfTwo = void*(std::size_t, std::size_t);
std::atomic<void*> next_malloc, next_calloc, next_realloc, next_aligned_alloc, next_memalign, next_posix_memalign;

[[noreturn]] void end() { ::_exit(epura::foreign::no_memory_status); }

void* or_end(void* memory, std::size_t size) {
  if (memory == nullptr && size > 0) end();
  return memory;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) noexcept { return or_end(next<OfSize>(next_malloc, "malloc")(size), size); }
void* calloc(std::size_t count, std::size_t size) noexcept {
  return or_end(next<OfTwo>(next_calloc, "calloc")(count, size), count > 0 ? size : 0);
}
void* realloc(void* old, std::size_t size) noexcept {
  return or_end(next<void*(void*, std::size_t)>(next_realloc, "realloc")(old, size), size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return or_end(next<OfTwo>(next_aligned_alloc, "aligned_alloc")(alignment, size), size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return or_end(next<OfTwo>(next_memalign, "memalign")(alignment, size), size);
}
int posix_memalign(void** place, std::size_t alignment, std::size_t size) noexcept {
  const int failure =
      next<int(void**, std::size_t, std::size_t)>(next_posix_memalign, "posix_memalign")(place, alignment, size);
  if (failure == ENOMEM) end();
  return failure;
}
}
#endif
