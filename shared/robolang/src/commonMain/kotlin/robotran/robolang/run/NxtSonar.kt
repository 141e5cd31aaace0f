package robotran.robolang.run

import robotran.nxt.hardware.I2cStatus
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative

/**
 * An ultrasonic sensor on a port, from 0, with the messages and the pauses of leJOS NXJ's `UltrasonicSensor`. Messages
 * take time: [goOn] is called each millisecond until it says that they are done.
 */
internal class NxtSonar(private val nxt: Nxt, private val port: Int) {
    private val messages = ArrayDeque<Message>()
    private val answer = ByteArray(1)
    private var isUnderWay = false
    private var nextCommand = 0L
    private var nextData = 0L

    /** The last distance in centimetres. */
    var distance = NOTHING
        private set

    fun setUp(sourceLine: Int) {
        messages += Message(byteArrayOf(MODE, RESET), isReading = false, sourceLine)
        messages += Message(byteArrayOf(MODE, CONTINUOUS), isReading = false, sourceLine)
    }

    fun measure(sourceLine: Int) {
        messages += Message(byteArrayOf(FIRST_DISTANCE), isReading = true, sourceLine)
    }

    /** Goes on with the messages; returns whether there are none left. */
    fun goOn(): Boolean {
        while (true) {
            val message = messages.firstOrNull() ?: return true
            if (!isUnderWay && !begin(message)) return false
            if (isUnderWay && nxt.i2cStatus(port) == I2cStatus.BUSY) return false
            if (isUnderWay) end(message)
            messages.removeFirst()
        }
    }

    /** Sends [message] if its time has come. */
    private fun begin(message: Message): Boolean {
        val earliest = if (message.isReading) maxOf(nextCommand, nextData) else nextCommand
        if (nxt.milliseconds < earliest || nxt.i2cStatus(port) == I2cStatus.BUSY) return false
        val count = if (message.isReading) 1 else 0
        val call = NxtCall(NxtNative.I2C_START, intArrayOf(port, ADDRESS, count), bytes = message.bytes)
        isUnderWay = nxt.call(call, message.sourceLine) >= 0
        if (!isUnderWay && message.isReading) distance = NOTHING
        return true
    }

    private fun end(message: Message) {
        isUnderWay = false
        val count = nxt.i2cComplete(port, answer)
        nextCommand = nxt.milliseconds + COMMAND_DELAY
        if (message.isReading) distance = if (count == 1) answer[0].toInt() and BYTE else NOTHING
        if (count >= 0) nextData = nxt.milliseconds + DATA_DELAY
    }

    private class Message(val bytes: ByteArray, val isReading: Boolean, val sourceLine: Int)

    private companion object {
        const val ADDRESS = 2
        const val MODE: Byte = 0x41
        const val RESET: Byte = 4
        const val CONTINUOUS: Byte = 2
        const val FIRST_DISTANCE: Byte = 0x42
        const val NOTHING = 255
        const val BYTE = 0xFF
        const val COMMAND_DELAY = 5
        const val DATA_DELAY = 30
    }
}
