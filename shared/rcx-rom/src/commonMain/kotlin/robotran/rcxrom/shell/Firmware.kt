package robotran.rcxrom.shell

import robotran.brick.controls.MotorMode
import robotran.brick.kind.BrickKind
import robotran.brick.program.ProgramFailure
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.controls.romCode
import robotran.rcxrom.memory.FirmwareMemory
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.Battery
import robotran.rcxrom.sound.Speaker

/** The ROM calls of the firmware itself, as in leJOS `main.c`; in the log they have no source line. */
internal class Firmware(private val rom: Rom, private val speaker: Speaker) {
    /** Initializes the hardware after the brick was off. */
    fun initialize() {
        call(RomAddress.INIT_TIMER, FirmwareMemory.TIMERS, FirmwareMemory.HANDLER_FLAGS)
        call(RomAddress.INIT_POWER)
        call(RomAddress.INIT_SENSORS)
        initializeSerial()
    }

    /** Gives the infrared to the ROM, with nothing received and nothing to send. */
    fun initializeSerial() = call(RomAddress.INIT_SERIAL, 0, 0, 1, 1)

    /** Puts everything to sleep until On-Off is pressed. */
    fun shutDown() {
        call(RomAddress.SHUTDOWN_SENSORS)
        call(RomAddress.SHUTDOWN_BUTTONS)
        call(RomAddress.SHUTDOWN_TIMER)
        call(RomAddress.POWER_OFF)
    }

    /**
     * Shows the battery's volts and the number of the program that Run starts, with the standing man if there is one.
     */
    fun showReady(slot: Int, programIsLoaded: Boolean) {
        call(RomAddress.CLEAR_LCD)
        call(RomAddress.READ_POWER_STATUS, RomCode.BATTERY, FirmwareMemory.RESULT)
        val tenths = Battery.screenTenths(rom.memory.readShort(FirmwareMemory.RESULT))
        call(RomAddress.SET_LCD_NUMBER, RomCode.LCD_SIGNED, tenths, RomCode.LCD_POINT_1)
        call(RomAddress.SET_LCD_NUMBER, RomCode.LCD_PROGRAM, slot, RomCode.LCD_POINT_NONE)
        if (programIsLoaded) call(RomAddress.SET_LCD_SEGMENT, RomCode.SEGMENT_STANDING_MAN)
        call(RomAddress.REFRESH_LCD)
    }

    /**
     * Shows the number of the program that Run starts.
     *
     * @param standingMan whether to show (true) or hide (false) the standing man; null leaves it unchanged.
     */
    fun showSlot(slot: Int, standingMan: Boolean?) {
        call(RomAddress.SET_LCD_NUMBER, RomCode.LCD_PROGRAM, slot, RomCode.LCD_POINT_NONE)
        if (standingMan == true) call(RomAddress.SET_LCD_SEGMENT, RomCode.SEGMENT_STANDING_MAN)
        if (standingMan == false) call(RomAddress.CLEAR_LCD_SEGMENT, RomCode.SEGMENT_STANDING_MAN)
        call(RomAddress.REFRESH_LCD)
    }

    fun showRunning() {
        call(RomAddress.CLEAR_LCD_SEGMENT, RomCode.SEGMENT_STANDING_MAN)
        call(RomAddress.SET_LCD_SEGMENT, RomCode.SEGMENT_WALKING_MAN)
        call(RomAddress.REFRESH_LCD)
    }

    /** Shows the numbers of an uncaught exception, over what the program has shown. */
    fun showFailure(failure: ProgramFailure) {
        call(RomAddress.SET_LCD_NUMBER, RomCode.LCD_UNSIGNED, failure.methodNumber, RomCode.LCD_POINT_NONE)
        call(RomAddress.SET_LCD_NUMBER, RomCode.LCD_PROGRAM, failure.exceptionNumber % FIGURES, RomCode.LCD_POINT_NONE)
        call(RomAddress.SET_LCD_SEGMENT, RomCode.SEGMENT_SENSOR_1_VIEW)
        call(RomAddress.REFRESH_LCD)
    }

    fun showNothing() {
        call(RomAddress.CLEAR_LCD)
        call(RomAddress.REFRESH_LCD)
    }

    /** Queues a system sound. */
    fun play(systemSound: Int) =
        speaker.asFirmware { call(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_QUEUED, systemSound) }

    /** Plays a system sound at once and discards all others. */
    fun playNow(systemSound: Int) =
        speaker.asFirmware { call(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_NOW, systemSound) }

    /** Sets all motors to [mode] with power 0. */
    fun controlMotors(mode: MotorMode) =
        BrickKind.RCX.motorPorts.forEach { call(RomAddress.CONTROL_MOTOR, it.romCode, mode.code, 0) }

    /** Takes a received message; copies up to [longest] bytes to [FirmwareMemory.MESSAGE]. */
    fun receive(longest: Int) {
        rom.memory.writeByte(FirmwareMemory.RESULT, 0)
        call(RomAddress.RECEIVE_DATA, FirmwareMemory.MESSAGE, longest, FirmwareMemory.RESULT)
    }

    fun send(message: List<Int>) {
        message.forEachIndexed { place, byte -> rom.memory.writeByte(FirmwareMemory.MESSAGE + place, byte) }
        call(RomAddress.SEND_DATA, RomCode.SEND_SHORT, 0, FirmwareMemory.MESSAGE, message.size)
    }

    private fun call(address: Int, vararg arguments: Int) =
        rom.call(RomCall(address, arguments.toList()), NO_SOURCE_LINE)

    private companion object {
        const val NO_SOURCE_LINE = 0
        const val FIGURES = 10
    }
}
