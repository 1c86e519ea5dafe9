#pragma once

#define TF2_ROS_EXPORT
#define TF2_ROS_IMPORT
#define TF2_ROS_PUBLIC
#define TF2_ROS_LOCAL
