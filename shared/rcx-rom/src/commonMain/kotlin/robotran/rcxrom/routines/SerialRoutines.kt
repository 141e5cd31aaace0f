package robotran.rcxrom.routines

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.infrared.InfraredRange
import robotran.rcxrom.infrared.Serial
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.memory.SerialMemory
import robotran.rcxrom.messages.BrickMessages

/** The routines for the infrared, and the one that it shares with tones. */
internal class SerialRoutines(
    private val memory: RcxMemory,
    private val serial: Serial,
    private val sounds: SoundRoutines,
    private val messages: BrickMessages,
) {
    val routines: Map<Int, RomRoutine> = mapOf(
        RomAddress.INIT_SERIAL to ::init,
        RomAddress.SHUTDOWN_SERIAL to { shutdown() },
        RomAddress.SET_RANGE_LONG to { (code) -> setRange(code, InfraredRange.LONG) },
        RomAddress.SET_RANGE_SHORT to { (code) -> setRange(code, InfraredRange.SHORT) },
        RomAddress.PLAY_TONE to ::playTone,
        RomAddress.CHECK_FOR_DATA to ::check,
        RomAddress.RECEIVE_DATA to ::receive,
        RomAddress.SEND_DATA to ::send,
    )

    private fun init(arguments: List<Int>): RomEffect {
        val (flag, timer, header, complements) = arguments
        serial.begin(flag, timer, header, complements)
        return RomEffect(messages.startInfrared())
    }

    private fun shutdown(): RomEffect {
        serial.shutdown()
        return RomEffect(messages.stopInfrared())
    }

    private fun setRange(code: Int, range: InfraredRange): RomEffect {
        if (code != RomCode.RANGE) return refused(messages.unknownCode(code))
        serial.setRange(range)
        return RomEffect(messages.infraredRange(range))
    }

    private fun playTone(arguments: List<Int>): RomEffect {
        val (code, first, last) = arguments
        return when (code) {
            RomCode.TONE -> sounds.queueTone(first, last)
            RomCode.TONE_SYSTEM_SOUND -> sounds.queueSystemSound(last)
            RomCode.TONE_DATA_POINTER -> setTransferPointer(first)
            else -> refused(messages.unknownCode(code))
        }
    }

    private fun setTransferPointer(address: Int): RomEffect {
        memory.writeShort(SerialMemory.TRANSFER_POINTER, address)
        memory.writeShort(SerialMemory.SEQUENCE_NUMBER, SerialMemory.NO_SEQUENCE)
        return RomEffect(messages.transferPointer(address))
    }

    private fun check(arguments: List<Int>): RomEffect {
        val (validPointer, nextPointer) = arguments
        val valid = memory.readByte(SerialMemory.VALID)
        memory.writeByte(validPointer, valid)
        memory.writeShort(nextPointer, memory.readWord(SerialMemory.TRANSFER_POINTER))
        return RomEffect(messages.dataWaiting(valid != 0))
    }

    private fun receive(arguments: List<Int>): RomEffect {
        val (pointer, longest, countPointer) = arguments
        val count = serial.take(pointer, longest % LENGTHS)
        memory.writeByte(countPointer, memory.readByte(countPointer) + count)
        return RomEffect(messages.received(count))
    }

    private fun send(arguments: List<Int>): RomEffect {
        val (code, opcode, pointer, length) = arguments
        val longest = if (code == RomCode.SEND_LONG) MAX_LONG_BYTES else SerialMemory.MAX_SHORT_BYTES
        if (code != RomCode.SEND_SHORT && code != RomCode.SEND_LONG) return refused(messages.unknownCode(code))
        if (length !in 1..longest) return refused(messages.wrongMessageLength(length, longest))
        val sending = if (code == RomCode.SEND_SHORT) {
            serial.sendShort(pointer, length)
        } else {
            serial.sendLong(opcode, pointer, length)
        }
        return RomEffect(
            when (sending) {
                Serial.Sending.BEGUN -> messages.sent(length)
                Serial.Sending.BUSY -> messages.stillSending()
                Serial.Sending.OFF -> messages.infraredOff()
            },
        )
    }

    private companion object {
        /** The ROM stores a length in a byte. */
        const val LENGTHS = 256

        /** Max count of the ROM's counter of remaining bytes, including complements, header and sum. */
        const val MAX_LONG_BYTES = 0x7FFC
    }
}
