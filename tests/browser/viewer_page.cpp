#include "browser/viewer_page.hpp"

#include <chrono>
#include <cmath>
#include <thread>

namespace tetloft::test {

void ViewerPage::start(int width, int height) {
  const bool firefox = GetParam() == std::string("firefox");
  const auto found = find_program(
      firefox ? std::vector<std::string>{"firefox", "firefox-esr"}
              : std::vector<std::string>{"chromium", "chromium-browser", "google-chrome"});
  if (!found) GTEST_SKIP() << "no " << GetParam();
  browser_ = firefox ? start_firefox() : start_chromium();
  ASSERT_NE(browser_, nullptr) << "installed, but does not start";
  browser_->resize(width, height);
}

void ViewerPage::open(const std::string& page) {
  ASSERT_TRUE(write_file(folder_.file("page.html"), page));
  browser_->open("file://" + folder_.file("page.html"));
}

void ViewerPage::show_page(const std::string& page) {
  open(page);
  for (int waited = 0; waited < 600; ++waited) {
    const std::string message = text("document.getElementById('message')?.textContent");
    if (message.find("WebGL") != std::string::npos) GTEST_SKIP() << message;
    if (holds("Boolean(window.tetloft)")) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  ASSERT_TRUE(holds("Boolean(window.tetloft)"));
}

void ViewerPage::show(std::span<const NamedModel> models, const RenderOptions& options) {
  const auto page = render_html(models, nullptr, options);
  ASSERT_TRUE(page);
  show_page(*page);
}

void ViewerPage::show(const Model& model, const RenderOptions& options) {
  const NamedModel one{&model, options.title};
  show({&one, 1}, options);
}

void ViewerPage::show(const SectionStack& stack, Ends ends, const RenderOptions& options) {
  const Model model = solid_of(stack, ends);
  const auto page = render_html(model, &stack, options);
  ASSERT_TRUE(page);
  show_page(*page);
}

void ViewerPage::show_sample(const std::string& sample, const RenderOptions& options) {
  const auto input = read_cnt(std::string(TETLOFT_DATA_DIR) + '/' + sample + ".cnt");
  ASSERT_TRUE(input);
  show(input->stack, Ends::half, options);
}

ViewerPage::Pixels ViewerPage::pixels() {
  const JsonValue value = evaluate("window.tetloft.pixels()");
  return {value.at("covered").number, value.at("colours").number, value.at("hash").number};
}

void ViewerPage::act(const std::string& action) { evaluate("(() => { " + action + " })()"); }

ViewerPage::Pixels ViewerPage::after(const std::string& action) {
  act(action);
  return pixels();
}

std::string ViewerPage::text_of(const std::string& id) {
  return text("document.getElementById(" + json_quoted(id) + ").textContent");
}

void ViewerPage::press(const std::string& key, bool shift) {
  act("document.body.dispatchEvent(new KeyboardEvent('keydown', {bubbles: true, cancelable: true, "
      "key: " +
      json_quoted(key) + ", shiftKey: " + (shift ? "true" : "false") + "}));");
}

void ViewerPage::click_on(const std::array<double, 3>& own, int slab) {
  std::string point = "[";
  for (const double x : own) point += std::to_string(x) + ',';
  act("const t = tetloft, c = t.canvas, box = c.getBoundingClientRect(), pane = t.panes[0];"
      "const [x, y] = t.camera.project(t.layers[0].placed(" +
      point + "], " + std::to_string(slab) +
      ", t.state.explode));"
      "c.setPointerCapture = () => {};"
      "const send = (n) => c.dispatchEvent(new PointerEvent(n, {pointerId: 7, button: 0, clientX: "
      "box.left + pane.x + pane.width / 2 + x, clientY: box.top + pane.y + pane.height / 2 - y}));"
      "send('pointerdown'); send('pointerup');");
}

void ViewerPage::expect_no_errors() {
  for (const std::string& error : browser_->errors()) ADD_FAILURE() << error;
}

std::string ViewerPage::slide(const std::string& selector, double value) {
  return "{ const s = document.querySelector(" + json_quoted(selector) +
         "); s.value = " + std::to_string(value) + "; s.dispatchEvent(new Event('input')); }";
}

std::string ViewerPage::click(const std::string& selector) {
  return "document.querySelector(" + json_quoted(selector) + ").click();";
}

Model solid_of(const SectionStack& stack, Ends ends) {
  ReconstructOptions options;
  options.ends = ends;
  auto solid = reconstruct(stack, options);
  EXPECT_TRUE(solid);
  return solid ? std::move(solid->model) : Model{};
}

SectionStack one_box() {
  SectionStack stack;
  for (std::size_t s = 0; s < 5; ++s) {
    Section section{0.7 * static_cast<double>(s), {}};
    section.contours.push_back({{{0, 0}, {1, 0}, {1, 3}, {0, 3}}});
    stack.sections.push_back(section);
  }
  return stack;
}

Frame oblique_frame() {
  const double c = std::cos(0.4), s = std::sin(0.4);
  return {{Point3{c, 0, -s}, Point3{0, 1, 0}, Point3{s, 0, c}}, {50, -60, 70}};
}

}  // namespace tetloft::test
