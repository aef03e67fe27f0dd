// SPDX-License-Identifier: Apache-2.0
#include "session.hpp"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <algorithm>
#include <string_view>

namespace occt {

Handle(Complaints) Complaints::install() {
  Handle(Complaints) complaints = new Complaints;
  complaints->SetTraceLevel(Message_Fail);
  Message::DefaultMessenger()->ChangePrinters().Clear();
  Message::DefaultMessenger()->AddPrinter(complaints);
  return complaints;
}

void Complaints::send(const TCollection_AsciiString& text, Message_Gravity gravity) const {
  if (gravity < Message_Fail || !line_.empty()) return;
  const std::string_view complaint = text.ToCString();
  constexpr std::string_view word = "line ";
  const std::size_t found = complaint.find(word);
  if (found == std::string_view::npos) return;
  const std::string_view rest = complaint.substr(found + word.size());
  line_ = rest.substr(0, std::min(rest.find_first_not_of("0123456789"), rest.size()));
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
