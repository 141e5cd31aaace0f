package robotran.lejoslinker.image

/**
 * What an image holds, by the numbers that the firmware uses.
 *
 * @property parts the parts in the order of their places; together they are the whole image.
 * @property classes by number.
 * @property signatures names and descriptors of methods by number.
 * @property constants by number.
 * @property staticFields by number.
 * @property entryClasses the numbers of the classes that can be started, in the order of the Prgm button.
 */
class ImageContents(
    val parts: List<ImagePart>,
    val classes: List<ClassRecord>,
    val signatures: List<String>,
    val constants: List<ConstantValue>,
    val staticFields: List<StaticFieldRecord>,
    val entryClasses: List<Int>,
) {
    /** Bytes of all static fields, without the byte that makes their number even. */
    val staticStateBytes: Int get() = staticFields.sumOf { it.type.bytes }
}

/** A part of the image from byte [offset] on. */
class ImagePart(val kind: PartKind, val offset: Int, val bytes: Int)

/** The parts of an image in their order. */
enum class PartKind {
    MASTER_RECORD,
    CLASS_RECORDS,
    STATIC_STATE,
    STATIC_FIELD_RECORDS,
    CONSTANT_RECORDS,
    METHOD_RECORDS,
    EXCEPTION_RECORDS,
    FIELD_TYPES,
    CODE,
    CONSTANT_VALUES,
    ENTRY_CLASSES,
}

/**
 * A class or interface.
 *
 * @property name with slashes.
 * @property superclass the number of the superclass; 0 for Object itself.
 * @property objectBytes bytes of an object, with its header of 4 bytes, rounded up to words of 2 bytes.
 * @property fields the types of its own instance fields.
 * @property methods by their index in the class.
 */
class ClassRecord(
    val name: String,
    val superclass: Int,
    val objectBytes: Int,
    val fields: List<FieldType>,
    val methods: List<MethodRecord>,
)

/**
 * A method.
 *
 * @property signature the number of its name and descriptor.
 * @property codeOffset where its code is in the image; 0 for a native or abstract method.
 * @property codeBytes 0 for a native or abstract method.
 * @property handlers number of exception handlers.
 */
class MethodRecord(
    val signature: Int,
    val isNative: Boolean,
    val isStatic: Boolean,
    val isSynchronized: Boolean,
    val codeOffset: Int,
    val codeBytes: Int,
    val handlers: Int,
)

/**
 * A static field.
 *
 * @property owner the class, with slashes.
 * @property offset its place in the static state.
 */
class StaticFieldRecord(val owner: String, val name: String, val type: FieldType, val offset: Int)
