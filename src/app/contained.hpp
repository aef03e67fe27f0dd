// Foreign code at arm's length.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace epura {

/// How work in a process of its own ended.
struct Contained {
  std::optional<int> code;  ///< what it returned; nothing if it did not come to that
  std::string trouble;      ///< otherwise: "crashes (Aborted)", "ends the program", "takes more than 10 s"
};

/// Runs `work` in a child process, which is ended after so many `seconds`; what it prints appears. To be called while
/// the process has one thread.
Contained run_contained(const std::function<int()>& work, double seconds);

/// Whether loading the plugin crashes or takes longer: how, or nothing. That it may be no plugin is another matter.
std::string trouble_with_loading(const std::filesystem::path& plugin, double seconds);

}  // namespace epura
