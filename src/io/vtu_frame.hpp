// How a .vtu tells where a model lies: the frame as data of the whole grid, and, where placing
// points rounds, the points of the stack as data of the points.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include <tetloft/frame.hpp>
#include <tetloft/ids.hpp>

namespace tetloft::internal::io {

inline constexpr std::string_view kFrameArray = "frame";
inline constexpr std::string_view kStackPointArray = "stack_point";
inline constexpr std::size_t kFrameNumbers = 12;

/// The axes one after the other, then the origin.
[[nodiscard]] std::array<double, kFrameNumbers> numbers_of(const Frame& frame);
[[nodiscard]] Frame frame_of(const std::vector<double>& numbers);

/// Takes the points of a model from where they lie back to the stack: by exchanging coordinates, or
/// to `stack_points`, three numbers each. False, and nothing is done, unless placing them gives
/// `points`, bit for bit: somebody moved them.
[[nodiscard]] bool take_back(const Frame& frame, const std::vector<double>& stack_points,
                             IdVector<VertexId, Point3>& points);

}  // namespace tetloft::internal::io
