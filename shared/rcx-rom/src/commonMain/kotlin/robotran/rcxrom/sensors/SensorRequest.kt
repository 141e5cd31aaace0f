package robotran.rcxrom.sensors

/** Which value of a sensor to read; [code] is josx's number for it. Source: leJOS `SensorConstants.java`. */
enum class SensorRequest(val code: Int) {
    /** What the port measures, 0..1023; lower if more current flows. */
    RAW(0),

    /** The value that the port's mode computes from it. */
    CANONICAL(1),

    /** 1 for a low raw value, such as from a pressed touch sensor, otherwise 0. */
    BOOLEAN(2),
}
