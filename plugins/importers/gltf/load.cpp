// SPDX-License-Identifier: Apache-2.0
#include "load.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "draco.hpp"
#include "extensions.hpp"
#include "invalid.hpp"
#include "meshopt.hpp"
#include "refuse.hpp"
#include "set_aside.hpp"

namespace epura::plugin::gltf {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "glTF";
constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;

// tinygltf traverses values recursively.
constexpr int deepest_json = 200;

void expect_32_bits(std::uint64_t size) {
  refuse_if(size > std::numeric_limits<std::uint32_t>::max(), "is larger than 4 GB, and glTF counts in 32 bits");
}

std::string whole_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  if (!file || size < 0) throw std::runtime_error("cannot be opened");
  expect_32_bits(static_cast<std::uint64_t>(size));
  std::string bytes(static_cast<std::size_t>(size), 0);
  file.seekg(0);
  file.read(bytes.data(), size);
  refuse_if(!file, "cannot be read");
  return bytes;
}

std::uint32_t word_at(std::string_view bytes, std::size_t place) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= std::uint32_t{static_cast<unsigned char>(bytes[place + i])} << (8 * i);
  return word;
}

// Checks what tinygltf would only call an invalid binary.
void expect_whole(std::string_view bytes) {
  refuse_if(bytes.size() < header_bytes, "ends within its header");
  const std::uint32_t version = word_at(bytes, 4), length = word_at(bytes, 8);
  refuse_if(version != 2, "is GLB of version " + std::to_string(version) + "; version 2 is read");
  refuse_if(length > bytes.size(),
            "ends after " + std::to_string(bytes.size()) + " of " + std::to_string(length) + " bytes");
}

void expect_shallow(std::string_view json) {
  int depth = 0;
  bool is_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (is_text && c == '\\')
      ++i;
    else if (c == '"')
      is_text = !is_text;
    else if (!is_text && (c == '{' || c == '['))
      refuse_if(++depth > deepest_json, "holds JSON of more than " + std::to_string(deepest_json) + " levels");
    else if (!is_text && (c == '}' || c == ']'))
      --depth;
  }
}

// The JSON part of a GLB, or the whole of another file.
std::string_view json_of(std::string_view bytes, bool is_binary) {
  if (!is_binary) return bytes;
  if (bytes.size() < header_bytes + chunk_header_bytes) return {};
  return bytes.substr(header_bytes + chunk_header_bytes, word_at(bytes, header_bytes));
}

void put_word(std::string& bytes, std::size_t place, std::size_t word) {
  for (std::size_t i = 0; i < 4; ++i) bytes[place + i] = static_cast<char>(word >> (8 * i) & 0xff);
}

// Longer JSON in place of what is there. Chunks end at multiples of four.
std::string with_json(std::string_view bytes, std::string json, bool is_binary) {
  if (!is_binary) return json;
  constexpr std::size_t begin = header_bytes + chunk_header_bytes;
  const std::size_t end = begin + json_of(bytes, is_binary).size();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string whole = std::string(bytes.substr(0, begin)) + json;
  // A header that says something else stays wrong.
  for (const std::size_t length : {magic.size() + 4, header_bytes})
    put_word(whole, length, word_at(bytes, length) + (begin + json.size() - end));
  return whole.append(bytes.substr(end));
}

void set_aside_in(std::string& bytes, bool is_binary) {
  const std::string_view json = json_of(bytes, is_binary);
  std::string edited = set_aside(json);
  if (edited == json) return;
  bytes = with_json(bytes, std::move(edited), is_binary);
  expect_32_bits(bytes.size());
}

// tinygltf takes a last chunk without bytes for damage. Programs write it where there is nothing to draw.
void fill_empty_chunk(std::string& bytes) {
  const std::size_t chunk = header_bytes + chunk_header_bytes + json_of(bytes, true).size();
  const bool is_empty = bytes.size() == chunk + chunk_header_bytes && word_at(bytes, chunk) == 0;
  if (!is_empty) return;
  constexpr std::size_t least = 4;
  bytes.resize(bytes.size() + least);
  put_word(bytes, chunk, least);
  put_word(bytes, magic.size() + 4, bytes.size());
}

bool has_scheme(std::string_view uri) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const std::size_t colon = uri.find_first_of(":/?#");
  return colon != std::string_view::npos && uri[colon] == ':' && colon > 0 && is_letter(uri.front());
}

