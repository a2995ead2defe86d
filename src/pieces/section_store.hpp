// The sections of a stack, validated, in a scratch file: read once from a stream, and then as often
// as planning takes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/section_stream.hpp>
#include <tetloft/valid_stack.hpp>

#include "core/unit_of_length.hpp"
#include "pieces/archive.hpp"
#include "sections/coarse_edges.hpp"

namespace tetloft::internal::pieces {

struct StoredSection {
  Section section;
  Nesting nesting;
};

/// Sections as handed in.
struct GivenSections {
  SectionStream& sections;
  /// Of the whole stack, where it is known to be valid.
  const IdVector<SectionId, Nesting>* nestings = nullptr;
};

/// In memory are what is said here of the whole, and a height and a place in the file for each
/// section.
class SectionStore {
 public:
  /// All sections of the stream. Scratch files as of io::ScratchFile. Refused as validate() does,
  /// with places as the stream tells them.
  [[nodiscard]] static Result<SectionStore> of(const GivenSections& given,
                                               const Execution& execution, const std::string& path);

  [[nodiscard]] std::size_t size() const { return vertices_of_.size(); }
  /// As it was given.
  [[nodiscard]] Result<StoredSection> section(std::size_t s) const;
  /// All of them, in memory.
  [[nodiscard]] Result<ValidStack> stack() const;

  [[nodiscard]] const std::vector<double>& heights() const { return heights_; }
  [[nodiscard]] std::size_t vertices_of(std::size_t s) const { return vertices_of_[s]; }
  [[nodiscard]] std::size_t contours() const { return contours_; }
  [[nodiscard]] std::size_t vertices() const { return coarse_.all; }
  [[nodiscard]] bool has_hole() const { return has_hole_; }
  /// Of x and y.
  [[nodiscard]] double largest() const { return largest_; }
  /// Of all coordinates.
  [[nodiscard]] const UnitOfLength& unit() const { return unit_; }
  [[nodiscard]] const sections::CoarseShare& coarse_vertices() const { return coarse_; }
  [[nodiscard]] const Frame& frame() const { return frame_; }
  [[nodiscard]] const Description& about() const { return about_; }

 private:
  friend class StoreFiller;

  ArchiveReader archive_;
  std::vector<double> heights_;
  std::vector<std::size_t> vertices_of_;
  std::size_t contours_ = 0;
  bool has_hole_ = false;
  double largest_ = 0;
  UnitOfLength unit_;
  sections::CoarseShare coarse_;
  Frame frame_;
  Description about_;
};

}  // namespace tetloft::internal::pieces
