// The table of formats: what it promises of each, how one is chosen, and that what writers make
// is recognised and read back.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include <tetloft/formats.hpp>

#include "io/formats.hpp"
#include "model/fields.hpp"
#include "model/tables.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

using io::Direction;
using io::Format;
using io::format_table;
using test::TempFolder;

std::vector<Contents> all_contents() {
  std::vector<Contents> all;
  for (int k = 0; k < kContents; ++k) all.push_back(static_cast<Contents>(k));
  return all;
}

SectionStack two_triangles() {
  SectionStack stack;
  for (const double z : {0.1, 1.0 / 3}) {
    Section section{z, {}};
    section.contours.push_back({{{0.1, 0}, {1e22, 5e-324}, {1.0 / 3, 7}}});
    stack.sections.push_back(section);
  }
  return stack;
}

std::vector<Point3> hard_points() { return test::hard_model().points.raw(); }

// Well within float32.
Model one_tet() {
  Model model;
  for (const Point3& p : std::vector<Point3>{{0.5, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}}) {
    model.points.push_back(p);
  }
  model.tets.push_back({VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  return model;
}

TEST(FormatTable, NamesEachFormatOnce) {
  std::set<std::string_view> names;
  for (const FormatInfo& format : formats()) {
    EXPECT_TRUE(names.insert(format.name).second) << format.name;
    EXPECT_FALSE(format.summary.empty()) << format.name;
  }
  EXPECT_EQ(names.size(), format_table().size());
}

TEST(FormatTable, HasExtensionsThatTellTheFormat) {
  for (const FormatInfo& format : formats()) {
    EXPECT_FALSE(format.extensions.empty()) << format.name;
    for (const std::string_view extension : format.extensions) {
      EXPECT_TRUE(extension.size() > 1 && extension.front() == '.') << format.name;
      EXPECT_TRUE(std::none_of(extension.begin(), extension.end(),
                               [](char c) { return c >= 'A' && c <= 'Z'; }));
    }
  }
  for (const Contents contents : all_contents()) {
    for (const Direction direction : {Direction::reading, Direction::writing}) {
      std::set<std::string_view> seen;
      for (const FormatInfo& format : formats()) {
        const ContentsSet& set = direction == Direction::reading ? format.reads : format.writes;
        if (!set.has(contents)) continue;
        for (const std::string_view extension : format.extensions) {
          EXPECT_TRUE(seen.insert(extension).second) << name_of(contents) << extension;
        }
      }
    }
  }
}

TEST(FormatTable, HasAUseForEachFormatAndEachContents) {
  for (const FormatInfo& format : formats()) {
    const auto used = [&](Contents c) { return format.reads.has(c) || format.writes.has(c); };
    const std::vector<Contents> all = all_contents();
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), used)) << format.name;
  }
  for (const Contents contents : all_contents()) {
    EXPECT_FALSE(io::extensions_of(format_table(), contents, Direction::writing).empty())
        << name_of(contents);
  }
}

TEST(FormatTable, HasOneTakerOfTextForEachContents) {
  for (const Contents contents : all_contents()) {
    const auto takers = std::count_if(
        format_table().begin(), format_table().end(),
        [&](const Format* format) { return format->takes_text && io::reads(*format, contents); });
    EXPECT_LE(takers, 1) << name_of(contents);
  }
}

// Each format's own bytes of each contents, by both encodings.
void for_each_output(const std::function<void(const Format&, Contents, const std::string&)>& test) {
  const LineSet lines{{{Point3{0, 0, 0}, Point3{1, 0.1, 2}}}, {{"kind", {7}}}};
  for (const Format* format : format_table()) {
    for (const Encoding encoding : {Encoding::binary, Encoding::ascii, Encoding::compressed}) {
      const WriteOptions options{encoding, std::string(format->name)};
      const auto check = [&](Contents contents, const Result<Formatted>& made) {
        ASSERT_TRUE(made.ok()) << format->name << to_string(made.error());
        // What cannot be read back may have rounded the numbers.
        EXPECT_TRUE(made->warnings.empty() || !io::reads(*format, contents)) << format->name;
        test(*format, contents, made->bytes);
      };
      if (format->write_stack != nullptr) {
        check(Contents::stack, format_stack(two_triangles(), options));
      }
      // One of several files is read in a test of its own.
      if (format->write_model != nullptr && format->companions.front().write == nullptr) {
        check(Contents::model, format_model(test::hard_model(), options));
      }
      if (format->write_surface != nullptr) {
        check(Contents::surface, format_surface(one_tet(), options));
      }
      if (format->write_points != nullptr) {
        check(Contents::points, format_points(hard_points(), options));
      }
      if (format->write_lines != nullptr) {
        io::StringSink sink;
        ASSERT_TRUE(format->write_lines(sink, lines, {{}, options}).ok());
        test(*format, Contents::lines, sink.take());
      }
    }
  }
}

