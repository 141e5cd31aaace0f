package robotran.simulation.robot

import robotran.simulation.config.SimulationLimits
import robotran.simulation.physics.BodyMotion
import robotran.world.geometry.length
import robotran.world.robot.RobotParameters

/**
 * The impulses of the two tyres on the robot in one physics step, in kg cm/s.
 *
 * @property left forwards, at the left wheel.
 * @property right forwards, at the right wheel.
 * @property leftSideways to the robot's left, at the left wheel.
 * @property rightSideways to the robot's left, at the right wheel.
 * @property leftSlips whether the left tyre slips.
 * @property rightSlips whether the right tyre slips.
 */
internal data class TyreImpulses(
    val left: Double,
    val right: Double,
    val leftSideways: Double,
    val rightSideways: Double,
    val leftSlips: Boolean,
    val rightSlips: Boolean,
)

/**
 * The tyres of a robot on the floor.
 *
 * Rolling gives three equations for the midpoint between the wheels: its forward speed is the mean of the tyres'
 * speeds, it does not move sideways, and the robot turns by their difference. The three unknowns are the forward
 * impulse of each tyre, and the sideways one, which both tyres share.
 */
internal class Traction(private val f: RobotParameters) {
    private val strongestImpulse = f.tyreFriction * f.wheelLoad * SimulationLimits.PHYSICS_STEP_SECONDS

    /**
     * The impulses with which the tyres, turning at [leftSpeed] and [rightSpeed] in cm/s, roll without slipping for the
     * next step, within the limits of their grip. A tyre that would exceed friction slips and gives the max impulse.
     */
    fun rollingImpulses(motion: BodyMotion, leftSpeed: Double, rightSpeed: Double): TyreImpulses {
        val forwards = motion.velocityX * motion.cosine + motion.velocityY * motion.sine
        val sideways = motion.velocityY * motion.cosine - motion.velocityX * motion.sine
        val wantedTurning = (rightSpeed - leftSpeed) / f.wheelTrack
        val both = f.mass * ((leftSpeed + rightSpeed) / 2 - forwards)
        // The centre of mass is in front of the axle, so it moves sideways when the robot turns about the axle's centre.
        val across = f.mass * (wantedTurning * f.massX - sideways)
        val twist = f.inertia * (wantedTurning - motion.angularVelocity) + f.massX * across
        val difference = 2 * twist / f.wheelTrack
        val left = (both - difference) / 2
        val right = (both + difference) / 2
        val leftGrip = grip(left, across / 2)
        val rightGrip = grip(right, across / 2)
        return TyreImpulses(
            left * leftGrip,
            right * rightGrip,
            across / 2 * leftGrip,
            across / 2 * rightGrip,
            leftGrip < 1.0,
            rightGrip < 1.0,
        )
    }

    /**
     * The forward impulse that changes the speed of a freely rolling robot's tyres by [own] at this wheel and by
     * [other] at the other one. The rest of a tyre's impulse goes into a load.
     */
    fun rollingImpulse(own: Double, other: Double): Double {
        val twist = (f.inertia + f.mass * f.massX * f.massX) * (own - other) / f.wheelTrack
        return f.mass * (own + other) / 4 + twist / f.wheelTrack
    }

    /** The part of an impulse that friction can give, at most 1. */
    private fun grip(along: Double, across: Double): Double {
        val wanted = length(along, across)
        return if (wanted <= strongestImpulse) 1.0 else strongestImpulse / wanted
    }
}
