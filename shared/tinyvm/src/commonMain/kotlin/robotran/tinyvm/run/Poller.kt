package robotran.tinyvm.run

import robotran.rom.RomAddress
import robotran.rom.RomCall
import robotran.rom.RomCode
import robotran.rom.SensorCode
import robotran.rom.SensorRequest
import robotran.tinyvm.link.LinkedClass

/**
 * Tells the program what changed at the sensors and buttons, as josx `Poll` wants it: the bits of what changed are added to the field
 * `changed` of the object it registered, and all threads that wait for it are woken. Source: leJOS `poll.c`.
 */
internal class Poller(private val machine: Machine) {
    private val values = IntArray(SensorCode.PORTS)
    private var buttons = 0
    private var throttle = 1
    private var lastLook = -1L
    private var changedField = -1

    /** The registered object, 0 for none. */
    var reference = 0
        private set

    /** Whether somebody wants to know. */
    val isActive: Boolean get() = changedField >= 0

    fun register(poller: Int) {
        val type = machine.heap.typeOf(poller) as? LinkedClass
        val field = type?.findField("changed", "S", isStatic = false) ?: type?.findField("changed", "I", isStatic = false)
        reference = poller
        changedField = field?.slot ?: -1
        lastLook = machine.rom.milliseconds
        readSensors()
        buttons = readButtons()
    }

    /** Looks at the sensors only every so many times. */
    fun setThrottle(times: Int) {
        throttle = times.coerceAtLeast(1)
    }

    /** Looks, if it is time to. */
    fun look() {
        val now = machine.rom.milliseconds
        if (!isActive || now < lastLook + MachineConstants.POLL_MILLISECONDS * throttle || !machine.monitors.isFree(reference)) return
        lastLook = now
        val pressed = readButtons()
        val changed = readSensors() or ((pressed xor buttons) shl FIRST_BUTTON_BIT)
        buttons = pressed
        if (changed == 0) return
        val field = reference + Heap.HEADER_WORDS + changedField
        machine.heap.words[field] = machine.heap.words[field] or changed
        machine.scheduler.notify(reference, all = true)
    }

    private fun readSensors(): Int {
        var changed = 0
        for (port in values.indices) {
            val value = machine.rom.readSensor(port, SensorRequest.CANONICAL)
            if (value != values[port]) changed = changed or (1 shl port)
            values[port] = value
        }
        return changed
    }

    private fun readButtons(): Int {
        machine.rom.call(RomCall(RomAddress.READ_BUTTONS, listOf(RomCode.BUTTONS, MachineConstants.BUTTONS_VARIABLE)), 0)
        return machine.rom.memory.readShort(MachineConstants.BUTTONS_VARIABLE)
    }

    private companion object {
        /** josx `Poll.BUTTON_MASK_SHIFT`. */
        const val FIRST_BUTTON_BIT = 3
    }
}
