// What the command line asks for, as text and plain values.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace epura {

struct DrawOptions {
  std::vector<std::string> models;
  std::vector<std::string> outputs;  ///< "-" is standard output
  std::string format;                ///< of "-"
  std::string projection = "isometric";
  std::vector<std::filesystem::path> plugin_path;
  std::vector<std::string> transforms;
  std::string unit = "mm";
  std::string up = "z";
  std::string sheet = "A4";
  bool portrait = false;
  std::string scale = "fit";
  std::string title;
  std::string hidden = "dashed";
  std::string edges = "contour,crease,boundary,intersection";
  double crease_angle = 30;
  std::string visibility = "exact";
  std::optional<double> near, far, contact;
  double dpi = 300;
  int threads = 0;
  bool plain = false;
  bool timings = false;
  std::vector<std::string> why;  ///< edges to explain
  std::string dump;              ///< table to print: "edges", "spans" or none
  std::string progress = "auto";
  std::optional<double> time_limit;  ///< seconds
  bool verify = false;
  int verify_samples = 2000;
};

struct PluginsOptions {
  std::string name;  ///< empty: list all
  std::vector<std::filesystem::path> plugin_path;
};

}  // namespace epura
