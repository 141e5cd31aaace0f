package robotran.rcxrom.infrared

import robotran.rcxrom.call.RomCode
import robotran.rcxrom.clock.Clock
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.memory.Registers
import robotran.rcxrom.memory.SerialMemory

/**
 * The infrared of a brick: sending, receiving, and the state of both in the ROM's memory, where leJOS and josx read it.
 * A brick does not hear its own light: while it sends, it discards incoming bytes. Source: brickEmu's ROM
 * re-implementation.
 *
 * @param clock the brick's clock.
 */
internal class Serial(private val memory: RcxMemory, private val port: InfraredPort, private val clock: Clock) {
    private val sender = InfraredSender(port)
    private val receiver = SerialReceiver(memory)
    private var runs = true

    /** The port past the ROM. */
    val line = RawSerial(memory, port, clock) { port.range = range }

    init {
        begin(flagPointer = 0, timerPointer = 0, usesHeader = 1, usesComplements = 1)
    }

    val isSending: Boolean get() = memory.readByte(SerialMemory.SEND_STATE) != SerialMemory.IDLE

    val range: InfraredRange
        get() = if (memory.readByte(Registers.PORT_4) and Registers.RANGE_SHORT_BIT != 0) {
            InfraredRange.SHORT
        } else {
            InfraredRange.LONG
        }

    /** Resets the infrared: nothing received, nothing to send. */
    fun begin(flagPointer: Int, timerPointer: Int, usesHeader: Int, usesComplements: Int) {
        sender.stop()
        line.end()
        for (address in SerialMemory.ALL) memory.writeByte(address, 0)
        memory.writeByte(SerialMemory.USES_HEADER, usesHeader)
        memory.writeByte(SerialMemory.USES_COMPLEMENTS, usesComplements)
        memory.writeByte(SerialMemory.SEND_STATE, SerialMemory.IDLE)
        memory.writeShort(SerialMemory.FLAG_POINTER, flagPointer)
        memory.writeShort(SerialMemory.TIMER_POINTER, timerPointer)
        memory.writeShort(SerialMemory.SEQUENCE_NUMBER, SerialMemory.NO_SEQUENCE)
        receiver.reset()
        setRange(InfraredRange.SHORT)
        runs = true
    }

    /** Stops sending and receiving. */
    fun shutdown() {
        sender.stop()
        line.end()
        memory.writeByte(SerialMemory.SEND_STATE, SerialMemory.IDLE)
        setRange(InfraredRange.LONG)
        runs = false
    }

    fun setRange(range: InfraredRange) = memory.setBits(
        Registers.PORT_4,
        Registers.RANGE_SHORT_BIT,
        range == InfraredRange.SHORT,
    )

    /** The result of a send request. */
    enum class Sending { BEGUN, BUSY, OFF }

    /** Copies the [length] bytes at [address], 1..[SerialMemory.MAX_SHORT_BYTES], and starts sending them. */
    fun sendShort(address: Int, length: Int): Sending {
        if (!isFree()) return whyNot()
        val message = List(length) { memory.readByte(address + it) }
        val packet = framed(message)
        packet.forEachIndexed { place, byte -> memory.writeByte(SerialMemory.OUTGOING + place, byte) }
        begin(packet.size, RomCode.SEND_SHORT) { memory.readByte(SerialMemory.OUTGOING + it) }
        return Sending.BEGUN
    }

    /**
     * Starts sending an answer to [opcode] with the [length] bytes at [address]; reads each byte during transmission.
     */
    fun sendLong(opcode: Int, address: Int, length: Int): Sending {
        if (!isFree()) return whyNot()
        val reply = opcode.inv() and BYTE
        val head = framed(listOf(reply)).dropLast(sumBytes)
        memory.writeShort(SerialMemory.SEND_POINTER, address)
        memory.writeByte(SerialMemory.SEND_SUM, reply)
        begin(head.size + (length + 1) * sumBytes, RomCode.SEND_LONG) { place ->
            if (place < head.size) head[place] else longByte(place - head.size, address, length)
        }
        return Sending.BEGUN
    }

    /** Takes a received message like the ROM: copies up to [longest] bytes to [address] and returns how many. */
    fun take(address: Int, longest: Int): Int {
        var count = 0
        var from = memory.readByte(SerialMemory.UNPACK_INDEX) % SerialMemory.INCOMING_BYTES
        val end = memory.readByte(SerialMemory.RECEIVE_INDEX) % SerialMemory.INCOMING_BYTES
        while (count < longest && from != end) {
            memory.writeByte(address + count, memory.readByte(SerialMemory.INCOMING + from))
            from = (from + 1) % SerialMemory.INCOMING_BYTES
            count++
        }
        memory.writeByte(SerialMemory.UNPACK_INDEX, from)
        memory.writeByte(SerialMemory.VALID, 0)
        return count
    }

    /** Advances by a millisecond in which the processor sleeps: incoming bytes are lost. */
    fun sleep() {
        while (port.hear(clock.milliseconds()) != null) continue
    }

    /** Advances by one millisecond. */
    fun tick() {
        val now = clock.milliseconds()
        if (line.isActive) return line.tick(now)
        var byte = port.hear(now)
        while (byte != null) {
            hear(byte)
            byte = port.hear(now)
        }
        if (!isSending) return
        sender.tick(now)
        memory.writeShort(SerialMemory.SEND_REMAINING, sender.remaining)
        if (sender.remaining == 0) memory.writeByte(SerialMemory.SEND_STATE, SerialMemory.IDLE)
    }

    private fun hear(byte: ReceivedByte) {
        when {
            !runs -> Unit
            isSending -> receiver.forget()
            byte.damaged -> receiver.damaged()
            else -> receiver.receive(byte.value)
        }
    }

    private val usesComplements: Boolean get() = memory.readByte(SerialMemory.USES_COMPLEMENTS) != 0

    /** Bytes transmitted for each byte of a message. */
    private val sumBytes: Int get() = if (usesComplements) 2 else 1

    private val isOn: Boolean get() = runs && !line.isActive

    private fun isFree() = isOn && !isSending

    private fun whyNot() = if (isOn) Sending.BUSY else Sending.OFF

    private fun framed(message: List<Int>): List<Int> {
        val packet = InfraredPacket.encode(message)
        val header = if (memory.readByte(SerialMemory.USES_HEADER) == 0) emptyList() else InfraredPacket.HEADER
        val body = packet.drop(InfraredPacket.HEADER.size)
        return header + if (usesComplements) body else body.filterIndexed { place, _ -> place % 2 == 0 }
    }

    private fun longByte(index: Int, address: Int, length: Int): Int {
        val isComplement = index % sumBytes == 1
        val number = index / sumBytes
        val value = if (number < length) memory.readByte(address + number) else memory.readByte(SerialMemory.SEND_SUM)
        if (number < length && !isComplement) {
            memory.writeByte(SerialMemory.SEND_SUM, memory.readByte(SerialMemory.SEND_SUM) + value)
        }
        return if (isComplement) value.inv() and BYTE else value
    }

    private fun begin(length: Int, kind: Int, byteAt: (Int) -> Int) {
        memory.writeShort(SerialMemory.SEND_KIND, kind)
        memory.writeShort(SerialMemory.SEND_REMAINING, length)
        memory.writeByte(SerialMemory.SEND_STATE, SerialMemory.SENDING)
        port.range = range
        sender.begin(clock.milliseconds(), length) { place ->
            memory.writeByte(SerialMemory.SEND_INDEX, place + 1)
            byteAt(place)
        }
    }

    private companion object {
        const val BYTE = 0xFF
    }
}
