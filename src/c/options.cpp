#include "c/options.hpp"

#include "c/arrays.hpp"
#include "c/handles.hpp"
#include "c/structs.hpp"

namespace tetloft::internal::c {

namespace {

tetloft_execution default_execution() {
  tetloft_execution execution{};
  execution.version = TETLOFT_EXECUTION_VERSION;
  return execution;
}

tetloft_read_options default_read_options() {
  tetloft_read_options options{};
  options.version = TETLOFT_READ_OPTIONS_VERSION;
  return options;
}

tetloft_write_options default_write_options() {
  tetloft_write_options options{};
  options.version = TETLOFT_WRITE_OPTIONS_VERSION;
  return options;
}

tetloft_correspondence default_correspondence() {
  const CorrespondenceOptions defaults;
  tetloft_correspondence options{};
  options.version = TETLOFT_CORRESPONDENCE_VERSION;
  options.criterion = static_cast<std::int32_t>(defaults.criterion);
  options.tau = -1;
  options.chain = defaults.chain ? 1 : 0;
  options.lone = defaults.lone ? 1 : 0;
  options.void_rule = static_cast<std::int32_t>(defaults.voids.rule);
  options.void_reach = defaults.voids.reach;
  return options;
}

}  // namespace

Execution execution_of(const tetloft_execution* execution) {
  if (execution == nullptr) return {};
  require_version(*execution, TETLOFT_EXECUTION_VERSION, "execution");
  Execution result;
  result.threads = execution->threads;
  if (execution->stop != nullptr) {
    result.stop = value_of_handle(execution->stop, "execution: stop")->get_token();
  }
  if (execution->progress != nullptr) {
    result.progress = [progress = execution->progress, user = execution->user](std::size_t done,
                                                                               std::size_t all) {
      if (progress(user, done, all) != 0) {
        throw Cancelled("stopped by the progress callback");
      }
    };
  }
  return result;
}

ReadOptions read_options_of(const tetloft_read_options* options) {
  if (options == nullptr) return {};
  require_version(*options, TETLOFT_READ_OPTIONS_VERSION, "read options");
  ReadOptions result;
  result.validity = options->unchecked != 0 ? Validity::unchecked : Validity::required;
  if (options->format != nullptr) result.format = options->format;
  return result;
}

WriteOptions write_options_of(const tetloft_write_options* options) {
  if (options == nullptr) return {};
  require_version(*options, TETLOFT_WRITE_OPTIONS_VERSION, "write options");
  WriteOptions result;
  result.encoding = options->ascii == 0   ? Encoding::binary
                    : options->ascii == 2 ? Encoding::compressed
                                          : Encoding::ascii;
  if (options->format != nullptr) result.format = options->format;
  return result;
}

CorrespondenceOptions correspondence_of(const tetloft_correspondence* options) {
  if (options == nullptr) return {};
  require_version(*options, TETLOFT_CORRESPONDENCE_VERSION, "correspondence");
  CorrespondenceOptions result;
  result.criterion =
      enumerator_of(options->criterion, Criterion::moved, "correspondence: criterion");
  // Below 0 the default; what is no number is not below, and refused where it is used.
  if (!(options->tau < 0)) result.tau = options->tau;
  result.chain = options->chain != 0;
  result.lone = options->lone != 0;
  result.voids.rule =
      enumerator_of(options->void_rule, VoidRule::free, "correspondence: void_rule");
  result.voids.reach = options->void_reach;
  if (options->labels != nullptr) {
    const auto labels = value_of_handle(options->labels, "correspondence: labels");
    result.labels = labels->labels;
    result.decisions = labels->decisions;
    result.voids.labels = labels->hole_labels;
    result.voids.decisions = labels->void_decisions;
  }
  return result;
}

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_execution_defaults(tetloft_execution* execution) {
  return answer([&] {
    require_output(execution, "execution");
    *execution = default_execution();
  });
}

tetloft_status tetloft_read_options_defaults(tetloft_read_options* options) {
  return answer([&] {
    require_output(options, "options");
    *options = default_read_options();
  });
}

tetloft_status tetloft_write_options_defaults(tetloft_write_options* options) {
  return answer([&] {
    require_output(options, "options");
    *options = default_write_options();
  });
}

tetloft_status tetloft_correspondence_defaults(tetloft_correspondence* options) {
  return answer([&] {
    require_output(options, "options");
    *options = default_correspondence();
  });
}

tetloft_status tetloft_stop_create(tetloft_stop** stop) {
  clear(stop);
  return answer([&] {
    require_output(stop, "stop");
    hand_out(stop, std::stop_source());
  });
}

tetloft_status tetloft_stop_request(tetloft_stop* stop) {
  return answer([&] {
    // Requesting is const: the source is a name of what it shares with its tokens.
    std::stop_source source = *value_of_handle(stop, "stop");
    source.request_stop();
  });
}

tetloft_status tetloft_stop_free(tetloft_stop* stop) { return free_handle(stop); }
