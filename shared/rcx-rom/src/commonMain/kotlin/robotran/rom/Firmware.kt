package robotran.rom

/** The ROM calls the firmware itself makes, as leJOS does in `main.c`; in the log they have no source line. */
internal class Firmware(private val rom: Rom) {
    /** Shows the battery's volts and the number of the program that Run will start, with the standing man if there is one. */
    fun showReady(slot: Int, programIsLoaded: Boolean) {
        call(RomAddress.CLEAR_LCD)
        call(RomAddress.READ_POWER_STATUS, RomCode.BATTERY, VARIABLE)
        val tenthsOfVolt = rom.memory.readShort(VARIABLE) * PERCENT / BATTERY_UNITS_FOR_A_TENTH_OF_A_VOLT
        call(RomAddress.SET_LCD_NUMBER, RomCode.LCD_SIGNED, tenthsOfVolt, RomCode.LCD_POINT_1)
        call(RomAddress.SET_LCD_NUMBER, RomCode.LCD_PROGRAM, slot, RomCode.LCD_POINT_NONE)
        if (programIsLoaded) call(RomAddress.SET_LCD_SEGMENT, RomCode.SEGMENT_STANDING_MAN)
        call(RomAddress.REFRESH_LCD)
    }

    fun showSlot(slot: Int) {
        call(RomAddress.SET_LCD_NUMBER, RomCode.LCD_PROGRAM, slot, RomCode.LCD_POINT_NONE)
        call(RomAddress.REFRESH_LCD)
    }

    fun showRunning() {
        call(RomAddress.CLEAR_LCD_SEGMENT, RomCode.SEGMENT_STANDING_MAN)
        call(RomAddress.SET_LCD_SEGMENT, RomCode.SEGMENT_WALKING_MAN)
        call(RomAddress.REFRESH_LCD)
    }

    fun showNothing() {
        call(RomAddress.CLEAR_LCD)
        call(RomAddress.REFRESH_LCD)
    }

    /** Queues a system sound. */
    fun play(systemSound: Int) = call(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_QUEUED, systemSound)

    /** Plays a system sound instead of all others. */
    fun playNow(systemSound: Int) = call(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_NOW, systemSound)

    /** Tells all motors to do [mode] with power 0. */
    fun controlMotors(mode: MotorMode) = MotorPort.entries.forEach { call(RomAddress.CONTROL_MOTOR, it.code, mode.code, 0) }

    private fun call(address: Int, vararg arguments: Int) = rom.call(RomCall(address, arguments.toList()), NO_SOURCE_LINE)

    private companion object {
        const val NO_SOURCE_LINE = 0

        /** A short in the firmware's own part of the memory, which begins at 0x8000, for results. */
        const val VARIABLE = 0x8000

        /** leJOS `main.c` shows `raw * 100 / 355` tenths of a volt. */
        const val PERCENT = 100
        const val BATTERY_UNITS_FOR_A_TENTH_OF_A_VOLT = 355
    }
}
