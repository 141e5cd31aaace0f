package robotran.scene3d.model

import robotran.world.RobotColour

/**
 * The colours of what stands on the paper, as opaque 0xAARRGGBB.
 */
data class SceneColours(
    val wall: Int,
    val wallTop: Int,
    val wallJoint: Int,
    val block: Int,
    val blockTop: Int,
    val blockGrain: Int,
    val lampOn: Int,
    val lampInfrared: Int,
    val lampOff: Int,
    val lampShade: Int,
    val lampEdge: Int,
    val flag: Int,
    val flagMet: Int,
    val flagLight: Int,
    val robot: RobotPalette,
)

/** The colours of the parts of a robot. */
data class RobotPalette(
    val brick: (RobotColour) -> Int,
    val brickEdge: (RobotColour) -> Int,
    val ink: (Int) -> Int,
    val chassis: Int,
    val chassisEdge: Int,
    val tyre: Int,
    val tread: Int,
    val hub: Int,
    val bumper: Int,
    val bumperEdge: Int,
    val glass: Int,
    val motor: Int,
    val clip: Int,
    val lightSensor: Int,
    val sensorLamp: Int,
    val buttons: List<Int>,
    val beacon: Int,
    val eye: Int,
    val pupil: Int,
    val nxtFace: Int = 0xFFEDEEEC.toInt(),
    val nxtGrey: Int = 0xFFC9CED2.toInt(),
    val orange: Int = 0xFFF07C1A.toInt(),
)

/** [colour] with its red, green and blue multiplied by [brightness], at most white. */
internal fun shaded(colour: Int, brightness: Double): Int {
    fun part(shift: Int): Int = (((colour ushr shift) and WHOLE) * brightness).toInt().coerceIn(0, WHOLE) shl shift
    return (colour and ALPHA) or part(RED) or part(GREEN) or part(BLUE)
}

private const val WHOLE = 0xFF
private const val ALPHA = 0xFF shl 24
private const val RED = 16
private const val GREEN = 8
private const val BLUE = 0
