package robotran.blockediting.palette

import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.robolang.words.ValueForm

/** Comparisons to begin a condition with: one for each sensor of a robot with [brick] that has [sensors], never none. */
fun comparisonsFor(sensors: Set<SensorKind>, brick: BrickKind): List<String> = COMPARISONS
    .filter { (sensor, compared) -> sensor in sensors && compared.first.exampleOn(brick) != null }
    .map { it.value.second }
    .ifEmpty { listOf("timer > 5") }

/** The value of each sensor, compared with what makes sense. */
private val COMPARISONS = mapOf(
    SensorKind.ULTRASONIC to (ValueForm.DISTANCE to "distance < 20"),
    SensorKind.COLOUR to (ValueForm.COLOUR to "colour == red"),
    SensorKind.SOUND to (ValueForm.LOUDNESS to "loudness > 50"),
    SensorKind.LIGHT to (ValueForm.LIGHT to "light < 40"),
)
