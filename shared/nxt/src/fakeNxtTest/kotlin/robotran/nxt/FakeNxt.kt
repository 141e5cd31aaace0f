package robotran.nxt

import robotran.nxt.bluetooth.BluetoothLink
import robotran.nxt.display.BitBlt
import robotran.nxt.display.ByteArrayMemory
import robotran.nxt.display.DisplayMemory
import robotran.nxt.display.DisplaySize
import robotran.nxt.display.Drawing
import robotran.nxt.display.NxtDisplay
import robotran.nxt.display.Picture
import robotran.nxt.hardware.NxtColour
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.regulator.MotorRegulator
import robotran.nxt.regulator.RegulatedMotor

/**
 * An NXT for tests of programs, without a brick: it keeps the calls, says what the test has told it, and has motors
 * that follow their power at once, at [degreesPerSecond] for each percent. Time passes only in [advance].
 */
class FakeNxt(private val degreesPerSecond: Double = 10.0, override val name: String = "NXT") : Nxt {
    /** All calls so far. */
    val calls: MutableList<NxtCall> = mutableListOf()

    /** The lines of the [calls]. */
    val lines: MutableList<Int> = mutableListOf()

    /** What the analog pins measure. */
    val analog: IntArray = IntArray(INPUTS) { OPEN }

    /** What colour sensors see; null if there is none. */
    val colours: Array<NxtColour?> = arrayOfNulls(INPUTS)

    /** What an I2C sensor answers to a message; null if there is none. */
    val answers: Array<((ByteArray) -> ByteArray)?> = arrayOfNulls(INPUTS)

    /** What [buttons] says. */
    var held = 0

    /** What [batteryStatus] says. */
    var millivolts = 8_000

    /** The robots that there are. */
    val robots: MutableSet<String> = mutableSetOf()

    override var milliseconds = 0L
        private set
    override var displayMemory: DisplayMemory = ByteArrayMemory(ByteArray(DisplaySize.BYTES))
    override var onStopRequest: (() -> Unit)? = null

    private val motors = List(MOTORS) { FakeMotor() }
    private val regulators = motors.map { MotorRegulator(it) }
    private val pins = Array(INPUTS) { BooleanArray(PINS) }
    private val received = arrayOfNulls<ByteArray>(INPUTS)
    private var soundEnd = 0L
    private var refreshed = 0L

    /** What a glass would show now. */
    val display: NxtDisplay get() = NxtDisplay.of(displayMemory)

    /** The power of a motor, -100..100. */
    fun power(motor: Int): Int = motors[motor].power

    fun advance(milliseconds: Int) = repeat(milliseconds) {
        this.milliseconds++
        motors.forEach { it.degrees += it.power * degreesPerSecond / SECOND }
        if (this.milliseconds % MotorRegulator.PERIOD == 0L) regulators.forEach { it.tick() }
    }

