"""The picture that a link to the book shows has what the package computes."""

import io

import link_picture
import numpy as np
import pytest

import discostorm as ds


@pytest.mark.parametrize(("name", "hosts"), [("DDS", 7), ("Zenoh", 7)])
def test_the_picture_of_a_link_shows_how_many_robots_fit(name: str, hosts: int) -> None:
    protocol = ds.PROTOCOLS[name]
    picture = link_picture.draw_link_picture(protocol, (1200, 630))
    (axis,) = picture.axes
    heights = [bar.get_height() for bar in axis.patches]
    assert heights == pytest.approx(ds.utilization(protocol, np.arange(1, 11), 2, 10), rel=1e-12)
    shown = picture.texts[-1].get_text()
    assert f"{hosts} small robots keep it busy\nfor {heights[hosts - 1]:.2f} s." in shown
    colors = [bar.get_facecolor() for bar in axis.patches]
    assert len(set(colors[:hosts])) == len(set(colors[hosts:])) == 1
    assert colors[0] != colors[-1]


def test_pictures_are_the_same_every_time() -> None:
    pictures = []
    for _ in range(2):
        picture = io.BytesIO()
        figure = link_picture.draw_link_picture(ds.DDS, (1200, 630))
        figure.savefig(picture, metadata={"Software": None})
        pictures.append(picture.getvalue())
    assert pictures[0] == pictures[1]
