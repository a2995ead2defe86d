// The codes of DEFLATE (RFC 1951), which packing and unpacking have in common.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tetloft::internal::io {

inline constexpr std::size_t kWindow = std::size_t{1} << 15;
inline constexpr std::size_t kLongestMatch = 258;
inline constexpr unsigned kEndOfBlock = 256;

// RFC 1951, 3.2.5: base values and extra bits of length codes 257… and of distance codes.
struct CodedRange {
  std::uint16_t base;
  std::uint8_t extra;
};
inline constexpr std::array<CodedRange, 29> kMatchLengths{
    {{3, 0},  {4, 0},  {5, 0},  {6, 0},   {7, 0},   {8, 0},   {9, 0},   {10, 0},  {11, 1}, {13, 1},
     {15, 1}, {17, 1}, {19, 2}, {23, 2},  {27, 2},  {31, 2},  {35, 3},  {43, 3},  {51, 3}, {59, 3},
     {67, 4}, {83, 4}, {99, 4}, {115, 4}, {131, 5}, {163, 5}, {195, 5}, {227, 5}, {258, 0}}};
inline constexpr std::array<CodedRange, 30> kMatchDistances{
    {{1, 0},     {2, 0},     {3, 0},     {4, 0},      {5, 1},      {7, 1},
     {9, 2},     {13, 2},    {17, 3},    {25, 3},     {33, 4},     {49, 4},
     {65, 5},    {97, 5},    {129, 6},   {193, 6},    {257, 7},    {385, 7},
     {513, 8},   {769, 8},   {1025, 9},  {1537, 9},   {2049, 10},  {3073, 10},
     {4097, 11}, {6145, 11}, {8193, 12}, {12289, 12}, {16385, 13}, {24577, 13}}};

// Section 3.2.7: the order in which lengths of the code-length code are sent.
inline constexpr std::array<std::uint8_t, 19> kCodeLengthOrder{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                               11, 4,  12, 3, 13, 2, 14, 1, 15};

}  // namespace tetloft::internal::io
