// The tables of a model, its links, motions and deviations, in unstructured grids.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/io.hpp>

#include "core/little_endian.hpp"
#include "core/prng.hpp"
#include "io/base64.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string written(const Model& model, Encoding encoding) {
  const auto bytes = format_vtu(model, encoding);
  EXPECT_TRUE(bytes.ok()) << to_string(bytes.error());
  return *bytes;
}

std::size_t count_of(const std::string& word, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

// Any bits that are a finite number.
double random_number(Prng& prng) {
  for (;;) {
    const double value = std::bit_cast<double>(prng.below(~std::uint64_t{0}));
    if (std::isfinite(value)) return value;
  }
}

RegionLink random_link(Prng& prng) {
  const auto index = [&] { return prng.below(4) == 0 ? 0x7FFFFFFFU : prng.below(1000); };
  RegionLink link{SlabId(index()),
                  ContourId(index()),
                  ContourId(index()),
                  static_cast<Evidence>(prng.below(kEvidences)),
                  static_cast<LinkFate>(prng.below(kLinkFates)),
                  random_number(prng),
                  random_number(prng),
                  random_number(prng),
                  random_number(prng),
                  {}};
  if (prng.below(2) == 0) link.lead = random_number(prng);
  return link;
}

Model random_tables(Prng& prng) {
  Model model = test::hard_model();
  model.links.clear();
  model.motions.clear();
  model.void_links.clear();
  model.deviations.clear();
  const auto index = [&] { return prng.below(4) == 0 ? 0x7FFFFFFFU : prng.below(1000); };
  for (std::uint64_t n = prng.below(40); n > 0; --n) model.links.push_back(random_link(prng));
  for (std::uint64_t n = prng.below(40); n > 0; --n) {
    model.motions.push_back({SlabId(index()),
                             prng.below(2) == 0,
                             ContourId(index()),
                             {random_number(prng), random_number(prng)}});
  }
  for (std::uint64_t n = prng.below(40); n > 0; --n) {
    VoidLink link{random_link(prng)};
    if (prng.below(3) == 0) link.lower = ContourId();
    if (prng.below(3) == 0) link.upper = ContourId();
    link.planes = static_cast<VoidPlanes>(prng.below(kVoidPlanes));
    model.void_links.push_back(link);
  }
  for (std::uint64_t n = prng.below(40); n > 0; --n) {
    const auto chi = [&] { return static_cast<std::int32_t>(prng.below(1U << 31)) - (1 << 30); };
    model.deviations.push_back(
        {SlabId(index()), prng.below(2) == 0, ContourId(index()), chi(), chi()});
  }
  return model;
}

TEST(VtuTables, ReadBackBitForBit) {
  Prng prng(31);
  for (int trial = 0; trial < 200; ++trial) {
    const Model model = random_tables(prng);
    for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
      const std::string bytes = written(model, encoding);
      const auto read = parse_vtu(bytes, "m.vtu");
      ASSERT_TRUE(read.ok()) << to_string(read.error());
      test::expect_same(model, *read);
      EXPECT_EQ(written(*read, encoding), bytes);
    }
  }
}

TEST(VtuTables, AreDataOfTheWholeGridWithTheirCounts) {
  const Model model = test::hard_model();
  for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
    const std::string bytes = written(model, encoding);
    const std::size_t from = bytes.find("<FieldData>");
    const std::size_t to = bytes.find("</FieldData>");
    ASSERT_NE(from, std::string::npos);
    EXPECT_LT(bytes.find("<UnstructuredGrid>"), from);
    EXPECT_LT(to, bytes.find("<Piece "));
    const std::string inside = bytes.substr(from, to - from);
    EXPECT_EQ(count_of("NumberOfTuples=\"" + std::to_string(model.links.size()) + '"', inside),
              11U);
    EXPECT_EQ(count_of("NumberOfTuples=\"" + std::to_string(model.motions.size()) + '"', inside),
              5U);
    EXPECT_EQ(count_of("NumberOfTuples=\"" + std::to_string(model.void_links.size()) + '"', inside),
              12U);
    EXPECT_EQ(count_of("NumberOfTuples=\"" + std::to_string(model.deviations.size()) + '"', inside),
              6U);
    EXPECT_EQ(count_of("NumberOfTuples", bytes), 34U);
  }
}

TEST(VtuTables, AreLeftOutWhereEmpty) {
  Model model = test::hard_model();
  model.links.clear();
  EXPECT_EQ(count_of("Name=\"link_", written(model, Encoding::binary)), 0U);
  EXPECT_EQ(count_of("Name=\"motion_", written(model, Encoding::binary)), 5U);
  model.void_links.clear();
  EXPECT_EQ(count_of("Name=\"void_", written(model, Encoding::binary)), 0U);
  EXPECT_EQ(count_of("Name=\"deviation_", written(model, Encoding::binary)), 6U);
  model.motions.clear();
  model.deviations.clear();
  EXPECT_EQ(count_of("FieldData", written(model, Encoding::binary)), 0U);
  const auto read = parse_vtu(written(model, Encoding::binary), "m.vtu");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->links.empty());
  EXPECT_TRUE(read->motions.empty());
  EXPECT_TRUE(read->void_links.empty());
  EXPECT_TRUE(read->deviations.empty());
}

