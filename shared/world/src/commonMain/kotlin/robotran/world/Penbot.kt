package robotran.world

import kotlin.math.PI

/**
 * The penbot: every figure of its build and of how it moves. Lengths are in centimetres, times in milliseconds, speeds
 * in centimetres a second, masses in kilograms. Places on the robot are seen from the point halfway between the wheels,
 * x forwards and y to the left.
 */
object Penbot {
    // What Robolang's `forward` and `turn` count on.

    /**
     * Both motors at power 3 for this long drive one centimetre: 20 cm/s. A metre then takes 5 s, a slow
     * TimingNavigator robot.
     */
    const val MILLISECONDS_PER_CENTIMETRE = 50.0

    /** One motor forwards and one backwards at power 3 for this long turn one degree; a whole turn takes 1.8 s. */
    const val MILLISECONDS_PER_DEGREE = 5.0

    /** Between the middles of the tyres; so wide that the two figures above agree. An RIS rover has 11 to 14 cm. */
    const val WHEEL_TRACK = 36.0 / PI

    // Wheels and motors.

    /** The small spoked wheel of the kit, tyre 49.6 x 28. */
    const val WHEEL_DIAMETER = 4.96
    const val WHEEL_WIDTH = 2.8
    const val WHEEL_CIRCUMFERENCE = PI * WHEEL_DIAMETER

    /**
     * Turns a minute of a gearmotor without load at 9 V, 330 to 380 measured by builders; geared down 1:3 to the wheel.
     */
    const val MOTOR_NO_LOAD_SPEED = 340.0
    const val GEAR_REDUCTION = 3.0

    /** The power that [MILLISECONDS_PER_CENTIMETRE] is for: a new josx Motor has it. */
    const val CALIBRATED_POWER = 3
    const val CALIBRATED_SPEED = 1000.0 / MILLISECONDS_PER_CENTIMETRE

    /** At full power: the motor's own speed, since the robot is light. 29.4 cm/s. */
    const val TOP_SPEED = MOTOR_NO_LOAD_SPEED / GEAR_REDUCTION / 60.0 * WHEEL_CIRCUMFERENCE

    /**
     * How quickly a motor comes to its speed, and to rest when it brakes. One figure for both, and for every braking
     * power, so that what a wheel lacks at the start it makes up for at the end and a command of t ms drives exactly t
     * / 50 cm. Shorter, and the tyres would slip when a turn follows a straight piece at once; longer, and the corners
     * drawn would be round.
     */
    const val MOTOR_LAG = 30.0

    /**
     * What holds a motor fast that is always switched on, as a force at the tyre in kg cm/s2. A gearmotor stalls at
     * about 6 N cm at 9 V, as measured by builders; times three for the gears, less 15 % for their friction, at a wheel
     * of 2.48 cm radius: 6.2 N, more than twice what the tyre grips with. At power 2 and below it is the motor that
     * gives in at a wall, above that the tyre slips.
     */
    const val STALL_FORCE = 620.0

    /**
     * A load below this, in kg cm/s2, is not felt: it is the robot's own mass and castor in a curve, which the
     * calibration includes.
     */
    const val UNFELT_LOAD = 12.0

    /**
     * How quickly a wheel that floats loses speed to the friction of its gears, in cm/s each second: 20 cm/s die away
     * over 3.3 cm.
     */
    const val ROLLING_DECELERATION = 60.0

    // Outline, seen from above.
    const val CHASSIS_BACK = -5.0
    const val CHASSIS_FRONT = 8.0

    /** Fits between the tyres. */
    const val CHASSIS_WIDTH = 8.4

    /** The two bumpers lie before the chassis, one to each side, with this gap between them. */
    const val BUMPER_FRONT = 9.2
    const val BUMPER_GAP = 0.4
    const val BUMPER_WIDTH = 6.4
    const val OVERALL_WIDTH = WHEEL_TRACK + WHEEL_WIDTH

    /**
     * How long a bumper stays in after it has come free; its rubber band is quick, but a graze should not count as many
     * bumps.
     */
    const val BUMPER_RETURN = 30

    /** A castor wheel under the front. Its drag is part of the calibration, so it has none of its own. */
    const val CASTER_PLACE = 6.5

    /** The light sensor, under the front between the bumpers. */
    const val LIGHT_SENSOR_PLACE = 7.2

    // Mass and grip.

    /**
     * The RCX with six batteries weighs about 0.28 kg, each of three motors 0.042 kg, wheels, beams and pen the rest.
     */
    const val MASS = 0.6

    /** The centre of mass, a little before the axle, where the brick's batteries are. */
    const val MASS_PLACE = 0.8

    /** About the centre of mass in kg cm2: as if the mass were spread evenly over chassis and wheels. */
    const val INERTIA =
        MASS * ((CHASSIS_FRONT - CHASSIS_BACK) * (CHASSIS_FRONT - CHASSIS_BACK) + OVERALL_WIDTH * OVERALL_WIDTH) / 12.0

    /** Coulomb coefficient of the rubber tyres on paper; 0.8 to 1.1 by table. */
    const val TYRE_FRICTION = 1.0

    /** Coulomb coefficient of smooth plastic against a wall of wood or card. */
    const val SHELL_FRICTION = 0.3

    /** In cm/s2. */
    const val GRAVITY = 981.0

    /** What each driven wheel presses on the paper with, in kg cm/s2; the castor bears the rest. */
    const val WHEEL_LOAD = MASS * GRAVITY * (1.0 - MASS_PLACE / CASTER_PLACE) / 2.0

    // The pen, halfway between the wheels, so that it draws sharp corners; motor B lowers it forwards and lifts it
    // backwards.

    /** How long the motor at [CALIBRATED_POWER] moves the pen from one end stop to the other. */
    const val PEN_TRAVEL_TIME = 200.0

    /** The part of the way down at which the tip meets the paper; the rest of the way a rubber band gives. */
    const val PEN_CONTACT = 0.8

    /** How wide the pen's line is: a broad felt-tip pen. */
    const val PEN_LINE_WIDTH = 0.3
}
