// Many questions at once, by several threads, in an order in which each is near the last one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/execution.hpp>

#include "core/parallel.hpp"
#include "core/watched_work.hpp"

namespace tetloft::internal {

/// A thread takes so many neighbouring questions at a time. Each search of a stretch starts at the
/// answer to the last one, so what comes out does not depend on the number of threads.
inline constexpr std::size_t kAskedTogether = 1024;

/// result[i] is ask(i, before): a pointer to the answer of the question before in the order, which
/// is of all i, or null.
template <class Answer, class Ask>
[[nodiscard]] std::vector<Answer> asked_together(std::span<const std::uint32_t> order,
                                                 const Execution& execution, const Ask& ask) {
  std::vector<Answer> answers(order.size());
  const std::size_t stretches = std::max<std::size_t>(order.size() / kAskedTogether, 1);
  WatchedWork work(execution, stretches);
  parallel_for(stretches, execution.threads, [&](std::size_t k) {
    work.go_on();
    const Answer* before = nullptr;
    const std::size_t end = order.size() * (k + 1) / stretches;
    for (std::size_t place = order.size() * k / stretches; place < end; ++place) {
      Answer& answer = answers[order[place]];
      answer = ask(order[place], before);
      before = &answer;
    }
    work.step_done();
  });
  return answers;
}

}  // namespace tetloft::internal
