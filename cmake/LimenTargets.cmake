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

# limen_unite(target): compiles the sources of each folder a few at a time as one file, which takes less than half as long;
# so names in their unnamed namespaces are unique within a folder. The presets `dev`, `clang`, `coverage` and `tidy` compile each by itself:
# it is to include what it uses.
option(LIMEN_UNITE "Compile several sources as one" OFF)
set(LIMEN_UNITED_SOURCES 8 CACHE STRING "How many at most")
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

# limen_room(name sources...): one library per folder of src, alias limen::name. The room's public
# headers are included as "name/Header.h".
function(limen_room name)
    add_library(limen_${name} STATIC ${ARGN})
    add_library(limen::${name} ALIAS limen_${name})
    target_include_directories(limen_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(limen_${name} PRIVATE limen_flags)
    limen_unite(limen_${name})
endfunction()

# limen_test(name [TOGETHER] [BUSY] [LONG] LABELS l... SOURCES s... LINK t...): one gtest program. Every suite in it becomes a CTest test, which its tests share
# a process in: many ask for the same world, and making it takes longer than they do. TOGETHER: so do all suites. Programs without labels are built by the target
# `unlabelled_tests`: all that sanitizers run. With them it is our code that is optimised and not the tests', which compiles in half the time, but for
# tests that are BUSY themselves. What is LONG begins first.
add_custom_target(unlabelled_tests)
function(limen_test name)
    cmake_parse_arguments(ARG "TOGETHER;BUSY;LONG" "" "LABELS;SOURCES;LINK" ${ARGN})
    add_executable(${name} ${ARG_SOURCES})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_link_libraries(${name} PRIVATE limen_flags ${ARG_LINK} GTest::gtest GTest::gmock GTest::gtest_main)
    limen_unite(${name})
    if(NOT ARG_LABELS)
        add_dependencies(unlabelled_tests ${name})
    endif()
    if(LIMEN_SANITIZE AND NOT ARG_BUSY)
        target_compile_options(${name} PRIVATE -O0)
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
