// SPDX-License-Identifier: Apache-2.0
#include "projection/plugin_process.hpp"

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "foreign/child_process.hpp"
#include "foreign/messages.hpp"
#include "foreign/sandbox.hpp"
#include "projection/answer.hpp"
#include "projection/loader.hpp"

namespace epura::projection {

namespace {

using foreign::Packer;
using foreign::Received;
using foreign::Unpacker;

/// Longer messages are sent only by a damaged process.
constexpr std::size_t max_bytes = std::size_t{1} << 28;

// One function for both directions, so that values are unpacked as they were packed.

template <class Pack, class Entry>
void pack_entry(Pack& pack, Entry& entry) {
  pack(entry.name), pack(entry.family), pack(entry.summary), pack(entry.reference);
}

struct Question {
  std::string projection;
  std::vector<double> values;
  Box scene;
};

template <class Pack, class Words>
void pack_question(Pack& pack, Words& question) {
  pack(question.projection), pack(question.values), pack(question.scene);
}

void pack_table(Packer& pack, const std::vector<ProjectionEntry>& entries) {
  pack(entries.size());
  for (const ProjectionEntry& entry : entries) {
    pack_entry(pack, entry);
    pack(entry.parameters.size());
    for (const Parameter& parameter : entry.parameters) foreign::pack_parameter(pack, parameter);
  }
}

std::vector<ProjectionEntry> unpack_table(Unpacker& unpack) {
  std::vector<ProjectionEntry> entries(unpack.count(1));
  for (ProjectionEntry& entry : entries) {
    pack_entry(unpack, entry);
    entry.parameters.resize(unpack.count(1));
    for (Parameter& parameter : entry.parameters) foreign::pack_parameter(unpack, parameter);
  }
  return entries;
}

void pack_answer(Packer& pack, const PluginAnswer& answer) {
  pack(answer.view), pack(int{answer.refusal.has_value()}), pack(answer.refusal.value_or(""));
}

PluginAnswer unpack_answer(Unpacker& unpack) {
  PluginAnswer answer{};
  int is_refused = 0;
  std::string sentence;
  unpack(answer.view), unpack(is_refused), unpack(sentence);
  if (is_refused != 0) answer.refusal = sentence;
  return answer;
}

// The following functions run in the process of the plugin.

PluginAnswer answer_to(const std::string& words, const std::vector<ProjectionEntry>& entries) {
  Question question;
  Unpacker unpack(words);
  pack_question(unpack, question);
  for (const ProjectionEntry& entry : entries)
    if (entry.name == question.projection) return entry.ask(question.values, question.scene);
  throw Error(ErrorKind::plugin, "", "no longer exists");
}

/// The plugin prints to where messages go, since standard output may receive a drawing. It crashes as if the program
/// had no signal handlers.
void take_precautions() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::signal(crash, SIG_DFL);
}

void serve(const std::filesystem::path& path, Confinement confinement, int socket) {
  take_precautions();
  std::vector<ProjectionEntry> entries;
  bool goes_on = foreign::send_message(socket, foreign::message_or_reason([&](Packer& message) {
                                         if (confinement == Confinement::sandbox)
                                           foreign::enter_sandbox({{path.parent_path()}, {}, {}});
                                         entries = read_plugin(path);
                                         pack_table(message, entries);
                                       }));
  for (foreign::Incoming words; goes_on && words.receive(socket, {}, max_bytes) == Received::all;)
    goes_on = foreign::send_message(socket, foreign::message_or_reason([&](Packer& message) {
                                      pack_answer(message, answer_to(words.take(), entries));
                                    }));
}

// The following functions run in the program.

/// The plugin's process as seen by the program.
class PluginProcess {
 public:
  PluginProcess(std::filesystem::path path, double seconds, Confinement confinement)
      : path_(std::move(path)), seconds_(seconds), confinement_(confinement) {}

  std::vector<ProjectionEntry> table() {
    const std::lock_guard lock(mutex_);
    return start();
  }
  PluginAnswer ask(const Question& question) {
    const std::lock_guard lock(mutex_);
    if (!process_.is_there()) start();
    try {
      return ask_process(question);
    } catch (const Error&) {
      // The process ends with the thread that started it, perhaps in this moment.
      if (process_.is_there() || started_by_ == ::gettid()) throw;
    }
    start();
    return ask_process(question);
  }
  void rest() {
    const std::lock_guard lock(mutex_);
    process_.end();
  }

 private:
  std::vector<ProjectionEntry> start();
  PluginAnswer ask_process(const Question& question);

  const std::filesystem::path path_;
  const double seconds_;
  const Confinement confinement_;
  std::mutex mutex_;
  foreign::ChildProcess process_;
  pid_t started_by_ = 0;  ///< the thread
};

std::vector<ProjectionEntry> PluginProcess::start() {
  process_.fork([this](int socket) { serve(path_, confinement_, socket); });
  started_by_ = ::gettid();
  return process_.receive_loaded(seconds_, max_bytes, unpack_table);
}

PluginAnswer PluginProcess::ask_process(const Question& question) {
  Packer words;
  pack_question(words, question);
  process_.send(words);
  const std::string message = process_.receive_within(seconds_, max_bytes);
  Unpacker unpack(message);
  foreign::expect_no_reason(unpack);
  return unpack_answer(unpack);
}

}  // namespace

std::vector<ProjectionEntry> read_plugin_apart(const std::filesystem::path& path, Afterwards afterwards, double seconds,
                                               Confinement confinement) {
  const auto process = std::make_shared<PluginProcess>(path, seconds, confinement);
  std::vector<ProjectionEntry> entries = process->table();
  if (afterwards == Afterwards::rests) process->rest();
  for (ProjectionEntry& entry : entries) {
    entry.plugin = path;
    entry.ask = [process, name = entry.name](const std::vector<double>& values, const Box& scene) {
      return process->ask({name, values, scene});
    };
  }
  return entries;
}

}  // namespace epura::projection
