package robotran.legofirmware.run

import robotran.legofirmware.device.Clocks
import robotran.legofirmware.device.Outputs
import robotran.legofirmware.device.Viewing
import robotran.legofirmware.model.Assumptions
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.SensorMode

/** Writes to the LCD what has changed since the last refresh, so that the log stays readable. */
internal class Display(private val core: Core) {
    private val calls get() = core.calls
    private val devices get() = core.devices
    private var number: MainNumber? = null
    private var slot: Int? = null
    private var figure: Int? = null
    private var quarters = 0
    private val segments = mutableSetOf<Int>()
    private var isLowBattery = false
    private var batteryCheckAt = 0L
    private var refreshAt = 0L

    /** @property format [RomCode.LCD_SIGNED] or [RomCode.LCD_UNSIGNED]. */
    private data class MainNumber(val format: Int, val value: Int, val decimals: Int)

    /** Forgets what is shown, after the LCD was cleared. */
    fun begin() {
        number = null
        slot = null
        figure = null
        quarters = 0
        segments.clear()
        refreshAt = 0
        batteryCheckAt = 0
    }

    /** Refreshes the LCD if it is time, or [atOnce]. */
    fun tick(isRunning: Boolean, atOnce: Boolean = false) {
        if (core.now < refreshAt && !atOnce) return
        refreshAt = core.now + Assumptions.DISPLAY_MILLISECONDS
        calls.asFirmware { if (show(isRunning)) calls.call(RomAddress.REFRESH_LCD) }
    }

    /** Returns whether anything has changed. */
    private fun show(isRunning: Boolean): Boolean = listOf(
        showNumber(),
        showSlot(),
        showFigure(isRunning),
        showDatalog(),
        showSegments(),
    ).any { it }

    private fun showNumber(): Boolean {
        val shown = mainNumber()
        if (shown == number) return false
        number = shown
        calls.call(RomAddress.SET_LCD_NUMBER, shown.format, shown.value, RomCode.LCD_POINT_NONE + shown.decimals)
        return true
    }

    private fun mainNumber(): MainNumber {
        val viewing = devices.viewing
        return when (val view = viewing.number) {
            in Viewing.FIRST_SENSOR until Viewing.FIRST_MOTOR -> sensor(view - Viewing.FIRST_SENSOR)

            in Viewing.FIRST_MOTOR..Viewing.LAST_PORT -> {
                MainNumber(RomCode.LCD_SIGNED, devices.outputs.powerOfMotor(view - Viewing.FIRST_MOTOR), 0)
            }

            Viewing.USER -> {
                val value = viewing.value?.let { (source, argument) ->
                    core.at(null)
                    core.values.read(source, argument, core.requests)
                }
                MainNumber(RomCode.LCD_SIGNED, value ?: 0, viewing.decimals)
            }

            else -> {
                val minutes = devices.clocks.watch
                val hours = minutes / Clocks.MINUTES_IN_HOUR
                val digits = hours * HUNDRED + minutes % Clocks.MINUTES_IN_HOUR
                MainNumber(RomCode.LCD_UNSIGNED, digits, WATCH_DECIMALS)
            }
        }
    }

    private fun sensor(port: Int): MainNumber {
        val mode = SensorMode.of(devices.inputs.mode(port))
        val decimals = if (mode == SensorMode.CELSIUS || mode == SensorMode.FAHRENHEIT) 1 else 0
        return MainNumber(RomCode.LCD_SIGNED, devices.inputs.value(port), decimals)
    }

    private fun showSlot(): Boolean {
        if (devices.slot == slot) return false
        slot = devices.slot
        calls.call(RomAddress.SET_LCD_NUMBER, RomCode.LCD_PROGRAM, devices.slot + 1, RomCode.LCD_POINT_NONE)
        return true
    }

    private fun showFigure(isRunning: Boolean): Boolean {
        val isWalking = isRunning && core.now / Assumptions.STEP_MILLISECONDS % 2 == 0L
        val shown = if (isWalking) RomCode.SEGMENT_WALKING_MAN else RomCode.SEGMENT_STANDING_MAN
        if (shown == figure) return false
        figure = shown
        calls.call(RomAddress.SET_LCD_SEGMENT, shown)
        return true
    }

    private fun showDatalog(): Boolean {
        val datalog = devices.datalog
        val shown = if (datalog.capacity == 0) 0 else datalog.used * QUARTERS / datalog.capacity
        if (shown == quarters) return false
        if (shown < quarters) calls.call(RomAddress.CLEAR_LCD_SEGMENT, RomCode.SEGMENT_DATALOG)
        val lit = if (shown < quarters) 0 else quarters
        repeat(shown - lit) { calls.call(RomAddress.SET_LCD_SEGMENT, RomCode.SEGMENT_DATALOG) }
        quarters = shown
        return true
    }

    private fun showSegments(): Boolean {
        val wanted = wantedSegments()
        val gone = segments - wanted
        val new = wanted - segments
        gone.forEach { calls.call(RomAddress.CLEAR_LCD_SEGMENT, it) }
        new.forEach { calls.call(RomAddress.SET_LCD_SEGMENT, it) }
        segments.clear()
        segments += wanted
        return gone.isNotEmpty() || new.isNotEmpty()
    }

    private fun wantedSegments(): Set<Int> = buildSet {
        val view = devices.viewing.number
        for (port in 0 until SensorCode.PORTS) {
            val viewed = RomCode.SEGMENT_SENSOR_1_VIEW + port * SENSOR_SEGMENTS
            if (view == port + Viewing.FIRST_SENSOR) add(viewed)
            if (devices.inputs.boolean(port) != 0) add(viewed + 1)
        }
        for (motor in 0 until Outputs.MOTORS) {
            val viewed = SEGMENT_MOTOR_A_VIEW + motor * MOTOR_SEGMENTS
            if (view == motor + Viewing.FIRST_MOTOR) add(viewed)
            val drivesForward = devices.outputs.drivesForward(motor)
            if (drivesForward != null) add(if (drivesForward) viewed + 2 else viewed + 1)
        }
        add(if (devices.infrared.isLong) RomCode.SEGMENT_INFRARED_LONG else RomCode.SEGMENT_INFRARED_SHORT)
        if (hasLowBattery()) add(RomCode.SEGMENT_LOW_BATTERY)
    }

    private fun hasLowBattery(): Boolean {
        if (core.now >= batteryCheckAt) {
            batteryCheckAt = core.now + Assumptions.BATTERY_MILLISECONDS
            isLowBattery = devices.power.readBattery() < Assumptions.LOW_BATTERY_MILLIVOLTS
        }
        return isLowBattery
    }

    private companion object {
        const val HUNDRED = 100
        const val WATCH_DECIMALS = 2
        const val QUARTERS = 4
        const val SENSOR_SEGMENTS = 2
        const val MOTOR_SEGMENTS = 3

        /** The segment that points at motor A; those of its directions and of the other motors follow. */
        const val SEGMENT_MOTOR_A_VIEW = 0x300E
    }
}
