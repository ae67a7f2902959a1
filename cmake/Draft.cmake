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
