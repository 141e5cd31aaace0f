package robotran.programs.messages

import robotran.language.Language
import robotran.language.choose

/** The messages of this module to a pupil. Each language is an implementation. */
interface ProgramMessages {
    /** A mistake in the Java that a Robolang program becomes, told at the program's line. */
    fun inTranslation(message: String): String

    /** A program was given to a robot with another brick. Both are names of bricks: `RCX`, `NXT`. */
    fun forOtherBrick(program: String, robot: String): String

    /** An image was asked for of a program for this brick, which is no RCX. */
    fun noImageFor(brick: String): String

    /** An image for leJOS was asked for of a program for LEGO's own firmware. */
    fun noImageForFirmware(): String

    /** The compiler for Java was not ready with a program in the time that it has. */
    fun compilesTooLong(): String

    companion object {
        fun of(language: Language): ProgramMessages =
            language.choose(EnglishProgramMessages, SpanishProgramMessages, GermanProgramMessages)
    }
}
