package robotran.rcxrom.infrared

import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.memory.SerialMemory

/**
 * Assembles received bytes into messages, byte by byte like the ROM's interrupt handler; its whole state is in memory.
 * The opcode gives the length of a message. Source: brickEmu's ROM re-implementation.
 */
internal class SerialReceiver(private val memory: RcxMemory) {
    /** Waits for the next message. */
    fun reset() {
        memory.writeByte(SerialMemory.RECEIVE_STATE, HEADER)
        memory.writeByte(SerialMemory.LAST_BYTE, NO_BYTE)
    }

    /** Discards a received message that was not taken. */
    fun forget() {
        memory.writeByte(SerialMemory.UNPACK_INDEX, 0)
        memory.writeByte(SerialMemory.RECEIVE_INDEX, 0)
    }

    /** Handles a damaged byte. */
    fun damaged() {
        if (memory.readByte(SerialMemory.RECEIVE_STATE) !in
            TRANSFER_SUM..TRANSFER
        ) {
            memory.writeByte(SerialMemory.RECEIVE_STATE, HEADER)
        }
        restartTimer()
    }

    fun receive(byte: Int) {
        if (memory.readWord(memory.readWord(SerialMemory.TIMER_POINTER)) == 0) {
            memory.writeByte(SerialMemory.EXPECTS_COMPLEMENT, 0)
            reset()
        }
        restartTimer()
        val usesComplements = memory.readByte(SerialMemory.USES_COMPLEMENTS) != 0
        if (usesComplements && memory.readByte(SerialMemory.EXPECTS_COMPLEMENT) != 0) return receiveComplement(byte)
        when (memory.readByte(SerialMemory.RECEIVE_STATE)) {
            HEADER -> receiveOpcode(byte)
            OPERANDS -> receiveOperand(byte)
            SUM -> receiveSum(byte, usesComplements)
            TRANSFER_SUM -> receiveTransferSum(byte)
            TRANSFER -> receiveTransfer(byte)
            else -> reset()
        }
    }

    private fun receiveComplement(byte: Int) {
        memory.writeByte(SerialMemory.EXPECTS_COMPLEMENT, 0)
        when {
            byte xor BYTE != memory.readByte(SerialMemory.LAST_BYTE) -> reset()
            memory.readByte(SerialMemory.RECEIVE_STATE) == COMPLETE -> completeMessage()
        }
    }

    private fun receiveOpcode(byte: Int) {
        if (memory.readByte(SerialMemory.USES_HEADER) != 0 && byte in InfraredPacket.HEADER) return
        memory.writeByte(SerialMemory.UNPACK_INDEX, 0)
        memory.writeByte(SerialMemory.RECEIVE_INDEX, 0)
        memory.writeByte(SerialMemory.RECEIVE_SUM, 0)
        keep(byte)
        val operands = operandsOf(byte)
        memory.writeByte(SerialMemory.RECEIVE_REMAINING, if (isTransfer(byte)) TRANSFER_HEAD else operands)
        memory.writeByte(SerialMemory.TRANSFER_SUM, 0)
        memory.writeByte(
            SerialMemory.RECEIVE_STATE,
            if (operands == 0) {
                SUM
            } else if (isTransfer(byte)) {
                TRANSFER
            } else {
                OPERANDS
            },
        )
    }

    private fun receiveOperand(byte: Int) {
        keep(byte)
        val remaining = memory.readByte(SerialMemory.RECEIVE_REMAINING) - 1
        memory.writeByte(SerialMemory.RECEIVE_REMAINING, remaining)
        if (remaining == 0) memory.writeByte(SerialMemory.RECEIVE_STATE, SUM)
    }

    private fun receiveSum(byte: Int, usesComplements: Boolean) {
        val isRight = byte == memory.readByte(SerialMemory.RECEIVE_SUM)
        note(byte)
        when {
            !isRight -> reset()
            usesComplements -> memory.writeByte(SerialMemory.RECEIVE_STATE, COMPLETE)
            else -> completeMessage()
        }
    }

    private fun receiveTransfer(byte: Int) {
        note(byte)
        memory.writeByte(SerialMemory.RECEIVE_SUM, memory.readByte(SerialMemory.RECEIVE_SUM) + byte)
        val headRemaining = memory.readByte(SerialMemory.RECEIVE_REMAINING)
        if (headRemaining == 0) return receiveTransferData(byte)
        store(byte)
        memory.writeByte(SerialMemory.RECEIVE_REMAINING, headRemaining - 1)
        if (headRemaining == 1) beginTransferData()
    }

