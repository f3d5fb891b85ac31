# How the libraries and executables of maclint are made.

# Compiles `target` with maclint's warnings and roots its includes at the repository.
function(maclint_own_code target scope)
  target_include_directories(${target} ${scope} "${CMAKE_SOURCE_DIR}")
  # Assertions stay on in what is shipped: they cost a ten-thousandth of the instructions.
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -UNDEBUG)
  if(MACLINT_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 reports them falsely, from inside its own std::string, std::function and std::variant.
    target_compile_options(${target} PRIVATE
      -Wno-restrict -Wno-error=maybe-uninitialized -Wno-error=stringop-overflow -Wno-error=array-bounds)
  endif()
endfunction()

# maclint_library(name SOURCES files... LINKS libraries... [DEFINITIONS macros...] [OWN_CODE] [RELEASE_OPTION option])
# RELEASE_OPTION says how much a release is optimised, where it is not as CMake has it.
function(maclint_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OWN_CODE" "RELEASE_OPTION" "SOURCES;LINKS;DEFINITIONS")
  add_library(${name} STATIC ${arg_SOURCES})
  target_link_libraries(${name} PUBLIC ${arg_LINKS})
  target_compile_definitions(${name} PUBLIC ${arg_DEFINITIONS})
  if(arg_OWN_CODE)
    maclint_own_code(${name} PUBLIC)
  endif()
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:${arg_RELEASE_OPTION}>)
endfunction()

# Compiles so many files of `target` at a time, so that what they include and instantiate is made once: their names must
# not clash, those of anonymous namespaces included.
function(maclint_together target files)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${MACLINT_FAST_BUILD} UNITY_BUILD_BATCH_SIZE ${files})
  if(MACLINT_FAST_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC takes each file but the first for a header, which should hold no anonymous namespace.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# Compiles `target` as tests, in a release with `optimisation`: what is tested is in the libraries, the tests themselves
# are to compile fast.
function(maclint_test_code target optimisation)
  target_link_libraries(${target} PRIVATE maclint_cli GTest::gtest GTest::gmock)
  target_compile_definitions(${target} PRIVATE
    MACLINT_SOURCE_DIR="${CMAKE_SOURCE_DIR}" MACLINT_EXECUTABLE="${CMAKE_BINARY_DIR}/maclint"
    MACLINT_SHARED="${MACLINT_SHARED}")
  maclint_own_code(${target} PRIVATE)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${optimisation}>)
  maclint_together(${target} 4)
endfunction()

# Links jemalloc into the executable `target`: programs are let go group by group, which leaves the C library's
# allocator long lists of free pieces to search (a fifth of the time over a large folder).
function(maclint_allocator target)
  if(NOT MACLINT_JEMALLOC)
    return()
  endif()
  find_library(MACLINT_JEMALLOC_LIBRARY NAMES libjemalloc.a)
  if(MACLINT_JEMALLOC_LIBRARY)
    target_link_libraries(${target} PRIVATE ${MACLINT_JEMALLOC_LIBRARY} Threads::Threads ${CMAKE_DL_LIBS} m)
  endif()
endfunction()

# Compiles the headers once for all files of `target`. A file still includes what it uses: ./dev tidy compiles without.
function(maclint_precompile target)
  if(MACLINT_FAST_BUILD)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
      # Else a compiler cache keeps one for each checkout.
      target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
    endif()
  endif()
endfunction()
