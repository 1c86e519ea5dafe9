echo milk > list.txt
echo bread > list.txt
echo apples >> list.txt
cat list.txt
