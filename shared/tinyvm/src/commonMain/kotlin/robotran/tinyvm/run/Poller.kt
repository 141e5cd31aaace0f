package robotran.tinyvm.run

import robotran.brick.controls.BrickButton
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.SensorRequest
import robotran.tinyvm.link.LinkedClass

/**
 * Reports changes of the sensors and buttons as josx `Poll` expects: it adds the bits of changed inputs to the first
 * field of the registered object and wakes all threads that wait for it. Polling is no ROM call. Source: leJOS
 * `poll.c`.
 */
internal class Poller(private val machine: VirtualMachine, private val rom: Rom) {
    private val values = IntArray(SensorCode.PORTS)
    private var buttons = 0
    private var hadMessage = false
    private var throttle = 1
    private var lastReading = -1L
    private var changedField = -1
    private val hasMode = BooleanArray(SensorCode.PORTS)

    /** The registered object, 0 for none. */
    var reference = 0
        private set

    /** Whether a poller is registered. */
    val isActive: Boolean get() = changedField >= 0

    /** Registers the object [poller]. On a brick, the sensors change only from what they measure now. */
    fun register(poller: Int) {
        val field = (machine.heap.typeOf(poller) as? LinkedClass)?.instanceFields?.firstOrNull()
        reference = poller
        changedField = field?.takeIf { it.descriptor == "S" }?.slot ?: -1
        if (machine.model.hasQuirks) for (port in values.indices) values[port] = valueOf(port)
    }

    /** Polls only once in [readings] readings of the sensors. */
    fun setThrottle(readings: Int) {
        throttle = readings.coerceAtLeast(1)
    }

    /** Polls if it is due and no thread is inside the registered object's monitor. */
    fun poll() {
        val reading = rom.milliseconds / SensorCode.READING_MILLISECONDS
        if (!isActive || reading < lastReading + throttle || !machine.monitors.isFree(reference)) return
        lastReading = reading
        val changed = changedSensors() or changedButtons() or changedMessage()
        if (changed == 0) return
        val field = reference + Heap.HEADER_WORDS + changedField
        machine.heap.words[field] = (machine.heap.words[field] or changed).toShort().toInt()
        machine.scheduler.notify(reference, all = true)
    }

    private fun changedSensors(): Int {
        var changed = 0
        for (port in values.indices) {
            val value = valueOf(port)
            if (value != values[port]) changed = changed or (1 shl port)
            values[port] = value
        }
        return changed
    }

    /** Notes that the program has set the mode of the sensor at [port]. */
    fun modeSet(port: Int) {
        hasMode[port] = true
    }

    /** What the sensor at [port] measures. On a brick its mode is raw until the program sets one. */
    private fun valueOf(port: Int): Int {
        val isRaw = machine.model.hasQuirks && !hasMode[port]
        return rom.readSensor(port, if (isRaw) SensorRequest.RAW else SensorRequest.CANONICAL)
    }

    private fun changedButtons(): Int {
        val pressed = rom.pressedButtons.sumOf { BUTTON_BITS[it] ?: 0 }
        val changed = pressed xor buttons
        buttons = pressed
        return changed
    }

    private fun changedMessage(): Int {
        val hasMessage = rom.hasMessage
        val isNew = hasMessage && !hadMessage
        hadMessage = hasMessage
        return if (isNew) MESSAGE_BIT else 0
    }

    private companion object {
        /** Source: josx `Poll`, RUN_MASK, VIEW_MASK, PRGM_MASK and SERIAL_MASK. */
        val BUTTON_BITS = mapOf(BrickButton.RUN to 0x08, BrickButton.VIEW to 0x10, BrickButton.PRGM to 0x20)
        const val MESSAGE_BIT = 0x40
    }
}
