package robotran.simulation.config

import robotran.simulation.physics.PhysicsSettings

/** How a session is computed: what is a matter of the simulation, not of the robot or the world. */
internal object SimulationLimits {
    /** One tick: the RCX's own clock. */
    const val TICK_SECONDS = 0.001

    /** Ticks between two steps of the physics: 5 ms, in which a wheel moves 1.5 mm at most. */
    const val TICKS_PER_PHYSICS_STEP = 5L
    const val PHYSICS_STEP_SECONDS = TICKS_PER_PHYSICS_STEP * TICK_SECONDS

    /**
     * dyn4j works in centimetres, the unit of everything else, so nothing is rounded on the way. Its own tolerance of
     * 0.005 is made for metres and would be far finer than needed; 0.02 is 0.2 mm, less than a pencil line, and keeps a
     * robot that pushes against a wall touching it. Solving a step in two halves keeps the robot at full speed from
     * getting more than 0.8 mm into a wall.
     */
    val PHYSICS = PhysicsSettings(
        stepSeconds = PHYSICS_STEP_SECONDS,
        stepParts = 2,
        lengthTolerance = 0.02,
        velocityIterations = 10,
        positionIterations = 5,
    )

    /** How often it is looked whether goals are met. */
    const val MILLISECONDS_PER_JUDGEMENT = 10

    /** How long one step of a program is waited for if nothing else is said: ten minutes. */
    const val LONGEST_STEP_MILLISECONDS = 600_000

    /** A wheel slower than this, in cm/s, stands still. */
    const val STANDSTILL_SPEED = 1e-6

    /** How far the drawn line may lie beside the pen's real way, in centimetres: a small part of the pen's line. */
    const val INK_TOLERANCE = 0.005

    /**
     * Corners of all strokes together, enough for days of drawing by hand; whatever is drawn after that is measured but
     * not kept.
     */
    const val MAXIMUM_INK_POINTS = 200_000

    /** Corners of all trails together; how robots drive on after that is not remembered. */
    const val MAXIMUM_TRAIL_POINTS = 100_000
}
