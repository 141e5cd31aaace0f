package robotran.rcxrom.sensors

/**
 * What of the firmware's table of sensors can be set; [code] is josx's number for it. Source: leJOS `native.c`,
 * `Sensor.java`.
 */
enum class SensorField(val code: Int) {
    /** How to read it, see [SensorMode]; a slope 0..31 may be added. */
    MODE(0),

    /** What is connected; kept, but without effect, as in leJOS. */
    TYPE(1),

    /** The value in its mode, from which counting goes on: josx `Sensor.setPreviousValue`. */
    VALUE(2),

    /** 1 or 0, until the next reading. */
    BOOLEAN(3),
}
