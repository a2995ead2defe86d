// Where a writer's bytes go.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace tetloft::internal::io {

class Sink {
 public:
  virtual ~Sink() = default;
  virtual void append(std::string_view bytes) = 0;
  /// False once bytes are lost: lets long writers stop early.
  [[nodiscard]] virtual bool ok() const { return true; }

 protected:
  Sink() = default;
  Sink(const Sink&) = default;
  Sink(Sink&&) = default;
  Sink& operator=(const Sink&) = default;
  Sink& operator=(Sink&&) = default;
};

class StringSink final : public Sink {
 public:
  void append(std::string_view bytes) override { bytes_ += bytes; }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Collects small pieces, and hands on large ones.
class Pieces {
 public:
  explicit Pieces(Sink& sink) : sink_(sink) {}

  /// To be appended to; call next() behind each line or record.
  std::string& text() { return text_; }
  void next() {
    if (text_.size() >= kPiece) finish();
  }
  void finish() {
    sink_.append(text_);
    text_.clear();
  }

 private:
  // Large enough to make the calls cheap, small beside the file.
  static constexpr std::size_t kPiece = std::size_t{1} << 16;

  Sink& sink_;
  std::string text_;
};

}  // namespace tetloft::internal::io
