package robotran.rcxrom.routines

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.memory.Registers
import robotran.rcxrom.messages.BrickMessages

/** The routines for On-Off, the battery and sleep. */
internal class PowerRoutines(
    private val memory: RcxMemory,
    private val sleep: () -> Unit,
    private val messages: BrickMessages,
) {
    val routines: Map<Int, RomRoutine> = mapOf(
        RomAddress.READ_POWER_STATUS to ::readPowerStatus,
        RomAddress.INIT_POWER to { initPower() },
        RomAddress.POWER_OFF to { powerOff() },
        RomAddress.INIT_PORT_6_BIT_3 to { setUnknownPin("init port 6 bit 3", on = true) },
        RomAddress.SHUTDOWN_PORT_6_BIT_3 to { setUnknownPin("shutdown port 6 bit 3", on = false) },
    )

    private fun readPowerStatus(arguments: List<Int>): RomEffect {
        val (code, pointer) = arguments
        return when (code) {
            RomCode.ON_OFF_KEY -> readOnOffKey(pointer)
            RomCode.BATTERY -> readBattery(pointer)
            else -> refused(messages.unknownCode(code))
        }
    }

    private fun readOnOffKey(pointer: Int): RomEffect {
        val released = memory.readByte(Registers.PORT_4) and Registers.ON_OFF_RELEASED_BIT
        memory.writeShort(pointer, released)
        return RomEffect(messages.onOffKey(held = released == 0))
    }

    private fun readBattery(pointer: Int): RomEffect {
        val raw = memory.readWord(Registers.CONVERTER_OF_BATTERY) shr Registers.CONVERTER_SHIFT
        memory.writeShort(pointer, raw)
        return RomEffect(messages.battery(raw))
    }

    private fun initPower(): RomEffect {
        memory.setBits(Registers.PORT_5_DIRECTIONS, Registers.MEMORY_POWER_PIN, on = true)
        return RomEffect(messages.setUp("init power"))
    }

    private fun powerOff(): RomEffect {
        sleep()
        return RomEffect(messages.powerOff())
    }

    private fun setUnknownPin(routine: String, on: Boolean): RomEffect {
        memory.setBits(Registers.PORT_6_DIRECTIONS, Registers.UNKNOWN_PIN, on)
        return RomEffect(messages.setUp(routine))
    }
}
