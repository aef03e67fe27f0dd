// SPDX-License-Identifier: Apache-2.0
#include <epura/importer_abi.h>
#include <epura/projection_abi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <deque>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "importer/loader.hpp"
#include "numbers.hpp"
#include "own_projections.hpp"
#include "projection/answer.hpp"
#include "projection/catalogue.hpp"
#include "projection/loader.hpp"
#include "scene/choices.hpp"
#include "shapes.hpp"
#include "targets.hpp"
#include "view/viewing_model.hpp"

namespace epura::fuzz {

namespace {

constexpr const char* no_library = "fuzz.so";

/// Numbers of any size, and those that are none.
double any_number(Numbers& numbers) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  constexpr std::array<double, 8> odd{infinity, -infinity, nan, 1e300, -1e-300, 5e-324, 1e-9, 0x1p53};
  const int kind = numbers.below(256);
  if (kind < 192) return kind % 16 - 8 + (kind / 16) / 8.0;
  return odd[static_cast<std::size_t>(kind) % odd.size()];
}

/// Rows of a table as a library has them, as far apart as the first one says. Strings stay where they are.
template <class Row>
class Table {
 public:
  /// At most `most` rows, of which one may say that it is of another size.
  Table(Numbers& numbers, int most) {
    constexpr std::array<std::size_t, 8> more{0, 0, 0, 0, 8, 16, 4, std::size_t(0) - 8};
    const std::size_t size = sizeof(Row) + more[static_cast<std::size_t>(numbers.below(8))];
    count_ = static_cast<std::size_t>(numbers.below(most + 1));
    stride_ = std::max(size, sizeof(Row));
    // Rows longer than known have their known part at any multiple of their alignment.
    bytes_.resize((count_ + 1) * (stride_ / alignof(Row) + 1));
    for (std::size_t i = 0; i < count_; ++i) {
      Row row{};
      row.size = static_cast<std::uint32_t>(i > 0 && numbers.below(16) == 15 ? size + 8 : size);
      rows_.push_back(row);
    }
  }

  std::vector<Row>& rows() { return rows_; }
  const Row* laid_out() {
    for (std::size_t i = 0; i < count_; ++i)
      std::memcpy(reinterpret_cast<std::byte*>(bytes_.data()) + i * stride_, &rows_[i], sizeof(Row));
    return reinterpret_cast<const Row*>(bytes_.data());
  }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::size_t count_ = 0, stride_ = 0;
  std::vector<Row> rows_;
  std::vector<std::max_align_t> bytes_;
};

/// The strings of tables.
class Strings {
 public:
  const char* of(Numbers& numbers) {
    const int kind = numbers.below(32);
    if (kind == 31) return nullptr;
    all_.push_back(kind < 24 ? std::string(1, static_cast<char>('a' + kind)) : numbers.text(20));
    return all_.back().c_str();
  }

