// SPDX-License-Identifier: Apache-2.0
// A library to preload, which lets a system call of a program fail, or refuses it memory: tests/faults/run says which.
//
// EPURA_FAULT=CALL:N:WHAT: the N-th call fails; CALL:N+:WHAT: and all after it. WHAT is the name of an error, or
// "short" (a part of what was asked for is read or written), or "kill" (the process ends there).
// CALL:FIRST-LAST/STEP:WHAT with EPURA_FAULT_BRANCH (branch.hpp): each of these fails in a copy of the process.
// EPURA_FAULT_ALONE: only in the first process, not in those that it starts.
// EPURA_FAULT_COUNTS=FILE: keeps a table there, a row for each process: how many calls of each kind there had been when
// it began (as a copy of another, perhaps), and how many there are.
// EPURA_FAULT_CLOCK=SECONDS: what the clock on the wall shows is that much later.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "branch.hpp"

extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* old, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
}

namespace {

enum Call {
  memory,
  map,
  open_file,
  nameless,
  read_bytes,
  write_bytes,
  close_file,
  sync_file,
  rename_file,
  link_file,
  mode,
  status,
  list_folder,
  thread,
  fork_process,
  spawn,
  pair,
  wait_for,
  calls
};
constexpr const char* names[calls] = {"memory",  "mmap",   "open",   "nameless", "read",       "write",
                                      "close",   "fsync",  "rename", "link",     "fchmod",     "stat",
                                      "readdir", "thread", "fork",   "spawn",    "socketpair", "poll"};

struct ErrorName {
  const char* name;
  int number;
};
constexpr ErrorName errors[] = {{"ENOMEM", ENOMEM}, {"ENOSPC", ENOSPC},        {"EIO", EIO},
                                {"EINTR", EINTR},   {"EACCES", EACCES},        {"EXDEV", EXDEV},
                                {"ESTALE", ESTALE}, {"EMFILE", EMFILE},        {"EAGAIN", EAGAIN},
                                {"EDQUOT", EDQUOT}, {"EOPNOTSUPP", EOPNOTSUPP}};
constexpr int shortened = -1, killed = -2;

std::atomic<long> counts[calls];
long wanted = 0;
int failing = calls, how = 0;
bool goes_on = false, is_alone = false;
// The calls that fail in copies, and what processes that are started from a copy read in place of EPURA_FAULT.
long last_wanted = 0, step = 0;
pid_t original = 0, pretended = 0;  // the process before it was copied; one that a copy seems to have killed
const char* what = "";

constexpr long most_rows = 200;
struct Row {
  long before[calls], now[calls];
};
struct Table {
  std::atomic<long> rows;
  char words[calls][16];
  Row counts[most_rows];
};
Table* table = nullptr;
Row* row = nullptr;
char variable[128] = "EPURA_FAULT=none:0:kill";

// However a process ends, the table has its counts.
void begin_row() {
  if (table == nullptr) return;
  const long number = table->rows.fetch_add(1, std::memory_order_relaxed);
  row = number < most_rows ? &table->counts[number] : nullptr;
  for (int call = 0; row != nullptr && call < calls; ++call) row->before[call] = row->now[call] = counts[call];
}

void begin_counting() {
  const char* path = getenv("EPURA_FAULT_COUNTS");
  if (path == nullptr) return;
  const int file = static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, O_RDWR | O_CLOEXEC, 0));
  const long place = syscall(SYS_mmap, nullptr, sizeof(Table), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  syscall(SYS_close, file);
  if (place < 0) return;
  table = reinterpret_cast<Table*>(place);
  for (int call = 0; call < calls; ++call) strcpy(table->words[call], names[call]);
  begin_row();
}

// For processes that this one starts.
void set_variable(const char* fault, const char* word) {
  if (fault != nullptr)
    snprintf(variable, sizeof variable, "EPURA_FAULT=%s:%ld%s:%s", fault, wanted, goes_on ? "+" : "", word);
  for (char** place = environ; *place != nullptr; ++place)
    if (strncmp(*place, "EPURA_FAULT=", 12) == 0) *place = variable;
}

// Neither memory nor locks are needed here: this runs before everything else.
__attribute__((constructor)) void begin() {
  begin_counting();
  const char* text = getenv("EPURA_FAULT");
  if (text == nullptr) return;
  const char* colon = strchr(text, ':');
  if (colon == nullptr) return;
  char* rest = nullptr;
  const long number = strtol(colon + 1, &rest, 10);
  if (*rest == '-') {
    last_wanted = strtol(rest + 1, &rest, 10);
    step = strtol(rest + 1, &rest, 10);
  }
  goes_on = *rest == '+';
  const char* word = strchr(rest, ':');
  if (word == nullptr) return;
  ++word;
  if (strcmp(word, "short") == 0) how = shortened;
  if (strcmp(word, "kill") == 0) how = killed;
  for (const ErrorName& error : errors)
    if (strcmp(word, error.name) == 0) how = error.number;
  wanted = number;
  for (int call = 0; call < calls; ++call)
    if (strlen(names[call]) == static_cast<size_t>(colon - text) && strncmp(text, names[call], colon - text) == 0)
      failing = call;
  original = getpid();
  if (step > 0 && !branch::begin()) step = 0;
  what = word;
  is_alone = getenv("EPURA_FAULT_ALONE") != nullptr;
  if (is_alone || step > 0) set_variable(nullptr, nullptr);
}

