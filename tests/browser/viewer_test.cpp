// The viewer's page in real browsers: no errors, a picture, and controls that change it.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>

#include "browser/viewer_page.hpp"

namespace tetloft {
namespace {

class Viewer : public test::ViewerPage {
 protected:
  // Whether stage, panel and bar lie beside each other, and the solid is seen whole on the stage.
  void expect_the_solid_is_free(double least_part) {
    const test::JsonValue value = evaluate(R"((() => {
      const box = (id) => document.getElementById(id).getBoundingClientRect();
      const [stage, panel, bar] = [box('picture'), box('panel'), box('bar')];
      const apart = (a, b) => a.right <= b.left + 0.5 || b.right <= a.left + 0.5 ||
        a.bottom <= b.top + 0.5 || b.bottom <= a.top + 0.5;
      window.tetloft.fit();
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
              inside: bar.right <= innerWidth + 0.5 && bar.bottom <= innerHeight + 0.5,
              covered: covered / c.width / c.height,
              part: stage.width * stage.height / innerWidth / innerHeight};
    })())");
    EXPECT_TRUE(value.at("apart").boolean);
    EXPECT_TRUE(value.at("inside").boolean);
    EXPECT_EQ(value.at("border").number, 0);
    EXPECT_GT(value.at("covered").number, 0.03);
    EXPECT_GT(value.at("part").number, least_part);
  }
};

TEST_P(Viewer, ShowsTheSolidAndEveryControlChangesThePicture) {
  start();
  if (ended()) return;
  show_sample("tooth");
  if (ended()) return;
  const Pixels whole = pixels();
  EXPECT_GT(whole.covered, 0.05);
  EXPECT_LT(whole.covered, 0.9);
  EXPECT_GT(whole.colours, 50);
  EXPECT_EQ(pixels().hash, whole.hash) << "the same view is the same picture";
  const std::string shown = browser_->screenshot();

  EXPECT_NE(after(slide("#cut", 500)).hash, whole.hash);
  EXPECT_NE(text_of("place"), "the whole solid");
  EXPECT_NE(browser_->screenshot(), shown);
  EXPECT_EQ(after(slide("#cut", 1000)).hash, whole.hash) << "and back";

  for (const char* box : {"#contours", "#edges", "#smooth"}) {
    EXPECT_NE(after(click(box)).hash, whole.hash) << box;
    EXPECT_EQ(after(click(box)).hash, whole.hash) << box;
  }
  for (int k = 2; k <= 5; ++k) {
    const std::string button = "#colour button:nth-child(" + std::to_string(k) + ')';
    EXPECT_NE(after(click(button)).hash, whole.hash) << button;
  }
  EXPECT_EQ(after(click("#colour button:nth-child(1)")).hash, whole.hash);
  EXPECT_NE(after(slide("#explode", 1)).hash, whole.hash);
  EXPECT_EQ(after(slide("#explode", 0)).hash, whole.hash);
  for (int k = 1; k <= 6; ++k) {
    EXPECT_NE(after(click("[data-side='" + std::to_string(k) + "']")).hash, whole.hash) << k;
  }
  EXPECT_EQ(after(click("#home")).hash, whole.hash);
  expect_no_errors();
}

TEST_P(Viewer, DrawsWhileSomethingChangesAndAtNoOtherTime) {
  start();
  if (ended()) return;
  show(test::one_box(), Ends::flat);
  if (ended()) return;
  const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(700)); };
  wait();
  const double frames = number("tetloft.frames");
  wait();
  EXPECT_EQ(number("tetloft.frames"), frames);
  act(click("#spin"));
  wait();
  EXPECT_GT(number("tetloft.frames"), frames);
  act(click("#spin"));
  wait();
  const double stopped = number("tetloft.frames");
  wait();
  EXPECT_EQ(number("tetloft.frames"), stopped);
  expect_no_errors();
}

