# What the package may use: PN_SUBDIVISION_3_WITH_... is OFF, ON (an error where it is missing) or AUTO
# (taken where it is found).

# pn_choice(name default meaning): the option of this name.
function(pn_choice name default meaning)
  set(option PN_SUBDIVISION_3_WITH_${name})
  set(${option} ${default} CACHE STRING "${meaning}: OFF, ON, or AUTO (where it is found)")
  set_property(CACHE ${option} PROPERTY STRINGS OFF ON AUTO)
  string(TOUPPER "${${option}}" value)
  if(value MATCHES "^(1|Y|YES|TRUE)$")
    set(value ON)
  elseif(value MATCHES "^(0|N|NO|FALSE)?$")
    set(value OFF)
  elseif(NOT value MATCHES "^(OFF|ON|AUTO)$")
    message(FATAL_ERROR "${option} is '${${option}}', but must be OFF, ON or AUTO.")
  endif()
  set(${option} ${value} PARENT_SCOPE)
endfunction()

# pn_missing(name sentence): says that something is left out, or ends if it was asked for.
function(pn_missing name sentence)
  if(PN_SUBDIVISION_3_WITH_${name} STREQUAL "AUTO")
    message(STATUS "PN_subdivision_3: ${sentence}")
  else()
    message(FATAL_ERROR "PN_subdivision_3: ${sentence}; PN_SUBDIVISION_3_WITH_${name} is ON:"
                        " AUTO or OFF does without it.")
  endif()
endfunction()
