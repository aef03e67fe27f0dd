// SPDX-License-Identifier: Apache-2.0
#include "importer/process.hpp"

#include <fcntl.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/shared_library.hpp"
#include "base/text.hpp"
#include "foreign/child_process.hpp"
#include "foreign/messages.hpp"
#include "foreign/sandbox.hpp"
#include "importer/bounds.hpp"
#include "importer/memory.hpp"

namespace epura::importer {

namespace {

using foreign::Clock;
using foreign::Packer;
using foreign::Unpacker;

/// Only a corrupted process sends longer messages.
constexpr std::size_t max_bytes = std::size_t{1} << 36;

enum class Question { recognise, read };
/// The kind of a message that answers Question::read.
enum class Answer { progress, document, refusal };

// One function for both packing and unpacking, so that the two always agree.

template <class Pack, class Value>
void pack_table(Pack& pack, Value& table) {
  pack(table.name), pack(table.summary), pack(table.extensions), pack(table.has_mark);
}

template <class Pack, class Value>
void pack_reading(Pack& pack, Value& reading) {
  pack(reading.path), pack(reading.values), pack(reading.tolerance), pack(reading.relative_tolerance);
  pack(reading.threads), pack(reading.may_leave), pack(reading.is_confined), pack(reading.readable);
  pack(reading.bounds.memory);
}

void pack_tables(Packer& pack, const std::vector<LoadedImporter>& importers) {
  pack(importers.size());
  for (const LoadedImporter& importer : importers) {
    pack_table(pack, importer.table);
    pack(importer.table.parameters.size());
    for (const foreign::Parameter& parameter : importer.table.parameters) foreign::pack_parameter(pack, parameter);
  }
}

std::vector<ImporterTable> unpack_tables(Unpacker& unpack) {
  std::vector<ImporterTable> tables(unpack.count(1));
  for (ImporterTable& table : tables) {
    pack_table(unpack, table);
    table.parameters.resize(unpack.count(1));
    for (foreign::Parameter& parameter : table.parameters) foreign::pack_parameter(unpack, parameter);
  }
  return tables;
}

// That this process may take, and the processes that it starts; the most if there is no limit.
rlim_t memory_limit() {
  rlimit limit{};
  return ::getrlimit(RLIMIT_DATA, &limit) == 0 ? limit.rlim_cur : RLIM_INFINITY;
}

// The smaller of what a file may take and what this process may.
rlim_t memory_for(const Reading& reading) {
  return reading.bounds.memory > 0
             ? std::min(memory_limit(), static_cast<rlim_t>(std::min(reading.bounds.memory, 1e15)))
             : memory_limit();
}

// The following code runs in the process of the library.

class Server {
 public:
  Server(std::filesystem::path library, int socket) : library_(std::move(library)), socket_(socket) {}

  bool load() {
    return foreign::send_message(socket_, foreign::message_or_reason([&](Packer& message) {
                                   importers_ = load_importers(library_);
                                   pack_tables(message, importers_);
                                 }));
  }

  bool answer(const std::string& words) {
    Unpacker unpack(words);
    Question question{};
    std::string name;
    unpack(question), unpack(name);
    const epura_importer& importer = named(name);
    return foreign::send_message(socket_, question == Question::recognise ? answer_to_recognise(unpack, importer)
                                                                          : answer_to_read(unpack, importer));
  }

 private:
  [[nodiscard]] const epura_importer& named(const std::string& name) const {
    for (const LoadedImporter& importer : importers_)
      if (importer.table.name == name) return *importer.definition;
    throw Error(ErrorKind::plugin, "", "no longer exists");
  }

  static Packer answer_to_recognise(Unpacker& question, const epura_importer& importer) {
    std::vector<unsigned char> first_bytes;
    question(first_bytes);
    return foreign::message_or_reason(
        [&](Packer& answer) { answer(int{importer.recognises(first_bytes.data(), first_bytes.size()) != 0}); });
  }

  Packer answer_to_read(Unpacker& question, const epura_importer& importer) {
    Reading reading;
    pack_reading(question, reading);
    const auto tell = [&](double done) {
      Packer message;
      message(Answer::progress), message(done);
      foreign::send_message(socket_, message);
    };
    Packer answer;
    try {
      if (reading.is_confined != 0) confine(reading);
      if (has_own_memory) limit_memory(reading);
      const ImportedFile document = read_by(importer, reading, tell);
      answer(Answer::document);
      pack_file(answer, document);
    } catch (const Error& error) {
      answer(Answer::refusal), answer(error.kind()), answer(std::string(error.what()));
    }
    return answer;
  }

