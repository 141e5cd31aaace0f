package robotran.robolang.messages

import robotran.language.quoted

/**
 * The messages in German. They call the pupil "du". One thing has one word: brick - Stein, bracket - Klammer, command -
 * Befehl, condition - Bedingung, declare - anlegen, display - Anzeige, figure - Ziffer, line - Zeile, loop - Schleife,
 * power - Leistung, text - Text, value - Wert, whole number - ganze Zahl, decimal number - Kommazahl. Words of Robolang
 * stay as they are, between quotation marks.
 */
object GermanMessages :
    RobolangMessages,
    SyntaxMessages by GermanSyntaxMessages,
    MeaningMessages by GermanMeaningMessages,
    WarningMessages by GermanWarningMessages,
    RunMessages by GermanRunMessages

internal fun germanDidYouMean(suggestion: String?) = if (suggestion == null) "" else " Meinst du ${quoted(suggestion)}?"

internal fun germanWriteInstead(written: String, right: String) = "Schreib ${quoted(right)} statt ${quoted(written)}."
