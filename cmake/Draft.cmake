# glassbox_draft(TARGET): hardly optimises code that hardly runs, which halves its compile time: the command line, the
# interface, the lessons' programs. With GLASSBOX_DRAFT it does not optimise at all, for builds that are meant for
# checking and not for speed.
option(GLASSBOX_DRAFT "Do not optimise what hardly runs" OFF)
function(glassbox_draft target)
  if(GLASSBOX_DRAFT)
    target_compile_options(${target} PRIVATE -O0)
  else()
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# What is linked a hundred times a day is linked by the fastest linker that is there.
if(GLASSBOX_DRAFT)
  include(CheckLinkerFlag)
  foreach(linker lld gold)
    check_linker_flag(CXX -fuse-ld=${linker} GLASSBOX_LINKS_BY_${linker})
    if(GLASSBOX_LINKS_BY_${linker})
      add_link_options(-fuse-ld=${linker})
      break()
    endif()
  endforeach()
endif()
