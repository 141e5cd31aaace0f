package robotran.rcxrom.sensors

/** What of a sensor is asked for; [code] is josx's number for it. Source: leJOS `SensorConstants.java`. */
enum class SensorRequest(val code: Int) {
    /** What the port measures, 0..1023: the lower, the more current flows. */
    RAW(0),

    /** What the port's mode makes of it. */
    CANONICAL(1),

    /** 1 for a low raw value, as of a pressed touch sensor, otherwise 0. */
    BOOLEAN(2),
}
