// SPDX-License-Identifier: Apache-2.0
#include "base/file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <span>

#include "base/descriptor.hpp"
#include "base/error.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t max_bytes_of_pipe = 1'000'000'000;
// The number of links that Linux follows.
constexpr int max_links = 40;
constexpr std::size_t max_at_once = 1 << 24;  // bytes to read between two checks of the clock

[[noreturn]] void fail(ErrorKind kind, const fs::path& path, const std::string& action, int number) {
  std::string hint;
  if (number == ENOENT) hint = kind == ErrorKind::input ? "check the path" : "create the folder first";
  if (number == EACCES || number == EROFS) hint = "check the permissions of the file and its folder";
  throw Error(kind, path.string(), "cannot " + action + ": " + std::strerror(number), hint);
}

// Git LFS keeps the contents of such a file elsewhere.
void refuse_pointer(const fs::path& path, std::string_view bytes) {
  if (bytes.starts_with("version https://git-lfs.github.com/spec/"))
    throw Error(ErrorKind::input, path.string(), "is a Git LFS pointer; the file it stands for is missing",
                "run git lfs pull");
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

void write_directly(const fs::path& path, std::string_view bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.number() < 0) fail(ErrorKind::output, path, "write", errno);
  if (!write_all(file.number(), bytes) || !file.close()) fail(ErrorKind::output, path, "write", errno);
}

// Returns the mode of the old file, or the one that any new file would get.
mode_t mode_for(const fs::path& target) {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  struct stat old {};
  return ::stat(target.c_str(), &old) == 0 ? old.st_mode & 0777 : 0666 & ~mask;
}

// Keeps errno.
void remove(const std::string& name) {
  const int number = errno;
  ::unlink(name.c_str());
  errno = number;
}

// Moves a complete file to the target, or removes it.
bool put_in_place(const std::string& name, const fs::path& target) {
  if (::rename(name.c_str(), target.c_str()) == 0) return true;
  remove(name);
  return false;
}

bool give_name(const Descriptor& file, const std::string& name) {
  const std::string self = "/proc/self/fd/" + std::to_string(file.number());
  return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

// Gives a nameless file a name next to the target; returns an empty name if that is impossible.
std::string name_beside(const Descriptor& file, const fs::path& target) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    std::string name = target.string() + "." + std::to_string(::getpid() + attempt);
    if (give_name(file, name)) return name;
    if (errno != EEXIST) break;
  }
  return {};
}

// Uses a nameless file, which vanishes by itself whenever and however the process ends; it has another name than the
// target only while it takes the place of an old file. Returns false if the file system does not support that, or for
// errors that the other method will encounter, too.
bool replace_by_nameless(const fs::path& target, std::string_view bytes, Progress progress) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  Descriptor file(::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600));
  if (file.number() < 0 || !write_all(file.number(), bytes) || ::fchmod(file.number(), mode_for(target)) != 0)
    return false;
  // Closing tells of errors of the disk, which must be known before the file has a name.
  const Descriptor same(::fcntl(file.number(), F_DUPFD_CLOEXEC, 0));
  if (same.number() < 0 || !file.close()) return false;
  const auto lock = progress.undisturbed();
  if (give_name(same, target.string())) return true;
  if (errno != EEXIST) return false;
  const std::string name = name_beside(same, target);
  return !name.empty() && put_in_place(name, target);
}

bool replace_by_named(const fs::path& target, std::string_view bytes, Progress progress) {
  const auto lock = progress.undisturbed();
  std::string name = target.string() + ".XXXXXX";
  Descriptor file(::mkostemp(name.data(), O_CLOEXEC));
  if (file.number() < 0) return false;
  if (write_all(file.number(), bytes) && ::fchmod(file.number(), mode_for(target)) == 0 && file.close())
    return put_in_place(name, target);
  remove(name);
  return false;
}

