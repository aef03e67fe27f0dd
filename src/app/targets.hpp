// The files to be written.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/options.hpp"
#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "output/write.hpp"
#include "sheet/paper.hpp"

namespace epura {

struct Target {
  std::string path;  ///< "-" for standard output
  Format format;
};

/// Formats are settled before any work is done: a long run must not end in a typing error. Throws Error{input}.
std::vector<Target> targets_of(const DrawOptions& options);

/// A sheet, and what JSON says of it beside.
struct FinishedSheet {
  Sheet sheet;
  double scale = 1;                     ///< main scale, mm of paper per unit of the world
  std::vector<Drawing> drawings{};      ///< in order of the views; none where no target wants them
  std::vector<std::string> warnings{};  ///< what of it is not as was wished
  Paper paper{};
};

/// Marks a sheet that lacks something since time was over in a stage; once more by another stage.
void mark_partial(FinishedSheet& sheet, const std::string& stage);

/// x-2.svg for x.svg.
std::string numbered(const std::string& path, std::size_t number);

struct FileBytes {
  std::string path, bytes;
};

/// PDF and PostScript have one file for all sheets, the other formats one for each: x-1.svg, x-2.svg where there are
/// several. Throws OutOfTime.
std::vector<FileBytes> encode_all(const std::vector<Target>& targets, std::span<const FinishedSheet> sheets,
                                  const VectorOptions& options, const Report& report, Progress progress);

/// Throws Error{output}.
void write(const FileBytes& file, Progress progress);

}  // namespace epura
