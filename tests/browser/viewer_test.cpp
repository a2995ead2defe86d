// The viewer's page in real browsers: no errors, a picture, and controls that change it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include <tetloft/tetloft.hpp>

#include "browser/browser.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {
namespace {

using test::Browser;
using test::JsonValue;

const std::string kData = TETLOFT_DATA_DIR;

class Viewer : public ::testing::TestWithParam<const char*> {
 protected:
  // Skips where the browser is not there.
  bool start() {
    const bool firefox = GetParam() == std::string("firefox");
    const auto found = test::find_program(
        firefox ? std::vector<std::string>{"firefox", "firefox-esr"}
                : std::vector<std::string>{"chromium", "chromium-browser", "google-chrome"});
    if (!found) return false;
    browser_ = firefox ? test::start_firefox() : test::start_chromium();
    EXPECT_NE(browser_, nullptr) << "installed, but does not start";
    return browser_ != nullptr;
  }

  // Opens the page of a sample of data/ and waits for the viewer.
  void show(const std::string& sample, const RenderOptions& options = {}) {
    const auto input = read_cnt(kData + '/' + sample + ".cnt");
    ASSERT_TRUE(input);
    show(input->stack, Ends::half, options);
  }

  void show(const SectionStack& stack, Ends ends, const RenderOptions& options) {
    ReconstructOptions with_ends;
    with_ends.ends = ends;
    const auto solid = reconstruct(stack, with_ends);
    ASSERT_TRUE(solid);
    const auto page = render_html(solid->model, &stack, options);
    ASSERT_TRUE(page);
    open(*page);
    for (int waited = 0; waited < 600; ++waited) {
      const std::string message =
          browser_->evaluate("document.getElementById('message')?.textContent").string;
      if (message.find("WebGL") != std::string::npos) GTEST_SKIP() << message;
      if (browser_->evaluate("Boolean(window.tetloft)").boolean) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    ASSERT_TRUE(browser_->evaluate("Boolean(window.tetloft)").boolean);
  }

  void open(const std::string& page) {
    ASSERT_TRUE(write_file(folder_.file("page.html"), page));
    browser_->open("file://" + folder_.file("page.html"));
  }

  struct Pixels {
    double covered = 0, colours = 0, hash = 0;
  };
  Pixels pixels() {
    const JsonValue value = browser_->evaluate("window.tetloft.pixels()");
    return {value.at("covered").number, value.at("colours").number, value.at("hash").number};
  }

  // Does something in the page; the picture that follows.
  Pixels after(const std::string& action) {
    browser_->evaluate("(() => { " + action + " })()");
    return pixels();
  }

  static std::string slide(const std::string& id, double value) {
    return "const s = document.getElementById('" + id + "'); s.value = " + std::to_string(value) +
           "; s.dispatchEvent(new Event('input'));";
  }
  static std::string click(const std::string& selector) {
    return "document.querySelector(" + test::json_quoted(selector) + ").click();";
  }

  // What is seen of the rectangle [u0, u1] × [v0, v1], in parts of the solid's box, in section s:
  // pixels that show nothing, and the largest difference of their reds.
  struct Face {
    double missing = -1, spread = -1;
  };
  Face face(std::size_t s, const std::array<double, 4>& parts) {
    const JsonValue value = browser_->evaluate(
        R"((() => {
          const t = window.tetloft, m = t.mesh, gl = t.drawing.gl, c = t.canvas;
          const span = (axis) => {
            const all = m.points.filter((_, i) => i % 3 === axis);
            return [Math.min(...all), Math.max(...all)];
          };
          const [x, y, z] = [span(0), span(1), m.sections[)" +
        std::to_string(s) + R"(].at];
          t.drawNow();
          const bytes = new Uint8Array(4 * c.width * c.height);
          gl.readPixels(0, 0, c.width, c.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
          const {view, projection} = t.camera.matrices(c.width / c.height, 1.05 * t.reach());
          const times = (a, v) => [0, 1, 2, 3].map((i) =>
            a[i] * v[0] + a[4 + i] * v[1] + a[8 + i] * v[2] + a[12 + i] * v[3]);
          let missing = 0, low = 255, high = 0;
          for (let k = 0; k < 10000; ++k) {
            const u = )" +
        std::to_string(parts[0]) + " + " + std::to_string(parts[1] - parts[0]) +
        R"( * (0.08 + 0.84 * (k % 100) / 99);
            const v = )" +
        std::to_string(parts[2]) + " + " + std::to_string(parts[3] - parts[2]) +
        R"( * (0.08 + 0.84 * Math.floor(k / 100) / 99);
            const q = times(projection, times(view,
              [x[0] + u * (x[1] - x[0]), y[0] + v * (y[1] - y[0]), z, 1]));
            const at = 4 * (Math.floor((q[0] / q[3] + 1) / 2 * c.width) +
                            c.width * Math.floor((q[1] / q[3] + 1) / 2 * c.height));
            if (bytes[at + 3] !== 255) ++missing;
            low = Math.min(low, bytes[at]);
            high = Math.max(high, bytes[at]);
          }
          return {missing, spread: high - low};
        })())");
    return {value.at("missing").number, value.at("spread").number};
  }

