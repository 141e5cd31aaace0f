package robotran.lejoslinker.link

import robotran.lejoslinker.image.FieldType
import robotran.tinyvm.classfile.AccessFlag
import robotran.tinyvm.classfile.ClassFile
import robotran.tinyvm.classfile.CodeEntry
import robotran.tinyvm.classfile.MethodDescriptor
import robotran.tinyvm.classfile.MethodEntry

/** A class of an image, filled step by step. */
internal class ImageClass(val number: Int, val file: ClassFile, val isOwn: Boolean, val isEntry: Boolean) {
    val name: String get() = file.name

    /** Null for Object only, once [Hierarchy] is done. */
    var superclass: ImageClass? = null

    /** The methods that are kept, in the order of the class file. */
    var methods: List<ImageMethod> = emptyList()
        set(value) {
            field = value
            bySignature = value.associateBy { it.entry.signature }
        }

    private var bySignature: Map<String, ImageMethod> = emptyMap()

    var staticFields: List<ImageField> = emptyList()
    var instanceFields: List<ImageField> = emptyList()

    /** Bytes of all instance fields, with those of the superclasses. */
    var instanceBytes = 0

    val hasInitializer: Boolean get() = methodNamed("<clinit>()V") != null

    /** Bytes of an object, rounded up to words of two bytes. */
    val objectWords: Int get() = (instanceBytes + HEADER_BYTES + 1) / 2

    fun methodNamed(signature: String): ImageMethod? = bySignature[signature]

    companion object {
        /** The header of an object. Source: leJOS `classes.h`, Object. */
        const val HEADER_BYTES = 4
    }
}

/**
 * A method that is kept.
 *
 * @property index its place among the class's kept methods.
 * @property signature the number of its name and descriptor.
 */
internal class ImageMethod(
    val owner: ImageClass,
    val index: Int,
    val entry: MethodEntry,
    val signature: Int,
    descriptor: MethodDescriptor,
) {
    val isStatic: Boolean get() = entry.flags and AccessFlag.STATIC != 0
    val isNative: Boolean get() = entry.flags and AccessFlag.NATIVE != 0
    val isSynchronized: Boolean get() = entry.flags and AccessFlag.SYNCHRONIZED != 0

    /** Words of its arguments, without `this`. */
    val argumentWords: Int = descriptor.parameterWords

    /** Words of its arguments, with `this`. */
    val parameterWords: Int get() = argumentWords + if (isStatic) 0 else 1

    /** Null for abstract and native methods. */
    val body: CodeEntry? get() = entry.code.takeUnless { isNative }

    val place: CodePlace get() = CodePlace(owner.name, entry.name)

    /** The code as in the image; empty for abstract and native methods. */
    var code: ByteArray = ByteArray(0)
}

/** Name and descriptor together, as the firmware's table has them. */
internal val MethodEntry.signature: String get() = name + descriptor

/**
 * A field.
 *
 * @property number the number of a static field in the whole program.
 * @property offset its place in the static state or, with the header, in an object.
 */
internal class ImageField(
    val owner: ImageClass,
    val name: String,
    val descriptor: String,
    val type: FieldType,
    val number: Int,
    val offset: Int,
)
