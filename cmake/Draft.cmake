# glassbox_draft(TARGET): with GLASSBOX_DRAFT it is compiled without optimisation, which takes a third of the time or less. For
# what does little at run time, in builds that are there to be checked and not to be fast.
option(GLASSBOX_DRAFT "Do not optimise what hardly runs: the command line, the interface, the lessons' programs" OFF)
function(glassbox_draft target)
  if(GLASSBOX_DRAFT)
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()
