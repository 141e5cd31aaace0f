package robotran.robolang.messages

import robotran.language.quoted

/** The messages in English. */
object EnglishNqcTranslationMessages : NqcTranslationMessages {
    override fun otherBrick() = "NQC is for an RCX, but this is for an NXT."

    override fun decimal() =
        "NQC has no decimal numbers. It can take them only where they are written after forward, turn, wait or play, " +
            "or compared with timer or battery."

    override fun list() = "Lists do not go over to NQC."

    override fun numberTooLarge(number: Int) = "$number is too large for NQC. Its numbers go from -32768 to 32767."

    override fun text() = "LEGO's firmware cannot show texts, only numbers."

    override fun clearScreen() = "LEGO's firmware cannot clear its display. It shows the clock instead."

    override fun button() = "A program for LEGO's firmware cannot read the buttons."

    override fun whenever() = "whenever does not go over to NQC. Write a task with acquire there."

    override fun recursion(name: String) = "${quoted(name)} calls itself, and LEGO's firmware cannot do that."

    override fun builtIn(name: String) = "NQC has no function ${quoted(name)}."

    override fun unknownStep() = "For NQC the step of a loop must be written as a number."

    override fun tooLong() = "LEGO's firmware can wait at most 327 seconds at a time."

    override fun alwaysCalled() = "In NQC this function is called even if the left side of and or or decides already."
}
