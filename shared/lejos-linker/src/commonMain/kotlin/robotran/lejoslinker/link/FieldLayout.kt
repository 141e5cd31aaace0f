package robotran.lejoslinker.link

import robotran.lejoslinker.config.ImageLimits
import robotran.lejoslinker.image.FieldType
import robotran.lejoslinker.messages.ImageMessages
import robotran.lejoslinker.messages.tinyVm
import robotran.tinyvm.classfile.FieldEntry
import robotran.tinyvm.messages.Counted

/**
 * Places the fields of an image without gaps: static ones one behind the other through the whole program, those of
 * objects behind the inherited ones. Source: leJOS `Binary.java`, processFields, and `ClassRecord.java`.
 */
internal class FieldLayout(
    private val classes: List<ImageClass>,
    private val errors: ErrorList,
    private val messages: ImageMessages,
) {
    private var staticFields = 0
    private var staticBytes = 0
    private val placed = HashSet<ImageClass>()

    /** Places all fields, but of the static ones only those of [used] if there is that. */
    fun place(used: UsedParts?) {
        for (each in classes) {
            if (each.file.fields.size > ImageLimits.FIELDS) {
                errors.add(CodePlace(each.name), messages.tinyVm.tooMany(Counted.FIELDS, ImageLimits.FIELDS))
            }
            placeInstanceFields(each)
            each.staticFields = each.file.fields
                .filter { it.isStatic && (used == null || used.hasStatic(each.name, it.name)) }
                .map { placeStatic(each, it) }
        }
        if (staticBytes > ImageLimits.OFFSET + 1) {
            val place = CodePlace(classes.first { it.isEntry }.name)
            errors.add(place, messages.tooManyStaticBytes(staticBytes, ImageLimits.OFFSET + 1))
        }
    }

    private fun placeStatic(owner: ImageClass, entry: FieldEntry): ImageField {
        val type = FieldType.of(entry.descriptor)
        val field = ImageField(owner, entry.name, entry.descriptor, type, staticFields++, staticBytes)
        staticBytes += type.bytes
        return field
    }

    private fun placeInstanceFields(each: ImageClass) {
        if (!placed.add(each)) return
        val superclass = each.superclass
        if (superclass != null) placeInstanceFields(superclass)
        var bytes = superclass?.instanceBytes ?: 0
        each.instanceFields = each.file.fields.filterNot { it.isStatic }.map { entry ->
            val type = FieldType.of(entry.descriptor)
            val offset = ImageClass.HEADER_BYTES + bytes
            bytes += type.bytes
            ImageField(each, entry.name, entry.descriptor, type, number = 0, offset)
        }
        each.instanceBytes = bytes
        if (each.instanceFields.any { it.offset > ImageLimits.OFFSET }) {
            errors.add(CodePlace(each.name), messages.objectTooLarge(bytes, ImageLimits.OFFSET))
        }
    }
}