  // Whether stage, panel and bar lie beside each other, and the solid is seen whole on the stage.
  void expect_the_solid_is_free(double least_part) {
    const JsonValue value = browser_->evaluate(R"((() => {
      const box = (id) => document.getElementById(id).getBoundingClientRect();
      const [stage, panel, bar] = [box('picture'), box('panel'), box('bar')];
      const apart = (a, b) => a.right <= b.left + 0.5 || b.right <= a.left + 0.5 ||
        a.bottom <= b.top + 0.5 || b.bottom <= a.top + 0.5;
      window.tetloft.drawNow();
      const gl = window.tetloft.drawing.gl, c = window.tetloft.canvas;
      const bytes = new Uint8Array(4 * c.width * c.height);
      gl.readPixels(0, 0, c.width, c.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      let covered = 0, border = 0;
      for (let k = 0; k < c.width * c.height; ++k) {
        if (bytes[4 * k + 3] === 0) continue;
        ++covered;
        const x = k % c.width, y = Math.floor(k / c.width);
        if (x === 0 || y === 0 || x + 1 === c.width || y + 1 === c.height) ++border;
      }
      return {apart: apart(stage, panel) && apart(stage, bar) && apart(panel, bar), border,
              covered: covered / c.width / c.height,
              part: stage.width * stage.height / innerWidth / innerHeight};
    })())");
    EXPECT_TRUE(value.at("apart").boolean);
    EXPECT_EQ(value.at("border").number, 0);
    EXPECT_GT(value.at("covered").number, 0.03);
    EXPECT_GT(value.at("part").number, least_part);
  }

  void expect_no_errors() {
    for (const std::string& error : browser_->errors()) ADD_FAILURE() << error;
  }

  test::TempFolder folder_;
  std::unique_ptr<Browser> browser_;
};

TEST_P(Viewer, ShowsTheSolidAndEveryControlChangesThePicture) {
  if (!start()) GTEST_SKIP() << "no " << GetParam();
  show("tooth");
  if (IsSkipped() || HasFatalFailure()) return;
  const Pixels whole = pixels();
  EXPECT_GT(whole.covered, 0.05);
  EXPECT_LT(whole.covered, 0.9);
  EXPECT_GT(whole.colours, 50);
  EXPECT_EQ(pixels().hash, whole.hash) << "the same view is the same picture";
  const std::string shown = browser_->screenshot();

  const Pixels cut = after(slide("cut", 500));
  EXPECT_NE(cut.hash, whole.hash);
  EXPECT_NE(browser_->evaluate("document.getElementById('place').textContent").string,
            "the whole solid");
  EXPECT_NE(browser_->screenshot(), shown);
  EXPECT_EQ(after(slide("cut", 1000)).hash, whole.hash) << "and back";

  for (const char* box : {"#contours", "#edges", "#smooth"}) {
    EXPECT_NE(after(click(box)).hash, whole.hash) << box;
    EXPECT_EQ(after(click(box)).hash, whole.hash) << box;
  }
  for (int k = 2; k <= 5; ++k) {
    const std::string button = "#colour button:nth-child(" + std::to_string(k) + ')';
    EXPECT_NE(after(click(button)).hash, whole.hash) << button;
  }
  EXPECT_EQ(after(click("#colour button:nth-child(1)")).hash, whole.hash);
  EXPECT_NE(after(slide("explode", 1)).hash, whole.hash);
  after(slide("explode", 0));
  EXPECT_NE(after(click("[data-view='-90 90']")).hash, whole.hash);
  EXPECT_EQ(after(click("[data-view='-60 25']")).hash, whole.hash);
  expect_no_errors();
}