// In a copy, the call fails as if only that had been asked for.
void fail_in_copy(long number) {
  if (number < wanted || number > last_wanted || (number - wanted) % step != 0 || !branch::copy_before(number)) return;
  wanted = number;
  set_variable(names[failing], what);
}

// Counts a call. Whether it is one that fails; then errno is set.
bool fails(Call call) {
  const long number = counts[call].fetch_add(1, std::memory_order_relaxed) + 1;
  if (row != nullptr) row->now[call] = number;
  if (call != failing || (is_alone && getpid() != original)) return false;
  if (step > 0 && !branch::is_copy() && getpid() == original) fail_in_copy(number);
  if (step > 0 && !branch::is_copy()) return false;
  if (!(number == wanted || (goes_on && number > wanted))) return false;
  if (how == killed) syscall(SYS_kill, getpid(), SIGKILL);
  if (how > 0) errno = how;
  return true;
}

// The number of bytes to ask for, if not all.
size_t part_of(size_t size) { return how == shortened && size > 1 ? size / 2 : size; }

template <class Function>
Function real(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

mode_t mode_of(int flags, va_list rest) { return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0; }

int open_at(int folder, const char* path, int flags, mode_t bits) {
  const bool has_no_name = (flags & O_TMPFILE) == O_TMPFILE;
  if (has_no_name && fails(nameless)) return -1;
  if (fails(open_file)) return -1;
  return static_cast<int>(syscall(SYS_openat, folder, path, flags, bits));
}

template <class Transfer>
ssize_t transfer(Call call, size_t size, const Transfer& go) {
  if (!fails(call)) return go(size);
  return how == shortened ? go(part_of(size)) : -1;
}

}  // namespace

extern "C" {

void* malloc(size_t size) { return fails(memory) ? nullptr : __libc_malloc(size); }
void* calloc(size_t count, size_t size) { return fails(memory) ? nullptr : __libc_calloc(count, size); }
void* realloc(void* old, size_t size) { return fails(memory) ? nullptr : __libc_realloc(old, size); }
void* memalign(size_t alignment, size_t size) { return fails(memory) ? nullptr : __libc_memalign(alignment, size); }
void* aligned_alloc(size_t alignment, size_t size) {
  return fails(memory) ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** place, size_t alignment, size_t size) {
  void* const memory_there = fails(memory) ? nullptr : __libc_memalign(alignment, size);
  if (memory_there == nullptr) return ENOMEM;
  *place = memory_there;
  return 0;
}

void* mmap(void* place, size_t size, int protection, int flags, int file, off_t offset) {
  if (fails(map)) return MAP_FAILED;
  return reinterpret_cast<void*>(syscall(SYS_mmap, place, size, protection, flags, file, offset));
}
void* mmap64(void* place, size_t size, int protection, int flags, int file, off_t offset) {
  return mmap(place, size, protection, flags, file, offset);
}

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t bits = mode_of(flags, rest);
  va_end(rest);
  return open_at(AT_FDCWD, path, flags, bits);
}
int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t bits = mode_of(flags, rest);
  va_end(rest);
  return open_at(AT_FDCWD, path, flags, bits);
}
int openat(int folder, const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t bits = mode_of(flags, rest);
  va_end(rest);
  return open_at(folder, path, flags, bits);
}
int mkostemp(char* pattern, int flags) {
  if (fails(open_file)) return -1;
  return real<int (*)(char*, int)>("mkostemp")(pattern, flags);
}
int mkostemp64(char* pattern, int flags) { return mkostemp(pattern, flags); }
FILE* fopen(const char* path, const char* how_to) {
  if (fails(open_file)) return nullptr;
  return real<FILE* (*)(const char*, const char*)>("fopen")(path, how_to);
}
FILE* fopen64(const char* path, const char* how_to) { return fopen(path, how_to); }

ssize_t read(int file, void* bytes, size_t size) {
  branch::expect_own(file);
  return transfer(read_bytes, size, [&](size_t part) { return syscall(SYS_read, file, bytes, part); });
}
ssize_t pread(int file, void* bytes, size_t size, off_t offset) {
  return transfer(read_bytes, size, [&](size_t part) { return syscall(SYS_pread64, file, bytes, part, offset); });
}
ssize_t pread64(int file, void* bytes, size_t size, off_t offset) { return pread(file, bytes, size, offset); }
ssize_t recv(int socket, void* bytes, size_t size, int flags) {
  branch::expect_own(socket);
  return transfer(read_bytes, size,
                  [&](size_t part) { return syscall(SYS_recvfrom, socket, bytes, part, flags, nullptr, nullptr); });
}
ssize_t write(int file, const void* bytes, size_t size) {
  branch::expect_own(file);
  return transfer(write_bytes, size, [&](size_t part) { return syscall(SYS_write, file, bytes, part); });
}
ssize_t send(int socket, const void* bytes, size_t size, int flags) {
  branch::expect_own(socket);
  return transfer(write_bytes, size,
                  [&](size_t part) { return syscall(SYS_sendto, socket, bytes, part, flags, nullptr, 0); });
}

