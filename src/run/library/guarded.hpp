// SPDX-License-Identifier: Apache-2.0
// Converts exceptions to the one type that the library throws.
#pragma once

#include <cxxabi.h>

#include <epura/epura.hpp>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include "base/error.hpp"
#include "base/progress.hpp"

namespace epura {

template <class Work>
auto guarded(const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw Failure(static_cast<Failure::Kind>(error.kind()), error.where(), error.what(), error.hint());
  } catch (const OutOfTime& cut) {
    throw Failure(Failure::Kind::time, "settings.time_limit",
                  "time ran out at '" + cut.stage + "', before there was anything to show", "allow more time");
  } catch (const Stopped&) {
    throw Failure(Failure::Kind::stopped, "settings.stop", "the call was stopped", "");
  } catch (const std::bad_alloc&) {
    throw Failure(Failure::Kind::input, "", "not enough memory for this model", "");
  } catch (const std::logic_error& error) {
    throw Failure(Failure::Kind::broken, "", std::string("internal error: this does not hold: ") + error.what(),
                  "the fault is in epura " EPURA_VERSION
                  ", not in the input; to report it, send the scene with its models");
  } catch (const std::exception& error) {
    throw Failure(Failure::Kind::input, "", error.what(), "");
  } catch (const abi::__forced_unwind&) {
    throw;  // the thread is being cancelled
  } catch (...) {
    throw Failure(Failure::Kind::input, "settings", "a function of the program throws what is no std::exception",
                  "let 'progress' and projections of your own throw nothing, or what derives from std::exception");
  }
}

}  // namespace epura