// Reads from a file that was opened without waiting. Who names a pipe may begin to write a moment later; a pipe to
// which nobody writes would be waited for without end. `has_begun`: an empty answer is the end.
ssize_t read_some(const Descriptor& file, std::span<char> to, bool has_begun, const Progress& progress) {
  constexpr int patience_ms = 5000, look_ms = 20;
  for (int waited_ms = 0; waited_ms < patience_ms; waited_ms += has_begun ? 0 : look_ms) {
    progress.expect_time();
    const ssize_t got = ::read(file.number(), to.data(), std::min(to.size(), max_at_once));
    if (got > 0 || (got == 0 && has_begun) || (got < 0 && errno != EINTR && errno != EAGAIN)) return got;
    has_begun = has_begun || (got < 0 && errno == EAGAIN);  // the writer pauses
    pollfd end{file.number(), POLLIN, 0};
    ::poll(&end, 1, look_ms);
    if ((end.revents & POLLHUP) != 0) has_begun = true;  // the writer has come and gone
  }
  errno = ETIMEDOUT;
  return -1;
}

}  // namespace

fs::path end_of_links(const fs::path& path) {
  fs::path end = path;
  std::error_code error;
  for (int links = 0; links < max_links && fs::is_symlink(end, error); ++links) {
    const fs::path next = fs::read_symlink(end, error);
    if (error) break;
    end = end.parent_path() / next;
  }
  return end;
}

std::string identity_of_file(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0)
    return S_ISREG(status.st_mode) ? std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino) : "";
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(end_of_links(path)), error).string();
}

std::string read_file(const fs::path& path, const Progress& progress, std::uintmax_t max_bytes) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
  if (file.number() < 0) fail(ErrorKind::input, path, "read", errno);
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) fail(ErrorKind::input, path, "read", errno);
  if (S_ISDIR(status.st_mode)) throw Error(ErrorKind::input, path.string(), "is a directory, not a file");
  if (!S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode))
    throw Error(ErrorKind::input, path.string(), "is a device, not a file");
  if (S_ISFIFO(status.st_mode)) max_bytes = std::min(max_bytes, max_bytes_of_pipe);
  const auto expect_at_most = [&](std::uintmax_t size) {
    if (size > max_bytes)
      throw Error(ErrorKind::input, path.string(), "has more than " + std::to_string(max_bytes / 1'000'000) + " MB",
                  "is it the right file?");
  };
  expect_at_most(static_cast<std::uintmax_t>(status.st_size));

  // One byte more than the size, so that the end of the file is detected without growing. A pipe reports size 0.
  std::string bytes(static_cast<std::size_t>(status.st_size) + 1, '\0');
  std::size_t filled = 0;
  const bool is_pipe = S_ISFIFO(status.st_mode);
  while (true) {
    if (filled == bytes.size()) bytes.resize(2 * filled + 65536);
    const ssize_t got = read_some(file, std::span(bytes).subspan(filled), !is_pipe || filled > 0, progress);
    if (is_pipe && got < 0 && errno == ETIMEDOUT)
      throw Error(ErrorKind::input, path.string(), "is a pipe to which nobody writes");
    if (got < 0) fail(ErrorKind::input, path, "read", errno);
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
    expect_at_most(filled);
  }
  bytes.resize(filled);
  refuse_pointer(path, bytes);
  return bytes;
}

void write_file(const fs::path& path, std::string_view bytes, Progress progress) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw Error(ErrorKind::output, path.string(), "is a directory, not a file");
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) return write_directly(path, bytes);

  const fs::path target = end_of_links(path);
  if (fs::is_symlink(target, ignored)) fail(ErrorKind::output, path, "write", ELOOP);
  if (fs::exists(target, ignored) && ::access(target.c_str(), W_OK) != 0) fail(ErrorKind::output, path, "write", errno);
  if (!replace_by_nameless(target, bytes, progress) && !replace_by_named(target, bytes, progress))
    fail(ErrorKind::output, path, "write", errno);
}

}  // namespace epura
