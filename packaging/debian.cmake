# What a Debian package has in other places than `cmake --install`: CPack runs this over the staged files of each package.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
set(share "${CPACK_TEMPORARY_DIRECTORY}${CPACK_PACKAGING_INSTALL_PREFIX}/share")
set(doc "${share}/doc/maclint")

file(MAKE_DIRECTORY "${share}/zsh" "${share}/lintian/overrides")
file(RENAME "${share}/zsh/site-functions" "${share}/zsh/vendor-completions")

# One file tells of all licences.
file(READ "${doc}/LICENSE" copyright)
file(GLOB licences "${doc}/licences/*.txt")
foreach(licence IN LISTS licences)
  get_filename_component(name "${licence}" NAME_WE)
  file(READ "${licence}" text)
  string(APPEND copyright "\n\n==== linked in: ${name} ====\n\n${text}")
endforeach()
file(WRITE "${doc}/copyright" "${copyright}")
file(REMOVE "${doc}/LICENSE")
file(READ "${doc}/README.md" readme)
string(REPLACE "[LICENSE](LICENSE)" "[copyright](copyright)" readme "${readme}")
file(WRITE "${doc}/README.md" "${readme}")
file(REMOVE_RECURSE "${doc}/licences")

string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE "${doc}/changelog" "maclint (${CPACK_PACKAGE_VERSION}) stable; urgency=medium

  * CHANGELOG.md says what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${now}
")
execute_process(COMMAND gzip -9n "${doc}/changelog" "${share}/man/man1/maclint.1" COMMAND_ERROR_IS_FATAL ANY)

# On purpose: one package serves every release of Debian and Ubuntu.
file(WRITE "${share}/lintian/overrides/maclint" "# One package is to serve every release of Debian and Ubuntu.\nmaclint: statically-linked-binary\n")