// A box through all sections, and beside it a small one in the middle, which nothing overlaps.
SectionStack with_a_lone_box() {
  SectionStack stack;
  for (std::size_t s = 0; s < 3; ++s) {
    Section section{0.7 * static_cast<double>(s), {}};
    section.contours.push_back({{{0, 0}, {1, 0}, {1, 3}, {0, 3}}});
    if (s == 1) section.contours.push_back({{{1.2, 1}, {1.4, 1}, {1.4, 1.2}, {1.2, 1.2}}});
    stack.sections.push_back(section);
  }
  return stack;
}

TEST_P(Viewer, ColoursByTheEvidenceOfLinks) {
  if (!start()) GTEST_SKIP() << "no " << GetParam();
  RenderOptions options;
  options.colour = ColourBy::evidence;
  show(with_a_lone_box(), Ends::half, options);
  if (IsSkipped() || HasFatalFailure()) return;
  EXPECT_EQ(browser_->evaluate("document.querySelector('#colour [aria-checked=true]').textContent")
                .string,
            "evidence");
  const auto rows = [&] {
    return browser_
        ->evaluate(
            "[...document.querySelectorAll('#legend .row')].map((r) => r.textContent).join()")
        .string;
  };
  EXPECT_EQ(rows(), "overlap2,lone1,no link");
  const Pixels evidence = pixels();
  EXPECT_NE(after(click("#colour button:nth-child(1)")).hash, evidence.hash);
  EXPECT_EQ(rows(), "");
  EXPECT_EQ(after(click("#colour button:nth-child(5)")).hash, evidence.hash);
  EXPECT_NE(after(slide("cut", 300)).hash, evidence.hash);
  expect_no_errors();
}

TEST_P(Viewer, TurnsAndMovesWithThePointer) {
  if (!start()) GTEST_SKIP() << "no " << GetParam();
  show("torus");
  if (IsSkipped() || HasFatalFailure()) return;
  const Pixels whole = pixels();
  const auto drag = [](const std::string& modifier) {
    return "const c = document.getElementById('picture'); c.setPointerCapture = () => {};"
           "const send = (n, x, y) => c.dispatchEvent(new PointerEvent(n, {pointerId: 1, buttons: "
           "1,"
           " clientX: x, clientY: y, " +
           modifier +
           "}));"
           "send('pointerdown', 500, 300); send('pointermove', 560, 340); send('pointerup', 560, "
           "340);";
  };
  const Pixels turned = after(drag("shiftKey: false"));
  EXPECT_NE(turned.hash, whole.hash);
  const Pixels moved = after(drag("shiftKey: true"));
  EXPECT_NE(moved.hash, turned.hash);
  EXPECT_GT(moved.covered, 0.02);
  const Pixels nearer = after(
      "document.getElementById('picture').dispatchEvent(new WheelEvent('wheel', {deltaY: -300}));");
  EXPECT_GT(nearer.covered, moved.covered);
  EXPECT_EQ(
      after("document.getElementById('picture').dispatchEvent(new MouseEvent('dblclick'));").hash,
      whole.hash);
  expect_no_errors();
}

TEST_P(Viewer, StepsFromSectionToSectionAndHidesComponents) {
  if (!start()) GTEST_SKIP() << "no " << GetParam();
  RenderOptions options;
  options.title = "</script> & \"title\"";
  options.cut = PictureCut{2, 3};
  show("bifurcation", options);
  if (IsSkipped() || HasFatalFailure()) return;
  EXPECT_EQ(browser_->evaluate("document.getElementById('title').textContent").string,
            options.title);
  const Pixels at_first = pixels();
  const auto place = [&] {
    return browser_->evaluate("document.getElementById('place').textContent").string;
  };
  const std::string before = place();
  EXPECT_NE(after(click("#down")).hash, at_first.hash);
  EXPECT_NE(place().find("section"), std::string::npos);
  EXPECT_NE(place(), before);
  browser_->evaluate(
      "(() => { for (let k = 0; k < 100; ++k) document.querySelector('#up').click(); })()");
  EXPECT_EQ(place(), "the whole solid");
  EXPECT_GT(pixels().covered, at_first.covered);
  EXPECT_EQ(after(click("#contours") + click("#legend button")).covered, 0);
  expect_no_errors();
}

// Two boxes, of which one ends above the middle section.
SectionStack two_heights() {
  SectionStack stack;
  for (std::size_t s = 0; s < 5; ++s) {
    Section section{0.3 + 0.7 * static_cast<double>(s), {}};
    section.contours.push_back({{{0, 0}, {1, 0}, {1, 3}, {0, 3}}});
    if (s < 3) section.contours.push_back({{{2, 0}, {3, 0}, {3, 3}, {2, 3}}});
    stack.sections.push_back(section);
  }
  return stack;
}

