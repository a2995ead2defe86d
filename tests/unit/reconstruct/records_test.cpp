// Plans, sections and solids through files: slabs built apart from each other, in any order, make
// the model of the direct run.
#include "reconstruct/records.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/reconstruct.hpp>

#include "core/prng.hpp"
#include "core/watched_work.hpp"
#include "model/scaling.hpp"
#include "property/same_model.hpp"
#include "reconstruct/build.hpp"
#include "reconstruct/ends.hpp"
#include "reconstruct/stack_errors.hpp"
#include "sections/section_record.hpp"
#include "support/signed_record.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

class Folder {
 public:
  Folder()
      : path_(std::filesystem::path(::testing::TempDir()) /
              ("tetloft_records_" +
               std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream file(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  std::filesystem::path path_;
};

std::string section_file(SectionId s) { return "section" + std::to_string(s.value()); }
std::string slab_file(SlabId s) { return "slab" + std::to_string(s.value()); }

// Phase 1 on one machine; the slabs are built here only to learn which contours have to be refined.
std::optional<Error> plan_into(const Folder& folder, const SectionStack& stack,
                               const ReconstructOptions& options) {
  WatchedWork work(options.execution, 0);
  Result<PreparedStack> prepared = prepare(stack, Unit::of_the_stack, options, work);
  if (!prepared) return prepared.error();
  Plan plan;
  plan.exponent = prepared->exponent;
  plan.gabriel.resize(prepared->section_count());
  std::vector<Warning> warnings;
  plan.ends = *place_ends(*prepared, options, warnings);
  Decision decision(*prepared, options);
  Result<Correspondence> decided = decision.make(all_ids<SlabId>(prepared->slab_count()), work);
  if (!decided) return decided.error();
  plan.correspondence = *decided;
  SlabBuilds builds(*prepared, decision, plan, options, work);
  if (auto error = builds.run()) return error;
  folder.write("plan", to_record(plan));
  for (const SectionId s : prepared->sections.ids()) {
    folder.write(section_file(s), sections::to_record(prepared->sections[s]));
  }
  return std::nullopt;
}

ConformingSection section_of_file(const Folder& folder, SectionId s) {
  return sections::section_from_record(folder.read(section_file(s)), section_file(s)).value();
}

// Phase 2 of one slab, on another machine.
void build_into(const Folder& folder, SlabId slab) {
  const Plan plan = plan_from_record(folder.read("plan"), "plan").value();
  const ConformingSection lower = section_of_file(folder, lower_section(slab));
  const ConformingSection upper = section_of_file(folder, upper_section(slab));
  const SlabOutcome outcome = build_slab(slab, lower, upper, plan.correspondence.links[slab],
                                         {DelaunayEngine::automatic, kDefaultWorkLimit})
                                  .value();
  folder.write(slab_file(slab), to_record(std::get<SlabSolid>(outcome)));
}

// Phase 3.
Model glued(const Folder& folder) {
  const Plan plan = plan_from_record(folder.read("plan"), "plan").value();
  IdVector<SectionId, ConformingSection> sections;
  for (const SectionId s : plan.gabriel.ids()) sections.push_back(section_of_file(folder, s));
  const SectionId last(sections.size() - 1);
  std::vector<Part> parts;
  if (plan.ends) {
    parts.push_back({SlabId(0), SectionId(), SectionId(0),
                     build_end(sections[SectionId(0)], plan.ends->below)});
  }
  for (const SlabId slab : plan.correspondence.links.ids()) {
    parts.push_back({slab, lower_section(slab), upper_section(slab),
                     solid_from_record(folder.read(slab_file(slab)), slab_file(slab)).value()});
  }
  if (plan.ends) {
    const SlabId top(sections.size() == 1 ? 0 : last.value() - 1);
    parts.push_back({top, last, SectionId(), build_end(sections[last], plan.ends->above)});
  }
  Model model = glue(sections, plan.correspondence.component, std::move(parts));
  EXPECT_TRUE(scale_exactly(model, -plan.exponent));
  return model;
}

// Whether there was a model.
bool expect_same_through_files(const SectionStack& stack, const ReconstructOptions& options,
                               Prng& prng) {
  const Result<Reconstruction> direct = reconstruct(stack, options);
  if (!direct) return false;
  const Folder folder;
  const auto error = plan_into(folder, stack, options);
  EXPECT_FALSE(error) << to_string(*error);
  std::vector<SlabId> order = all_ids<SlabId>(stack.sections.size() - 1);
  for (std::size_t k = order.size(); k > 1; --k) {
    std::swap(order[k - 1], order[static_cast<std::size_t>(prng.below(k))]);
  }
  for (const SlabId slab : order) build_into(folder, slab);
  EXPECT_TRUE(same_bits(glued(folder), direct->model));
  return true;
}

TEST(Records, AStackBuiltThroughFilesInAnyOrderIsThatOfTheDirectRun) {
  Prng prng(910);
  std::size_t models = 0;
  for (const StackKind kind : all_kinds()) {
    const SectionStack stack = generate(kind, 911).stack;
    if (stack.vertex_count() > 1500) continue;
    SCOPED_TRACE(name_of(kind));
    for (const Criterion criterion : {Criterion::overlap, Criterion::reverse}) {
      ReconstructOptions options;
      options.correspondence.criterion = criterion;
      options.ends = models % 2 == 0 ? Ends::half : Ends::flat;
      if (expect_same_through_files(stack, options, prng)) ++models;
    }
  }
  EXPECT_GT(models, 50U);
}

TEST(Records, SoIsASingleSection) {
  Prng prng(912);
  EXPECT_TRUE(expect_same_through_files(stack_of_boxes({{box(0, 0, 4, 2)}}), {}, prng));
}

TEST(Records, SolidsAndPlansReadBackAsTheyWere) {
  for (const NamedSlab& s : generated_slabs(913, 1)) {
    SCOPED_TRACE(s.name);
    const SlabOutcome outcome =
        build_slab(SlabId(0), s.built->lower, s.built->upper, s.built->links,
                   {DelaunayEngine::automatic, kDefaultWorkLimit})
            .value();
    const auto* solid = std::get_if<SlabSolid>(&outcome);
    if (solid == nullptr) continue;
    const std::string bytes = to_record(*solid);
    const Result<SlabSolid> read = solid_from_record(bytes, "name");
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(to_record(*read), bytes);
  }
}

TEST(Records, WhatIsSignedButWrongIsRefusedOrStillInBounds) {
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 4, 2)}, {box(0, 0, 3, 2), box(5, 0, 6, 2)}, {box(1, 0, 2, 2)}});
  const Folder folder;
  ASSERT_FALSE(plan_into(folder, stack, {}));
  build_into(folder, SlabId(0));
  Prng prng(914);
  std::size_t refused = 0;
  for (const bool of_plan : {false, true}) {
    const std::string bytes = folder.read(of_plan ? "plan" : slab_file(SlabId(0)));
    for (std::size_t at = 24; at + 8 < bytes.size(); ++at) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << prng.below(8)));
      damaged = signed_again(std::move(damaged));
      std::optional<Error> error;
      if (of_plan) {
        const Result<Plan> plan = plan_from_record(damaged, "name");
        if (!plan) error = plan.error();
      } else {
        const Result<SlabSolid> solid = solid_from_record(damaged, "name");
        if (!solid) error = solid.error();
      }
      if (!error) continue;
      ++refused;
      EXPECT_EQ(error->code, ErrorCode::invalid_input) << to_string(*error);
      EXPECT_EQ(error->where.file, "name");
    }
  }
  EXPECT_GT(refused, 200U);
}

}  // namespace
}  // namespace tetloft::testing
