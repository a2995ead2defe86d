// Stacks that are larger than memory: their sections one after the other.
#pragma once

#include <cstddef>
#include <optional>

#include <tetloft/description.hpp>
#include <tetloft/export.hpp>
#include <tetloft/frame.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft {

/// Sections from below, each handed out once: of a file (open_sections()), of a stack in memory, or
/// of a class of yours. One thread at a time asks.
class TETLOFT_API SectionStream {
 public:
  SectionStream() = default;
  SectionStream(const SectionStream&) = delete;
  SectionStream& operator=(const SectionStream&) = delete;
  virtual ~SectionStream();

  /// The next section; nothing after the last one. An error ends the work that asked, which returns
  /// it. What it throws is guarded as what the work itself throws.
  [[nodiscard]] virtual Result<std::optional<Section>> next() = 0;

  /// As in SectionStack; asked for after the last section. By default those of no file.
  [[nodiscard]] virtual Frame frame() const;
  [[nodiscard]] virtual Description about() const;

  /// The place of an error, which names a section, maybe a contour and a vertex, with what the
  /// stream knows of it: file and line. By default as it is.
  [[nodiscard]] virtual Place located(Place where);
};

/// Of a stack in memory, which must outlive this.
class TETLOFT_API StackStream : public SectionStream {
 public:
  explicit StackStream(const SectionStack& stack) : stack_(stack) {}

  [[nodiscard]] Result<std::optional<Section>> next() override;
  [[nodiscard]] Frame frame() const override { return stack_.frame; }
  [[nodiscard]] Description about() const override { return stack_.about; }

 private:
  const SectionStack& stack_;
  std::size_t next_ = 0;
};

}  // namespace tetloft
