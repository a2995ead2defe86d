// Plans, sections and solids through files: slabs built apart from each other, in any order, make
// the model of the direct run.
#include "reconstruct/records.hpp"
#include "reconstruct/void_outcome.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/reconstruct.hpp>

#include "core/prng.hpp"
#include "core/watched_work.hpp"
#include "correspondence/link_report.hpp"
#include "model/scaling.hpp"
#include "property/same_model.hpp"
#include "reconstruct/build.hpp"
#include "reconstruct/decide_between.hpp"
#include "reconstruct/decide_voids.hpp"
#include "reconstruct/ends.hpp"
#include "reconstruct/layered_slab.hpp"
#include "reconstruct/stack_errors.hpp"
#include "sections/complement.hpp"
#include "sections/section_record.hpp"
#include "support/same_rows.hpp"
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
                               const ReconstructOptions& options, Unit unit) {
  WatchedWork work(options.execution, 0);
  Result<PreparedStack> prepared = prepare(stack, unit, options, work);
  if (!prepared) return prepared.error();
  Plan plan;
  plan.exponent = prepared->exponent;
  plan.gabriel.resize(prepared->section_count());
  plan.apart.resize(prepared->section_count());
  plan.divided = prepared->divisions;
  std::vector<Warning> warnings;
  plan.ends = *place_ends(*prepared, options, warnings);
  Decision decision(*prepared, options);
  Result<Correspondence> decided = decision.make(all_ids<SlabId>(prepared->slab_count()), work);
  if (!decided) return decided.error();
  plan.correspondence = *decided;
  plan.motions = decision.motions();
  plan.voids = *VoidDecision(*prepared, options).make(plan.correspondence.links, work);
  if (auto error =
          decide_between(*prepared, options, all_ids<SlabId>(prepared->slab_count()), work, plan)) {
    return error;
  }
  SlabBuilds builds(*prepared, decision, plan, options, work);
  if (auto error = builds.run()) return error;
  if (auto error = builds.triangulate_again(all_ids<SlabId>(prepared->slab_count()))) return error;
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
  const SlabOutcome outcome =
      build_slab_between(
          slab, lower, upper,
          {plan.correspondence.links[slab], plan.voids ? &plan.voids->links[slab] : nullptr},
          plan.between[slab],
          {DelaunayEngine::automatic, kDefaultWorkLimit, plan.may_ask[slab] != 0})
          .value();
  folder.write(slab_file(slab), to_record(std::get<SlabSolid>(outcome)));
}

IdVector<SectionId, Nesting> complements_of(
    const IdVector<SectionId, ConformingSection>& sections) {
  IdVector<SectionId, Nesting> nestings;
  for (const ConformingSection& section : sections) {
    Section given;
    for (const ContourId c : section.nesting.depth.ids()) {
      Contour contour;
      for (const PlaneVertexId v : IdRange<PlaneVertexId>(section.vertex_count())) {
        if (section.contour[v] == c) contour.vertices.push_back(section.point(v));
      }
      given.contours.push_back(contour);
    }
    nestings.push_back(internal::sections::complement_of(given, section.nesting, 1).nesting);
  }
  return nestings;
}

// Phase 3. None where the model is none in the unit given.
std::optional<Model> glued(const Folder& folder) {
  Plan plan = plan_from_record(folder.read("plan"), "plan").value();
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
  const bool holed = std::any_of(sections.begin(), sections.end(), [](const auto& section) {
    return section.nesting.region.size() > section.nesting.outer.size();
  });
  VoidOutcome of_voids =
      void_outcome(sections, plan.voids,
                   holed ? complements_of(sections) : IdVector<SectionId, Nesting>(), parts);
  Model model = glue(sections, plan.correspondence.component, std::move(parts));
  IdVector<SectionId, Nesting> nestings;
  for (const ConformingSection& section : sections) nestings.push_back(section.nesting);
  model.links = region_links(plan.correspondence.candidates, nestings);
  model.motions = plan.motions;
  model.void_links = std::move(of_voids.links);
  model.deviations = std::move(of_voids.deviations);
  if (!scale_exactly(model, -plan.exponent)) return std::nullopt;
  return model;
}