TEST(FormatTable, RecognisesWhatEachFormatWrites) {
  std::size_t recognised = 0;
  for_each_output([&](const Format& format, Contents contents, const std::string& bytes) {
    if (format.recognise == nullptr) return;
    ++recognised;
    for (const Format* other : format_table()) {
      if (other->recognise == nullptr) continue;
      EXPECT_EQ(other->recognise(bytes), other == &format)
          << format.name << ' ' << name_of(contents) << " by " << other->name;
      EXPECT_FALSE(other->recognise("")) << other->name;
      EXPECT_FALSE(other->recognise("some words\n")) << other->name;
    }
  });
  EXPECT_GE(recognised, 14U);
}

// Points, tets and components are the same, and so is what else the format holds.
void expect_same_solid(Model read, const Model& expected) {
  for_each_field([&](const auto& field) {
    auto& values = read.*field.values;
    if (values.empty() && field.name != "component") values = expected.*field.values;
  });
  for_each_table([&](const auto& table) {
    if ((read.*table.rows).empty()) read.*table.rows = expected.*table.rows;
  });
  // Formats without any for what has no name have one all the same.
  for (const ComponentId c : read.component_names.ids()) {
    EXPECT_EQ(read.component_names[c], component_name(expected, c));
  }
  read.component_names = expected.component_names;
  test::expect_same(read, expected);
}

TEST(FormatTable, ReadsBackWhatEachFormatWrites) {
  std::size_t read_back = 0;
  for_each_output([&](const Format& format, Contents contents, const std::string& bytes) {
    if (!io::reads(format, contents)) return;
    ++read_back;
    // Recognised under any name; where nothing in the bytes tells, the extension does.
    const std::string name =
        "a" + (format.recognise != nullptr ? std::string() : std::string(format.extensions[0]));
    if (contents == Contents::stack) {
      const auto read = parse_stack(bytes, name);
      ASSERT_TRUE(read.ok()) << to_string(read.error());
      const SectionStack expected = two_triangles();
      ASSERT_EQ(read->stack.sections.size(), expected.sections.size());
      for (SectionId s(0); s < expected.sections.end_id(); s = SectionId(s.index() + 1)) {
        EXPECT_EQ(read->stack.sections[s].z, expected.sections[s].z);
        EXPECT_EQ(read->stack.sections[s].contours[ContourId(0)].vertices,
                  expected.sections[s].contours[ContourId(0)].vertices);
      }
    } else if (contents == Contents::model) {
      const auto read = parse_model(bytes, name);
      ASSERT_TRUE(read.ok()) << to_string(read.error());
      expect_same_solid(read->model, test::hard_model());
    } else if (contents == Contents::points) {
      const auto read = parse_points(bytes, name);
      ASSERT_TRUE(read.ok()) << to_string(read.error());
      const std::vector<Point3> expected = hard_points();
      ASSERT_EQ(read->points.size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_TRUE(test::same_bits(read->points[i], expected[i])) << format.name << i;
      }
    } else if (contents == Contents::surface) {
      const auto read = parse_triangles(bytes, name);
      ASSERT_TRUE(read.ok()) << to_string(read.error());
      const io::SurfaceMesh expected = io::surface_mesh(one_tet());
      ASSERT_EQ(read->mesh.triangles.size(), expected.triangles.size());
      for (std::size_t i = 0; i < expected.triangles.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_EQ(read->mesh.points[read->mesh.triangles[i][k]],
                    expected.points[expected.triangles[i][k]])
              << format.name << i << k;
        }
      }
    } else {
      ADD_FAILURE() << "no way to read back " << name_of(contents);
    }
  });
  EXPECT_GE(read_back, 8U);
}

// A format of nowhere: a stack in one byte.
bool is_dot(std::string_view bytes) { return bytes.substr(0, 1) == "."; }
Result<io::StackOfFile> read_dot(const io::Source& source, const ReadOptions& /*options*/) {
  ReadStack read;
  for (std::size_t i = 0; i < source.bytes.size(); ++i) {
    read.stack.sections.push_back({static_cast<double>(i), {}});
  }
  return io::StackOfFile{std::move(read), {}};
}
io::Written write_dots(io::Sink& sink, const SectionStack& stack, const io::Target& /*target*/) {
  sink.append(std::string(stack.sections.size(), '.'));
  return std::vector<Warning>();
}
constexpr Format kDots{.name = "dots",
                       .summary = "sections of nothing",
                       .extensions = {".dots", ".dots.cnt"},
                       .recognise = is_dot,
                       .read_stack = read_dot,
                       .write_stack = write_dots};

