// Plans, pieces and indices: of any bytes an error that names the file. Records have checksums, so
// that bytes changed at random are never looked at; most inputs therefore say how the contents of
// honest records are changed, and these get checksums anew. A solid made of a plan whose contents
// were accepted keeps guarantees 1 to 3.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/io.hpp>
#include <tetloft/pieces.hpp>

#include "core/record.hpp"
#include "fuzz/plans_of_pieces.hpp"
#include "fuzz/target.hpp"
#include "io/vtu_piece.hpp"
#include "model/digest.hpp"
#include "pieces/archive.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/piece_set.hpp"
#include "pieces/plan_file.hpp"
#include "property/same_model.hpp"

namespace tetloft::fuzz {
namespace {

namespace pieces = internal::pieces;
namespace io = internal::io;

struct World {
  test::TempFolder folder;
  std::vector<PlannedCase> cases = written_cases(folder);
};

World& world() {
  static World made;
  return made;
}

// Changes a text: a byte, a word, or what stands there.
void change(std::string& text, Bytes& bytes) {
  const std::size_t kind = bytes.below(8);
  const std::size_t at = bytes.byte() + 256 * std::size_t{bytes.byte()};
  const auto place = [&](std::size_t width) {
    return text.size() < width ? std::string::npos : at % (text.size() - width + 1);
  };
  const auto put = [&](auto value) {
    const std::size_t to = place(sizeof value);
    if (to == std::string::npos) return;
    std::string word;
    internal::append_little(word, value);
    text.replace(to, word.size(), word);
  };
  switch (kind) {
    case 0: put(bytes.byte()); break;
    case 1: put(bytes.any_double()); break;
    case 2: put(static_cast<double>(bytes.byte()) / 8 - 4); break;
    case 3: put(std::uint32_t{bytes.byte()}); break;
    case 4: put(std::uint64_t{bytes.byte()}); break;
    case 5: text.insert(place(0), bytes.below(32), static_cast<char>(bytes.byte())); break;
    case 6:
      if (!text.empty()) text.erase(place(1), bytes.below(64));
      break;
    default: {  // what stands elsewhere, too
      const std::size_t width = 1 + bytes.below(40);
      const std::size_t from = place(width);
      const std::size_t to = bytes.byte() + 256 * std::size_t{bytes.byte()};
      if (from == std::string::npos) break;
      const std::string part = text.substr(from, width);
      text.replace(to % (text.size() - width + 1), width, part);
    }
  }
}

// Of a record, before and behind its contents: core/record.hpp.
constexpr std::size_t kHeader = 24;
constexpr std::size_t kChecksum = 8;

// A record with other contents, and the checksum of these.
std::string with_contents(std::string_view record, std::string_view contents) {
  internal::RecordWriter out(
      {record.substr(8, 4), internal::load_little<std::uint32_t>(record.data() + 12), {}});
  for (const char c : contents) out.put(static_cast<std::uint8_t>(c));
  return out.take();
}

void change_record(std::string& record, Bytes& bytes) {
  std::string contents = record.substr(kHeader, record.size() - kHeader - kChecksum);
  change(contents, bytes);
  record = with_contents(record, contents);
}

std::string changed_plan(const PlannedCase& of, Bytes& bytes) {
  const auto archive = pieces::ArchiveReader::open(of.plan);
  require(archive.ok(), "a plan that was written is refused");
  std::vector<std::string> records;
  for (std::size_t k = 0; k < archive->size(); ++k) records.push_back(*archive->record(k));
  for (std::size_t changes = 0; changes < 6 && !bytes.empty(); ++changes) {
    const std::size_t which = bytes.byte();
    std::string& record = records[which % records.size()];
    if (which < 240) {
      change_record(record, bytes);
    } else if (which < 248) {
      record = records[bytes.below(records.size())];
    } else if (records.size() > 1) {
      records.erase(records.begin() + static_cast<std::ptrdiff_t>(which % records.size()));
    }
  }
  io::StringSink sink;
  pieces::ArchiveWriter out(sink);
  for (const std::string& record : records) out.append(record);
  out.finish();
  return sink.take();
}

// An error of the library that says where: files, sections or slabs.
template <class T>
bool placed(const Result<T>& result) {
  if (result) return true;
  require_clean(result.error());
  require(!to_string(result.error().where).empty(),
          "an error without a place: " + to_string(result.error()));
  return false;
}

void check_solid(const std::string& piece, const pieces::PlanFile& plan) {
  const auto model = read_vtu(piece);
  require(model.ok(), "a piece that was written is refused");
  const auto stack = plan.stack();
  require(stack.ok(), "a plan that was built is refused");
  CheckOptions options;
  options.execution.threads = 1;
  // Labels may be of contours that there are no more: what belongs together is not asked here.
  options.correspondence.voids.rule = VoidRule::free;
  const auto report = check(*model, *stack, options);
  if (!report) {
    require_clean(report.error());
    return;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const GuaranteeVerdict& verdict = report->guarantees[k];
    require(verdict.pass,
            "guarantee " + std::to_string(verdict.number) + ": " +
                (verdict.failures.empty() ? verdict.not_asked : verdict.failures.front().what));
  }
}

PieceOptions quietly() {
  PieceOptions options;
  options.execution.threads = 1;
  return options;
}

void check_plan_file(std::string_view bytes) {
  const test::TempFolder& folder = world().folder;
  const std::string path = folder.file("plan");
  write_bytes(path, bytes);
  const auto part = pieces::part_of(path);
  require(part.ok(), "a file is not looked at");
  const auto read = read_plan(path);
  const auto checked = check_plan(path);
  if (!fine(read)) {
    require(!checked.ok(), "a plan that cannot be read is found to be right");
    return;
  }
  require(*part == pieces::Part::plan, "a plan is not known as one");
  const bool right = fine(checked);
  const std::size_t slabs = read->sections - 1;
  if (slabs > 8) return;
  const std::string piece = folder.file("made.vtu");
  const auto whole = write_piece(piece, path, 0, slabs, quietly());
  if (placed(whole)) {
    require(right, "a plan that is not right is built");
    require(whole->summary.open.empty(), "a whole stack is left open");
    const auto plan = pieces::PlanFile::open(path);
    require(plan.ok(), "a plan that was built is refused");
    check_solid(piece, *plan);
  }
  for (std::size_t slab = 0; slab < slabs; ++slab) {
    const auto one = write_piece(piece, path, slab, slab + 1, quietly());
    if (!placed(one)) continue;
    const auto made = check_piece(piece);
    require(made.ok(),
            "a piece that was made is refused: " + (made ? "" : to_string(made.error())));
  }
}

// The case whose pieces these are, of which an index may name others than those of `of`.
const PlannedCase& case_of(const std::vector<std::string>& files, const PlannedCase& of) {
  const auto read = pieces::read_pieces(files);
  require(read.ok(), "pieces that were joined are refused");
  const std::vector<PlannedCase>& all = world().cases;
  const auto found = std::find_if(all.begin(), all.end(), [&](const PlannedCase& one) {
    return one.identity == read->front().record.plan;
  });
  return found == all.end() ? of : *found;
}

void check_joined(const Model& joined, const PlannedCase& of) {
  if (of.any_open) return;
  Model expected = of.model;
  expected.component_count = joined.component_count;  // what a record says of the whole
  require(testing::same_bits(joined, expected), "pieces become another solid");
}

// All that takes pieces. `honest`: none of their solids was changed.
void check_pieces(const std::vector<std::string>& files, const PlannedCase& of, bool honest) {
  JoinOptions joining;
  joining.execution.threads = 1;
  joining.plan = of.plan;
  const auto joined = join_pieces(files, joining);
  const test::TempFolder& folder = world().folder;
  const auto written = write_joined(folder.file("joined.vtu"), files, joining);
  const auto listed = write_index(folder.file("listed.pvtu"), files, joining);
  if (!joined) {
    require_clean(joined.error());
    require(!written.ok() && !listed.ok(), "pieces that do not fit are joined in a stream");
    return;
  }
  if (honest) check_joined(joined->model, case_of(files, of));
  const auto text = format_vtu(joined->model);
  if (!text) {
    require_clean(text.error());
    return;
  }
  require(written.ok(), "pieces that fit are not joined in a stream");
  require(test::get(folder.file("joined.vtu")) == *text, "a stream joins to other bytes");
}

void check_piece_file(const std::string& path, const PlannedCase& of, std::size_t which,
                      bool honest) {
  const auto read = read_piece(path);
  const auto checked = check_piece(path);
  if (!fine(read)) require(!checked.ok(), "a piece that cannot be read is found to be right");
  fine(checked);
  std::vector<std::string> files = of.pieces;
  files[which] = path;
  check_pieces(files, of, honest);
}

// The record of a piece is another one.
void change_piece_record(const PlannedCase& of, std::size_t which, Bytes& bytes) {
  const auto record = io::piece_bytes(test::get(of.pieces[which]), "piece");
  const auto model = read_vtu(of.pieces[which]);
  require(record.ok() && model.ok(), "a piece that was written is refused");
  std::string changed = record->bytes;
  for (std::size_t changes = 0; changes < 4 && !bytes.empty(); ++changes) {
    change_record(changed, bytes);
  }
  const std::string path = world().folder.file("piece.vtu");
  auto staged = io::stage_piece(path, *model, changed, Encoding::binary);
  require(staged.ok() && io::commit_all(staged->files).ok(), "a piece is not written");
  check_piece_file(path, of, which, true);
}

// The solid of a piece is another one, which its record speaks of.
void change_piece_solid(const PlannedCase& of, std::size_t which, Bytes& bytes) {
  std::string text = test::get(of.pieces[which]);
  auto whole = pieces::read_whole_piece(of.pieces[which]);
  require(whole.ok(), "a piece that was written is refused");
  for (std::size_t changes = 0; changes < 4 && !bytes.empty(); ++changes) change(text, bytes);
  auto model = parse_vtu(text, "piece.vtu");
  if (!fine(model)) return;
  model->component_count = whole->record.components;
  whole->model = std::move(*model);
  const std::string path = world().folder.file("piece.vtu");
  auto staged = pieces::stage_whole_piece(path, *whole, Encoding::binary, nullptr);
  if (!staged) {
    require_clean(staged.error());
    return;
  }
  require(io::commit_all(staged->files).ok(), "a piece is not written");
  check_piece_file(path, of, which, false);
}

void check_index(std::string_view bytes, const PlannedCase& of) {
  const std::string path = world().folder.file("index.pvtu");
  write_bytes(path, bytes);
  check_pieces({path}, of, true);
}

// An honest file, changed byte by byte.
std::string damaged(const std::string& path, Bytes& bytes) {
  std::string text = test::get(path);
  for (std::size_t changes = 0; changes < 4 && !bytes.empty(); ++changes) change(text, bytes);
  return text;
}

std::string index_of(const PlannedCase& of) {
  const std::string path = world().folder.file("honest.pvtu");
  JoinOptions joining;
  joining.execution.threads = 1;
  joining.plan = of.plan;
  require(write_index(path, of.pieces, joining).ok(), "pieces of a case are not listed");
  return path;
}

}  // namespace
}  // namespace tetloft::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft::fuzz;
  Bytes bytes(data, size);
  const std::size_t mode = bytes.below(12);
  const PlannedCase& of = world().cases[bytes.below(world().cases.size())];
  const std::size_t which = bytes.below(of.pieces.size());
  const std::string_view rest =
      text_of(data, size).substr(std::min<std::size_t>(size, 3));  // behind these three
  const std::string piece = world().folder.file("piece.vtu");
  std::filesystem::remove(piece);  // of an input before, which an index might name
  switch (mode) {
    case 0: check_plan_file(rest); break;
    case 1:
      write_bytes(piece, rest);
      check_piece_file(piece, of, which, true);
      break;
    case 2: check_index(rest, of); break;
    case 3: check_plan_file(damaged(of.plan, bytes)); break;
    case 4:
      write_bytes(piece, damaged(of.pieces[which], bytes));
      check_piece_file(piece, of, which, true);
      break;
    case 5: check_index(damaged(index_of(of), bytes), of); break;
    case 6: change_piece_record(of, which, bytes); break;
    case 7: change_piece_solid(of, which, bytes); break;
    default: check_plan_file(changed_plan(of, bytes));
  }
  return 0;
}
