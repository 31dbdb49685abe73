"""Runs the code cells of a notebook, as Jupyter does, and shows what each ends with: cells.py NOTEBOOK. Without pandas, cells
with the tag `pandas` have to say what is missing."""
import ast
import importlib.util
import json
import sys

has_pandas, names, last = importlib.util.find_spec("pandas") is not None, {}, None
for cell in json.load(open(sys.argv[1], encoding="utf-8"))["cells"]:
    if cell["cell_type"] != "code":
        continue
    tree = ast.parse("".join(cell["source"]))
    end = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    try:
        exec(compile(tree, sys.argv[1], "exec"), names)
        last = eval(compile(ast.Expression(end.value), sys.argv[1], "eval"), names) if end else None
    except ImportError as error:
        assert not has_pandas and "pandas" in cell["metadata"].get("tags", ()) and "pip install pandas" in str(error), error
        continue
    if last is not None:
        print(last._repr_html_())
result = names["result"]
assert "<td>mine</td>" in result._repr_html_() and result.headline in str(result).replace("\n  ", " ")