// Of text: the DataArray element of a column.
std::pair<std::size_t, std::size_t> element_of(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("Name=\"" + name + '"');
  const std::size_t from = text.rfind("<DataArray", at);
  const std::size_t to = text.find("</DataArray>", at) + 12;
  return {from, to - from};
}

std::string with(std::string text, const std::string& name, const std::string& element) {
  const auto [from, size] = element_of(text, name);
  return text.replace(from, size, element);
}

std::string column(const std::string& type, const std::string& name, const std::string& values,
                   const std::string& rest = "") {
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" " + rest + " format=\"ascii\">" +
         values + "</DataArray>";
}

const std::vector<std::string> kColumns{
    "link_slab",       "link_lower",     "link_upper",     "link_evidence",   "link_fate",
    "link_ratio",      "link_moved",     "link_distance",  "link_margin",     "link_has_lead",
    "link_lead",       "motion_slab",    "motion_upper",   "motion_contour",  "motion_x",
    "motion_y",        "void_slab",      "void_lower",     "void_upper",      "void_evidence",
    "void_fate",       "void_ratio",     "void_moved",     "void_distance",   "void_margin",
    "void_has_lead",   "void_lead",      "deviation_slab", "deviation_upper", "deviation_contour",
    "deviation_least", "deviation_most", "deviation_got",  "void_planes"};

bool is_number(const std::string& name) {
  return name.ends_with("_x") || name.ends_with("_y") || name.ends_with("ratio") ||
         name.ends_with("moved") || name.ends_with("distance") || name.ends_with("margin") ||
         name == "link_lead" || name == "void_lead";
}
// Calls with(rows): those of the column's table.
template <class With>
auto with_rows(Model& model, const std::string& name, const With& with) {
  if (name.starts_with("link")) return with(model.links);
  if (name.starts_with("motion")) return with(model.motions);
  if (name.starts_with("void")) return with(model.void_links);
  return with(model.deviations);
}
std::size_t rows_of(const std::string& name) {
  Model model = test::hard_model();
  return with_rows(model, name, [](const auto& rows) { return rows.size(); });
}
// The largest number below those that the column may hold.
const char* too_low(const std::string& name) {
  if (name == "deviation_least" || name == "deviation_most" || name == "deviation_got")
    return "-2147483649";
  return name == "void_lower" || name == "void_upper" ? "-2" : "-1";
}
std::string repeated(const std::string& value, std::size_t times) {
  std::string text;
  for (; times > 0; --times) text += value + ' ';
  return text;
}

// The table is left out, the others and the rest are there.
void expect_without_table(const std::string& bytes, const std::string& name) {
  const auto read = parse_vtu(bytes, "m.vtu");
  ASSERT_TRUE(read.ok()) << name << ": " << to_string(read.error());
  Model rest = test::hard_model();
  with_rows(rest, name, [](auto& rows) { rows.clear(); });
  test::expect_same(rest, *read);
}

TEST(VtuTables, AreIgnoredWhereAColumnIsMissingOrMeansSomethingElse) {
  const std::string text = written(test::hard_model(), Encoding::ascii);
  for (const std::string& name : kColumns) {
    const std::size_t rows = rows_of(name);
    expect_without_table(with(text, name, ""), name);
    const char* const other = is_number(name) ? "Int32" : "Float64";
    expect_without_table(with(text, name, column(other, name, repeated("0", rows))), name);
    expect_without_table(with(text, name,
                              column(is_number(name) ? "Float64" : "Int32", name,
                                     repeated("0", 2 * rows), "NumberOfComponents=\"2\"")),
                         name);
    expect_without_table(with(text, name, column("String", name, repeated("0", rows))), name);
    if (is_number(name)) continue;
    for (const char* value : {too_low(name), "2147483648"}) {
      expect_without_table(with(text, name, column("Int64", name, repeated(value, rows))), name);
    }
  }
  for (const auto& [name, value] :
       {std::pair("link_evidence", kEvidences), std::pair("link_fate", kLinkFates),
        std::pair("link_has_lead", 2), std::pair("motion_upper", 2),
        std::pair("void_evidence", kEvidences), std::pair("void_fate", kLinkFates),
        std::pair("void_has_lead", 2), std::pair("deviation_upper", 2)}) {
    expect_without_table(
        with(text, name, column("UInt8", name, repeated(std::to_string(value), rows_of(name)))),
        name);
  }
}

TEST(VtuTables, WithNumbersThatAreNotFiniteAreIgnored) {
  const std::string name = "link_margin";
  std::vector<double> margins(rows_of(name), 0.5);
  std::string data;
  append_little(data, static_cast<std::uint64_t>(8 * margins.size()));
  margins.back() = kInfinity;
  for (const double margin : margins) append_little(data, margin);
  const std::string element = "<DataArray type=\"Float64\" Name=\"" + name +
                              "\" format=\"binary\">" + io::encode_base64(data) + "</DataArray>";
  expect_without_table(with(written(test::hard_model(), Encoding::ascii), name, element), name);
}