// The descriptor is closed in any case, as Linux does.
int close(int file) {
  branch::forget(file);
  const bool failed = fails(close_file);
  const int number = errno;
  const int result = static_cast<int>(syscall(SYS_close, file));
  if (!failed) return result;
  errno = number;
  return -1;
}
int fsync(int file) { return fails(sync_file) ? -1 : static_cast<int>(syscall(SYS_fsync, file)); }
int fdatasync(int file) { return fails(sync_file) ? -1 : static_cast<int>(syscall(SYS_fdatasync, file)); }

int rename(const char* from, const char* to) {
  return fails(rename_file) ? -1 : static_cast<int>(syscall(SYS_rename, from, to));
}
int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) {
  return fails(link_file) ? -1 : static_cast<int>(syscall(SYS_linkat, from_folder, from, to_folder, to, flags));
}
int fchmod(int file, mode_t bits) { return fails(mode) ? -1 : static_cast<int>(syscall(SYS_fchmod, file, bits)); }

int stat(const char* path, struct stat* result) {
  return fails(status) ? -1 : static_cast<int>(syscall(SYS_newfstatat, AT_FDCWD, path, result, 0));
}
int stat64(const char* path, struct stat64* result) { return stat(path, reinterpret_cast<struct stat*>(result)); }
int fstat(int file, struct stat* result) {
  return fails(status) ? -1 : static_cast<int>(syscall(SYS_fstat, file, result));
}
int fstat64(int file, struct stat64* result) { return fstat(file, reinterpret_cast<struct stat*>(result)); }

// Both names, since either may be what the program calls; neither is called by the other.
dirent* readdir(DIR* folder) { return fails(list_folder) ? nullptr : real<dirent* (*)(DIR*)>("readdir")(folder); }
dirent64* readdir64(DIR* folder) {
  return fails(list_folder) ? nullptr : real<dirent64* (*)(DIR*)>("readdir64")(folder);
}

int pthread_create(pthread_t* thread_made, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  if (fails(thread)) return how > 0 ? how : EAGAIN;
  using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  const int failure = real<Create>("pthread_create")(thread_made, attributes, run, argument);
  if (failure == 0) branch::add_thread(*thread_made);
  return failure;
}
int pthread_join(pthread_t thread, void** result) {
  return branch::is_gone(thread) ? 0 : real<int (*)(pthread_t, void**)>("pthread_join")(thread, result);
}
pid_t fork() {
  const pid_t child = fails(fork_process) ? -1 : real<pid_t (*)()>("fork")();
  if (child == 0) begin_row();
  branch::add_child(child);
  return child;
}
int kill(pid_t process, int signal) {
  if (!branch::is_own(process)) pretended = process;
  return process == pretended ? 0 : static_cast<int>(syscall(SYS_kill, process, signal));
}
pid_t waitpid(pid_t process, int* status, int options) {
  if (process > 0 && process == pretended) {
    if (status != nullptr) *status = SIGKILL;
    return process;
  }
  branch::expect_own_child(process);
  return static_cast<pid_t>(syscall(SYS_wait4, process, status, options, nullptr));
}
int posix_spawn(pid_t* child, const char* path, const posix_spawn_file_actions_t* actions,
                const posix_spawnattr_t* how_to, char* const words[], char* const variables[]) {
  if (fails(spawn)) return how > 0 ? how : EAGAIN;
  using Spawn = int (*)(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*, char* const*,
                        char* const*);
  const int failure = real<Spawn>("posix_spawn")(child, path, actions, how_to, words, variables);
  if (failure == 0) branch::add_child(*child);
  return failure;
}
int socketpair(int domain, int type, int protocol, int ends[2]) {
  return fails(pair) ? -1 : static_cast<int>(syscall(SYS_socketpair, domain, type, protocol, ends));
}
int poll(pollfd* events, nfds_t count, int wait_ms) {
  for (nfds_t i = 0; i < count; ++i) branch::expect_own(events[i].fd);
  return fails(wait_for) ? -1 : static_cast<int>(syscall(SYS_poll, events, count, wait_ms));
}

int clock_gettime(clockid_t clock, timespec* result) {
  const int done = static_cast<int>(syscall(SYS_clock_gettime, clock, result));
  const char* later = clock == CLOCK_REALTIME ? getenv("EPURA_FAULT_CLOCK") : nullptr;
  if (later != nullptr) result->tv_sec += strtol(later, nullptr, 10);
  return done;
}
time_t time(time_t* result) {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  if (result != nullptr) *result = now.tv_sec;
  return now.tv_sec;
}
}