 private:
  std::deque<std::string> all_;
};

std::uint32_t count_of(Numbers& numbers, std::size_t count) {
  return numbers.below(32) == 31 ? 4000000000U : static_cast<std::uint32_t>(count);
}

void fill(std::vector<epura_parameter>& rows, Numbers& numbers, Strings& strings) {
  for (epura_parameter& row : rows) {
    row.type = static_cast<std::uint32_t>(numbers.below(16) == 15 ? 3 : numbers.below(3));
    row.count = static_cast<std::uint32_t>(row.type == EPURA_VECTOR ? numbers.below(10) : 1);
    row.name = strings.of(numbers);
    row.unit = strings.of(numbers);
    row.help = strings.of(numbers);
    row.choices = row.type == EPURA_CHOICE ? strings.of(numbers) : nullptr;
    for (double& value : row.initial) value = row.type == EPURA_CHOICE ? numbers.below(4) : any_number(numbers);
    row.least = numbers.below(2) == 0 ? -HUGE_VAL : any_number(numbers);
    row.most = numbers.below(2) == 0 ? HUGE_VAL : any_number(numbers);
  }
}

const char* never_called(const double*, const epura_scene*, epura_view*) { return "is called"; }
const char* never_read(const epura_source*, const epura_sink*) { return "is called"; }

void expect_drawable(const projection::Projection& projection) {
  const test::Result drawn = test::draw(test::world_of(test::box({0, 0, 0}, {1, 2, 3})), projection);
  for (const drawing::Segment& segment : drawn.drawing.segments)
    check(std::isfinite(segment.from.x + segment.from.y + segment.to.x + segment.to.y),
          "a projection that is accepted draws a line to a point that is not finite");
  // The matrices that are shown for it.
  const view::ViewingModel model = view::viewing_model(drawn.view, drawn.world.box, 1);
  check(model.viewport.min.x <= model.viewport.max.x && model.viewport.min.y <= model.viewport.max.y,
        "a projection that is accepted has a viewport inside out");
}

// An answer as a plugin might give it, some of it preset.
std::optional<std::string> answer(Numbers& numbers, epura_view& view) {
  if (numbers.below(16) == 15) return numbers.text(20);
  view.projectors = static_cast<std::uint32_t>(numbers.below(3));
  for (auto* vector : {&view.point, &view.normal, &view.up, &view.projector})
    for (double& component : *vector) component = any_number(numbers);
  const int more = numbers.below(16);
  if (more % 2 == 1) view.scale = any_number(numbers);
  if (more / 2 % 2 == 1)
    for (double& side : view.window) side = any_number(numbers);
  if (more / 4 % 2 == 1) view.front = any_number(numbers);
  if (more / 8 % 2 == 1) view.back = any_number(numbers);
  return std::nullopt;
}

// Gives a row of a table its parameters, which are kept.
template <class Row>
void give_parameters(Row& row, std::deque<Table<epura_parameter>>& parameters, Numbers& numbers, Strings& strings) {
  Table<epura_parameter>& own = parameters.emplace_back(numbers, 4);
  fill(own.rows(), numbers, strings);
  row.parameters = own.laid_out();
  row.parameter_count = count_of(numbers, own.count());
}

// A library of projections: its table, values for its parameters as somebody writes them, its answers.
void use_projections(const std::string& bytes) {
  Numbers numbers(bytes);
  Strings strings;
  Table<epura_projection> table(numbers, 3);
  std::deque<Table<epura_parameter>> parameters;
  for (epura_projection& row : table.rows()) {
    row.name = strings.of(numbers);
    row.family = strings.of(numbers);
    row.summary = strings.of(numbers);
    row.reference = strings.of(numbers);
    give_parameters(row, parameters, numbers, strings);
    row.project = numbers.below(32) == 31 ? nullptr : never_called;
  }
  const epura_projection_list list{
      numbers.below(32) == 31 ? 2U : EPURA_ABI_VERSION,
      static_cast<std::uint32_t>(numbers.below(32) == 31 ? 4 : sizeof(epura_projection_list)),
      count_of(numbers, table.count()), table.laid_out()};
  for (projection::ProjectionEntry& entry : projection::read_list(&list, no_library)) {
    entry.ask = [&](const std::vector<double>& values, const Box& scene) {
      return projection::call_function(
          [&](const std::vector<double>&, const epura_scene&, epura_view& view) { return answer(numbers, view); },
          values, scene);
    };
    const scene::ProjectionRequest request = scene::parse_request(entry.name + numbers.text(40));
    expect_drawable(projection::make_projection(entry, request, {Vec3(0), Vec3(1, 2, 3)}));
  }
}

void use_importers(const std::string& bytes) {
  Numbers numbers(bytes);
  Strings strings;
  Table<epura_importer> table(numbers, 3);
  std::deque<Table<epura_parameter>> parameters;
  for (epura_importer& row : table.rows()) {
    row.name = strings.of(numbers);
    row.summary = strings.of(numbers);
    row.extensions = strings.of(numbers);
    give_parameters(row, parameters, numbers, strings);
    row.read = numbers.below(32) == 31 ? nullptr : never_read;
  }
  const epura_importer_list list{numbers.below(32) == 31 ? 2U : EPURA_IMPORTER_ABI_VERSION,
                                 static_cast<std::uint32_t>(numbers.below(32) == 31 ? 4 : sizeof(epura_importer_list)),
                                 count_of(numbers, table.count()), table.laid_out()};
  for (const importer::LoadedImporter& loaded : importer::read_list(&list)) {
    const scene::ProjectionRequest request = scene::parse_request(loaded.table.name + numbers.text(40));
    foreign::values_of(loaded.table.parameters, request.assignments, loaded.table.name, "importer");
  }
}

// The projections of the installation, with parameters as somebody writes them. The first byte selects one, if the
// words do not name it.
void use_words(const std::string& bytes) {
  const std::vector<projection::ProjectionEntry>& all = own_projections();
  Numbers numbers(bytes);
  const projection::ProjectionEntry& chosen =
      all[static_cast<std::size_t>(numbers.below(static_cast<int>(all.size())))];
  const scene::ProjectionRequest request = scene::parse_request(chosen.name + numbers.rest());
  const auto named =
      std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.name == request.name; });
  if (named == all.end()) throw Error(ErrorKind::input, request.name, "no such projection");
  expect_drawable(projection::make_projection(*named, request, {Vec3(0), Vec3(1, 2, 3)}));
}

}  // namespace

const std::vector<projection::ProjectionEntry>& own_projections() {
  static const std::vector<projection::ProjectionEntry> all = [] {
    std::vector<std::filesystem::path> libraries;
    for (const auto& file : std::filesystem::directory_iterator(EPURA_FUZZ_PROJECTIONS))
      libraries.push_back(file.path());
    std::sort(libraries.begin(), libraries.end());
    std::vector<projection::ProjectionEntry> found;
    for (const std::filesystem::path& library : libraries)
      for (projection::ProjectionEntry& entry : projection::read_plugin(library)) found.push_back(std::move(entry));
    return found;
  }();
  return all;
}

std::span<const Target> plugins() {
  static constexpr std::array<Target, 3> all{
      {{"projections", use_projections}, {"importers", use_importers}, {"parameters", use_words}}};
  return all;
}

}  // namespace epura::fuzz
