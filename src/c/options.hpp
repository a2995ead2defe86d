// Options of C as those of C++. Each takes NULL for the defaults, and ends a body with
// TETLOFT_USAGE, naming the field, where a struct is of no known version or a field makes no sense
// by itself; nested ones likewise. Numbers whose range the functions look at are left to them.
#pragma once

#include <tetloft/tetloft.h>
#include <tetloft/correspondence.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/formats.hpp>

namespace tetloft::internal::c {

[[nodiscard]] Execution execution_of(const tetloft_execution* execution);
[[nodiscard]] ReadOptions read_options_of(const tetloft_read_options* options);
[[nodiscard]] WriteOptions write_options_of(const tetloft_write_options* options);
[[nodiscard]] CorrespondenceOptions correspondence_of(const tetloft_correspondence* options);

}  // namespace tetloft::internal::c
