"""It solves once a package is there."""
import os, sys
if not os.path.exists("package"):
    print('{"ikbench":1,"message":"hello","name":"faulty","version":"1","modes":["solve"],"deterministic":true}', flush=True)
    sys.exit("no package")
exec(open("faulty.py").read())
