// SPDX-License-Identifier: Apache-2.0
// Takes from this process whatever it does not need, before it reads what a stranger wrote: with Landlock (Linux 5.13)
// it opens only files that are named here, with seccomp it has no network and cannot look into other processes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace epura::foreign {

/// What a process may still open. Folders include all that lies below them; what does not exist is left out.
struct Permissions {
  std::vector<std::filesystem::path> readable;
  std::vector<std::filesystem::path> writable;  ///< and readable
  std::vector<std::filesystem::path> executable;
};

/// Returns why this computer cannot confine a process; empty if it can.
std::string reason_for_no_sandbox();

/// Confines this thread, those that it starts, and the processes that these start, for as long as they run: so it is
/// called before the first thread. The system's libraries, its time zone and its fonts' settings remain readable; files
/// that are open remain open. Can be called again, which only takes more. Does what the kernel offers. Throws
/// Error{plugin} if the kernel offers it and fails.
void enter_sandbox(const Permissions& permissions);

}  // namespace epura::foreign
