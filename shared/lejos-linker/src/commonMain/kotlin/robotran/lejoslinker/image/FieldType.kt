package robotran.lejoslinker.image

/**
 * The type of a field as leJOS numbers it. Source: leJOS `TinyVMConstants`.
 *
 * @property number as in the image, 0 to 11.
 * @property bytes bytes that a field takes.
 */
enum class FieldType(val number: Int, val bytes: Int) {
    REFERENCE(0, 4),
    BOOLEAN(4, 1),
    CHAR(5, 2),
    FLOAT(6, 4),
    DOUBLE(7, 8),
    BYTE(8, 1),
    SHORT(9, 2),
    INT(10, 4),
    LONG(11, 8),
    ;

    companion object {
        /** The type with this class file [descriptor]. */
        fun of(descriptor: String): FieldType = when (descriptor.first()) {
            'Z' -> BOOLEAN
            'C' -> CHAR
            'F' -> FLOAT
            'D' -> DOUBLE
            'B' -> BYTE
            'S' -> SHORT
            'I' -> INT
            'J' -> LONG
            else -> REFERENCE
        }
    }
}
