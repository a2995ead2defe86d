// The page: well-formed, of nothing but itself, and true.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include <tetloft/report_page.hpp>

#include "report/cuts.hpp"
#include "report/panels.hpp"
#include "report/pictures.hpp"
#include "unit/render/boxes.hpp"
#include "unit/report/markup_reader.hpp"
#include "unit/report/solids.hpp"

namespace tetloft {
namespace {

using test::Element;

Report made(const Model& model, const SectionStack* stack, const ReportOptions& options = {}) {
  auto report = render_report(model, stack, options);
  EXPECT_TRUE(report.ok()) << (report.ok() ? "" : to_string(report.error()));
  return report.ok() ? *std::move(report) : Report{};
}

Element page_of(const Report& report) {
  std::string why;
  const auto page = test::parse_markup(report.html, why);
  EXPECT_TRUE(page.has_value()) << why;
  return page.value_or(Element{});
}

class ReportPage : public ::testing::Test {
 protected:
  SectionStack stack_ = test::stack_of(test::kBlocks);
  Model model_ = test::model_of(stack_);
};

TEST_F(ReportPage, StandsForItself) {
  const Report report = made(model_, &stack_);
  const Element page = page_of(report);
  EXPECT_TRUE(page.all("script").empty());
  for (const Element* element : page.all("*")) {
    for (const auto& [name, value] : element->attributes) {
      EXPECT_NE(name.substr(0, 2), "on");
      EXPECT_FALSE((name == "href" || name == "src") && value.substr(0, 5) != "data:") << value;
      EXPECT_TRUE(name.substr(0, 5) == "xmlns" || value.find("://") == std::string::npos) << value;
    }
  }
  const std::string style = page.all("style").front()->text;
  EXPECT_EQ(style.find("url("), std::string::npos);
  EXPECT_EQ(style.find("@import"), std::string::npos);
  EXPECT_LT(report.html.size(), 1000000U);
  EXPECT_EQ(made(model_, &stack_).html, report.html);
}

TEST_F(ReportPage, TellsWhatTheFiguresSay) {
  const Report report = made(model_, &stack_);
  const Element page = page_of(report);
  std::map<std::string, std::string> tiles;
  for (const Element* tile : page.all("dl", "tiles").front()->all("div")) {
    tiles[tile->children[0].text] = tile->children[1].text;
  }
  EXPECT_EQ(tiles["components"], "3");
  EXPECT_EQ(tiles["genus"], "1");
  EXPECT_EQ(tiles["cavities"], "1");
  EXPECT_EQ(tiles["sections"], "3");
  EXPECT_EQ(page.all("span", "holds").size(), 5U);
  EXPECT_EQ(page.all("figure", "picture").size(), 4U);
  // Three sections and two middles.
  EXPECT_EQ(page.all("path", "contour").size(), 3U);
  EXPECT_EQ(page.all("path", "below").size(), 2U);
  EXPECT_EQ(page.all("path", "above").size(), 2U);
  EXPECT_EQ(page.all("svg", "plot").size(), 3U);
}

TEST_F(ReportPage, TellsTheRuleOfCorrespondence) {
  ReportOptions options;
  options.check.correspondence.labels = {{SectionId(0U), ContourId(0U), 1},
                                         {SectionId(1U), ContourId(0U), 1}};
  EXPECT_NE(page_of(made(model_, &stack_, options))
                .words()
                .find("moved above 0.1; voids: overlap; labels and decisions given: 2"),
            std::string::npos);
}

TEST_F(ReportPage, ShowsAsManySectionsAsAsked) {
  ReportOptions options;
  options.sections = 2;
  const Element page = page_of(made(model_, &stack_, options));
  EXPECT_EQ(page.all("path", "contour").size(), 2U);
  EXPECT_EQ(page.all("path", "below").size(), 1U);
  for (const std::size_t wrong : {std::size_t{0}, kMostReportSections + 1}) {
    options.sections = wrong;
    const auto refused = render_report(model_, &stack_, options);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
  }
}

TEST_F(ReportPage, TextsAreTextWhateverTheyAre) {
  const std::string evil = "</title><script>alert(1)</script>&amp;\"'\x1b[31m\xff\xe2\x80\xae<!--";
  ReportOptions options;
  options.title = options.model_file = options.stack_file = options.command = options.date = evil;
  Place place;
  place.file = evil;
  options.warnings = {{evil, place}};
  model_.about = {evil, evil, "LPS"};
  model_.component_names = {};
  for (int c = 0; c < 3; ++c) model_.component_names.push_back(evil);
  const Report report = made(model_, &stack_, options);
  const Element page = page_of(report);
  EXPECT_TRUE(page.all("script").empty());
  const std::string shown = "</title><script>alert(1)</script>&amp;\"'\uFFFD[31m\uFFFD\uFFFD<!--";
  EXPECT_EQ(page.all("h1").front()->text, shown);
  EXPECT_EQ(page.all("title").front()->text, shown);
  EXPECT_EQ(page.all("code").front()->text, shown);
  for (const char c : report.html) {
    EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n');
  }
}

TEST_F(ReportPage, WithoutAStackSaysWhatIsNotChecked) {
  const Report report = made(model_, nullptr);
  const Element page = page_of(report);
  EXPECT_TRUE(report.pass());
  EXPECT_FALSE(report.check.has_value());
  std::string verdicts;
  for (const ReportGuarantee& guarantee : report.guarantees) {
    verdicts += name_of(guarantee.verdict)[0];
  }
  EXPECT_EQ(verdicts, "huhuu");
  EXPECT_EQ(page.all("span", "unchecked").size(), 3U);
  // The model knows its sections: outlines are drawn there, and half way.
  EXPECT_EQ(page.all("path", "outline").size(), 5U);
  EXPECT_TRUE(page.all("path", "contour").empty());
  EXPECT_EQ(report.figures.all.first, SectionId(0U));
  EXPECT_EQ(report.figures.all.last, SectionId(2U));
}

TEST_F(ReportPage, OfABadModelIsWrittenAndSaysSo) {
  SectionStack other = stack_;
  other.sections[SectionId(1U)].contours[ContourId(0U)].vertices[0].x -= 1;
  const Report report = made(model_, &other);
  EXPECT_FALSE(report.pass());
  EXPECT_EQ(report.guarantees[1].verdict, ReportVerdict::fails);
  const Element page = page_of(report);
  EXPECT_EQ(page.all("div", "fails").size(), 1U);
  EXPECT_NE(page.words().find("2.3 an input vertex is missing"), std::string::npos);
}

TEST_F(ReportPage, SurvivesModelsInRuins) {
  std::vector<Model> ruins(4, model_);
  // A face of three tets; a tet that stands on its head; a point that is none; components unknown.
  ruins[0].tets.push_back(ruins[0].tets[TetId(0U)]);
  ruins[0].component.push_back(ComponentId(0U));
  ruins[0].slab.push_back(SlabId(0U));
  ruins[0].kind.push_back(TetKind::cc);
  std::swap(ruins[1].tets[TetId(3U)][0], ruins[1].tets[TetId(3U)][1]);
  ruins[2].points[VertexId(5U)].x = std::numeric_limits<double>::infinity();
  ruins[3].component[TetId(7U)] = ComponentId(4000000000U);
  for (std::size_t k = 0; k < ruins.size(); ++k) {
    for (const SectionStack* stack :
         {static_cast<const SectionStack*>(&stack_), static_cast<const SectionStack*>(nullptr)}) {
      const Report report = made(ruins[k], stack);
      EXPECT_EQ(report.pass(), k == 3) << k;
      page_of(report);
    }
  }
}

TEST(ReportPages, TakeCoordinatesOfAnySize) {
  for (const int exponent : {-1060, 1020}) {
    Model model = test::boxes(2, 2);
    for (Point3& p : model.points) {
      p = {std::ldexp(p.x - 4, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    }
    page_of(made(model, nullptr));
    // And a frame that makes them larger.
    model.frame.axes = {Point3{0x1p900, 0, 0}, Point3{0, 3, 0}, Point3{0, 0, 1}};
    page_of(made(model, nullptr));
  }
}

TEST_F(ReportPage, RefusesWhatCannotBeReported) {
  EXPECT_EQ(render_report(Model{}, nullptr).error().code, ErrorCode::invalid_input);
  Model uneven = model_;
  uneven.slab.push_back(SlabId(0U));
  EXPECT_EQ(render_report(uneven, &stack_).error().code, ErrorCode::invalid_input);
  const SectionStack none;
  EXPECT_EQ(render_report(model_, &none).error().code, ErrorCode::invalid_input);
  std::stop_source stop;
  stop.request_stop();
  ReportOptions options;
  options.execution.stop = stop.get_token();
  EXPECT_EQ(render_report(model_, &stack_, options).error().code, ErrorCode::cancelled);
}

TEST_F(ReportPage, TellsItsSteps) {
  std::size_t last = 0, all = 0;
  ReportOptions options;
  options.execution.progress = [&](std::size_t done, std::size_t of_all) {
    EXPECT_EQ(done, last + 1);
    last = done;
    all = of_all;
  };
  made(model_, &stack_, options);
  EXPECT_GT(all, 5U);
  EXPECT_EQ(last, all);
}

// What a path in whole steps encloses.
double enclosed(const std::string& path) {
  double twice = 0, x = 0, y = 0, x0 = 0, y0 = 0;
  for (std::size_t at = 0; at < path.size();) {
    const char command = path[at++];
    if (command == 'z') {
      twice += x * y0 - x0 * y;
      continue;
    }
    std::size_t used = 0;
    const double a = std::stod(path.substr(at), &used);
    at += used;
    const double b = std::stod(path.substr(at), &used);
    at += used;
    if (command == 'M') {
      x0 = x = a;
      y0 = y = b;
    } else {
      twice += x * (y + b) - (x + a) * y;
      x += a;
      y += b;
    }
  }
  return std::abs(twice) / 2;
}

TEST_F(ReportPage, DrawnContoursEncloseWhatTheSectionsDo) {
  const Element page = page_of(made(model_, &stack_));
  const auto contours = page.all("path", "contour");
  ASSERT_EQ(contours.size(), 3U);
  // Holes turn against their outer contours or with them, as the file has them: here all turn the
  // same way, so their areas add. One unit of length is 2400 / 44.
  const double unit = 2400.0 / 44;
  const std::vector<double> areas{64 + 64 + 4, 64 + 4 + 64 + 4 + 16, 64 + 64 + 4 + 16};
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_NEAR(enclosed(contours[s]->attributes.at("d")) / (unit * unit), areas[s],
                0.02 * areas[s]);
  }
}

TEST(Evenly, HasTheFirstAndTheLast) {
  using internal::report::evenly;
  using Positions = std::vector<std::size_t>;
  EXPECT_EQ(evenly(10, 4), (Positions{0, 3, 6, 9}));
  EXPECT_EQ(evenly(3, 8), (Positions{0, 1, 2}));
  EXPECT_EQ(evenly(5, 1), (Positions{0}));
  EXPECT_EQ(evenly(0, 3), Positions{});
  const Positions many = evenly(1000000, 12);
  EXPECT_EQ(many.front(), 0U);
  EXPECT_EQ(many.back(), 999999U);
}

TEST(OrientationLetter, IsThatOfTheFilesAxes) {
  using internal::report::orientation_letter;
  const Frame plain;
  EXPECT_EQ(orientation_letter(plain, "LPS", {1, 0, 0}), 'L');
  EXPECT_EQ(orientation_letter(plain, "LPS", {-1, 0, 0}), 'R');
  EXPECT_EQ(orientation_letter(plain, "LPS", {0, 1, 0}), 'P');
  EXPECT_EQ(orientation_letter(plain, "RAS", {0, 0, -1}), 'I');
  EXPECT_EQ(orientation_letter(plain, "", {1, 0, 0}), 0);
  EXPECT_EQ(orientation_letter(plain, "XYZ", {1, 0, 0}), 0);
  EXPECT_EQ(orientation_letter(plain, "LPS", {}), 0);
  // Sagittal planes: the stack's z runs along the file's x.
  const Frame turned{{Point3{0, 1, 0}, Point3{0, 0, 1}, Point3{1, 0, 0}}, {}};
  EXPECT_EQ(orientation_letter(turned, "LPS", {0, 0, 1}), 'L');
  EXPECT_EQ(orientation_letter(turned, "LPS", {1, 0, 0}), 'P');
  const Frame askew{{Point3{0.7, 0.7, 0}, Point3{-0.7, 0.7, 0}, Point3{0, 0, 1}}, {}};
  EXPECT_EQ(orientation_letter(askew, "LPS", {1, 0, 0}), 0);
  EXPECT_EQ(orientation_letter(askew, "LPS", {0, 0, 1}), 'S');
}

}  // namespace
}  // namespace tetloft