// What went through the files.
struct Seen {
  std::size_t models = 0, links = 0, leads = 0, motions = 0, void_links = 0;
  std::set<Evidence> evidences;
  std::set<LinkFate> fates;

  void add(const Model& model) {
    ++models;
    links += model.links.size();
    motions += model.motions.size();
    void_links += model.void_links.size();
    for (const RegionLink& link : model.links) {
      leads += link.lead ? 1U : 0U;
      evidences.insert(link.evidence);
      fates.insert(link.fate);
    }
  }
};

void expect_same_through_files(const SectionStack& stack, const ReconstructOptions& options,
                               Prng& prng, Seen& seen) {
  const Result<Reconstruction> direct = reconstruct(stack, options);
  if (!direct) return;
  std::optional<Model> model;
  for (const Unit unit : {Unit::of_the_stack, Unit::as_given}) {
    if (model) continue;
    const Folder folder;
    const auto error = plan_into(folder, stack, options, unit);
    EXPECT_FALSE(error) << to_string(*error);
    std::vector<SlabId> order = all_ids<SlabId>(stack.sections.size() - 1);
    for (std::size_t k = order.size(); k > 1; --k) {
      std::swap(order[k - 1], order[static_cast<std::size_t>(prng.below(k))]);
    }
    for (const SlabId slab : order) build_into(folder, slab);
    model = glued(folder);
  }
  ASSERT_TRUE(model.has_value());
  EXPECT_TRUE(same_bits(*model, direct->model));
  seen.add(direct->model);
}

TEST(Records, AStackBuiltThroughFilesInAnyOrderIsThatOfTheDirectRun) {
  Prng prng(910);
  Seen seen;
  for (const StackKind kind : all_kinds()) {
    const SectionStack stack = generate(kind, 911).stack;
    if (stack.vertex_count() > 1500) continue;
    SCOPED_TRACE(name_of(kind));
    for (const Criterion criterion : {Criterion::overlap, Criterion::reverse, Criterion::moved}) {
      ReconstructOptions options;
      options.correspondence.criterion = criterion;
      options.ends = seen.models % 2 == 0 ? Ends::half : Ends::flat;
      expect_same_through_files(stack, options, prng, seen);
    }
  }
  EXPECT_GT(seen.models, 75U);
  EXPECT_GT(seen.links, 500U);
  EXPECT_GT(seen.leads, 100U);
  EXPECT_GT(seen.motions, 100U);
  EXPECT_GT(seen.void_links, 20U);
  for (const Evidence evidence :
       {Evidence::overlap, Evidence::reverse, Evidence::motion, Evidence::chain, Evidence::lone}) {
    EXPECT_TRUE(seen.evidences.contains(evidence)) << name_of(evidence);
  }
  EXPECT_TRUE(seen.fates.contains(LinkFate::too_weak));
  EXPECT_TRUE(seen.fates.contains(LinkFate::outruled));
}

TEST(Records, SoIsASingleSection) {
  Prng prng(912);
  Seen seen;
  expect_same_through_files(stack_of_boxes({{box(0, 0, 4, 2)}}), {}, prng, seen);
  EXPECT_EQ(seen.models, 1U);
}

