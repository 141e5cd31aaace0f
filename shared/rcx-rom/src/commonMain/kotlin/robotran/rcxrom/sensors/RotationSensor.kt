package robotran.rcxrom.sensors

/**
 * The LEGO rotation sensor: its axle has sixteen positions per turn, and each has one of four raw values. Sources:
 * brickOS `dsensor.c` and measurements by its users.
 */
object RotationSensor {
    const val COUNTS_PER_TURN = 16

    /** The raw values of four consecutive positions, forwards; each in the middle of its band. */
    private val RAW_OF_POSITION = listOf(992, 864, 416, 640)

    /**
     * The raw value at the port.
     *
     * @param count position of the axle in sixteenths of a turn; grows forwards.
     * @param active whether the port is powered. Without power it measures an open port.
     */
    fun raw(count: Int, active: Boolean): Int =
        if (active) RAW_OF_POSITION[count.mod(RAW_OF_POSITION.size)] else SensorCode.OPEN_RAW
}
