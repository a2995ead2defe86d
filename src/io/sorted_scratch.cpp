#include "io/sorted_scratch.hpp"

#include <algorithm>

namespace tetloft::internal::io {

namespace {

// A run, read stretch by stretch.
class SortedRun {
 public:
  SortedRun(ScratchColumn<double>& column, std::size_t first, std::size_t end, std::size_t stretch)
      : column_(&column), next_(first), end_(end), stretch_(stretch) {
    load();
  }

  [[nodiscard]] bool at_end() const { return at_ == loaded_.size(); }
  [[nodiscard]] double value() const { return loaded_[at_]; }
  void step() {
    if (++at_ == loaded_.size()) load();
  }

 private:
  void load() {
    const std::size_t count = std::min(stretch_, end_ - next_);
    loaded_ = column_->values(next_, next_ + count);
    next_ += count;
    at_ = 0;
  }

  ScratchColumn<double>* column_;
  std::size_t next_, end_, stretch_;
  std::vector<double> loaded_;
  std::size_t at_ = 0;
};

}  // namespace

void SortedScratch::push_back(double value) {
  run_.push_back(value);
  if (run_.size() >= run_size_) put_away();
}

void SortedScratch::put_away() {
  if (run_.empty()) return;
  std::sort(run_.begin(), run_.end());
  for (const double value : run_) sorted_.push_back(value);
  ends_.push_back(sorted_.size());
  run_.clear();
}

void SortedScratch::for_each(const std::function<bool(double)>& visit) {
  put_away();
  if (failure()) return;
  std::vector<SortedRun> runs;
  std::size_t first = 0;
  for (const std::size_t end : ends_) {
    runs.emplace_back(sorted_, first, end, stretch_);
    first = end;
  }
  // A heap, the least on top.
  const auto later = [](const SortedRun& a, const SortedRun& b) { return a.value() > b.value(); };
  std::make_heap(runs.begin(), runs.end(), later);
  while (!runs.empty()) {
    std::pop_heap(runs.begin(), runs.end(), later);
    if (!visit(runs.back().value())) return;
    runs.back().step();
    if (runs.back().at_end()) {
      runs.pop_back();
    } else {
      std::push_heap(runs.begin(), runs.end(), later);
    }
  }
}

}  // namespace tetloft::internal::io
