// SPDX-License-Identifier: Apache-2.0
#include "base/file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "errors.hpp"
#include "folder.hpp"

namespace epura::test::file_test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

int mode_of(const fs::path& path) { return static_cast<int>(fs::status(path).permissions()); }

TEST(Files, BytesComeBack) {
  const Folder folder;
  std::string bytes(100000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i >> 3);
  for (const std::string& content : {std::string(), std::string("\0\r\n\xFF", 4), bytes}) {
    write_file(folder / "a", content);
    EXPECT_EQ(read_file(folder / "a"), content);
  }
  EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(Files, DevicesAreNoFiles) {
  for (const char* path : {"/dev/zero", "/dev/null"})
    EXPECT_TRUE(contains(error_of([&] { read_file(path); }).what(), "is a device, not a file"));
}

TEST(Files, MoreThanIsWantedIsNotRead) {
  const Folder folder;
  const std::string path = folder.file("a", std::string(3'000'000, 'a'));
  EXPECT_EQ(read_file(path, {}, 3'000'000).size(), 3'000'000U);
  EXPECT_TRUE(contains(error_of([&] { read_file(path, {}, 2'999'999); }).what(), "has more than 2 MB"));
}

// A scene file can name a pipe.
TEST(Files, APipeWithoutAWriterIsNotWaitedFor) {
  const Folder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  EXPECT_TRUE(contains(error_of([&] { read_file(path); }).what(), "is a pipe to which nobody writes"));
}

TEST(Files, AWriterMayComeLateAndPause) {
  const Folder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const auto pause = [] { std::this_thread::sleep_for(std::chrono::milliseconds(60)); };
  std::thread writer([&] {
    pause();
    std::ofstream pipe(path);
    pause();
    pipe << "one " << std::flush;
    pause();
    pipe << "two";
  });
  EXPECT_EQ(read_file(path), "one two");
  writer.join();
  std::thread silent([&] { const std::ofstream pipe(path); });
  EXPECT_EQ(read_file(path), "");
  silent.join();
}

TEST(Files, APipeWithoutEndIsRefused) {
  const Folder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  auto* const before = std::signal(SIGPIPE, SIG_IGN);
  std::thread writer([&] {
    std::ofstream pipe(path);
    while (pipe) pipe << "endless\n";
  });
  EXPECT_TRUE(contains(error_of([&] { read_file(path, {}, 5'000'000); }).what(), "has more than 5 MB"));
  writer.join();
  std::signal(SIGPIPE, before);
}

TEST(Files, APointerOfGitLfsIsNoFile) {
  const Folder folder;
  const std::string path =
      folder.file("a.stl", "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12\n");
  const Error error = error_of([&] { read_file(path); });
  EXPECT_EQ(error.kind(), ErrorKind::input);
  EXPECT_TRUE(contains(error.what(), "Git LFS pointer")) << error.what();
  EXPECT_EQ(error.hint(), "run git lfs pull");
}

TEST(Files, WhatCannotBeReadIsNamedWithTheReason) {
  const Folder folder;
  const Error missing = error_of([&] { read_file(folder / "none.obj"); });
  EXPECT_EQ(missing.kind(), ErrorKind::input);
  EXPECT_EQ(missing.where(), (folder / "none.obj").string());
  EXPECT_TRUE(contains(missing.what(), "No such file")) << missing.what();
  EXPECT_EQ(missing.hint(), "check the path");
  const Error directory = error_of([&] { read_file(folder / ""); });
  EXPECT_TRUE(contains(directory.what(), "is a directory")) << directory.what();
}

TEST(Files, ANewFileHasTheModeOfAnyNewFile) {
  const Folder folder;
  const mode_t mask = ::umask(027);
  write_file(folder / "a", "x");
  ::umask(mask);
  EXPECT_EQ(mode_of(folder / "a"), 0640);
}

TEST(Files, AnOldFileKeepsItsMode) {
  const Folder folder;
  write_file(folder / "a", "old");
  fs::permissions(folder / "a", fs::perms(0604));
  write_file(folder / "a", "new");
  EXPECT_EQ(mode_of(folder / "a"), 0604);
  EXPECT_EQ(read_file(folder / "a"), "new");
}

TEST(Files, ALinkStaysALink) {
  const Folder folder;
  write_file(folder / "target", "old");
  fs::create_symlink("target", folder / "link");
  write_file(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read_file(folder / "target"), "new");
  EXPECT_EQ(folder.names(), (Names{"link", "target"}));
}

TEST(Files, ALinkToNothingYetStaysALink) {
  const Folder folder;
  fs::create_directory(folder / "below");
  fs::create_symlink("below/second", folder / "first");
  fs::create_symlink("../target", folder / "below/second");
  write_file(folder / "first", "new");
  EXPECT_EQ(fs::read_symlink(folder / "first"), "below/second");
  EXPECT_EQ(fs::read_symlink(folder / "below/second"), "../target");
  EXPECT_EQ(read_file(folder / "target"), "new");
}

TEST(Files, LinksInACircleAreRefusedAndStay) {
  const Folder folder;
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  const Error error = error_of([&] { write_file(folder / "a", "new"); });
  EXPECT_EQ(error.kind(), ErrorKind::output);
  EXPECT_TRUE(contains(error.what(), "symbolic links")) << error.what();
  EXPECT_TRUE(fs::is_symlink(folder / "a") && fs::is_symlink(folder / "b"));
}

TEST(Files, OneFileIsKnownByAllItsNames) {
  const Folder folder;
  write_file(folder / "a", "x");
  write_file(folder / "b", "x");
  fs::create_hard_link(folder / "a", folder / "hard");
  fs::create_symlink("a", folder / "soft");
  fs::create_symlink("soft", folder / "softer");
  fs::create_symlink("new", folder / "to-come");
  const auto identity = [&](const char* name) { return identity_of_file(folder / name); };
  for (const char* name : {"hard", "soft", "softer", "./a"}) EXPECT_EQ(identity(name), identity("a")) << name;
  for (const char* name : {"to-come", "missing/../new"}) EXPECT_EQ(identity(name), identity("new")) << name;
  for (const char* name : {"b", "new", "to-come"}) EXPECT_NE(identity(name), identity("a")) << name;
  for (const fs::path& none : {fs::path("/dev/null"), folder / ""}) EXPECT_EQ(identity_of_file(none), "");
}

TEST(Files, AReaderKeepsTheOldFile) {
  const Folder folder;
  write_file(folder / "a", "old");
  std::ifstream reader(folder / "a");
  write_file(folder / "a", "something new");
  std::string seen;
  std::getline(reader, seen);
  EXPECT_EQ(seen, "old");
}

TEST(Files, NamesThatOthersHaveTakenAreLeftAlone) {
  const Folder folder;
  const std::string other = "a." + std::to_string(::getpid());
  write_file(folder / "b", "other");
  fs::rename(folder / "b", folder / other);
  write_file(folder / "a", "new");
  EXPECT_EQ(read_file(folder / "a"), "new");
  EXPECT_EQ(read_file(folder / other), "other");
  EXPECT_EQ(folder.names(), (Names{"a", other}));
}

TEST(Files, NothingIsPutInPlaceWhileTheRunIsBeingEnded) {
  const Folder folder;
  write_file(folder / "a", "old");
  ProgressBoard board;
  std::unique_lock ending(board.ending());
  std::thread writer([&] { write_file(folder / "a", "new", Progress(board)); });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(folder.names(), Names{"a"});
  EXPECT_EQ(read_file(folder / "a"), "old");
  ending.unlock();
  writer.join();
  EXPECT_EQ(read_file(folder / "a"), "new");
}

TEST(Files, WhatCannotBeWrittenIsRefused) {
  const Folder folder;
  write_file(folder / "file", "old");
  for (const fs::path& path : {folder / "", folder / "missing/a", folder / "file/a", fs::path("/proc/epura")}) {
    const Error error = error_of([&] { write_file(path, "x"); });
    EXPECT_EQ(error.kind(), ErrorKind::output) << path;
    EXPECT_EQ(error.where(), path.string());
  }
  EXPECT_EQ(folder.names(), Names{"file"});
  EXPECT_EQ(read_file(folder / "file"), "old");
}

TEST(Files, DevicesAreWrittenToDirectly) {
  write_file("/dev/null", "x");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(error_of([] { write_file("/dev/full", "x"); }).kind(), ErrorKind::output);
}

// Files may hold no more than this many bytes while it lives: a full disk, as far as the writer can see.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  void (*old_handler_)(int);
  rlimit old_{};
};

TEST(Files, AFullDiskLeavesTheOldFileAndNothingElse) {
  const Folder folder;
  write_file(folder / "a", "old");
  Error error(ErrorKind::input, "", "");
  {
    const FullDisk disk(1000);
    error = error_of([&] { write_file(folder / "a", std::string(5000, 'x')); });
  }
  EXPECT_EQ(error.kind(), ErrorKind::output);
  EXPECT_EQ(read_file(folder / "a"), "old");
  EXPECT_EQ(folder.names(), Names{"a"});
}

}  // namespace
}  // namespace epura::test::file_test
