# glassbox_draft(TARGET): what hardly runs is hardly optimised, which takes half of the time to compile: the command line, the
# interface, the lessons' programs. With GLASSBOX_DRAFT not at all, in builds that are there to be checked and not to be fast.
option(GLASSBOX_DRAFT "Do not optimise what hardly runs" OFF)
function(glassbox_draft target)
  if(GLASSBOX_DRAFT)
    target_compile_options(${target} PRIVATE -O0)
  else()
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()
