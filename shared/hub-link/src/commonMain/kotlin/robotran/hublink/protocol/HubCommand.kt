package robotran.hublink.protocol

import robotran.hublink.HubVersion
import robotran.hublink.Profile
import robotran.hublink.fourBytes

/** The commands of Pybricks' protocol, as they are written to a hub. */
internal object HubCommand {
    private const val STOP = 0
    private const val START = 1
    private const val SIZE = 3
    private const val BYTES = 4
    private const val INPUT = 6
    private const val APP_DATA = 7

    /** Stops the program. */
    fun stop(): ByteArray = byteArrayOf(STOP.toByte())

    /** Starts the program in [slot]; before profile 1.4 there is one slot, which has no number. */
    fun start(profile: HubVersion, slot: Int): ByteArray =
        if (profile < Profile.WITH_SLOTS) byteArrayOf(START.toByte()) else byteArrayOf(START.toByte(), slot.toByte())

    /** Opens a download. The program in the slot is gone from then on. */
    fun open(): ByteArray = size(0)

    /** Closes the download of a program of [size] bytes. */
    fun size(size: Int): ByteArray = byteArrayOf(SIZE.toByte()) + fourBytes(size)

    /** [bytes] of a program from [offset] on. */
    fun bytes(offset: Int, bytes: ByteArray): ByteArray = byteArrayOf(BYTES.toByte()) + fourBytes(offset) + bytes

    /** What the program reads as its input. */
    fun input(bytes: ByteArray): ByteArray = byteArrayOf(INPUT.toByte()) + bytes

    /** Data for the program from [offset] on. */
    fun appData(offset: Int, bytes: ByteArray): ByteArray =
        byteArrayOf(APP_DATA.toByte(), offset.toByte(), (offset shr Byte.SIZE_BITS).toByte()) + bytes
}

/** The error of a command; over Bluetooth the ATT error of the write. */
internal object HubErrorCode {
    const val DOWNLOAD_STATE = 0x0E
    const val NOT_ALLOWED = 0x13
    const val INVALID = 0x80
    const val BUSY = 0x81
}
