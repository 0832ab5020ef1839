# Run the first line on one computer and the second on another, each with its own address.
fastdds discovery -i 0 -l 192.168.1.10 -p 11811
fastdds discovery -i 1 -l 192.168.1.11 -p 11811
