package robotran.legofirmware.device

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.sensors.Battery

/** The battery, and when the brick switches itself off. */
internal class Power(private val calls: RomCalls) {
    /** Minutes without activity after which the brick switches itself off; 0 for never. */
    var offMinutes = OFF_MINUTES

    /** Whether a program wants the brick to be switched off. */
    var isOffRequested = false

    /** What the battery has now, in millivolts. */
    fun readBattery(): Int {
        calls.call(RomAddress.READ_POWER_STATUS, RomCode.BATTERY, RomCalls.RESULT)
        return Battery.millivolts(calls.rom.memory.readShort(RomCalls.RESULT))
    }

    /** Ignored while the brick never switches itself off. */
    fun requestOff() {
        if (offMinutes != 0) isOffRequested = true
    }

    private companion object {
        /** Source: LEGO's quick start. */
        const val OFF_MINUTES = 15
    }
}
