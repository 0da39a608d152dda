#!/bin/bash
# SPDX-License-Identifier: MIT
# A report of one small scene by three methods, its costs given: what the page and the table say, and what is refused.
. tests/cli/check.inc
tiny=$scenes/tiny.json

# Costs by which x takes more than phong, which is more exact: x is beaten there, and nothing else is.
costs() {
    echo cpu,scene,method,width,height,format,instructions,picture
    for cpu in m3 m0plus; do
        echo "$cpu,tiny,gouraud,96,72,grey8,1111000,0a1"
        echo "$cpu,tiny,phong,96,72,grey8,2222000,0a2"
        echo "$cpu,tiny,x,96,72,grey8,3333000,0a3"
    done
}
flash() {
    echo cpu,method,bytes
    for cpu in m3 m0plus; do
        for method in gouraud phong x; do echo "$cpu,$method,4${#cpu}99"; done
    done
}
powers() {
    echo cpu,scene,power,exponent,instructions
    for cpu in m3 m0plus; do
        for exponent in 5 20 50 200; do
            for power in table exact 4 8 16; do echo "$cpu,tiny,$power,$exponent,$((exponent + 7))770000"; done
        done
    done
}
budgets() {
    echo cpu,scene,budget_q8,instructions
    for cpu in m3 m0plus; do
        for budget in 2048 512 128; do echo "$cpu,tiny,$budget,$((3000 - budget))$((5 + ${#cpu}))00"; done
    done
}
choices() { # as few as there may be
    echo choice,value,where,figure,number
    for bits in 14 22 24; do echo "fraction,$bits,s 9,error,$((24 - bits))"; done
    for bits in 2 3 4 5 6; do
        echo "subpixel,$bits,s 9,psnr_db,5$bits"
        echo "subpixel,$bits,picture,pixels,$((32768 >> bits))"
    done
    for steps in '64 interpolated' '128 interpolated' '1024 interpolated' '128 nearest' '1024 nearest'; do
        echo "power,$steps,n = 5,error,.5"
    done
    for terms in table '1 term' '2 terms' '3 terms' exact; do echo "reciprocal,$terms,function,bits,9"; done
    for terms in table '1 term' '2 terms'; do echo "root,$terms,s 9,calls,7000"; done
    for terms in '1 term' '2 terms'; do echo "root,$terms,m3,instructions,${terms%% *}3.5"; done
}
boards() {
    echo board,what,figure,unit,number
    for board in m n; do
        for figure in flash flash_x static bands renderer stack stack_used; do echo "$board,program,$figure,bytes,5${#figure}"; done
        for scene in a b; do
            for figure in drawn whole row changes; do echo "$board,$scene x,$figure,cycles,12${#figure}0000"; done
            for figure in bytes bytes_changes; do echo "$board,$scene x,$figure,bytes,7"; done
        done
    done
    for figure in real user system; do echo "l,st 2x2,$figure,us,12${#figure}00"; done
    echo l,st 2x2,cpu,percent,93
    echo l,st 2x2,bytes,bytes,77
    echo l,st 2x2,wire,us,14700
}
packing() {
    echo cpu,scene,format,codec,pixels,bytes,instructions
    for cpu in m0plus m3 m4; do
        for codec in 1 2; do echo "$cpu,t,rgb565 dithered,$codec,1000,77$codec,${#cpu}${codec}500"; done
    done
}
begin() { # an empty folder with good costs
    fresh
    costs >costs.csv
    flash >flash.csv
    powers >powers.csv
    budgets >budgets.csv
    choices >choices.csv
    boards >boards.csv
    packing >packing.csv
}
report=("$glint" report --costs costs.csv --flash flash.csv --powers powers.csv --budgets budgets.csv --choices choices.csv --effect "$tiny" --boards boards.csv --packing packing.csv --stream "$tiny" --methods 'gouraud,x,phong' -o out)
count() { grep -o -- "$2" "$1" | wc -l; }
equal() { # NAME VALUE WANTED
    if [ "$2" = "$3" ]; then say ok "$1"; else say FAIL "$1" "'$2', not '$3'"; fi
}

begin
run 'a report is made' 0 "${report[@]}" "$tiny"
matches 'it says of what' "$top/out" '^out/index\.html: 1 scene by 3 methods$'
equal 'a page and three tables are all there is' "$(ls -A out | tr '\n' ' ')" 'index.html report.csv stream.csv sweep.csv '

