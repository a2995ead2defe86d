// Memory that ends in readers and writers: no file stays behind, and an old one stays as it was.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "robustness/inputs.hpp"
#include "robustness/sweep.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::test {
namespace {

const std::string kOld = "what was there before";

// Of a writer of `name`: run over an old file, which is replaced as a whole or not at all.
void sweep_writer(const std::string& what, const std::string& name,
                  const std::function<Ended(const std::string& path)>& write) {
  const TempFolder folder;
  const std::string path = folder.file(name);
  ASSERT_EQ(write(path), Ended()) << what;
  const std::string complete = get(path);
  put(path, kOld);
  sweep(
      what, [&] { return write(path); },
      [&] {
        const std::string now = get(path);
        const bool alone = folder.names() == std::vector<std::string>{name};
        put(path, kOld);
        return alone && (now == kOld || now == complete);
      },
      8);
}

TEST(MemoryEnds, WhileWriting) {
  const SectionStack stack = case_stack("fork");
  const Model model = model_of(stack);
  sweep_writer("write_cnt", "a.cnt",
               [&](const std::string& path) { return ended(write_cnt(path, stack)); });
  sweep_writer("write_file", "a.txt",
               [&](const std::string& path) { return ended(write_file(path, "text")); });
  for (const char* extension : {"obj", "ply", "vtp", "stl"}) {
    sweep_writer(std::string("write_surface, .") + extension, std::string("a.") + extension,
                 [&](const std::string& path) { return ended(write_surface(path, model)); });
  }
  for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
    const std::string how = encoding == Encoding::binary ? ", binary" : ", ascii";
    sweep_writer("write_vtu" + how, "a.vtu",
                 [&](const std::string& path) { return ended(write_vtu(path, model, encoding)); });
    sweep_writer("write_vtu, mesh" + how, "a.vtu", [&](const std::string& path) {
      return ended(write_vtu(path, model.points.raw(), model.tets.raw(), encoding));
    });
    LineSet lines;
    lines.lines.push_back({Point3{0, 0, 0}, Point3{1, 1, 1}});
    lines.data.push_back({"numbers", {7}});
    sweep_writer("write_lines" + how, "a.vtp", [&](const std::string& path) {
      return ended(write_lines(path, lines, encoding));
    });
  }
}

TEST(MemoryEnds, WhileReading) {
  const TempFolder folder;
  const std::string stack = case_path("ring");
  sweep("read_cnt", [&] { return ended(read_cnt(stack)); });
  const std::string text = get(stack);
  const std::string name = "a name too long to be kept within a string";
  sweep("parse_cnt", [&] { return ended(parse_cnt(text, name)); });
  const std::string open = text + "{";
  sweep("parse_cnt, refused", [&] { return ended(parse_cnt(open, name)); });
  const std::string labels = folder.file("a.labels");
  put(labels, "0 0 1 # first\n1 0 1\njoin 0 0 1\npart 0 0 2\n1 1 2\n");
  sweep("read_labels", [&] { return ended(read_labels(labels)); });
  const std::string points = folder.file("a.txt");
  put(points, "0 0 0\n1 0 0 # second\n1 1 1e3\n");
  sweep("read_points", [&] { return ended(read_points(points)); });
  sweep("parse_points, refused", [&] { return ended(parse_points("1 2", name)); });
  const std::string none = folder.file("none.vtu");
  sweep("read_vtu, no file", [&] { return ended(read_vtu(none)); });
  const Model model = model_of(case_stack("fork"));
  for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
    const std::string path = folder.file("a.vtu");
    ASSERT_TRUE(write_vtu(path, model, encoding));
    const std::string how = encoding == Encoding::binary ? "binary" : "ascii";
    sweep("read_vtu, " + how, [&] { return ended(read_vtu(path)); });
    const std::string bytes = get(path);
    const std::string half = bytes.substr(0, bytes.size() / 2);
    sweep("parse_vtu, cut off, " + how, [&] { return ended(parse_vtu(half, name)); });
  }
}

TEST(MemoryEnds, WhileFormatting) {
  const SectionStack stack = case_stack("fork");
  const Model model = model_of(stack);
  sweep("format_cnt", [&] { return ended(format_cnt(stack)); });
  sweep("format_vtu", [&] { return ended(format_vtu(model)); });
  sweep("format_vtu, mesh",
        [&] { return ended(format_vtu(model.points.raw(), model.tets.raw())); });
  for (const char* name : {"obj", "ply", "vtp", "stl"}) {
    sweep(name, [&] { return ended(format_surface(model, {.format = name})); });
  }
  sweep("format_points",
        [&] { return ended(format_points(model.points.raw(), {.format = "xyz"})); });
  const WriteOptions unknown{.format = "a format that there is not"};
  sweep("format_points, refused",
        [&] { return ended(format_points(model.points.raw(), unknown)); });
  sweep("parse_stack, refused",
        [&] { return ended(parse_stack(std::string_view("\0", 1), "a name", {})); });
}

TEST(MemoryEnds, InTextsOfErrors) {
  Error error{ErrorCode::invalid_input, "a message that is longer than any string holds", {}};
  error.where.file = "a file name that is longer than any string holds in place";
  error.where.vertex = 7;
  error.where.point = Point3{0.1, 0.2, 0.3};
  sweep("to_string", [&] { return ended_throwing([&] { static_cast<void>(to_string(error)); }); });
}

}  // namespace
}  // namespace tetloft::test
