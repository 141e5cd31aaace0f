package robotran.tower

/**
 * The opcodes of messages to a brick. Bit 3 is free for the toggle, see [TOGGLE].
 *
 * Sources: BrickBot/nqc (`rcxlib`), BrickBot/leJOS-RCX (`src/comms`, `src/platform/rcx/main.c`).
 */
internal object RcxOpcode {
    /** Answered by every brick. */
    const val ALIVE = 0x10

    /** Begins a program download to leJOS. LEGO's firmware reads one of its values instead. */
    const val LEJOS_BEGIN = 0x12

    /** Asks for the versions of ROM and firmware. */
    const val VERSIONS = 0x15

    /** Sets the clock of LEGO's firmware: hours, minutes. */
    const val SET_CLOCK = 0x22

    /** Begins the download of a task to LEGO's firmware. */
    const val BEGIN_TASK = 0x25

    /** Asks LEGO's firmware for the voltage of the batteries. */
    const val BATTERY = 0x30

    /** Begins the download of a subroutine to LEGO's firmware. */
    const val BEGIN_SUBROUTINE = 0x35

    /** Deletes all tasks of the selected slot of LEGO's firmware. */
    const val DELETE_TASKS = 0x40

    /** A block of a program or a firmware. */
    const val BLOCK = 0x45

    /** Stops all tasks of LEGO's firmware. */
    const val STOP = 0x50

    /** Plays a sound of LEGO's firmware. */
    const val PLAY_SOUND = 0x51

    /** Deletes the firmware; the ROM answers afterwards. */
    const val DELETE_FIRMWARE = 0x65

    /** Deletes all subroutines of the selected slot of LEGO's firmware. */
    const val DELETE_SUBROUTINES = 0x70

    /** Starts a task of LEGO's firmware. */
    const val START_TASK = 0x71

    /** Begins a firmware download. */
    const val BEGIN_FIRMWARE = 0x75

    /** Selects a slot of LEGO's firmware, which stops its tasks. */
    const val SELECT_SLOT = 0x91

    /** Asks LEGO's firmware for entries of the datalog: the first one, how many. */
    const val READ_DATALOG = 0xA4

    /** Starts the firmware that was downloaded. */
    const val UNLOCK_FIRMWARE = 0xA5

    /** A message of one byte between bricks. Nobody answers it. */
    const val MESSAGE = 0xF7

    /** A brick takes a message with the opcode byte of the last one for a resend. This bit tells new ones apart. */
    const val TOGGLE = 0x08
}

/** Parameters that are the same in all messages of a kind. Sources: as for [RcxOpcode]. */
internal object Key {
    /** Of [RcxOpcode.VERSIONS] and [RcxOpcode.DELETE_FIRMWARE]: the first primes. */
    val PRIMES = byteArrayOf(1, 3, 5, 7, 11)

    /** Of [RcxOpcode.UNLOCK_FIRMWARE]: LEGO and the sign for registered. */
    val LEGO = byteArrayOf(0x4C, 0x45, 0x47, 0x4F, 0xAE.toByte())

    /** The magic number of leJOS's images and of its answer to [RcxOpcode.LEJOS_BEGIN]. */
    val LEJOS = byteArrayOf(0xCA.toByte(), 0xF6.toByte())
}

/** The answers to blocks and to messages that begin a download. Source: leJOS-RCX, nqc. */
internal object Status {
    const val GOOD = 0

    /** LEGO's firmware and ROM: no memory. leJOS: no download has begun. */
    const val NO_MEMORY = 1

    /** The firmware's checksum is wrong. */
    const val WRONG_FIRMWARE_CHECKSUM = 4
}

/** The line between tower and brick. */
internal object LineSpeed {
    /** Baud. Source: nqc, leJOS-RCX, WebPBrick. */
    private const val BITS_PER_SECOND = 2400

    /** Start bit, eight data bits, parity, stop bit. */
    private const val BITS_PER_BYTE = 11

    /** How long [bytes] are on the line, in ms, rounded up. */
    fun milliseconds(bytes: Int): Int = (bytes * BITS_PER_BYTE * 1000 + BITS_PER_SECOND - 1) / BITS_PER_SECOND
}

/** Times in ms. Those of the tools range from 50 to 1100; ours are measured from the end of sending. */
internal object Wait {
    /** The wait for an answer to begin, at first. nqc begins with the same. */
    const val FIRST_ANSWER_TIMEOUT = 500

    /** The shortest wait for an answer to begin. A brick answers within 20 ms; adapters and browsers add to it. */
    const val MIN_ANSWER_TIMEOUT = 150

    /** The longest wait for an answer to begin, after answers that came too late. */
    const val MAX_ANSWER_TIMEOUT = 2000

    /** A serial tower without any echo this long after the end of sending is no tower. leJOS-RCX: 100. */
    const val FOR_ECHO = 250

    /** A pause in the echo after which the rest of it counts as lost. */
    const val ECHO_GAP = 100

