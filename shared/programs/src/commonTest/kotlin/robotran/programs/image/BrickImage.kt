package robotran.programs.image

/**
 * An image for a brick, read byte by byte as leJOS's firmware does. Independent of the linker: it knows no names, only
 * the numbers that the firmware uses.
 */
internal class BrickImage(private val bytes: ByteArray) {
    private val constantsAt = short(2)
    private val staticFieldsAt = short(4)

    /** Numbers of the classes that can be started. */
    val entryClasses: List<Int> = List(byte(14)) { byte(short(12) + it) }

    val classes: List<ImageClass> = List(byte(15) + 1) { classAt(MASTER_RECORD + it * CLASS_RECORD) }

    /** Types and offsets of all static fields. */
    val staticFields: List<ImageField> = List(short(10)) { fieldOf(short(staticFieldsAt + it * 2)) }

    /** The constant [number]. */
    fun constant(number: Int): ImageConstant {
        val record = constantsAt + number * CONSTANT_RECORD
        val begin = short(record)
        return ImageConstant(byte(record + 2), bytes.copyOfRange(begin, begin + byte(record + 3)))
    }

    /** Type and offset in the object that a `getfield` or `putfield` has as its operand. */
    fun fieldOf(operand: Int) = ImageField(operand shr TYPE_SHIFT, operand and OFFSET)

    private fun classAt(at: Int): ImageClass {
        val methods = List(byte(at + 7)) { methodAt(short(at + 2) + it * METHOD_RECORD) }
        val fields = List(byte(at + 6)) { byte(short(at + 4) + it) }
        return ImageClass(short(at) * 2, fields, methods, byte(at + 8), byte(at + 9))
    }

    private fun methodAt(at: Int): ImageMethod {
        val handlers = List(byte(at + 9)) { index ->
            val record = short(at + 2) + index * HANDLER_RECORD
            ImageHandler(short(record), short(record + 2), short(record + 4), byte(record + 6))
        }
        return ImageMethod(
            short(at),
            handlers,
            short(at + 4),
            byte(at + 6),
            byte(at + 7),
            byte(at + 8),
            byte(at + 10),
        )
    }

    /** [length] bytes of code from [offset] on. */
    fun code(offset: Int, length: Int): IntArray = IntArray(length) { byte(offset + it) }

    private fun byte(at: Int): Int = bytes[at].toInt() and 0xFF

    private fun short(at: Int): Int = byte(at) shl 8 or byte(at + 1)

    private companion object {
        const val MASTER_RECORD = 16
        const val CLASS_RECORD = 10
        const val METHOD_RECORD = 12
        const val HANDLER_RECORD = 8
        const val CONSTANT_RECORD = 4
        const val TYPE_SHIFT = 12
        const val OFFSET = 0xFFF
    }
}

/** @property fields the types of its own instance fields. */
internal class ImageClass(
    val objectBytes: Int,
    val fields: List<Int>,
    val methods: List<ImageMethod>,
    val superclass: Int,
    private val flags: Int,
) {
    val isInterface: Boolean get() = flags and 8 != 0
}

/** @property codeAt 0 for an abstract or native method. */
internal class ImageMethod(
    val signature: Int,
    val handlers: List<ImageHandler>,
    val codeAt: Int,
    val locals: Int,
    val stack: Int,
    val parameterWords: Int,
    private val flags: Int,
) {
    val isNative: Boolean get() = flags and 1 != 0
    val isSynchronized: Boolean get() = flags and 2 != 0
    val isStatic: Boolean get() = flags and 4 != 0
}

internal class ImageHandler(val start: Int, val end: Int, val target: Int, val type: Int)

internal data class ImageField(val type: Int, val offset: Int)

internal class ImageConstant(val type: Int, val value: ByteArray)

/** The types of leJOS's firmware. */
internal object ImageTypes {
    const val REFERENCE = 0
    private val NUMBERS =
        mapOf('Z' to 4, 'C' to 5, 'F' to 6, 'D' to 7, 'B' to 8, 'S' to 9, 'I' to 10, 'J' to 11)
    private val BYTES = mapOf(REFERENCE to 4, 4 to 1, 5 to 2, 6 to 4, 7 to 8, 8 to 1, 9 to 2, 10 to 4, 11 to 8)

    fun of(descriptor: String): Int = NUMBERS[descriptor[0]] ?: REFERENCE

    fun bytesOf(type: Int): Int = BYTES.getValue(type)
}
