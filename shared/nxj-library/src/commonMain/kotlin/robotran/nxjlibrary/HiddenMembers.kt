package robotran.nxjlibrary

private const val CONSTANT_POOL = 10
private const val COUNT = 8
private const val BYTE_BITS = 8
private const val BYTE = 0xFF

private const val UTF8 = 1
private const val ONE_BYTE = 1
private const val TWO_BYTES = 2
private const val THREE_BYTES = 3
private const val FOUR_BYTES = 4
private const val EIGHT_BYTES = 8

/** The access flags of what only a class itself names, and of what compilers do not see. */
private const val PRIVATE = 0x0002
private const val SYNTHETIC = 0x1000
private const val ACCESS = 0x0007

/** The bytes of a constant behind its tag, but for text. Source: the Java Virtual Machine Specification, 4.4. */
private val CONSTANT_BYTES = mapOf(
    3 to FOUR_BYTES,
    4 to FOUR_BYTES,
    5 to EIGHT_BYTES,
    6 to EIGHT_BYTES,
    7 to TWO_BYTES,
    8 to TWO_BYTES,
    9 to FOUR_BYTES,
    10 to FOUR_BYTES,
    11 to FOUR_BYTES,
    12 to FOUR_BYTES,
    15 to THREE_BYTES,
    16 to TWO_BYTES,
    18 to FOUR_BYTES,
)

/**
 * [classFile] with [members] that compilers do not find: methods and constructors are synthetic, fields are private.
 *
 * @param members as in [NxjDifference.member]; the class need not have all of them.
 */
internal fun withHiddenMembers(classFile: ByteArray, members: Set<String>): ByteArray =
    MemberHider(classFile.copyOf(), members).hidden()

/** The internal name of the superclass of [classFile]; null for `java/lang/Object`. */
internal fun superclassOf(classFile: ByteArray): String? = MemberHider(classFile, emptySet()).superclass()

/** Walks through a class file and changes the access of some members in place. */
private class MemberHider(private val bytes: ByteArray, private val members: Set<String>) {
    private val constants = mutableMapOf<Int, Int>()
    private val behindConstants = readConstants()

    fun superclass(): String? {
        val index = word(behindConstants + 2 * TWO_BYTES)
        return if (index == 0) null else text(word(constants.getValue(index) + ONE_BYTE))
    }

    fun hidden(): ByteArray {
        val interfaces = behindConstants + THREE_BYTES * TWO_BYTES
        var place = interfaces + TWO_BYTES + word(interfaces) * TWO_BYTES
        place = hide(place, ":") { access -> access and ACCESS.inv() or PRIVATE }
        hide(place, "") { access -> access or SYNTHETIC }
        return bytes
    }

    /** Hides the fields or methods whose number is at [start]; returns where the bytes behind them begin. */
    private fun hide(start: Int, separator: String, changed: (Int) -> Int): Int {
        var place = start + TWO_BYTES
        repeat(word(start)) {
            val member = text(word(place + TWO_BYTES)) + separator + text(word(place + 2 * TWO_BYTES))
            if (member in members) setWord(place, changed(word(place)))
            val attributes = place + THREE_BYTES * TWO_BYTES
            place = attributes + TWO_BYTES
            repeat(word(attributes)) {
                place +=
                    TWO_BYTES + FOUR_BYTES + (word(place + TWO_BYTES) shl 2 * BYTE_BITS or word(place + FOUR_BYTES))
            }
        }
        return place
    }

    /** Notes where each constant begins; returns where the bytes behind all of them begin. */
    private fun readConstants(): Int {
        var place = CONSTANT_POOL
        var index = 1
        while (index < word(COUNT)) {
            val tag = bytes[place].toInt()
            constants[index] = place
            place += ONE_BYTE + if (tag == UTF8) TWO_BYTES + word(place + ONE_BYTE) else CONSTANT_BYTES.getValue(tag)
            index += if (CONSTANT_BYTES[tag] == EIGHT_BYTES) 2 else 1
        }
        return place
    }

    /** A text constant in ASCII. */
    private fun text(index: Int): String {
        val place = constants.getValue(index) + ONE_BYTE
        return bytes.decodeToString(place + TWO_BYTES, place + TWO_BYTES + word(place))
    }

    private fun word(offset: Int): Int =
        bytes[offset].toInt() and BYTE shl BYTE_BITS or (bytes[offset + 1].toInt() and BYTE)

    private fun setWord(offset: Int, value: Int) {
        bytes[offset] = (value shr BYTE_BITS).toByte()
        bytes[offset + 1] = value.toByte()
    }
}
