package robotran.legofirmware.device

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode

/** What the firmware does with the ROM when the brick is switched on and off. */
internal class PowerRoutines(private val calls: RomCalls) {
    /** Initializes the hardware after the brick was off. */
    fun initialize() {
        calls.call(RomAddress.INIT_TIMER, TIMERS, HANDLER_FLAGS)
        calls.call(RomAddress.INIT_POWER)
        calls.call(RomAddress.INIT_SENSORS)
        calls.call(RomAddress.INIT_SERIAL, 0, 0, 1, 1)
    }

    /** Puts everything to sleep until On-Off is pressed. */
    fun shutDown() {
        calls.call(RomAddress.SHUTDOWN_SENSORS)
        calls.call(RomAddress.SHUTDOWN_BUTTONS)
        calls.call(RomAddress.SHUTDOWN_TIMER)
        calls.call(RomAddress.POWER_OFF)
    }

    fun clearDisplay() = calls.call(RomAddress.CLEAR_LCD)

    fun refreshDisplay() = calls.call(RomAddress.REFRESH_LCD)

    /** Queues a system sound of the brick itself. */
    fun play(systemSound: Int) = calls.call(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_QUEUED, systemSound)

    /** Plays a system sound of the brick itself, in place of all others. */
    fun playNow(systemSound: Int) = calls.call(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_NOW, systemSound)

    private companion object {
        /** Where the ROM counts for the firmware: its flags, six bytes, and its timers, 40 bytes. */
        const val HANDLER_FLAGS = 0x8028
        const val TIMERS = 0x8030
    }
}