TEST(Records, SolidsAndPlansReadBackAsTheyWere) {
  for (const NamedSlab& s : generated_slabs(913, 1)) {
    SCOPED_TRACE(s.name);
    const SlabOutcome outcome =
        build_slab(SlabId(0), s.built->lower, s.built->upper, {s.built->links},
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

between::InnerSections one_section_between() {
  between::InnerSections inner;
  between::InnerSection mid;
  mid.section = stack_of_boxes({{box(0, 0, 4, 2), box(5, 0, 6, 2)}}).sections[SectionId(0)];
  mid.section.z = 0.5;
  mid.nesting = nest(mid.section);
  mid.class_of.assign(2, ClassId(1));
  inner.sections.push_back(mid);
  inner.links = {{{RegionId(0), RegionId(0)}, {RegionId(1), RegionId(1)}},
                 {{RegionId(1), RegionId(0)}}};
  return inner;
}

// Two sections of two regions each, with every evidence and fate, and a motion of each plane.
Plan plan_of_two_sections() {
  Plan plan;
  plan.exponent = -7;
  plan.gabriel.resize(2);
  plan.apart.resize(2);
  plan.divided.resize(2);
  plan.divided[SectionId(1)] = {{ContourId(0), 3, 4}, {ContourId(2), 0, 16}};
  plan.may_ask.assign(1, 1);
  plan.between.push_back(one_section_between());
  plan.apart[SectionId(0)] = {{0.5, -0.25}, {-0.0, 3}};
  Correspondence& c = plan.correspondence;
  c.links.resize(1);
  c.component.resize(2);
  c.partition.resize(2);
  for (const SectionId s : c.component.ids()) {
    c.component[s].resize(2, ComponentId(0));
    c.partition[s].resize(3, ComponentId(0));
  }
  c.candidates.resize(1);
  for (int k = 0; k < kEvidences; ++k) {
    LinkCandidate candidate;
    candidate.link = {SlabId(0), RegionId(k % 2), RegionId(k / 4)};
    candidate.evidence = static_cast<Evidence>(k);
    candidate.fate = static_cast<LinkFate>(k % kLinkFates);
    candidate.ratio = 0.1 * k;
    candidate.moved = 5e-324;
    candidate.distance = 1.0 / 3;
    candidate.margin = -0.0;
    if (k != 3) candidate.lead = k == 0 ? 0 : -1e300;
    c.candidates[SlabId(0)].push_back(candidate);
  }
  plan.motions = {{SlabId(0), false, ContourId(2), {0.1, -0.0}},
                  {SlabId(0), true, ContourId(0), {-1e-310, 3}}};
  // Voids, of a contour more, the frame.
  plan.voids = c;
  for (const SectionId s : c.partition.ids()) {
    plan.voids->partition[s].push_back(ComponentId(0));
    plan.voids->component[s].push_back(ComponentId(1));
  }
  plan.voids->links[SlabId(0)] = {{SlabId(0), RegionId(0), RegionId(0)},
                                  {SlabId(0), RegionId(1), RegionId(2)}};
  return plan;
}

TEST(Records, CandidatesAndMotionsOfAPlanReadBackBitForBit) {
  const Plan plan = plan_of_two_sections();
  const std::string bytes = to_record(plan);
  const Result<Plan> read = plan_from_record(bytes, "name");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(to_record(*read), bytes);
  EXPECT_TRUE(test::same_rows(read->motions, plan.motions));
  ASSERT_EQ(read->between.size(), 1U);
  EXPECT_EQ(read->between[SlabId(0)].links, plan.between[SlabId(0)].links);
  EXPECT_EQ(read->between[SlabId(0)].sections[0].class_of,
            plan.between[SlabId(0)].sections[0].class_of);
  Nesting nesting;
  nesting.outer = IdVector<RegionId, ContourId>({ContourId(0), ContourId(2)});
  const IdVector<SectionId, Nesting> nestings({nesting, nesting});
  EXPECT_TRUE(test::same_rows(region_links(read->correspondence.candidates, nestings),
                              region_links(plan.correspondence.candidates, nestings)));
  ASSERT_TRUE(read->voids);
  EXPECT_EQ(read->voids->links, plan.voids->links);
  EXPECT_EQ(read->voids->component, plan.voids->component);
  EXPECT_EQ(read->voids->partition, plan.voids->partition);
  EXPECT_TRUE(test::same_rows(void_links(read->voids->candidates, nestings),
                              void_links(plan.voids->candidates, nestings)));
  Plan without = plan;
  without.voids = std::nullopt;
  EXPECT_FALSE(plan_from_record(to_record(without), "name")->voids);
}

between::InnerSections& between_of(Plan& plan) { return plan.between[SlabId(0)]; }

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Records, PlansWithCandidatesOrMotionsThatThereAreNotAreRefused) {
  ASSERT_TRUE(plan_from_record(to_record(plan_of_two_sections()), "name"));
  using Spoil = void (*)(Plan&, LinkCandidate&);
  for (const auto& [why, spoil] : std::vector<std::pair<const char*, Spoil>>{
           {"no evidence",
            [](Plan&, LinkCandidate&c) { c.evidence = static_cast<Evidence>(kEvidences); }},
           {"no evidence or fate",
            [](Plan&, LinkCandidate&c) { c.fate = static_cast<LinkFate>(kLinkFates); }},
           {"not finite", [](Plan&, LinkCandidate&c) { c.ratio = kInfinity; }},
           {"not finite", [](Plan&, LinkCandidate&c) { c.moved = -kInfinity; }},
           {"not finite", [](Plan&, LinkCandidate&c) { c.distance = kInfinity - kInfinity; }},
           {"not finite", [](Plan&, LinkCandidate&c) { c.margin = kInfinity; }},
           {"not finite", [](Plan&, LinkCandidate&c) { c.lead = kInfinity; }},
           {"region", [](Plan&, LinkCandidate&c) { c.link.lower = RegionId(2); }},
           {"region", [](Plan&, LinkCandidate&c) { c.link.upper = RegionId(); }},
           {"some of its sections",
            [](Plan&p, LinkCandidate&) { p.correspondence.candidates.resize(2); }},
           {"void", [](Plan&p, LinkCandidate&) { p.voids->candidates[SlabId(0)][2].link.upper = RegionId(3); }},
           {"void", [](Plan&p, LinkCandidate&) { p.voids->links[SlabId(0)][1].lower = RegionId(3); }},
           {"evidence", [](Plan&p, LinkCandidate&) { p.voids->candidates[SlabId(0)][2].evidence = static_cast<Evidence>(kEvidences); }},
           {"some of its sections", [](Plan&p, LinkCandidate&) { p.voids->component.resize(3); }},
           {"other voids", [](Plan&p, LinkCandidate&) { p.voids->partition[SectionId(1)].resize(3); }},
           {"some of its sections", [](Plan&p, LinkCandidate&) { p.between.push_back({}); }},
           {"not valid", [](Plan&p, LinkCandidate&) { between_of(p).sections[0].section.contours.push_back({}); }},
           {"no class", [](Plan&p, LinkCandidate&) { between_of(p).sections[0].class_of[RegionId(1)] = ClassId(4); }},
           {"no class", [](Plan&p, LinkCandidate&) { between_of(p).sections[0].class_of.push_back(ClassId(0)); }},
           {"sections between", [](Plan&p, LinkCandidate&) { between_of(p).links.pop_back(); }},
           {"region between", [](Plan&p, LinkCandidate&) { between_of(p).links[0][1].above = RegionId(2); }},
           {"region between", [](Plan&p, LinkCandidate&) { between_of(p).links[1][0].above = RegionId(2); }},
           {"some of its sections", [](Plan&p, LinkCandidate&) { p.divided.resize(1); }},
           {"divides", [](Plan&p, LinkCandidate&) { p.divided[SectionId(1)][1].contour = ContourId(3); }},
           {"divides", [](Plan&p, LinkCandidate&) { p.divided[SectionId(1)][0].parts = 0; }},
           {"motion", [](Plan&p, LinkCandidate&) { p.motions[0].by.x = kInfinity; }},
           {"motion", [](Plan&p, LinkCandidate&) { p.motions[1].by.y = -kInfinity; }},
           {"contour", [](Plan&p, LinkCandidate&) { p.motions[0].contour = ContourId(3); }},
           {"contour", [](Plan&p, LinkCandidate&) { p.motions[1].contour = ContourId(); }},
           {"contour", [](Plan&p, LinkCandidate&) { p.motions[0].slab = SlabId(1); }},
           {"contour", [](Plan&p, LinkCandidate&) { p.motions[1].slab = SlabId(); }}}) {
    Plan plan = plan_of_two_sections();
    spoil(plan, plan.correspondence.candidates[SlabId(0)][5]);
    const Result<Plan> read = plan_from_record(to_record(plan), "name");
    ASSERT_FALSE(read) << why;
    EXPECT_EQ(read.error().code, ErrorCode::invalid_input);
    EXPECT_EQ(read.error().where.file, "name");
    EXPECT_NE(read.error().message.find(why), std::string::npos) << read.error().message;
  }
}

TEST(Records, WhatIsSignedButWrongIsRefusedOrStillInBounds) {
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 4, 2)}, {box(0, 0, 3, 2), box(5, 0, 6, 2)}, {box(1, 0, 2, 2)}});
  const Folder folder;
  ASSERT_FALSE(plan_into(folder, stack, {}, Unit::of_the_stack));
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
