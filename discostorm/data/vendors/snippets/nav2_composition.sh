# Nav2 makes a container of its own, nav2_container. Load your other nodes into it, too:
# nodes outside of it stay processes of their own.
ros2 launch nav2_bringup bringup_launch.py use_composition:=True
