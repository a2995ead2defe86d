// What a shared library offers: everything declared in these headers, nothing else.
#pragma once

/// Before every public function, and every class with members that are not inline. Empty for
/// static libraries; TETLOFT_SHARED is defined for the sources of a shared library and for those
/// who link it, TETLOFT_BUILDING for its sources alone.
#if !defined(TETLOFT_SHARED)
#define TETLOFT_API
#elif !defined(_WIN32)
#define TETLOFT_API __attribute__((visibility("default")))
#elif defined(TETLOFT_BUILDING)
#define TETLOFT_API __declspec(dllexport)
#else
#define TETLOFT_API __declspec(dllimport)
#endif
