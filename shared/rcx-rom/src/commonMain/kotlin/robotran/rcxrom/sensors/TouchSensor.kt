package robotran.rcxrom.sensors

object TouchSensor {
    /** A pressed sensor has a small resistance, which reads far below the threshold. Builders report 150 to 250. */
    const val PRESSED_RAW = 180

    fun raw(pressed: Boolean): Int = if (pressed) PRESSED_RAW else SensorCode.OPEN_RAW
}
