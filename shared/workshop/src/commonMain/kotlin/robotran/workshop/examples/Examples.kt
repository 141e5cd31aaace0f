package robotran.workshop.examples

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage

/** The built-in example programs in this language for an RCX, text by name. */
val ProgramLanguage.examples: Map<String, String> get() = examplesFor(BrickKind.RCX)

/** The built-in example programs in this language for a [brick], text by name; those in Robolang are for every one. */
fun ProgramLanguage.examplesFor(brick: BrickKind): Map<String, String> = when (this) {
    ProgramLanguage.ROBOLANG -> exampleTexts

    ProgramLanguage.JAVA -> when (brick) {
        BrickKind.RCX -> lejosExampleTexts
        BrickKind.NXT -> nxjExampleTexts
    }
}
