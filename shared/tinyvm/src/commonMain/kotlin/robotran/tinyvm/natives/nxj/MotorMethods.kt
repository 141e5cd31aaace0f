package robotran.tinyvm.natives.nxj

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.nxt.program.NxtNative
import robotran.nxt.regulator.MotorRegulator
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.wordOf

private const val PORT = "lejos/nxt/MotorPort"
private val MOTORS = BrickKind.with(JavaPlatform.NXJ).motorPorts.indices
private const val REGULATION = "lejos/nxt/MotorRegulation"

/** `lejos.nxt.MotorPort`, and what regulates motors for `NXTRegulatedMotor`. */
internal val motorMethods: Map<String, NativeMethod> = mapOf(
    "$PORT.controlMotorById(III)V" to calls(NxtNative.CONTROL_MOTOR),
    "$PORT.resetTachoCountById(I)V" to calls(NxtNative.RESET_TACHO_COUNT),
    "$PORT.getTachoCountById(I)I" to reads { nxt, arguments ->
        val port = arguments(0)
        if (port in MOTORS) nxt.tachoCount(port) else 0
    },
    "$REGULATION.start(IFIIZ)V" to calls(NxtNative.REGULATE),
    "$REGULATION.speed(IF)V" to calls(NxtNative.REGULATOR_SPEED),
    "$REGULATION.acceleration(II)V" to calls(NxtNative.REGULATOR_ACCELERATION),
    "$REGULATION.roll(I)V" to calls(NxtNative.REGULATOR_ROLL),
    "$REGULATION.suspend(I)Z" to calls(NxtNative.REGULATOR_SUSPEND),
    "$REGULATION.stallThreshold(III)V" to calls(NxtNative.REGULATOR_STALL),
    "$REGULATION.position(I)F" to regulated { it.position.toBits() },
    "$REGULATION.velocity(I)F" to regulated { it.velocity.toBits() },
    "$REGULATION.isMoving(I)Z" to regulated { wordOf(it.isMoving) },
    "$REGULATION.isStalled(I)Z" to regulated { wordOf(it.isStalled) },
    "$REGULATION.limit(I)I" to regulated { it.limit },
)

private fun regulated(read: (MotorRegulator) -> Int): NativeMethod = reads { nxt, arguments ->
    val port = arguments(0)
    if (port in MOTORS) read(nxt.regulator(port)) else 0
}
