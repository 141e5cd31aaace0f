package robotran.microbit.hardware

import robotran.microbit.model.MicrobitButton
import robotran.microbit.model.MicrobitModel
import robotran.microbit.program.Microbit
import robotran.microbit.program.MicrobitCall
import robotran.microbit.program.MicrobitError

/** The board as programs see it. */
internal class VirtualBoard(private val hardware: BoardHardware) : Microbit {
    override val model: MicrobitModel get() = hardware.model
    override val milliseconds: Long get() = hardware.milliseconds
    override val distance: Int get() = hardware.distance
    override val lightLevel: Int get() = hardware.lightLevel
    override val soundLevel: Int get() = if (hardware.model.hasMicrophone) hardware.soundLevel else 0

    override fun call(call: MicrobitCall, sourceLine: Int, sourceFile: String?): MicrobitError? =
        hardware.perform(call, sourceLine, sourceFile)

    override fun isPressed(button: MicrobitButton): Boolean = hardware.buttons.isDown(button)

    override fun isDark(line: Int): Boolean = hardware.isDark(line)

    override fun grey(line: Int): Int = hardware.grey(line)
}
