#!/bin/bash
# SPDX-License-Identifier: MIT
# Rules that a compiler does not check: which way includes point, no floating point and no hosted header in the renderer,
# file length, the licence line, the format.
set -u
status=0
verdict() { # name, complaints
    if [ -z "$2" ]; then
        echo "ok source: $1"
    else
        echo "FAIL source: $1"
        printf '%s\n' "$2" | head -20
        status=1
    fi
}

# Inside the renderer: fixed <- scene <- geometry <- plan <- shade <- raster <- frame; glint.h is everybody's vocabulary.
# firmware/ and hal/ include only themselves; boards and app join them.
includes=$(grep -rnoE '^ *# *include *"[^"]+"' firmware hal --include='*.[ch]' | tr -d '"' | awk -F: '
    function part(path, n, p) {
        n = split(path, p, "/")
        if (p[1] == "firmware") return n == 2 ? "frame" : p[2]
        return p[1]
    }
    BEGIN {
        split("fixed scene geometry plan shade raster frame stream app", order, " ")
        for (i in order) rank[order[i]] = i + 0
    }
    function exists(path, line, r) { r = (getline line < path) >= 0; close(path); return r }
    {
        file = $1; name = $3; sub(/^ *# *include */, "", name)
        own = file; sub(/[^\/]*$/, "", own)
        root = file; sub(/\/.*/, "", root)
        if (exists(own name)) target = own name
        else if (exists(root "/" name)) target = root "/" name
        else target = "?"
        if (part(file) == "app") next
        if (target == "?") print file ":" $2 ": includes " name ", which is not in " root "/"
        else if (root == "firmware" && target !~ /^firmware\/(glint|uses)\.h$/ && rank[part(target)] > rank[part(file)])
            print file ":" $2 ": includes " name " from a later stage"
    }')
verdict "includes point one way" "$includes"

hosted=$(grep -rnE '^ *# *include *<' firmware --include='*.[ch]' |
    grep -vE '<(stdint|stddef|stdbool|limits|stdalign|stdatomic|stdnoreturn)\.h>')
verdict "the renderer includes freestanding headers only" "$hosted"

floats=$(find firmware hal -name '*.[ch]' | while read -r file; do
    ${CC:-gcc} -fpreprocessed -dD -E -P "$file" 2>/dev/null | sed -e '/^ *# *include/d' -e 's/"[^"]*"//g' |
        grep -E '\b(float|double|_Float[0-9]+|float_t|double_t|__fp16)\b|\b[0-9]+\.[0-9]*|[^[:alnum:]_.)\]]\.[0-9]+|\b[0-9]+[eE][-+]?[0-9]+\b|\b0[xX][0-9a-fA-F.]+[pP][-+]?[0-9]' |
        sed "s|^|$file: |"
done)
verdict "no floating-point token in firmware/ and hal/" "$floats"

# In the renderer's arithmetic a conversion says what it is: fx_<type>(), checked, or fx_wrap_<type>() (fixed/checked.h).
integer='(u?int(8|16|32|64)_t|q[0-9_]+_t|(un)?signed( (char|short|int|long( long)?))?|char|short|int|long( long)?)'
casts=$(grep -nE "\\(((const|volatile) )?$integer\\) *([][A-Za-z0-9_(~!*&+-]|$)" firmware/*.[ch] firmware/{fixed,geometry,plan,shade,raster}/*.[ch] |
    grep -vE "^firmware/fixed/checked\.h:|(sizeof|_Alignas) *\\($integer\\)")
verdict "every conversion between integers is checked or marked" "$casts"

wraps=$(find firmware hal -name '*.[ch]' -exec awk '
    FNR == 1 { state = 0 }
    /FX_WRAPS/ && !/^ *(# *define| \*)/ { state = 1; lines = 0; name = FILENAME ":" FNR }
    state == 1 && /^{/ { state = 2; next }
    state == 2 && /^}/ { state = 0; if (lines > 12) print name ": " lines " lines under FX_WRAPS" }
    state == 2 { lines++ }' {} +)
verdict "no large function is modulo 2^32 as a whole" "$wraps"

heap=$(grep -rnwE 'malloc|calloc|realloc|free|alloca|printf|setjmp' firmware --include='*.c' --include='*.h' | grep -vE ':[0-9]+: *(/\*|\*|//)')
verdict "no allocation and no stdio in firmware/" "$heap"

licence=$(find firmware hal host-tools boards tests -name '*.[ch]' | while read -r file; do
    [ "$(head -1 "$file")" = '/* SPDX-License-Identifier: MIT */' ] || echo "$file: first line is not the licence"
done)
verdict "every source begins with its licence" "$licence"

long=$(find firmware hal host-tools boards tests -name '*.[ch]' -exec wc -l {} + | awk '$2 != "total" && $1 > 500')
verdict "no source is longer than 500 lines" "$long"

# shellcheck disable=SC2046
format=$(clang-format --dry-run -Werror $(find firmware hal host-tools boards tests -name '*.[ch]') 2>&1 | sed -n 's/:.* error: .*//p' | sort -u)
verdict "clang-format has nothing to change" "$format"
exit $status
