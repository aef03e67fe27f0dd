// SPDX-License-Identifier: Apache-2.0
#include "session.hpp"

#include <Message.hxx>
#include <Message_Messenger.hxx>

namespace occt {

Handle(Complaints) Complaints::install() {
  Handle(Complaints) complaints = new Complaints;
  complaints->SetTraceLevel(Message_Fail);
  Message::DefaultMessenger()->ChangePrinters().Clear();
  Message::DefaultMessenger()->AddPrinter(complaints);
  return complaints;
}

void Complaints::send(const TCollection_AsciiString& text, Message_Gravity gravity) const {
  if (gravity < Message_Fail || !first_.empty()) return;
  for (const char* c = text.ToCString(); *c != '\0'; ++c) {
    const bool is_space = *c == ' ' || *c == '\n' || *c == '\t' || *c == '\r';
    if (!is_space) {
      first_ += *c;
    } else if (!first_.empty() && first_.back() != ' ') {
      first_ += ' ';
    }
  }
  while (!first_.empty() && (first_.back() == ' ' || first_.back() == '.')) first_.pop_back();
}

void Stage::Show(const Message_ProgressScope&, bool) {
  if (std::this_thread::get_id() != thread_ || is_cancelled_) return;
  const double done = from_ + GetPosition() * (to_ - from_);
  if (done - shown_ < 0.01) return;
  shown_ = done;
  try {
    sink_.progress(done);
  } catch (const epura::plugin::Cancelled&) {
    // Leaving Open CASCADE's functions through UserBreak, because not all of them can handle a foreign exception.
    is_cancelled_ = true;
  }
}

}  // namespace occt
