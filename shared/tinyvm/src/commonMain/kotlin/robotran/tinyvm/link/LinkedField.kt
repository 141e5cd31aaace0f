package robotran.tinyvm.link

/**
 * A field with its place.
 *
 * @property slot of a static field its place among all static fields of a program, otherwise the word of the object.
 * @property initialValue what a static constant begins with, null if nothing is said about it.
 */
internal class LinkedField(
    val owner: LinkedClass,
    val name: String,
    val descriptor: String,
    val isStatic: Boolean,
    val slot: Int,
    val initialValue: InitialValue?,
) {
    val isReference: Boolean get() = isReferenceDescriptor(descriptor)

    /** Whether it is a long or a double, which take two words among locals and operands, though one in an object. */
    val isWide: Boolean get() = descriptor == "J" || descriptor == "D"
}

/** What a static constant begins with. */
internal sealed interface InitialValue {
    class Word(val bits: Int) : InitialValue

    class Text(val text: String) : InitialValue
}

internal fun isReferenceDescriptor(descriptor: String): Boolean = descriptor[0] == 'L' || descriptor[0] == '['

/** Bytes that a value takes in an object of a real brick. Source: leJOS `memory.c`, typeSize. */
internal fun brickBytesOf(descriptor: String): Int = when (descriptor[0]) {
    'Z', 'B' -> 1
    'C', 'S' -> 2
    'J', 'D' -> 8
    else -> 4
}
