package robotran.robolang.messages

import robotran.language.quoted

/** The messages in English. */
object EnglishMessages :
    RobolangMessages,
    SyntaxMessages by EnglishSyntaxMessages,
    MeaningMessages by EnglishMeaningMessages,
    WarningMessages by EnglishWarningMessages,
    RunMessages by EnglishRunMessages

internal fun didYouMean(suggestion: String?) = if (suggestion == null) "" else " Did you mean ${quoted(suggestion)}?"

internal fun writeInstead(written: String, right: String) = "Write ${quoted(right)} instead of ${quoted(written)}."
