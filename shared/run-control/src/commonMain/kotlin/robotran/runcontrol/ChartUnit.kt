package robotran.runcontrol

import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind

/**
 * The unit of a [ChartLane].
 *
 * @property sign how it is written behind a number; empty for [NONE].
 */
enum class ChartUnit(val sign: String) {
    /** A power step, 0 or 1, or a number that only the program knows the meaning of. */
    NONE(""),
    PERCENT("%"),
    CENTIMETRES("cm"),
    DEGREES("°"),
    MILLIVOLTS("mV"),
    ;

    internal companion object {
        /** The unit of [lane] of a robot with a [brick] that has a sensor of this [kind] there; null if it has none. */
        fun of(lane: ChartLane, brick: BrickKind, kind: SensorKind?): ChartUnit = when {
            lane.isDegrees -> DEGREES
            lane == ChartLane.BATTERY -> MILLIVOLTS
            brick == BrickKind.RCX -> NONE
            lane.isMotor -> PERCENT
            else -> ofSensor(kind)
        }

        private fun ofSensor(kind: SensorKind?): ChartUnit = when (kind) {
            SensorKind.LIGHT, SensorKind.SOUND, SensorKind.COLOUR -> PERCENT
            SensorKind.ULTRASONIC -> CENTIMETRES
            SensorKind.COMPASS -> DEGREES
            else -> NONE
        }
    }
}
