// SPDX-License-Identifier: Apache-2.0
#include "foreign/sandbox.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>

#include "base/descriptor.hpp"
#include "base/error.hpp"

namespace epura::foreign {

namespace {

namespace fs = std::filesystem;

// Newer than the kernel headers of Debian 12.
constexpr std::uint64_t truncate_file = 1U << 14, use_device = 1U << 15;
constexpr std::uint64_t scope_abstract_sockets = 1U << 0, scope_signals = 1U << 1;

/// struct landlock_ruleset_attr of Linux 6.12. Older kernels accept it if what they do not know is zero.
struct Ruleset {
  std::uint64_t files = 0, network = 0, scope = 0;
};

constexpr std::uint64_t read_rights = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t execute_rights = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE;
constexpr std::uint64_t write_rights = read_rights | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                                       LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_DIR |
                                       LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_REFER | truncate_file;
constexpr std::uint64_t rights_of_files = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE |
                                          LANDLOCK_ACCESS_FS_WRITE_FILE | truncate_file | use_device;

/// What libraries of the system read at any time.
constexpr std::array of_system{"/usr",
                               "/lib",
                               "/lib64",
                               "/etc/fonts",
                               "/etc/ld.so.cache",
                               "/etc/localtime",
                               "/proc/self",
                               "/proc/cpuinfo",
                               "/proc/meminfo",
                               "/sys/devices/system/cpu",
                               "/sys/devices/system/node",
                               "/dev/urandom"};

/// Sockets of both ends exist before: those of socketpair() are no way out.
constexpr std::array denied_calls{"socket",
                                  "ptrace",
                                  "process_vm_readv",
                                  "process_vm_writev",
                                  "process_madvise",
                                  "pidfd_getfd",
                                  "mount",
                                  "umount2",
                                  "pivot_root",
                                  "chroot",
                                  "unshare",
                                  "setns",
                                  "fsopen",
                                  "fsmount",
                                  "open_tree",
                                  "move_mount",
                                  "mount_setattr",
                                  "bpf",
                                  "keyctl",
                                  "add_key",
                                  "request_key",
                                  "io_uring_setup",
                                  "io_uring_enter",
                                  "io_uring_register",
                                  "userfaultfd",
                                  "kexec_load",
                                  "kexec_file_load",
                                  "init_module",
                                  "finit_module",
                                  "delete_module",
                                  "open_by_handle_at",
                                  "name_to_handle_at",
                                  "perf_event_open",
                                  "quotactl",
                                  "swapon",
                                  "swapoff",
                                  "reboot"};

/// The version of Landlock; 0 if the kernel has none.
int landlock_version() {
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  return version > 0 ? static_cast<int>(version) : 0;
}

/// All rights that a version knows.
Ruleset known_to(int version) {
  constexpr int with_refer = 2, with_truncate = 3, with_network = 4, with_devices = 5, with_scope = 6;
  Ruleset known{(LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1};
  if (version >= with_refer) known.files |= LANDLOCK_ACCESS_FS_REFER;
  if (version >= with_truncate) known.files |= truncate_file;
  if (version >= with_network) known.network = 3;  // to bind and to connect
  if (version >= with_devices) known.files |= use_device;
  if (version >= with_scope) known.scope = scope_abstract_sockets | scope_signals;
  return known;
}

[[noreturn]] void refuse_to_confine(const std::string& what) {
  throw Error(ErrorKind::plugin, "sandbox", what + ": " + std::strerror(errno), "--sandbox off does without");
}

void allow(const Descriptor& ruleset, const fs::path& path, std::uint64_t rights) {
  const Descriptor file(::open(path.empty() ? "." : path.c_str(), O_PATH | O_CLOEXEC));
  struct stat about {};
  if (file.number() < 0 || ::fstat(file.number(), &about) != 0) return;
  if (!S_ISDIR(about.st_mode)) rights &= rights_of_files;
  const landlock_path_beneath_attr rule{rights, file.number()};
  if (::syscall(SYS_landlock_add_rule, ruleset.number(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0)
    refuse_to_confine(path.string() + " cannot be allowed");
}

void confine_files(const Permissions& permissions, int version) {
  const Ruleset known = known_to(version);
  const Descriptor ruleset(static_cast<int>(::syscall(SYS_landlock_create_ruleset, &known, sizeof known, 0)));
  if (ruleset.number() < 0) refuse_to_confine("cannot be made");
  for (const char* path : of_system) allow(ruleset, path, read_rights);
  allow(ruleset, "/dev/null", (read_rights | LANDLOCK_ACCESS_FS_WRITE_FILE) & known.files);
  for (const fs::path& path : permissions.readable) allow(ruleset, path, read_rights);
  for (const fs::path& path : permissions.writable) allow(ruleset, path, write_rights & known.files);
  for (const fs::path& path : permissions.executable) allow(ruleset, path, execute_rights);
  if (::syscall(SYS_landlock_restrict_self, ruleset.number(), 0) != 0) refuse_to_confine("cannot be entered");
}

void deny_calls() {
  struct Release {
    void operator()(void* filter) const { ::seccomp_release(filter); }
  };
  const std::unique_ptr<void, Release> filter(::seccomp_init(SCMP_ACT_ALLOW));
  if (!filter) return;
  for (const char* name : denied_calls) {
    const int call = ::seccomp_syscall_resolve_name(name);
    if (call != __NR_SCMP_ERROR) ::seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(EPERM), call, 0);
  }
  ::seccomp_load(filter.get());
}

}  // namespace

std::string reason_for_no_sandbox() {
  return landlock_version() > 0 ? "" : "the kernel has no Landlock (Linux 5.13), or it is switched off";
}

void enter_sandbox(const Permissions& permissions) {
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) refuse_to_confine("cannot be entered");
  if (const int version = landlock_version(); version > 0) confine_files(permissions, version);
  deny_calls();
}

}  // namespace epura::foreign