    /** What has come before a message is read until nothing comes for this long. */
    const val DRAIN = 3

    /** A serial tower needs this after its first byte. Source: leJOS-RCX. */
    const val WAKE_UP = 20

    /** A tower that has not found its echo in this time is not there. Source: leJOS-RCX. */
    const val WAKE_UP_IN_ALL = 4000

    /** The same for a port that may be anything. */
    const val SEARCH = 1200

    /** A serial tower falls asleep some seconds after the last byte; nobody knows how many. */
    const val KEEP_AWAKE = 3000

    /** The ROM sums up a firmware before it can unlock it. Source: leJOS-RCX. */
    const val BEFORE_UNLOCK = 1000

    /** The wait for the answer to unlocking to begin. Source: nqc. */
    const val FOR_UNLOCK = 1000

    /** A message from a brick ends with a pause this long at the latest. */
    const val MESSAGE_GAP = 60

    /** Blocks without any sign of the brick for this long make the sender ask whether it is there. */
    const val UNTIL_ALIVE = 3000

    /** Blocks without any sign of a brick that cannot be asked in between are in vain after this time. */
    const val UNHEARD = 15_000

    /** Nobody switches a brick off and on again within this time. An assumption, not measured. */
    const val OFF_AND_ON = 1500
}

/** How often things are tried. */
internal object Tries {
    /** A request of a few bytes. leJOS-RCX tries alive five times. */
    const val REQUEST = 10

    /** The same, if parts of answers have come. */
    const val WHEN_HEARD = 30

    /** Serial attempts without a single byte of echo after which there is no tower. */
    const val WITHOUT_ECHO = 3

    /** Attempts to begin a leJOS download after an alive that was answered at once, and after one that was not. */
    const val LEJOS_BEGIN_WHEN_CLEAR = 6
    const val LEJOS_BEGIN = 24

    /** Asking a brick that may be of another kind for its versions. */
    const val VERSIONS_OF_OTHERS = 3

    /** A block, before a download begins again with smaller ones. */
    const val BLOCK = 3

    /** A block of the smallest size: at 5 % lost bytes, one in eight gets through with its answer. */
    const val SMALLEST_BLOCK = 200

    /** Attempts at a whole download. */
    const val DOWNLOAD = 16

    /** Deletions after a download to LEGO's firmware that ended early: the pupil waits for them. */
    const val CLEAN_UP = 3

    /** Entries of the datalog of one size, and of the smallest size. */
    const val DATALOG = 3
    const val SMALLEST_DATALOG = 30

    /** Unlockings of a firmware. */
    const val UNLOCK = 5
}

/** Blocks of a download. */
internal object Blocks {
    /**
     * Data bytes in a block, from clear to disturbed. All tools use 200 at most, nqc 20 on a bad line. Blocks of 8
     * take the least time if 5 % of all bytes are lost.
     */
    val SIZES = listOf(200, 100, 50, 20, 8)

    /** Bytes of a block's message besides its data: header 3, and 7 with their complements. */
    const val OVERHEAD_BYTES = 17

    /** Bytes of the answer to a block: header 3, and 3 with their complements. */
    const val ANSWER_BYTES = 9

    /** Blocks in a row that were confirmed at once, after which a larger size is tried. */
    const val UNTIL_LARGER = 4

    /**
     * Data bytes of the last block at most. If only its answer is lost, a resend must follow within
     * [Wait.OFF_AND_ON].
     */
    const val MAX_LAST = 100

    /** leJOS refuses a download in a single block. Source: `src/platform/rcx/main.c`. */
    const val MIN_COUNT_LEJOS = 2
}

/** What fits on a brick, in bytes. */
object BrickMemory {
    /**
     * The largest image that every leJOS takes: from the end of the firmware of 3.0 (B8F2) to where a download gives up
     * (EECE). A brick does not tell which version it has.
     */
    const val MAX_LEJOS_IMAGE = 13_788

    /** The largest image for leJOS 2.1, whose firmware ends at B576. */
    const val MAX_LEJOS_2_1_IMAGE = 14_680

    /** The largest firmware. Source: leJOS-RCX, `srec.h`. */
    const val MAX_FIRMWARE = 32_768

    /** The ROM sums up a firmware from 8000 to before CC00. */
    internal const val SUMMED_FIRMWARE = 0xCC00 - 0x8000
}

/** LEGO's firmware. */
object LegoLimits {
    /** The slots are numbered from 1. */
    const val SLOTS = 5

    /** nqc warns below this; a transfer takes minutes, and a brick that restarts in it loses everything. */
    const val MIN_MILLIVOLTS = 6600

    /** The oldest version of firmware 2.0. Source: the names of its files. */
    val VERSION_2 = RcxVersion(3, 28)

    /**
     * Entries of a datalog at most, with the first, which counts them: more than the memory of a brick has room for.
     */
    const val DATALOG_ENTRIES = 0x8000 / 3
}
