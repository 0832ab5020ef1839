"""Frames on the air: the stored run of the first page is today's simulator's."""

import pandas as pd
import single_simulations

from discostorm.data import data_path


def test_the_picture_is_of_todays_simulator() -> None:
    kept = pd.read_csv(data_path("simulated/air.csv", "discostorm_book"), dtype=str)
    pd.testing.assert_frame_equal(
        kept, pd.DataFrame(single_simulations.first_page_run()).astype(str)
    )
