package robotran.blockediting.palette

import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind

/** Comparisons to begin a condition with: one for each sensor of a robot with [brick] that has [sensors], never none. */
fun comparisonsFor(sensors: Set<SensorKind>, brick: BrickKind): List<String> {
    val ofNxt = if (brick == BrickKind.NXT) NXT_COMPARISONS else emptyMap()
    val fitting = (ofNxt + (SensorKind.LIGHT to LIGHT_COMPARISON)).filterKeys { it in sensors }.values.toList()
    return fitting.ifEmpty { listOf("timer > 5") }
}

internal const val LIGHT_COMPARISON = "light < 40"
internal const val DISTANCE_COMPARISON = "distance < 20"

/** The word for a sensor that only an NXT has, compared with a value that makes sense. */
private val NXT_COMPARISONS = mapOf(
    SensorKind.ULTRASONIC to DISTANCE_COMPARISON,
    SensorKind.COLOUR to "colour == red",
    SensorKind.SOUND to "loudness > 50",
)
