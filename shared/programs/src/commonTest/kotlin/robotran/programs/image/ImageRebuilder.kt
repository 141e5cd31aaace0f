package robotran.programs.image

import robotran.tinyvm.classfile.ClassFile
import robotran.tinyvm.classfile.MethodEntry

/**
 * Makes class files of an image again. Code, constants, the places of fields, the methods that are there, what a call
 * reaches, handlers and superclasses come from the image; [names] only adds what a verifier wants to know.
 */
internal class ImageRebuilder(private val image: BrickImage, private val names: ImageNames) {
    private val layouts: List<List<PlacedField>> by lazy { image.classes.indices.map(::layoutOf) }
    private val firstStatics: List<Int> = names.originals.indices.runningFold(0) { first, number ->
        first + names.staticsOf(number).size
    }

    /** The class files by made-up name. */
    fun rebuild(): Map<String, ByteArray> = image.classes.indices.associate { names.classNamed(it) to rebuild(it) }

    /** A field with its offset in an object, and the made-up names of its class and of itself. */
    class PlacedField(val owner: String, val name: String, val descriptor: String, val place: ImageField)

    /** The field of objects of the class [number] at [place]. */
    fun fieldAt(number: Int, place: ImageField): PlacedField = layouts[number].single { it.place == place }

    /** The static field [number] of the whole image, which belongs to the class [owner]. */
    fun staticField(owner: Int, number: Int): PlacedField {
        val original = names.staticsOf(owner)[number - firstStatics[owner]]
        check(ImageTypes.of(original.descriptor) == image.staticFields[number].type) { "static field $number" }
        return PlacedField(
            names.classNamed(owner),
            "s$number",
            names.descriptor(original.descriptor),
            image.staticFields[number],
        )
    }

    private fun layoutOf(number: Int): List<PlacedField> {
        val type = image.classes[number]
        val inherited = if (number == 0) emptyList() else layoutOf(type.superclass)
        var offset =
            inherited.lastOrNull()?.let { it.place.offset + ImageTypes.bytesOf(it.place.type) } ?: OBJECT_HEADER
        val originals = names.originals[number].fields.filter { !it.isStatic }
        check(originals.map { ImageTypes.of(it.descriptor) } == type.fields) { "fields of class $number" }
        val own = originals.mapIndexed { index, original ->
            val place = ImageField(type.fields[index], offset)
            offset += ImageTypes.bytesOf(place.type)
            PlacedField(names.classNamed(number), "f$index", names.descriptor(original.descriptor), place)
        }
        check(type.objectBytes == (offset + 1) / 2 * 2) { "size of class $number" }
        return inherited + own
    }

    private fun rebuild(number: Int): ByteArray {
        val type = image.classes[number]
        val original = names.originals[number]
        val superName = if (number == 0) null else names.classNamed(type.superclass)
        val interfaces = original.interfaces.filter(names::isInImage).map(names::renamed)
        val flags = PUBLIC or if (type.isInterface) INTERFACE or ABSTRACT else SUPER
        val builder = ClassFileBuilder(names.classNamed(number), superName, flags, interfaces)
        val methods = type.methods.map { it to originalOf(original, it) }
        val codes = methods.map { (method, methodOfGuide) ->
            methodOfGuide.code?.let { CodeRebuilder(image, names, this, builder, original, method, it) }
        }
        codes.forEach { it?.reserveLoadedConstants() }
        for (field in layouts[number].filter { it.owner == names.classNamed(number) }) {
            builder.addField(field.name, field.descriptor, PUBLIC)
        }
        repeat(names.staticsOf(number).size) {
            val field = staticField(number, firstStatics[number] + it)
            builder.addField(field.name, field.descriptor, PUBLIC or STATIC)
        }
        methods.zip(codes) { (method, _), code -> addMethod(builder, method, code) }
        return builder.build()
    }

    private fun addMethod(builder: ClassFileBuilder, method: ImageMethod, code: CodeRebuilder?) {
        var flags = PUBLIC
        if (method.isStatic) flags = flags or STATIC
        if (method.isSynchronized) flags = flags or SYNCHRONIZED
        if (method.isNative) flags = flags or NATIVE
        check((code == null) == (method.codeAt == 0)) { names.signature(method.signature) }
        if (code == null && !method.isNative) flags = flags or ABSTRACT
        val name = names.methodNamed(method.signature)
        builder.addMethod(name, names.descriptorOf(method.signature), flags, code?.rebuild())
    }

    private fun originalOf(original: ClassFile, method: ImageMethod): MethodEntry =
        original.methods.single { it.name + it.descriptor == names.signature(method.signature) }

    private companion object {
        const val OBJECT_HEADER = 4
        const val PUBLIC = 0x1
        const val STATIC = 0x8
        const val SUPER = 0x20
        const val SYNCHRONIZED = 0x20
        const val NATIVE = 0x100
        const val INTERFACE = 0x200
        const val ABSTRACT = 0x400
    }
}
