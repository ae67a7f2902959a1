# glassbox_together(TARGET): compiles several of its files at a time as one, which halves what there is to compile (each
# file's share of CLI11, nlohmann-json and Boost costs more than itself). Names in unnamed namespaces are then in the
# same file, and must differ.
function(glassbox_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 10)
endfunction()
