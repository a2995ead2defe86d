// The model reader, and check() and pictures of whatever model it reads.
#include <tetloft/check.hpp>
#include <tetloft/io.hpp>
#include <tetloft/render.hpp>

#include "fuzz/target.hpp"

namespace tetloft::fuzz {
namespace {

// A square over a square.
SectionStack tube() {
  SectionStack stack;
  for (const double z : {0.0, 1.0}) {
    Section section;
    section.z = z;
    section.contours.push_back({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}});
    stack.sections.push_back(section);
  }
  return stack;
}

// Each kind of picture is drawn, or refused cleanly.
void draw(const Model& model) {
  RenderOptions options;
  options.width = options.height = 24;
  options.explode = 0.5;
  options.edges = true;
  options.cut = PictureCut{2, 0.5};
  for (const auto render : {render_png, render_svg, render_html}) {
    const auto picture = render(model, nullptr, options);
    if (!picture) {
      require_clean(picture.error());
    } else {
      require(!picture->empty(), "an empty picture");
    }
  }
}

}  // namespace
}  // namespace tetloft::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft;
  using namespace tetloft::fuzz;
  const auto model = parse_vtu(text_of(data, size), "fuzz.vtu");
  if (!model) {
    require_clean(model.error());
    require(!model.error().where.file.empty(), "an error without the file's name");
    return 0;
  }
  draw(*model);
  const auto report = check(*model, tube());
  if (!report) {
    require_clean(report.error());
    return 0;
  }
  require(report->guarantees.size() == 5, "five guarantees");
  for (const GuaranteeVerdict& verdict : report->guarantees) {
    const bool no_reason = verdict.failures.empty() && verdict.not_asked.empty();
    require(verdict.pass == no_reason, "a verdict without a reason");
  }
  return 0;
}
