// An index over pieces: what was left open where the stack was cut is built, and all else stays in
// the files that were given.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/pieces.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/text.hpp"
#include "io/files.hpp"
#include "io/pvtu.hpp"
#include "model/segment.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/piece_set.hpp"
#include "reconstruct/report_of.hpp"

namespace tetloft {

using namespace internal;

namespace internal::pieces {

namespace {

namespace fs = std::filesystem;

Error index_error(ErrorCode code, const std::string& file, std::string message) {
  Error error{code, std::move(message), {}};
  error.where.file = file;
  return error;
}

// Beside the index, by number.
std::string piece_path(const std::string& index, std::size_t k) {
  const fs::path path(index);
  return (path.parent_path() / (path.stem().string() + '_' + std::to_string(k) + ".vtu")).string();
}

// As it is called from the index's folder; what a link in its place points to does not matter.
Result<std::string> source_from(const std::string& index, const std::string& piece) {
  std::error_code code;
  const auto folder_of = [](const std::string& path) {
    return fs::absolute(fs::path(path)).parent_path();
  };
  const fs::path folder = fs::proximate(folder_of(piece), folder_of(index), code);
  if (code) return index_error(ErrorCode::io, piece, "its folder is not found: " + code.message());
  const std::string source = (folder / fs::path(piece).filename()).lexically_normal().string();
  if (valid_utf8(source) == source) return source;
  return index_error(ErrorCode::usage, piece, "an index cannot hold this name: it is no UTF-8");
}

class Indexing {
 public:
  Indexing(const std::string& path, const JoinOptions& options, io::TemporaryWatcher* watcher)
      : path_(path), options_(options), watcher_(watcher) {}

  Result<StagedIndex> stage(std::span<const std::string> paths) {
    if (io::extension_of(path_) != ".pvtu") {
      return index_error(ErrorCode::usage, path_, "an index needs a name that ends in .pvtu");
    }
    Result<std::vector<PieceAt>> all = read_pieces(paths);
    if (!all) return all.error();
    all_ = std::move(*all);
    Result<SettledPieces> settled = settle_pieces(all_, options_);
    if (!settled) return settled.error();
    settled_ = std::move(*settled);
    if (settled_.whole) take_whole();
    for (std::size_t k = 0; k < all_.size(); ++k) {
      if (Result<void> added = add(k); !added) return added.error();
    }
    staged_.index.components = all_.front().record.components;
    staged_.index.warnings = std::move(settled_.warnings);
    if (Result<void> written = stage_list(); !written) return written.error();
    return std::move(staged_);
  }

 private:
  // The whole stack was built: it stands in the place of all pieces.
  void take_whole() {
    Reconstruction& whole = *settled_.whole;
    add_up(whole.report, settled_.report);
    settled_.warnings = std::move(whole.warnings);
    const std::size_t slabs = all_.front().record.sections - 1;
    for (PieceAt& piece : all_) piece.record.components = whole.model.component_count;
    settled_.ranges.push_back({{0, slabs}, std::move(whole.model), {}});
  }

  Result<void> add(std::size_t k) {
    const PieceAt& piece = all_[k];
    const std::vector<Stretch> stretches = stretches_of(piece, settled_.ranges);
    const bool as_given = std::all_of(stretches.begin(), stretches.end(),
                                      [](const Stretch& one) { return one.built == nullptr; });
    Result<Model> model = as_given ? piece_model(piece.path, piece.record) : renewed(stretches);
    if (!model) return model.error();
    const Result<AddedSegment> fits = numbers_.add(*model, piece.record.slabs);
    if (!fits) return index_error(fits.error().code, piece.path, fits.error().message);
    staged_.index.tets += model->tets.size();
    with_stack_points_ = with_stack_points_ || !is_exact(model->frame);
    if (as_given) {
      staged_.index.pieces.push_back(piece.path);
      return {};
    }
    for (const Stretch& one : stretches) {
      if (one.built != nullptr) staged_.index.settled += one.slabs.end - one.slabs.first;
    }
    return write_anew(k, std::move(*model));
  }

  // What is left of a piece, and what was built.
  Result<Model> renewed(const std::vector<Stretch>& stretches) const {
    JoinedModel joined(stretches.front().slabs.first);
    std::optional<Model> left;
    for (const Stretch& one : stretches) {
      if (one.built == nullptr && !left) {
        Result<Model> read = piece_model(one.piece->path, one.piece->record);
        if (!read) return read.error();
        left = std::move(*read);
      }
      Result<void> added = joined.add(one.built != nullptr ? *one.built : *left, one.slabs);
      if (!added) return added.error();
    }
    return joined.take();
  }

