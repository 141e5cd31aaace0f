package robotran.rcxrom.memory

/**
 * Addresses of the infrared state in the ROM's memory. Source: brickEmu's ROM re-implementation; josx reads several of
 * these itself.
 */
internal object SerialMemory {
    val ALL = 0xEF50..0xEFC5

    const val USES_HEADER = 0xEF50
    const val USES_COMPLEMENTS = 0xEF51

    /** The outgoing packet, up to [OUTGOING_BYTES]; josx `LLC` has the bytes there that it received. */
    const val OUTGOING = 0xEF52
    const val OUTGOING_BYTES = 64
    const val SEND_INDEX = 0xEF92

    /** [IDLE] or [SENDING]. */
    const val SEND_STATE = 0xEF93
    const val SEND_KIND = 0xEF94
    const val SEND_REMAINING = 0xEF96
    const val SEND_POINTER = 0xEF98
    const val SEND_SUM = 0xEF9B

    /** The incoming message, a ring buffer of ten bytes. */
    const val INCOMING = 0xEF9D
    const val TRANSFER_POINTER = 0xEFAE
    const val RECEIVE_INDEX = 0xEFB0
    const val UNPACK_INDEX = 0xEFB1
    const val RECEIVE_STATE = 0xEFB2
    const val EXPECTS_COMPLEMENT = 0xEFB3
    const val TIMER_POINTER = 0xEFB4
    const val VALID = 0xEFB6
    const val FLAG_POINTER = 0xEFB8
    const val LAST_BYTE = 0xEFBA
    const val SEQUENCE_NUMBER = 0xEFBC
    const val RECEIVE_SUM = 0xEFBE
    const val TRANSFER_SUM = 0xEFBF
    const val RECEIVE_REMAINING = 0xEFC0
    const val TRANSFER_REMAINING = 0xEFC2
    const val TRANSFER_BEGIN = 0xEFC4

    const val IDLE = 0x4F
    const val SENDING = 0x13
    const val INCOMING_BYTES = 10
    const val NO_SEQUENCE = 0xFFFF

    /** Max bytes of a message that fit into [OUTGOING] with header, complements and sum. */
    const val MAX_SHORT_BYTES = 29
}