    /**
     * A block that is repeated because its answer was lost goes to the same address again. The two sums replace the
     * length, as in leJOS `main.c` and `rom.h`; brickEmu keeps both.
     */
    private fun beginTransferData() {
        val sequence = littleWord(SerialMemory.INCOMING + 1)
        if (sequence == memory.readWord(SerialMemory.SEQUENCE_NUMBER)) {
            memory.writeShort(SerialMemory.TRANSFER_POINTER, memory.readWord(SerialMemory.TRANSFER_BEGIN))
        } else {
            memory.writeShort(SerialMemory.SEQUENCE_NUMBER, sequence)
            memory.writeShort(SerialMemory.TRANSFER_BEGIN, memory.readWord(SerialMemory.TRANSFER_POINTER))
        }
        memory.writeShort(SerialMemory.TRANSFER_REMAINING, littleWord(SerialMemory.INCOMING + LENGTH_PLACE))
        memory.writeByte(SerialMemory.RECEIVE_INDEX, LENGTH_PLACE)
    }

    private fun receiveTransferData(byte: Int) {
        val pointer = memory.readWord(SerialMemory.TRANSFER_POINTER)
        if (pointer != 0) {
            memory.writeByte(pointer, byte)
            memory.writeShort(SerialMemory.TRANSFER_POINTER, pointer + 1)
            memory.writeByte(SerialMemory.TRANSFER_SUM, memory.readByte(SerialMemory.TRANSFER_SUM) + byte)
        }
        val remaining = memory.readWord(SerialMemory.TRANSFER_REMAINING) - 1
        memory.writeShort(SerialMemory.TRANSFER_REMAINING, remaining)
        if (remaining == 0) memory.writeByte(SerialMemory.RECEIVE_STATE, TRANSFER_SUM)
    }

    /** Stores the sum from the sender and the computed sum of the block as operands of the message. */
    private fun receiveTransferSum(byte: Int) {
        keep(byte)
        store(memory.readByte(SerialMemory.TRANSFER_SUM))
        memory.writeByte(SerialMemory.RECEIVE_STATE, SUM)
    }

    private fun completeMessage() {
        memory.writeByte(SerialMemory.VALID, 1)
        memory.setBits(memory.readWord(SerialMemory.FLAG_POINTER), HANDLER_RUNS, on = true)
        reset()
    }

    /** Stores a byte of the message and adds it to the sum. */
    private fun keep(byte: Int) {
        store(byte)
        memory.writeByte(SerialMemory.RECEIVE_SUM, memory.readByte(SerialMemory.RECEIVE_SUM) + byte)
        note(byte)
    }

    private fun store(byte: Int) {
        val place = memory.readByte(SerialMemory.RECEIVE_INDEX) % SerialMemory.INCOMING_BYTES
        memory.writeByte(SerialMemory.INCOMING + place, byte)
        memory.writeByte(SerialMemory.RECEIVE_INDEX, (place + 1) % SerialMemory.INCOMING_BYTES)
    }

    private fun note(byte: Int) {
        memory.writeByte(SerialMemory.LAST_BYTE, byte)
        memory.writeByte(SerialMemory.EXPECTS_COMPLEMENT, 1)
    }

    private fun restartTimer() = memory.writeShort(memory.readWord(SerialMemory.TIMER_POINTER), TIMER_MILLISECONDS)

    private fun littleWord(address: Int): Int = memory.readByte(address) or (memory.readByte(address + 1) shl 8)

    companion object {
        /**
         * Number of bytes that follow an opcode. The opcode for transferred data carries its own length, see
         * [isTransfer].
         */
        fun operandsOf(opcode: Int): Int = (opcode and 7).let { if (it > 5) it - 6 else it }

        /**
         * Whether a message transfers data of any length: 0x45 and, because bit 3 only tells a message from its
         * repetition, 0x4d.
         */
        fun isTransfer(opcode: Int): Boolean = opcode and TOGGLE_BIT.inv() == 0x45

        /** Differs between two messages with the same opcode unless the second is a repetition. */
        const val TOGGLE_BIT = 0x08

        private const val HEADER = 2
        private const val OPERANDS = 3
        private const val SUM = 4
        private const val TRANSFER_SUM = 5
        private const val TRANSFER = 6
        private const val COMPLETE = 99
        private const val NO_BYTE = 0xFF
        private const val BYTE = 0xFF
        private const val TRANSFER_HEAD = 4
        private const val LENGTH_PLACE = 3
        private const val HANDLER_RUNS = 0x80

        /** The receiver drops a message if its next byte takes longer than this, where leJOS lets the ROM count. */
        private const val TIMER_MILLISECONDS = 30
    }
}
