package robotran.robolang

import robotran.brick.kind.BrickKind
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.messages.EnglishRobolangMessages
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.brickIn
import robotran.robolang.syntax.scan

/** The brick that the header of the program [source] names; null if it names none. Never throws. */
fun brickInHeader(source: String): BrickKind? =
    if (source.length > RobolangLimits.SOURCE_CHARACTERS) {
        null
    } else {
        brickIn(scan(source, DiagnosticSink(EnglishRobolangMessages)))
    }