// What one column says of the rows, and what it holds itself, are facts of the same table.
TEST(VtuTables, OfUnequalColumnsAreRefused) {
  const std::string text = written(test::hard_model(), Encoding::ascii);
  for (const std::string& name : kColumns) {
    const std::size_t rows = rows_of(name);
    const char* const type = is_number(name) ? "Float64" : "Int32";
    for (const std::size_t n : {std::size_t{0}, rows - 1, rows + 1}) {
      const auto read = parse_vtu(with(text, name, column(type, name, repeated("0", n))), "m.vtu");
      ASSERT_FALSE(read.ok()) << name;
      EXPECT_EQ(read.error().code, ErrorCode::invalid_input);
      EXPECT_TRUE(read.error().where.line.has_value());
      EXPECT_NE(read.error().message.find("data array"), std::string::npos) << read.error().message;
    }
    for (const char* announced : {"0", "1", "9223372036854775807", "-1", "x"}) {
      const auto read = parse_vtu(with(text, name,
                                       column(type, name, repeated("0", rows),
                                              "NumberOfTuples=\"" + std::string(announced) + '"')),
                                  "m.vtu");
      EXPECT_FALSE(read.ok()) << name << ' ' << announced;
    }
    EXPECT_TRUE(parse_vtu(with(text, name, column(type, name, repeated("0", rows))), "m.vtu").ok());
  }
}

TEST(VtuTables, MayStandBehindThePiece) {
  std::string text = written(test::hard_model(), Encoding::ascii);
  const std::size_t from = text.find("<FieldData>");
  const std::size_t size = text.find("</FieldData>") + 12 - from;
  const std::string tables = text.substr(from, size);
  text.erase(from, size);
  text.insert(text.find("</UnstructuredGrid>"), tables);
  const auto read = parse_vtu(text, "m.vtu");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  test::expect_same(test::hard_model(), *read);
}

// Columns elsewhere are none: data of a piece, or deeper.
TEST(VtuTables, AreReadFromTheGridAlone) {
  std::string text = written(test::hard_model(), Encoding::ascii);
  for (const auto& [from, to] : {std::pair("<FieldData>", "<Other><FieldData>"),
                                 std::pair("</FieldData>", "</FieldData></Other>")}) {
    text.replace(text.find(from), std::string(from).size(), to);
  }
  const auto read = parse_vtu(text, "m.vtu");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->links.empty());
  EXPECT_TRUE(read->motions.empty());
  EXPECT_TRUE(read->void_links.empty());
  EXPECT_TRUE(read->deviations.empty());
}

TEST(VtuTables, ThatCannotBeReadBackAreNotWritten) {
  const auto refused = [](auto&& spoil, const char* word) {
    Model model = test::hard_model();
    spoil(model);
    const auto bytes = format_vtu(model);
    ASSERT_FALSE(bytes.ok()) << word;
    EXPECT_EQ(bytes.error().code, ErrorCode::invalid_input);
    EXPECT_NE(bytes.error().message.find(word), std::string::npos) << bytes.error().message;
  };
  refused([](Model& m) { m.links[0].slab = SlabId(); }, "link_slab");
  refused([](Model& m) { m.links[1].lower = ContourId(0x80000000U); }, "link 1");
  refused([](Model& m) { m.links[0].upper = ContourId(); }, "link_upper");
  refused([](Model& m) { m.links[0].evidence = static_cast<Evidence>(kEvidences); },
          "link_evidence");
  refused([](Model& m) { m.links[0].fate = static_cast<LinkFate>(kLinkFates); }, "link_fate");
  refused([](Model& m) { m.links[0].ratio = std::numeric_limits<double>::quiet_NaN(); },
          "link_ratio");
  refused([](Model& m) { m.links[0].moved = kInfinity; }, "link_moved");
  refused([](Model& m) { m.links[0].distance = kInfinity; }, "link_distance");
  refused([](Model& m) { m.links[0].margin = -kInfinity; }, "link_margin");
  refused([](Model& m) { m.links[0].lead = kInfinity; }, "link_lead");
  refused([](Model& m) { m.motions[0].slab = SlabId(); }, "motion_slab");
  refused([](Model& m) { m.motions[0].contour = ContourId(); }, "motion_contour");
  refused([](Model& m) { m.motions[0].by.x = kInfinity; }, "motion_x");
  refused([](Model& m) { m.motions[0].by.y = kInfinity; }, "motion_y");
  refused([](Model& m) { m.void_links[2].slab = SlabId(); }, "void_slab");
  refused([](Model& m) { m.void_links[0].ratio = kInfinity; }, "void_ratio");
  refused([](Model& m) { m.void_links[0].fate = static_cast<LinkFate>(kLinkFates); }, "void_fate");
  refused([](Model& m) { m.deviations[1].slab = SlabId(); }, "deviation_slab");
  refused([](Model& m) { m.deviations[0].contour = ContourId(); }, "deviation_contour");
}

}  // namespace
}  // namespace tetloft
