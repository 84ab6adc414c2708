# Settings of all our targets: language level, warnings as errors, sanitizers. They are attached to targets,
# never to directories, so that external libraries keep their own flags.

# The folder of sources for this system: each is one of a pair behind the same header.
if(WIN32)
    set(LIMEN_PLATFORM windows)
else()
    set(LIMEN_PLATFORM posix)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 99)
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})

find_program(LIMEN_CCACHE ccache)
if(LIMEN_CCACHE AND PROJECT_IS_TOP_LEVEL)
    # Without these settings ccache compiles each source that uses a precompiled header again.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${LIMEN_CCACHE})
endif()

add_library(limen_flags INTERFACE)
target_compile_options(limen_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor> $<$<COMPILE_LANGUAGE:CXX>:-Woverloaded-virtual>)
# GCC 12 at -O3 warns of concatenated strings without reason (its bug 105651); GCC 13 does not.
target_compile_options(limen_flags INTERFACE $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)
# A warning of ours is no error of a project that contains ours, perhaps with another compiler, nor where that project makes
# all warnings errors.
option(LIMEN_WERROR "Treat warnings as errors" ${PROJECT_IS_TOP_LEVEL})
if(LIMEN_WERROR)
    target_compile_options(limen_flags INTERFACE -Werror)
else()
    set(CMAKE_COMPILE_WARNING_AS_ERROR OFF)
    target_compile_options(limen_flags INTERFACE -Wno-error)
