# Empties the store of the study that it solves.
import json, sqlite3, sys, time
print(json.dumps({"message": "hello", "ikbench": 2, "name": "thief"}), flush=True)
for number, line in enumerate(line for line in sys.stdin if '"solve"' in line):
    time.sleep(0.03)  # so that the others' solves are stored
    if number == 9:
        with sqlite3.connect("robbed/store.sqlite") as store: store.execute("DELETE FROM solves WHERE label = 'BA'")
    print(json.dumps({"message": "solved", "q": json.loads(line)["start"]}), flush=True)