TEST_P(Viewer, GoesOnWhenTheGraphicsProcessorWasLost) {
  start();
  if (ended()) return;
  show(test::one_box(), Ends::flat);
  if (ended()) return;
  const Pixels before = after(slide("#cut", 400));
  act("window.lost = tetloft.drawing.gl.getExtension('WEBGL_lose_context'); lost.loseContext();");
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  act("window.lost.restoreContext();");
  Pixels again;
  for (int waited = 0; waited < 50 && again.hash != before.hash; ++waited) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    again = pixels();
  }
  EXPECT_EQ(again.hash, before.hash);
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
  start();
  if (ended()) return;
  RenderOptions options;
  options.colour = ColourBy::evidence;
  show(with_a_lone_box(), Ends::half, options);
  if (ended()) return;
  EXPECT_EQ(text("document.querySelector('#colour [aria-checked=true]').textContent"), "evidence");
  const auto rows = [&] {
    return text("[...document.querySelectorAll('#legend .row')].map((r) => r.textContent).join()");
  };
  EXPECT_EQ(rows(), "overlap2,lone1,no link");
  const Pixels evidence = pixels();
  EXPECT_NE(after(click("#colour button:nth-child(1)")).hash, evidence.hash);
  EXPECT_EQ(rows(), "");
  EXPECT_EQ(after(click("#colour button:nth-child(5)")).hash, evidence.hash);
  EXPECT_NE(after(slide("#cut", 300)).hash, evidence.hash);
  expect_no_errors();
}

TEST_P(Viewer, TurnsAndMovesWithThePointer) {
  start();
  if (ended()) return;
  show_sample("torus");
  if (ended()) return;
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
  EXPECT_TRUE(holds("document.getElementById('card').hidden")) << "who turns does not pick";
  const Pixels moved = after(drag("shiftKey: true"));
  EXPECT_NE(moved.hash, turned.hash);
  EXPECT_GT(moved.covered, 0.02);
  const Pixels nearer = after(
      "const c = document.getElementById('picture'), b = c.getBoundingClientRect();"
      "c.dispatchEvent(new WheelEvent('wheel', {deltaY: -300, clientX: (b.left + b.right) / 2, "
      "clientY: (b.top + b.bottom) / 2}));");
  EXPECT_GT(nearer.covered, moved.covered);
  EXPECT_EQ(
      after("document.getElementById('picture').dispatchEvent(new MouseEvent('dblclick'));").hash,
      whole.hash);
  expect_no_errors();
}

TEST_P(Viewer, ControlsLieBesideTheSolidAndOnAPhoneAreFoldedAndTwoFingersMoveAndZoom) {
  start(1280, 720);
  if (ended()) return;
  const auto unfolded = [&] {
    return holds("document.getElementById('controls').offsetHeight > 0");
  };
  show_sample("torus");
  if (ended()) return;
  EXPECT_TRUE(unfolded());
  expect_the_solid_is_free(0.6);
  act(click("#fold"));
  EXPECT_FALSE(unfolded());

  // On its side, and upright.
  browser_->resize(844, 390);
  show_sample("tooth");
  if (HasFatalFailure()) return;
  EXPECT_FALSE(unfolded());
  browser_->resize(390, 844);
  show_sample("tooth");
  if (HasFatalFailure()) return;
  EXPECT_FALSE(unfolded());
  expect_the_solid_is_free(0.6);
  act(click("#fold"));
  EXPECT_TRUE(unfolded());
  expect_the_solid_is_free(0.25);
  act(click("#measure"));
  EXPECT_FALSE(unfolded()) << "points are picked on the picture";
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
  const double before = number("window.tetloft.camera.unit");
  act(fingers(-50, 0));  // apart
  EXPECT_NEAR(number("window.tetloft.camera.unit"), before / 2, before / 50);
  const double middle = number(target);
  const Pixels centred = pixels();
  EXPECT_NE(after(fingers(0, 60)).hash, centred.hash);  // down
  EXPECT_GT(number(target), middle);
  expect_no_errors();
}

TEST_P(Viewer, SaysWhatToDoWithoutWebGl) {
  if (GetParam() != std::string("chromium")) GTEST_SKIP() << "the same in all: one will do";
  start();
  if (ended()) return;
  auto page = render_html(test::solid_of(test::one_box()), nullptr, {});
  ASSERT_TRUE(page);
  const std::size_t head = page->find("<title>");
  ASSERT_NE(head, std::string::npos);
  page->insert(head, "<script>HTMLCanvasElement.prototype.getContext = () => null;</script>");
  open(*page);
  std::string message;
  for (int waited = 0; waited < 600 && message.find("WebGL") == std::string::npos; ++waited) {
    message = text("document.getElementById('message').innerText");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_NE(message.find("tetloft render"), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(Browsers, Viewer, test::browsers(), test::browser_name);

}  // namespace
}  // namespace tetloft
