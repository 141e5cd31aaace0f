package robotran.simulation.config

import robotran.simulation.physics.PhysicsSettings

/** Settings of the simulation itself, independent of the robot and the world. */
internal object SimulationLimits {
    /** One tick: the RCX's own clock. */
    const val TICK_SECONDS = 0.001

    /** Ticks between two physics steps: 5 ms, in which a penbot's wheel moves at most 1.5 mm, and any wheel 3 mm. */
    const val TICKS_PER_PHYSICS_STEP = 5L
    const val PHYSICS_STEP_SECONDS = TICKS_PER_PHYSICS_STEP * TICK_SECONDS

    /**
     * dyn4j works in centimetres like everything else, so no conversion rounds. Its default tolerance of 0.005 is made
     * for metres and would be far too fine; 0.02 is 0.2 mm, less than a pencil line, and keeps a robot that pushes
     * against a wall in contact. Solving a step in two halves limits the penetration of a robot at full speed into a
     * wall to 0.8 mm.
     */
    val PHYSICS = PhysicsSettings(
        stepSeconds = PHYSICS_STEP_SECONDS,
        stepParts = 2,
        lengthTolerance = 0.02,
        velocityIterations = 10,
        positionIterations = 5,
    )

    /** Time between two checks of the goals. */
    const val MILLISECONDS_PER_EVALUATION = 10

    /** Default time limit for one step of a program: ten minutes. */
    const val MAX_STEP_MILLISECONDS = 600_000

    /** A wheel slower than this, in cm/s, stands still. */
    const val STANDSTILL_SPEED = 1e-6

    /** Max distance of the drawn line from the pen's real path, in centimetres: a small part of the line's width. */
    const val INK_TOLERANCE = 0.005

    /**
     * Max number of corners of all strokes together, enough for days of drawing by hand; later drawing is measured but
     * not stored.
     */
    const val MAXIMUM_INK_POINTS = 200_000

    /** Max number of corners of all trails together; later driving is not stored. */
    const val MAXIMUM_TRAIL_POINTS = 100_000
}
