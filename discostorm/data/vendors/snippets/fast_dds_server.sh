# Use the address of this computer.
fastdds discovery -i 0 -l 192.168.1.10 -p 11811