std::vector<const Format*> table_with_dots() {
  std::vector<const Format*> table(format_table().begin(), format_table().end());
  table.push_back(&kDots);
  return table;
}

std::string_view reader_of(std::string_view bytes, const std::string& name,
                           const std::string& named = {}) {
  const auto chosen =
      io::choose_reader(table_with_dots(), Contents::stack, {bytes, name, {}}, named);
  return chosen ? (*chosen)->name : "refused";
}

TEST(ChooseReader, GoesByContentsThenExtensionThenText) {
  EXPECT_EQ(reader_of("..", "a"), "dots");
  EXPECT_EQ(reader_of("..", "a.cnt"), "dots");
  EXPECT_EQ(reader_of("S 0", "a.dots"), "cnt");
  EXPECT_EQ(reader_of("\xEF\xBB\xBF # comment\n s\n2", "a.dots"), "cnt");
  EXPECT_EQ(reader_of("words", "a.DOTS"), "dots");
  EXPECT_EQ(reader_of("words", "a.dots.cnt"), "dots");
  EXPECT_EQ(reader_of("words", ".dots"), "cnt");
  EXPECT_EQ(reader_of("words", "a.wild"), "cnt");
  EXPECT_EQ(reader_of("", "a"), "cnt");
  EXPECT_EQ(reader_of("..", "a.dots", "cnt"), "cnt");
}

TEST(ChooseReader, RefusesWithTheListOfWhatCanBeRead) {
  const auto table = table_with_dots();
  const std::string binary("\1\0\2", 3);
  const auto unknown = io::choose_reader(table, Contents::stack, {binary, "a.wild", {}}, {});
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(unknown.error().where.file, "a.wild");
  for (const char* part :
       {"a stack is read as", "cnt (.cnt, NUAGES contours)", "dots (.dots, .dots.cnt, sections"}) {
    EXPECT_NE(unknown.error().message.find(part), std::string::npos) << unknown.error().message;
  }
  EXPECT_EQ(reader_of(binary, "a.cnt"), "cnt");

  const std::string grid = *format_vtu(one_tet());
  const auto other = io::choose_reader(table, Contents::stack, {grid, "a.vtu", {}}, {});
  ASSERT_FALSE(other.ok());
  EXPECT_NE(other.error().message.find("format vtu"), std::string::npos) << other.error().message;
  EXPECT_EQ(reader_of(grid, "a.cnt"), "cnt");

  for (const char* name : {"cnd", "vtu"}) {
    const auto named = io::choose_reader(table, Contents::stack, {"S 0", "a", {}}, name);
    ASSERT_FALSE(named.ok());
    EXPECT_EQ(named.error().code, ErrorCode::usage);
    EXPECT_NE(named.error().message.find(" or dots, not as"), std::string::npos);
  }
}

TEST(ChooseWriter, GoesByTheLongestExtension) {
  const auto table = table_with_dots();
  const auto writer = [&](const std::string& path, const std::string& named = {}) {
    const auto chosen = io::choose_writer(table, Contents::stack, path, named);
    return chosen ? (*chosen)->name : "refused";
  };
  EXPECT_EQ(writer("a.cnt"), "cnt");
  EXPECT_EQ(writer("a.dots.CNT"), "dots");
  EXPECT_EQ(writer("a.vtu"), "refused");
  EXPECT_EQ(writer("a.vtu", "dots"), "dots");
  const auto refused = io::choose_writer(table, Contents::stack, "a.vtu", {});
  EXPECT_EQ(refused.error().code, ErrorCode::usage);
  const std::string& message = refused.error().message;
  EXPECT_EQ(message.find("a stack is written as "), 0U) << message;
  EXPECT_TRUE(message.ends_with(", .dots or .dots.cnt, not as '.vtu'")) << message;
}

