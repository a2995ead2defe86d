// See plan_info.hpp.
#include "cli/plan_info.hpp"

#include <array>
#include <cstddef>
#include <cstdio>
#include <vector>

#include <tetloft/model.hpp>
#include <tetloft/pieces.hpp>

#include "io/numbers.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/plan_head.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

// The options that a plan was made with, as they were given to it; those that are as without.
std::vector<std::string> option_words(const ReconstructOptions& options) {
  const CorrespondenceOptions& rule = options.correspondence;
  std::vector<std::string> words;
  const auto add = [&](const std::string& option, const std::string& value) {
    words.push_back(option);
    if (!value.empty()) words.push_back(value);
  };
  constexpr std::array<const char*, 3> kCriteria{"overlap", "reverse", "moved"};
  if (rule.criterion != Criterion::moved) {
    add("--correspondence", kCriteria[static_cast<std::size_t>(rule.criterion)]);
  }
  if (rule.tau) add("--overlap", exact(*rule.tau));
  if (!rule.chain) add("--no-chain", {});
  if (!rule.lone) add("--no-lone", {});
  if (rule.voids.rule == VoidRule::free) add("--voids", "free");
  if (rule.voids.rule == VoidRule::near) add("--voids", "near=" + exact(rule.voids.reach));
  if (options.ends == Ends::half) add("--ends", "half");
  if (options.between) {
    add("--between", *options.between == 0 ? "none" : std::to_string(*options.between));
  }
  if (options.delaunay != DelaunayEngine::automatic) add("--delaunay", name_of(options.delaunay));
  if (!options.divide_coarse) add("--no-divide", {});
  if (options.thickness) add("--thickness", exact(*options.thickness));
  if (options.work_limit != kDefaultWorkLimit) {
    add("--work-limit", exact(options.work_limit));
  }
  return words;
}

std::size_t label_count(const ReconstructOptions& options) {
  return options.correspondence.labels.size() + options.correspondence.voids.labels.size();
}

std::size_t decision_count(const ReconstructOptions& options) {
  return options.correspondence.decisions.size() + options.correspondence.voids.decisions.size();
}

