package robotran.simulation.physics

/**
 * The settings of the physics solver.
 *
 * @property stepSeconds the fixed time of one step.
 * @property stepParts number of equal substeps; more substeps detect a collision at a smaller penetration.
 * @property lengthTolerance max overlap of two fixtures before they are pushed apart, in the world's unit of length.
 * @property velocityIterations velocity iterations of the contact solver per step.
 * @property positionIterations position iterations of the contact solver per step.
 */
data class PhysicsSettings(
    val stepSeconds: Double,
    val stepParts: Int,
    val lengthTolerance: Double,
    val velocityIterations: Int,
    val positionIterations: Int,
)