TEST(Formatting, MakesTheBytesThatAreWritten) {
  TempFolder folder;
  const Model model = one_tet();
  for (const char* name : {"obj", "ply", "vtp", "stl"}) {
    for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
      const std::string path = folder.file(std::string("a.") + name);
      ASSERT_TRUE(write_surface(path, model, encoding).ok());
      EXPECT_EQ(format_surface(model, {encoding, name})->bytes, test::get(path)) << name;
    }
  }
  const std::string path = folder.file("any name");
  ASSERT_TRUE(write_vtu(path, test::hard_model()).ok());
  EXPECT_EQ(*format_vtu(test::hard_model()), test::get(path));
  ASSERT_TRUE(write_model(folder.file("a.vtu"), test::hard_model()).ok());
  EXPECT_EQ(test::get(folder.file("a.vtu")), test::get(path));
  ASSERT_TRUE(write_vtu(path, model.points.raw(), model.tets.raw()).ok());
  EXPECT_EQ(*format_vtu(model.points.raw(), model.tets.raw()), test::get(path));
  EXPECT_EQ(*format_vtu(model), test::get(path));
  ASSERT_TRUE(write_cnt(path, two_triangles()).ok());
  EXPECT_EQ(*format_cnt(two_triangles()), test::get(path));
  const LineSet lines{{{Point3{0, 0, 0}, Point3{1, 0.1, 2}}}, {{"kind", {7}}}};
  ASSERT_TRUE(write_lines(path, lines).ok());
  EXPECT_EQ(*format_lines(lines), test::get(path));
  for (const char* name : {"a.xyz", "a.txt", "a.bin"}) {
    ASSERT_TRUE(write_points(folder.file(name), hard_points()).ok());
    const char* const format = std::string(name) == "a.bin" ? "bin" : "xyz";
    EXPECT_EQ(format_points(hard_points(), {.format = format})->bytes,
              test::get(folder.file(name)));
  }
}

TEST(Formatting, OfLabelsReadsBack) {
  TempFolder folder;
  const Labels labels{
      {{SectionId(0), ContourId(1), 7}, {SectionId(4294967294U), ContourId(0), 4294967294U}},
      {{SlabId(3), ContourId(5), ContourId(7), true},
       {SlabId(4294967294U), ContourId(0), ContourId(1), false}}};
  const auto bytes = format_labels(labels);
  ASSERT_TRUE(bytes.ok());
  EXPECT_EQ(*bytes, "0 1 7\n4294967294 0 4294967294\njoin 3 5 7\npart 4294967294 0 1\n");
  ASSERT_TRUE(write_labels(folder.file("l"), labels).ok());
  EXPECT_EQ(test::get(folder.file("l")), *bytes);
  const auto read = read_labels(folder.file("l"));
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read->labels.size(), labels.labels.size());
  for (std::size_t i = 0; i < labels.labels.size(); ++i) {
    EXPECT_EQ(read->labels[i].section, labels.labels[i].section);
    EXPECT_EQ(read->labels[i].contour, labels.labels[i].contour);
    EXPECT_EQ(read->labels[i].label, labels.labels[i].label);
  }
  ASSERT_EQ(read->decisions.size(), labels.decisions.size());
  for (std::size_t i = 0; i < labels.decisions.size(); ++i) {
    EXPECT_EQ(read->decisions[i].slab, labels.decisions[i].slab);
    EXPECT_EQ(read->decisions[i].lower, labels.decisions[i].lower);
    EXPECT_EQ(read->decisions[i].upper, labels.decisions[i].upper);
    EXPECT_EQ(read->decisions[i].join, labels.decisions[i].join);
  }
}

TEST(Formatting, NeedsAFormatAndAGoodModel) {
  for (const auto& refused :
       {format_stack({}, {}), format_model({}, {}), format_surface({}, {.format = "vtu"}),
        format_points({}, {.format = "obj"})}) {
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::usage) << refused.error().message;
  }
  Model bad = one_tet();
  bad.tets[TetId(0)][0] = VertexId(9);
  for (const char* name : {"obj", "ply", "vtp", "stl"}) {
    EXPECT_EQ(format_surface(bad, {.format = name}).error().code, ErrorCode::invalid_input);
  }
  EXPECT_EQ(format_vtu(bad).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(format_vtu(bad.points.raw(), bad.tets.raw()).error().code, ErrorCode::invalid_input);
  const auto encoding = static_cast<Encoding>(9);
  EXPECT_EQ(format_vtu(one_tet(), encoding).error().code, ErrorCode::usage);
}

TEST(Formatting, TellsOfFloat32WithTheBytes) {
  Model model = one_tet();
  model.points[VertexId(0)] = {1 + 0x1p-40, 0, 0};
  model.points[VertexId(1)] = {1, 0, 0};
  const auto made = format_surface(model, {.format = "stl"});
  ASSERT_TRUE(made.ok());
  EXPECT_FALSE(made->warnings.empty());
  EXPECT_EQ(made->bytes.size(), 84U + 50U * 4);
}

TEST(WrongTarget, IsNotOpenedBeforeTheModelIsChecked) {
  Model bad = one_tet();
  bad.tets[TetId(0)][0] = VertexId(9);
  const auto refused = write_model("/no/such/folder/a.vtu", bad);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(refused.error().where.file, "/no/such/folder/a.vtu");
  EXPECT_EQ(write_model("/no/such/folder/a.vtu", one_tet()).error().code, ErrorCode::io);
}

}  // namespace
}  // namespace tetloft
