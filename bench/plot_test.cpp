// The picture of distributions shows each engine where its figures are.
#include "plot.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/report/markup_reader.hpp"

namespace tetloft::bench {
namespace {

using test::Element;

Element parsed(const std::string& svg) {
  std::string why;
  const auto element = test::parse_markup(svg, why);
  EXPECT_TRUE(element.has_value()) << why;
  return element.value_or(Element{});
}

Measurement measured(const std::string& engine, unsigned threads, double seconds, double memory) {
  Measurement m;
  m.name = m.engine = engine;
  m.threads = threads;
  m.seconds = {2 * seconds, seconds};
  m.peak_megabytes = memory;
  return m;
}

CaseReport of_size(const std::string& distribution, std::size_t points) {
  const double n = static_cast<double>(points);
  CaseReport one{"distribution " + distribution, "", points, {}, {}, distribution};
  one.own = {measured("tetloft", 1, 1e-6 * n, 10), measured("tetloft", 2, 0.5e-6 * n, 20)};
  one.peers = {measured("<peer>", 1, 3e-6 * n, 40)};
  // Slow rounds change no best: ours has the better best and the worse median.
  one.own.front().seconds.insert(one.own.front().seconds.begin(), 2, 9e-6 * n);
  Measurement failed = measured("broken", 1, 1, 1);
  failed.failure = "crashed";
  one.peers.push_back(failed);
  return one;
}

Report of_two_distributions() {
  Report report;
  // Sizes in any order; a case of no distribution is not shown.
  for (const std::size_t points : {100'000U, 1000U, 10'000U}) {
    report.cases.push_back(of_size("uniform", points));
    report.cases.push_back(of_size("sphere", points));
  }
  report.cases.push_back(of_size("", 10));
  return report;
}

TEST(Plot, HasARowOfThreePlotsForEachDistribution) {
  const Element svg = parsed(plot_of(of_two_distributions()));
  EXPECT_EQ(svg.all("svg", "plot").size(), 6U);
  const std::string words = svg.words();
  for (const char* word : {"uniform", "sphere", "tetloft", "<peer>", "seconds", "MB", "speed-up"}) {
    EXPECT_NE(words.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(words.find("broken"), std::string::npos);
}

TEST(Plot, ShowsBestTimesBySize) {
  const Element svg = parsed(plot_of(of_two_distributions()));
  const Element& time = *svg.all("svg", "plot").front();
  const auto ours = time.all("circle", "d0");
  const auto theirs = time.all("circle", "d1");
  ASSERT_EQ(ours.size(), 3U);
  ASSERT_EQ(theirs.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(ours[k]->number("cx"), theirs[k]->number("cx"), 0.11);
    EXPECT_GT(ours[k]->number("cy"), theirs[k]->number("cy"));  // lower
    if (k == 0) continue;
    EXPECT_GT(ours[k]->number("cx"), ours[k - 1]->number("cx"));
    EXPECT_LT(ours[k]->number("cy"), ours[k - 1]->number("cy"));
  }
  // Time is linear in these, and scales are logarithmic.
  EXPECT_NEAR(ours[1]->number("cy"), (ours[0]->number("cy") + ours[2]->number("cy")) / 2, 0.11);
}

TEST(Plot, ShowsTheSpeedUpOfThoseOnSeveralThreads) {
  const Element svg = parsed(plot_of(of_two_distributions()));
  const Element& scaling = *svg.all("svg", "plot")[2];
  EXPECT_TRUE(scaling.all("circle", "d1").empty());
  const auto ours = scaling.all("circle", "d0");
  ASSERT_EQ(ours.size(), 2U);
  // From 1 to 2 above a floor of 0: the second is twice as high.
  const double floor = scaling.all("line", "axis").back()->number("y1");
  EXPECT_NEAR(floor - ours[1]->number("cy"), 2 * (floor - ours[0]->number("cy")), 0.31);
}

TEST(Plot, OfNoDistributionSaysSo) {
  const Element svg = parsed(plot_of({}));
  EXPECT_TRUE(svg.all("svg", "plot").empty());
  EXPECT_NE(svg.words().find("no case by distribution"), std::string::npos);
}

TEST(Table, HasAColumnForEachContestantOfDistributions) {
  Report report = of_two_distributions();
  report.cases[0].own[1].name = "tetloft, 2 threads";
  const std::string text = markdown_of(report);
  for (const char* line :
       {"| distribution | points | tetloft | tetloft, 2 threads | <peer> | broken |",
        "| uniform | 100000 | 0.1 (10) | 0.05 (20) | 0.3 (40) | failed: crashed |"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << " is not in\n" << text;
  }
}

}  // namespace
}  // namespace tetloft::bench