bool is_image(const fs::path& path) {
  constexpr std::array<std::string_view, 8> endings{".png", ".jpg",  ".jpeg", ".webp",
                                                    ".ktx", ".ktx2", ".dds",  ".basis"};
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// Files to which a file refers. tinygltf passes decoded URIs, and puts no folder before them.
class Companions {
 public:
  Companions(const fs::path& file, bool may_leave)
      : folder_(fs::weakly_canonical(fs::absolute(file)).parent_path()), may_leave_(may_leave) {}

  tinygltf::FsCallbacks callbacks() {
    return {[](const std::string& uri, void* self) { return !is_image(uri) && self != nullptr; },
            [](const std::string& uri, void*) { return uri; },
            [](std::vector<unsigned char>* bytes, std::string*, const std::string& uri, void* self) {
              return static_cast<Companions*>(self)->read(uri, *bytes);
            },
            [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }, this};
  }

  /// The reason why a file was not read; empty if all were.
  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  bool read(const std::string& uri, std::vector<unsigned char>& bytes) noexcept {
    try {
      const std::string whole = whole_file(inside(uri));
      bytes.assign(whole.begin(), whole.end());
      return true;
    } catch (const std::exception& error) {
      if (fault_.empty()) fault_ = "refers to '" + shortened(uri) + "', which " + error.what();
      return false;
    }
  }

  [[nodiscard]] fs::path inside(const std::string& uri) const {
    refuse_if(has_scheme(uri), "is not opened: only files in its own folder are");
    const fs::path path(uri);
    const bool leaves = path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
    // A symbolic link may lead outside, too.
    std::error_code unreadable;
    const fs::path whole = fs::weakly_canonical(folder_ / path, unreadable);
    refuse_if(static_cast<bool>(unreadable), "cannot be opened: " + unreadable.message());
    const bool is_inside =
        std::mismatch(folder_.begin(), folder_.end(), whole.begin(), whole.end()).first == folder_.end();
    refuse_if(!may_leave_ && (leaves || !is_inside), "lies outside its folder");
    refuse_if(!fs::exists(whole), "is not there");
    refuse_if(!fs::is_regular_file(whole), "is no file");
    return whole;
  }

  fs::path folder_;
  bool may_leave_;
  std::string fault_;
};

bool leave_image_alone(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

// Checked first, because the errors that a reader finds in other versions would be misleading.
void expect_version(const tinygltf::Model& model) {
  const std::string& version = model.asset.minVersion.empty() ? model.asset.version : model.asset.minVersion;
  refuse_if(!version.empty() && version.substr(0, 2) != "2.",
            "is glTF of version " + shortened(version) + "; version 2 is read");
}

}  // namespace

tinygltf::Model load(const Source& source, std::string& warning) {
  std::string bytes = whole_file(source.path);
  if (bytes.substr(0, 3) == "\xef\xbb\xbf") bytes.erase(0, 3);
  const bool is_binary = std::string_view(bytes).substr(0, magic.size()) == magic;
  if (is_binary) expect_whole(bytes);
  expect_shallow(json_of(bytes, is_binary));
  set_aside_in(bytes, is_binary);
  if (is_binary) fill_empty_chunk(bytes);
  Companions companions(source.path, source.may_leave);
  tinygltf::TinyGLTF reader;
  reader.SetFsCallbacks(companions.callbacks());
  reader.SetImageLoader(leave_image_alone, nullptr);
  tinygltf::Model model;
  std::string error, other;
  bool has_wrong_values = false;
  bool is_read = false;
  try {
    const auto size = static_cast<unsigned>(bytes.size());
    is_read = is_binary ? reader.LoadBinaryFromMemory(&model, &error, &other,
                                                      reinterpret_cast<const unsigned char*>(bytes.data()), size)
                        : reader.LoadASCIIFromString(&model, &error, &other, bytes.data(), size, "");
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    has_wrong_values = true;
  }
  expect_version(model);
  expect_extensions(model);
  if (!is_read && !companions.fault().empty()) throw std::runtime_error(companions.fault());
  refuse_if(has_wrong_values, "is not a valid glTF file: its JSON holds values of another kind than glTF has there");
  refuse_if(!is_read, "is not a valid glTF file: " + (error.empty() ? "nothing is in it" : sentence_for(error)));
  if (!error.empty()) warning = sentence_for(error);
  decompress_views(model);
  return model;
}

bool is_gltf(std::string_view first_bytes) {
  if (first_bytes.substr(0, magic.size()) == magic) return true;
  const std::size_t start = first_bytes.find_first_not_of("\xef\xbb\xbf \t\r\n");
  const auto has = [&](std::string_view word) { return first_bytes.find(word) != std::string_view::npos; };
  return start != std::string_view::npos && first_bytes[start] == '{' && has("\"asset\"") && has("\"version\"");
}

}  // namespace epura::plugin::gltf