  Result<void> write_anew(std::size_t k, Model model) {
    const std::string path = piece_path(path_, k);
    for (const PieceAt& given : all_) {
      std::error_code ignored;
      if (!fs::equivalent(path, given.path, ignored)) continue;
      return index_error(ErrorCode::usage, path,
                         "the piece has to be written anew, which would overwrite one that was "
                         "given: choose another name for the index");
    }
    WholePiece piece{all_[k].record, std::move(model)};
    piece.record.clusters = clusters_of(all_[k].record);
    piece.record.names = piece.model.component_names;
    // All that was built counts once, in the first of these pieces.
    add_up(std::exchange(settled_.report, {}), piece.record.report);
    Result<io::Staged> made = stage_whole_piece(path, piece, options_.encoding, watcher_);
    if (!made) return made.error();
    std::move(made->files.begin(), made->files.end(), std::back_inserter(staged_.files));
    staged_.index.pieces.push_back(path);
    staged_.index.written.push_back(path);
    return {};
  }

  // None is open any more: what a range holds of the piece is closed as it is.
  [[nodiscard]] std::vector<ClusterSpan> clusters_of(const PieceRecord& piece) const {
    std::vector<ClusterSpan> clusters;
    for (const BuiltRange& made : settled_.ranges) {
      const SlabRange part{std::max(piece.slabs.first, made.slabs.first),
                           std::min(piece.slabs.end, made.slabs.end)};
      if (part.first < part.end) clusters.push_back({part, {}});
    }
    const std::size_t built = clusters.size();
    for (const ClusterSpan& cluster : piece.clusters) {
      const bool replaced =
          std::any_of(clusters.begin(), clusters.begin() + static_cast<std::ptrdiff_t>(built),
                      [&](const ClusterSpan& made) { return cluster.slabs.meets(made.slabs); });
      if (!replaced) clusters.push_back(cluster);
    }
    return clusters;
  }

  Result<void> stage_list() {
    io::IndexedGrid grid;
    grid.with_stack_points = with_stack_points_;
    for (const std::string& piece : staged_.index.pieces) {
      Result<std::string> source = source_from(path_, piece);
      if (!source) return source.error();
      grid.sources.push_back(std::move(*source));
    }
    Result<io::Staged> list = io::stage(path_, watcher_, [&](io::Sink& sink) -> io::Written {
      io::append_index(sink, grid);
      return std::vector<Warning>();
    });
    if (!list) return list.error();
    std::move(list->files.begin(), list->files.end(), std::back_inserter(staged_.files));
    return {};
  }

  const std::string& path_;
  const JoinOptions& options_;
  io::TemporaryWatcher* watcher_;
  std::vector<PieceAt> all_;
  SettledPieces settled_;
  SegmentNumbers numbers_;  // so that pieces next to each other are known to fit
  bool with_stack_points_ = false;
  StagedIndex staged_;
};

}  // namespace

bool is_index(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;  // a stream is read once
  std::ifstream file(path, std::ios::binary);
  std::string first(512, '\0');
  file.read(first.data(), static_cast<std::streamsize>(first.size()));
  first.resize(static_cast<std::size_t>(file.gcount()));
  return io::begins_as_index(first);
}

Result<std::vector<std::string>> listed_pieces(std::span<const std::string> paths) {
  std::vector<std::string> all;
  for (const std::string& path : paths) {
    if (!is_index(path)) {
      all.push_back(path);
      continue;
    }
    const Result<std::string> bytes = io::read_file(path);
    if (!bytes) return bytes.error();
    const Result<std::vector<std::string>> sources = io::index_sources(*bytes, path);
    if (!sources) return sources.error();
    const fs::path folder = fs::path(path).parent_path();
    for (const std::string& source : *sources) all.push_back((folder / source).string());
  }
  return all;
}

Result<StagedIndex> stage_index(const std::string& path, std::span<const std::string> pieces,
                                const JoinOptions& options, io::TemporaryWatcher* watcher) {
  return guard_threads(
      options, [&](const JoinOptions& own) { return Indexing(path, own, watcher).stage(pieces); });
}

}  // namespace internal::pieces

Result<WrittenIndex> write_index(const std::string& path, std::span<const std::string> pieces,
                                 const JoinOptions& options) {
  Result<pieces::StagedIndex> staged = internal::pieces::stage_index(path, pieces, options);
  if (!staged) return staged.error();
  return guard_internal([&]() -> Result<WrittenIndex> {
    if (Result<void> done = io::commit_all(staged->files); !done) return done.error();
    return std::move(staged->index);
  });
}

}  // namespace tetloft