  void confine(Reading& reading) {
    if (std::exchange(is_confined_, true)) return;
    // A confined process opens no descriptors of another one.
    if (reading.readable.empty())
      reading.path = "/proc/self/fd/" + std::to_string(::open(reading.path.c_str(), O_RDONLY | O_CLOEXEC));
    foreign::Permissions permissions{reading.readable, {}, {}};
    permissions.readable.push_back(library_.parent_path());
    foreign::enter_sandbox(permissions);
  }

  // Only the soft limit, since the next file may be larger.
  void limit_memory(const Reading& reading) {
    rlimit limit{};
    ::getrlimit(RLIMIT_DATA, &limit);
    limit.rlim_cur = first_limit_;
    ::setrlimit(RLIMIT_DATA, &limit);
    limit.rlim_cur = memory_for(reading);
    ::setrlimit(RLIMIT_DATA, &limit);
  }

  const std::filesystem::path library_;
  const int socket_;
  const rlim_t first_limit_ = memory_limit();
  std::vector<LoadedImporter> importers_;
  bool is_confined_ = false;
};

}  // namespace

void serve(const std::filesystem::path& library, int socket) {
  Server server(library, socket);
  bool goes_on = server.load();
  for (foreign::Incoming incoming; goes_on && incoming.receive(socket, {}, max_bytes) == foreign::Received::all;)
    goes_on = server.answer(incoming.take());
}

// The following code runs in the main program.

// What to do about a file that takes too much; `key` is the parameter that allows more.
std::string cures(const Reading& reading, const std::string& key) {
  return "is the file whole? export it again, or its parts in files of their own, or ask for coarser facets or a "
         "smaller scale; " +
         reading.name + ":" + key + " allows more";
}

class Process {
 public:
  explicit Process(std::filesystem::path library) : library_(std::move(library)) {}

  std::vector<ImporterTable> start(double seconds) {
    const std::lock_guard lock(mutex_);
    seconds_ = seconds;
    return start();
  }

  bool recognises(const std::string& name, std::string_view first_bytes) {
    const std::lock_guard lock(mutex_);
    Packer question;
    question(Question::recognise), question(name);
    question(std::vector<unsigned char>(first_bytes.begin(), first_bytes.end()));
    process_.send(question);
    const std::string message = process_.receive_within(seconds_, max_bytes);
    Unpacker unpack(message);
    foreign::expect_no_reason(unpack);
    int answer = 0;
    unpack(answer);
    return answer != 0;
  }

  ImportedFile read(const std::string& name, const Reading& reading, const std::function<void(double)>& tell,
                    const Progress& progress) {
    const std::lock_guard lock(mutex_);
    if (reading.is_confined != 0) expect_confinable(reading.readable);
    Packer question;
    question(Question::read), question(name), pack_reading(question, reading);
    process_.send(question);
    Patience patience(process_, reading, progress);
    while (true) {
      const std::string message = next(reading, progress, patience);
      Unpacker unpack(message);
      Answer answer{};
      unpack(answer);
      if (answer == Answer::progress) {
        double done = 0;
        unpack(done);
        tell(done);
        patience.see(done);
        continue;
      }
      if (answer == Answer::document) return checked(unpack_file(unpack));
      ErrorKind kind{};
      std::string reason;
      unpack(kind), unpack(reason);
      throw Error(kind == ErrorKind::input ? ErrorKind::input : ErrorKind::plugin, "", reason);
    }
  }

 private:
  /// Ends when nothing has been done for a while, in which the process had a processor or slept: what is read does not
  /// depend on what else runs. With a time limit, that is what the user wants to wait for.
  class Patience {
   public:
    Patience(const foreign::ChildProcess& process, const Reading& reading, const Progress& progress)
        : process_(process), seconds_(progress.is_limited() ? 0 : reading.bounds.patience) {}
    void see(double done) {
      if (!(done >= done_ + min_progress)) return;
      done_ = done;
      since_ = Clock::now();
      waited_ = process_.waited_for_processor();
    }
    [[nodiscard]] bool is_at_its_end() const {
      const double passed = std::chrono::duration<double>(Clock::now() - since_).count();
      return seconds_ > 0 && passed > seconds_ && passed - (process_.waited_for_processor() - waited_) > seconds_;
    }