TEST_P(Viewer, FlatFacesHaveNoHolesWholeOrCutInAnySection) {
  if (!start()) GTEST_SKIP() << "no " << GetParam();
  RenderOptions options;
  options.contours = false;
  options.elevation = 40;
  browser_->resize(1000, 800);
  show(two_heights(), Ends::flat, options);
  if (IsSkipped() || HasFatalFailure()) return;
  const std::array left{0.0, 1.0 / 3, 0.0, 1.0}, right{2.0 / 3, 1.0, 0.0, 1.0};
  const auto expect_uniform = [&](std::size_t s, const std::array<double, 4>& parts) {
    const Face seen = face(s, parts);
    EXPECT_EQ(seen.missing, 0) << s;
    EXPECT_GE(seen.spread, 0) << s;
    EXPECT_LT(seen.spread, 30) << s;
  };
  expect_uniform(4, left);
  for (std::size_t s = 4; s-- > 1;) {
    browser_->evaluate("document.querySelector('#down').click()");
    expect_uniform(s, left);
    if (s <= 2) expect_uniform(s, right);
  }
  expect_no_errors();
}

TEST_P(Viewer, ControlsLieBesideTheSolidAndOnAPhoneAreFoldedAndTwoFingersMoveAndZoom) {
  if (!start()) GTEST_SKIP() << "no " << GetParam();
  const auto unfolded = [&] {
    return browser_->evaluate("document.getElementById('controls').offsetHeight > 0").boolean;
  };
  browser_->resize(1280, 720);
  show("torus");
  if (IsSkipped() || HasFatalFailure()) return;
  EXPECT_TRUE(unfolded());
  expect_the_solid_is_free(0.6);
  after(click("#fold"));
  EXPECT_FALSE(unfolded());

  browser_->resize(390, 844);
  show("tooth");
  if (HasFatalFailure()) return;
  EXPECT_FALSE(unfolded());
  expect_the_solid_is_free(0.6);
  after(click("#fold"));
  EXPECT_TRUE(unfolded());
  expect_the_solid_is_free(0.25);
  after(click("#fold"));
  EXPECT_FALSE(unfolded());
  expect_the_solid_is_free(0.6);

  const auto fingers = [](int dx, int dy) {
    return "const c = document.getElementById('picture'); c.setPointerCapture = () => {};"
           "const send = (n, id, x, y) => c.dispatchEvent(new PointerEvent(n, {pointerId: id, "
           "pointerType: 'touch', buttons: 1, clientX: x, clientY: y}));"
           "send('pointerdown', 1, 100, 300); send('pointerdown', 2, 200, 300);"
           "send('pointermove', 1, " +
           std::to_string(100 + dx) + ", " + std::to_string(300 + dy) +
           "); send('pointermove', 2, " + std::to_string(200 + std::abs(dx)) + ", " +
           std::to_string(300 + dy) + "); send('pointerup', 1, 0, 0); send('pointerup', 2, 0, 0);";
  };
  const std::string target = "window.tetloft.camera.target[2]";
  const double before = browser_->evaluate("window.tetloft.camera.distance").number;
  after(fingers(-50, 0));  // apart
  EXPECT_NEAR(browser_->evaluate("window.tetloft.camera.distance").number, before / 2, before / 50);
  const double middle = browser_->evaluate(target).number;
  const Pixels centred = pixels();
  const Pixels moved = after(fingers(0, 60));  // down
  EXPECT_NE(moved.hash, centred.hash);
  EXPECT_GT(browser_->evaluate(target).number, middle);
  expect_no_errors();
}

TEST_P(Viewer, SaysWhatToDoWithoutWebGl) {
  if (GetParam() != std::string("chromium")) GTEST_SKIP() << "the same in all: one will do";
  if (!start()) GTEST_SKIP() << "no " << GetParam();
  const auto solid = reconstruct(two_heights());
  ASSERT_TRUE(solid);
  auto page = render_html(solid->model, nullptr, {});
  ASSERT_TRUE(page);
  const std::size_t head = page->find("<title>");
  ASSERT_NE(head, std::string::npos);
  page->insert(head, "<script>HTMLCanvasElement.prototype.getContext = () => null;</script>");
  open(*page);
  std::string message;
  for (int waited = 0; waited < 600 && message.find("WebGL") == std::string::npos; ++waited) {
    message = browser_->evaluate("document.getElementById('message').innerText").string;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_NE(message.find("tetloft render"), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(Browsers, Viewer, ::testing::Values("chromium", "firefox"),
                         [](const auto& with) { return std::string(with.param); });

}  // namespace
}  // namespace tetloft
