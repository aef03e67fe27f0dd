#compdef epura
# SPDX-License-Identifier: Apache-2.0
# Completion of epura in zsh. The program itself is asked for words, and so for plugins.

_epura() {
  local line word help
  local -a answer whole begun
  answer=("${(@f)$("${(Q)words[1]}" completion words -- "${(@Q)words[2,CURRENT-1]}" "${(Q)PREFIX}" 2>/dev/null)}")
  case $answer[1] in
    :files) [[ $PREFIX != --*=* ]] || compset -P '*='; _files; return ;;
    :folders) [[ $PREFIX != --*=* ]] || compset -P '*='; _files -/; return ;;
  esac
  for line in $answer; do
    word=${line%%$'\t'*} help=${line#*$'\t'}
    if [[ $word == *[:=,] ]]; then begun+=("${word//:/\\:}:$help"); else whole+=("${word//:/\\:}:$help"); fi
  done
  _describe -t words word whole -- begun -S ''
}

if [[ $funcstack[1] == _epura ]]; then _epura "$@"; else compdef _epura epura; fi
