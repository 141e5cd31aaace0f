package robotran.simulation.noise

import robotran.world.geometry.Pose
import robotran.world.geometry.normalHeading

/** The real start pose of a robot for the pose [planned], which is never met exactly. */
internal fun realStart(planned: Pose, streams: NoiseStreams, realism: Double): Pose {
    if (realism == 0.0) return planned

    fun error(name: String, deviation: Double) =
        realism * deviation * streams.named("start: $name").normal().coerceIn(-MAX_DEVIATIONS, MAX_DEVIATIONS)
    return Pose(
        planned.x + error("x", Realism.START_POSITION),
        planned.y + error("y", Realism.START_POSITION),
        normalHeading(planned.heading + error("heading", Realism.START_HEADING)),
    )
}

private const val MAX_DEVIATIONS = 2.0
