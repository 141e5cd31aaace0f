package robotran.nxt.messages

internal const val PIN_INPUT = 1
internal const val PIN_OUTPUT = 2
internal const val PIN_MEASURES = 3
