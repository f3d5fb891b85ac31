# Target maclint_tree_sitter: the system's library, or the one in MACLINT_TREE_SITTER compiled here (1.5 times faster).
add_library(maclint_tree_sitter INTERFACE)

if(MACLINT_TREE_SITTER)
  # The C library stands in lib/ of the repository, in tree_sitter/core/lib/ of the PyPI archive and at the top of the crate.
  find_path(MACLINT_TREE_SITTER_ROOT src/lib.c NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH NO_CACHE
    PATHS "${MACLINT_TREE_SITTER}/lib" "${MACLINT_TREE_SITTER}/tree_sitter/core/lib" "${MACLINT_TREE_SITTER}")
  if(NOT MACLINT_TREE_SITTER_ROOT)
    message(FATAL_ERROR "MACLINT_TREE_SITTER names '${MACLINT_TREE_SITTER}', where no tree-sitter source (lib/src/lib.c) is.")
  endif()
  add_library(maclint_tree_sitter_runtime STATIC "${MACLINT_TREE_SITTER_ROOT}/src/lib.c")
  target_include_directories(maclint_tree_sitter_runtime
    PRIVATE "${MACLINT_TREE_SITTER_ROOT}/src" "${MACLINT_TREE_SITTER_ROOT}/src/wasm"
    PUBLIC "${MACLINT_TREE_SITTER_ROOT}/include")
  target_compile_definitions(maclint_tree_sitter_runtime PRIVATE _POSIX_C_SOURCE=200112L _DEFAULT_SOURCE)
  target_compile_options(maclint_tree_sitter_runtime PRIVATE -w)
  target_link_libraries(maclint_tree_sitter INTERFACE maclint_tree_sitter_runtime)
else()
  # No version is asked for: Debian 12 packs 0.20.7, which calls itself 0.6.3 in its .pc file.
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(TREE_SITTER REQUIRED IMPORTED_TARGET tree-sitter)
  target_link_libraries(maclint_tree_sitter INTERFACE PkgConfig::TREE_SITTER)
endif()
