"""In a group of its own, it does not answer and ignores SIGTERM."""
import json, os, signal, time
os.setpgid(0, 0)
signal.signal(signal.SIGTERM, signal.SIG_IGN)
print(json.dumps({"message": "hello", "ikbench": 2, "name": "stuck"}), flush=True)
time.sleep(1000)
