# Target `docs`: HTML pages of the public headers and of docs/, in BUILD/docs/html. It exists only where Doxygen is
# installed, and it is not part of `all`. Every warning is an error: a wrong parameter name, a broken reference, a link to
# a heading that is not there (tests/architecture looks for missing files). A declaration without a comment is no warning.
if(NOT PROJECT_IS_TOP_LEVEL)
    return() # a project that uses the library may have a target of this name
endif()
find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
    message(STATUS "Doxygen is not installed: there is no target `docs`")
    return()
endif()

# Public headers: those of the rooms, and the record types. The program's own rooms have no users outside of it.
file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*/*.h ${PROJECT_SOURCE_DIR}/src/dat/records/*.h
     ${PROJECT_SOURCE_DIR}/src/visibility/c/*.h)
list(FILTER headers EXCLUDE REGEX "/src/(cli|viewer)/")
file(GLOB_RECURSE pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.md)
file(GLOB root_pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/*.md)

set(DOXYGEN_PROJECT_BRIEF "Worlds of interiors and landscape, joined by portals")
set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/docs)
set(DOXYGEN_USE_MDFILE_AS_MAINPAGE ${PROJECT_SOURCE_DIR}/README.md)
# The interpreter by its own path: where `python3` is a script that chooses a version, it takes longer than the filter.
execute_process(COMMAND python3 -c "import sys; print(sys.executable, end='')" OUTPUT_VARIABLE python RESULT_VARIABLE failed)
if(failed)
    message(STATUS "Python is not installed: there is no target `docs`")
    return()
endif()
set(DOXYGEN_FILTER_PATTERNS "*.md=${python} -ISB ${PROJECT_SOURCE_DIR}/cmake/page-filter" "*.h=${PROJECT_SOURCE_DIR}/cmake/header-filter.sed")
set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR})
set(DOXYGEN_STRIP_FROM_INC_PATH ${PROJECT_SOURCE_DIR}/src)
set(DOXYGEN_IMAGE_PATH ${PROJECT_SOURCE_DIR}/docs) # not the root: Doxygen walks through all folders below, build folders too
set(DOXYGEN_INCLUDE_PATH ${PROJECT_SOURCE_DIR}/src)
set(DOXYGEN_SEARCH_INCLUDES NO) # a header's comments need no other header
set(DOXYGEN_MACRO_EXPANSION YES) # of the marks of exported declarations only
set(DOXYGEN_EXPAND_ONLY_PREDEF YES)
set(DOXYGEN_PREDEFINED LIMEN_API= LIMEN_C_API= LIMEN_API_BEGIN= LIMEN_API_END=)
set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
set(DOXYGEN_EXTRACT_ALL NO)
set(DOXYGEN_HIDE_UNDOC_MEMBERS NO)
set(DOXYGEN_WARNINGS YES)
set(DOXYGEN_WARN_IF_UNDOCUMENTED NO)
set(DOXYGEN_WARN_IF_DOC_ERROR YES)
set(DOXYGEN_WARN_IF_INCOMPLETE_DOC NO) # a parameter whose name and type say all needs no \param
set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
set(DOXYGEN_QUIET YES)
set(DOXYGEN_GENERATE_LATEX NO)
set(DOXYGEN_HAVE_DOT NO)
doxygen_add_docs(docs ${headers} ${pages} ${root_pages} ${PROJECT_SOURCE_DIR}/docs/namespaces.dox
     COMMENT "Doxygen: pages of the public headers")
