package robotran.brick.sensors

/**
 * The unit of what a brick measures.
 *
 * @property sign how it is written behind a number; empty for [NONE].
 */
enum class MeasuringUnit(val sign: String) {
    /** 0 or 1, a power step, or a number that only the program knows the meaning of. */
    NONE(""),
    PERCENT("%"),
    CENTIMETRES("cm"),
    MILLIMETRES("mm"),
    DEGREES("°"),
    MILLIVOLTS("mV"),
    ;

    /** [value] with the unit, such as `45 cm` or `90°`. */
    fun text(value: Int): String = when (this) {
        NONE -> "$value"
        DEGREES -> "$value$sign"
        else -> "$value $sign"
    }

    companion object {
        /** The unit in which an NXT measures with a sensor of this [kind]; [NONE] if there is no sensor. */
        fun of(kind: SensorKind?): MeasuringUnit = when (kind) {
            SensorKind.LIGHT, SensorKind.SOUND, SensorKind.COLOUR, SensorKind.RCX_LIGHT -> PERCENT
            SensorKind.ULTRASONIC -> CENTIMETRES
            SensorKind.OPTICAL_DISTANCE -> MILLIMETRES
            SensorKind.COMPASS, SensorKind.MINDSENSORS_COMPASS -> DEGREES
            SensorKind.NXT_TEMPERATURE, SensorKind.TEMPERATURE, SensorKind.ROTATION -> DEGREES
            else -> NONE
        }
    }
}
