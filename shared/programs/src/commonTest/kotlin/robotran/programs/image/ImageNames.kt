package robotran.programs.image

import robotran.language.Language
import robotran.lejoslinker.image.ImageContents
import robotran.tinyvm.classfile.ClassFile
import robotran.tinyvm.classfile.ClassFileResult
import robotran.tinyvm.classfile.FieldEntry
import robotran.tinyvm.classfile.readClassFile
import robotran.tinyvm.config.BrickLayout
import robotran.tinyvm.messages.TinyVmMessages

/**
 * What an image does not hold and a verifier wants to know: the static types of fields, parameters and receivers. They are
 * taken from the class files that the image was made of, with made-up names for all classes and methods that the firmware
 * does not know by number.
 */
internal class ImageNames(private val contents: ImageContents, classFiles: Map<String, ByteArray>) {
    private val numbers: Map<String, Int> = contents.classes.withIndex().associate { it.value.name to it.index }
    private val signatures: List<String> = contents.signatures

    /** By class number. */
    val originals: List<ClassFile> = contents.classes.map { read(it.name, classFiles.getValue(it.name)) }

    /** The static fields of the class [number] that are in the image, in its order. */
    fun staticsOf(number: Int): List<FieldEntry> {
        val type = originals[number]
        val kept = contents.staticFields.filter { it.owner == type.name }.map { it.name }
        return type.fields.filter { it.isStatic && it.name in kept }
    }

    /** The made-up name of the class [number]. */
    fun classNamed(number: Int): String = if (number < SPECIAL_CLASSES) originals[number].name else "C$number"

    /** The made-up name of the class or array [original]; one that is not in the image passes as an object. */
    fun renamed(original: String): String = when {
        original.startsWith("[") -> descriptor(original)
        original in numbers -> classNamed(numbers.getValue(original))
        else -> ROOT
    }

    fun isInImage(original: String): Boolean = original in numbers

    /** The made-up name of the method with the signature [number]. */
    fun methodNamed(number: Int): String {
        val name = signatures[number].substringBefore('(')
        return if (number < SPECIAL_SIGNATURES || name.startsWith("<")) name else "m$number"
    }

    fun descriptorOf(number: Int): String = descriptor("(" + signatures[number].substringAfter('('))

    /** The class and signature numbers of [layout] by made-up names. */
    fun renamed(layout: BrickLayout) = BrickLayout(
        layout.imageBytes,
        originals.indices.associateBy(::classNamed),
        signatures.indices.associateBy { methodNamed(it) + descriptorOf(it) },
    )

    fun signature(number: Int): String = signatures[number]

    /** [original] with the classes renamed. */
    fun descriptor(original: String): String = CLASS.replace(original) { "L" + renamed(it.groupValues[1]) + ";" }

    private fun read(name: String, bytes: ByteArray): ClassFile =
        (readClassFile(bytes, name, TinyVmMessages.of(Language.ENGLISH)) as ClassFileResult.Success).classFile

    private companion object {
        const val ROOT = "java/lang/Object"
        const val SPECIAL_CLASSES = 17
        const val SPECIAL_SIGNATURES = 50
        val CLASS = Regex("L([^;]+);")
    }
}
