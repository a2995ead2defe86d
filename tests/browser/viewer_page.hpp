// The viewer's page in a browser: opened, and its controls used.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <span>
#include <string>

#include <tetloft/tetloft.hpp>

#include "browser/browser.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::test {

class ViewerPage : public ::testing::TestWithParam<const char*> {
 protected:
  /// Starts the browser; skips where it is not installed. All below do nothing after that.
  void start(int width = 1000, int height = 700);
  /// Opens a page and waits for the viewer; skips without WebGL.
  void show_page(const std::string& page);
  void show(const Model& model, const RenderOptions& options = {});
  void show(std::span<const NamedModel> models, const RenderOptions& options = {});
  /// The page of a stack, or of a sample of data/.
  void show(const SectionStack& stack, Ends ends, const RenderOptions& options = {});
  void show_sample(const std::string& sample, const RenderOptions& options = {});
  /// Writes a page and opens it.
  void open(const std::string& page);
  [[nodiscard]] bool ended() const { return IsSkipped() || HasFatalFailure(); }

  struct Pixels {
    double covered = 0, colours = 0, hash = 0;
  };
  Pixels pixels();
  /// Does something in the page; the picture that follows.
  Pixels after(const std::string& action);
  void act(const std::string& action);
  /// Where the page's own scripts would: its constants and classes are no members of the window.
  JsonValue evaluate(const std::string& expression) {
    return browser_->evaluate("window.eval(" + json_quoted(expression) + ')');
  }
  double number(const std::string& expression) { return evaluate(expression).number; }
  std::string text(const std::string& expression) { return evaluate(expression).string; }
  bool holds(const std::string& expression) { return evaluate(expression).boolean; }
  std::string text_of(const std::string& id);
  void press(const std::string& key, bool shift = false);
  /// A click on the picture where a point of the first model's own coordinates is seen.
  void click_on(const std::array<double, 3>& own, int slab);
  void expect_no_errors();

  static std::string slide(const std::string& selector, double value);
  static std::string click(const std::string& selector);

  TempFolder folder_;
  std::unique_ptr<Browser> browser_;
};

/// The browsers, as parameters, and their names.
inline auto browsers() { return ::testing::Values("chromium", "firefox"); }
inline std::string browser_name(const ::testing::TestParamInfo<const char*>& with) {
  return with.param;
}

/// A model of a stack, with ends as asked for.
[[nodiscard]] Model solid_of(const SectionStack& stack, Ends ends = Ends::flat);
/// A box [0, 1] × [0, 3] × [0, 2.8] in five sections.
[[nodiscard]] SectionStack one_box();
/// Turned about y, and shifted.
[[nodiscard]] Frame oblique_frame();

}  // namespace tetloft::test
