package robotran.ui.sheet.svg

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.toArgb
import kotlin.math.abs
import kotlin.math.floor

/** Writes elements of an SVG picture. Numbers have the same format on every platform. */
class SvgWriter {
    private val text = StringBuilder()
    private var depth = 0

    /** Writes an element around the output of [content], with the [attributes] that are not null. */
    fun element(name: String, vararg attributes: Pair<String, Any?>, content: (() -> Unit)? = null) {
        begin(name, attributes)
        if (content == null) {
            text.append("/>\n")
            return
        }
        text.append(">\n")
        depth++
        content()
        depth--
        text.append("  ".repeat(depth)).append("</").append(name).append(">\n")
    }

    /** Writes an element that contains text. */
    fun textElement(name: String, content: String, vararg attributes: Pair<String, Any?>) {
        begin(name, attributes)
        text.append('>').append(escaped(content)).append("</").append(name).append(">\n")
    }

    /** Writes an element that contains texts, each in a `tspan` with its attributes. */
    fun runs(name: String, runs: List<Pair<String, List<Pair<String, Any?>>>>, vararg attributes: Pair<String, Any?>) {
        begin(name, attributes)
        text.append('>')
        for ((words, ofRun) in runs) {
            tag("tspan", ofRun.toTypedArray())
            text.append('>').append(escaped(words)).append("</tspan>")
        }
        text.append("</").append(name).append(">\n")
    }

    /** Writes what [other] has written. */
    fun nested(other: SvgWriter) {
        text.append(other.text.toString().trimEnd().prependIndent("  ".repeat(depth))).append('\n')
    }

    private fun begin(name: String, attributes: Array<out Pair<String, Any?>>) {
        text.append("  ".repeat(depth))
        tag(name, attributes)
    }

    private fun tag(name: String, attributes: Array<out Pair<String, Any?>>) {
        text.append('<').append(name)
        for ((attribute, value) in attributes) {
            if (value != null) {
                text.append(' ').append(attribute).append("=\"").append(escaped(written(value))).append('"')
            }
        }
    }

    private fun written(value: Any): String = when (value) {
        is Double -> figure(value)
        is Float -> figure(value)
        else -> value.toString()
    }

    override fun toString() = text.toString()
}

/** A number such as `12`, `-0.5` or `3.125`, rounded to a thousandth, which is a hundredth of a millimetre. */
fun figure(number: Double): String {
    val count = floor(number * THOUSAND + HALF).toLong()
    val size = abs(count)
    val decimals = (size % THOUSAND.toLong()).toString().padStart(DECIMALS, '0').trimEnd('0')
    return (if (count < 0) "-" else "") + size / THOUSAND.toLong() + if (decimals.isEmpty()) "" else ".$decimals"
}

internal fun figure(number: Float): String = figure(number.toDouble())

/** The format of `points`. */
internal fun parameters(points: List<Offset>): String = points.joinToString(" ") { parameter(it) }

internal fun parameter(point: Offset, between: String = ",") = figure(point.x) + between + figure(point.y)

/** A colour such as `#16307a`; its alpha needs a separate attribute. */
fun hex(colour: Color): String = "#" + (colour.toArgb() and RGB).toString(HEXADECIMAL).padStart(RGB_DIGITS, '0')

/** Escapes [text] for XML and drops control characters and lone surrogates. */
private fun escaped(text: String): String = buildString {
    for ((place, letter) in text.withIndex()) {
        when {
            letter == '&' -> append("&amp;")
            letter == '<' -> append("&lt;")
            letter == '>' -> append("&gt;")
            letter == '"' -> append("&quot;")
            letter.isHighSurrogate() && text.getOrNull(place + 1)?.isLowSurrogate() != true -> append(MISSING)
            letter.isLowSurrogate() && text.getOrNull(place - 1)?.isHighSurrogate() != true -> append(MISSING)
            letter < ' ' && letter != '\n' && letter != '\t' -> append(' ')
            letter == '\uFFFE' || letter == '\uFFFF' -> append(MISSING)
            else -> append(letter)
        }
    }
}

private const val THOUSAND = 1000.0
private const val HALF = 0.5
private const val DECIMALS = 3
private const val RGB = 0xFFFFFF
private const val RGB_DIGITS = 6
private const val HEXADECIMAL = 16
private const val MISSING = '\uFFFD'
