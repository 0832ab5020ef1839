"""Frames on the air: the still picture shows the run that the page plays."""

import io

import pandas as pd

import discostorm as ds
from discostorm.data import data_path
from discostorm_book import landing


def test_the_caption_says_what_the_picture_shows() -> None:
    kept = pd.read_csv(data_path("simulated/air.csv", "discostorm_book"))
    assert (landing.HOSTS, landing.TABLE, landing.PICTURE_END_S) == (12, "Fast DDS 3.6", 0.25)
    assert set(kept["station"]) == set(range(landing.HOSTS + 1))
    assert kept["start_s"].max() > 0.98 * landing.PICTURE_END_S
    full = kept[kept["waiting"] >= landing.QUEUE[0]]["start_s"].min()
    assert round(full, 2) == 0.13
    assert (kept["outcome"] == 1).sum() > 0.9 * (kept["outcome"] != 0).sum()


def test_each_product_and_the_papers_tables_can_be_chosen() -> None:
    chosen = landing.protocol_choices()
    products = {p.product for p in ds.PROTOCOLS.values() if p.basis in ("measured", "mitigated")}
    assert {p.product for p in chosen} == products | {None}
    assert {p.name for p in chosen if p.basis == "paper"} == {"DDS", "Zenoh"}
    exported = landing.page_data()
    assert [table["name"] for table in exported["tables"]] == [p.name for p in chosen]
    assert exported["table"] in {p.name for p in chosen}


def test_the_picture_is_the_same_every_time() -> None:
    pictures = []
    for _ in range(2):
        picture = io.BytesIO()
        landing.draw_first_part().savefig(picture, format="png", metadata={"Software": None})
        pictures.append(picture.getvalue())
    assert pictures[0] == pictures[1]
