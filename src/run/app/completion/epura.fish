# SPDX-License-Identifier: Apache-2.0
# Completion of epura in fish. The program itself is asked for words, and so for plugins.

function __epura_words
    set -l before (commandline -opc)
    set -l word (commandline -ct)
    set -l answer ($before[1] completion words -- $before[2..-1] "$word" 2>/dev/null)
    set -l option (string match -r -- '^--[^=]*=' "$word")
    set -l name (string replace -r -- '^--[^=]*=' '' "$word")
    switch "$answer[1]"
        case :files
            printf '%s\n' "$option"(__fish_complete_path "$name")
        case :folders
            printf '%s\n' "$option"(__fish_complete_directories "$name")
        case '*'
            printf '%s\n' $answer
    end
end

complete -c epura -f -a '(__epura_words)'
