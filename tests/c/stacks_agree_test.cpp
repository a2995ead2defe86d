// Stacks, labels and links of C are those of C++, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <tetloft/tetloft.hpp>

#include "c/owned.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::c_test {
namespace {

std::string sample(const std::string& name) { return TETLOFT_DATA_DIR "/cases/" + name + ".cnt"; }

std::vector<std::string> texts(const std::vector<Warning>& warnings) {
  std::vector<std::string> texts;
  for (const Warning& warning : warnings) texts.push_back(to_string(warning));
  return texts;
}

void expect_same_stack(const tetloft_stack* stack, const SectionStack& expected) {
  std::size_t sections = 0;
  std::size_t contours = 0;
  std::size_t vertices = 0;
  ASSERT_OK(tetloft_stack_counts(stack, &sections, &contours, &vertices));
  ASSERT_EQ(sections, expected.sections.size());
  EXPECT_EQ(contours, expected.contour_count());
  EXPECT_EQ(vertices, expected.vertex_count());
  for (std::size_t s = 0; s < sections; ++s) {
    const Section& section = expected.sections[SectionId(s)];
    double z = 0;
    ASSERT_OK(tetloft_stack_section(stack, s, &z, &contours));
    EXPECT_EQ(test::bits(z), test::bits(section.z));
    ASSERT_EQ(contours, section.contours.size());
    for (std::size_t c = 0; c < contours; ++c) {
      const Contour& contour = section.contours[ContourId(c)];
      const double* xy = nullptr;
      ASSERT_OK(tetloft_stack_contour(stack, s, c, &xy, &vertices));
      EXPECT_TRUE(same_array(xy, vertices, contour.vertices));
      double area = 0;
      ASSERT_OK(tetloft_stack_twice_area(stack, s, c, &area));
      EXPECT_EQ(test::bits(area), test::bits(twice_area(contour)));
    }
  }
}

void expect_same_nesting(const tetloft_stack* stack, std::size_t s, const Nesting& expected) {
  const std::size_t count = expected.depth.size();
  std::vector<std::uint32_t> parent(count);
  std::vector<std::uint32_t> depth(count);
  std::vector<std::uint32_t> region(count);
  std::size_t contours = 0;
  std::size_t regions = 0;
  ASSERT_OK(tetloft_stack_nesting(stack, s, parent.data(), depth.data(), region.data(), count,
                                  &contours, &regions));
  EXPECT_EQ(contours, count);
  EXPECT_EQ(regions, expected.outer.size());
  EXPECT_TRUE(count == 0 || same_array(parent.data(), count, expected.parent.raw()));
  EXPECT_EQ(depth, expected.depth.raw());
  EXPECT_TRUE(count == 0 || same_array(region.data(), count, expected.region.raw()));
}

TEST(StacksOfC, AreReadCreatedAndWrittenAsByCpp) {
  const test::TempFolder folder;
  for (const char* name : {"fork", "ring", "nested_hole"}) {
    SCOPED_TRACE(name);
    const ReadStack read = read_stack(sample(name)).value();
    Owned<tetloft_stack> stack;
    Owned<tetloft_warnings> warnings;
    ASSERT_OK(tetloft_stack_read(sample(name).c_str(), nullptr, stack.out(), warnings.out()));
    EXPECT_EQ(texts_of(warnings), texts(read.warnings));
    expect_same_stack(stack, read.stack);
    for (std::size_t s = 0; s < read.stack.sections.size(); ++s) {
      expect_same_nesting(stack, s, nest(read.stack.sections[SectionId(s)]));
    }
    const std::string bytes = test::get(sample(name));
    Owned<tetloft_stack> parsed;
    ASSERT_OK(
        tetloft_stack_parse(bytes.data(), bytes.size(), "a.cnt", nullptr, parsed.out(), nullptr));
    expect_same_stack(parsed, read.stack);

    std::vector<double> z;
    std::vector<double> xy;
    std::vector<std::size_t> contours;
    std::vector<std::size_t> vertices;
    for (const Section& section : read.stack.sections) {
      z.push_back(section.z);
      contours.push_back(section.contours.size());
      for (const Contour& contour : section.contours) {
        vertices.push_back(contour.vertices.size());
        for (const Point2& p : contour.vertices) xy.insert(xy.end(), {p.x, p.y});
      }
    }
    Owned<tetloft_stack> created;
    ASSERT_OK(tetloft_stack_create(z.data(), contours.data(), z.size(), vertices.data(),
                                   vertices.size(), xy.data(), xy.size() / 2, created.out()));
    expect_same_stack(created, read.stack);
    EXPECT_OK(tetloft_stack_validate(created, nullptr));

    const std::string path = folder.file("a.cnt");
    ASSERT_OK(tetloft_stack_write(created, path.c_str(), nullptr, nullptr));
    const std::string written = format_stack(read.stack, {.format = "cnt"}).value().bytes;
    EXPECT_EQ(test::get(path), written);
    tetloft_write_options options;
    ASSERT_OK(tetloft_write_options_defaults(&options));
    options.format = "cnt";
    Owned<tetloft_bytes> formatted;
    ASSERT_OK(tetloft_stack_format(created, &options, formatted.out(), nullptr));
    EXPECT_EQ(bytes_of(formatted), written);
  }
}

TEST(StacksOfC, CountsThatDoNotAddUpAreRefused) {
  const std::vector<double> z{0, 1};
  const std::vector<double> xy(14);
  Owned<tetloft_stack> stack;
  const auto create = [&](std::vector<std::size_t> contours, std::vector<std::size_t> vertices,
                          std::size_t contour_count, std::size_t vertex_count) {
    return tetloft_stack_create(z.data(), contours.data(), contours.size(), vertices.data(),
                                contour_count, xy.data(), vertex_count, stack.out());
  };
  constexpr std::size_t kMost = static_cast<std::size_t>(-1);
  EXPECT_OK(create({1, 1}, {3, 4}, 2, 7));
  EXPECT_OK(create({0, 2}, {3, 4}, 2, 7));
  EXPECT_EQ(create({1, 2}, {3, 4}, 2, 7), TETLOFT_USAGE);
  EXPECT_EQ(create({1, 0}, {3, 4}, 2, 7), TETLOFT_USAGE);
  EXPECT_EQ(create({kMost, 3}, {3, 4}, 2, 7), TETLOFT_USAGE);
  EXPECT_EQ(create({1, 1}, {3, 5}, 2, 7), TETLOFT_USAGE);
  EXPECT_EQ(create({1, 1}, {3, 3}, 2, 7), TETLOFT_USAGE);
  EXPECT_EQ(create({1, 1}, {kMost, 8}, 2, 7), TETLOFT_USAGE);
  EXPECT_EQ(tetloft_stack_create(nullptr, nullptr, 0, nullptr, 0, nullptr, 0, stack.out()),
            TETLOFT_OK);
  EXPECT_EQ(tetloft_stack_validate(stack, nullptr), TETLOFT_INVALID_INPUT);
}

TEST(StacksOfC, AreMadeFitAsByCpp) {
  SectionStack crossing;
  for (const double z : {0.0, 1.0}) {
    Section section;
    section.z = z;
    section.contours.push_back({{{0, 0}, {4, 4.125}, {4, 0}, {0, 4}}});
    crossing.sections.push_back(section);
  }
  const std::vector<double> z{0, 1};
  const std::vector<std::size_t> ones{1, 1};
  const std::vector<std::size_t> fours{4, 4};
  const std::vector<double> xy{0, 0, 4, 4.125, 4, 0, 0, 4, 0, 0, 4, 4.125, 4, 0, 0, 4};
  Owned<tetloft_stack> stack;
  ASSERT_OK(
      tetloft_stack_create(z.data(), ones.data(), 2, fours.data(), 2, xy.data(), 8, stack.out()));
  EXPECT_EQ(tetloft_stack_validate(stack, nullptr), TETLOFT_INVALID_INPUT);
  EXPECT_EQ(std::string(tetloft_last_error()), to_string(validate(crossing).error()));
  const auto nesting = [&](std::size_t section) {
    return tetloft_stack_nesting(stack, section, nullptr, nullptr, nullptr, 0, nullptr, nullptr);
  };
  EXPECT_EQ(nesting(1), TETLOFT_INVALID_INPUT);
  tetloft_place place;
  place.version = TETLOFT_PLACE_VERSION;
  ASSERT_OK(tetloft_last_place(&place));
  EXPECT_EQ(place.section, 1);

  for (const double distance : {-1.0, 0.5}) {
    RepairOptions options;
    if (distance >= 0) options.distance = distance;
    const Repaired expected = repair(crossing, options).value();
    Owned<tetloft_stack> repaired;
    Owned<tetloft_warnings> changes;
    ASSERT_OK(tetloft_stack_repair(stack, distance, nullptr, repaired.out(), changes.out()));
    expect_same_stack(repaired, expected.stack);
    EXPECT_EQ(texts_of(changes), texts(expected.changes));
    EXPECT_FALSE(expected.changes.empty());
    Owned<tetloft_stack> snapped;
    ASSERT_OK(tetloft_stack_snap(repaired, 12, nullptr, snapped.out()));
    expect_same_stack(snapped, snap(expected.stack, 12).value().stack);
    Owned<tetloft_stack> refined;
    ASSERT_OK(tetloft_stack_refine(repaired, 0.3, nullptr, refined.out()));
    expect_same_stack(refined, refine(expected.stack, 0.3).value().stack);
  }
  Owned<tetloft_stack> none;
  EXPECT_EQ(tetloft_stack_repair(stack, std::nan(""), nullptr, none.out(), nullptr), TETLOFT_USAGE);
  EXPECT_EQ(tetloft_stack_snap(stack, 0, nullptr, none.out()), TETLOFT_USAGE);
  EXPECT_EQ(tetloft_stack_refine(stack, std::nan(""), nullptr, none.out()), TETLOFT_USAGE);
}

TEST(StacksOfC, AreRepairedByAllOptionsAsInCpp) {
  // A channel of 0.2, a copy, and a square that overlaps it.
  const Contour keyhole{{{0, 0},
                         {10, 0},
                         {10, 4.9},
                         {7, 4.9},
                         {7, 3},
                         {3, 3},
                         {3, 7},
                         {7, 7},
                         {7, 5.1},
                         {10, 5.1},
                         {10, 10},
                         {0, 10}}};
  const Contour square{{{-2, 1}, {2, 1}, {2, 2}, {-2, 2}}};
  SectionStack given;
  given.sections.push_back({0, {}});
  for (const Contour& contour : {keyhole, keyhole, square}) {
    given.sections[SectionId(0)].contours.push_back(contour);
  }
  const std::string text = format_cnt(given).value();
  tetloft_read_options reading;
  ASSERT_OK(tetloft_read_options_defaults(&reading));
  reading.unchecked = 1;
  Owned<tetloft_stack> stack;
  ASSERT_OK(tetloft_stack_parse(text.data(), text.size(), "a.cnt", &reading, stack.out(), nullptr));
  tetloft_repair_options options;
  ASSERT_OK(tetloft_repair_options_defaults(&options));
  for (const int fill : {TETLOFT_FILL_ODD, TETLOFT_FILL_UNION, TETLOFT_FILL_WINDING}) {
    options.fill = fill;
    options.keyholes = 0.25;
    const Repaired expected =
        repair(given, {.fill = static_cast<FillRule>(fill), .keyholes = 0.25}).value();
    Owned<tetloft_stack> repaired;
    Owned<tetloft_warnings> changes;
    tetloft_repair_report report{};
    report.version = TETLOFT_REPAIR_REPORT_VERSION;
    ASSERT_OK(tetloft_stack_repair_by(stack, &options, repaired.out(), &report, changes.out()));
    expect_same_stack(repaired, expected.stack);
    EXPECT_EQ(texts_of(changes), texts(expected.changes));
    EXPECT_EQ(report.moved, expected.moved);
    EXPECT_EQ(report.area_before, expected.area_before);
    EXPECT_EQ(report.area_after, expected.area_after);
    EXPECT_EQ(report.copies, 1U);
    EXPECT_EQ(report.channels, 1U);
    EXPECT_EQ(report.lost, 0U);
  }
  const auto status = [&] {
    Owned<tetloft_stack> none;
    tetloft_repair_report report{};
    report.version = TETLOFT_REPAIR_REPORT_VERSION;
    return tetloft_stack_repair_by(stack, &options, none.out(), &report, nullptr);
  };
  options.keyholes = -1;
  EXPECT_EQ(status(), TETLOFT_USAGE);
  options.keyholes = 0;
  EXPECT_OK(status());
  options.fill = 3;
  EXPECT_EQ(status(), TETLOFT_USAGE);
}

TEST(StacksOfC, AreReadByAllOptionsAsInCpp) {
  // Two labels in three planes x = const: turned, and told with the stack.
  std::string text = "CSLC\n3 3\n";
  for (int plane = 1; plane <= 3; ++plane) {
    const std::string x = std::to_string(plane);
    text += '\n' + x + " 6 2 1 0 0 -" + x + "\n\n";
    for (const char* yz : {" 0 0", " 4 0", " 0 4", " 10 0", " 14 0", " 10 4"})
      text += x + yz + '\n';
    text += "\n3 1 0 1 2\n3 2 3 4 5\n";
  }
  tetloft_stack_options options;
  ASSERT_OK(tetloft_stack_options_defaults(&options));
  Owned<tetloft_stack> stack;
  Owned<tetloft_labels> labels;
  Owned<tetloft_warnings> warnings;
  ASSERT_OK(tetloft_stack_parse_by(text.data(), text.size(), "a.csl", &options, stack.out(),
                                   labels.out(), warnings.out()));
  const ReadStack expected = parse_stack(text, "a.csl").value();
  expect_same_stack(stack, expected.stack);
  EXPECT_EQ(expected.labels.labels.size(), 6U);
  Owned<tetloft_bytes> lines;
  ASSERT_OK(tetloft_labels_format(labels, lines.out()));
  EXPECT_EQ(bytes_of(lines), format_labels(expected.labels).value());
  EXPECT_EQ(texts_of(warnings), texts(expected.warnings));

  options.structure = "2";
  Owned<tetloft_stack> one;
  ASSERT_OK(tetloft_stack_parse_by(text.data(), text.size(), "a.csl", &options, one.out(), nullptr,
                                   nullptr));
  ReadOptions reading;
  reading.structure = "2";
  expect_same_stack(one, parse_stack(text, "a.csl", reading).value().stack);
  const auto status = [&] {
    Owned<tetloft_stack> none;
    return tetloft_stack_parse_by(text.data(), text.size(), "a.csl", &options, none.out(), nullptr,
                                  nullptr);
  };
  options.structure = "3";
  EXPECT_EQ(status(), TETLOFT_USAGE);
  options.structure = nullptr;
  options.plane_tolerance = -1;
  EXPECT_EQ(status(), TETLOFT_USAGE);
  options.plane_tolerance = 0;
  options.axis = 4;
  EXPECT_EQ(status(), TETLOFT_USAGE);
}

TEST(StacksOfC, HaveTheirPlanesArrangedAsInCpp) {
  const SectionStack given = read_cnt(sample("fork")).value().stack;
  SectionStack turned = given;
  std::reverse(turned.sections.begin(), turned.sections.end());
  const std::string text = format_cnt(turned).value();
  tetloft_read_options reading;
  ASSERT_OK(tetloft_read_options_defaults(&reading));
  reading.unchecked = 1;
  Owned<tetloft_stack> stack;
  ASSERT_OK(tetloft_stack_parse(text.data(), text.size(), "a.cnt", &reading, stack.out(), nullptr));
  for (const std::int32_t rule : {TETLOFT_PLANES_SORT, TETLOFT_PLANES_FLIP}) {
    Owned<tetloft_stack> arranged;
    ASSERT_OK(tetloft_stack_arrange_planes(stack, rule, 0, arranged.out(), nullptr));
    expect_same_stack(arranged, given);
  }
  Owned<tetloft_stack> one;
  Owned<tetloft_warnings> changes;
  ASSERT_OK(
      tetloft_stack_arrange_planes(stack, TETLOFT_PLANES_MERGE, 1e9, one.out(), changes.out()));
  const ArrangedPlanes expected = arrange_planes(turned, {PlaneRule::merge, 1e9}).value();
  expect_same_stack(one, expected.stack);
  EXPECT_EQ(texts_of(changes), texts(expected.changes));
  EXPECT_FALSE(expected.changes.empty());
  Owned<tetloft_stack> none;
  EXPECT_EQ(tetloft_stack_arrange_planes(stack, TETLOFT_PLANES_MERGE, 0, none.out(), nullptr),
            TETLOFT_USAGE);
  EXPECT_EQ(tetloft_stack_arrange_planes(stack, 3, 1, none.out(), nullptr), TETLOFT_USAGE);
}

// Labels on the contours of data/cases/fork: the first of each section.
const std::vector<tetloft_label> kLabels{{0, 0, 7}, {1, 0, 7}};
const std::vector<tetloft_decision> kDecisions{{0, 0, 1, 0}};

TEST(LabelsOfC, AreThoseOfCpp) {
  const Labels expected{
      .labels = {{SectionId(0), ContourId(0), 7}, {SectionId(1), ContourId(0), 7}},
      .decisions = {{SlabId(0), ContourId(0), ContourId(1), false}},
      .hole_labels = {{SectionId(0), ContourId(0), 7}, {SectionId(1), ContourId(0), 7}},
      .void_decisions = {{SlabId(0), ContourId(), ContourId(1), true}}};
  const std::vector<tetloft_decision> of_voids{{0, TETLOFT_NO_ID, 1, 1}};
  Owned<tetloft_labels> labels;
  ASSERT_OK(tetloft_labels_create(kLabels.data(), 2, kDecisions.data(), 1, kLabels.data(), 2,
                                  of_voids.data(), 1, labels.out()));
  const std::string text = format_labels(expected).value();
  Owned<tetloft_bytes> bytes;
  ASSERT_OK(tetloft_labels_format(labels, bytes.out()));
  EXPECT_EQ(bytes_of(bytes), text);
  const test::TempFolder folder;
  const std::string path = folder.file("a.labels");
  ASSERT_OK(tetloft_labels_write(labels, path.c_str()));
  EXPECT_EQ(test::get(path), text);
  ASSERT_OK(tetloft_labels_read(path.c_str(), labels.out()));
  ASSERT_OK(tetloft_labels_format(labels, bytes.out()));
  EXPECT_EQ(bytes_of(bytes), text);
  ASSERT_OK(tetloft_labels_parse(text.data(), text.size(), "a", labels.out()));
  ASSERT_OK(tetloft_labels_format(labels, bytes.out()));
  EXPECT_EQ(bytes_of(bytes), text);
}

void expect_same_links(const tetloft_link* links, std::size_t count,
                       const std::vector<RegionLink>& expected) {
  ASSERT_EQ(count, expected.size());
  for (std::size_t i = 0; i < count; ++i) {
    const RegionLink& link = expected[i];
    EXPECT_EQ(links[i].slab, link.slab.value());
    EXPECT_EQ(links[i].lower, link.lower.value());
    EXPECT_EQ(links[i].upper, link.upper.value());
    EXPECT_STREQ(tetloft_evidence_name(links[i].evidence), name_of(link.evidence));
    EXPECT_STREQ(tetloft_fate_name(links[i].fate), name_of(link.fate));
    EXPECT_EQ(links[i].ratio, link.ratio);
    EXPECT_EQ(links[i].moved, link.moved);
    EXPECT_EQ(links[i].distance, link.distance);
    EXPECT_EQ(links[i].margin, link.margin);
    EXPECT_EQ(std::isnan(links[i].lead), !link.lead.has_value());
    if (link.lead) {
      EXPECT_EQ(links[i].lead, *link.lead);
    }
  }
}

TEST(LinksOfC, AreThoseOfCpp) {
  for (const char* name : {"fork", "ring", "nested_hole"}) {
    for (const bool labelled : {false, true}) {
      SCOPED_TRACE(std::string(name) + (labelled ? ", labelled" : ""));
      const SectionStack expected_stack = read_stack(sample(name)).value().stack;
      LinkOptions expected_options;
      expected_options.correspondence.criterion = Criterion::overlap;
      expected_options.correspondence.voids.rule = VoidRule::near;
      Owned<tetloft_stack> stack;
      ASSERT_OK(tetloft_stack_read(sample(name).c_str(), nullptr, stack.out(), nullptr));
      Owned<tetloft_labels> labels;
      tetloft_correspondence options;
      ASSERT_OK(tetloft_correspondence_defaults(&options));
      options.criterion = TETLOFT_OVERLAP;
      options.void_rule = TETLOFT_VOIDS_NEAR;
      if (labelled) {
        expected_options.correspondence.labels = {{SectionId(0), ContourId(0), 7},
                                                  {SectionId(1), ContourId(0), 7}};
        ASSERT_OK(tetloft_labels_create(kLabels.data(), 2, nullptr, 0, nullptr, 0, nullptr, 0,
                                        labels.out()));
        options.labels = labels;
      }
      const StackLinks expected = find_links(expected_stack, expected_options).value();
      Owned<tetloft_links> links;
      Owned<tetloft_warnings> warnings;
      ASSERT_OK(tetloft_links_find(stack, &options, nullptr, links.out(), warnings.out()));
      EXPECT_EQ(texts_of(warnings), texts(expected.warnings));
      const tetloft_link* array = nullptr;
      std::size_t count = 0;
      ASSERT_OK(tetloft_links_regions(links, &array, &count));
      expect_same_links(array, count, expected.links);
      ASSERT_OK(tetloft_links_voids(links, &array, &count));
      expect_same_links(array, count, {expected.void_links.begin(), expected.void_links.end()});
      std::size_t components = 0;
      std::size_t cavities = 0;
      ASSERT_OK(tetloft_links_counts(links, &components, &cavities));
      EXPECT_EQ(components, expected.components);
      EXPECT_EQ(cavities, expected.cavities);
      for (std::size_t s = 0; s < expected.partition.size(); ++s) {
        const std::uint32_t* component = nullptr;
        ASSERT_OK(tetloft_links_partition(links, s, &component, &count));
        EXPECT_TRUE(same_array(component, count, expected.partition[SectionId(s)].raw()));
      }
    }
  }
}

}  // namespace
}  // namespace tetloft::c_test
