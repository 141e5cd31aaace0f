package robotran.robolang

/** The messages in English. */
object EnglishMessages :
    RobolangMessages,
    SyntaxMessages by EnglishSyntaxMessages,
    MeaningMessages by EnglishMeaningMessages,
    WarningMessages by EnglishWarningMessages,
    RunMessages by EnglishRunMessages

/** [text] between quotation marks, unless it is or has one itself. */
internal fun quoted(text: String) = if ('"' in text) text else "\"$text\""

internal fun didYouMean(suggestion: String?) = if (suggestion == null) "" else " Did you mean ${quoted(suggestion)}?"

internal fun writeInstead(written: String, right: String) = "Write ${quoted(right)} instead of ${quoted(written)}."
