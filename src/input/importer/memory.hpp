// SPDX-License-Identifier: Apache-2.0
// Whether the process of importers has the allocator of importer/memory.cpp, and bounds of memory: sanitizers have
// allocators of their own, and reserve far more than they use.
#pragma once

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define EPURA_FOREIGN_MEMORY
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define EPURA_FOREIGN_MEMORY
#endif

namespace epura::importer {

#ifdef EPURA_FOREIGN_MEMORY
inline constexpr bool has_own_memory = false;
#else
inline constexpr bool has_own_memory = true;
#endif

}  // namespace epura::importer
