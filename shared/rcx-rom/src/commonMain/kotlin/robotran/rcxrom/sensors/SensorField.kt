package robotran.rcxrom.sensors

/**
 * The writable fields of the firmware's sensor table; [code] is josx's number. Sources: leJOS `native.c`,
 * `Sensor.java`.
 */
enum class SensorField(val code: Int) {
    /** How to read the sensor, see [SensorMode]; a slope 0..31 may be added. */
    MODE(0),

    /** The connected sensor; stored, but without effect, as in leJOS. */
    TYPE(1),

    /** The value in its mode, from which counting continues: josx `Sensor.setPreviousValue`. */
    VALUE(2),

    /** 1 or 0, until the next reading. */
    BOOLEAN(3),
}
