package robotran.rom

/** The routines that tell the state of the buttons and of the battery. */
internal class ButtonRoutines(
    private val memory: RcxMemory,
    private val buttons: Buttons,
) {
    val routines: Map<Int, RomRoutine> = mapOf(
        RomAddress.READ_BUTTONS to ::readButtons,
        RomAddress.READ_POWER_STATUS to ::readPowerStatus,
    )

    private fun readButtons(arguments: List<Int>): RomEffect {
        val (_, pointer) = arguments
        val held = BITS.keys.filter { it in buttons.pressed }
        memory.writeShort(pointer, held.sumOf { BITS.getValue(it) })
        return RomEffect("buttons held down: ${held.joinToString { NAMES.getValue(it) }.ifEmpty { "none" }}")
    }

    private fun readPowerStatus(arguments: List<Int>): RomEffect {
        val (code, pointer) = arguments
        return when (code) {
            RomCode.ON_OFF_KEY -> readOnOffKey(pointer)
            RomCode.BATTERY -> readBattery(pointer)
            else -> unknownCode(code)
        }
    }

    private fun readOnOffKey(pointer: Int): RomEffect {
        val held = BrickButton.ON_OFF in buttons.pressed
        memory.writeShort(pointer, if (held) 0 else RELEASED)
        return RomEffect("the On-Off key is ${if (held) "held down" else "up"}")
    }

    private fun readBattery(pointer: Int): RomEffect {
        memory.writeShort(pointer, FULL_BATTERY)
        return RomEffect("the battery measures $FULL_BATTERY")
    }

    companion object {
        /** The measured value of a battery of 9.0 volts, of 1023. Source: leJOS `Battery.java`, 43988 / 1560 millivolts a unit. */
        const val FULL_BATTERY = 320

        /** What the On-Off key reads when nobody presses it: the bit of its processor pin. Any value but 0 means this. */
        const val RELEASED = 2

        private val BITS = mapOf(BrickButton.RUN to 1, BrickButton.VIEW to 2, BrickButton.PRGM to 4)
        private val NAMES = mapOf(BrickButton.RUN to "Run", BrickButton.VIEW to "View", BrickButton.PRGM to "Prgm")
    }
}
