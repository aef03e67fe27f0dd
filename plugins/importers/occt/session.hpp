// SPDX-License-Identifier: Apache-2.0
// Confines Open CASCADE: its messages are kept, its exceptions become std::runtime_error, and its progress goes to the
// sink.
#pragma once

#include <Message_Printer.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Standard_Failure.hxx>
#include <atomic>
#include <epura/importer_plugin.hpp>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>

namespace occt {

/// Replaces Open CASCADE's printers, and keeps the line of the file that the first complaint names.
class Complaints : public Message_Printer {
  DEFINE_STANDARD_RTTI_INLINE(Complaints, Message_Printer)

 public:
  /// Silences Open CASCADE in this process.
  static Handle(Complaints) install();

  /// "" if no complaint names one.
  [[nodiscard]] const std::string& line() const { return line_; }

 protected:
  void send(const TCollection_AsciiString& text, Message_Gravity gravity) const override;

 private:
  mutable std::string line_;
};

/// During its lifetime, output that Open CASCADE writes directly to std::cout and std::cerr is discarded.
class Silence {
 public:
  Silence() : out_(std::cout.rdbuf(nullptr)), error_(std::cerr.rdbuf(nullptr)) {}
  ~Silence() {
    std::cout.rdbuf(out_);
    std::cerr.rdbuf(error_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  std::streambuf *out_, *error_;
};

/// Reports a stage of the work, from one share of the whole to another, and stops it at the host's request.
class Stage : public Message_ProgressIndicator {
  DEFINE_STANDARD_RTTI_INLINE(Stage, Message_ProgressIndicator)

 public:
  Stage(epura::plugin::Sink& sink, double from, double to)
      : sink_(sink), from_(from), to_(to), shown_(from), thread_(std::this_thread::get_id()) {}

  /// To be called after the work: throws epura::plugin::Cancelled if it was stopped.
  void finish() const {
    if (is_cancelled_) throw epura::plugin::Cancelled();
  }

 protected:
  bool UserBreak() override { return is_cancelled_; }
  void Show(const Message_ProgressScope& scope, bool is_forced) override;

 private:
  epura::plugin::Sink& sink_;
  double from_, to_, shown_;
  std::thread::id thread_;  ///< the only one that may call the sink
  std::atomic<bool> is_cancelled_ = false;
};

/// Calls `work`; exceptions of Open CASCADE become a sentence.
template <class Work>
auto guarded(const std::string& what, Work&& work) {
  try {
    return work();
  } catch (const Standard_Failure&) {  // its words are those of a library
    throw std::runtime_error(what +
                             ": Open CASCADE gives up on a shape in it, which may be damaged, or on facets as fine "
                             "as this scale asks for");
  }
}

}  // namespace occt
