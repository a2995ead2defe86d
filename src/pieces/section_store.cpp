#include "pieces/section_store.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/record.hpp"
#include "core/watched_work.hpp"
#include "reconstruct/decide_voids.hpp"
#include "reconstruct/section_record.hpp"
#include "sections/scaling.hpp"
#include "sections/validation.hpp"

namespace tetloft::internal::pieces {

namespace {

constexpr RecordKind kStored{"cont", 1, "a section"};
// Validated at once, on all threads.
constexpr std::size_t kMostAtOnce = 64;
constexpr std::size_t kMostVerticesAtOnce = std::size_t{1} << 17;

std::size_t vertex_count(const Section& section) {
  std::size_t vertices = 0;
  for (const Contour& contour : section.contours) vertices += contour.vertices.size();
  return vertices;
}

std::string to_record(const Section& section, const Nesting& nesting) {
  RecordWriter out(kStored);
  put_section(section, out);
  out.put_all(nesting.parent);
  out.put_all(nesting.depth);
  out.put_all(nesting.region);
  out.put_all(nesting.outer);
  return out.take();
}

Result<StoredSection> stored_from_record(std::string_view bytes, const std::string& name) {
  RecordReader in(bytes, kStored, name);
  StoredSection stored;
  stored.section = get_section(in);
  stored.nesting.parent.raw() = in.get_all<ContourId>();
  stored.nesting.depth.raw() = in.get_all<std::uint32_t>();
  stored.nesting.region.raw() = in.get_all<RegionId>();
  stored.nesting.outer.raw() = in.get_all<ContourId>();
  if (Result<void> read = in.end(); !read) return read.error();
  return stored;
}

}  // namespace

class StoreFiller {
 public:
  StoreFiller(const GivenSections& given, const Execution& execution, const std::string& path)
      : sections_(given.sections),
        known_(given.nestings),
        quiet_(untold(execution)),
        work_(quiet_, 0),
        path_(path),
        scratch_(path),
        archive_(scratch_) {}

  Result<SectionStore> fill() {
    next_ = next_batch();
    while (!next_.sections.empty()) {
      const Batch batch = std::move(next_);
      next_ = Batch{{}, batch.end, batch.error};
      if (auto error = add(batch)) {
        error->where = sections_.located(std::move(error->where));
        return *error;
      }
      if (scratch_.failure()) return *scratch_.failure();
    }
    if (next_.error) return *std::move(next_.error);
    if (store_.size() == 0) return sections::no_section_error();
    if (store_.contours_ == 0) {
      Error error = sections::no_contour_error();
      error.where = sections_.located(std::move(error.where));
      return error;
    }
    store_.frame_ = sections_.frame();
    store_.about_ = sections_.about();
    archive_.finish();
    if (scratch_.failure()) return *scratch_.failure();
    Result<ArchiveReader> reader = ArchiveReader::of(std::move(scratch_), path_);
    if (!reader) return reader.error();
    store_.archive_ = std::move(*reader);
    return std::move(store_);
  }

 private:
  struct Batch {
    std::vector<Section> sections;
    bool end = false;            // no more come
    std::optional<Error> error;  // instead of more
  };

  Batch next_batch() {
    Batch batch;
    for (std::size_t vertices = 0;
         batch.sections.size() < kMostAtOnce && vertices < kMostVerticesAtOnce;) {
      Result<std::optional<Section>> next = sections_.next();
      if (!next) batch.error = next.error();
      batch.end = !next || !*next;
      if (batch.end) break;
      vertices += vertex_count(**next);
      batch.sections.push_back(std::move(**next));
    }
    return batch;
  }

  // On another thread, if there are several, the next ones are read meanwhile.
  std::optional<Error> add(const Batch& read) {
    const std::vector<Section>& batch = read.sections;
    const std::size_t first = store_.size();
    std::vector<Result<Nesting>> nestings(batch.size(), Nesting());
    parallel_for(batch.size() + 1, quiet_.threads, [&](std::size_t i) {
      work_.go_on();
      if (i == 0) {
        if (!read.end) next_ = next_batch();
        return;
      }
      const std::size_t k = i - 1;
      nestings[k] = known_ != nullptr ? (*known_)[SectionId(first + k)]
                                      : sections::nest_section_if_valid(batch[k], first + k);
    });
    for (const Section& section : batch) store_.heights_.push_back(section.z);
    for (std::size_t k = 0; k < batch.size(); ++k) {
      if (auto error = sections::height_error(store_.heights_, first + k)) {
        return wrong_height(first + k);
      }
      if (!nestings[k]) return nestings[k].error();
      add(batch[k], *nestings[k]);
    }
    return std::nullopt;
  }

  void add(const Section& section, const Nesting& nesting) {
    store_.vertices_of_.push_back(vertex_count(section));
    store_.contours_ += section.contours.size();
    store_.has_hole_ = store_.has_hole_ || has_hole(nesting);
    store_.largest_ = std::max(store_.largest_, sections::largest_magnitude(section));
    sections::include(section, store_.unit_);
    store_.coarse_.add(sections::coarse_vertices(section));
    archive_.append(to_record(section, nesting));
  }

  // The remedy depends on the heights of all.
  std::optional<Error> wrong_height(std::size_t s) {
    for (const Section& section : next_.sections) store_.heights_.push_back(section.z);
    while (!next_.end) {
      const Result<std::optional<Section>> next = sections_.next();
      if (!next || !*next) return sections::height_error(store_.heights_, s);
      store_.heights_.push_back((*next)->z);
    }
    return sections::height_error(store_.heights_, s);
  }

  SectionStream& sections_;
  const IdVector<SectionId, Nesting>* known_;
  Execution quiet_;
  WatchedWork work_;
  const std::string& path_;
  io::ScratchFile scratch_;
  ArchiveWriter archive_;
  Batch next_;
  SectionStore store_;
};

Result<SectionStore> SectionStore::of(const GivenSections& given, const Execution& execution,
                                      const std::string& path) {
  return guard_internal([&]() -> Result<SectionStore> {
    if (Result<void> sound = fp_self_check(); !sound) return sound.error();
    return StoreFiller(given, execution, path).fill();
  });
}

Result<StoredSection> SectionStore::section(std::size_t s) const {
  const Result<std::string> bytes = archive_.record(s);
  if (!bytes) return bytes.error();
  return stored_from_record(*bytes, archive_.path());
}

Result<ValidStack> SectionStore::stack() const {
  SectionStack stack;
  stack.frame = frame_;
  stack.about = about_;
  IdVector<SectionId, Nesting> nestings;
  for (std::size_t s = 0; s < size(); ++s) {
    Result<StoredSection> stored = section(s);
    if (!stored) return stored.error();
    stack.sections.push_back(std::move(stored->section));
    nestings.push_back(std::move(stored->nesting));
  }
  return sections::ValidStackMaker::make(std::move(stack), std::move(nestings));
}

}  // namespace tetloft::internal::pieces