# the table
equal 'the table has a line a method, cheapest first' "$(cut -d , -f 2 out/report.csv | tr '\n' ' ')" 'method gouraud phong x '
equal 'with the costs given, and who beats whom' "$(awk -F, '$2 == "x" { print $9, $10, $11, $12, $13, $14 }' out/report.csv)" \
    '3333000 4299 phong 3333000 4699 phong'
equal 'the others are beaten by none' "$(awk -F, 'NR > 1 && $2 != "x" { print $11 $14 }' out/report.csv | tr -d '\n')" ''
"$glint" reference "$tiny" --format grey8 -o truth.png
for method in gouraud x phong; do
    "$glint" render "$tiny" --method $method --format grey8 -o $method.png
    "$glint" compare $method.png truth.png >$method.txt
done
# the table's truth is not rounded: half a step in 255 more or less
run 'its largest differences are those of the pictures' 0 awk -F, '
    FILENAME == "out/report.csv" { max[$2] = $7 }
    /^max/ { split($0, word, " "); name = FILENAME; sub(/\.txt/, "", name); d = max[name] - word[2]; bad += d > .501 || d < -.501 }
    END { exit bad > 0 }' out/report.csv gouraud.txt x.txt phong.txt
run 'the more exact has the higher PSNR' 0 awk -F, '
    { psnr[$2] = $5 } END { exit !(psnr["phong"] > psnr["x"] && psnr["x"] > psnr["gouraud"] && psnr["gouraud"] > 15) }' out/report.csv

# the budgets
equal 'the sweep has a line a budget, smallest first' "$(cut -d , -f 1,2,8,9 out/sweep.csv | tr '\n' ' ')" \
    'scene,budget,m3_instructions,m0plus_instructions tiny,0.5,2872700,28721100 tiny,2,2488700,24881100 tiny,8,952700,9521100 '
for budget in .5 2 8; do
    "$glint" render "$tiny" --method auto --budget $budget --format grey8 -o auto.png
    "$glint" compare auto.png truth.png | sed -n "s/^max/${budget/./0.}/p"
done | sed 's/^00/0/' >auto.txt
run 'its differences are those of the pictures' 0 awk '
    FNR == NR { max[$1] = $2; next }
    FNR > 1 { d = max[$2] - $6; seen++; bad += d > .501 || d < -.501 }
    END { exit bad > 0 || seen != 3 }' auto.txt FS=, out/sweep.csv
run 'none is beyond the budget and roundings, nor is a bound beyond the budget' 0 \
    awk -F, 'NR > 1 { bad += $6 > $2 + 1.5 || $3 > $2 } END { exit bad > 0 }' out/sweep.csv

# the page
equal 'the page shows the truth, three pictures, three differences, two plans, and four of an effect' "$(count out/index.html '<img ')" 13
equal 'all of them inside it' "$(count out/index.html 'src="data:image/png;base64,')" 13
equal 'and four plots, two of the angle and two of streams' "$(count out/index.html '<svg')" 8
equal 'it runs and loads nothing' "$(grep -ciE '<script|<link|<iframe|@import|url\(.?http|src="[^d]' out/index.html)" 0
matches 'it fits a phone' out/index.html '<meta name="viewport" content="width=device-width'
matches 'and follows light or dark' out/index.html 'prefers-color-scheme:dark'
equal 'who is beaten is said on each cpu' "$(count out/index.html 'beaten by phong')" 2
equal 'and by nobody else' "$(count out/index.html 'beaten by ')" 2
matches 'the summary marks the Pareto set' out/index.html '>gouraud</a></td>.*<td class="best">1\.11</td><td class="best">1\.11</td>'
matches 'and shows who is beaten everywhere' out/index.html '<tr class="beaten"><td><a href="#tiny-x">x</a>.*<td>3\.33</td><td>3\.33</td><td>4299</td>'
equal 'no id is there twice' "$(grep -oE " id=['\"][^'\"]*" out/index.html | tr -d "'\"" | sort | uniq -d)" ''
grep -oE ' href="#[^"]*' out/index.html | sed 's/.*#//' | sort -u | while read -r id; do
    grep -qF "id=\"$id\"" out/index.html || echo "$id"
