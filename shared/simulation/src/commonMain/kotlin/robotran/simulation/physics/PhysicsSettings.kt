package robotran.simulation.physics

/**
 * What a world is solved with.
 *
 * @property stepSeconds the fixed time of one step.
 * @property stepParts how many equal parts a step is solved in; the more, the less deep a body gets into another before
 * it is noticed.
 * @property lengthTolerance how deep two fixtures may overlap before they are pushed apart, in the world's unit of
 * length.
 * @property velocityIterations how often the solver goes over the contacts' velocities in a step.
 * @property positionIterations how often it goes over their positions.
 */
data class PhysicsSettings(
    val stepSeconds: Double,
    val stepParts: Int,
    val lengthTolerance: Double,
    val velocityIterations: Int,
    val positionIterations: Int,
)
