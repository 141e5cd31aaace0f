package robotran.hub.model

/**
 * What a program can expect on a port.
 *
 * @property className the class of Pybricks.
 */
enum class HubDeviceKind(val className: String) {
    MOTOR("Motor"),
    COLOR_SENSOR("ColorSensor"),
    ULTRASONIC_SENSOR("UltrasonicSensor"),
    FORCE_SENSOR("ForceSensor"),
    TOUCH_SENSOR("TouchSensor"),
    LIGHT_SENSOR("LightSensor"),
    SOUND_SENSOR("SoundSensor"),
}