std::string json_of(const PlanSummary& plan, const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.member("format", "plan");
  json.member("version", internal::pieces::kPlanVersion);
  json.member("identity", in_hex(plan.identity));
  json.key("source");
  json.begin_object();
  json.member("name", plan.source.name);
  json.member("bytes", plan.source.bytes);
  json.member("checksum", in_hex(plan.source.checksum));
  json.end_object();
  json.member("sections", plan.sections);
  json.member("slabs", plan.sections - 1);
  json.member("contours", plan.contours);
  json.member("vertices", plan.vertices);
  json.member("z", std::array{plan.lowest, plan.highest});
  json.member("components", plan.components);
  json.member("cavities", plan.cavities);
  json.member("options", option_words(plan.options));
  json.member("labels", label_count(plan.options));
  json.member("decisions", decision_count(plan.options));
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string text_of(const PlanSummary& plan) {
  std::string text = "a plan, version " + std::to_string(internal::pieces::kPlanVersion) +
                     ", identity " + in_hex(plan.identity) + "; all of it is whole\n";
  if (plan.source != PlanSource{}) {
    text += "of " + io::in_quotes(plan.source.name) + ", " + std::to_string(plan.source.bytes) +
            " bytes\n";
  }
  text += counted(plan.sections, "section") + ", slabs 0:" + std::to_string(plan.sections - 1) +
          ", " + counted(plan.contours, "contour") + ", " + std::to_string(plan.vertices) +
          " vertices, z " + readable(plan.lowest) + " to " + readable(plan.highest) + '\n' +
          counted(plan.components, "component") + ", cavities: " + std::to_string(plan.cavities) +
          '\n';
  text += "options:";
  const std::vector<std::string> words = option_words(plan.options);
  for (const std::string& word : words) text += ' ' + word;
  if (words.empty()) text += " none";
  const std::size_t wishes = label_count(plan.options) + decision_count(plan.options);
  if (wishes > 0) {
    text += ", " + counted(label_count(plan.options), "label") + " and " +
            counted(decision_count(plan.options), "decision");
  }
  return text + '\n';
}

std::string json_of(const PieceSummary& piece, const Model& model, const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.member("format", "piece");
  json.member("version", internal::pieces::kPieceVersion);
  json.member("plan", in_hex(piece.plan));
  json.member("slabs", std::array{piece.first, piece.end});
  json.member("of", piece.sections - 1);
  json.member("open", piece.open);
  json.member("vertices", model.points.size());
  json.member("tets", model.tets.size());
  json.member("components", model.component_count);
  json.member("volume", volume(model));
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string text_of(const PieceSummary& piece, const Model& model) {
  std::string text = "a piece, version " + std::to_string(internal::pieces::kPieceVersion) +
                     ", of the plan " + in_hex(piece.plan) + "; all of it is whole\n" + "slabs " +
                     std::to_string(piece.first) + ':' + std::to_string(piece.end) + " of " +
                     std::to_string(piece.sections - 1) + ": " + counted(model.tets.size(), "tet") +
                     ", " + std::to_string(model.points.size()) + " vertices, volume " +
                     readable(volume(model)) + ", of a stack of " +
                     counted(model.component_count, "component") + '\n';
  if (!piece.open.empty()) {
    text += "left open, to be built from the plan by joining:";
    for (const std::size_t slab : piece.open) text += ' ' + std::to_string(slab);
    text += '\n';
  }
  return text;
}

std::string json_of(const IndexSummary& index, const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.member("format", "index");
  json.member("complete", !index.wrong.has_value());
  json.member("wrong", index.wrong ? to_string(*index.wrong) : std::string());
  json.key("pieces");
  json.begin_array();
  for (const ListedPiece& listed : index.pieces) {
    json.begin_object();
    json.member("file", listed.path);
    json.member("wrong", listed.wrong ? to_string(*listed.wrong) : std::string());
    if (listed.piece) {
      json.member("plan", in_hex(listed.piece->plan));
      json.member("slabs", std::array{listed.piece->first, listed.piece->end});
      json.member("of", listed.piece->sections - 1);
      json.member("open", listed.piece->open);
      json.member("vertices", listed.vertices);
      json.member("tets", listed.tets);
    }
    json.end_object();
  }
  json.end_array();
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string text_of(const IndexSummary& index) {
  const PieceSummary* any = nullptr;
  std::size_t tets = 0;
  for (const ListedPiece& listed : index.pieces) {
    if (any == nullptr && listed.piece) any = &*listed.piece;
    tets += listed.tets;
  }
  std::string text = "an index over " + counted(index.pieces.size(), "piece");
  if (any != nullptr) {
    text += " of the plan " + in_hex(any->plan) + ", " + std::to_string(any->sections - 1) +
            " slabs, " + counted(tets, "tet");
  }
  text += index.wrong ? "; not whole: " + to_string(*index.wrong) + '\n'
                      : std::string("; all are there\n");
  text += "      slabs        tets    vertices  file\n";
  for (const ListedPiece& listed : index.pieces) {
    const std::string slabs =
        listed.piece ? std::to_string(listed.piece->first) + ':' + std::to_string(listed.piece->end)
                     : std::string("?");
    char line[80];
    std::snprintf(line, sizeof line, "%11s %11zu %11zu  ", slabs.c_str(), listed.tets,
                  listed.vertices);
    text += line + listed.path;
    if (listed.piece && any != nullptr && listed.piece->plan != any->plan) {
      text += " (of the plan " + in_hex(listed.piece->plan) + ')';
    }
    text += '\n';
  }
  return text;
}

}  // namespace

Result<std::optional<std::string>> plan_or_piece_info(const std::string& path,
                                                      const Console& console) {
  using Told = std::optional<std::string>;
  if (internal::pieces::is_index(path)) {
    const Result<IndexSummary> index = read_index(path);
    if (!index) return index.error();
    return Told(console.json() ? json_of(*index, console) : text_of(*index));
  }
  const Result<internal::pieces::Part> part = internal::pieces::part_of(path);
  if (!part) return part.error();
  if (*part == internal::pieces::Part::plan) {
    const Result<PlanSummary> plan = check_plan(path);
    if (!plan) return plan.error();
    return Told(console.json() ? json_of(*plan, console) : text_of(*plan));
  }
  if (*part == internal::pieces::Part::piece) {
    const Result<internal::pieces::WholePiece> piece = internal::pieces::read_whole_piece(path);
    if (!piece) return piece.error();
    const PieceSummary summary = internal::pieces::summary_of(piece->record);
    return Told(console.json() ? json_of(summary, piece->model, console)
                               : text_of(summary, piece->model));
  }
  return Told();
}

}  // namespace tetloft::cli
