// SPDX-License-Identifier: Apache-2.0
// No process is started: calls of the library that would start one end here, whatever a test of this program draws.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <utility>

namespace {

std::atomic<int> started = 0;

int refused() {
  ++started;
  return errno = EPERM;
}

class NoProcesses : public testing::Environment {
  void TearDown() override { EXPECT_EQ(started, 0); }
};

[[maybe_unused]] const testing::Environment* const added = testing::AddGlobalTestEnvironment(new NoProcesses);

}  // namespace

extern "C" {

pid_t fork() noexcept { return -refused(); }
pid_t vfork() noexcept { return -refused(); }
int execve(const char*, char* const*, char* const*) noexcept { return -refused(); }
int posix_spawn(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*, char* const*,
                char* const*) {
  return refused();
}
int posix_spawnp(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*, char* const*,
                 char* const*) {
  return refused();
}

}  // extern "C"

namespace epura::test::process_test {
namespace {

// What the library would call: the dynamic linker finds these before those of the C library, if it has to.
TEST(HlrLibrary, WouldStartProcessesHere) {
  for (const auto& [name, here] : {std::pair(std::string("fork"), reinterpret_cast<void*>(&::fork)),
                                   std::pair(std::string("posix_spawn"), reinterpret_cast<void*>(&::posix_spawn))})
    EXPECT_EQ(dlsym(RTLD_DEFAULT, name.c_str()), here) << name;
}

}  // namespace
}  // namespace epura::test::process_test
