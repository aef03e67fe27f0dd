// SPDX-License-Identifier: Apache-2.0
#include "importer/read_model.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <new>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "importer/catalogue.hpp"
#include "mesh/read.hpp"
#include "mesh/subdivide.hpp"

namespace epura::importer {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t mark_bytes = 4096;

std::string extension_of(const fs::path& path) {
  const std::string dotted = to_lower(path.extension().string());
  return dotted.empty() ? dotted : dotted.substr(1);
}

/// A file on disk or in memory.
struct Source {
  fs::path path;
  std::string name;                    ///< by which errors call it
  const std::string* bytes = nullptr;  ///< in memory
};

/// A file without a name in a file system that has the bytes, for importers, which read paths.
class NamelessFile {
 public:
  explicit NamelessFile(const std::string& bytes) : descriptor_(::memfd_create("epura", MFD_CLOEXEC)) {
    for (std::size_t written = 0; written < bytes.size();) {
      const ssize_t count = ::write(descriptor_, bytes.data() + written, bytes.size() - written);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) throw std::bad_alloc();
      written += static_cast<std::size_t>(count);
    }
  }
  NamelessFile(const NamelessFile&) = delete;
  NamelessFile& operator=(const NamelessFile&) = delete;
  ~NamelessFile() { ::close(descriptor_); }
  /// Also for other processes.
  [[nodiscard]] std::string path() const {
    return "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(descriptor_);
  }

 private:
  int descriptor_;
};

// At most `mark_bytes`. Throws like read_file if there is nothing to read.
std::string first_bytes_of(const fs::path& path) {
  std::string bytes(mark_bytes, 0);
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  if (bytes.empty() && read_file(path, {}, mark_bytes).empty())
    throw Error(ErrorKind::input, path.string(), "is empty");
  return bytes;
}

const ImporterEntry* importer_by_content(const Catalogue& catalogue, const Source& source) {
  const std::string bytes = source.bytes != nullptr ? source.bytes->substr(0, mark_bytes) : first_bytes_of(source.path);
  for (const ImporterEntry& entry : catalogue.entries)
    if (entry.recognises(bytes)) return &entry;
  return nullptr;
}

// The first one; null if there is none.
const ImporterEntry* importer_by_extension(const Catalogue& catalogue, const std::string& extension) {
  for (const ImporterEntry& entry : catalogue.entries)
    if (std::find(entry.table.extensions.begin(), entry.table.extensions.end(), extension) !=
        entry.table.extensions.end())
      return &entry;
  return nullptr;
}

// The first importer for the extension, otherwise the first one that recognises the content.
const ImporterEntry* importer_for(const Catalogue& catalogue, const std::string& extension, const Source& source) {
  const ImporterEntry* named = importer_by_extension(catalogue, extension);
  return named != nullptr ? named : importer_by_content(catalogue, source);
}

// ".step, .stp, .glb"
std::string extensions_in(const Catalogue& catalogue) {
  std::string text;
  for (const ImporterEntry& entry : catalogue.entries)
    for (const std::string& extension : entry.table.extensions) text += (text.empty() ? "." : ", .") + extension;
  return text;
}

[[noreturn]] void throw_missing(const std::string& name, const std::string& extension, const Catalogue& catalogue) {
  std::string hint = "install the package " + std::string(package_for(extension));
  for (const foreign::BadPlugin& bad : catalogue.bad) hint += "\n" + bad.path.string() + ": " + bad.reason;
  throw Error(ErrorKind::input, name, "no importer for '." + extension + "' is installed", hint);
}

/// Reports progress in bytes of the file: once while the importer reads, once more when the mesh is complete.
class Advance {
 public:
  Advance(const Progress& progress, std::size_t bytes) : progress_(progress), bytes_(static_cast<double>(bytes)) {}
  void to(double done) {
    const auto reached = static_cast<std::size_t>(done * bytes_);
    if (reached <= told_) return;
    progress_.advance(reached - told_);
    told_ = reached;
  }

 private:
  const Progress& progress_;
  double bytes_;
  std::size_t told_ = 0;
};

// The parts of the bodies of a mesh, which are numbered otherwise than the names in the file.
std::vector<BodyPart> parts_of_bodies(const mesh::Mesh& mesh, const std::vector<int>& name_of_polygon,
                                      const std::vector<BodyPart>& parts) {
  std::vector<BodyPart> of_bodies(static_cast<std::size_t>(mesh.report.bodies));
  for (int t = 0; t < mesh.triangle_count(); ++t) of_bodies[mesh.body[t]] = parts[name_of_polygon[mesh.polygon[t]]];
  return of_bodies;
}

// Of glTF, most of the model is in files of this extension beside it.
constexpr std::string_view buffers = ".bin";

