package robotran.robolang.outline

import robotran.language.source.SourceSpan
import robotran.robolang.words.ValueForm
import robotran.robolang.words.ValueUse

/** A part of a line or of a value, with its exact place. */
sealed interface PhrasePart {
    val span: SourceSpan

    /** A word or sign that belongs to the form. */
    data class Word(override val span: SourceSpan) : PhrasePart

    /** A word, number or sign for which each of [options] may stand, such as `left` and `right`. */
    data class Choice(override val span: SourceSpan, val options: List<String>) : PhrasePart

    /** A name. */
    data class NamePart(override val span: SourceSpan, val role: NameRole) : PhrasePart

    /** The text of `show`, with its quotation marks. */
    data class Text(override val span: SourceSpan) : PhrasePart

    /** A value, for [use]. */
    data class Value(val use: ValueUse, val value: OutlineValue) : PhrasePart {
        override val span: SourceSpan get() = value.span
    }
}

/** What a name does at its place. */
enum class NameRole { DECLARES, DECLARES_ROUTINE, READS, ASSIGNS, CALLS_PROCEDURE, CALLS_FUNCTION }

/** A value with its [parts]; no two values of a program have the same [span]. */
data class OutlineValue(val form: ValueForm, val span: SourceSpan, val parts: List<PhrasePart>)
