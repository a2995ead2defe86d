// Browsers without a window, remotely controlled: pages are tested where they are used.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/json_value.hpp"

namespace tetloft::test {

/// Milliseconds to wait for an answer: software drawing on a busy machine is slow.
inline constexpr int kPatience = 240'000;

class Browser {
 public:
  virtual ~Browser() = default;
  /// Loads a page and waits until it is there.
  virtual void open(const std::string& url) = 0;
  /// The value of an expression in the page; null where it throws.
  virtual JsonValue evaluate(const std::string& expression) = 0;
  /// The size of the page in pixels, as nearly as the browser takes it; before a page is opened.
  virtual void resize(int width, int height) = 0;
  /// Errors that the page reported so far.
  virtual std::vector<std::string> errors() = 0;
  /// The window as PNG, base64.
  virtual std::string screenshot() = 0;
};

/// Chromium by its debugging pipe; null where it is not installed or does not start.
[[nodiscard]] std::unique_ptr<Browser> start_chromium();
/// Firefox by its Marionette server; null where it is not installed or does not start.
[[nodiscard]] std::unique_ptr<Browser> start_firefox();

/// The first of these programs that is installed.
[[nodiscard]] std::optional<std::string> find_program(const std::vector<std::string>& names);

/// `text` as a JSON string.
[[nodiscard]] std::string json_quoted(const std::string& text);

/// A child process, ended with its object. Its output goes to the file `log`; descriptors (of
/// this process, of the child) are handed on.
class Child {
 public:
  Child(const std::vector<std::string>& words, const std::string& log,
        const std::vector<std::pair<int, int>>& descriptors = {});
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

 private:
  int pid_ = -1;
};

}  // namespace tetloft::test
