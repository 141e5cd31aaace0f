package robotran.rcxrom.routines

import robotran.brick.controls.BrickButton
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.controls.Buttons
import robotran.rcxrom.display.Lcd
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.memory.Registers
import robotran.rcxrom.messages.BrickMessages

/** The routines for the buttons and for the pins they share with the display. */
internal class ButtonRoutines(
    private val memory: RcxMemory,
    private val buttons: Buttons,
    private val lcd: Lcd,
    private val messages: BrickMessages,
) {
    val routines: Map<Int, RomRoutine> = mapOf(
        RomAddress.READ_BUTTONS to ::readButtons,
        RomAddress.INIT_BUTTONS to { init() },
        RomAddress.SHUTDOWN_BUTTONS to { shutdown() },
    )

    private fun readButtons(arguments: List<Int>): RomEffect {
        val (code, pointer) = arguments
        if (code != RomCode.BUTTONS) return refused(messages.unknownCode(code))
        val held = BITS.keys.filter { it in buttons.pressed }
        memory.writeShort(pointer, held.sumOf { BITS.getValue(it) })
        return RomEffect(messages.buttons(held))
    }

    private fun init(): RomEffect {
        lcd.clearAll()
        memory.setBits(Registers.PORT_6_DIRECTIONS, Registers.DISPLAY_PINS, on = true)
        return RomEffect(messages.setUp("init buttons"))
    }

    private fun shutdown(): RomEffect {
        memory.setBits(Registers.PORT_6_DIRECTIONS, Registers.DISPLAY_PINS, on = false)
        return RomEffect(messages.setUp("shutdown buttons"))
    }

    private companion object {
        val BITS = mapOf(BrickButton.RUN to 1, BrickButton.VIEW to 2, BrickButton.PRGM to 4)
    }
}
