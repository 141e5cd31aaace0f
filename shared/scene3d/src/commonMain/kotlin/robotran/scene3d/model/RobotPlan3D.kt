package robotran.scene3d.model

import robotran.world.Penbot

/**
 * The shape of the robot in centimetres: x forwards from the pen, y to its left, z upwards. What is not in [Penbot]
 * follows LEGO's parts, a little smaller where two would be in the same place. Its columns, the wheels, the rear, the
 * front with the brick and the bumpers, stand side by side without a common point, also while a bumper is pressed.
 */
internal object RobotPlan3D {
    const val WHEEL_RADIUS = Penbot.WHEEL_DIAMETER / 2
    const val WHEEL_INNER = Penbot.WHEEL_TRACK / 2 - Penbot.WHEEL_WIDTH / 2
    const val WHEEL_OUTER = Penbot.WHEEL_TRACK / 2 + Penbot.WHEEL_WIDTH / 2

    /** Between the tyres. */
    const val HALF_CHASSIS = WHEEL_INNER - 0.05

    const val REAR = Penbot.CHASSIS_BACK

    /** Where the column of the brick begins: the tyres end here. */
    const val MIDDLE = WHEEL_RADIUS + 0.02
    const val FRONT = Penbot.CHASSIS_FRONT - 0.2

    /** An RCX is 6.4 by 11.2 by 4 cm; this one has five sixths of that, to fit between tyres and bumpers. */
    const val HALF_BRICK = 4.75
    const val BRICK_CORNER = 0.55
    const val BRICK_BEVEL = 0.3

    const val CHASSIS_BOTTOM = 1.7
    const val CHASSIS_TOP = 4.6
    const val BRICK_BASE = 5.4
    const val BRICK_SHOULDER = 7.7
    const val BRICK_TOP = 8.0
    const val BEACON_TOP = 10.6

    const val BUMPER_BACK = Penbot.BUMPER_FRONT - 0.8
    const val BUMPER_INNER = Penbot.BUMPER_GAP / 2
    const val BUMPER_OUTER = BUMPER_INNER + Penbot.BUMPER_WIDTH
    const val BUMPER_BOTTOM = 1.3
    const val BUMPER_TOP = 3.3

    /** How far a bumper gives way. */
    const val BUMPER_TRAVEL = 0.55

    const val PEN_RADIUS = 0.62
    const val PEN_TIP_RADIUS = 0.14
    const val HOLDER_TOP = 7.0
    const val PEN_TOP = 10.6

    /** The way of the pen between its end stops. */
    const val PEN_LIFT = 1.2

    /** All robots with their pens and lights are lower than this. */
    const val HEIGHT = 12.0
}
