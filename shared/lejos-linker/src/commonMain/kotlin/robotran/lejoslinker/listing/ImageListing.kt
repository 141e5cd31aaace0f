package robotran.lejoslinker.listing

import robotran.lejoslinker.LejosImage
import robotran.lejoslinker.image.ClassRecord
import robotran.lejoslinker.image.ConstantValue
import robotran.lejoslinker.image.ImageContents
import robotran.lejoslinker.image.MethodRecord
import robotran.lejoslinker.messages.ListingMessages

/**
 * [image] in words, line by line: its parts, classes with their methods, constants, static fields and signatures, all
 * with the numbers that a brick uses, such as those that it shows for an exception.
 */
fun listingOf(image: LejosImage, messages: ListingMessages): String = ImageListing(image.contents, messages).text()

private class ImageListing(private val contents: ImageContents, private val messages: ListingMessages) {
    private val lines = ArrayList<String>()

    fun text(): String {
        parts()
        section(messages.entryClasses(), contents.entryClasses) { position, number -> "$position ${nameOf(number)}" }
        lines += messages.classes()
        contents.classes.forEachIndexed(::classLines)
        section(messages.constants(), contents.constants) { number, constant -> "$number ${textOf(constant)}" }
        section(messages.staticFields(), contents.staticFields) { number, field ->
            "$number ${dotted(field.owner)}.${field.name}  ${messages.bytesAt(field.type.bytes, field.offset)}"
        }
        section(messages.signatures(), contents.signatures) { number, signature -> "$number $signature" }
        return lines.joinToString("\n", postfix = "\n")
    }

    private fun parts() {
        lines += messages.parts(contents.parts.sumOf { it.bytes })
        for (part in contents.parts) {
            lines += "  ${messages.partName(part.kind)}  ${messages.bytesAt(part.bytes, part.offset)}"
        }
    }

    private fun <T> section(heading: String, rows: List<T>, row: (Int, T) -> String) {
        lines += heading
        rows.forEachIndexed { number, each -> lines += "  ${row(number, each)}" }
    }

    private fun classLines(number: Int, each: ClassRecord) {
        val superclass = if (number == 0) "" else ": ${nameOf(each.superclass)}"
        lines += "  $number ${dotted(each.name)}$superclass  ${messages.objectBytes(each.objectBytes)}"
        each.methods.forEachIndexed { index, method -> lines += "    $index ${textOf(method)}" }
    }

    private fun textOf(method: MethodRecord): String = listOfNotNull(
        contents.signatures[method.signature],
        "static".takeIf { method.isStatic },
        "synchronized".takeIf { method.isSynchronized },
        when {
            method.isNative -> "native"
            method.codeOffset == 0 -> "abstract"
            else -> messages.bytesAt(method.codeBytes, method.codeOffset)
        },
    ).joinToString("  ")

    private fun textOf(constant: ConstantValue): String = when (constant) {
        is ConstantValue.Text -> "\"${constant.text.map(::visible).joinToString("")}\""
        is ConstantValue.Whole -> "int ${constant.value}"
        is ConstantValue.Decimal -> "float ${Float.fromBits(constant.bits)}"
        is ConstantValue.LongWhole -> "long ${constant.value}"
        is ConstantValue.LongDecimal -> "double ${Double.fromBits(constant.bits)}"
    }

    private fun visible(character: Char): String = when {
        character == '"' || character == '\\' -> "\\$character"
        character < ' ' -> "\\u" + character.code.toString(HEXADECIMAL).padStart(HEX_DIGITS, '0')
        else -> character.toString()
    }

    private fun nameOf(number: Int) = dotted(contents.classes[number].name)

    private fun dotted(name: String) = name.replace('/', '.')

    private companion object {
        const val HEXADECIMAL = 16
        const val HEX_DIGITS = 4
    }
}
