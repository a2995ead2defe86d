// tetloft join --index, and info of plans and pieces.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/pieces_fixture.hpp"

namespace tetloft {
namespace {

using namespace test;

class PieceIndex : public PiecesCommand {
 protected:
  // The files that an index lists, as it calls them.
  static Words sources_of(const std::string& index) {
    Words sources;
    const std::string mark = "<Piece Source=\"";
    const std::string text = get(index);
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
      const std::size_t from = at + mark.size();
      sources.push_back(text.substr(from, text.find('"', from) - from));
    }
    return sources;
  }

  std::string index_ = folder_.file("solid.pvtu");
};

class OpenPieceIndex : public OpenSlabs {
 protected:
  std::string index_ = folder_.file("solid.pvtu");
};

TEST_F(PieceIndex, ListsThePiecesFromBelow) {
  make_plan(data("torus.cnt"));
  const Words pieces = make_pieces({0, 7, 12, 19});
  const JsonValue made = run_json(with({"join", "--index", "-o", index_}, pieces));
  EXPECT_EQ(made.at("pieces").number, 3);
  EXPECT_EQ(made.at("settled").number, 0);
  EXPECT_EQ(made.at("components").number, 1);
  ASSERT_EQ(made.at("written").array.size(), 1U);
  EXPECT_EQ(made.at("written").array[0].string, index_);
  EXPECT_EQ(made.at("listed").array[2].string, piece(2));
  EXPECT_EQ(sources_of(index_), (Words{"piece0.vtu", "piece1.vtu", "piece2.vtu"}));
  const std::string joined = folder_.file("joined.vtu");
  EXPECT_EQ(made.at("tets").number,
            run_json(with({"join", "-o", joined}, pieces)).at("tets").number);
  const std::string told = run(with({"join", "--index", "-o", index_}, pieces)).out;
  EXPECT_NE(told.find("3 pieces: "), std::string::npos) << told;
}

TEST_F(PieceIndex, CallsThePiecesFromItsFolder) {
  make_plan(data("torus.cnt"));
  const Words pieces = make_pieces({0, 7, 19});
  std::filesystem::create_directory(folder_.file("out"));
  const std::string odd = folder_.file("a & \"b\".vtu");
  std::filesystem::rename(piece(1), odd);
  const std::string index = folder_.file("out/solid.pvtu");
  ASSERT_EQ(run({"join", "--index", "-o", index, piece(0), odd}).code, 0);
  const Words sources = sources_of(index);
  ASSERT_EQ(sources.size(), 2U);
  EXPECT_EQ(sources[0], "../piece0.vtu");
  EXPECT_EQ(sources[1], "../a &amp; &quot;b&quot;.vtu");
}

TEST_F(PieceIndex, FindsPiecesWhateverTheyAreCalled) {
  make_plan(data("torus.cnt"));
  const Words pieces = make_pieces({0, 7, 19});
  const std::string odd = folder_.file("a\n\t\r & <'b'>.vtu");
  std::filesystem::rename(piece(1), odd);
  ASSERT_EQ(run({"join", "--index", "-o", index_, piece(0), odd}).code, 0);
  ASSERT_EQ(run({"join", "-o", folder_.file("listed.vtu"), index_}).code, 0);
  ASSERT_EQ(run({"join", "-o", folder_.file("named.vtu"), piece(0), odd}).code, 0);
  EXPECT_TRUE(get(folder_.file("listed.vtu")) == get(folder_.file("named.vtu")));
}

// The pieces of an index are pieces like others: joined they are the single run's solid.
TEST_F(OpenPieceIndex, WritesAnewWhatWasLeftOpen) {
  const std::string whole = folder_.file("whole.vtu");
  ASSERT_EQ(run(with({"reconstruct", stack_, "-o", whole}, options_)).code, 0);
  for (const Cuts& cuts : {Cuts{0, 2, 7, 9}, Cuts{0, 4, 9}, Cuts{0, 2, 4, 5, 7, 9},
                           Cuts{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}) {
    const Words pieces = make_pieces(cuts);
    std::vector<std::string> bytes;
    for (const std::string& path : pieces) bytes.push_back(get(path));
    const JsonValue made =
        run_json(with({"join", "--index", "-o", index_, "--plan", plan_}, pieces));
    const bool open = cuts.size() != 4;
    EXPECT_EQ(made.at("settled").number, open ? 3 : 0);
    EXPECT_EQ(made.at("written").array.size() > 1, open);
    for (std::size_t k = 0; k < pieces.size(); ++k) EXPECT_EQ(get(pieces[k]), bytes[k]);
    Words listed;
    for (const JsonValue& path : made.at("listed").array) listed.push_back(path.string);
    ASSERT_EQ(listed.size(), pieces.size());
    const std::string joined = folder_.file("joined.vtu");
    ASSERT_EQ(run(with({"join", "-o", joined}, listed)).code, 0);
    EXPECT_TRUE(get(joined) == get(whole));
  }
}

TEST_F(OpenPieceIndex, AppearsWithAllItsPiecesOrNotAtAll) {
  const Words pieces = make_pieces({0, 4, 9});
  const std::string beside = folder_.file("solid_0.vtu");
  expect_failure(with({"join", "--index", "-o", index_}, pieces), 2, "usage", "--plan",
                 {index_, beside});
  // A piece cannot appear.
  std::filesystem::create_directory(folder_.file("solid_1.vtu"));
  expect_failure(with({"join", "--index", "-o", index_, "--plan", plan_}, pieces), 4, "io",
                 "solid_1.vtu", {index_, beside});
  std::filesystem::remove(folder_.file("solid_1.vtu"));
  // It would overwrite what was given.
  const std::string index = folder_.file("piece.pvtu");
  std::filesystem::rename(piece(0), folder_.file("piece_0.vtu"));
  const std::string before = get(folder_.file("piece_0.vtu"));
  const Words words{"join",  "--index", "-o", index, "--plan", plan_, folder_.file("piece_0.vtu"),
                    piece(1)};
  const Outcome refused = run(words);
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("overwrite"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(index));
  EXPECT_EQ(get(folder_.file("piece_0.vtu")), before);
}

// It stands for its pieces wherever a model is read, and in joining.
TEST_F(PieceIndex, IsReadAsTheSolidOfItsPieces) {
  make_plan(data("torus.cnt"), {"--ends", "half"});
  const Words pieces = make_pieces({0, 7, 19});
  std::filesystem::create_directory(folder_.file("out"));
  const std::string index = folder_.file("out/a & b.pvtu");
  std::filesystem::rename(piece(1), folder_.file("<1>.vtu"));
  ASSERT_EQ(run({"join", "--index", "-o", index, piece(0), folder_.file("<1>.vtu")}).code, 0);
  const std::string whole = folder_.file("whole.vtu"), joined = folder_.file("joined.vtu");
  ASSERT_EQ(run({"reconstruct", stack_, "-o", whole, "--ends", "half"}).code, 0);
  ASSERT_EQ(run({"join", index, "-o", joined}).code, 0);
  EXPECT_TRUE(get(joined) == get(whole));
  ASSERT_EQ(run({"convert", index, "-o", joined}).code, 0);
  EXPECT_TRUE(get(joined) == get(whole));
  EXPECT_EQ(run({"check", index, stack_}).out, run({"check", whole, stack_}).out);
  EXPECT_EQ(run({"check", index, data("bifurcation.cnt")}).code, 1);
  // One of its pieces is not overwritten, and it may be listed anew.
  const std::string before = get(piece(0));
  expect_failure({"join", index, "-o", piece(0), "--quiet"}, 2, "usage", "overwrite");
  EXPECT_EQ(get(piece(0)), before);
  ASSERT_EQ(run({"join", "--index", index, "-o", index_}).code, 0);
  EXPECT_EQ(sources_of(index_), (Words{"piece0.vtu", "&lt;1&gt;.vtu"}));
}

TEST_F(PieceIndex, ThatIsDamagedIsRefused) {
  make_plan(data("torus.cnt"));
  const Words pieces = make_pieces({0, 7, 19});
  ASSERT_EQ(run(with({"join", "--index", "-o", index_}, pieces)).code, 0);
  const std::string whole = get(index_);
  const auto refused = [&](const std::string& text, int code, const std::string& name,
                           const std::string& word) {
    put(index_, text);
    expect_failure({"check", index_, stack_}, code, name, word);
  };
  const auto without = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  refused(whole.substr(0, whole.size() - 11), 3, "invalid_input", "cut off");
  refused(without("Source=", "Sauce="), 3, "invalid_input", "no Source");
  refused(without("    <Piece Source=\"piece1.vtu\"/>\n", ""), 3, "invalid_input", "slabs 7:19");
  refused(without("piece1", "piece7"), 4, "io", "piece7.vtu");
  refused(without("piece1", "piece0"), 3, "invalid_input", "is twice");
  refused(without("</PUnstructuredGrid>", "</Grid>"), 3, "invalid_input", "Grid");
  refused("<VTKFile type=\"PUnstructuredGrid\"></VTKFile>", 3, "invalid_input", "lists no piece");
}

TEST_F(PieceIndex, RefusesWhatMakesNoSense) {
  make_plan(data("torus.cnt"));
  const Words pieces = make_pieces({0, 7, 19});
  expect_failure({"join", "--index", piece(0), piece(1)}, 2, "usage", "OUT.pvtu");
  expect_failure({"join", "--index", piece(0), piece(1), "-o", folder_.file("o.vtu")}, 2, "usage",
                 ".pvtu", {folder_.file("o.vtu")});
  expect_failure(
      {"join", "--index", piece(0), piece(1), "-o", index_, "--surface", folder_.file("o.ply")}, 2,
      "usage", "--surface", {index_, folder_.file("o.ply")});
  expect_failure({"join", "--index", piece(1), "-o", index_}, 3, "invalid_input", "slabs 0:7",
                 {index_});
  std::string bytes = get(piece(0));
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  put(piece(0), bytes);
  expect_failure({"join", "--index", piece(0), piece(1), "-o", index_}, 3, "invalid_input",
                 "piece0.vtu", {index_});
}

TEST_F(PieceIndex, CheckNamesThePieceAtFault) {
  make_plan(data("torus.cnt"));
  const Words pieces = make_pieces({0, 7, 12, 19});
  ASSERT_EQ(run(with({"join", "--index", "-o", index_}, pieces)).code, 0);
  const JsonValue right = run_json({"check", index_, stack_});
  EXPECT_TRUE(right.at("pass").boolean);
  EXPECT_EQ(right.at("components").number, 1);
  // Another stack: all fails, by the numbers of the whole.
  const std::string other = folder_.file("other.cnt");
  const auto read = read_stack(stack_);
  SectionStack stack = read->stack;
  stack.sections[SectionId(9)].contours[ContourId(0)].vertices[0].x *= 1.25;
  ASSERT_TRUE(write_stack(other, stack).ok());
  const Outcome wrong = run({"check", index_, other});
  EXPECT_EQ(wrong.code, 1);
  EXPECT_NE(wrong.out.find("piece1.vtu: section 9"), std::string::npos) << wrong.out;
  stack = read->stack;
  stack.sections[SectionId(12)].contours[ContourId(0)].vertices[0].x *= 1.25;
  ASSERT_TRUE(write_stack(other, stack).ok());
  const Outcome at_seam = run({"check", index_, other});
  EXPECT_EQ(at_seam.code, 1);
  EXPECT_NE(at_seam.out.find("piece1.vtu and piece2.vtu: section 12"), std::string::npos)
      << at_seam.out;
}

TEST_F(PieceIndex, InfoTellsWhatItLists) {
  make_plan(data("torus.cnt"));
  const Words pieces = make_pieces({0, 7, 12, 19});
  const JsonValue made = run_json(with({"join", "--index", "-o", index_}, pieces));
  JsonValue told = run_json({"info", index_});
  EXPECT_EQ(told.at("format").string, "index");
  EXPECT_TRUE(told.at("complete").boolean);
  EXPECT_EQ(told.at("wrong").string, "");
  const std::vector<JsonValue>& listed = told.at("pieces").array;
  ASSERT_EQ(listed.size(), 3U);
  double tets = 0;
  for (const JsonValue& one : listed) tets += one.at("tets").number;
  EXPECT_EQ(tets, made.at("tets").number);
  EXPECT_EQ(listed[1].at("slabs").array[0].number, 7);
  EXPECT_EQ(listed[1].at("slabs").array[1].number, 12);
  EXPECT_EQ(listed[1].at("of").number, 19);
  EXPECT_EQ(listed[1].at("plan").string, run_json({"info", plan_}).at("identity").string);
  EXPECT_EQ(listed[1].at("vertices").number, run_json({"info", piece(1)}).at("vertices").number);
  EXPECT_TRUE(listed[1].at("open").array.empty());
  const std::string text = run({"info", index_}).out;
  EXPECT_NE(text.find("; all are there"), std::string::npos) << text;
  EXPECT_NE(text.find("7:12"), std::string::npos) << text;

  std::filesystem::rename(piece(1), folder_.file("away.vtu"));
  told = run_json({"info", index_});
  EXPECT_FALSE(told.at("complete").boolean);
  EXPECT_NE(told.at("wrong").string.find("piece1.vtu"), std::string::npos);
  EXPECT_EQ(told.at("pieces").array[0].at("wrong").string, "");
  EXPECT_NE(told.at("pieces").array[1].at("wrong").string, "");
  EXPECT_NE(run({"info", index_}).out.find("; not whole: "), std::string::npos);
  std::filesystem::copy_file(piece(0), piece(1));
  told = run_json({"info", index_});
  EXPECT_NE(told.at("wrong").string.find("is twice"), std::string::npos);
}

// What no join closed.
TEST_F(OpenPieceIndex, InfoAndCheckTellOfOpenSlabs) {
  const Words pieces = make_pieces({0, 4, 9});
  ASSERT_EQ(run(with({"join", "--index", "-o", index_, "--plan", plan_}, pieces)).code, 0);
  EXPECT_TRUE(run_json({"info", index_}).at("complete").boolean);
  for (std::size_t k = 0; k < 2; ++k) {
    std::filesystem::copy_file(piece(k), folder_.file("solid_" + std::to_string(k) + ".vtu"),
                               std::filesystem::copy_options::overwrite_existing);
  }
  const JsonValue told = run_json({"info", index_});
  EXPECT_FALSE(told.at("complete").boolean);
  EXPECT_NE(told.at("wrong").string.find("left open"), std::string::npos);
  expect_failure({"check", index_, stack_}, 2, "usage", "left open");
}

TEST_F(PieceIndex, InfoTellsOfPlans) {
  const std::string labels = folder_.file("torus.labels");
  put(labels, "3 0 5\npart 12 0 0\n");
  make_plan(data("torus.cnt"), {"--ends", "half", "--between=2", "--overlap", "0.25", "--no-lone",
                                "--voids", "near=0.75", "--labels", labels});
  const JsonValue told = run_json({"info", plan_});
  EXPECT_EQ(told.at("format").string, "plan");
  EXPECT_EQ(told.at("version").number, 2);
  EXPECT_EQ(told.at("identity").string.size(), 16U);
  EXPECT_EQ(told.at("source").at("name").string, "torus.cnt");
  EXPECT_EQ(told.at("source").at("bytes").number,
            static_cast<double>(std::filesystem::file_size(stack_)));
  EXPECT_EQ(told.at("sections").number, 20);
  EXPECT_EQ(told.at("slabs").number, 19);
  EXPECT_EQ(told.at("contours").number, run_json({"info", stack_}).at("contours").number);
  EXPECT_EQ(told.at("vertices").number, run_json({"info", stack_}).at("vertices").number);
  EXPECT_EQ(told.at("z").array[1].number,
            run_json({"info", stack_}).at("extents").at("z").array[1].number);
  EXPECT_EQ(told.at("labels").number, 1);
  EXPECT_EQ(told.at("decisions").number, 1);
  Words words;
  for (const JsonValue& word : told.at("options").array) words.push_back(word.string);
  EXPECT_EQ(words, (Words{"--overlap", "0.25", "--no-lone", "--voids", "near=0.75", "--ends",
                          "half", "--between", "2"}));
  // They make the plan that they tell of.
  const std::string again = folder_.file("again.plan");
  ASSERT_EQ(run(with({"plan", stack_, "-o", again, "--labels", labels}, words)).code, 0);
  EXPECT_EQ(run_json({"info", again}).at("identity").string, told.at("identity").string);
  const std::string text = run({"info", plan_}).out;
  EXPECT_NE(text.find("20 sections, slabs 0:19"), std::string::npos) << text;
  EXPECT_NE(text.find("--ends half --between 2, 1 label and 1 decision"), std::string::npos)
      << text;
  EXPECT_TRUE(run({"info", plan_, "--quiet"}).out.empty());
}

TEST_F(OpenPieceIndex, InfoTellsOfPieces) {
  const Words pieces = make_pieces({0, 4, 9});
  const JsonValue told = run_json({"info", piece(1)});
  EXPECT_EQ(told.at("format").string, "piece");
  EXPECT_EQ(told.at("plan").string, run_json({"info", plan_}).at("identity").string);
  EXPECT_EQ(told.at("slabs").array[0].number, 4);
  EXPECT_EQ(told.at("slabs").array[1].number, 9);
  EXPECT_EQ(told.at("of").number, 9);
  ASSERT_EQ(told.at("open").array.size(), 2U);
  EXPECT_EQ(told.at("open").array[1].number, 5);
  const auto model = read_vtu(piece(1));
  EXPECT_EQ(told.at("tets").number, static_cast<double>(model->tets.size()));
  EXPECT_EQ(told.at("volume").number, volume(*model));
  const std::string text = run({"info", piece(1)}).out;
  EXPECT_NE(text.find("slabs 4:9 of 9: "), std::string::npos) << text;
  EXPECT_NE(text.find("left open, to be built from the plan by joining: 4 5"), std::string::npos)
      << text;
}

TEST_F(PieceIndex, InfoRefusesWhatIsDamaged) {
  make_plan(data("torus.cnt"));
  make_pieces({0, 19});
  for (const std::string& path : {plan_, piece(0)}) {
    const std::string whole = get(path);
    std::string bytes = whole;
    bytes[whole.size() / 2] = static_cast<char>(bytes[whole.size() / 2] ^ 1);
    put(path, bytes);
    expect_failure({"info", path}, 3, "invalid_input", path);
    put(path, whole.substr(0, whole.size() - 40));
    expect_failure({"info", path}, 3, "invalid_input", path);
  }
  // A solid that is no piece is still no stack.
  const std::string solid = folder_.file("solid.vtu");
  ASSERT_EQ(run({"reconstruct", stack_, "-o", solid}).code, 0);
  EXPECT_NE(run({"info", solid}).code, 0);
}

}  // namespace
}  // namespace tetloft
