package robotran.robolang

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.syntax.brickIn
import robotran.robolang.syntax.scan

/** The brick that the header of a Robolang program names; null if it names none. Never throws for any [source]. */
fun brickOfRobolang(source: String): BrickKind? =
    brickIn(scan(source, DiagnosticSink(RobolangMessages.of(Language.ENGLISH))))