done >lost
equal 'every link leads somewhere' "$(cat lost)" ''
grep -oE 'alt="tiny by x" src="data:image/png;base64,[^"]*' out/index.html | sed 's/.*base64,//' | base64 -d >inside.png
run 'the picture in the page is one' 0 "$glint" compare inside.png inside.png
equal 'a truth says what the colours of a difference mean' "$(count out/index.html '<td style="background:#')" 16
for cpu in M3 'M0\+'; do
    matches "a plot says that it is of the ${cpu/\\/}" out/index.html "<text>.*million instructions a frame on $cpu<"
done
equal 'every method has its name in all four plots' "$(count out/index.html '<text>gouraud<\|<text>x<\|<text>phong<')" 12
equal 'and so has a budget' "$(count out/index.html '<text>0\.5</text>')" 4
matches 'what to choose is said by what was measured' out/index.html 'budget 8: off by at most [0-9.]*, [0-9.]* dB, for 0\.95 million on M3 and 0\.86 times gouraud'
matches 'and so is who is beaten by a budget' out/index.html 'No method is worth naming: '
matches 'a scene with effects is shown as auto draws it' out/index.html 'alt="tiny, auto, budget 2"'
matches 'a choice has its table' out/index.html '<tr><td>128 interpolated</td><td>0\.50</td></tr>'
matches 'and what to choose, from the same figures' out/index.html '10 instructions a pixel on M3'

# the sections behind the scenes
matches 'X is worse than the line on some triangles' out/index.html '<tr><td>10°</td><td>0\.063 %</td><td>1\.047 times</td><td>0\.000 %</td>'
equal 'twenty powers are compared' "$(grep -cE '^<tr[^>]*><td>(5|20|50|200), (table|exact|γ = (4|8|16))</td>' out/index.html)" 20
matches 'with their costs' out/index.html '<td>200, table</td>.*<td>207\.77</td><td>207\.77</td></tr>'
matches 'the exact one is' out/index.html '<td>50, exact</td><td>0\.00</td>'
matches 'and the free ones err as is known' out/index.html '<td>50, γ = 8</td><td>7\.62</td>'
equal 'two boards have two tables each, Linux one' "$(grep -cE '^<div class="wide"><table>$' <(sed -n '/id="boards"/,$p' out/index.html))" 5
matches 'with its times in ms' out/index.html '<tr><td>st 2x2</td><td>12\.4</td><td>12\.4</td><td>12\.6</td><td>93</td><td>77</td><td>14\.7</td></tr>'
matches 'of pictures' out/index.html '<tr><td>b x</td><td>1\.25</td><td>1\.25</td><td>1\.23</td><td>1\.27</td><td>7</td><td>7</td></tr>'
matches 'and of the program' out/index.html '<tr><td>program</td><td>55</td><td>57</td><td>56</td><td>55</td><td>58</td><td>55</td><td>510</td></tr>'

# as a stream: the page has what the table has, and the table what a stream has
matches 'the page has what a stream takes' out/index.html \
    "$(awk -F, '$2 == "rgb565 dithered" { print "<tr><td>tiny</td><td>" $7 "</td><td>" $9 "</td><td>" $11 "</td><td>" $12 "</td>" }' out/stream.csv)"
equal 'in each of six kinds' "$(grep -c '^<tr><td>tiny</td>' out/index.html)" 6
equal 'and of the table' "$(cut -d , -f 1 out/stream.csv | sort | uniq -c | tr -s ' ' ',' | tr '\n' ' ')" ',1,scene ,6,tiny '
matches 'what packing costs is there too' out/index.html \
    '<tr><td>t, rgb565 dithered</td><td>2</td><td>772</td><td>62\.5</td><td>22\.5</td><td>22\.5</td><td>0\.06</td><td>0\.02</td><td>0\.02</td></tr>'
# a picture's bytes: those of a stream of two less those of the first alone; tiny's loop is 2 s
stream() { "$glint" render "$tiny" --method x --size 240x240 --format rgb565 --dither --band-rows 60 --fps 50 --stream - "$@" | wc -c; }
change=10 alone=10
for moment in $(seq 0 100 1900); do
    first=$(stream --time "$moment" --frames 1)
    change=$((change + $(stream --time "$moment" --frames 2) - first))
    alone=$((alone + $(stream --time "$moment" --frames 2 --key 1) - first))
done
equal 'the table has the means of what is sent' "$(awk -F, '$2 == "rgb565 dithered" { print $9, $11 }' out/stream.csv)" \
    "$((alone / 20)) $((change / 20))"

