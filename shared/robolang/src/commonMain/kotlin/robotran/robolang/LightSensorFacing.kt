package robotran.robolang

/** The direction of the light sensor in a program's header. */
enum class LightSensorFacing { DOWN, FORWARD }
