# What `cmake --install` puts where, and what CPack makes of it.
include(GNUInstallDirs)
set(doc "${CMAKE_INSTALL_DATAROOTDIR}/doc/maclint")
set(CMAKE_INSTALL_MESSAGE NEVER) # a line a page would hide what matters

if(SKBUILD) # a build for pip: where Python's scripts go
  set(CMAKE_INSTALL_BINDIR "${SKBUILD_SCRIPTS_DIR}")
endif()
install(TARGETS maclint DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT executable)

# maclint writes its manual page and completions itself; what is built for another machine needs an emulator for that.
if(NOT WIN32 AND (NOT CMAKE_CROSSCOMPILING OR CMAKE_CROSSCOMPILING_EMULATOR))
  set(written "${CMAKE_BINARY_DIR}/shell")
  file(MAKE_DIRECTORY "${written}")
  foreach(pair IN ITEMS "man=maclint.1" "completions bash=maclint" "completions zsh=_maclint" "completions fish=maclint.fish")
    string(REPLACE "=" ";" pair "${pair}")
    list(GET pair 0 arguments)
    list(GET pair 1 name)
    install(CODE "execute_process(COMMAND ${CMAKE_CROSSCOMPILING_EMULATOR} \"$<TARGET_FILE:maclint>\" ${arguments}
      OUTPUT_FILE \"${written}/${name}\" COMMAND_ERROR_IS_FATAL ANY)")
  endforeach()
  install(FILES "${written}/maclint.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
  install(FILES "${written}/maclint" DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/bash-completion/completions")
  install(FILES "${written}/_maclint" DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/zsh/site-functions")
  install(FILES "${written}/maclint.fish" DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/fish/vendor_completions.d")
endif()

# The pages stand as here, so that their links hold. Links to what only a copy of the repository has become plain text.
install(FILES LICENSE action.yml DESTINATION "${doc}")
install(DIRECTORY docs editors DESTINATION "${doc}")
foreach(page IN ITEMS README.md CHANGELOG.md SECURITY.md)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${page}")
  file(READ "${page}" text)
  string(REGEX REPLACE "\\[([^]]+)\\]\\((CONTRIBUTING\\.md|tests/[^)]*)\\)" "\\1" text "${text}")
  file(WRITE "${CMAKE_BINARY_DIR}/pages/${page}" "${text}")
  install(FILES "${CMAKE_BINARY_DIR}/pages/${page}" DESTINATION "${doc}")
endforeach()
install(FILES docs/maclint.schema.json DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/maclint")
foreach(grammar IN ITEMS fanuc dinplus sinumerik)
  install(DIRECTORY "grammar/${grammar}" DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/maclint/grammars"
    PATTERN test EXCLUDE PATTERN ".git*" EXCLUDE)
endforeach()

# maclint_licence(name places...): the licence of what is linked in, from the first place that has it.
function(maclint_licence name)
  foreach(place IN LISTS ARGN)
    if(EXISTS "${place}")
      install(FILES "${place}" DESTINATION "${doc}/licences" RENAME "${name}.txt")
      return()
    endif()
  endforeach()
  message(STATUS "The licence of ${name} is in none of: ${ARGN}")
endfunction()

set(system_docs "/usr/share/doc")
# Fetched sources have their licences beside them, the system's packages have theirs there.
maclint_licence(nlohmann-json "${MACLINT_HEADERS}/../licences/nlohmann-json.txt" "${system_docs}/nlohmann-json3-dev/copyright")
maclint_licence(cli11 "${MACLINT_HEADERS}/../licences/cli11.txt" "${system_docs}/libcli11-dev/copyright")
maclint_licence(tree-sitter "${MACLINT_TREE_SITTER}/LICENSE" "${MACLINT_TREE_SITTER}/../licences/tree-sitter.txt"
  "${system_docs}/libtree-sitter-dev/copyright")
if(MACLINT_JEMALLOC_LIBRARY)
  maclint_licence(jemalloc "${system_docs}/libjemalloc-dev/copyright")
endif()
if(WIN32)
  maclint_licence(libstdc++ "${system_docs}/gcc-mingw-w64-x86-64-posix-runtime/copyright" "${system_docs}/gcc-mingw-w64-base/copyright")
  maclint_licence(mingw-w64 "${system_docs}/mingw-w64-x86-64-dev/copyright")
elseif(CMAKE_EXE_LINKER_FLAGS MATCHES "-static( |$)" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  string(REGEX MATCH "^[0-9]+" gcc "${CMAKE_CXX_COMPILER_VERSION}")
  set(cross "")
  if(CMAKE_SYSTEM_PROCESSOR STREQUAL "aarch64" AND CMAKE_CROSSCOMPILING)
    set(cross "-arm64-cross")
  endif()
  maclint_licence(libstdc++ "${system_docs}/libstdc++-${gcc}-dev${cross}/copyright")
  maclint_licence(glibc "${system_docs}/libc6-dev${cross}/copyright")
endif()

set(CPACK_PACKAGE_VENDOR "The maclint authors")
set(CPACK_PACKAGE_CONTACT "The maclint authors <maintainers@maclint.invalid>" CACHE STRING "Maintainer that the Debian package names")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "finds mistakes in NC programs before the control does")
set(CPACK_SYSTEM_NAME "linux-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "maclint reads programs in Fanuc Custom Macro B and its relatives, and in
HEIDENHAIN DIN PLUS, and reports what the control would only find with
the spindle turning: alarms, endless loops, vacant variables, modal state
left behind, comparisons that rounding breaks.")
if(NOT CMAKE_EXE_LINKER_FLAGS MATCHES "-static( |$)")
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
endif()
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_SOURCE_DIR}/packaging/debian.cmake")
include(CPack)