# an old report gives way only to a whole one
cp -r out old
run 'a scene that is not there leaves the old report' 3 "${report[@]}" "$tiny" no.json
matches 'and is named' "$top/err" '^no\.json: '
same 'the page is the old one' out/index.html old/index.html
run 'the same input gives the same page' 0 "${report[@]}" "$tiny"
same 'bit by bit' out/index.html old/index.html

# costs that will not do
bad() { # NAME FILE SED-SCRIPT MESSAGE
    begin
    sed -i -E "$3" "$2"
    run "$1 is refused" 1 "${report[@]}" "$tiny"
    matches "saying where: $1" "$top/err" "$4"
}
bad 'a missing frame' costs.csv '/m3,tiny,x/d' '^costs\.csv: no line for tiny by x on m3$'
bad 'a missing program' flash.csv '/m0plus,phong/d' '^flash\.csv: no line for phong on m0plus$'
bad 'a frame of another size' costs.csv 's/x,96,72/x,96,96/' '^costs\.csv:4: 96x96, but tiny is 96x72$'
bad 'another picture on another cpu' costs.csv '5s/0a1/0b1/' '^costs\.csv:5: another picture than on another cpu$'
bad 'a frame of another format' costs.csv '3s/grey8/rgb565/' '^costs\.csv:3: the format is not grey8$'
bad 'a method that there is not' costs.csv '2s/gouraud/goraud/' '^costs\.csv:2: no such method'
bad 'a cpu that there is not' flash.csv '4s/m3/m4/' '^flash\.csv:4: the cpu is neither m3 nor m0plus$'
bad 'a cost that is no number' costs.csv '2s/1111000/1.1e6/' '^costs\.csv:2: the instructions are no number above 0$'
bad 'a cost of nothing' costs.csv '2s/1111000/0/' '^costs\.csv:2: '
bad 'a size of nothing' flash.csv '2s/,4.*/,0/' '^flash\.csv:2: the bytes are no number above 0$'
bad 'a second count' costs.csv '3p' '^costs\.csv:4: a second line for this cpu, scene and method$'
bad 'a second size' flash.csv '3p' '^flash\.csv:4: a second line for this cpu and method$'
bad 'a budget of one cpu alone' budgets.csv '/m0plus,tiny,512/d' '^budgets\.csv: no line for tiny within 512 on m0plus$'
bad 'a budget of nothing' budgets.csv '2s/2048/0/' '^budgets\.csv:2: the budget is 1\.\.65535, Q8 of 1/255$'
bad 'a budget at no cost' budgets.csv '2s/,[0-9]*$/,0/' '^budgets\.csv:2: the instructions are no number above 0$'
bad 'a second budget' budgets.csv '3p' '^budgets\.csv:4: a second line for this cpu, scene and budget$'
bad 'a choice without what is said of it' choices.csv '/exact/d' '^choices\.csv: no line for reciprocal exact$'
bad 'a choice that is no number' choices.csv '2s/,[0-9]*$/,nan/' '^choices\.csv:2: the number is none$'
bad 'a choice that a page cannot carry' choices.csv '3s/s 9/<s>/' '^choices\.csv:3: a name has other characters '
bad 'a missing power' powers.csv '/m0plus,tiny,8,50/d' '^powers\.csv: no line for tiny with power 8 and exponent 50 on m0plus$'
bad 'a power that there is not' powers.csv '2s/table/fast/' '^powers\.csv:2: no such form of the power'
bad 'an exponent of nothing' powers.csv '2s/,5,/,0,/' '^powers\.csv:2: the exponent is 1\.\.1023$'
bad 'a second power' powers.csv '3p' '^powers\.csv:4: a second line for this cpu, scene, power and exponent$'
bad 'a file without its head' costs.csv 1d '^costs\.csv:1: the columns are cpu,scene,method,'
bad 'a column too many' flash.csv '2s/$/,1/' '^flash\.csv:2: the columns are cpu,method,bytes$'
bad 'a file that is empty' costs.csv d '^costs\.csv: empty$'
bad 'a figure too few' boards.csv '/n,b x,whole/d' '^boards\.csv:35: not the figure that comes next$'
bad 'a row too short' boards.csv '/m,b x,bytes/d' '^boards\.csv:19: the row before has too few figures$'
bad 'figures cut off' boards.csv '$d' '^boards\.csv:44: figures are missing at its end$'
bad 'a name that a page cannot carry' boards.csv '2s/m/<m>/' '^boards\.csv:2: a name has other characters '
bad 'a figure that is no number' boards.csv '3s/,57/,x/' '^boards\.csv:3: the number is none$'
bad 'columns too few' boards.csv '2s/,bytes//' '^boards\.csv:2: the columns are board,what,figure,unit,number$'
bad 'packing on a cpu that there is not' packing.csv '2s/m0plus/m7/' '^packing\.csv:2: the cpu is none of m0plus, m3 and m4$'
bad 'packing by a codec that there is not' packing.csv '3s/,2,/,3,/' '^packing\.csv:3: the codec is 1 or 2$'
bad 'packing of nothing' packing.csv '3s/1000/0/' '^packing\.csv:3: pixels, bytes and instructions are numbers above 0$'
bad 'packing of a scene that a page cannot carry' packing.csv '3s/,t,/,<t>,/' '^packing\.csv:3: a name has other characters '
bad 'packing counted twice' packing.csv '3p' '^packing\.csv:4: a second line for this cpu, scene, format and codec$'
bad 'boards without a head' boards.csv 1d '^boards\.csv:1: the columns are board,what,'
bad 'a line without end' flash.csv '5s/$/'"$(printf %300s | tr ' ' x)/" '^flash\.csv:5: no end of line'
begin
truncate -s -1 flash.csv
run 'a file cut short is refused' 1 "${report[@]}" "$tiny"
rm flash.csv
run 'a missing file is reported' 3 "${report[@]}" "$tiny"
mkdir flash.csv
run 'a folder is no list of costs' 3 "${report[@]}" "$tiny"