std::uintmax_t bytes_of(const fs::path& path) {
  std::error_code unknown;
  const std::uintmax_t bytes = fs::file_size(path, unknown);
  return unknown ? 0 : bytes;
}

std::uintmax_t bytes_of_buffers_beside(const fs::path& path) {
  std::uintmax_t bytes = 0;
  std::error_code unknown;
  for (fs::directory_iterator at(fs::absolute(path).parent_path(), unknown), end; !unknown && at != end;
       at.increment(unknown))
    if (at->path().extension() == buffers) bytes += bytes_of(at->path());
  return bytes;
}

ReadModel read_by_importer(const ImporterEntry& importer, const Source& source, const foreign::Assignments& parameters,
                           const ReadOptions& options, const Progress& progress) {
  std::optional<NamelessFile> file;
  if (source.bytes != nullptr) file.emplace(*source.bytes);
  const fs::path path = file ? fs::path(file->path()) : source.path;
  const std::uintmax_t bytes = bytes_of(path),
                       all_bytes =
                           bytes + (file || extension_of(source.name) != "gltf" ? 0 : bytes_of_buffers_beside(path));
  const foreign::ParameterValues values =
      foreign::values_of(importer.table.parameters, parameters, importer.table.name, "importer");
  const Reading reading{
      .path = path,
      .name = source.name,
      .values = foreign::flattened(values),
      .tolerance = options.tolerance,
      .relative_tolerance = options.relative_tolerance,
      .threads = options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency()),
      .may_leave = options.allow_outside ? 1 : 0,
      .is_confined = options.is_confined ? 1 : 0,
      .bounds = given_bounds(values, bounds_for(all_bytes)),
      .readable = file ? std::vector<fs::path>() : readable_for(source.path, options.allow_outside)};
  Advance advance(progress, bytes);
  const ImportedFile document = importer.read(
      reading, [&](double done) { advance.to(done); }, progress);
  advance.to(1);
  try {
    Assembled assembled = assemble(document, importer.table.name);
    const std::vector<int> name_of_polygon = assembled.soup.face_body;
    ReadModel model{mesh::make_mesh(std::move(assembled.soup), source.name, progress, assembled.step)};
    model.body_parts = parts_of_bodies(model.mesh, name_of_polygon, assembled.body_parts);
    if (!assembled.part.faces.empty())
      model.part = std::make_shared<surfaces::PartFaces>(
          surfaces::part_of(model.mesh, assembled.part, surfaces::RecogniseOptions().tangent_angle));
    model.requirements = requirements_of(document, assembled, model.mesh, model.part.get());
    model.saved_views = document.saved_views;
    model.standard = document.standard;
    if (document.unit > 0) model.unit = document.unit;
    model.is_y_up = document.is_y_up != 0;
    model.tree = std::move(assembled.tree);
    advance.to(2);
    return model;
  } catch (const Error& error) {
    if (!error.where().empty()) throw;
    throw Error(error.kind(), source.name, error.what(), error.hint());
  }
}

// Nothing for what is read without a library; `others` then lists what libraries read, if the name does not tell the
// format.
std::optional<ReadModel> read_by_library(const Source& source, const foreign::Assignments& parameters,
                                         const ReadOptions& options, std::string& others, const Progress& progress) {
  const std::string extension = extension_of(source.name);
  std::error_code error;
  const bool is_readable = source.bytes != nullptr ? !source.bytes->empty() : fs::is_regular_file(source.path, error);
  if (mesh::format_named(extension) == nullptr && is_readable) {
    const Catalogue catalogue = load_catalogue(importer_folders(options.plugin_path));
    if (const ImporterEntry* importer = importer_for(catalogue, extension, source))
      return read_by_importer(*importer, source, parameters, options, progress);
    if (!package_for(extension).empty()) throw_missing(source.name, extension, catalogue);
    others = extensions_in(catalogue);
  }
  if (!parameters.empty() && mesh::format_named(extension) == nullptr)
    throw Error(ErrorKind::input, source.name + ":" + parameters.front().first,
                "files of this format have no parameters");
  return std::nullopt;
}

/// Parameters of mesh formats.
struct Subdivision {
  int steps = 0;
  double sharp = 180;  ///< degrees
};

Subdivision subdivision_of(const std::string& name, const foreign::Assignments& parameters) {
  constexpr int max_steps = 5;
  Subdivision subdivision;
  for (const auto& parameter : parameters) {
    const std::string &key = parameter.first, &text = parameter.second;
    const std::string where = name + ":" + key;
    const std::optional<double> value = parse_number(text);
    const auto expect = [&](bool is_so, const std::string& what) {
      if (!is_so) throw Error(ErrorKind::input, where, "is '" + text + "', allowed is " + what);
    };
    if (key == "subdivide") {
      expect(value && *value >= 0 && *value <= max_steps && *value == std::floor(*value),
             "a whole number from 0 to " + std::to_string(max_steps));
      subdivision.steps = static_cast<int>(*value);
    } else if (key == "sharp") {
      expect(value && *value >= 0 && *value <= 180, "0 to 180, degrees");
      subdivision.sharp = *value;
    } else {
      throw Error(ErrorKind::input, where, "mesh files have no parameter of this name",
                  "known: subdivide, the number of steps that round a mesh, and sharp, the fold in degrees from which "
                  "its edges stay");
    }
  }
  return subdivision;
}

