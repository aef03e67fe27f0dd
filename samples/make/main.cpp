// SPDX-License-Identifier: Apache-2.0
// make_samples FOLDER writes the sample models; make_samples --check tells whether they are sound.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "check.hpp"
#include "parts.hpp"
#include "write.hpp"

namespace samples {

const std::vector<Part>& all_parts() {
  static const std::vector<Part> parts = {
      {"bearing.obj", bearing, true}, {"bracket.obj", bracket, true}, {"cylinders.obj", cylinders, true},
      {"elbow.obj", elbow, true},     {"flange.obj", flange, true},   {"gear.stl", gear, true},
      {"house.obj", house, true},     {"shaft.obj", shaft, true},     {"sombrero.obj", sombrero, false},
      {"stairs.obj", stairs, true},
  };
  return parts;
}

namespace {

bool check(const Part& part) {
  const Model model = part.make();
  std::size_t points = 0, faces = 0;
  double enclosed = 0;
  for (const Solid& solid : model) {
    points += solid.points().size();
    faces += solid.faces().size();
    enclosed += part.closed ? volume(solid) : 0;
  }
  std::printf("%-14s %2zu bodies %5zu points %5zu faces %14.0f mm3\n", part.file.c_str(), model.size(), points, faces,
              enclosed);
  const std::vector<std::string> found = faults(model, part.closed);
  for (const std::string& fault : found) {
    std::printf("  %s\n", fault.c_str());
  }
  return found.empty();
}

void write(const Part& part, const std::filesystem::path& folder) {
  const Model model = part.make();
  const std::filesystem::path path = folder / part.file;
  std::ofstream file(path, std::ios::binary);
  file << (path.extension() == ".stl" ? to_stl(model) : to_obj(model));
  if (!file.flush()) {
    throw std::runtime_error("could not write " + path.string());
  }
}

int run(const std::string& argument) {
  bool sound = true;
  for (const Part& part : all_parts()) {
    if (argument == "--check") {
      sound = check(part) && sound;
    } else {
      write(part, argument);
    }
  }
  return sound ? 0 : 1;
}

}  // namespace

}  // namespace samples

int main(int count, char** arguments) try {
  if (count != 2) {
    std::fputs("usage: make_samples FOLDER | --check\n", stderr);
    return 2;
  }
  return samples::run(arguments[1]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "make_samples: %s\n", error.what());
  return 1;
}
