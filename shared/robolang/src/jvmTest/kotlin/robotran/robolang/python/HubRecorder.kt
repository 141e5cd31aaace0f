package robotran.robolang.python

import robotran.hub.model.HubButton
import robotran.hub.model.HubColor
import robotran.hub.model.HubDeviceKind
import robotran.hub.model.HubModel
import robotran.hub.model.HubPort
import robotran.hub.program.DriveBaseSettings
import robotran.hub.program.Hub
import robotran.hub.program.HubCall
import robotran.hub.program.HubDriveBaseView
import robotran.hub.program.HubError
import robotran.hub.program.HubMotorView
import robotran.hub.program.HubNative
import robotran.hub.program.HubReading
import robotran.hub.program.LightMode
import kotlin.math.abs

/**
 * A hub that moves nothing: it keeps the calls that a program makes, takes the time for them that the fake modules in
 * Python take, and measures what they measure.
 */
internal class HubRecorder(override val model: HubModel) : Hub {
    val calls = mutableListOf<String>()

    /** The line of the program that made each of the [calls]. */
    val sourceLines = mutableListOf<Int>()
    private val devices = mutableMapOf<HubPort, HubDeviceKind>()
    private val motors = mutableMapOf<HubPort, Motor>()
    private var base: Base? = null

    override var milliseconds: Long = 0
    override val driveBase: HubDriveBaseView? get() = base
    override val batteryMillivolts: Int get() = 7500
    override val heading: Double? get() = null
    override val beepMillisecondsLeft: Int get() = 0
    override val textMillisecondsLeft: Int get() = 0

    override fun call(call: HubCall, sourceLine: Int, sourceFile: String?): HubError? {
        calls += "$call"
        sourceLines += sourceLine
        val numbers = call.numbers
        when (call.native) {
            HubNative.DEVICE -> make(checkNotNull(call.port), HubDeviceKind.entries[numbers[1]])
            HubNative.DRIVE_BASE_CREATE -> base = Base()
            HubNative.DRIVE_BASE_SETTINGS -> if (numbers.any { it == 0 }) return HubError.INVALID_ARGUMENT
            HubNative.DRIVE_BASE_STRAIGHT, HubNative.DRIVE_BASE_TURN -> base?.move(abs(numbers[0]))
            HubNative.DRIVE_BASE_DRIVE -> base?.drive()
            HubNative.DRIVE_BASE_BRAKE, HubNative.DRIVE_BASE_STOP -> base?.move(0)
            else -> call.port?.let { motors[it] }?.order(call)
        }
        return null
    }

    private fun make(port: HubPort, kind: HubDeviceKind) {
        devices[port] = kind
        if (kind == HubDeviceKind.MOTOR) motors[port] = Motor()
    }

    override fun motor(port: HubPort): HubMotorView? = motors[port]

    override fun sensor(port: HubPort): HubReading? = when (devices[port]) {
        HubDeviceKind.COLOR_SENSOR, HubDeviceKind.LIGHT_SENSOR -> {
            val light = if (milliseconds % 2600 >= 1300) 20 else 60
            val each = light * HubReading.BRIGHTEST / 100 + 1
            HubReading.Light(each, each, each, ambient = light)
        }

        HubDeviceKind.ULTRASONIC_SENSOR -> HubReading.Distance(if (milliseconds % 5000 >= 3000) 150 else 900)
        HubDeviceKind.FORCE_SENSOR, HubDeviceKind.TOUCH_SENSOR -> touch(port)
        HubDeviceKind.SOUND_SENSOR -> HubReading.Sound(if (milliseconds % 3000 >= 2000) 80 else 10)
        HubDeviceKind.MOTOR, null -> null
    }

    private fun touch(port: HubPort): HubReading {
        val first = if (port == HubPort.E || port == HubPort.S1) 1500 else 2700
        return HubReading.Force(if (milliseconds % 4000 in first..<first + 300) 50 else 0)
    }

    override fun brightness(port: HubPort, mode: LightMode): Int? =
        (sensor(port) as? HubReading.Light)?.brightness(mode)

    override fun color(port: HubPort): HubColor = COLORS[(milliseconds / 700 % 6).toInt()]

    override val pressed: Set<HubButton>
        get() = PRESSES.filterValues { first -> milliseconds % 3000 in first..<first + 400 }.keys

    private inner class Base : HubDriveBaseView {
        private var until = 0L
        override var commands = 0
            private set

        override val isDone: Boolean get() = milliseconds >= until
        override val distance = 0
        override val angle = 0.0
        override val speed = 0
        override val turnRate = 0
        override val isStalled = false
        override val settings = DriveBaseSettings(1, 1, 1, 1)
        override val straightLimit = Int.MAX_VALUE
        override val turnLimit = Int.MAX_VALUE

        /** A millimetre and a degree take the same time. */
        fun move(amount: Int) {
            commands++
            until = milliseconds + amount * MS_OF_MOVE
        }

        fun drive() {
            commands++
            until = Long.MAX_VALUE
        }
    }

    private inner class Motor : HubMotorView {
        private var rest = 0
        private var since = 0L
        private var until = 0L
        override var speed = 0
            private set
        override var commands = 0
            private set
        override val isDone: Boolean get() = speed == 0 && milliseconds >= until
        override val angle: Int get() = rest + Math.floorDiv(speed * (milliseconds - since), 1000L).toInt()
        override val isStalled = false

        fun order(call: HubCall) {
            rest = angle
            speed = 0
            since = milliseconds
            until = 0
            commands++
            when (call.native) {
                HubNative.MOTOR_RUN -> speed = call.numbers[1]
                HubNative.MOTOR_RUN_ANGLE -> turn(call.numbers[2])
                HubNative.MOTOR_RUN_TARGET -> turn(call.numbers[2] - rest)
                HubNative.MOTOR_RESET_ANGLE -> rest = call.numbers[1]
                else -> Unit
            }
        }

        private fun turn(degrees: Int) {
            until = milliseconds + abs(degrees) * MS_OF_TURN
            rest += degrees
        }
    }

    private companion object {
        /** How long a millimetre or a degree of the base takes in the fake modules, and a degree of a motor. */
        const val MS_OF_MOVE = 5L
        const val MS_OF_TURN = 2L
        val PRESSES = mapOf(HubButton.LEFT to 600, HubButton.RIGHT to 1200, HubButton.CENTER to 1800)
        val COLORS =
            listOf(HubColor.WHITE, HubColor.RED, HubColor.BLACK, HubColor.YELLOW, HubColor.BLUE, HubColor.GREEN)
    }
}
