package robotran.lejoslinker.link

import robotran.lejoslinker.image.ClassRecord
import robotran.lejoslinker.image.ConstantValue
import robotran.lejoslinker.image.ImageContents
import robotran.lejoslinker.image.ImagePart
import robotran.lejoslinker.image.MethodRecord
import robotran.lejoslinker.image.PartKind
import robotran.lejoslinker.image.StaticFieldRecord

/** Where everything lies in an image. Each part begins where the one before ends. */
internal class ImageLayout(
    val classes: List<ImageClass>,
    private val signatures: SignatureTable,
    constantTable: ConstantTable,
    val entryClasses: List<Int>,
) {
    val hierarchy = Hierarchy(classes)
    val methods: List<ImageMethod> = classes.flatMap { it.methods }
    val constants: List<ConstantValue> = constantTable.all
    val staticFields: List<ImageField> = classes.flatMap { it.staticFields }
    private val staticBytes = staticFields.sumOf { it.type.bytes }

    /** The static state in words of two bytes. */
    val staticWords: Int = (staticBytes + 1) / 2

    val parts: List<ImagePart>

    val size: Int

    init {
        var offset = 0
        parts = PartKind.entries.map { kind ->
            ImagePart(kind, offset, bytesOf(kind)).also { offset += it.bytes }
        }
        size = offset
    }

    private val codeOffsets: Map<ImageMethod, Int> = buildMap {
        var offset = offsetOf(PartKind.CODE)
        for (method in methods) {
            if (method.body != null) put(method, offset)
            offset += method.code.size
        }
    }

    fun offsetOf(kind: PartKind): Int = parts[kind.ordinal].offset

    /** Where the code of [method] is; 0 if it has none. */
    fun codeOffsetOf(method: ImageMethod): Int = codeOffsets[method] ?: 0

    private fun bytesOf(kind: PartKind): Int = when (kind) {
        PartKind.MASTER_RECORD -> MASTER_RECORD
        PartKind.CLASS_RECORDS -> classes.size * CLASS_RECORD
        PartKind.STATIC_STATE -> staticWords * 2
        PartKind.STATIC_FIELD_RECORDS -> staticFields.size * 2
        PartKind.CONSTANT_RECORDS -> constants.size * CONSTANT_RECORD
        PartKind.METHOD_RECORDS -> methods.size * METHOD_RECORD
        PartKind.EXCEPTION_RECORDS -> methods.sumOf { it.body?.handlers?.size ?: 0 } * EXCEPTION_RECORD
        PartKind.FIELD_TYPES -> classes.sumOf { it.instanceFields.size }
        PartKind.CODE -> methods.sumOf { it.code.size }
        PartKind.CONSTANT_VALUES -> constants.sumOf { it.bytes.size }
        PartKind.ENTRY_CLASSES -> entryClasses.size
    }

    fun contents() = ImageContents(
        parts,
        classes.map(::recordOf),
        signatures.all,
        constants,
        staticFields.map { StaticFieldRecord(it.owner.name, it.name, it.type, it.offset) },
        entryClasses,
    )

    private fun recordOf(each: ImageClass) = ClassRecord(
        each.name,
        each.superclass?.number ?: 0,
        each.objectWords * 2,
        each.instanceFields.map { it.type },
        each.methods.map { method ->
            MethodRecord(
                method.signature,
                method.isNative,
                method.isStatic,
                method.isSynchronized,
                codeOffsetOf(method),
                method.code.size,
                method.body?.handlers?.size ?: 0,
            )
        },
    )

    companion object {
        const val MASTER_RECORD = 16
        const val CLASS_RECORD = 10
        const val CONSTANT_RECORD = 4
        const val METHOD_RECORD = 12
        const val EXCEPTION_RECORD = 8
    }
}
