package robotran.rcxrom.sensors

/** The LEGO touch sensor as something that a port measures. */
object TouchSensor {
    /**
     * Pressed, its resistance is small but not nothing; far below all that counts as pressed. Builders report 150 to
     * 250.
     */
    const val PRESSED_RAW = 180

    /** What the port measures. */
    fun raw(pressed: Boolean): Int = if (pressed) PRESSED_RAW else SensorCode.OPEN_RAW
}