ReadModel rounded(mesh::Mesh mesh, const Subdivision& subdivision, const Progress& progress) {
  constexpr long long max_triangles = 20'000'000;
  const std::string name = mesh.report.name;
  if (static_cast<long long>(mesh.triangle_count()) << (2 * subdivision.steps) > max_triangles)
    throw Error(ErrorKind::input, name + ":subdivide", "gives more than 20 million triangles", "use fewer steps");
  if (subdivision.steps > 0) mesh = mesh::subdivide(std::move(mesh), subdivision.steps, subdivision.sharp, progress);
  return {std::move(mesh)};
}

// A file of another format than its name says. Nothing if what it holds is not recognised.
std::optional<ReadModel> read_misnamed(const Source& source, const ReadOptions& options, const Progress& progress) {
  const std::string extension = extension_of(source.name);
  const Catalogue catalogue = load_catalogue(importer_folders(options.plugin_path));
  const ImporterEntry* const named = importer_by_extension(catalogue, extension);
  if (named == nullptr && mesh::format_named(extension) == nullptr) return std::nullopt;
  const auto noted = [&](ReadModel model, std::string_view holds) {
    model.mesh.report.notes.push_back("the file is named ." + extension + ", but holds " + std::string(holds));
    return model;
  };
  if (const ImporterEntry* importer = importer_by_content(catalogue, source)) {
    if (importer == named) return std::nullopt;
    return noted(read_by_importer(*importer, source, {}, options, progress), importer->table.name);
  }
  if (named == nullptr) return std::nullopt;
  const std::string bytes = read_file(source.path, progress);
  const mesh::Format* const format = mesh::format_in(bytes);
  if (format == nullptr) return std::nullopt;
  return noted({mesh::make_mesh(format->read(bytes, source.name, progress), source.name, progress)}, format->name);
}

bool is_assignment(std::string_view part) {
  const std::size_t equals = part.find('=');
  return equals != std::string_view::npos && foreign::is_plugin_name(part.substr(0, equals));
}

}  // namespace

ModelRequest parse_model_request(const std::string& text) {
  std::error_code error;
  if (fs::exists(text, error)) return {text, {}};
  const std::size_t slash = text.rfind('/');
  const std::size_t colon = text.find(':', slash == std::string::npos ? 0 : slash);
  if (colon == std::string::npos) return {text, {}};
  ModelRequest request{text.substr(0, colon), {}};
  for (const std::string_view part : split(std::string_view(text).substr(colon + 1), ':')) {
    if (!is_assignment(part)) return {text, {}};
    const std::size_t equals = part.find('=');
    const std::string key(part.substr(0, equals));
    for (const auto& [earlier, value] : request.parameters)
      if (earlier == key) throw Error(ErrorKind::input, request.path + ":" + key, "is given twice");
    request.parameters.emplace_back(key, part.substr(equals + 1));
  }
  return request;
}

ReadModel read_model(const fs::path& path, const foreign::Assignments& parameters, const ReadOptions& options,
                     const Progress& progress) {
  if (path == standard_input)
    return read_model(read_file("/dev/stdin", progress), "standard input", parameters, options, progress);
  const Source source{path, path.string()};
  try {
    std::string others;
    if (std::optional<ReadModel> model = read_by_library(source, parameters, options, others, progress))
      return *std::move(model);
    return rounded(mesh::read_mesh(path, progress, others), subdivision_of(path.string(), parameters), progress);
  } catch (const Error& error) {
    std::error_code unreadable;  // such as a name that is too long
    if (error.kind() != ErrorKind::input || !parameters.empty() || !fs::is_regular_file(path, unreadable)) throw;
    if (std::optional<ReadModel> model = read_misnamed(source, options, progress)) return *std::move(model);
    throw;
  }
}

ReadModel read_model(std::string bytes, const std::string& name, const foreign::Assignments& parameters,
                     const ReadOptions& options, const Progress& progress) {
  std::string others;
  if (std::optional<ReadModel> model = read_by_library({name, name, &bytes}, parameters, options, others, progress))
    return *std::move(model);
  const Subdivision subdivision = subdivision_of(name, parameters);
  return rounded(mesh::read_mesh(std::move(bytes), name, progress, others), subdivision, progress);
}

}  // namespace epura::importer
