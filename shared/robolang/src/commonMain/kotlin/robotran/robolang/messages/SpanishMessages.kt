package robotran.robolang.messages

import robotran.language.quoted

/**
 * The messages in Spanish. They call the pupil "tú". One thing has one word: brick - ladrillo, bracket - paréntesis,
 * command - orden, condition - condición, declare - declarar, display - pantalla, figure - cifra, line - línea, loop -
 * bucle, power - potencia, text - texto, value - valor, whole number - número entero, decimal number - número decimal.
 * Words of Robolang stay as they are, between quotation marks.
 */
object SpanishMessages :
    RobolangMessages,
    SyntaxMessages by SpanishSyntaxMessages,
    MeaningMessages by SpanishMeaningMessages,
    WarningMessages by SpanishWarningMessages,
    RunMessages by SpanishRunMessages

internal fun spanishDidYouMean(suggestion: String?) = if (suggestion ==
    null
) {
    ""
} else {
    " ¿Querías decir ${quoted(suggestion)}?"
}

internal fun spanishWriteInstead(written: String, right: String) =
    "Escribe ${quoted(right)} en lugar de ${quoted(written)}."