    override fun call(call: NxtCall, sourceLine: Int, sourceFile: String?): Int {
        calls += call
        lines += sourceLine
        val n = call.numbers
        when (call.native) {
            NxtNative.CONTROL_MOTOR -> motors[n[0]].control(n[1], brakes = n[2] != 0)
            NxtNative.RESET_TACHO_COUNT -> reset(n[0])
            NxtNative.REGULATE -> return bit(regulators[n[0]].start(call.speed, n[2], n[3], hold = n[4] != 0))
            NxtNative.REGULATOR_SPEED -> regulators[n[0]].setSpeed(call.speed)
            NxtNative.REGULATOR_ACCELERATION -> regulators[n[0]].setAcceleration(n[1])
            NxtNative.REGULATOR_ROLL -> regulators[n[0]].roll()
            NxtNative.REGULATOR_SUSPEND -> return bit(regulators[n[0]].suspend())
            NxtNative.REGULATOR_STALL -> regulators[n[0]].setStallThreshold(n[1], n[2])
            NxtNative.SET_SENSOR_PIN -> pins[n[0]][n[1]] = n[2] != 0
            NxtNative.I2C_START -> received[n[0]] = answers[n[0]]?.invoke(call.bytes ?: NO_BYTES)
            NxtNative.DRAW_STRING -> Drawing.drawString(displayMemory, call.text.orEmpty(), n[0], n[1], n[2] != 0)
            NxtNative.DRAW_INT -> Drawing.drawInt(displayMemory, n[0], n[1], n[2], n[3])
            NxtNative.CLEAR -> Drawing.clear(displayMemory)
            NxtNative.ASYNC_REFRESH -> refreshed = milliseconds + REFRESH_MILLISECONDS
            NxtNative.PLAY_FREQ -> soundEnd = milliseconds + n[1]
            NxtNative.PLAY_QUEUED_SAMPLE -> return call.bytes?.size ?: 0
            NxtNative.OPEN, NxtNative.OPEN_CABLE -> return if (call.text in robots) 0 else -1
            NxtNative.WRITE -> return call.bytes?.size ?: 0
            else -> Unit
        }
        return 0
    }

    override fun bitBlt(source: Picture, part: BitBlt, sourceLine: Int, sourceFile: String?) {
        part.draw(source, Picture(displayMemory, DisplaySize.WIDTH, DisplaySize.HEIGHT))
        calls += NxtCall.of(
            NxtNative.BIT_BLT,
            source.width,
            source.height,
            part.sourceX,
            part.sourceY,
            part.targetX,
            part.targetY,
            part.width,
            part.height,
            part.operation,
        )
        lines += sourceLine
    }

    override fun tachoCount(motor: Int): Int = motors[motor].tachoCount

    override fun regulator(motor: Int): MotorRegulator = regulators[motor]

    override fun analog(port: Int): Int = analog[port]

    override fun pin(port: Int, pin: Int): Boolean = pins[port][pin]

    override fun i2cStatus(port: Int): Int = if (answers[port] == null) FAULT else 0

    override fun i2cComplete(port: Int, into: ByteArray): Int {
        val bytes = received[port] ?: return FAULT
        received[port] = null
        val count = minOf(bytes.size, into.size)
        bytes.copyInto(into, 0, 0, count)
        return count
    }

    override fun colour(port: Int): NxtColour? = colours[port]

    override fun buttons(): Int = held

    override fun batteryStatus(): Int = millivolts

    override fun readPage(page: Int, into: ByteArray): Boolean = false

    override fun soundMillisecondsLeft(): Int = maxOf(0L, soundEnd - milliseconds).toInt()

    override fun refreshCompleteTime(): Int = refreshed.toInt()

    override fun knowsRobot(name: String): Boolean = name in robots

    /** There are no links: what is sent to one is only kept in [calls]. */
    override fun link(number: Int): BluetoothLink? = null

    private fun reset(motor: Int) {
        regulators[motor].countReset()
        motors[motor].degrees = 0.0
    }

    private fun bit(isSet: Boolean) = if (isSet) 1 else 0

    private class FakeMotor : RegulatedMotor {
        var degrees = 0.0
        var power = 0
            private set

        override val tachoCount: Int get() = floorOf(degrees)

        override fun control(power: Int, brakes: Boolean) {
            this.power = power.coerceIn(-FULL, FULL)
        }

        private fun floorOf(value: Double): Int = if (value < 0) -((-value + ALMOST).toInt()) else value.toInt()
    }

    private companion object {
        const val MOTORS = 3
        const val INPUTS = 4
        const val PINS = 2
        const val OPEN = 1023
        const val FULL = 100
        const val SECOND = 1000
        const val FAULT = -3
        const val REFRESH_MILLISECONDS = 6L

        /** For the whole number below one that is negative. */
        const val ALMOST = 0.999999
        val NO_BYTES = ByteArray(0)
    }
}
