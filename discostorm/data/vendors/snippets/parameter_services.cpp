auto options = rclcpp::NodeOptions().start_parameter_services(false);
auto node = std::make_shared<rclcpp::Node>("name", options);
