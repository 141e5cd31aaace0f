package robotran.workshop.examples

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage

/** The built-in example programs in this language for an RCX, text by name. */
val ProgramLanguage.examples: Map<String, String> get() = examplesFor(BrickKind.RCX)

/**
 * The built-in example programs in this language for a [brick], text by name. Those in Robolang are for every one; what
 * an NXT cannot do in one of them is a mistake there, which names the RCX.
 */
fun ProgramLanguage.examplesFor(brick: BrickKind): Map<String, String> = when (this) {
    ProgramLanguage.ROBOLANG -> when (brick) {
        BrickKind.RCX -> exampleTexts
        BrickKind.NXT -> exampleTexts.mapValues { forNxtPenbot(it.value) }
    }

    ProgramLanguage.JAVA -> when (brick) {
        BrickKind.RCX -> lejosExampleTexts
        BrickKind.NXT -> nxjExampleTexts
    }
}

/** The light sensor of the NXT penbot is on another port than that of an RCX, and it cannot be turned ahead. */
private fun forNxtPenbot(text: String): String = if ("facing forward" in text) {
    text.replaceFirst("\nrobot\n", "\nrobot\n  brick rcx\n")
} else {
    text.replace("light sensor on 2", "light sensor on 3")
}
