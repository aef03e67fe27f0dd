// SPDX-License-Identifier: Apache-2.0
#include "branch.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/eventfd.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

// Nothing here may call what the library replaces: it would be counted, and could fail.
namespace branch {

namespace {

constexpr int most_files = 256, most_threads = 256, most_children = 64;
constexpr int tried_alone = 201;  // an exit code that epura does not have

int ask_by = -1, answer_by = -1;
bool copied = false;
bool is_foreign[most_files];
pthread_t threads[most_threads];
int thread_count = 0, threads_before = 0;
pid_t children[most_children];
int child_count = 0;

long status_of(int file, struct stat* result) { return syscall(SYS_fstat, file, result); }
long close_raw(int file) { return syscall(SYS_close, file); }

void say(const char* word, long number) {
  char line[64];
  const int size = snprintf(line, sizeof line, "%s %ld\n", word, number);
  syscall(SYS_write, ask_by, line, size);
}

char answer() {
  char letter = 0;
  long got = 0;
  do got = syscall(SYS_read, answer_by, &letter, 1);
  while (got < 0 && errno == EINTR);
  if (got != 1) syscall(SYS_exit_group, 1);
  return letter;
}

long path_of(int file, char* path, size_t size) {
  char self[40];
  snprintf(self, sizeof self, "/proc/self/fd/%d", file);
  const long length = syscall(SYS_readlink, self, path, size - 1);
  path[length < 0 ? 0 : length] = '\0';
  return length;
}

// All of what the process has written so far.
void copy_bytes(int from, int to) {
  char bytes[4096];
  off_t at = 0;
  for (long got = 0; (got = syscall(SYS_pread64, from, bytes, sizeof bytes, at)) > 0; at += got)
    syscall(SYS_pwrite64, to, bytes, got, at);
}

int open_again(int file, int flags) {
  char self[40];
  snprintf(self, sizeof self, "/proc/self/fd/%d", file);
  return static_cast<int>(syscall(SYS_openat, AT_FDCWD, self, flags, 0));
}

// A file that is being written: the copy writes into a file of its own, with the same name if it has one.
int own_file(int file, const struct stat& status, int flags) {
  char path[4096], beside[4200];
  if (path_of(file, path, sizeof path) <= 0) return -1;
  const int readable = open_again(file, O_RDONLY);
  int own = -1;
  if (strncmp(path, "/memfd:", 7) == 0) {
    own = static_cast<int>(syscall(SYS_memfd_create, "copy", 0));
  } else if (status.st_nlink == 0) {
    *strrchr(path, '/') = '\0';
    own = static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, O_TMPFILE | O_RDWR, status.st_mode & 07777));
  } else {
    snprintf(beside, sizeof beside, "%s.copy", path);
    own = static_cast<int>(syscall(SYS_openat, AT_FDCWD, beside, O_RDWR | O_CREAT, status.st_mode & 07777));
    syscall(SYS_rename, beside, path);
  }
  copy_bytes(readable, own);
  close_raw(readable);
  const int same = open_again(own, flags & (O_ACCMODE | O_APPEND));
  close_raw(own);
  return same;
}

void make_own(int file) {
  struct stat status {};
  if (status_of(file, &status) != 0) return;
  const int flags = static_cast<int>(syscall(SYS_fcntl, file, F_GETFL));
  const int kept = static_cast<int>(syscall(SYS_fcntl, file, F_GETFD)) & FD_CLOEXEC ? O_CLOEXEC : 0;
  int own = -1;
  if (S_ISREG(status.st_mode)) {
    own = (flags & O_ACCMODE) == O_RDONLY ? open_again(file, O_RDONLY) : own_file(file, status, flags);
    if (own < 0) syscall(SYS_exit_group, tried_alone);
    syscall(SYS_lseek, own, syscall(SYS_lseek, file, 0, SEEK_CUR), SEEK_SET);
    // Two descriptors of one file would become two files.
    for (int other = file + 1; other < most_files; ++other) {
      struct stat same {};
      if (status_of(other, &same) != 0 || same.st_ino != status.st_ino || same.st_dev != status.st_dev) continue;
      if ((flags & O_ACCMODE) != O_RDONLY) syscall(SYS_exit_group, tried_alone);
    }
  } else {
    char path[64];
    path_of(file, path, sizeof path);
    if (strcmp(path, "anon_inode:[eventfd]") == 0) own = static_cast<int>(syscall(SYS_eventfd2, 0, 0));
    is_foreign[file] = S_ISSOCK(status.st_mode) || S_ISFIFO(status.st_mode) || strcmp(path, "anon_inode:[pidfd]") == 0;
  }
  if (own < 0) return;
  syscall(SYS_dup3, own, file, kept);
  close_raw(own);
}

void become_copy() {
  copied = true;
  threads_before = thread_count;
  child_count = 0;
  close_raw(ask_by);
  close_raw(answer_by);
  // Messages of copies follow those of the process.
  for (int file = 3; file < most_files; ++file) make_own(file);
}

}  // namespace

bool begin() {
  const char* text = getenv("EPURA_FAULT_BRANCH");
  if (text == nullptr || sscanf(text, "%d,%d", &ask_by, &answer_by) != 2) return false;
  for (int* file : {&ask_by, &answer_by}) {
    const int beyond = static_cast<int>(syscall(SYS_fcntl, *file, F_DUPFD_CLOEXEC, most_files));
    close_raw(*file);
    *file = beyond;
  }
  return true;
}

bool copy_before(long number) {
  if (syscall(SYS_gettid) != syscall(SYS_getpid)) {
    say("alone", number);
    return false;
  }
  say("begin", number);
  if (answer() != 'y') return false;
  const int errno_before = errno;
  // Not fork(), which would free locks that the caller holds.
  const long child = syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0);
  if (child == 0) {
    become_copy();
    errno = errno_before;
    return true;
  }
  say("copy", child);
  int status = 0;
  while (syscall(SYS_wait4, child, &status, 0, nullptr) < 0 && errno == EINTR) {
  }
  const bool alone = WIFEXITED(status) && WEXITSTATUS(status) == tried_alone;
  say(alone ? "again" : "end", alone ? number : WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status));
  answer();
  errno = errno_before;
  return false;
}

bool is_copy() { return copied; }

void expect_own(int file) {
  if (copied && file >= 0 && file < most_files && is_foreign[file]) syscall(SYS_exit_group, tried_alone);
}
void forget(int file) {
  if (file >= 0 && file < most_files) is_foreign[file] = false;
}

bool is_own(pid_t child) {
  if (!copied || child <= 0 || child == syscall(SYS_getpid)) return true;
  return std::find(children, children + child_count, child) != children + child_count;
}
void expect_own_child(pid_t child) {
  if (!is_own(child)) syscall(SYS_exit_group, tried_alone);
}
void add_child(pid_t child) {
  if (child > 0 && child_count < most_children) children[child_count++] = child;
}

void add_thread(pthread_t thread) {
  if (thread_count < most_threads) threads[thread_count++] = thread;
}
bool is_gone(pthread_t thread) {
  for (int i = 0; copied && i < threads_before; ++i)
    if (threads[i] == thread) return true;
  return false;
}

}  // namespace branch
