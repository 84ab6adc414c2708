#pragma once

// LIMEN_API marks a declaration that the shared libraries export; all others are hidden (docs/api-stability.md).
// LIMEN_SHARED is defined for users of a shared library, LIMEN_BUILDS_SHARED while one is compiled; both matter on
// Windows only.
#if defined(_WIN32) && defined(LIMEN_BUILDS_SHARED)
#define LIMEN_API __declspec(dllexport)
#elif defined(_WIN32) && defined(LIMEN_SHARED)
#define LIMEN_API __declspec(dllimport)
#elif defined(_WIN32)
#define LIMEN_API
#else
#define LIMEN_API __attribute__((visibility("default")))
#endif

// Between these two lines all declarations are exported: for headers of plain structs. Templates over a hidden type are
// hidden, too.
#if defined(_WIN32)
#define LIMEN_API_BEGIN
#define LIMEN_API_END
#else
#define LIMEN_API_BEGIN _Pragma("GCC visibility push(default)")
#define LIMEN_API_END _Pragma("GCC visibility pop")
#endif
