#include "base/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "base/error.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool close() {
    const int number = number_;
    number_ = -1;
    return ::close(number) == 0;
  }

 private:
  int number_;
};

[[noreturn]] void fail(Trouble trouble, const fs::path& path, const std::string& action, int number) {
  std::string hint;
  if (number == ENOENT) hint = trouble == Trouble::input ? "check the path" : "make the folder first";
  if (number == EACCES || number == EROFS) hint = "check the permissions of the file and its folder";
  throw Error(trouble, path.string(), "cannot " + action + ": " + std::strerror(number), hint);
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
  if (file.number() < 0) fail(Trouble::output, path, "write", errno);
  if (!write_all(file.number(), bytes) || !file.close()) fail(Trouble::output, path, "write", errno);
}

}  // namespace

std::string read_file(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) fail(Trouble::input, path, "read", errno);
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) fail(Trouble::input, path, "read", errno);
  if (S_ISDIR(status.st_mode)) throw Error(Trouble::input, path.string(), "is a directory, not a file");

  // One byte more than the size, so that the end of the file is seen without growing. A pipe says size 0.
  std::string bytes(static_cast<std::size_t>(status.st_size) + 1, '\0');
  std::size_t filled = 0;
  while (true) {
    if (filled == bytes.size()) bytes.resize(2 * filled + 65536);
    const ssize_t got = ::read(file.number(), bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(Trouble::input, path, "read", errno);
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
  }
  bytes.resize(filled);
  return bytes;
}

void write_file(const fs::path& path, std::string_view bytes) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw Error(Trouble::output, path.string(), "is a directory, not a file");
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) return write_directly(path, bytes);

  // A link is followed, so that it stays a link.
  fs::path target = fs::is_symlink(path, ignored) ? fs::canonical(path, ignored) : path;
  if (target.empty()) target = path;
  if (fs::exists(target, ignored) && ::access(target.c_str(), W_OK) != 0) fail(Trouble::output, path, "write", errno);

  std::string temporary = target.string() + ".XXXXXX";
  Descriptor file(::mkostemp(temporary.data(), O_CLOEXEC));
  if (file.number() < 0) fail(Trouble::output, path, "write", errno);

  // mkostemp makes private files; the result gets the mode that any new file would get.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  struct stat old {};
  const mode_t mode = ::stat(target.c_str(), &old) == 0 ? old.st_mode & 0777 : 0666 & ~mask;
  const bool written = write_all(file.number(), bytes) && ::fchmod(file.number(), mode) == 0 && file.close() &&
                       ::rename(temporary.c_str(), target.c_str()) == 0;
  if (written) return;
  const int number = errno;
  ::unlink(temporary.c_str());
  fail(Trouble::output, path, "write", number);
}

}  // namespace epura
