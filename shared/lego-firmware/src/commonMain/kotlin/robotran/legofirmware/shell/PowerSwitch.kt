package robotran.legofirmware.shell

import robotran.legofirmware.device.PowerRoutines
import robotran.legofirmware.run.FirmwareMachine
import robotran.rcxrom.program.ShellHardware

/** Switches the brick on and off, also by itself when nobody has used it for some minutes. */
internal class PowerSwitch(private val machine: FirmwareMachine, private val hardware: ShellHardware) {
    private val devices = machine.core.devices
    private val routines = PowerRoutines(machine.core.calls)
    private var isSwitchingOff = false
    private var usedAt = 0L

    var isOn = false
        private set

    /** Whether a program wants it, or nobody has used the brick for long. */
    val isOffDue: Boolean
        get() {
            val minutes = devices.power.offMinutes
            val isIdle = minutes != 0 && hardware.rom.milliseconds - usedAt >= minutes * MINUTE
            return isIdle || devices.power.isOffRequested
        }

    /** Switches on for the first time, with the firmware just loaded. */
    fun begin() {
        start()
        machine.begin()
    }

    fun switchOn() {
        if (isSwitchingOff) finish()
        hardware.wake()
        start()
        devices.inputs.resume()
        machine.redraw()
    }

    /** Switches off; the processor sleeps after the last sound. */
    fun switchOff() {
        machine.core.at(null)
        isOn = false
        isSwitchingOff = true
        devices.power.isOffRequested = false
        devices.outputs.float()
        hardware.asFirmware { routines.playNow(CLICK) }
        routines.clearDisplay()
        routines.refreshDisplay()
    }

    fun tick() {
        if (isSwitchingOff && hardware.isSilent) finish()
    }

    /** Somebody uses the brick. */
    fun noteUse() {
        usedAt = hardware.rom.milliseconds
    }

    /** Queues a system sound of the brick itself. */
    fun play(systemSound: Int) {
        machine.core.at(null)
        hardware.asFirmware { routines.play(systemSound) }
    }

    private fun start() {
        machine.core.at(null)
        if (!hardware.timerRuns) routines.initialize()
        routines.clearDisplay()
        play(TWO_BEEPS)
        isOn = true
        noteUse()
    }

    private fun finish() {
        isSwitchingOff = false
        machine.core.at(null)
        routines.shutDown()
    }

    private companion object {
        const val MINUTE = 60_000L

        /** System sounds of the ROM. */
        const val CLICK = 0
        const val TWO_BEEPS = 1
    }
}
