package robotran.hublink.protocol

import robotran.hublink.HubStatus
import robotran.hublink.u32
import robotran.hublink.u8

/** What a hub tells by itself. */
internal sealed interface HubEvent {
    class Status(val status: HubStatus) : HubEvent

    /** A piece of what the program prints; a letter may be cut in two. */
    class Output(val bytes: ByteArray) : HubEvent

    class AppData(val bytes: ByteArray) : HubEvent

    companion object {
        /** Reads an event; null for one that we do not know, or that is cut short. */
        fun read(bytes: ByteArray): HubEvent? = when (bytes.firstOrNull()?.toInt()) {
            STATUS -> readStatus(bytes)
            OUTPUT -> Output(bytes.copyOfRange(1, bytes.size))
            APP_DATA -> AppData(bytes.copyOfRange(1, bytes.size))
            else -> null
        }

        /** From profile 1.4 on with the program, from 1.5 on with the slot. */
        private fun readStatus(bytes: ByteArray): Status? {
            if (bytes.size < PROGRAM_PLACE) return null
            val program = if (bytes.size > PROGRAM_PLACE) bytes.u8(PROGRAM_PLACE) else 0
            val slot = if (bytes.size > SLOT_PLACE) bytes.u8(SLOT_PLACE) else 0
            return Status(HubStatus(bytes.u32(1), program, slot))
        }

        private const val STATUS = 0
        private const val OUTPUT = 1
        private const val APP_DATA = 2
        private const val PROGRAM_PLACE = 5
        private const val SLOT_PLACE = 6
    }
}
