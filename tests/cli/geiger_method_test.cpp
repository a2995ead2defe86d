// tetloft reconstruct --method geiger.
#include <gtest/gtest.h>

#include <tetloft/io.hpp>

#include "cli/runner.hpp"

namespace tetloft {
namespace {

using test::expect_failure;
using test::JsonValue;
using test::run;
using test::run_json;
using test::TempFolder;

class GeigerMethod : public ::testing::Test {
 protected:
  GeigerMethod() { test::put(in_, test::kFork); }
  TempFolder folder_;
  std::string in_ = folder_.file("in.cnt");
  std::string out_ = folder_.file("out.vtu");
};

TEST_F(GeigerMethod, WritesAModelAndSaysWhatItDid) {
  const JsonValue json = run_json({"reconstruct", in_, "-o", out_, "--method", "geiger"});
  EXPECT_EQ(json.at("method").string, "geiger");
  EXPECT_EQ(json.at("contours").number, 3);
  EXPECT_EQ(json.at("lost_contours").number, 0);
  const auto model = read_vtu(out_);
  ASSERT_TRUE(model);
  EXPECT_EQ(static_cast<double>(model->tets.size()), json.at("tets").number);
  const auto text = run({"reconstruct", in_, "-o", out_, "--method", "geiger"});
  EXPECT_EQ(text.code, 0);
  EXPECT_NE(text.out.find("eliminated"), std::string::npos) << text.out;
}

TEST_F(GeigerMethod, VerifyTellsBrokenGuaranteesAsWarnings) {
  test::put(in_,
            "S 2\nv 4 z 0\n{ 0 0 4 0 4 4 0 4 }\n"
            "v 8 z 1\n{ 0 0 4 0 4 4 0 4 }\n{ 9 0 10 0 10 1 9 1 }\n");
  const auto told = run({"reconstruct", in_, "-o", out_, "--method", "geiger", "--verify"});
  EXPECT_EQ(told.code, 0);
  EXPECT_NE(told.err.find("broken: guarantee 2 (re-sampling)"), std::string::npos) << told.err;
}

TEST_F(GeigerMethod, RefusesWhatHasNoMeaning) {
  expect_failure({"reconstruct", in_, "-o", out_, "--method", "geiger", "--ends", "half"}, 2,
                 "usage", "--ends", {out_});
  expect_failure({"reconstruct", in_, "-o", out_, "--method", "geiger", "--overlap", "0.1"}, 2,
                 "usage", "--overlap", {out_});
  for (const char* flag : {"--no-chain", "--no-lone"}) {
    expect_failure({"reconstruct", in_, "-o", out_, "--method", "geiger", flag}, 2, "usage", flag,
                   {out_});
  }
  expect_failure({"reconstruct", in_, "-o", out_, "--method", "nuages"}, 2, "usage", "nuages",
                 {out_});
  expect_failure({"reconstruct", in_, "--method", "geiger"}, 2, "usage", "--output");
  test::put(in_, test::kBowtie);
  expect_failure({"reconstruct", in_, "-o", out_, "--method", "geiger"}, 3, "invalid_input", "",
                 {out_});
}

TEST_F(GeigerMethod, NonatoIsTheDefault) {
  ASSERT_EQ(run({"reconstruct", in_, "-o", out_}).code, 0);
  const std::string plain = test::get(out_);
  ASSERT_EQ(run({"reconstruct", in_, "-o", out_, "--method", "nonato"}).code, 0);
  EXPECT_EQ(test::get(out_), plain);
}

}  // namespace
}  // namespace tetloft
