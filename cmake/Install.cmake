# What `cmake --install` puts where, and `cpack -G DEB` into a package. The program finds what it reads as it runs in
# ../share/glassbox: scenes, lessons, and the sources that learners' programs are compiled with, laid out as here.
set(data ${CMAKE_INSTALL_DATADIR}/glassbox)
install(TARGETS glassbox RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY scenes DESTINATION ${data} PATTERN "*.py" EXCLUDE)
install(DIRECTORY lessons DESTINATION ${data} PATTERN CMakeLists.txt EXCLUDE PATTERN "*.cmake" EXCLUDE)
install(DIRECTORY src DESTINATION ${data} FILES_MATCHING PATTERN "*.hpp")
install(FILES src/render/view.cpp DESTINATION ${data}/src/render)
install(FILES src/learn/picture/renderer.cpp src/learn/picture/stepper.cpp DESTINATION ${data}/src/learn/picture)
install(DIRECTORY src/learn/check/runner DESTINATION ${data}/src/learn/check FILES_MATCHING PATTERN "*.cpp")
install(DIRECTORY tests/stages tests/support DESTINATION ${data}/tests FILES_MATCHING PATTERN "*.hpp" PATTERN "stage*.cpp"
        PATTERN "support/random_bits.cpp" PATTERN "support/seen.cpp" PATTERN "support/ulps.cpp")

install(FILES tests/certified/lost_rays.cpp DESTINATION ${data}/tests/certified)
install(DIRECTORY docs DESTINATION ${data} FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.gif" PATTERN "*.svg")
install(DIRECTORY examples DESTINATION ${data})

# The pages link each other as they do here, from where documentation belongs, too.
set(pages README.md LICENSE CHANGELOG.md CITATION.cff CONTRIBUTING.md THIRD-PARTY.md)
install(FILES ${pages} DESTINATION ${data})
install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_DOCDIR})
file(RELATIVE_PATH to_data /prefix/${CMAKE_INSTALL_DOCDIR} /prefix/${data})
foreach(folder docs examples lessons scenes src tests)
  install(CODE "
    set(link \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DOCDIR}/${folder}\")
    file(REMOVE_RECURSE \"\${link}\")
    file(CREATE_LINK ${to_data}/${folder} \"\${link}\" SYMBOLIC)")
endforeach()
install(FILES packaging/glassbox.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES packaging/glassbox.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME glassbox)
install(FILES packaging/_glassbox DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)

set(CPACK_PACKAGE_CONTACT "The Glassbox authors <glassbox@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Learners' programs are compiled where they are run; Dear ImGui is linked as Debian has it, a static library.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "g++ (>= 4:11), doctest-dev")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "bubblewrap, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, libtbb-dev, libhwy-dev")  # to build on glassbox::engine
set(CPACK_STRIP_FILES ON)
include(CPack)
