// Numbers in fields of a width: decks of Fortran programs, which cut off what is longer.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <tetloft/model.hpp>
#include <tetloft/result.hpp>

namespace tetloft::internal::io {

/// Of at most `width` characters (12 at least) the decimal number nearest to `value`, which is
/// finite; with a point and an exponent behind E, if any, as decks ask for reals. The shortest
/// digits that read back where they fit.
[[nodiscard]] std::string fitted_number(double value, std::size_t width);

/// A warning where coordinates do not read back to the same bits from such fields, with the largest
/// difference.
[[nodiscard]] std::vector<Warning> fitting_warnings(const Model& model, std::size_t width);

}  // namespace tetloft::internal::io
