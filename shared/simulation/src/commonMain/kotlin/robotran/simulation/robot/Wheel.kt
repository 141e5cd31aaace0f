package robotran.simulation.robot

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.simulation.config.SimulationLimits
import robotran.simulation.noise.WheelNoise
import robotran.world.robot.RobotParameters
import kotlin.math.abs

/**
 * One driven wheel: its motor, the effect of the floor, and its rotation. Speeds are in cm/s, distances in centimetres.
 */
internal class Wheel(
    private val noise: WheelNoise,
    private val motor: MotorModel,
    private val f: RobotParameters,
    private val play: MotorPlay? = null,
) {
    private var floats = true
    private var load = 0.0
    private var travel = 0.0
    private var speedBefore = 0.0

    /** Distance that the tyre has rolled since the session began, forwards positive. */
    var turned = 0.0
        private set

    /** Distance that the tyre would have rolled if it had followed every turn of the motor, forwards positive. */
    var motorTravel = 0.0
        private set

    /** The tyre's speed in the current physics step, and its change since the last one. */
    var speed = 0.0
        private set
    val speedChange: Double get() = speed - speedBefore

    /** The effect of each cause of error on the wheel's distance. */
    val account = WheelErrorBudget()

    /**
     * Advances by one millisecond, with batteries that give [battery] of the voltage of fresh ones.
     *
     * @param isRegulated whether something makes up for a strong or weak motor.
     */
    fun tick(command: MotorState, battery: Double, tick: Long, isRegulated: Boolean = false) {
        noise.tick(tick)
        floats = command.mode == MotorMode.FLOAT
        motor.tick(command, noise.strength * noise.flutter * battery, load)
        val way = motor.speed * SimulationLimits.TICK_SECONDS
        motorTravel += way
        travel += if (play == null) way else play.passOn(way)
        if (noise.isOn && !floats && !isRegulated && way != 0.0) {
            account.strength += way - way / noise.strength
            account.flutter += way - way / noise.flutter
            account.battery += way - way / battery
        }
    }

    /** Starts a physics step: from now on [speed] is the speed of this step. */
    fun beginStep() {
        speedBefore = speed
        val slipped = travel * noise.slip
        account.slip += abs(slipped)
        speed = (travel - slipped) / SimulationLimits.PHYSICS_STEP_SECONDS
    }

    /**
     * Ends a physics step.
     *
     * @param force the floor's force against the tyre, beyond that of acceleration, in kg cm/s2; forwards positive.
     * @param slips whether the tyre has slipped.
     * @param ground the robot's speed over the floor at this wheel.
     */
    fun endStep(force: Double, slips: Boolean, ground: Double) {
        val felt = if (abs(force) > f.unfeltLoad) {
            force - (if (force > 0) f.unfeltLoad else -f.unfeltLoad)
        } else {
            0.0
        }
        load = if (felt == 0.0 && abs(load) < f.unfeltLoad) 0.0 else load + (felt - load) * LOAD_RESPONSE
        if (slips) {
            turned += travel
            account.spin += abs(travel - ground * SimulationLimits.PHYSICS_STEP_SECONDS)
        } else {
            turned += ground * SimulationLimits.PHYSICS_STEP_SECONDS
            // What holds or pushes the tyre holds or pushes the motor.
            motorTravel += (ground - speed) * SimulationLimits.PHYSICS_STEP_SECONDS
            if (floats) motor.follow(ground)
        }
        travel = 0.0
    }

    /** Distance that was lost between motor and wheel, unsigned. */
    val playedAway: Double get() = play?.lost ?: 0.0

    private companion object {
        /** The part of a load change that reaches the motor in a step, because gears and tyres give a little. */
        const val LOAD_RESPONSE = 0.25
    }
}

/**
 * The causes of error in a wheel's distance, in centimetres; backwards is negative.
 *
 * @property strength from a strong or weak motor.
 * @property flutter from speed fluctuation.
 * @property battery from the voltage.
 * @property slip lost on the floor, unsigned.
 * @property spin turned without grip, as at a wall, unsigned.
 */
internal class WheelErrorBudget {
    var strength = 0.0
    var flutter = 0.0
    var battery = 0.0
    var slip = 0.0
    var spin = 0.0
}
