package robotran.hublink

/**
 * What a hub says that it can take.
 *
 * @property messageBytes the longest command.
 * @property programBytes the longest program as the hub reports it, which is senseless on an NXT: see [roomFor].
 * @property slots programs that it keeps; 0 where it has one and no choice.
 */
data class HubCapabilities(val messageBytes: Int, val flags: Long, val programBytes: Long, val slots: Int) {
    /** Whether it takes several modules of bytecode of version 6, as we send them. */
    val takesPrograms: Boolean get() = flags and MULTI_MPY_6 != 0L

    /** The bytes of a program that a command has room for. */
    val payload: Int get() = messageBytes.coerceIn(MIN_MESSAGE, MAX_MESSAGE) - COMMAND_HEAD

    /** The longest program that a hub of [kind] takes, in bytes. */
    fun roomFor(kind: HubKind): Int = when {
        kind == HubKind.NXT || programBytes > MAX_PROGRAM -> NXT_ROOM
        else -> programBytes.toInt()
    }

    companion object {
        /** Reads the value of the hub's characteristic; null if it is too short. */
        fun read(value: ByteArray): HubCapabilities? {
            if (value.size < SIZE) return null
            val slots = if (value.size > SIZE) value.u8(SIZE) else 0
            return HubCapabilities(value.u16(0), value.u32(2), value.u32(6), slots)
        }

        private const val SIZE = 10
        private const val MULTI_MPY_6 = 2L

        /** Command and offset. */
        private const val COMMAND_HEAD = 5

        /** What goes over Bluetooth without any agreement, and what never goes. */
        private const val MIN_MESSAGE = 20
        private const val MAX_MESSAGE = 512

        /** More than any hub has. An NXT reports nearly 4 GB, because its storage has 0 bytes and the sum wraps. */
        private const val MAX_PROGRAM = 16_000_000L

        /** The memory that an NXT has for a program and its data together. */
        private const val NXT_ROOM = 10_000
    }
}
