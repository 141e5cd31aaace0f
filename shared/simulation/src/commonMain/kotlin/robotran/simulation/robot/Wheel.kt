package robotran.simulation.robot

import robotran.rcxrom.controls.MotorMode
import robotran.rcxrom.controls.MotorState
import robotran.simulation.config.SimulationLimits
import robotran.simulation.noise.WheelNoise
import robotran.world.Penbot
import kotlin.math.abs

/**
 * One driven wheel: its motor, what the floor does to it, and how far it has turned. Speeds are in cm/s, ways in
 * centimetres.
 */
internal class Wheel(private val noise: WheelNoise) {
    private val motor = Motor()
    private var floats = true
    private var load = 0.0
    private var travel = 0.0
    private var speedBefore = 0.0

    /** How far the tyre has turned since the session began, forwards positive. */
    var turned = 0.0
        private set

    /**
     * At what speed the tyre carries the robot in the step of the physics that is being made, and by how much that has
     * changed.
     */
    var speed = 0.0
        private set
    val speedChange: Double get() = speed - speedBefore

    /** What each cause of unevenness has added to the wheel's way, or taken from it. */
    val account = WheelErrorBudget()

    /** Lets one millisecond pass, with batteries that give [battery] of what fresh ones do. */
    fun tick(told: MotorState, battery: Double, tick: Long) {
        noise.tick(tick)
        floats = told.mode == MotorMode.FLOAT
        motor.tick(told, noise.strength * noise.flutter * battery, load)
        val way = motor.speed * SimulationLimits.TICK_SECONDS
        travel += way
        if (noise.isOn && !floats && way != 0.0) {
            account.strength += way - way / noise.strength
            account.flutter += way - way / noise.flutter
            account.battery += way - way / battery
        }
    }

    /** A step of the physics begins: from now on [speed] is that of this step. */
    fun beginStep() {
        speedBefore = speed
        val slipped = travel * noise.slip
        account.slip += abs(slipped)
        speed = (travel - slipped) / SimulationLimits.PHYSICS_STEP_SECONDS
    }

    /**
     * The step is over.
     *
     * @param force what the floor held the tyre back with, beyond what changing the speed takes, in kg cm/s2; forwards
     * positive.
     * @param slips whether the tyre has slipped.
     * @param ground how fast the robot moves over the floor at this wheel.
     */
    fun endStep(force: Double, slips: Boolean, ground: Double) {
        val felt = if (abs(force) >
            Penbot.UNFELT_LOAD
        ) {
            force - (if (force > 0) Penbot.UNFELT_LOAD else -Penbot.UNFELT_LOAD)
        } else {
            0.0
        }
        load = if (felt == 0.0 && abs(load) < Penbot.UNFELT_LOAD) 0.0 else load + (felt - load) * LOAD_RESPONSE
        if (slips) {
            turned += travel
            account.spin += abs(travel - ground * SimulationLimits.PHYSICS_STEP_SECONDS)
        } else {
            turned += ground * SimulationLimits.PHYSICS_STEP_SECONDS
            if (floats) motor.follow(ground)
        }
        travel = 0.0
    }

    private companion object {
        /** The part of a change of load that reaches the motor in a step: gears and tyres give a little. */
        const val LOAD_RESPONSE = 0.25
    }
}

/**
 * What has made a wheel's way longer or shorter, in centimetres; backwards is negative.
 *
 * @property strength because its motor is strong or weak.
 * @property flutter because its speed flutters.
 * @property battery because of the voltage.
 * @property slip lost on the floor here and there, without a sign.
 * @property spin turned without grip, as at a wall, without a sign.
 */
internal class WheelErrorBudget {
    var strength = 0.0
    var flutter = 0.0
    var battery = 0.0
    var slip = 0.0
    var spin = 0.0
}