endif()
# No fused multiply-add: results must not depend on the compiler.
target_compile_options(limen_flags INTERFACE -ffp-contract=off)
if(LIMEN_SANITIZE)
    target_compile_options(limen_flags INTERFACE -fsanitize=${LIMEN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(limen_flags INTERFACE -fsanitize=${LIMEN_SANITIZE})
    # With sanitizers this warning has false positives (GCC manual), e.g. for std::regex.
    target_compile_options(limen_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

find_program(LIMEN_LLD ld.lld)
if(LIMEN_LLD AND PROJECT_IS_TOP_LEVEL AND NOT WIN32)
    target_link_options(limen_flags INTERFACE -fuse-ld=lld) # links the test programs in a fraction of the time
endif()

# limen_unite(target): compiles several sources of a folder as one, in less than half the time. Therefore
# names in unnamed namespaces must be unique within a folder. The presets `dev`, `clang`, `coverage` and
# `tidy` compile each source alone, which checks that it includes all headers it uses.
option(LIMEN_UNITE "Compile several sources as one" OFF)
set(LIMEN_UNITED_SOURCES 24 CACHE STRING "Largest number of sources compiled as one")
function(limen_unite target)
    if(NOT LIMEN_UNITE)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source ${sources})
        cmake_path(GET source PARENT_PATH folder)
        string(MAKE_C_IDENTIFIER "in ${folder}" key)
        math(EXPR count "0${${key}} + 1")
        set(${key} ${count})
        math(EXPR group "(${count} - 1) / ${LIMEN_UNITED_SOURCES}")
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${key}_${group}")
    endforeach()
endfunction()

# GCC collects garbage from 128 MiB on, which takes a tenth of the time of united sources.
if(LIMEN_UNITE)
    target_compile_options(limen_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>)
endif()

# limen_share_headers(target set): where our own presets unite sources, headers that nearly all sources include are compiled once for
# all targets of a set. These must have the same options: `library` and `program` for rooms, `test`. GCC forgets that a precompiled
# header is one of the system, and then warns of it where it optimises; so with GCC only `test`, which is not optimised, shares them.
function(limen_share_headers target set)
    if(NOT LIMEN_UNITE OR NOT PROJECT_IS_TOP_LEVEL OR CMAKE_CROSSCOMPILING)
        return()
    endif()
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT set STREQUAL "test")
        return()
    endif()
    if(NOT TARGET limen_headers_${set})
        set(empty ${PROJECT_BINARY_DIR}/limen_headers.cpp)
        file(CONFIGURE OUTPUT ${empty} CONTENT "// The headers of limen_share_headers.\n")
        add_library(limen_headers_${set} OBJECT ${empty})
        target_link_libraries(limen_headers_${set} PRIVATE limen_flags)
        # For ccache, which must know the parts of a precompiled header and find no times in it.
        target_compile_options(limen_headers_${set} PUBLIC $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
            $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)
        set(headers <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <span> <string> <vector>)
        if(set STREQUAL "library")
            limen_make_library_room(limen_headers_library)
        elseif(set STREQUAL "test")
            target_link_libraries(limen_headers_test PRIVATE GTest::gtest GTest::gmock)
            target_compile_options(limen_headers_test PRIVATE ${LIMEN_TEST_OPTIONS})
            list(APPEND headers <fstream> <random> <set> <gtest/gtest.h> <gmock/gmock.h>)
        endif()
        target_precompile_headers(limen_headers_${set} PRIVATE ${headers})
    endif()
    target_precompile_headers(${target} REUSE_FROM limen_headers_${set})
    target_compile_options(${target} PRIVATE $<TARGET_PROPERTY:limen_headers_${set},INTERFACE_COMPILE_OPTIONS>)
endfunction()

# The rooms that the libraries for other projects are made of. Their objects also go into shared libraries, and only
# declarations with LIMEN_API are exported.
set(LIMEN_LIBRARY_ROOMS core geometry visibility dat worlds placements world motion frame gpu reference check engine)

# limen_make_library_room(target): options of a target whose objects also go into shared libraries.
function(limen_make_library_room target)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# limen_room(name sources...): a library for a folder of src, with the alias limen_room::name. Its headers are
# included as "name/Header.h". The libraries for other projects are limen::name (LimenProduct.cmake).
function(limen_room name)
    add_library(limen_${name} STATIC ${ARGN})
    add_library(limen_room::${name} ALIAS limen_${name})
    set(headers program)
    if(name IN_LIST LIMEN_LIBRARY_ROOMS)
        set(headers library)
        limen_make_library_room(limen_${name})
        if(WIN32 AND BUILD_SHARED_LIBS)
            target_compile_definitions(limen_${name} PRIVATE LIMEN_BUILDS_SHARED)
        endif()
    endif()
    target_include_directories(limen_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(limen_${name} PRIVATE limen_flags)
    # The fuzzers are guided by branches and comparisons in `dat`, by branches alone elsewhere: comparisons
    # would make the sanitizer tests half as slow again.
    if(LIMEN_BUILD_FUZZERS AND name STREQUAL "dat")
        target_compile_options(limen_${name} PRIVATE -fsanitize=fuzzer-no-link)
    elseif(LIMEN_BUILD_FUZZERS)
        target_compile_options(limen_${name} PRIVATE -fsanitize-coverage=inline-8bit-counters,pc-table)
    endif()
    limen_unite(limen_${name})
    if(NOT LIMEN_BUILD_FUZZERS OR NOT name STREQUAL "dat") # else its options are not those of its set
        limen_share_headers(limen_${name} ${headers})
    endif()
endfunction()

# limen_test(name [TOGETHER] [BUSY] [LONG] [WHOLE] LABELS l... SOURCES s... LINK t...): a gtest program. Each suite is
# a CTest test. The tests of a suite share a process, because many use the same world, which takes longer to
# make than to test. TOGETHER: all suites share one process. LONG: starts first. The target `unlabelled_tests`
# builds the programs without labels, which are those that run under sanitizers. WHOLE: the program tests
# whole worlds, or no code that reads foreign bytes; the target `whole_world_tests` builds it, for
# `./test --all`. Test code is not optimised, which halves its compile time. BUSY: it is, because the test itself
# computes much.
if(LIMEN_BUILD_TESTS)
    add_custom_target(unlabelled_tests)
    add_custom_target(whole_world_tests)
endif()
# EXPECT_... and ASSERT_... are if-else statements; GCC warns where one is the only statement of an `if`.
set(LIMEN_TEST_OPTIONS -Wno-dangling-else -O0)
function(limen_test name)
    cmake_parse_arguments(ARG "TOGETHER;BUSY;LONG;WHOLE" "" "LABELS;SOURCES;LINK" ${ARGN})
    add_executable(${name} ${ARG_SOURCES})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_link_libraries(${name} PRIVATE limen_flags ${ARG_LINK} GTest::gtest GTest::gmock GTest::gtest_main)
    if(NOT LIMEN_SANITIZE)
        target_link_libraries(${name} PRIVATE limen_test_crashes limen_room::core)
    endif()
    limen_unite(${name})
    if(ARG_WHOLE)
        add_dependencies(whole_world_tests ${name})
    elseif(NOT ARG_LABELS)
        add_dependencies(unlabelled_tests ${name})
    endif()
    if(ARG_BUSY)
        target_compile_options(${name} PRIVATE -Wno-dangling-else)
    else()
        target_compile_options(${name} PRIVATE ${LIMEN_TEST_OPTIONS})
        limen_share_headers(${name} test)
    endif()
    set(cost 0)
    if(ARG_LONG)
        set(cost 100)
    endif()
    if(ARG_TOGETHER)
        add_test(NAME ${name} COMMAND ${name})
        set_tests_properties(${name} PROPERTIES COST ${cost})
        return()
    endif()
    set(suites ${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake)
    add_custom_command(TARGET ${name} POST_BUILD
        COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${name}> "-DLABELS=${ARG_LABELS}" -D COST=${cost} -D OUTPUT=${suites}
            -P ${PROJECT_SOURCE_DIR}/cmake/ListSuites.cmake
        BYPRODUCTS ${suites}
        VERBATIM)
    set(entry ${CMAKE_CURRENT_BINARY_DIR}/${name}_tests.cmake)
    file(WRITE ${entry} "if(EXISTS [[${suites}]])\n    include([[${suites}]])\nelse()\n    add_test(${name}_NOT_BUILT ${name}_NOT_BUILT)\nendif()\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${entry})
endfunction()
