package robotran.world

import kotlin.math.PI

/**
 * All constants of the penbot's construction and motion. Lengths are in centimetres, times in milliseconds, speeds in
 * centimetres a second, masses in kilograms. Positions on the robot are relative to the midpoint between the wheels, x
 * forwards and y to the left.
 */
object Penbot {
    // The calibration of Robolang's `forward` and `turn`.

    /** Driving one centimetre with both motors at power 3: 20 cm/s. A metre takes 5 s, a slow TimingNavigator robot. */
    const val MILLISECONDS_PER_CENTIMETRE = 50.0

    /** Turning one degree with one motor forwards and one backwards at power 3; a full turn takes 1.8 s. */
    const val MILLISECONDS_PER_DEGREE = 5.0

    /** Distance between the tyres' centres; makes the two values above agree. An RIS rover has 11 to 14 cm. */
    const val WHEEL_TRACK = 36.0 / PI

    // Wheels and motors.

    /** The small spoked wheel of the kit, tyre 49.6 x 28. */
    const val WHEEL_DIAMETER = 4.96
    const val WHEEL_WIDTH = 2.8
    const val WHEEL_CIRCUMFERENCE = PI * WHEEL_DIAMETER

    /**
     * Revolutions per minute of a gearmotor without load at 9 V, 330 to 380 measured by builders; geared down 1:3 to
     * the wheel.
     */
    const val MOTOR_NO_LOAD_SPEED = 340.0
    const val GEAR_REDUCTION = 3.0

    /** The power for [MILLISECONDS_PER_CENTIMETRE]: the initial power of a josx Motor. */
    const val CALIBRATED_POWER = 3
    const val CALIBRATED_SPEED = 1000.0 / MILLISECONDS_PER_CENTIMETRE

    /** Speed at full power: the motor's no-load speed, because the robot is light. 29.4 cm/s. */
    const val TOP_SPEED = MOTOR_NO_LOAD_SPEED / GEAR_REDUCTION / 60.0 * WHEEL_CIRCUMFERENCE

    /**
     * Time constant of a motor that starts or brakes. It is the same for both and for every braking power, so a wheel
     * makes up at the end for what it lacks at the start, and a command of t ms drives exactly t / 50 cm. A shorter one
     * would make the tyres slip when a turn follows a straight drive; a longer one would round the drawn corners.
     */
    const val MOTOR_LAG = 30.0

    /**
     * The force at the tyre that stalls a motor at full power, in kg cm/s2. A gearmotor stalls at about 6 N cm at 9 V,
     * as measured by builders; times three for the gears, less 15 % friction, at a wheel of 2.48 cm radius: 6.2 N, more
     * than twice the tyre's grip. At a wall, the motor stalls at power 2 and below; above that the tyre slips.
     */
    const val STALL_FORCE = 620.0

    /**
     * A load below this, in kg cm/s2, is ignored: the robot's own mass and castor in a curve, part of the calibration.
     */
    const val UNFELT_LOAD = 12.0

    /** Deceleration of a floating wheel by its gears' friction, in cm/s each second: 20 cm/s end after 3.3 cm. */
    const val ROLLING_DECELERATION = 60.0

    // Outline, seen from above.
    const val CHASSIS_BACK = -5.0
    const val CHASSIS_FRONT = 8.0

    /** Fits between the tyres. */
    const val CHASSIS_WIDTH = 8.4

    /** The two bumpers are in front of the chassis, one on each side, with this gap between them. */
    const val BUMPER_FRONT = 9.2
    const val BUMPER_GAP = 0.4
    const val BUMPER_WIDTH = 6.4
    const val OVERALL_WIDTH = WHEEL_TRACK + WHEEL_WIDTH

    /**
     * Time that a bumper stays pressed after its last contact. Its rubber band is quick, but a graze must not count as
     * many bumps.
     */
    const val BUMPER_RETURN = 30

    /** A castor wheel under the front. Its drag is part of the calibration, so it has none of its own. */
    const val CASTER_POSITION = 6.5

    /** The light sensor, under the front between the bumpers. */
    const val LIGHT_SENSOR_POSITION = 7.2

    // Mass and grip.

    /**
     * The RCX with six batteries weighs about 0.28 kg, each of three motors 0.042 kg, wheels, beams and pen the rest.
     */
    const val MASS = 0.6

    /** The centre of mass, slightly in front of the axle, at the brick's batteries. */
    const val MASS_POSITION = 0.8

    /** About the centre of mass in kg cm2, with the mass spread evenly over chassis and wheels. */
    const val INERTIA =
        MASS * ((CHASSIS_FRONT - CHASSIS_BACK) * (CHASSIS_FRONT - CHASSIS_BACK) + OVERALL_WIDTH * OVERALL_WIDTH) / 12.0

    /** Coulomb coefficient of rubber tyres on paper; tables give 0.8 to 1.1. */
    const val TYRE_FRICTION = 1.0

    /** Coulomb coefficient of smooth plastic against a wall of wood or card. */
    const val SHELL_FRICTION = 0.3

    /** In cm/s2. */
    const val GRAVITY = 981.0

    /** Force of each driven wheel on the paper, in kg cm/s2; the castor bears the rest. */
    const val WHEEL_LOAD = MASS * GRAVITY * (1.0 - MASS_POSITION / CASTER_POSITION) / 2.0

    // The pen is at the midpoint between the wheels, so it draws sharp corners; motor B lowers it forwards and lifts it
    // backwards.

    /** Time for the motor at [CALIBRATED_POWER] to move the pen from one end stop to the other. */
    const val PEN_TRAVEL_TIME = 200.0

    /** The part of the way down at which the tip touches the paper; a rubber band takes up the rest. */
    const val PEN_CONTACT = 0.8

    /** The line width of a broad felt-tip pen. */
    const val PEN_LINE_WIDTH = 0.3
}
