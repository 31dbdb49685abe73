"""In a group of its own, it does not answer and ignores SIGTERM."""
import json, os, signal, time
os.setpgid(0, 0)
signal.signal(signal.SIGTERM, signal.SIG_IGN)
print(json.dumps({"ikbench": 1, "message": "hello", "name": "stuck", "version": "1", "modes": ["solve"]}), flush=True)
while True:
    told = json.loads(input())
    if told["message"] == "robot": print('{"message":"ready"}', flush=True)
    if told["message"] == "solve": time.sleep(1000)
