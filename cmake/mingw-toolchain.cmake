# Cross-build for 64-bit Windows with Debian's MinGW-w64. The libraries come from tools/windows-deps; nothing of this
# system's own libraries is found.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(triple x86_64-w64-mingw32)
set(CMAKE_C_COMPILER ${triple}-gcc-posix)
set(CMAKE_CXX_COMPILER ${triple}-g++-posix)
set(CMAKE_RC_COMPILER ${triple}-windres)

set(LIMEN_WINDOWS_DEPS ${CMAKE_CURRENT_LIST_DIR}/../build/windows-deps/prefix CACHE PATH "Libraries made by tools/windows-deps")
cmake_path(NORMAL_PATH LIMEN_WINDOWS_DEPS)
set(CMAKE_FIND_ROOT_PATH ${LIMEN_WINDOWS_DEPS})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_LIBDIR} ${LIMEN_WINDOWS_DEPS}/lib/pkgconfig)
set(PKG_CONFIG_ARGN --static)

# Windows 10: the first version with UTF-8 as a program's code page.
add_compile_definitions(_WIN32_WINNT=0x0A00 WINVER=0x0A00 NOMINMAX WIN32_LEAN_AND_MEAN)
