ros2 launch nav2_bringup bringup_launch.py use_composition:=True
