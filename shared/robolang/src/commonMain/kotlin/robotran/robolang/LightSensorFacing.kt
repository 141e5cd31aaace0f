package robotran.robolang

/** Where a program says that the light sensor looks. */
enum class LightSensorFacing { DOWN, FORWARD }
