# What every target of ours shares: the language level, warnings as errors, sanitizers. Hung on
# targets, never on directories, so that libraries from outside keep their own flags.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})

find_program(LIMEN_CCACHE ccache)
if(LIMEN_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${LIMEN_CCACHE})
endif()

add_library(limen_flags INTERFACE)
target_compile_options(limen_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    -Wnon-virtual-dtor -Woverloaded-virtual -Werror)
# Products and sums keep their written rounding: results must not depend on whether a compiler fuses them.
target_compile_options(limen_flags INTERFACE -ffp-contract=off)
if(LIMEN_SANITIZE)
    target_compile_options(limen_flags INTERFACE -fsanitize=${LIMEN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(limen_flags INTERFACE -fsanitize=${LIMEN_SANITIZE})
    # GCC's manual: with sanitizers this one warns of what is not there (it does of std::regex).
    target_compile_options(limen_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

# limen_room(name sources...): one library per folder of src, alias limen::name. The room's public
# headers are included as "name/Header.h".
function(limen_room name)
    add_library(limen_${name} STATIC ${ARGN})
    add_library(limen::${name} ALIAS limen_${name})
    target_include_directories(limen_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(limen_${name} PRIVATE limen_flags)
endfunction()

# limen_test(name LABELS l... SOURCES s... LINK t...): one gtest program; every test in it becomes a CTest test.
function(limen_test name)
    cmake_parse_arguments(ARG "" "" "LABELS;SOURCES;LINK" ${ARGN})
    add_executable(${name} ${ARG_SOURCES})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_link_libraries(${name} PRIVATE limen_flags ${ARG_LINK} GTest::gtest GTest::gmock GTest::gtest_main)
    if(ARG_LABELS)
        set(props PROPERTIES LABELS "${ARG_LABELS}")
    endif()
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 120 ${props})
endfunction()
