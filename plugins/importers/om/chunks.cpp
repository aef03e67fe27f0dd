// SPDX-License-Identifier: Apache-2.0
#include "chunks.hpp"

#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace om {

namespace {

// Numbers of the format (OpenMesh/Core/IO/OMFormat.hh).
enum Entity : unsigned { vertex = 0, whole_mesh = 1, face = 2, edge = 4, halfedge = 6, sentinel = 7 };
enum Type : unsigned { position = 0, normal = 1, texture = 2, status = 3, colour = 4, custom = 6, topology = 7 };

// The larger three bits are those of the major version.
constexpr unsigned version(unsigned major, unsigned minor) { return major << 5 | minor; }

/// The bits of a chunk's header, from the lowest.
struct Head {
  bool is_named;
  unsigned entity, type;
  bool is_float;
  unsigned dimensions;
  std::size_t number_size;  ///< bytes
};

class Chunks {
 public:
  explicit Chunks(std::string_view file) : file_(file) {
    kind_ = file.size() > 2 ? file[2] : ' ';
    at_ = 3;
    version_ = static_cast<unsigned>(number(1));
    vertices_ = number(4);
    faces_ = number(4);
    edges_ = number(4);
    needed_ = file.substr(0, at_);
  }

  std::string needed() {
    for (int count = 1; at_ < file_.size(); ++count) {
      const std::size_t begin = at_;
      const Head head = next_head();
      if (head.entity == sentinel) break;
      if (head.is_named) skip_name();
      if (head.is_named && version_ >= version(2, 2)) skip_name();  // of its type
      expect_dimensions(head, count);
      skip_data(head, count);
      if (is_needed(head)) needed_ += file_.substr(begin, at_ - begin);
    }
    constexpr std::string_view end("\x1c\0", 2);
    return needed_ + std::string(end);
  }

 private:
  // Lowest byte first.
  std::uint64_t number(std::size_t bytes) {
    const std::size_t begin = at_;
    skip(bytes);
    std::uint64_t value = 0;
    for (std::size_t i = at_; i-- > begin;) value = value << 8 | static_cast<unsigned char>(file_[i]);
    return value;
  }

  void skip(std::uint64_t bytes) {
    if (bytes > file_.size() - at_) throw std::runtime_error("ends too early");
    at_ += bytes;
  }
  void skip(std::uint64_t count, std::uint64_t size) {
    if (size > 0 && count > file_.size() / size) throw std::runtime_error("ends too early");
    skip(count * size);
  }
  void skip_name() { skip(number(1)); }

  // The bit for floats is set in topologies, too, whose numbers are whole.
  Head next_head() {
    const auto bits = static_cast<unsigned>(number(2));
    const bool is_float = (bits >> 10 & 1) != 0 && (bits >> 5 & 15) != topology;
    return {(bits >> 1 & 1) != 0, bits >> 2 & 7,
            bits >> 5 & 15,       is_float,
            (bits >> 11 & 7) + 1, std::size_t(is_float ? 4 : 1) << (bits >> 14)};
  }

  [[nodiscard]] std::uint64_t count_of(const Head& head) const {
    return head.entity == vertex     ? vertices_
           : head.entity == face     ? faces_
           : head.entity == halfedge ? 2 * edges_
           : head.entity == edge     ? edges_
                                     : 1;
  }

  [[noreturn]] static void fail(int chunk, const std::string& what) {
    throw std::runtime_error("is damaged: chunk " + std::to_string(chunk) + " " + what);
  }

  static void expect_dimensions(const Head& head, int chunk) {
    const unsigned wanted = head.type == position || head.type == normal || head.type == colour ? 3
                            : head.type == texture                                              ? 2
                                                                                                : head.dimensions;
    if (head.dimensions != wanted)
      fail(chunk, "has " + std::to_string(head.dimensions) +
                      " numbers for each point, colour or direction instead of " + std::to_string(wanted));
    if (head.type == position && (!head.is_float || head.number_size > sizeof(double)))
      fail(chunk, "has coordinates that are neither floats nor doubles");
  }

  void skip_data(const Head& head, int chunk) {
    const std::uint64_t count = count_of(head);
    const bool is_of_points = head.entity == vertex || head.entity == face;
    if (head.type == custom) return skip(number(4));
    if (head.type == status && head.entity != whole_mesh) return skip(count, sizeof(std::uint32_t));
    if (head.type == topology && head.entity == face && version_ < version(2, 0)) return skip_corners(head);
    if (head.type == topology && is_of_points) return skip(count, head.number_size);
    if (head.type == topology && head.entity == halfedge) return skip(count, 3 * head.number_size);
    const bool is_attribute = head.type == normal || head.type == texture || head.type == colour;
    if ((is_attribute && head.entity != whole_mesh) || (head.type == position && head.entity == vertex))
      return skip(count, head.dimensions * head.number_size);
    fail(chunk, "is of a kind that OpenMesh does not write");
  }

  // Faces were lists of vertices: of polygons, each with its length.
  void skip_corners(const Head& head) {
    if (kind_ == 'T' || kind_ == 'Q') return skip(faces_, (kind_ == 'T' ? 3 : 4) * head.number_size);
    for (std::uint64_t i = 0; i < faces_; ++i) skip(number(2), head.number_size);
  }

  static bool is_needed(const Head& head) {
    if (head.type == topology) return head.entity == face || head.entity == halfedge;
    return (head.type == position && head.entity == vertex) || (head.type == status && head.entity == face);
  }

  std::string_view file_;
  std::size_t at_ = 0;
  char kind_;
  unsigned version_;
  std::uint64_t vertices_, faces_, edges_;
  std::string needed_;
};

}  // namespace

std::string needed_chunks(std::string_view file) { return Chunks(file).needed(); }

}  // namespace om
