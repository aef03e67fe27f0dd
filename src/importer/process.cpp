// SPDX-License-Identifier: Apache-2.0
#include "importer/process.hpp"

#include <fcntl.h>

#include <chrono>
#include <csignal>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/shared_library.hpp"
#include "foreign/child_process.hpp"
#include "foreign/messages.hpp"
#include "foreign/sandbox.hpp"

namespace epura::importer {

namespace {

using foreign::Clock;
using foreign::Packer;
using foreign::Unpacker;

/// Only a corrupted process sends longer messages.
constexpr std::size_t most_bytes = std::size_t{1} << 36;

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
      const Document document = read_by(importer, reading, tell);
      answer(Answer::document);
      pack_document(answer, document);
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

  const std::filesystem::path library_;
  const int socket_;
  std::vector<LoadedImporter> importers_;
  bool is_confined_ = false;
};

}  // namespace

void serve(const std::filesystem::path& library, int socket) {
  Server server(library, socket);
  bool goes_on = server.load();
  for (foreign::Incoming incoming; goes_on && incoming.receive(socket, {}, most_bytes) == foreign::Received::all;)
    goes_on = server.answer(incoming.take());
}

// The following code runs in the main program.

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
    const std::string message = next({}, {});
    Unpacker unpack(message);
    foreign::expect_no_reason(unpack);
    int answer = 0;
    unpack(answer);
    return answer != 0;
  }

  Document read(const std::string& name, const Reading& reading, const std::function<void(double)>& tell,
                const Progress& progress) {
    const std::lock_guard lock(mutex_);
    if (reading.is_confined != 0) expect_confinable(reading.readable);
    Packer question;
    question(Question::read), question(name), pack_reading(question, reading);
    process_.send(question);
    while (true) {
      const std::string message = next(progress, [this] { process_.end(); });
      Unpacker unpack(message);
      Answer answer{};
      unpack(answer);
      if (answer == Answer::progress) {
        double done = 0;
        unpack(done);
        tell(done);
        continue;
      }
      if (answer == Answer::document) return checked(unpack_document(unpack));
      ErrorKind kind{};
      std::string reason;
      unpack(kind), unpack(reason);
      throw Error(kind == ErrorKind::input ? ErrorKind::input : ErrorKind::plugin, "", reason);
    }
  }

 private:
  std::vector<ImporterTable> start() {
    process_.run(own_folder() / "epura-importer", {library_.string()});
    return process_.receive_loaded(seconds_, most_bytes, unpack_tables);
  }

  // A process that is confined for one file is confined for ever.
  void expect_confinable(const std::vector<std::filesystem::path>& readable) {
    if (confined_to_ && (readable.empty() || *confined_to_ != readable)) start();
    confined_to_ = readable;
  }

  static Document checked(Document document) {
    expect_sound(document);
    return document;
  }

  /// Waits for the next message, and checks the time limit meanwhile. Throws OutOfTime after calling `end`, and
  /// Stopped.
  std::string next(const Progress& progress, const std::function<void()>& end) {
    constexpr auto look = std::chrono::milliseconds(50);
    while (true) {
      if (auto message = process_.receive(Clock::now() + look, most_bytes)) return *std::move(message);
      if (end && progress.is_out_of_time()) end();
      progress.expect_time();
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

Document ImporterEntry::read(const Reading& reading, const std::function<void(double)>& tell,
                             const Progress& progress) const {
  try {
    return process->read(table.name, reading, tell, progress);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::input) throw Error(ErrorKind::input, reading.name, error.what());
    throw Error(ErrorKind::plugin, library.string(), "'" + table.name + "' " + error.what() + " at " + reading.name);
  }
}

std::vector<ImporterEntry> importers_of(const std::filesystem::path& library, double seconds) {
  const auto process = std::make_shared<Process>(library);
  std::vector<ImporterEntry> entries;
  for (ImporterTable& table : process->start(seconds)) entries.push_back({std::move(table), library, process});
  return entries;
}

}  // namespace epura::importer
