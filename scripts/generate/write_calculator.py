"""Write the model of the calculator, book/_static/calculator/model.js: `make calculator`."""

from pathlib import Path

from discostorm_planner.calculator import model_js

MODEL_JS = Path(__file__).parents[2] / "book" / "_static" / "calculator" / "model.js"

if __name__ == "__main__":
    MODEL_JS.write_text(model_js(), encoding="utf-8")
