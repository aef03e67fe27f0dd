// SPDX-License-Identifier: Apache-2.0
// How far the work is, told to epura while Open CASCADE does it.
#pragma once

#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressRange.hxx>
#include <algorithm>
#include <epura/importer_plugin.hpp>

namespace epura_occt {

/// Part of the work, from one share of it to another. Open CASCADE's threads may tell at any time, never two at once.
class Watch : public Message_ProgressIndicator {
 public:
  explicit Watch(epura::plugin::Sink& sink) : sink_(sink) {}

  /// What begins now takes the run from here to there, 0 to 1. Throws Cancelled.
  Message_ProgressRange begin(double from, double to) {
    from_ = from;
    to_ = to;
    expect_wanted();
    return Start();
  }
  void expect_wanted() const {
    if (is_cancelled_) throw epura::plugin::Cancelled{};
  }

  void Show(const Message_ProgressScope&, const Standard_Boolean) override {
    const double done = from_ + (to_ - from_) * std::clamp(GetPosition(), 0.0, 1.0);
    if (done < told_ + 0.01 || is_cancelled_) return;
    told_ = done;
    try {
      sink_.progress(done);
    } catch (const epura::plugin::Cancelled&) {
      is_cancelled_ = true;  // an exception must not cross the threads of Open CASCADE
    }
  }
  Standard_Boolean UserBreak() override { return is_cancelled_; }

 private:
  epura::plugin::Sink& sink_;
  double from_ = 0, to_ = 1, told_ = -1;
  bool is_cancelled_ = false;
};

}  // namespace epura_occt
