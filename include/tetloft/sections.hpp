// All about sections; each part can be included alone.
#pragma once

#include <tetloft/conforming_section.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/overlap.hpp>
#include <tetloft/repair.hpp>
#include <tetloft/section_stack.hpp>
#include <tetloft/section_stream.hpp>
#include <tetloft/skeleton.hpp>
#include <tetloft/slice.hpp>
#include <tetloft/valid_stack.hpp>
