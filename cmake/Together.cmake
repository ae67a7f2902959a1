# glassbox_together(TARGET): with GLASSBOX_TOGETHER its files are compiled a few at a time as one, which halves what there is
# to compile from nothing (each file's share of CLI11, nlohmann-json and Boost costs more than itself), and makes a change
# cost more. Ours is for CI. Names in unnamed namespaces then meet; a room that lets them is not compiled so.
option(GLASSBOX_TOGETHER "Compile several files at once: quicker from nothing, slower after a change" OFF)
function(glassbox_together target)
  if(GLASSBOX_TOGETHER)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 10)
  endif()
endfunction()
