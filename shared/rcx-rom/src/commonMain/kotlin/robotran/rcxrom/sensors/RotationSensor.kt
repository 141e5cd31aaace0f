package robotran.rcxrom.sensors

/**
 * The LEGO rotation sensor as something that a port measures: its axle has sixteen places a turn, and each has one of
 * four raw values. Source: brickOS `dsensor.c` and measurements of its users.
 */
object RotationSensor {
    /** How many counts a turn has. */
    const val COUNTS_PER_TURN = 16

    /** The raw values of four places running, forwards; each in the middle of its band. */
    private val RAW_OF_PLACE = listOf(992, 864, 416, 640)

    /**
     * What the port measures.
     *
     * @param count where the axle stands, in sixteenths of a turn; forwards it grows.
     * @param active whether the port is powered. If it is not, it measures as if nothing were connected.
     */
    fun raw(count: Int, active: Boolean): Int =
        if (active) RAW_OF_PLACE[count.mod(RAW_OF_PLACE.size)] else SensorCode.OPEN_RAW
}