   private:
    const foreign::ChildProcess& process_;
    double seconds_, done_ = 0;
    Clock::time_point since_ = Clock::now();
    double waited_ = process_.waited_for_processor();
  };

  std::vector<ImporterTable> start() {
    process_.run(own_folder() / "epura-importer", {library_.string()});
    return process_.receive_loaded(seconds_, max_bytes, unpack_tables);
  }

  // A process that is confined for one file is confined for ever.
  void expect_confinable(const std::vector<std::filesystem::path>& readable) {
    if (confined_to_ && (readable.empty() || *confined_to_ != readable)) start();
    confined_to_ = readable;
  }

  static ImportedFile checked(ImportedFile document) {
    expect_sound_file(document);
    return document;
  }

  /// Waits for the next message, and checks time limits meanwhile. Throws OutOfTime and Stopped after ending the
  /// process, and Error{input} without a place if the file takes too much.
  std::string next(const Reading& reading, const Progress& progress, const Patience& patience) {
    constexpr auto look = std::chrono::milliseconds(50);
    while (true) {
      // Also between messages without a pause.
      const bool has_patience = !patience.is_at_its_end();
      if (progress.is_out_of_time() || !has_patience) process_.end();
      progress.expect_time();
      if (!has_patience)
        throw Error(ErrorKind::input, "",
                    "reading it makes no progress for " + format_rounded(reading.bounds.patience, 3) + " s",
                    cures(reading, "patience=SECONDS"));
      if (auto message = received(Clock::now() + look, reading)) return *std::move(message);
    }
  }

  static std::string allowance_of(const Reading& reading) {
    const rlim_t allowed = memory_for(reading);
    if (allowed == RLIM_INFINITY) return "";
    return ": it may take " + format_rounded(static_cast<double>(allowed) / 1e9, 3) + " GB";
  }

  std::optional<std::string> received(Clock::time_point until, const Reading& reading) {
    try {
      return process_.receive(until, max_bytes);
    } catch (const Error&) {
      if (!process_.lacked_memory()) throw;
      throw Error(ErrorKind::input, "", "reading it runs out of memory" + allowance_of(reading),
                  cures(reading, "memory=GB"));
    }
  }

  const std::filesystem::path library_;
  std::mutex mutex_;
  double seconds_ = loading_seconds;
  std::optional<std::vector<std::filesystem::path>> confined_to_;
  foreign::ChildProcess process_;
};

std::vector<std::filesystem::path> readable_for(const std::filesystem::path& file, bool allow_outside) {
  if (allow_outside) return {"/"};
  return {std::filesystem::absolute(file).parent_path(), file};
}

bool ImporterEntry::recognises(std::string_view first_bytes) const {
  try {
    return table.has_mark != 0 && process->recognises(table.name, first_bytes);
  } catch (const Error& error) {
    throw Error(ErrorKind::plugin, library.string(), "'" + table.name + "' " + error.what());
  }
}

ImportedFile ImporterEntry::read(const Reading& reading, const std::function<void(double)>& tell,
                                 const Progress& progress) const {
  try {
    return process->read(table.name, reading, tell, progress);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::input) throw Error(ErrorKind::input, reading.name, error.what(), error.hint());
    throw Error(ErrorKind::plugin, library.string(), "'" + table.name + "' " + error.what() + " at " + reading.name);
  }
}

static void add_bounds(std::vector<foreign::Parameter>& parameters) {
  for (foreign::Parameter& row : parameters_of_bounds()) {
    for (const foreign::Parameter& own : parameters)
      foreign::require(own.name != row.name, "has a parameter '" + row.name + "', a name that epura uses itself");
    parameters.push_back(std::move(row));
  }
}

std::vector<ImporterEntry> importers_of(const std::filesystem::path& library, double seconds) {
  const auto process = std::make_shared<Process>(library);
  std::vector<ImporterEntry> entries;
  for (ImporterTable& table : process->start(seconds)) {
    add_bounds(table.parameters);
    entries.push_back({std::move(table), library, process});
  }
  return entries;
}

}  // namespace epura::importer
