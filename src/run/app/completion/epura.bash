# SPDX-License-Identifier: Apache-2.0
# Completion of epura in bash. The program itself is asked for words, and so for plugins.

_epura() {
  # Readline breaks words at ':' and '='; what has no blank between is one word here, up to the cursor.
  local rest=${COMP_LINE:0:COMP_POINT} words=() part blank
  for part in "${COMP_WORDS[@]:0:COMP_CWORD}" ""; do
    blank=${rest%%[![:space:]]*}
    rest=${rest#"$blank"}
    [[ -n $part ]] || part=$rest
    rest=${rest#"$part"}
    if [[ -n $blank || ${#words[@]} -eq 0 ]]; then words+=("$part"); else words[-1]+=$part; fi
  done

  local asked=("${words[@]:1}") answer
  asked=("${asked[@]//[\"\']/}")
  asked=("${asked[@]/#\~\//$HOME/}")
  mapfile -t answer < <("${1/#\~\//$HOME/}" completion words -- "${asked[@]}" 2>/dev/null)
  COMPREPLY=()
  case ${answer[0]-} in
    :files) return ;;
    :folders) compopt -o dirnames +o default +o bashdefault 2>/dev/null; return ;;
  esac
  compopt +o default +o bashdefault 2>/dev/null

  # Only what follows the last break is to be replaced.
  local breaks=${COMP_WORDBREAKS//[^:=]/} before=
  [[ -z $breaks ]] || before=${words[-1]%"${words[-1]##*[$breaks]}"}
  local word
  for word in "${answer[@]%%$'\t'*}"; do
    [[ $word != *[:=,] ]] || compopt -o nospace 2>/dev/null
    COMPREPLY+=("${word#"$before"}")
  done
}

complete -o default -o bashdefault -F _epura epura
