package robotran.brick.sensors

enum class SensorKind { TOUCH, TEMPERATURE, LIGHT, ROTATION, ULTRASONIC, SOUND, COLOUR, COMPASS, GYRO }
