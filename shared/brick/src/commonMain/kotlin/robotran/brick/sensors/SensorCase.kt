package robotran.brick.sensors

/** What the simple sensors for a brick are built into. */
enum class SensorCase {
    /** A small brick with studs. */
    STUDDED,

    /** A round front in a grey box. */
    ROUNDED,
}