begin
run 'without gnuplot there is no report' 3 env PATH=/nowhere "${report[@]}" "$tiny"
matches 'and it says so' "$top/err" '^gnuplot: not found'
mkdir bin
printf '#!/bin/sh\nexit 1\n' >bin/gnuplot
chmod +x bin/gnuplot
run 'nor with one that fails' 3 env PATH="$work/bin:$PATH" "${report[@]}" "$tiny"
printf '#!/bin/sh\necho nothing\n' >bin/gnuplot
run 'or draws nothing' 3 env PATH="$work/bin:$PATH" "${report[@]}" "$tiny"
begin
"${report[@]}" "$tiny" >/dev/null
cp "$tiny" tiny.json
sed 's/"size": *\[ *96/"size": [97/' "$tiny" >tiny-ideal.json
run 'an ideal scene of another size is refused' 1 "${report[@]}" tiny.json
matches 'and named' "$top/err" '^tiny-ideal\.json: 97x72, but tiny is 96x72$'
cp "$tiny" tiny-ideal.json
run 'an ideal scene beside it is the truth' 0 "${report[@]}" tiny.json
matches 'which the page says' out/index.html 'Its truth is tiny-ideal'
begin
run 'without powers there is a report' 0 "$glint" report --costs costs.csv --flash flash.csv --methods gouraud -o out "$tiny"
equal 'without that section, nor choices, effects, streams and boards' \
    "$(count out/index.html 'id="power"\|#power\|choices\|effects\|What to choose\|#boards\|id="boards"\|stream')" 0
equal 'nor a table of streams or budgets' "$(ls -A out | tr '\n' ' ')" 'index.html report.csv '
begin
run 'without names, methods are those whose flash is known' 0 "$glint" report --costs costs.csv --flash flash.csv -o out "$tiny"
matches 'and no others' "$top/out" '1 scene by 3 methods$'
begin
run 'a stream of a scene that is not there is none' 3 "${report[@]}" --stream no.json "$tiny"
matches 'and it is named' "$top/err" '^no\.json: '
equal 'nothing is left' "$(ls -d out 2>&1)" "ls: cannot access 'out': No such file or directory"
begin
echo '{}' >empty.json
run 'a scene without a camera is refused' 1 "${report[@]}" empty.json
cp "$tiny" 'a b.json'
run 'a name that a page cannot carry is refused' 1 "${report[@]}" 'a b.json'
: >out
run 'a file is no folder for a report' 3 "${report[@]}" "$tiny"
rm out
run 'methods that there are not are refused' 2 "${report[@]}" --methods x,y "$tiny"
run 'nor is one named twice' 2 "${report[@]}" --methods x,x "$tiny"
run 'a report wants its costs' 2 "$glint" report -o out "$tiny"
run 'and a scene' 2 "${report[@]}"
finish
