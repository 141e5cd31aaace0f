package robotran.tinyvm.link

/**
 * A field with its slot.
 *
 * @property slot the index among all static fields of a program, or the word in the object.
 * @property initialValue the initial value of a static constant, null if the class file has none.
 */
internal class LinkedField(
    val owner: LinkedClass,
    val name: String,
    val descriptor: String,
    val isStatic: Boolean,
    val slot: Int,
    val initialValue: InitialValue?,
) {
    /** Whether code reads it. */
    var isRead = false

    val isReference: Boolean get() = isReferenceDescriptor(descriptor)

    /** Whether it is a long or a double, which takes two words in locals and operands; on an RCX, it takes one in an object. */
    val isWide: Boolean get() = descriptor == "J" || descriptor == "D"
}

/** The initial value of a static constant. */
internal sealed interface InitialValue {
    class Word(val bits: Int) : InitialValue

    /** Of two words, on an exact machine. */
    class Wide(val value: Long) : InitialValue

    class Text(val text: String) : InitialValue
}

internal fun isReferenceDescriptor(descriptor: String): Boolean = descriptor[0] == 'L' || descriptor[0] == '['

/** Bytes that a value takes in an object on a real brick. Source: leJOS `memory.c`, typeSize. */
internal fun brickBytesOf(descriptor: String): Int = when (descriptor[0]) {
    'Z', 'B' -> 1
    'C', 'S' -> 2
    'J', 'D' -> 8
    else -> 4
}
